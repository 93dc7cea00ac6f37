// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfacePoint_txx
#define geodesic_SurfacePoint_txx

#include "SurfacePoint.h"
#include "TriangleMesh.h"

namespace geodesic
{

template <typename Visitor>
void forEachFace(const TriangleMesh& mesh, const SurfacePoint& point, Visitor&& visit)
{
  switch (point.kind)
  {
    case SurfacePoint::Kind::Vertex:
      for (const Id corner : mesh.cornersAt(point.id))
      {
        visit(TriangleMesh::faceOf(corner));
      }
      break;
    case SurfacePoint::Kind::Edge:
    {
      Id side = point.id;
      do
      {
        visit(TriangleMesh::faceOf(side));
        side = mesh.nextInRing(side);
      } while (side != point.id);
      break;
    }
    case SurfacePoint::Kind::Face:
      visit(point.id);
      break;
  }
}

}

#endif
