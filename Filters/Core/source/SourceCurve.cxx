// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceCurve.h"

#include <algorithm>
#include <cstddef>
#include <unordered_map>

namespace geodesic
{

std::vector<SourceCurve> curvesWhereRegionsBranch(
  const TriangleMesh& mesh, const std::vector<SourceCurve>& curves)
{
  std::unordered_map<Id, std::vector<Id>> sourcesOfFaces;
  for (const SourceCurve& curve : curves)
  {
    for (const Id face : curve.coveredFaces)
    {
      sourcesOfFaces[face].push_back(curve.source);
    }
  }
  std::vector<SourceCurve> result;
  if (sourcesOfFaces.empty() || mesh.numberOfNonManifoldEdges() == 0)
  {
    return result;
  }
  for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
  {
    if (mesh.edgeOf(halfedge) != halfedge)
    {
      continue;
    }
    std::unordered_map<Id, std::size_t> uses;
    Id outside = NoId;
    Id s = halfedge;
    do
    {
      const auto found = sourcesOfFaces.find(TriangleMesh::faceOf(s));
      outside = found == sourcesOfFaces.end() ? TriangleMesh::faceOf(s) : outside;
      for (const Id source : found == sourcesOfFaces.end() ? std::vector<Id>() : found->second)
      {
        ++uses[source];
      }
      s = mesh.nextSibling(s);
    } while (s != halfedge);
    const auto branching =
      std::find_if(uses.begin(), uses.end(), [](const auto& use) { return use.second > 1; });
    if (outside != NoId && branching != uses.end())
    {
      result.push_back({ { SurfacePoint::atVertex(mesh.origin(halfedge)),
                           SurfacePoint::atVertex(mesh.destination(halfedge)) },
        { outside }, { 0, 0 }, branching->first });
    }
  }
  return result;
}

double lengthOfSegment(const TriangleMesh& mesh, const SourceCurve& curve, std::size_t i)
{
  const Id frame = longestHalfedge(mesh, curve.faces[i]);
  return norm(inHalfedgeFrame(mesh, frame, curve.points[i]) -
    inHalfedgeFrame(mesh, frame, curve.points[i + 1]));
}

double lengthOf(const TriangleMesh& mesh, const SourceCurve& curve)
{
  double length = 0.0;
  for (std::size_t i = 0; i < curve.faces.size(); ++i)
  {
    length += lengthOfSegment(mesh, curve, i);
  }
  return length;
}

Vec2 directionIn(const TriangleMesh& mesh, const SegmentEnd& end, Id halfedge)
{
  return end.onward.halfedge != NoId
    ? turned(mesh, end.onward, halfedge)
    : inHalfedgeFrame(mesh, halfedge, end.to) - inHalfedgeFrame(mesh, halfedge, end.from);
}

std::vector<SourceInFace> segmentsInFaces(const TriangleMesh& mesh, const SourceCurve& curve,
  Id number, const std::vector<double>& parameters)
{
  std::vector<SourceInFace> segments;
  for (std::size_t i = 0; i < curve.faces.size(); ++i)
  {
    const SurfacePoint& p = curve.points[i];
    const SurfacePoint& q = curve.points[i + 1];
    const auto add = [&](Id face)
    {
      segments.push_back({ face, barycentric(mesh, p, face), barycentric(mesh, q, face), number,
        parameters[i], parameters[i + 1] });
    };
    add(curve.faces[i]);
    const SourceInFace segment = segments.back();
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id halfedge = TriangleMesh::halfedgeOf(segment.face, k);
      for (Id s = mesh.nextSibling(halfedge); runsAlong(k, segment.a, segment.b) && s != halfedge;
           s = mesh.nextSibling(s))
      {
        add(TriangleMesh::faceOf(s));
      }
    }
  }
  return segments;
}

double nearestAlongSource(
  const TriangleMesh& mesh, const SourceInFace& source, const Barycentric& point)
{
  const Id frame = longestHalfedge(mesh, source.face);
  const Vec2 a = inHalfedgeFrame(mesh, frame, source.a);
  const Vec2 ab = inHalfedgeFrame(mesh, frame, source.b) - a;
  const double squared = dot(ab, ab);
  const double along = dot(inHalfedgeFrame(mesh, frame, point) - a, ab);
  return squared > 0.0 ? std::clamp(along / squared, 0.0, 1.0) : 0.0;
}

Barycentric nearestOnSource(
  const TriangleMesh& mesh, const SourceInFace& source, const Barycentric& point)
{
  return source.isWholeFace ? point
                            : between(source.a, source.b, nearestAlongSource(mesh, source, point));
}

double distanceToSource(
  const TriangleMesh& mesh, const SourceInFace& source, const Barycentric& point)
{
  return norm(wayInFrame(
    mesh, longestHalfedge(mesh, source.face), nearestOnSource(mesh, source, point), point));
}

}
