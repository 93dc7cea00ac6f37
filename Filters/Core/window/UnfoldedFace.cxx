// SPDX-License-Identifier: BSD-3-Clause
#include "window/UnfoldedFace.h"

#include "Tolerance.h"

namespace geodesic
{

UnfoldedFace unfold(const TriangleMesh& mesh, Id halfedge)
{
  const FaceShape& shape = mesh.shape(TriangleMesh::faceOf(halfedge));
  const std::size_t k = halfedge % 3;
  const std::size_t next = (k + 1) % 3;
  UnfoldedFace face;
  face.length = shape.length[k];
  face.rightLength = shape.length[next];
  face.leftLength = shape.length[(k + 2) % 3];
  face.apex = Vec2{ shape.cornerDot[k] / face.length, shape.area2 / face.length };
  face.apexFromEnd = shape.cornerDot[next] / face.length;
  if (face.rightLength < tolerance::ShortEdge * face.length)
  {
    face.apex.x = face.length - face.apexFromEnd;
    face.apex.restOfX = face.length - face.apex.x - face.apexFromEnd;
  }
  // An edge without length carries no window, so any axis will do.
  face.leftAxis = face.leftLength > 0.0 ? (1.0 / face.leftLength) * face.apex : Vec2{ 1.0, 0.0 };
  face.rightAxis = face.rightLength > 0.0
    ? (1.0 / face.rightLength) * Vec2{ face.apexFromEnd, -face.apex.y }
    : Vec2{ 1.0, 0.0 };
  return face;
}

}
