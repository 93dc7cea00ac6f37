// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceCurve.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace geodesic
{

namespace
{

/// Edges by their source.
using EdgesOfSources = std::set<std::pair<Id, Id>>;

/// The edges along which a segment of a curve runs from end to end.
EdgesOfSources edgesAlong(const TriangleMesh& mesh, const std::vector<SourceCurve>& curves)
{
  EdgesOfSources edges;
  for (const SourceCurve& curve : curves)
  {
    for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
    {
      const SurfacePoint& a = curve.points[i];
      const SurfacePoint& b = curve.points[i + 1];
      const Id halfedge =
        a.kind == SurfacePoint::Kind::Vertex && b.kind == SurfacePoint::Kind::Vertex
        ? mesh.halfedgeBetween(a.id, b.id)
        : NoId;
      if (halfedge != NoId)
      {
        edges.emplace(curve.source, mesh.edgeOf(halfedge));
      }
    }
  }
  return edges;
}

/// Another face at a halfedge that is not among those of a source; NoId if there is none.
Id faceOutside(const TriangleMesh& mesh, Id halfedge, const std::set<Id>& covered)
{
  for (Id s = mesh.nextSibling(halfedge); s != halfedge; s = mesh.nextSibling(s))
  {
    if (covered.count(TriangleMesh::faceOf(s)) == 0)
    {
      return TriangleMesh::faceOf(s);
    }
  }
  return NoId;
}

} // anonymous namespace

void addBordersWithoutCurves(const TriangleMesh& mesh, std::vector<SourceCurve>& curves)
{
  std::map<Id, std::set<Id>> coveredBy;
  for (const SourceCurve& curve : curves)
  {
    if (!curve.coveredFaces.empty())
    {
      coveredBy[curve.source].insert(curve.coveredFaces.begin(), curve.coveredFaces.end());
    }
  }
  if (coveredBy.empty())
  {
    return;
  }
  EdgesOfSources known = edgesAlong(mesh, curves);
  for (const auto& [source, covered] : coveredBy)
  {
    for (const Id face : covered)
    {
      for (const Id halfedge : TriangleMesh::halfedgesOf(face))
      {
        const Id outside = faceOutside(mesh, halfedge, covered);
        if (outside != NoId && known.emplace(source, mesh.edgeOf(halfedge)).second)
        {
          curves.push_back({ { SurfacePoint::atVertex(mesh.origin(halfedge)),
                               SurfacePoint::atVertex(mesh.destination(halfedge)) },
            { outside }, { 0, 0 }, source });
          curves.back().isOutline = false;
        }
      }
    }
  }
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
