// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LeavingWindow_h
#define geodesic_LeavingWindow_h

#include "mesh/HalfedgeFrame.h"
#include "window/Interval.h"
#include "window/Window.h"

#include <vector>

namespace geodesic
{

/// A window that leaves a face. Its coordinates are those of the face's halfedge seen from outside:
/// x axis from the halfedge's destination to its origin, the face below.
struct LeavingWindow
{
  Id halfedge;
  Window window;
};

/// A point of the halfedge's face in that frame: the halfedge's own frame, turned by half a turn
/// about the middle of the halfedge.
Vec2 inLeavingFrame(const TriangleMesh& mesh, Id halfedge, const Barycentric& point);

/// Adds a window on the part of the interval that lies on the halfedge, unless that is too narrow
/// or the rays run along the halfedge.
///
/// \param window all of it but its interval.
void addLeavingWindow(const TriangleMesh& mesh, Id halfedge, const Interval& interval,
  const Window& window, std::vector<LeavingWindow>& windows);

/// The window through the halfedge opposite a corner, of rays that leave the vertex there.
LeavingWindow vertexWindow(const TriangleMesh& mesh, Id corner, double sigma);

}

#endif
