// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceInFace.h"

#include <algorithm>

namespace geodesic
{

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
  return between(source.a, source.b, nearestAlongSource(mesh, source, point));
}

double distanceToSource(
  const TriangleMesh& mesh, const SourceInFace& source, const Barycentric& point)
{
  return distanceInFace(mesh, source.face, nearestOnSource(mesh, source, point), point);
}

}
