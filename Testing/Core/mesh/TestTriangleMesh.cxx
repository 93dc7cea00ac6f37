// SPDX-License-Identifier: BSD-3-Clause
// The mesh structure: siblings of halfedges, counts, areas, which vertices may become
// pseudo-sources.
#include "EngineSupport.h"

#include "Errors.h"
#include "Tolerance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace geodesictest;
using geodesic::TriangleMesh;

namespace
{

constexpr double Pi = 3.14159265358979323846;

std::size_t numberOfSiblings(const TriangleMesh& mesh, geodesic::Id halfedge)
{
  std::size_t size = 1;
  for (geodesic::Id s = mesh.nextSibling(halfedge); s != halfedge; s = mesh.nextSibling(s))
  {
    ++size;
    if (size > mesh.numberOfHalfedges())
    {
      break;
    }
  }
  return size;
}

bool isPseudoSource(const TriangleMesh& mesh, geodesic::Id vertex)
{
  return mesh.pseudoSource(vertex) != TriangleMesh::PseudoSource::None;
}

/// Compares the siblings of every halfedge with a table of edges by their vertices.
void expectSiblingsAreEdges(const PlainMesh& plain)
{
  const TriangleMesh mesh = engineMesh(plain);
  std::map<std::pair<Index, Index>, std::set<geodesic::Id>> edges;
  for (geodesic::Id s = 0; s < mesh.numberOfHalfedges(); ++s)
  {
    EXPECT_EQ(mesh.destination(s), mesh.origin(TriangleMesh::nextInFace(s)));
    EXPECT_EQ(TriangleMesh::previousInFace(TriangleMesh::nextInFace(s)), s);
    edges[std::minmax(mesh.origin(s), mesh.destination(s))].insert(s);
  }
  EXPECT_EQ(numberOfEdges(mesh), edges.size());
  geodesic::Id nonManifold = 0;
  for (const auto& edge : edges)
  {
    nonManifold += edge.second.size() > 2 ? 1 : 0;
    for (geodesic::Id s : edge.second)
    {
      EXPECT_EQ(numberOfSiblings(mesh, s), edge.second.size());
      EXPECT_EQ(mesh.isBoundary(s), edge.second.size() == 1);
      EXPECT_EQ(mesh.edgeOf(s), *edge.second.begin());
      EXPECT_TRUE(edge.second.count(mesh.nextSibling(s)));
    }
  }
  EXPECT_EQ(mesh.numberOfNonManifoldEdges(), nonManifold);
}

}

TEST(TriangleMesh, TheSiblingsOfAHalfedgeAreAllHalfedgesOfItsEdge)
{
  Random random(1);
  expectSiblingsAreEdges(octasphere(4));
  expectSiblingsAreEdges(bumpySheet(8, 8, 2, 0.5, random));
  expectSiblingsAreEdges(book(5, 4, 3, 0.3, random));
  expectSiblingsAreEdges(moebius(15, 3));
  expectSiblingsAreEdges(withFlippedFaces(box({ 1, 1, 1 }, { 2, 3, 2 }), random));
  expectSiblingsAreEdges(joinedAtVertex(regularGrid(3, 3), 5, regularGrid(3, 3), 5));
}

TEST(TriangleMesh, BadFacesAreLeftOutButForThoseWithoutAreaAndTheFirstOfCopies)
{
  PlainMesh plain = regularGrid(2, 2); // 9 points, 8 faces
  plain.points.push_back({ 5, 5, 5 });
  plain.points.push_back({ 0.5, 0, 0 });
  plain.triangles.insert(plain.triangles.begin(), { 3, 3, 4 }); // repeats a vertex
  plain.triangles.push_back({ 4, 0, 1 });                       // a copy of the first face, turned
  plain.triangles.push_back({ 0, 4, 1 });                       // and flipped
  plain.triangles.push_back({ 0, 10, 1 });                      // collinear corners
  plain.triangles.push_back({ 2, 1, 2 });
  const TriangleMesh mesh = engineMesh(plain);
  EXPECT_EQ(facesWithoutArea(plain), 1u);
  EXPECT_EQ(mesh.numberOfNonManifoldEdges(), 0u);
  ASSERT_EQ(mesh.numberOfFaces(), 9u);
  for (geodesic::Id f = 0; f < mesh.numberOfFaces(); ++f)
  {
    EXPECT_EQ(mesh.inputFace(f), f < 8 ? f + 1 : 11U);
    EXPECT_EQ(mesh.triangle(f), plain.triangles[mesh.inputFace(f)]) << "face " << f;
  }
}

