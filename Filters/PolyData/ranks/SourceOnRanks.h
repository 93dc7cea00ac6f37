// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceOnRanks_h
#define geodesic_SourceOnRanks_h

#include "Progress.h"
#include "mesh/Box.h"
#include "mesh/FaceLocator.h"
#include "mesh/MeshPartition.h"
#include "mesh/ReplicatedPatch.h"
#include "source/PolylineOnSurface.h"
#include "source/SourceCurve.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace geodesic
{

/// Finds the faces that points are closest to, of all faces of a surface that ranks have in pieces.
/// All ranks call its functions together, with the same points.
class LocatorOnRanks
{
public:
  /// \param part of this rank; must outlive this.
  explicit LocatorOnRanks(const MeshPartition& part);

  /// A face that is closest to a point. Of a point's faces those come first that are as close up to
  /// rounding, in the order of the whole, then the others.
  struct Found
  {
    RankAddress face;
    bool isUpToRounding;

    bool operator<(const Found& other) const
    {
      return this->isUpToRounding != other.isUpToRounding ? this->isUpToRounding
                                                          : this->face < other.face;
    }
  };

  /// As FaceLocator::closest() would find them on the whole surface.
  ///
  /// \param progress called now and then with a fraction done; returning false throws Aborted.
  /// \returns one list a point, the same on all ranks.
  std::vector<std::vector<Found>> locate(const std::vector<Vec3>& points,
    double coordinatePrecision, const ProgressCallback& progress = {});

private:
  using Candidates = std::vector<FaceLocator::Candidate>;

  FaceLocator::Candidate inWhole(FaceLocator::Candidate candidate) const;

  const MeshPartition& part_;
  FaceLocator locator_;
  /// Of this rank's faces.
  Box box_;
};

/// Puts a source onto a surface that ranks have in pieces: on a patch of the surface that all ranks
/// have, so that the curves are the same on all of them. All ranks call its functions together,
/// with the same curves.
class SourceOnRanks
{
public:
  explicit SourceOnRanks(const MeshPartition& part);

  /// Adds curves: locates their points.
  void addCurves(const std::vector<LocatedPolyline>& polylines, double coordinatePrecision,
    LocatorOnRanks& locator, const ProgressCallback& progress);
  /// Adds the whole boundary.
  void addBoundary();
  /// Adds the boundary of a surface that has other faces than those of the part's surface, too.
  ///
  /// \param whole what this rank has of it.
  /// \param numbers of the vertices of whole's own: what they are in the part's surface; other
  ///        vertices have larger numbers than all of those.
  void addBoundaryOf(const MeshPartition& whole, const std::vector<Id>& numbers);
  /// Adds faces that this rank owns.
  ///
  /// \returns whether any rank has added one.
  bool addFaces(const std::vector<Id>& faces);
  /// Makes the patch of all that was added.
  void makePatch();

  const ReplicatedPatch& patch() const { return *this->patch_; }
  /// Sets the faces of the curves' points, as faces of the patch.
  void locateOnPatch(std::vector<LocatedPolyline>& polylines) const;
  /// The places of all curves' points in space, ascending, and the faces there.
  const std::vector<Vec3>& places() const { return this->places_; }
  const std::vector<std::vector<LocatorOnRanks::Found>>& facesAtPlaces() const
  {
    return this->faces_;
  }
  /// The curves of boundaryCurves() on the patch that are boundary of the whole. After
  /// addBoundaryOf() those of that surface, for boundaryOutsideBarriers().
  std::vector<SourceCurve> boundary() const;

private:
  void addFacesAround(Id face);
  void addFacesAtVertex(Id vertex);
  std::vector<SourceCurve> boundaryOfPatch() const;
  std::vector<SourceCurve> boundaryOfOther() const;

  const MeshPartition& part_;
  /// One a face of the part: whether it is asked for.
  std::vector<std::uint8_t> isChosen_;
  /// The places in space of the curves' points, ascending, and the faces there.
  std::vector<Vec3> places_;
  std::vector<std::vector<LocatorOnRanks::Found>> faces_;
  std::unique_ptr<ReplicatedPatch> patch_;
  /// After addBoundaryOf(): its curves, whose points have their numbers in place of vertices.
  std::optional<std::vector<SourceCurve>> otherBoundary_;
};

}

#endif
