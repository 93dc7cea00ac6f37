// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DistanceField_h
#define geodesic_DistanceField_h

#include "front/Front.h"
#include "front/Retention.h"
#include "mesh/SurfacePoint.h"
#include "mesh/TriangleMesh.h"
#include "window/WindowArchive.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

/// The geodesic distance to the sources: at the vertices, and where windows were kept at any point
/// of the surface. Made by solve(); the mesh must outlive it.
class DistanceField
{
public:
  DistanceField(const MeshPartition& surface, FrontResult front, KeptWindows kept);

  /// Distance at each vertex, in the surface's units; +infinity where the front did not come.
  const std::vector<double>& vertexDistances() const { return this->front_.vertexDistances; }

  /// What is certified about the relative error: no distance is larger than the exact one, and none
  /// smaller by more than this fraction of it. 0 in the exact field.
  double relativeErrorBound() const { return this->front_.relativeErrorBound; }

  /// Number of windows put on halfedges during the solve.
  std::uint64_t windowsPropagated() const { return this->front_.windowsPropagated; }

  /// The windows that enter the halfedge's face through it, in no order; several may overlap. Empty
  /// where none were kept.
  WindowRuns windowsOn(Id halfedge) const;

  /// Where a shortest path comes to each vertex from; empty where the solve did not keep it.
  const std::vector<Arrival>& arrivals() const { return this->front_.arrivals; }

  /// The sources that lie in a face.
  std::vector<SourceInFace> sourcesIn(Id face) const;

  const TriangleMesh& mesh() const { return this->surface_.mesh(); }
  /// What this rank has of the surface; in one process all of it.
  const MeshPartition& surface() const { return this->surface_; }

  /// Whether windows were kept, so that distance() and path() can be called.
  bool hasWindows() const { return this->kept_.windows.isIndexed(); }

  /// Whether the inside of a face is known: it is complete and its windows were kept.
  bool knowsInside(Id face) const
  {
    return this->isComplete(face) && (this->kept_.faces.empty() || this->kept_.faces[face]);
  }

  /// What windows of flat faces were dropped by; 0 where all were kept.
  double droppedTolerance() const { return this->kept_.droppedTolerance; }
  /// Certified: in faces whose windows were dropped, no closure by triangles between points of the
  /// edges differs by more from the distance.
  double droppedErrorBound() const { return this->kept_.droppedErrorBound; }

  /// Exact distance at a point of the surface; +infinity where the front did not come, which with a
  /// limit is every face without a point within it. Known at every vertex, and elsewhere where the
  /// windows of a face around the point were kept. Thread-safe.
  ///
  /// \throws Error where they were not.
  double distance(const SurfacePoint& point) const;

  /// The shortest path from the point back to the source, as points of the surface: the point, a
  /// point on every edge it crosses, the vertices it passes, its end on the source. One of them
  /// where there are several. Empty where the point was not reached, or where by rounding no path
  /// as long as the distance (tolerance::BoundMargin) is found.
  ///
  /// \throws Error where not all windows were kept.
  std::vector<SurfacePoint> path(const SurfacePoint& from) const;

private:
  /// The last straight piece of a path to a point: it comes through one face from `from`.
  struct IncomingSegment
  {
    double distance = Infinity;
    /// Length of the piece.
    double length = 0.0;
    SurfacePoint from;
    bool fromSource = false;
    /// The face of the piece.
    Id face = NoId;
  };

  /// The best of the pieces that come to a point, and on demand all that may be part of a shortest
  /// path.
  struct LastPieces
  {
    IncomingSegment best;
    /// Of pieces whose distances differ by no more the longest is best: no path is led over places
    /// a rounding beside it.
    double tie = 0.0;
    /// The face that is looked at.
    Id face = NoId;
    /// The longest distance of those that are kept, and these; which of them is the best.
    double most = -Infinity;
    std::vector<IncomingSegment> kept;
    std::size_t bestKept = 0;

    bool isBest(double distance, double length) const;
    bool isWanted(double distance, double length) const
    {
      return distance <= this->most || this->isBest(distance, length);
    }
    void add(const IncomingSegment& piece);
  };

  /// A place that a search for a path has come to, and the ways on that are left to try.
  struct PathStep;

  bool isComplete(Id face) const
  {
    return this->front_.completeFaces.empty() || this->front_.completeFaces[face];
  }
  void requireWindows() const;
  std::vector<SurfacePoint> path(const SurfacePoint& from, double whole, double slack) const;
  std::vector<IncomingSegment> waysTo(const SurfacePoint& point, double distance, double most,
    const std::vector<std::uint8_t>& isCrossed) const;
  void arriveThrough(
    Id face, const SurfacePoint& point, bool ownHalfedges, LastPieces& pieces) const;
  void arriveFromCorners(
    Id face, const SurfacePoint& point, const std::array<double, 3>& b, LastPieces& pieces) const;
  void arriveFromSources(Id face, const std::array<double, 3>& b, LastPieces& pieces) const;
  void arriveThroughHalfedge(Id halfedge, const std::array<double, 3>& b, LastPieces& pieces) const;

  MeshPartition surface_;
  FrontResult front_;
  KeptWindows kept_;
};

}

#endif