TEST(TriangleMesh, AreasOfNeedlesAreExactUpToRounding)
{
  // Coordinates with few bits: differences are exact, and so is the area in extended precision.
  Random random(7);
  const auto coordinate = [&random](double size) { return std::floor(random.uniform(0.0, size)); };
  for (int i = 0; i < 1000; ++i)
  {
    const double length = 68719476736.0; // products of two such round
    const Vec3 along = { coordinate(length), coordinate(length), coordinate(length) };
    const Vec3 beside = { coordinate(16.0) + 1.0, coordinate(16.0), coordinate(16.0) };
    const PlainMesh plain = { { { 0, 0, 0 }, along, beside }, { { 0, 1, 2 } } };
    long double squared = 0.0L;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t m = (k + 1) % 3;
      const long double c = static_cast<long double>(along[k]) * beside[m] -
        static_cast<long double>(along[m]) * beside[k];
      squared += c * c;
    }
    const double area2 = static_cast<double>(std::sqrt(squared));
    // of the product of the two shorter edges, not of two long ones
    const double rounding = 4.0 * geodesic::tolerance::Rounding *
      spaceDistance(along, { 0, 0, 0 }) * spaceDistance(beside, { 0, 0, 0 });
    for (Index first = 0; first < 3; ++first)
    {
      PlainMesh turned = plain;
      turned.triangles = { { first, (first + 1) % 3, (first + 2) % 3 } };
      ASSERT_NEAR(engineMesh(turned).shape(0).area2, area2, rounding) << i;
    }
  }
}

TEST(TriangleMesh, AFaceIsCountedAsWithoutAreaUpToRoundingOnly)
{
  const auto counted = [](double h)
  {
    const PlainMesh plain = { { { 0, 0, 0 }, { 2, 0, 0 }, { 1, h, 0 } }, { { 0, 1, 2 } } };
    return facesWithoutArea(plain) == 1;
  };
  EXPECT_TRUE(counted(0.0));
  EXPECT_TRUE(counted(9e-12));
  EXPECT_FALSE(counted(1.1e-11));
}

// Even if coordinates are rounded to more than a fraction of the face.
TEST(TriangleMesh, ACornerOnTheLongestEdgeLeavesAnAltitudeThatChangesNoLength)
{
  Random random(77);
  for (int i = 0; i < 1000; ++i)
  {
    const double far = i % 2 == 0 ? 0.0 : 1e4;
    const Vec3 a = { far + random.uniform(), random.uniform(), random.uniform() };
    const Vec3 b = { far + random.uniform(), random.uniform(), random.uniform() };
    const double t = random.uniform(0.05, 0.95);
    PlainMesh plain;
    plain.points = { a, b, {} };
    for (std::size_t k = 0; k < 3; ++k)
    {
      plain.points[2][k] = (1.0 - t) * a[k] + t * b[k];
    }
    plain.triangles = { { 0, 1, 2 } };
    const TriangleMesh mesh = engineMesh(plain);
    EXPECT_EQ(facesWithoutArea(plain), 1u) << i;
    const geodesic::FaceShape& shape = mesh.shape(0);
    EXPECT_GT(shape.area2, 0.0) << i;
    EXPECT_LT(mesh.cornerAngle(2), Pi) << i;
    // The height's square changes a side by half its fraction of the side.
    const double height = shape.area2 / shape.longest();
    EXPECT_LE(height * height, geodesic::tolerance::Rounding * shape.shortest() * shape.shortest())
      << i;
    EXPECT_NEAR(shape.length[0], shape.length[1] + shape.length[2],
      4.0 * (far + 1.0) * geodesic::tolerance::Rounding)
      << i;
  }
}

TEST(TriangleMesh, AFlatVertexIsNoSaddleAndAnExcessBeyondRoundingIsOne)
{
  // In a plane the angles sum to 2 pi up to rounding.
  Random random(8);
  for (int i = 0; i < 20; ++i)
  {
    const PlainMesh plain = moved(randomPlanar(8, 8, random), random);
    const TriangleMesh mesh = engineMesh(plain);
    std::set<Index> boundary;
    for (const auto& edge : boundaryEdges(plain))
    {
      boundary.insert({ edge.first, edge.second });
    }
    for (geodesic::Id v = 0; v < mesh.numberOfVertices(); ++v)
    {
      EXPECT_FALSE(isPseudoSource(mesh, v) && boundary.count(v) == 0) << "vertex " << v;
    }
  }
  // Points around the vertex alternate between up and down: an excess of about 1e-10.
  PlainMesh fan = { { { 0, 0, 0 } }, {} };
  constexpr Index spokes = 8;
  long double angle = 0.0L;
  const auto at = [](Index i)
  {
    const double a = 2.0 * Pi * i / spokes;
    return Vec3{ std::cos(a), std::sin(a), i % 2 == 0 ? 3e-6 : -3e-6 };
  };
  for (Index i = 0; i < spokes; ++i)
  {
    const Vec3 p = at(i);
    const Vec3 q = at((i + 1) % spokes);
    fan.points.push_back(p);
    fan.triangles.push_back({ 0, 1 + i, 1 + (i + 1) % spokes });
    const long double x =
      p[1] * static_cast<long double>(q[2]) - p[2] * static_cast<long double>(q[1]);
    const long double y =
      p[2] * static_cast<long double>(q[0]) - p[0] * static_cast<long double>(q[2]);
    const long double z =
      p[0] * static_cast<long double>(q[1]) - p[1] * static_cast<long double>(q[0]);
    const long double dot = p[0] * static_cast<long double>(q[0]) +
      p[1] * static_cast<long double>(q[1]) + p[2] * static_cast<long double>(q[2]);
    angle += std::atan2(std::sqrt(x * x + y * y + z * z), dot);
  }
  const double excess = static_cast<double>(angle) / (2.0 * Pi) - 1.0;
  ASSERT_GT(excess, 1e-12);
  ASSERT_LT(excess, 1e-9);
  EXPECT_EQ(engineMesh(fan).pseudoSource(0), TriangleMesh::PseudoSource::Saddle);
}

