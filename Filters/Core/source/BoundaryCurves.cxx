// SPDX-License-Identifier: BSD-3-Clause
#include "source/BoundaryCurves.h"

#include "Chains.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

namespace
{

bool hasFaceAt(const TriangleMesh& mesh, Id vertex)
{
  return vertex < mesh.numberOfVertices() && mesh.cornersAt(vertex).size() > 0;
}

/// Restricts a boundary curve of a whole surface to the faces of a mesh.
void addPieces(const SourceCurve& curve, const TriangleMesh& mesh, std::vector<SourceCurve>& pieces)
{
  std::vector<SurfacePoint> points = curve.points;
  std::vector<Id> faces; // of the mesh at each segment; NoId if there is none
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    const Id from = points[i].id;
    const Id to = points[i + 1].id;
    const Id halfedge =
      hasFaceAt(mesh, from) && hasFaceAt(mesh, to) ? mesh.halfedgeBetween(from, to) : NoId;
    faces.push_back(halfedge == NoId ? NoId : TriangleMesh::faceOf(halfedge));
  }
  const auto gap = std::find(faces.begin(), faces.end(), NoId);
  if (gap == faces.end())
  {
    pieces.push_back(curve);
    pieces.back().faces = faces;
    return;
  }
  if (curve.isClosed())
  {
    // A loop begins behind an omitted segment, which then is the last one.
    points.pop_back();
    const auto omitted = gap - faces.begin();
    std::rotate(faces.begin(), gap + 1, faces.end());
    std::rotate(points.begin(), points.begin() + omitted + 1, points.end());
  }
  SourceCurve piece;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    piece.points.push_back(points[i]);
    if (i < faces.size() && faces[i] != NoId)
    {
      piece.faces.push_back(faces[i]);
      continue;
    }
    if (hasFaceAt(mesh, piece.points.front().id))
    {
      piece.isCut.assign(piece.points.size(), 0);
      piece.source = curve.source;
      pieces.push_back(std::move(piece));
    }
    piece = SourceCurve();
  }
}

} // anonymous namespace

std::vector<SourceCurve> curvesAlong(const std::vector<Id>& ends, const std::vector<Id>& faces)
{
  std::vector<Chain> chains = followChains(ends);
  beginAtLowestEnds(chains);
  std::vector<SourceCurve> curves;
  for (const Chain& chain : chains)
  {
    SourceCurve& curve =
      curves.emplace_back(pointCurve(SurfacePoint::atVertex(ends[chain.ends.front()])));
    for (const Id end : chain.ends)
    {
      curve.points.push_back(SurfacePoint::atVertex(ends[end ^ 1U]));
      curve.isCut.push_back(0);
      curve.faces.push_back(faces[end / 2]);
    }
  }
  return curves;
}

std::vector<SourceCurve> boundaryOutsideBarriers(
  const std::vector<SourceCurve>& boundary, const TriangleMesh& mesh)
{
  std::vector<SourceCurve> pieces;
  for (const SourceCurve& curve : boundary)
  {
    addPieces(curve, mesh, pieces);
  }
  return pieces;
}

}
