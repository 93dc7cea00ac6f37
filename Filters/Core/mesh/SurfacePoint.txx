// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfacePoint_txx
#define geodesic_SurfacePoint_txx

#include "mesh/SurfacePoint.h"
#include "mesh/TriangleMesh.h"

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
      Id halfedge = point.id;
      do
      {
        visit(TriangleMesh::faceOf(halfedge));
        halfedge = mesh.nextSibling(halfedge);
      } while (halfedge != point.id);
      break;
    }
    case SurfacePoint::Kind::Face:
      visit(point.id);
      break;
  }
}

}

#endif
