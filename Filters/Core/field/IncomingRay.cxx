// SPDX-License-Identifier: BSD-3-Clause
#include "field/IncomingRay.h"

#include "Tolerance.h"

#include <algorithm>
#include <vector>

namespace geodesic
{

namespace
{

/// How far apart rounding of a face's corners may put places in the face.
double roundingOf(const TriangleMesh& mesh, Id face)
{
  double largest = 0.0;
  for (const Id vertex : mesh.triangle(face))
  {
    largest = std::max(largest, largestCoordinate(mesh.point(vertex)));
  }
  return tolerance::SnapRoundings * tolerance::Rounding * largest;
}

/// The ray where it enters a face without area that it leaves. The whole face lies on one line, so
/// that the ray enters and leaves at one place. An edge as short as the rounding of its ends has no
/// direction.
IncomingRay acrossFaceWithoutArea(const TriangleMesh& mesh, const IncomingRay& ray)
{
  const Id left = TriangleMesh::previousInFace(ray.halfedge);
  const Id right = TriangleMesh::nextInFace(ray.halfedge);
  const double rounding = roundingOf(mesh, TriangleMesh::faceOf(ray.halfedge));
  const double apex = apexOf(mesh, ray.halfedge).x;
  const bool isLeft =
    mesh.length(left) > rounding && (ray.x < apex || mesh.length(right) <= rounding);
  const Id in = isLeft ? left : right;
  return { in, false, isLeft ? apex - ray.x : mesh.length(ray.halfedge) - ray.x,
    turned(mesh, ray.direction, ray.halfedge, in) };
}

} // anonymous namespace

bool hasPlane(const TriangleMesh& mesh, Id face)
{
  const FaceShape& shape = mesh.shape(face);
  return !shape.hasZeroArea() && shape.area2 > roundingOf(mesh, face) * shape.longest();
}

bool isInSpace(const TriangleMesh& mesh, const IncomingRay& ray)
{
  return hasPlane(mesh, TriangleMesh::faceOf(ray.halfedge)) ||
    std::abs(ray.direction.y) <= tolerance::GrazingAngle * std::abs(ray.direction.x);
}

// The frame of a halfedge in the opposite direction is rotated by pi, that of one in the same
// direction is mirrored.
IncomingRay acrossEdge(const TriangleMesh& mesh, const IncomingRay& ray)
{
  const Id behind = mesh.nextSibling(ray.halfedge);
  const bool isOpposed = mesh.origin(behind) == mesh.destination(ray.halfedge);
  return { behind, true, isOpposed ? mesh.length(behind) - ray.x : ray.x,
    { isOpposed ? -ray.direction.x : ray.direction.x, -ray.direction.y } };
}

IncomingRay backToDirectionInSpace(const TriangleMesh& mesh, IncomingRay ray)
{
  std::vector<Id> passed; // no path crosses a face twice
  while (!isInSpace(mesh, ray))
  {
    ray = ray.leaves ? acrossFaceWithoutArea(mesh, ray) : ray;
    const Id face = TriangleMesh::faceOf(ray.halfedge);
    if (mesh.isBoundary(ray.halfedge) ||
      std::find(passed.begin(), passed.end(), face) != passed.end())
    {
      return ray;
    }
    passed.push_back(face);
    ray = acrossEdge(mesh, ray);
  }
  return ray;
}

}
