// SPDX-License-Identifier: BSD-3-Clause
#include "field/IncomingRay.h"

#include "Tolerance.h"

#include <algorithm>
#include <vector>

namespace geodesic
{

namespace
{

/// How far places of a face may be apart by rounding of its corners.
double roundingOf(const TriangleMesh& mesh, Id face)
{
  double largest = 0.0;
  for (const Id vertex : mesh.triangle(face))
  {
    largest = std::max(largest, largestCoordinate(mesh.point(vertex)));
  }
  return tolerance::SnapRoundings * tolerance::Rounding * largest;
}

/// The ray where it comes into a face that it leaves. All of the face is on one line, so that is at
/// the same place; an edge that is rounding of its ends tells no direction.
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

// In the frame of a halfedge that runs against it, a ray into the face runs the other way; one that
// runs along it sees the ray in a mirror.
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
