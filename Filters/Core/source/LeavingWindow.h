// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LeavingWindow_h
#define geodesic_LeavingWindow_h

#include "source/SourceInFace.h"
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
