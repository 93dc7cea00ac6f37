// SPDX-License-Identifier: BSD-3-Clause
#include "truth/CappedMeshes.h"

#include <algorithm>
#include <map>

namespace geodesictest
{

namespace
{

struct PointOnEdge
{
  double fraction;
  Index vertex;
  bool operator<(const PointOnEdge& other) const { return this->fraction < other.fraction; }
};

/// New vertices on the edge from a to b, in their order.
std::vector<PointOnEdge> addPoints(
  PlainMesh& mesh, Index a, Index b, Index count, Random& random, double shift)
{
  std::vector<PointOnEdge> points;
  for (Index i = 0; i < count; ++i)
  {
    const double t = (i + shift + random.uniform(0.05, 0.4)) / count;
    const Vec3 p = mesh.points[a];
    const Vec3 q = mesh.points[b];
    points.push_back({ t, static_cast<Index>(mesh.points.size()) });
    mesh.points.push_back(
      { (1.0 - t) * p[0] + t * q[0], (1.0 - t) * p[1] + t * q[1], (1.0 - t) * p[2] + t * q[2] });
  }
  return points;
}

/// The face cut at points on its edge from `from` to the vertex behind it, if there are any.
void addCut(std::vector<Triangle>& triangles, const Triangle& face, Index from,
  const std::vector<Index>& points)
{
  const auto k = static_cast<std::size_t>(std::find(face.begin(), face.end(), from) - face.begin());
  const Index apex = face[(k + 2) % 3];
  Index last = from;
  for (const Index point : points)
  {
    triangles.push_back({ last, point, apex });
    last = point;
  }
  triangles.push_back({ last, face[(k + 1) % 3], apex });
}

/// Cuts off the corners of a polygon in any order.
void addPolygon(std::vector<Triangle>& triangles, std::vector<Index> polygon, Random& random)
{
  while (polygon.size() > 2)
  {
    const std::size_t n = polygon.size();
    const std::size_t i = random.below(n);
    triangles.push_back({ polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n] });
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

std::vector<Index> verticesOf(const std::vector<PointOnEdge>& points, bool isReversed)
{
  std::vector<Index> vertices;
  for (const PointOnEdge& p : points)
  {
    vertices.push_back(p.vertex);
  }
  if (isReversed)
  {
    std::reverse(vertices.begin(), vertices.end());
  }
  return vertices;
}

} // anonymous namespace

CappedMesh withCaps(const PlainMesh& mesh, Caps caps, double fraction, Random& random)
{
  CappedMesh result;
  result.mesh.points = mesh.points;
  std::map<std::pair<Index, Index>, Index> faceOf;
  for (Index f = 0; f < mesh.triangles.size(); ++f)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      faceOf[{ mesh.triangles[f][k], mesh.triangles[f][(k + 1) % 3] }] = f;
    }
  }
  const bool isOne = caps == Caps::One;
  std::vector<bool> isDone(mesh.triangles.size(), false);
  for (const auto& [edge, f] : faceOf)
  {
    const auto [a, b] = edge;
    const auto behind = faceOf.find({ b, a });
    if (behind == faceOf.end() || isDone[f] || isDone[behind->second] || !random.chance(fraction))
    {
      continue;
    }
    const Index g = behind->second;
    isDone[f] = true;
    isDone[g] = true;
    const std::vector<PointOnEdge> left =
      addPoints(result.mesh, a, b, isOne ? 1 : random.between(1, 3), random, 0.0);
    const std::vector<PointOnEdge> right = addPoints(
      result.mesh, a, b, isOne || random.chance(0.6) ? 0 : random.between(1, 2), random, 0.5);
    std::vector<PointOnEdge> all = left;
    all.insert(all.end(), right.begin(), right.end());
    std::sort(all.begin(), all.end());
    addCut(result.mesh.triangles, mesh.triangles[f], a, verticesOf(left, false));
    addCut(result.mesh.triangles, mesh.triangles[g], b, verticesOf(right, true));
    addCut(result.conforming.triangles, mesh.triangles[f], a, verticesOf(all, false));
    addCut(result.conforming.triangles, mesh.triangles[g], b, verticesOf(all, true));
    // f runs along the gap from a to b, so that the gap has it on its right.
    std::vector<Index> gap = { b };
    const std::vector<Index> back = verticesOf(left, true);
    gap.insert(gap.end(), back.begin(), back.end());
    gap.push_back(a);
    const std::vector<Index> forth = verticesOf(right, false);
    gap.insert(gap.end(), forth.begin(), forth.end());
    addPolygon(result.mesh.triangles, gap, random);
  }
  for (Index f = 0; f < mesh.triangles.size(); ++f)
  {
    if (!isDone[f])
    {
      result.mesh.triangles.push_back(mesh.triangles[f]);
      result.conforming.triangles.push_back(mesh.triangles[f]);
    }
  }
  result.conforming.points = result.mesh.points;
  return result;
}

PlainMesh withPockets(const PlainMesh& mesh, Index pockets, Random& random)
{
  PlainMesh result = mesh;
  for (Index pocket = 0; pocket < pockets; ++pocket)
  {
    const Triangle& face = mesh.triangles[random.below(mesh.triangles.size())];
    const Index k = random.below(3);
    const Index a = face[k];
    const Index b = face[(k + 1) % 3];
    std::vector<Index> all = { a, b };
    for (const PointOnEdge& p : addPoints(result, a, b, random.between(1, 4), random, 0.0))
    {
      all.push_back(p.vertex);
    }
    std::vector<Index> around = all;
    std::rotate(around.begin() + 1, around.begin() + 2, around.end()); // b last
    addPolygon(result.triangles, around, random);
    // Any faces on the same line, so that edges get many of them and the pocket is closed anyhow.
    for (Index extra = random.between(0, 5); extra > 0 && all.size() > 2; --extra)
    {
      const Index i = random.below(all.size());
      const Index j = (i + random.between(1, static_cast<Index>(all.size()) - 1)) %
        static_cast<Index>(all.size());
      const Index l = random.below(all.size());
      if (l != i && l != j)
      {
        result.triangles.push_back({ all[i], all[j], all[l] });
      }
    }
  }
  return result;
}

}