TEST(TriangleMesh, OnASphereNoVertexIsAPseudoSource)
{
  const TriangleMesh mesh = engineMesh(octasphere(6));
  for (geodesic::Id v = 0; v < mesh.numberOfVertices(); ++v)
  {
    EXPECT_FALSE(isPseudoSource(mesh, v)) << "vertex " << v;
  }
}

TEST(TriangleMesh, EverySaddleVertexIsAPseudoSource)
{
  // One saddle at the apex.
  const TriangleMesh saddle = engineMesh(fan(8, 1.0, 4));
  EXPECT_TRUE(isPseudoSource(saddle, 0));
  const TriangleMesh cone = engineMesh(fan(8, 0.7, 4));
  EXPECT_FALSE(isPseudoSource(cone, 0));
  Random random(4);
  const PlainMesh plain = bumpySheet(12, 12, 0, 0.5, random);
  const TriangleMesh mesh = engineMesh(plain);
  std::size_t inside = 0;
  std::set<Index> boundary;
  for (const auto& edge : boundaryEdges(plain))
  {
    boundary.insert({ edge.first, edge.second });
  }
  for (geodesic::Id v = 0; v < mesh.numberOfVertices(); ++v)
  {
    inside += isPseudoSource(mesh, v) && boundary.count(v) == 0 ? 1 : 0;
  }
  EXPECT_EQ(inside, countSaddles(plain));
}

TEST(TriangleMesh, OnTheBoundaryOnlyReflexVerticesArePseudoSources)
{
  // The only reflex corner of an L is in its middle.
  const PlainMesh plain = lShape(6, 6);
  const TriangleMesh mesh = engineMesh(plain);
  for (geodesic::Id v = 0; v < mesh.numberOfVertices(); ++v)
  {
    const bool reflex = plain.points[v][0] == 3.0 && plain.points[v][1] == 3.0;
    EXPECT_TRUE(isPseudoSource(mesh, v) || !reflex) << "the reflex corner must be one";
    const bool corner = plain.points[v] == Vec3{ 0, 0, 0 } || plain.points[v] == Vec3{ 6, 0, 0 } ||
      plain.points[v] == Vec3{ 6, 3, 0 };
    EXPECT_FALSE(isPseudoSource(mesh, v) && corner) << "vertex " << v;
  }
}

TEST(TriangleMesh, WhereFansMeetAndAtNonManifoldEdgesVerticesArePseudoSources)
{
  Random random(6);
  const TriangleMesh knot = engineMesh(joinedAtVertex(regularGrid(4, 4), 12, regularGrid(4, 4), 0));
  EXPECT_TRUE(isPseudoSource(knot, 12));
  // The spine of a book is its first vertices.
  const TriangleMesh pages = engineMesh(book(3, 5, 3, 0.0, random));
  for (geodesic::Id v = 0; v <= 5; ++v)
  {
    EXPECT_TRUE(isPseudoSource(pages, v)) << "vertex " << v << " of the spine";
  }
}

TEST(TriangleMesh, ComponentsAreThoseOfSharedVertices)
{
  const PlainMesh grid = regularGrid(3, 3);
  const PlainMesh knotted = joinedAtVertex(grid, 15, grid, 0);
  const std::vector<geodesic::Id> component = engineMesh(merged(knotted, grid)).components();
  for (std::size_t v = 0; v < component.size(); ++v)
  {
    const bool first = v < knotted.points.size();
    EXPECT_EQ(component[v] == component[0], first) << "vertex " << v;
    EXPECT_EQ(component[v] == component.back(), !first) << "vertex " << v;
  }
}

TEST(TriangleMesh, AMeshWithoutFacesIsRefused)
{
  EXPECT_THROW(TriangleMesh({}, {}), geodesic::MeshError);
  EXPECT_THROW(TriangleMesh({ { 0, 0, 0 } }, {}), geodesic::MeshError);
  EXPECT_THROW(
    TriangleMesh({ { 0, 0, 0 }, { 1, 0, 0 } }, { { 0, 1, 1 }, { 0, 0, 1 } }), geodesic::MeshError);
}

TEST(TriangleMesh, AnIdOutOfRangeIsRefused)
{
  EXPECT_THROW(
    TriangleMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 3 } }), geodesic::MeshError);
}
