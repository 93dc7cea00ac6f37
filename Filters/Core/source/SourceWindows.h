// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceWindows_h
#define geodesic_SourceWindows_h

#include "source/SourceCurve.h"
#include "source/SourceInFace.h"
#include "mesh/TriangleMesh.h"
#include "window/Window.h"

#include <vector>

namespace geodesic
{

/// A window that leaves a face. Its coordinates are those of the face's halfedge seen from outside: x
/// axis from the halfedge's destination to its origin, the face below.
struct LeavingWindow
{
  Id halfedge;
  Window window;
};

/// What the sources give the front to begin with (paper, sections 4.1 and 4.2).
struct SourceWindows
{
  std::vector<LeavingWindow> windows;
  /// In the order of the faces.
  std::vector<SourceInFace> inFaces;
  /// Mesh vertices on a source, ascending, each once.
  std::vector<Id> vertices;
  /// Vertices so near to a source's point that the directions around them cannot be told apart in
  /// the windows of that point: they are to be pseudo-sources.
  std::vector<Id> nearVertices;
};

/// Linear windows from both sides of every segment, and circular windows from every vertex of a
/// curve into its wedge: the directions at right angles or more to all its segments. Where a curve
/// is only cut by a mesh edge there is no wedge.
SourceWindows makeSourceWindows(const TriangleMesh& mesh, const std::vector<SourceCurve>& curves);

/// The window through the halfedge opposite a corner, of rays that leave the vertex there.
LeavingWindow vertexWindow(const TriangleMesh& mesh, Id corner, double sigma);

}

#endif
