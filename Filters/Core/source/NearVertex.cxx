// SPDX-License-Identifier: BSD-3-Clause
#include "source/NearVertex.h"

#include "Tolerance.h"

namespace geodesic
{

NearVertex nearVertexAt(const TriangleMesh& mesh, Id corner, const Barycentric& point)
{
  const NearVertex alone = { mesh.origin(corner) };
  if (mesh.pseudoSource(alone.vertex) == TriangleMesh::PseudoSource::Irregular)
  {
    return alone;
  }
  const double distance = norm(fromCorner(mesh, corner, point));
  for (const Id other : mesh.cornersAt(alone.vertex))
  {
    const double altitude =
      mesh.shape(TriangleMesh::faceOf(other)).area2 / mesh.length(TriangleMesh::nextInFace(other));
    if (!(distance < tolerance::NearVertex * altitude))
    {
      return alone;
    }
  }
  const Id opposite = TriangleMesh::nextInFace(corner);
  const std::size_t k = TriangleMesh::indexInFace(corner);
  const double ofFirst = point[(k + 1) % 3];
  const double ofSecond = point[(k + 2) % 3];
  return { alone.vertex, distance, opposite,
    mesh.length(opposite) * (ofSecond / (ofFirst + ofSecond)) };
}

Vec2 fromCorner(const TriangleMesh& mesh, Id corner, const Barycentric& point)
{
  const Vec2 second = apexOf(mesh, corner);
  const std::size_t k = TriangleMesh::indexInFace(corner);
  const double ofSecond = point[(k + 2) % 3];
  return { point[(k + 1) % 3] * mesh.length(corner) + ofSecond * second.x, ofSecond * second.y };
}

}
