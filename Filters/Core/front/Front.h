// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Front_h
#define geodesic_Front_h

#include "Job.h"
#include "front/Arrival.h"
#include "front/Retention.h"
#include "mesh/MeshPartition.h"
#include "mesh/TriangleMesh.h"
#include "source/SourceCurve.h"
#include "source/SourceWindows.h"

#include <functional>
#include <vector>

namespace geodesic
{

/// Restricts a search to one path: drops windows that no path to the target within the length
/// passes. Vertices that no such path passes may get distances that are too large.
struct Corridor
{
  /// For each vertex, a lower bound of the length of any path from it to the target.
  std::vector<double> lowerBounds;
  /// The largest length of the path.
  double length = Infinity;
};

struct FrontOptions
{
  /// 0: exact. Otherwise the largest relative error of any distance against the exact one; windows
  /// are then merged (paper, section 5).
  double relativeError = 0.0;
  /// With a relative error: a bound, in the surface's units, of how much merging the windows of one
  /// halfedge may change the distance there. The distances of two faces at a point of their edge
  /// then differ by no more.
  double maximumMerged = Infinity;
  /// The front stops there, in the surface's units. Every face that contains a point within the
  /// limit is complete: all its vertices (and its inside, if the retention needs it) have exact
  /// values.
  double maximumDistance = Infinity;
  /// If null, the front goes everywhere.
  const Corridor* corridor = nullptr;
  /// Whether to fill FrontResult::arrivals, which takes 40 bytes a vertex. Changes no distance.
  bool keepArrivals = false;
  /// Whether windows carry the angle at which their rays leave the source, for
  /// FootFinder::angleOf(). Changes no distance.
  bool keepAngles = false;
  /// Sources that start later, each as soon as all windows of those before have passed. Called
  /// until it returns none; if null, there are none. Distances are those to the nearest source.
  ///
  /// A later source takes work only where it is the nearest: its windows have to beat the
  /// distances that vertices know from earlier sources (FacePropagation.h). That is exact. Let s
  /// be nearer to a point v than all earlier sources, and p a point on the shortest path from s to
  /// v. Then s is also nearer to p: an earlier source that has as short a path to p would reach v
  /// by it. So vertices at which the path bends accept s and emit. Let the path cross an edge in
  /// p, let a be an end of the edge, and b the end of the path's window that is farther from a. By
  /// way of a, earlier sources reach p, so d(s, p) < known(a) + |a p|. The window is dropped only
  /// if its distance at b exceeds known(a) + |a b| by more than a tie. But from p to b along the
  /// edge its distance grows by at most the length. Windows of several sources that meet on one
  /// halfedge, or at one vertex, are compared with each other as those of one source are: the
  /// lower one stays.
  ///
  /// The retention must take windows in any order of distances: KeepNone or KeepFaces.
  std::function<SourceWindows()> laterSources;
  /// The result does not depend on its threads. Its watcher hears of the front at least ten times a
  /// second.
  Job job;
};

/// The result of the front, besides the windows that the retention has kept.
struct FrontResult
{
  /// Distance at each vertex, including the halo, in the surface's units; +infinity if the front
  /// did not reach it.
  std::vector<double> vertexDistances;
  /// How a shortest path arrives at each vertex, if requested; without a halfedge on the source,
  /// and if the path comes straight from a source in a face at the vertex.
  std::vector<Arrival> arrivals;
  /// Whether windows and arrivals carry angles.
  bool hasAngles = false;
  /// The sources inside faces, in the order of the faces, including the halo.
  std::vector<SourceInFace> sourcesInFaces;
  /// With a limit: whether each face is complete. Empty if all are.
  std::vector<std::uint8_t> completeFaces;
  /// Certified: no distance is larger than the exact one, or smaller by more than this fraction of
  /// it. 0 in the exact field.
  double relativeErrorBound = 0.0;
  std::uint64_t windowsPropagated = 0;
};

/// Computes the geodesic distance to the curves at the vertices, exactly or within a relative error
/// (paper, sections 3 to 5), and hands each window to the retention once it has passed its face.
///
/// If ranks share the surface, all of them call this together, each with its own job, and get
/// the distances on the whole surface at the vertices of their own faces; windows have global
/// numbers (Window::origin).
///
/// \throws SourceError if there is no curve; Error if the relative error is not a number >= 0;
/// Aborted.
/// \param sources the first windows and vertices, restricted to the faces that this rank owns.
FrontResult propagate(const MeshPartition& surface, SourceWindows sources,
  const FrontOptions& options, Retention& retention);

/// The windows of makeSourceWindows(). They take little time compared to a solve: whoever watches
/// the solve's job can stop them, but sees no progress.
SourceWindows startingWindows(
  const TriangleMesh& mesh, const std::vector<SourceCurve>& sources, const Job& job);

/// Propagates from curves, in one process.
FrontResult propagate(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  const FrontOptions& options, Retention& retention);

}

#endif
