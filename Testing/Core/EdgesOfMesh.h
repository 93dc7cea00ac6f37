// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_EdgesOfMesh_h
#define geodesictest_EdgesOfMesh_h

#include "mesh/TriangleMesh.h"
#include "source/BoundaryCurves.h"

#include <vector>

/// For tests and benchmarks of the engine.
namespace geodesictest
{

inline geodesic::Id numberOfEdges(const geodesic::TriangleMesh& mesh)
{
  geodesic::Id count = 0;
  for (geodesic::Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
  {
    count += mesh.edgeOf(halfedge) == halfedge ? 1 : 0;
  }
  return count;
}

/// The whole boundary of a surface; empty if it is closed.
inline std::vector<geodesic::SourceCurve> boundaryCurves(const geodesic::TriangleMesh& mesh)
{
  std::vector<geodesic::Id> ends;
  std::vector<geodesic::Id> faces;
  for (geodesic::Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
  {
    if (mesh.isBoundary(halfedge))
    {
      ends.insert(ends.end(), { mesh.origin(halfedge), mesh.destination(halfedge) });
      faces.push_back(geodesic::TriangleMesh::faceOf(halfedge));
    }
  }
  return geodesic::curvesAlong(ends, faces);
}

}

#endif
