// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceWindows_h
#define geodesic_SourceWindows_h

#include "Job.h"
#include "mesh/ReplicatedPatch.h"
#include "source/NearVertex.h"
#include "source/SourceCurve.h"
#include "window/Interval.h"
#include "window/Window.h"

#include <vector>

namespace geodesic
{

/// A window that leaves a face. Its coordinates refer to the face's halfedge seen from outside: the
/// x axis runs from the halfedge's destination to its origin, with the face below.
struct LeavingWindow
{
  Id halfedge;
  Window window;
};

/// The beginning of a front: windows and vertices of the sources (paper, sections 4.1 and 4.2).
struct SourceWindows
{
  std::vector<LeavingWindow> windows;
  /// How the sources reach vertices around a near vertex: windows in the frame of the halfedge
  /// opposite each of them.
  std::vector<LeavingWindow> toVertices;
  /// In the order of the faces.
  std::vector<SourceInFace> inFaces;
  /// If ranks share the surface: the sources in the halo, in the same order. Their owners start
  /// from them.
  std::vector<SourceInFace> inHalo;
  /// Mesh vertices on a source, ascending, each once.
  std::vector<Id> vertices;
  /// Vertices near to a source's point. Around one that has a fan, the point's windows begin behind
  /// the fan; every other one becomes a pseudo-source.
  std::vector<NearVertex> nearVertices;
};

/// Joins the curves at their ends (CurveChains); windows and SourceInFace use the chains' numbers.
/// No window leaves a face that a region covers: paths from inside begin at the outline.
///
/// Emits linear windows to both sides of every segment, and circular windows from every vertex of a
/// curve into its wedge: the directions at right angles or more to all its segments. A point where
/// a mesh edge merely cuts the curve has no wedge. Takes time in proportion to the segments and to
/// the faces around their ends.
///
/// \param job of the solve: whoever watches it can stop this, but sees no progress.
SourceWindows makeSourceWindows(
  const TriangleMesh& mesh, const std::vector<SourceCurve>& curves, const Job& job = {});

/// This rank's share of the same for curves on a replicated patch: the windows that leave this
/// rank's own faces, the sources in own faces and in the halo, and the vertices of the partition.
/// In one process that is all.
///
/// \param curves whose points lie in faces for which the patch was made.
SourceWindows makeSourceWindows(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<SourceCurve>& curves, const Job& job = {});

/// A point of the halfedge's face in that frame, which is the halfedge's own frame rotated by pi
/// about the middle of the halfedge.
Vec2 inLeavingFrame(const TriangleMesh& mesh, Id halfedge, const Barycentric& point);

/// Adds a window on the part of the interval that lies on the halfedge, unless this part is too
/// narrow or the rays run along the halfedge.
///
/// \param window complete but for its interval.
void addLeavingWindow(const TriangleMesh& mesh, Id halfedge, const Interval& interval,
  const Window& window, std::vector<LeavingWindow>& windows);

/// Adds the linear windows of a segment in a face: its rays leave at right angles to both sides,
/// through the face's halfedges (paper, section 4.2 and figure 6).
void addSegmentWindows(
  const TriangleMesh& mesh, const SourceInFace& segment, std::vector<LeavingWindow>& windows);

/// The window, through the halfedge opposite a corner, of the rays that leave the corner's vertex.
LeavingWindow vertexWindow(const TriangleMesh& mesh, Id corner, double sigma);

}

#endif
