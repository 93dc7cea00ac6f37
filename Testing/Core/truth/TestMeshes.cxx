// SPDX-License-Identifier: BSD-3-Clause
#include "truth/TestMeshes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace geodesictest
{

namespace
{

constexpr double Pi = 3.14159265358979323846;

using Edge = std::pair<Index, Index>;

Edge edgeBetween(Index a, Index b)
{
  return { std::min(a, b), std::max(a, b) };
}

Index size32(std::size_t n)
{
  return static_cast<Index>(n);
}

Vec3 difference(const Vec3& a, const Vec3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double dotProduct(const Vec3& a, const Vec3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vec3 crossProduct(const Vec3& a, const Vec3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

double length(const Vec3& a)
{
  return std::sqrt(dotProduct(a, a));
}

/// Twice the signed area in the xy plane.
double planarArea2(const PlainMesh& mesh, Index a, Index b, Index c)
{
  const Vec3 ab = difference(mesh.points[b], mesh.points[a]);
  const Vec3 ac = difference(mesh.points[c], mesh.points[a]);
  return ab[0] * ac[1] - ab[1] * ac[0];
}

/// Adds the cell with corners a, b, c, d (in turn) cut from a to c.
void addCell(PlainMesh& mesh, Index a, Index b, Index c, Index d)
{
  mesh.triangles.push_back({ a, b, c });
  mesh.triangles.push_back({ a, c, d });
}

struct Ring
{
  double radius;
  double height;
};

/// Cells between rings of `sides` points around an axis, from each ring to the next; if closed,
/// from the last to the first. The last ring may have the radius 0: all its points are one, an
/// apex.
PlainMesh turned(const std::vector<Ring>& rings, Index sides, bool isClosed)
{
  PlainMesh mesh;
  for (const Ring& ring : rings)
  {
    for (Index i = 0; i < (ring.radius > 0.0 ? sides : 1); ++i)
    {
      const double angle = 2.0 * Pi * i / sides;
      mesh.points.push_back(
        { ring.radius * std::cos(angle), ring.radius * std::sin(angle), ring.height });
    }
  }
  for (Index j = 0; j < (isClosed ? rings.size() : rings.size() - 1); ++j)
  {
    const Index k = j + 1 < rings.size() ? j + 1 : 0;
    for (Index i = 0; i < sides; ++i)
    {
      const Index a = j * sides + i;
      const Index b = j * sides + (i + 1) % sides;
      if (rings[k].radius > 0.0)
      {
        addCell(mesh, a, b, k * sides + (i + 1) % sides, k * sides + i);
      }
      else
      {
        mesh.triangles.push_back({ a, b, k * sides });
      }
    }
  }
  return mesh;
}

/// Hands out one vertex for each place of an integer lattice.
template <typename Key>
class VertexTable
{
public:
  explicit VertexTable(PlainMesh& mesh)
    : mesh_(mesh)
  {
  }

  Index operator()(const Key& key, const Vec3& point)
  {
    const auto [found, isNew] = this->table_.emplace(key, size32(this->mesh_.points.size()));
    if (isNew)
    {
      this->mesh_.points.push_back(point);
    }
    return found->second;
  }

private:
  PlainMesh& mesh_;
  std::map<Key, Index> table_;
};

/// Cuts a triangle into n x n; vertexAt(i, j) gives the vertex i steps to corner 1 and j to
/// corner 2.
template <typename VertexAt>
void addTriangleLattice(PlainMesh& mesh, Index n, const VertexAt& vertexAt)
{
  for (Index i = 0; i < n; ++i)
  {
    for (Index j = 0; i + j < n; ++j)
    {
      mesh.triangles.push_back({ vertexAt(i, j), vertexAt(i + 1, j), vertexAt(i, j + 1) });
      if (i + j + 1 < n)
      {
        mesh.triangles.push_back(
          { vertexAt(i + 1, j), vertexAt(i + 1, j + 1), vertexAt(i, j + 1) });
      }
    }
  }
}

/// The smaller of the two halves of the quad a, b, c, d cut from a to c.
double smallerHalf(const PlainMesh& mesh, Index a, Index b, Index c, Index d)
{
  return std::min(planarArea2(mesh, a, b, c), planarArea2(mesh, a, c, d));
}

/// Whether both halves of the quad are well away from flat.
bool canCut(const PlainMesh& mesh, Index a, Index b, Index c, Index d)
{
  return smallerHalf(mesh, a, b, c, d) > 0.05;
}

void flipRandomEdges(PlainMesh& mesh, Index tries, Random& random)
{
  std::map<Edge, std::vector<Index>> facesOf;
  for (Index f = 0; f < mesh.triangles.size(); ++f)
  {
    for (Index k = 0; k < 3; ++k)
    {
      facesOf[edgeBetween(mesh.triangles[f][k], mesh.triangles[f][(k + 1) % 3])].push_back(f);
    }
  }
  std::vector<Edge> edges;
  for (const auto& entry : facesOf)
  {
    if (entry.second.size() == 2)
    {
      edges.push_back(entry.first);
    }
  }
  std::vector<bool> touched(mesh.triangles.size(), false);
  for (Index i = 0; i < tries && !edges.empty(); ++i)
  {
    // Each face changes at most once, so that facesOf stays right for what is still looked up.
    const auto [a, c] = edges[random.below(edges.size())];
    const Index f = facesOf[{ a, c }][0];
    const Index g = facesOf[{ a, c }][1];
    if (touched[f] || touched[g])
    {
      continue;
    }
    const auto apex = [&mesh, from = a, to = c](Index face)
    {
      const Triangle& t = mesh.triangles[face];
      return *std::find_if(
        t.begin(), t.end(), [from, to](Index v) { return v != from && v != to; });
    };
    Index b = apex(f);
    Index d = apex(g);
    if (planarArea2(mesh, a, b, c) < 0.0)
    {
      std::swap(b, d);
    }
    if (canCut(mesh, b, c, d, a))
    {
      mesh.triangles[f] = { b, c, d };
      mesh.triangles[g] = { b, d, a };
      touched[f] = touched[g] = true;
    }
  }
}

/// The vertices of the jittered rectangle; the outline stays.
void addJitteredGrid(PlainMesh& mesh, Index nx, Index ny, Random& random)
{
  const double jitter = 0.35;
  for (Index j = 0; j <= ny; ++j)
  {
    for (Index i = 0; i <= nx; ++i)
    {
      const double dx = i == 0 || i == nx ? 0.0 : random.uniform(-jitter, jitter);
      const double dy = j == 0 || j == ny ? 0.0 : random.uniform(-jitter, jitter);
      mesh.points.push_back({ i + dx, j + dy, 0.0 });
    }
  }
}

void addRandomCells(
  PlainMesh& mesh, Index nx, Index ny, const std::vector<bool>& isHole, Random& random)
{
  for (Index j = 0; j < ny; ++j)
  {
    for (Index i = 0; i < nx; ++i)
    {
      const Index a = j * (nx + 1) + i;
      const Index b = a + 1;
      const Index c = b + nx + 1;
      const Index d = c - 1;
      const bool otherFirst = random.chance(0.5);
      if (isHole[j * nx + i])
      {
        continue;
      }
      // One diagonal at least is inside the quad.
      const bool either = canCut(mesh, a, b, c, d) && canCut(mesh, b, c, d, a);
      if (either ? otherFirst : smallerHalf(mesh, b, c, d, a) > smallerHalf(mesh, a, b, c, d))
      {
        addCell(mesh, b, c, d, a);
      }
      else
      {
        addCell(mesh, a, b, c, d);
      }
    }
  }
}

}

//----------------------------------------------------------------------------
double spaceDistance(const Vec3& a, const Vec3& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

Vec3 position(const PlainMesh& mesh, const MeshPoint& point)
{
  Vec3 sum = { 0.0, 0.0, 0.0 };
  for (Index k = 0; k < 3; ++k)
  {
    const Vec3& corner = mesh.points[mesh.triangles[point.face][k]];
    for (Index axis = 0; axis < 3; ++axis)
    {
      sum[axis] += point.weights[k] * corner[axis];
    }
  }
  return sum;
}

double Random::uniform()
{
  return static_cast<double>(this->engine_() >> 11) * 0x1.0p-53;
}

Index Random::below(std::size_t count)
{
  return static_cast<Index>(this->engine_() % count);
}

//----------------------------------------------------------------------------
MeshPoint randomFacePoint(const PlainMesh& mesh, Random& random)
{
  const Index face = random.below(mesh.triangles.size());
  double u = random.uniform(0.001, 0.998);
  double v = random.uniform(0.001, 0.998);
  if (u + v > 0.999)
  {
    u = 0.999 - u;
    v = 0.999 - v;
    u = std::max(u, 0.0005);
    v = std::max(v, 0.0005);
  }
  return { face, { 1.0 - u - v, u, v } };
}

MeshPoint randomEdgePoint(const PlainMesh& mesh, Random& random)
{
  MeshPoint point;
  point.face = random.below(mesh.triangles.size());
  const Index k = random.below(3);
  const double u = random.uniform(0.001, 0.999);
  point.weights[k] = 1.0 - u;
  point.weights[(k + 1) % 3] = u;
  point.weights[(k + 2) % 3] = 0.0;
  return point;
}

MeshPoint randomVertexPoint(const PlainMesh& mesh, Random& random)
{
  MeshPoint point;
  point.face = random.below(mesh.triangles.size());
  point.weights = { 0.0, 0.0, 0.0 };
  point.weights[random.below(3)] = 1.0;
  return point;
}

MeshPoint randomPoint(const PlainMesh& mesh, Random& random)
{
  switch (random.below(8))
  {
    case 0:
    case 1:
      return randomVertexPoint(mesh, random);
    case 2:
    case 3:
      return randomEdgePoint(mesh, random);
    case 4:
    {
      const double tiny = std::pow(10.0, -random.uniform(6.0, 18.0));
      const double u = random.chance(0.5) ? tiny : random.uniform(0.1, 0.9);
      return { random.below(mesh.triangles.size()), { 1.0 - u - tiny, u, tiny } };
    }
    default:
      return randomFacePoint(mesh, random);
  }
}

Barycentric randomWeights(Random& random)
{
  Barycentric weights = { 0.0, 0.0, 0.0 };
  const Index k = random.below(3);
  const double u = random.uniform(0.05, 0.9);
  switch (random.below(4))
  {
    case 0:
      weights[k] = 1.0;
      break;
    case 1:
      weights[k] = 1.0 - u;
      weights[(k + 1) % 3] = u;
      break;
    default:
    {
      const double v = random.uniform(0.05, 0.95) * (1.0 - u);
      weights = { 1.0 - u - v, u, v };
      break;
    }
  }
  return weights;
}

MeshPoint vertexPoint(const PlainMesh& mesh, Index vertex)
{
  MeshPoint point;
  for (Index f = 0; f < mesh.triangles.size(); ++f)
  {
    for (Index k = 0; k < 3; ++k)
    {
      if (mesh.triangles[f][k] == vertex)
      {
        point.face = f;
        point.weights = { 0.0, 0.0, 0.0 };
        point.weights[k] = 1.0;
        return point;
      }
    }
  }
  return point;
}

//----------------------------------------------------------------------------
void addNoise(PlainMesh& mesh, double noise, Random& random)
{
  for (Vec3& point : mesh.points)
  {
    for (double& coordinate : point)
    {
      coordinate += noise * random.uniform(-1.0, 1.0);
    }
  }
}

PlainMesh regularGrid(Index nx, Index ny)
{
  PlainMesh mesh;
  for (Index j = 0; j <= ny; ++j)
  {
    for (Index i = 0; i <= nx; ++i)
    {
      mesh.points.push_back({ static_cast<double>(i), static_cast<double>(j), 0.0 });
    }
  }
  for (Index j = 0; j < ny; ++j)
  {
    for (Index i = 0; i < nx; ++i)
    {
      const Index a = j * (nx + 1) + i;
      addCell(mesh, a, a + 1, a + nx + 2, a + nx + 1);
    }
  }
  return mesh;
}

PlainMesh randomPlanar(Index nx, Index ny, Random& random)
{
  return planarWithHoles(nx, ny, 0, random);
}

PlainMesh lShape(Index nx, Index ny)
{
  PlainMesh grid = regularGrid(nx, ny);
  PlainMesh mesh;
  mesh.points = grid.points;
  for (const Triangle& t : grid.triangles)
  {
    const Vec3& a = grid.points[t[0]];
    // Corner 0 is the lower left one of its cell.
    if (a[0] < nx / 2 || a[1] < ny / 2)
    {
      mesh.triangles.push_back(t);
    }
  }
  return compacted(mesh);
}

PlainMesh planarWithHoles(Index nx, Index ny, Index holes, Random& random)
{
  PlainMesh mesh;
  addJitteredGrid(mesh, nx, ny, random);
  std::vector<bool> isHole(std::size_t(nx) * ny, false);
  for (Index h = 0; h < holes && nx > 4 && ny > 4; ++h)
  {
    // A block of cells away from the outline.
    const Index width = random.between(1, std::max<Index>(1, nx / 5));
    const Index height = random.between(1, std::max<Index>(1, ny / 5));
    const Index left = random.between(1, nx - 1 - width);
    const Index bottom = random.between(1, ny - 1 - height);
    for (Index j = bottom; j < bottom + height; ++j)
    {
      for (Index i = left; i < left + width; ++i)
      {
        isHole[j * nx + i] = true;
      }
    }
  }
  addRandomCells(mesh, nx, ny, isHole, random);
  flipRandomEdges(mesh, size32(mesh.triangles.size()), random);
  return compacted(mesh);
}

PlainMesh bumpySheet(Index nx, Index ny, Index holes, double amplitude, Random& random)
{
  PlainMesh mesh = planarWithHoles(nx, ny, holes, random);
  for (Vec3& p : mesh.points)
  {
    p[2] = random.uniform(-amplitude, amplitude);
  }
  return mesh;
}

PlainMesh needleSheet(Index nx, Index ny, double aspect, double amplitude, Random& random)
{
  PlainMesh mesh = bumpySheet(nx, ny, 0, amplitude, random);
  for (Vec3& p : mesh.points)
  {
    p[0] *= aspect;
  }
  return mesh;
}

PlainMesh octasphere(Index n)
{
  PlainMesh mesh;
  VertexTable<std::array<int, 3>> vertexOf(mesh);
  for (int octant = 0; octant < 8; ++octant)
  {
    const int sx = octant & 1 ? -1 : 1;
    const int sy = octant & 2 ? -1 : 1;
    const int sz = octant & 4 ? -1 : 1;
    addTriangleLattice(mesh, n,
      [&](Index i, Index j)
      {
        const std::array<int, 3> key = { sx * static_cast<int>(n - i - j), sy * static_cast<int>(i),
          sz * static_cast<int>(j) };
        // Summing integers keeps mirror images equal bit by bit.
        const double r =
          std::sqrt(static_cast<double>(key[0] * key[0] + key[1] * key[1] + key[2] * key[2]));
        return vertexOf(key, { key[0] / r, key[1] / r, key[2] / r });
      });
  }
  return mesh;
}

PlainMesh book(Index pages, Index n, Index m, double amplitude, Random& random)
{
  PlainMesh mesh;
  // Under a quarter, so that no cell folds over.
  const auto jitter = [&random](bool inside) { return inside ? random.uniform(-0.24, 0.24) : 0.0; };
  for (Index i = 0; i <= n; ++i)
  {
    mesh.points.push_back({ 0.0, 0.0, i + jitter(i > 0 && i < n) });
  }
  for (Index page = 0; page < pages; ++page)
  {
    const double angle = 2.0 * Pi * (page + random.uniform(-0.3, 0.3)) / pages;
    const Index start = size32(mesh.points.size());
    for (Index j = 1; j <= m; ++j)
    {
      for (Index i = 0; i <= n; ++i)
      {
        const double r = j + jitter(j < m);
        const double off = random.uniform(-amplitude, amplitude);
        mesh.points.push_back({ r * std::cos(angle) - off * std::sin(angle),
          r * std::sin(angle) + off * std::cos(angle), i + jitter(i > 0 && i < n) });
      }
    }
    const auto vertexAt = [&](Index i, Index j)
    { return j == 0 ? i : start + (j - 1) * (n + 1) + i; };
    for (Index j = 0; j < m; ++j)
    {
      for (Index i = 0; i < n; ++i)
      {
        addCell(
          mesh, vertexAt(i, j), vertexAt(i + 1, j), vertexAt(i + 1, j + 1), vertexAt(i, j + 1));
      }
    }
  }
  return mesh;
}

PlainMesh moebius(Index n, Index m)
{
  PlainMesh mesh;
  const double radius = n / (2.0 * Pi);
  for (Index i = 0; i < n; ++i)
  {
    const double angle = 2.0 * Pi * i / n;
    for (Index j = 0; j <= m; ++j)
    {
      const double w = static_cast<double>(j) - 0.5 * m;
      const double r = radius + w * std::cos(0.5 * angle);
      mesh.points.push_back(
        { r * std::cos(angle), r * std::sin(angle), w * std::sin(0.5 * angle) });
    }
  }
  const auto vertexAt = [&](Index i, Index j) { return i < n ? i * (m + 1) + j : m - j; };
  for (Index i = 0; i < n; ++i)
  {
    for (Index j = 0; j < m; ++j)
    {
      addCell(mesh, vertexAt(i, j), vertexAt(i + 1, j), vertexAt(i + 1, j + 1), vertexAt(i, j + 1));
    }
  }
  return mesh;
}

PlainMesh box(const Vec3& size, const std::array<Index, 3>& n)
{
  PlainMesh mesh;
  VertexTable<std::array<Index, 3>> vertexOf(mesh);
  for (Index axis = 0; axis < 3; ++axis)
  {
    const Index u = (axis + 1) % 3;
    const Index v = (axis + 2) % 3;
    for (Index end = 0; end < 2; ++end)
    {
      const auto vertexAt = [&](Index i, Index j)
      {
        std::array<Index, 3> key{};
        key[axis] = end * n[axis];
        key[u] = i;
        key[v] = j;
        Vec3 p{};
        for (Index k = 0; k < 3; ++k)
        {
          p[k] = key[k] == n[k] ? size[k] : size[k] * key[k] / n[k];
        }
        return vertexOf(key, p);
      };
      for (Index i = 0; i < n[u]; ++i)
      {
        for (Index j = 0; j < n[v]; ++j)
        {
          // One after another, as arguments are evaluated in any order: each numbers a vertex.
          const Index d = vertexAt(i, j + 1);
          const Index c = vertexAt(i + 1, j + 1);
          const Index b = vertexAt(i + 1, j);
          const Index a = vertexAt(i, j);
          addCell(mesh, a, b, c, d);
        }
      }
    }
  }
  return mesh;
}

PlainMesh openCylinder(Index sides, Index rows, double height)
{
  std::vector<Ring> rings;
  for (Index j = 0; j <= rows; ++j)
  {
    rings.push_back({ 0.5 / std::sin(Pi / sides), height * j / rows });
  }
  return turned(rings, sides, false);
}

PlainMesh torus(Index sides, Index rows, double ratio)
{
  std::vector<Ring> rings;
  for (Index j = 0; j < rows; ++j)
  {
    const double angle = 2.0 * Pi * j / rows;
    rings.push_back({ ratio + std::cos(angle), std::sin(angle) });
  }
  return turned(rings, sides, true);
}

PlainMesh roundCone(Index sides, Index rows, double height)
{
  std::vector<Ring> rings;
  for (Index j = 0; j <= rows; ++j)
  {
    const double left = static_cast<double>(rows - j) / rows;
    rings.push_back({ left * 0.5 / std::sin(Pi / sides), height * (1.0 - left) });
  }
  return turned(rings, sides, false);
}

PlainMesh fan(Index sectors, double angle, Index n)
{
  // Legs of length 1 go to the rim at heights +h and -h by turns (a saddle) or all at h (a cone);
  // the rim's step is 2 sin(angle / 2).
  const double step = 2.0 * std::sin(0.5 * angle);
  const double turn = std::sin(Pi / sectors);
  const bool saddle = sectors * angle > 2.0 * Pi;
  // Saddle: step^2 = (2 r turn)^2 + 4 h^2 with r^2 + h^2 = 1; cone: step = 2 r turn.
  const double r =
    saddle ? std::sqrt((4.0 - step * step) / (4.0 - 4.0 * turn * turn)) : step / (2.0 * turn);
  const double h = std::sqrt(std::max(0.0, 1.0 - r * r));
  const auto rim = [&](Index i) -> Vec3
  {
    const double phi = 2.0 * Pi * i / sectors;
    return { r * std::cos(phi), r * std::sin(phi), saddle && i % 2 == 1 ? -h : h };
  };
  PlainMesh mesh;
  // A place is (ring, step along it); ring 0 is the apex.
  VertexTable<std::pair<Index, Index>> vertexOf(mesh);
  for (Index s = 0; s < sectors; ++s)
  {
    const Vec3 p = rim(s);
    const Vec3 q = rim((s + 1) % sectors);
    addTriangleLattice(mesh, n,
      [&](Index i, Index j)
      {
        const Index ring = i + j;
        const Index around = ring == 0 ? 0 : (s * ring + j) % (sectors * ring);
        Vec3 x{};
        for (Index k = 0; k < 3; ++k)
        {
          x[k] = (i * p[k] + j * q[k]) / n;
        }
        return vertexOf({ ring, around }, x);
      });
  }
  return mesh;
}

std::array<Vec3, 4> tetrahedronCorners()
{
  const double s = std::sqrt(0.125);
  return { { { s, s, s }, { s, -s, -s }, { -s, s, -s }, { -s, -s, s } } };
}

PlainMesh tetrahedron(Index n)
{
  const std::array<Vec3, 4> corners = tetrahedronCorners();
  PlainMesh mesh;
  VertexTable<std::array<Index, 4>> vertexOf(mesh);
  for (Index face = 0; face < 4; ++face)
  {
    const Index a = (face + 1) % 4;
    const Index b = (face + 2) % 4;
    const Index c = (face + 3) % 4;
    addTriangleLattice(mesh, n,
      [&](Index i, Index j)
      {
        std::array<Index, 4> key{};
        key[a] = n - i - j;
        key[b] = i;
        key[c] = j;
        Vec3 x{};
        for (Index k = 0; k < 3; ++k)
        {
          for (Index corner = 0; corner < 4; ++corner)
          {
            x[k] += key[corner] * corners[corner][k] / n;
          }
        }
        return vertexOf(key, x);
      });
  }
  return mesh;
}

//----------------------------------------------------------------------------
PlainMesh merged(const PlainMesh& a, const PlainMesh& b)
{
  PlainMesh mesh = a;
  const Index shift = size32(a.points.size());
  mesh.points.insert(mesh.points.end(), b.points.begin(), b.points.end());
  for (const Triangle& t : b.triangles)
  {
    mesh.triangles.push_back({ t[0] + shift, t[1] + shift, t[2] + shift });
  }
  return mesh;
}

PlainMesh joinedAtVertex(const PlainMesh& a, Index vertexOfA, const PlainMesh& b, Index vertexOfB)
{
  PlainMesh mesh = merged(a, b);
  const Index shift = size32(a.points.size());
  const Vec3 move = difference(a.points[vertexOfA], b.points[vertexOfB]);
  for (std::size_t i = shift; i < mesh.points.size(); ++i)
  {
    for (Index k = 0; k < 3; ++k)
    {
      mesh.points[i][k] += move[k];
    }
  }
  for (Triangle& t : mesh.triangles)
  {
    std::replace(t.begin(), t.end(), vertexOfB + shift, vertexOfA);
  }
  return compacted(mesh);
}

Renumbered renumbered(const PlainMesh& mesh, Random& random)
{
  const auto shuffled = [&random](std::size_t n)
  {
    std::vector<Index> order(n);
    std::iota(order.begin(), order.end(), Index(0));
    for (std::size_t i = n; i > 1; --i)
    {
      std::swap(order[i - 1], order[random.below(i)]);
    }
    return order;
  };
  Renumbered result;
  result.vertexMap = shuffled(mesh.points.size());
  result.faceMap = shuffled(mesh.triangles.size());
  result.mesh.points.resize(mesh.points.size());
  result.mesh.triangles.resize(mesh.triangles.size());
  for (Index v = 0; v < mesh.points.size(); ++v)
  {
    result.mesh.points[result.vertexMap[v]] = mesh.points[v];
  }
  for (Index f = 0; f < mesh.triangles.size(); ++f)
  {
    const Index shift = random.below(3);
    result.cornerShift.push_back(shift);
    for (Index k = 0; k < 3; ++k)
    {
      result.mesh.triangles[result.faceMap[f]][(k + shift) % 3] =
        result.vertexMap[mesh.triangles[f][k]];
    }
  }
  return result;
}

PlainMesh withFlippedFaces(const PlainMesh& mesh, Random& random, std::vector<bool>* flipped)
{
  PlainMesh result = mesh;
  for (Triangle& t : result.triangles)
  {
    const bool flip = random.chance(0.5);
    if (flip)
    {
      std::swap(t[1], t[2]);
    }
    if (flipped)
    {
      flipped->push_back(flip);
    }
  }
  return result;
}

PlainMesh withSplitFaces(const PlainMesh& mesh, double fraction, Random& random)
{
  PlainMesh result;
  result.points = mesh.points;
  for (Index f = 0; f < mesh.triangles.size(); ++f)
  {
    const Triangle& t = mesh.triangles[f];
    if (!random.chance(fraction))
    {
      result.triangles.push_back(t);
      continue;
    }
    const Index center = size32(result.points.size());
    result.points.push_back(position(mesh, { f, { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 } }));
    for (Index k = 0; k < 3; ++k)
    {
      result.triangles.push_back({ t[k], t[(k + 1) % 3], center });
    }
  }
  return result;
}

PlainMesh withSplitEdges(const PlainMesh& mesh, double fraction, Random& random)
{
  PlainMesh result;
  result.points = mesh.points;
  std::map<Edge, Index> middles;
  constexpr Index none = ~Index(0);
  for (const Triangle& t : mesh.triangles)
  {
    std::array<Index, 3> middle{};
    for (Index k = 0; k < 3; ++k)
    {
      const Edge edge = edgeBetween(t[k], t[(k + 1) % 3]);
      const auto [found, isNew] = middles.emplace(edge, none);
      if (isNew && random.chance(fraction))
      {
        found->second = size32(result.points.size());
        const Vec3& a = mesh.points[edge.first];
        const Vec3& b = mesh.points[edge.second];
        result.points.push_back({ 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2]) });
      }
      middle[k] = found->second;
    }
    // The outline of the face with its midpoints, as corners cut off one by one: first those
    // between two midpoints, then a fan from the last midpoint.
    std::vector<Index> outline;
    for (Index k = 0; k < 3; ++k)
    {
      if (middle[(k + 2) % 3] != none && middle[k] != none)
      {
        result.triangles.push_back({ t[k], middle[k], middle[(k + 2) % 3] });
      }
      else
      {
        outline.push_back(t[k]);
      }
      if (middle[k] != none)
      {
        outline.push_back(middle[k]);
      }
    }
    // Begin at a midpoint, which sees all others without a face of zero area.
    const auto start = std::find_if(
      outline.begin(), outline.end(), [&mesh](Index v) { return v >= size32(mesh.points.size()); });
    if (start != outline.end())
    {
      std::rotate(outline.begin(), start, outline.end());
    }
    for (std::size_t i = 1; i + 1 < outline.size(); ++i)
    {
      result.triangles.push_back({ outline[0], outline[i], outline[i + 1] });
    }
  }
  return result;
}

PlainMesh subdivided(const PlainMesh& mesh)
{
  Random random(0);
  return withSplitEdges(mesh, 1.0, random);
}

PlainMesh scaled(const PlainMesh& mesh, double factor)
{
  PlainMesh result = mesh;
  for (Vec3& p : result.points)
  {
    p = { factor * p[0], factor * p[1], factor * p[2] };
  }
  return result;
}

PlainMesh moved(const PlainMesh& mesh, Random& random)
{
  double size = 0.0;
  for (const Vec3& p : mesh.points)
  {
    size = std::max(size, length(p));
  }
  // Gram-Schmidt on two random vectors.
  const auto randomVector = [&random]() -> Vec3 {
    return { random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(0.1, 1.0) };
  };
  Vec3 x = randomVector();
  const double lx = length(x);
  x = { x[0] / lx, x[1] / lx, x[2] / lx };
  Vec3 z = crossProduct(x, { x[1], x[2], -x[0] });
  const double lz = length(z);
  z = { z[0] / lz, z[1] / lz, z[2] / lz };
  const Vec3 y = crossProduct(z, x);
  const Vec3 shift = { random.uniform(-size, size), random.uniform(-size, size),
    random.uniform(-size, size) };
  PlainMesh result = mesh;
  for (Vec3& p : result.points)
  {
    const Vec3 old = p;
    for (Index k = 0; k < 3; ++k)
    {
      p[k] = shift[k] + old[0] * x[k] + old[1] * y[k] + old[2] * z[k];
    }
  }
  return result;
}

PlainMesh compacted(const PlainMesh& mesh)
{
  constexpr Index none = ~Index(0);
  std::vector<Index> newId(mesh.points.size(), none);
  for (const Triangle& t : mesh.triangles)
  {
    for (Index v : t)
    {
      newId[v] = 0;
    }
  }
  PlainMesh result;
  for (Index v = 0; v < mesh.points.size(); ++v)
  {
    if (newId[v] != none)
    {
      newId[v] = size32(result.points.size());
      result.points.push_back(mesh.points[v]);
    }
  }
  for (const Triangle& t : mesh.triangles)
  {
    result.triangles.push_back({ newId[t[0]], newId[t[1]], newId[t[2]] });
  }
  return result;
}

//----------------------------------------------------------------------------
std::vector<std::pair<Index, Index>> boundaryEdges(const PlainMesh& mesh)
{
  std::map<Edge, Index> count;
  for (const Triangle& t : mesh.triangles)
  {
    for (Index k = 0; k < 3; ++k)
    {
      ++count[edgeBetween(t[k], t[(k + 1) % 3])];
    }
  }
  std::vector<Edge> edges;
  for (const auto& entry : count)
  {
    if (entry.second == 1)
    {
      edges.push_back(entry.first);
    }
  }
  return edges;
}

std::size_t countSaddles(const PlainMesh& mesh)
{
  std::vector<double> angle(mesh.points.size(), 0.0);
  for (const Triangle& t : mesh.triangles)
  {
    for (Index k = 0; k < 3; ++k)
    {
      const Vec3 a = difference(mesh.points[t[(k + 1) % 3]], mesh.points[t[k]]);
      const Vec3 b = difference(mesh.points[t[(k + 2) % 3]], mesh.points[t[k]]);
      angle[t[k]] += std::atan2(length(crossProduct(a, b)), dotProduct(a, b));
    }
  }
  for (const Edge& edge : boundaryEdges(mesh))
  {
    angle[edge.first] = angle[edge.second] = 0.0;
  }
  return static_cast<std::size_t>(std::count_if(
    angle.begin(), angle.end(), [](double sum) { return sum > 2.0 * Pi * (1.0 + 1e-12); }));
}

}
