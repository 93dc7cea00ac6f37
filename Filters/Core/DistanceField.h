// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DistanceField_h
#define geodesic_DistanceField_h

#include "SourceWindows.h"
#include "SurfacePoint.h"
#include "TriangleMesh.h"
#include "WindowArchive.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

/// The geodesic distance to the sources: at the vertices, and where windows were kept at any point
/// of the surface. Made by solve(); the mesh must outlive it.
class DistanceField
{
public:
  /// Distance at each vertex, in the surface's units; +infinity where the front did not come.
  const std::vector<double>& vertexDistances() const { return this->vertexDistances_; }

  /// What is certified about the relative error: no distance is larger than the exact one, and none
  /// smaller by more than this fraction of it. 0 in the exact field.
  double relativeErrorBound() const { return this->relativeErrorBound_; }

  /// Number of windows put on sides during the solve.
  std::uint64_t windowsPropagated() const { return this->windowsPropagated_; }

  /// The windows that enter the side's face through it, in no order; several may overlap. Empty
  /// where none were kept.
  WindowRuns windowsOn(Id side) const;

  /// The sources that lie in a face.
  std::vector<SourceInFace> sourcesIn(Id face) const;

  const TriangleMesh& mesh() const { return *this->mesh_; }

  /// Whether windows were kept, so that distance() and path() can be called.
  bool hasWindows() const { return this->windows_.isIndexed(); }

  /// Whether the inside of a face is known: it is complete and its windows were kept.
  bool knowsInside(Id face) const
  {
    return (this->faceComplete_.empty() || this->faceComplete_[face]) &&
      (this->faceKept_.empty() || this->faceKept_[face]);
  }

  /// What windows of flat faces were dropped by; 0 where all were kept.
  double keptTolerance() const { return this->keptTolerance_; }
  /// Certified: in faces whose windows were dropped, no closure by triangles between points of the
  /// edges differs by more from the distance.
  double flatErrorBound() const { return this->flatErrorBound_; }

  /// Exact distance at a point of the surface; +infinity where the front did not come, which with a
  /// limit is every face without a point within it. Thread-safe.
  ///
  /// \throws Error where no windows were kept.
  double distance(const SurfacePoint& point) const;

  /// The shortest path from the point back to the source, as points of the surface: the point, a
  /// point on every edge it crosses, the vertices it passes, its end on the source. One of them
  /// where there are several. Empty where the point was not reached.
  ///
  /// \throws Error where no windows were kept.
  std::vector<SurfacePoint> path(const SurfacePoint& from) const;

private:
  friend class Propagation;

  /// The last straight piece of a shortest path to a point: it comes through one face from `from`.
  struct Arrival
  {
    double distance = Infinity;
    /// Length of the piece.
    double length = 0.0;
    SurfacePoint from;
    bool fromSource = false;
    /// The face of the piece.
    Id face = NoId;
  };

  void requireWindows() const;
  Arrival arrive(const SurfacePoint& point, const std::vector<Id>& crossed) const;
  void arriveThrough(Id face, const SurfacePoint& point, bool ownSides, Arrival& best) const;
  void arriveFromCorners(
    Id face, const SurfacePoint& point, const std::array<double, 3>& b, Arrival& best) const;
  void arriveFromSources(Id face, const std::array<double, 3>& b, Arrival& best) const;
  void arriveThroughSide(Id side, const std::array<double, 3>& b, Arrival& best) const;

  const TriangleMesh* mesh_ = nullptr;
  std::vector<double> vertexDistances_;
  std::uint64_t windowsPropagated_ = 0;
  double relativeErrorBound_ = 0.0;
  WindowArchive windows_;
  std::vector<SourceInFace> sourcesInFaces_;
  /// With a limit: whether each face is complete. Empty where all are.
  std::vector<std::uint8_t> faceComplete_;
  /// Whether each face has its windows. Empty where all have.
  std::vector<std::uint8_t> faceKept_;
  double keptTolerance_ = 0.0;
  double flatErrorBound_ = 0.0;
};

/// Distance within the source's face to a point of that face.
double distanceToSource(const TriangleMesh& mesh, const SourceInFace& source,
  const std::array<double, 3>& barycentricCoordinates);

}

#endif
