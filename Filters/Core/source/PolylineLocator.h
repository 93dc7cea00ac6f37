// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PolylineLocator_h
#define geodesic_PolylineLocator_h

#include "Job.h"
#include "mesh/ReplicatedPatch.h"
#include "mesh/SurfaceLocator.h"
#include "source/PolylineOnSurface.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

/// The places in space of some polylines' points, and the faces closest to them.
struct LocatedPlaces
{
  /// Ascending, each once.
  std::vector<Vec3> places;
  ClosestFaces faces;

  std::size_t indexOf(const Vec3& place) const { return indexIn(this->places, place); }
  /// Sets the faces of polylines with these points, by their numbers on a patch. A point that is a
  /// vertex gets one of the vertex's faces.
  void setFaces(const ReplicatedPatch& patch, std::vector<LocatedPolyline>& polylines) const;
};

/// Finds the faces that the points of polylines are closest to. In one process, polylines along the
/// mesh's own edges need its vertices only; other polylines need a search, whose tree is kept.
class PolylineLocator
{
public:
  explicit PolylineLocator(const MeshPartition& surface)
    : locator_(surface)
  {
  }

  /// Locates polylines whose points are finite. A place in space is searched once, however many
  /// points lie there. All ranks call this together, with the same polylines, and get the same.
  /// Not thread-safe.
  ///
  /// \param coordinatePrecision relative precision of the points' coordinates.
  LocatedPlaces locate(
    const std::vector<LocatedPolyline>& polylines, double coordinatePrecision, const Job& job = {});

  /// Keeps polylines beside a thin wall on one side of it (chooseSides()): changes the faces of
  /// places about as near to the other side. Places on the surface stay as they are. All ranks call
  /// this together, with the same, and get the same. Not thread-safe.
  ///
  /// \param located the polylines' places.
  void keepOnOneSide(const std::vector<LocatedPolyline>& polylines, double coordinatePrecision,
    LocatedPlaces& located, const Job& job = {});

private:
  SurfaceLocator locator_;
};

}

#endif
