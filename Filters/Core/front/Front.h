// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Front_h
#define geodesic_Front_h

#include "Progress.h"
#include "Tasks.h"
#include "front/Retention.h"
#include "front/SaddleWedge.h"
#include "mesh/MeshPartition.h"
#include "mesh/TriangleMesh.h"
#include "source/SourceCurve.h"
#include "source/SourceWindows.h"

#include <vector>

namespace geodesic
{

/// A search for one path: windows that no path to the target within the length goes through are
/// dropped. Vertices that such a path cannot pass may then have distances that are too large.
struct Corridor
{
  /// For each vertex: no path from it to the target is shorter.
  std::vector<double> lowerBounds;
  /// The most that the path can measure.
  double length = Infinity;
};

struct FrontOptions
{
  /// 0: exact. Otherwise the largest relative error of any distance against the exact one, for
  /// which windows are merged (paper, section 5).
  double relativeError = 0.0;
  /// With a relative error: the most that merging the windows of one halfedge may change the
  /// distance there, in the surface's units. The distances of two faces at a point of their edge
  /// then differ by no more.
  double maximumMerged = Infinity;
  /// Stop there, in the surface's units. Every face that has a point within the limit is complete:
  /// all its vertices (and its inside, where the retention needs it) have exact values.
  double maximumDistance = Infinity;
  /// Absent: the front goes everywhere.
  const Corridor* corridor = nullptr;
  /// Whether FrontResult::arrivals is wanted, which takes 40 bytes a vertex. Changes no distance.
  bool keepArrivals = false;
  /// Absent: one task after another. The result does not depend on it.
  ParallelFor parallelFor;
  /// Called now and then, at least ten times a second, with the fraction done in [0, 1]; returning
  /// false stops the front with Aborted.
  ProgressCallback progress;
};

/// What the front leaves behind, besides the windows that the retention has kept.
struct FrontResult
{
  /// Distance at each vertex, also of the halo, in the surface's units; +infinity where the front
  /// did not come.
  std::vector<double> vertexDistances;
  /// Where a shortest path comes to each vertex from, where that was asked for; no halfedge on the
  /// source and where the path comes straight from a source in a face at the vertex.
  std::vector<Arrival> arrivals;
  /// The sources that lie in faces, in the order of the faces, also in the halo.
  std::vector<SourceInFace> sourcesInFaces;
  /// With a limit: whether each face is complete. Empty where all are.
  std::vector<std::uint8_t> completeFaces;
  /// Certified: no distance is larger than the exact one, and none smaller by more than this
  /// fraction of it. 0 in the exact field.
  double relativeErrorBound = 0.0;
  /// Number of windows put on halfedges.
  std::uint64_t windowsPropagated = 0;
};

/// Computes the geodesic distance to the curves at the vertices, exact or within a relative error
/// (paper, sections 3 to 5), and hands the windows that have passed to the retention.
///
/// Where ranks have the surface together, all of them call this together, with their own callbacks,
/// and get the distances of the whole at the vertices of the faces that they own; windows have
/// global numbers (Window::origin).
///
/// \throws SourceError where there is no curve; Error where the relative error is not a number >=
/// 0;
///         Aborted.
/// \param sources what they give to begin with, of it what the faces that this rank owns have.
FrontResult propagate(const MeshPartition& surface, SourceWindows sources,
  const FrontOptions& options, Retention& retention);

/// The windows of makeSourceWindows(). That is short beside a solve: the solve's progress can stop
/// it, and it counts as no progress.
SourceWindows startingWindows(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  const ProgressCallback& progress);

/// The same in one process, from the curves themselves.
FrontResult propagate(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  const FrontOptions& options, Retention& retention);

}

#endif
