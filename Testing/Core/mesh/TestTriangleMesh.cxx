// SPDX-License-Identifier: BSD-3-Clause
// The mesh structure: siblings of halfedges, counts, areas, which vertices may become
// pseudo-sources.
#include "EngineSupport.h"

#include "Errors.h"

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

/// Checks the siblings of every halfedge against a table of edges by their vertices.
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
  EXPECT_EQ(mesh.numberOfEdges(), edges.size());
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
  EXPECT_EQ(mesh.report().nonManifoldEdges, nonManifold);
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

TEST(TriangleMesh, CornersAtAVertexAreAllItsCorners)
{
  Random random(2);
  const TriangleMesh mesh = engineMesh(book(4, 4, 3, 0.3, random));
  std::size_t corners = 0;
  for (geodesic::Id v = 0; v < mesh.numberOfVertices(); ++v)
  {
    for (geodesic::Id corner : mesh.cornersAt(v))
    {
      EXPECT_EQ(mesh.origin(corner), v);
      ++corners;
    }
  }
  EXPECT_EQ(corners, mesh.numberOfHalfedges());
}

TEST(TriangleMesh, AnglesOfAFaceSumToPi)
{
  Random random(3);
  const TriangleMesh mesh = engineMesh(needleSheet(6, 6, 1e5, 0.3, random));
  for (geodesic::Id f = 0; f < mesh.numberOfFaces(); ++f)
  {
    const double sum =
      mesh.cornerAngle(3 * f) + mesh.cornerAngle(3 * f + 1) + mesh.cornerAngle(3 * f + 2);
    EXPECT_NEAR(sum, Pi, 1e-13) << "face " << f;
  }
}

TEST(TriangleMesh, LengthsAndAreaAreThoseInSpace)
{
  const PlainMesh plain = { { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 4, 0 } }, { { 0, 1, 2 } } };
  const TriangleMesh mesh = engineMesh(plain);
  EXPECT_DOUBLE_EQ(mesh.length(0), 3.0);
  EXPECT_DOUBLE_EQ(mesh.length(1), 5.0);
  EXPECT_DOUBLE_EQ(mesh.length(2), 4.0);
  EXPECT_DOUBLE_EQ(mesh.shape(0).area2, 12.0);
  EXPECT_DOUBLE_EQ(mesh.shape(0).cornerDot[0], 0.0);
  EXPECT_DOUBLE_EQ(mesh.shape(0).cornerDot[1], 9.0);
  EXPECT_DOUBLE_EQ(mesh.shape(0).cornerDot[2], 16.0);
}

TEST(TriangleMesh, WhatIsLeftOutOrNoticedIsCounted)
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
  EXPECT_EQ(mesh.report().facesWithRepeatedVertex, 2u);
  EXPECT_EQ(mesh.report().duplicateFaces, 2u);
  EXPECT_EQ(mesh.report().zeroAreaFaces, 1u);
  EXPECT_EQ(mesh.report().isolatedVertices, 1u);
  EXPECT_EQ(mesh.report().nonManifoldEdges, 0u);
  ASSERT_EQ(mesh.numberOfFaces(), 9u);
  for (geodesic::Id f = 0; f < mesh.numberOfFaces(); ++f)
  {
    EXPECT_EQ(mesh.triangle(f), plain.triangles[mesh.inputFace(f)]) << "face " << f;
  }
}

TEST(TriangleMesh, NothingIsCountedOnAGoodMesh)
{
  const TriangleMesh mesh = engineMesh(octasphere(5));
  EXPECT_EQ(mesh.report().facesWithRepeatedVertex, 0u);
  EXPECT_EQ(mesh.report().duplicateFaces, 0u);
  EXPECT_EQ(mesh.report().zeroAreaFaces, 0u);
  EXPECT_EQ(mesh.report().isolatedVertices, 0u);
  EXPECT_EQ(mesh.report().nonManifoldEdges, 0u);
  EXPECT_EQ(mesh.numberOfEdges(), 3 * mesh.numberOfFaces() / 2);
  EXPECT_EQ(mesh.inputFace(7), 7u);
}

TEST(TriangleMesh, NeedlesHaveArea)
{
  Random random(5);
  EXPECT_EQ(engineMesh(needleSheet(6, 6, 1e5, 0.3, random)).report().zeroAreaFaces, 0u);
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
  // The one reflex corner of an L is in its middle.
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
