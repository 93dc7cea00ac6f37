// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceWindows_h
#define geodesic_SourceWindows_h

#include "SourceCurve.h"
#include "TriangleMesh.h"
#include "Window.h"

#include <vector>

namespace geodesic
{

/// A window that leaves a face. Its coordinates are those of the face's side seen from outside: x
/// axis from the side's destination to its origin, the face below.
struct LeavingWindow
{
  Id side;
  Window window;
};

/// A segment (or a point, when both ends are the same) of a source that lies in a face; barycentric
/// coordinates of its ends.
struct SourceInFace
{
  Id face;
  std::array<double, 3> a;
  std::array<double, 3> b;
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

/// The window through the side opposite a corner, of rays that leave the vertex there.
LeavingWindow vertexWindow(const TriangleMesh& mesh, Id corner, double sigma);

/// A point of a face in the frame of a side (3 * face + k): the side along the x axis, the face
/// above.
Vec2 inSideFrame(
  const TriangleMesh& mesh, Id side, const std::array<double, 3>& barycentricCoordinates);

}

#endif
