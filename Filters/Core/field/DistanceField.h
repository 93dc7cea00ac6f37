// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DistanceField_h
#define geodesic_DistanceField_h

#include "front/Front.h"
#include "front/Retention.h"
#include "mesh/SurfacePoint.h"
#include "mesh/TriangleMesh.h"
#include "window/WindowArchive.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace geodesic
{

/// The geodesic distance to the sources: at the vertices, and, where windows were kept, at any
/// point of the surface. solve() makes it. The mesh must outlive it.
class DistanceField
{
public:
  DistanceField(const MeshPartition& surface, FrontResult front, KeptWindows kept)
    : surface_(surface)
    , front_(std::move(front))
    , kept_(std::move(kept))
  {
  }

  /// Distance at each vertex, in the surface's units; +infinity if the front did not reach it.
  const std::vector<double>& vertexDistances() const { return this->front_.vertexDistances; }

  /// The certified relative error: no distance is larger than the exact one, and none is smaller by
  /// more than this fraction of it. 0 in an exact field.
  double relativeErrorBound() const { return this->front_.relativeErrorBound; }

  /// Number of windows put on halfedges during the solve.
  std::uint64_t windowsPropagated() const { return this->front_.windowsPropagated; }

  /// The windows that enter the halfedge's face through it, in no order; several may overlap. Empty
  /// if none were kept.
  WindowRuns windowsOn(Id halfedge) const
  {
    return this->hasWindows() ? this->kept_.windows.at(halfedge) : WindowRuns();
  }

  /// How a shortest path arrives at each vertex; empty if the solve did not keep arrivals.
  const std::vector<Arrival>& arrivals() const { return this->front_.arrivals; }

  /// FrontOptions::keepAngles.
  bool hasAngles() const { return this->front_.hasAngles; }

  /// The sources that lie in a face.
  std::vector<SourceInFace> sourcesIn(Id face) const;
  /// Whether the whole face belongs to the source: the distance is 0 all over it.
  bool isCovered(Id face) const;

  const TriangleMesh& mesh() const { return this->surface_.mesh(); }
  /// This rank's part of the surface; in one process the whole surface.
  const MeshPartition& surface() const { return this->surface_; }

  /// Whether windows were kept, so that distance() can be called.
  bool hasWindows() const { return this->kept_.windows.isIndexed(); }
  /// Whether all windows were kept.
  bool hasAllWindows() const { return this->hasWindows() && this->kept_.faces.empty(); }

  /// Whether the distance inside a face is known: the face is complete and its windows were kept.
  bool knowsInside(Id face) const
  {
    return this->isComplete(face) && (this->kept_.faces.empty() || this->kept_.faces[face]);
  }

  /// Whether a face is complete, but its windows were not kept.
  bool isDropped(Id face) const { return this->isComplete(face) && !this->knowsInside(face); }

  /// The tolerance by which windows of flat faces were dropped; 0 if all were kept.
  double droppedTolerance() const { return this->kept_.droppedTolerance; }
  /// Certified: in faces whose windows were dropped, a closure by triangles between points of the
  /// edges differs by no more from the distance.
  double droppedErrorBound() const { return this->kept_.droppedErrorBound; }

  /// The exact distance at a point of the surface; +infinity if the front did not reach it, as in
  /// faces entirely beyond the distance limit. The distance is known at every vertex, and at other
  /// points if the windows of a face around the point were kept. Thread-safe.
  ///
  /// \throws Error if they were not kept.
  double distance(const SurfacePoint& point) const;

private:
  bool isComplete(Id face) const
  {
    return this->front_.completeFaces.empty() || this->front_.completeFaces[face];
  }

  MeshPartition surface_;
  FrontResult front_;
  KeptWindows kept_;
};

/// Which windows a solve keeps.
enum class KeepWindows
{
  /// Distances at vertices only, in the least memory.
  None,
  /// The distance can be evaluated at any surface point, and paths traced.
  All
};

/// Computes the field of the geodesic distance to the curves (paper, sections 3 to 5). For a field
/// that is to be refined solveForRefinement() needs less memory.
///
/// \param surface whose mesh must outlive the field.
/// \param sources the first windows and vertices, see propagate().
/// \throws SourceError if there is no curve; Error if the relative error is not a number >= 0;
///         Aborted.
DistanceField solve(const MeshPartition& surface, SourceWindows sources,
  const FrontOptions& options = {}, KeepWindows keep = KeepWindows::None);

/// The same with the windows of some faces.
///
/// \param faces for each face, not 0 if its windows are kept.
DistanceField solveKeeping(const MeshPartition& surface, SourceWindows sources,
  const FrontOptions& options, std::vector<std::uint8_t> faces);

/// Solves in one process, from the curves themselves.
DistanceField solve(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  const FrontOptions& options = {}, KeepWindows keep = KeepWindows::None);

}

#endif
