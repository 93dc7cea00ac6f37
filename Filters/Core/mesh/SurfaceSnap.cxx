// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/SurfaceSnap.h"

#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// A face in space. Positions are relative to one of its corners, so that little precision is lost
/// far from the origin.
struct Face
{
  Face(const TriangleMesh& mesh, Id face)
    : shape(mesh.shape(face))
  {
    const auto& [a, b, c] = mesh.triangle(face);
    this->corner = { mesh.point(a), mesh.point(b), mesh.point(c) };
    this->edge = { this->corner[1] - this->corner[0], this->corner[2] - this->corner[1],
      this->corner[0] - this->corner[2] };
  }

  /// Height of corner k over the opposite halfedge.
  double altitude(std::size_t k) const
  {
    const double base = this->shape.length[(k + 1) % 3];
    return base > 0.0 ? this->shape.area2 / base : 0.0;
  }
  /// From corner k to the point with these barycentric coordinates, which sum to one.
  Vec3 fromCorner(std::size_t k, const Barycentric& weights) const
  {
    return weights[(k + 1) % 3] * this->edge[k] - weights[(k + 2) % 3] * this->edge[(k + 2) % 3];
  }

  const FaceShape& shape;
  std::array<Vec3, 3> corner;
  /// From corner k to corner k + 1.
  std::array<Vec3, 3> edge;
};

/// A point of the face, and the given point's distance from it.
struct Candidate
{
  Barycentric weights{};
  double distance = Infinity;
};

/// Where on halfedge k, as a fraction, the point nearest to the given one lies; `fromOrigin` is the
/// given point relative to corner k.
double fractionAlong(const Face& face, std::size_t k, const Vec3& fromOrigin)
{
  const Vec3& edge = face.edge[k];
  const double t = dot(fromOrigin, edge) / dot(edge, edge);
  return t > 0.0 ? std::min(t, 1.0) : 0.0; // NaN becomes 0 if the halfedge has no length
}

Candidate closestOnEdge(const Face& face, std::size_t k, const Vec3& point)
{
  const Vec3 fromOrigin = point - face.corner[k];
  const double t = fractionAlong(face, k, fromOrigin);
  Candidate result;
  result.weights[k] = 1.0 - t;
  result.weights[(k + 1) % 3] = t;
  const Vec3& nearEnd = face.corner[t < 0.5 ? k : (k + 1) % 3];
  const Vec3 rest = (t < 0.5 ? t : t - 1.0) * face.edge[k];
  result.distance = norm(point - nearEnd - rest);
  return result;
}

/// The foot of the perpendicular onto the face's plane if it lies inside the face. Otherwise, or if
/// the face has no plane, a candidate at infinity.
Candidate closestInside(const Face& face, const Vec3& point)
{
  const std::size_t longest = face.shape.longestEdge();
  const Vec3 normal = cross(face.edge[(longest + 1) % 3], face.edge[(longest + 2) % 3]);
  Candidate result;
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t halfedge = (k + 1) % 3;
    const Vec3 fromEdge = point - face.corner[halfedge];
    result.weights[k] = dot(normal, cross(face.edge[halfedge], fromEdge));
    if (!(result.weights[k] > 0.0))
    {
      return {};
    }
    sum += result.weights[k];
  }
  for (double& weight : result.weights)
  {
    weight /= sum;
  }
  const Vec3 fromCorner = point - face.corner[0];
  result.distance = norm(fromCorner - face.fromCorner(0, result.weights));
  return result;
}

/// The nearest candidate by measured distance: in a needle rounding may misplace the foot, but then
/// a halfedge is measured to be nearer.
Candidate closestPoint(const Face& face, const Vec3& point)
{
  Candidate best = closestOnEdge(face, 0, point);
  for (std::size_t k = 1; k < 3; ++k)
  {
    const Candidate candidate = closestOnEdge(face, k, point);
    best = candidate.distance < best.distance ? candidate : best;
  }
  const Candidate inside = closestInside(face, point);
  return inside.distance <= best.distance ? inside : best;
}

/// Moves the point onto a vertex within the precision; false if there is none. There is one at
/// most, as tolerance::SnapFraction is less than half, but for vertices at one place: then the
/// first.
bool snapToVertex(const Face& face, double precision, Barycentric& weights)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double shorter = std::min(face.shape.length[k], face.shape.length[(k + 2) % 3]);
    const double snapDistance = std::min(precision, tolerance::SnapFraction * shorter);
    if (norm(face.fromCorner(k, weights)) <= snapDistance)
    {
      weights = cornerWeights(k);
      return true;
    }
  }
  return false;
}

/// Moves the point perpendicularly onto the nearest halfedge within the precision, if any.
void snapToEdge(const Face& face, double precision, Barycentric& weights)
{
  double nearest = Infinity;
  const Barycentric given = weights;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double altitude = face.altitude(k);
    const double distance = given[k] * altitude;
    if (distance > std::min(precision, tolerance::SnapFraction * altitude) || distance >= nearest)
    {
      continue;
    }
    const std::size_t halfedge = (k + 1) % 3;
    const double t = fractionAlong(face, halfedge, face.fromCorner(halfedge, given));
    if (t > 0.0 && t < 1.0)
    {
      nearest = distance;
      weights[k] = 0.0;
      weights[halfedge] = 1.0 - t;
      weights[(halfedge + 1) % 3] = t;
    }
  }
}

} // anonymous namespace

SnappedPoint snapToFace(
  const TriangleMesh& mesh, Id faceId, const Vec3& point, double coordinatePrecision)
{
  const Face face(mesh, faceId);
  Candidate closest = closestPoint(face, point);
  const double largest =
    std::max({ largestCoordinate(face.corner[0]), largestCoordinate(face.corner[1]),
      largestCoordinate(face.corner[2]), largestCoordinate(point) });
  const double precision = tolerance::SnapRoundings * coordinatePrecision * largest;
  if (!snapToVertex(face, precision, closest.weights))
  {
    snapToEdge(face, precision, closest.weights);
  }

  SnappedPoint result;
  result.place = fromBarycentric(mesh, faceId, closest.weights);
  result.offset = (face.corner[0] - point) + face.fromCorner(0, closest.weights);
  result.distance = norm(point - position(mesh, result.place));
  const double shortest = *std::min_element(face.shape.length.begin(), face.shape.length.end());
  result.tolerance = std::min(precision, tolerance::SnapFraction * shortest);
  return result;
}

}
