// SPDX-License-Identifier: BSD-3-Clause
// The boundary on faces that are not barriers: each edge once, and each vertex without such an
// edge.
#include "EngineSupport.h"

#include "truth/RandomMeshKinds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace
{

using namespace geodesic;
using geodesictest::boundaryCurves;
using geodesictest::engineMesh;
using geodesictest::Index;
using geodesictest::PlainMesh;
using geodesictest::Random;

std::vector<SourceCurve> numberedBoundary(const PlainMesh& mesh)
{
  std::vector<SourceCurve> boundary = boundaryCurves(engineMesh(mesh));
  for (std::size_t i = 0; i < boundary.size(); ++i)
  {
    boundary[i].source = static_cast<Id>(i + 10);
  }
  return boundary;
}

PlainMesh without(const PlainMesh& mesh, const std::vector<bool>& isBarrier)
{
  PlainMesh open{ mesh.points, {} };
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
  {
    if (!isBarrier[f])
    {
      open.triangles.push_back(mesh.triangles[f]);
    }
  }
  return open;
}

using Edges = std::multiset<std::pair<Index, Index>>;

/// For edges and for single vertices, the number of their curve.
void expectParts(const PlainMesh& whole, const PlainMesh& open)
{
  const std::vector<SourceCurve> boundary = numberedBoundary(whole);
  const TriangleMesh mesh = engineMesh(open);
  const std::vector<SourceCurve> parts = boundaryOutsideBarriers(boundary, mesh);
  std::map<std::pair<Index, Index>, Id> sourceOf;
  for (const SourceCurve& curve : boundary)
  {
    for (std::size_t i = 1; i < curve.points.size(); ++i)
    {
      sourceOf[std::minmax(curve.points[i - 1].id, curve.points[i].id)] = curve.source;
    }
  }
  std::set<std::pair<Index, Index>> openEdges;
  std::set<Index> openVertices;
  for (const geodesictest::Triangle& t : open.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      openEdges.insert(std::minmax(t[k], t[(k + 1) % 3]));
      openVertices.insert(t[k]);
    }
  }
  Edges expected;
  std::set<Index> expectedVertices;
  for (const auto& [a, b] : geodesictest::boundaryEdges(whole))
  {
    const std::pair<Index, Index> edge = std::minmax(a, b);
    if (openEdges.count(edge) > 0)
    {
      expected.insert(edge);
    }
    for (const Index vertex : { a, b })
    {
      if (openVertices.count(vertex) > 0)
      {
        expectedVertices.insert(vertex);
      }
    }
  }
  Edges found;
  std::set<Index> foundVertices;
  for (const SourceCurve& part : parts)
  {
    ASSERT_EQ(part.faces.size() + 1, part.points.size());
    ASSERT_EQ(part.isCut, std::vector<std::uint8_t>(part.points.size(), 0));
    for (std::size_t i = 0; i < part.points.size(); ++i)
    {
      foundVertices.insert(part.points[i].id);
      if (i > 0)
      {
        const std::pair<Index, Index> edge = std::minmax(part.points[i - 1].id, part.points[i].id);
        found.insert(edge);
        EXPECT_EQ(part.source, sourceOf.at(edge));
        EXPECT_TRUE(contains(mesh, part.faces[i - 1], part.points[i - 1]));
        EXPECT_TRUE(contains(mesh, part.faces[i - 1], part.points[i]));
      }
    }
  }
  EXPECT_EQ(found, expected);
  EXPECT_EQ(foundVertices, expectedVertices);
}

/// The mesh with renumbered vertices: those of faces that are not barriers come first.
PlainMesh renumbered(const PlainMesh& mesh, const PlainMesh& open)
{
  const auto none = static_cast<Index>(mesh.points.size());
  std::vector<Index> numbers(mesh.points.size(), none);
  Index next = 0;
  for (const std::vector<geodesictest::Triangle>* triangles : { &open.triangles, &mesh.triangles })
  {
    for (const geodesictest::Triangle& t : *triangles)
    {
      for (const Index vertex : t)
      {
        numbers[vertex] = numbers[vertex] == none ? next++ : numbers[vertex];
      }
    }
  }
  PlainMesh result{ std::vector<geodesictest::Vec3>(next), mesh.triangles };
  for (geodesictest::Triangle& t : result.triangles)
  {
    for (Index& vertex : t)
    {
      result.points[numbers[vertex]] = mesh.points[vertex];
      vertex = numbers[vertex];
    }
  }
  return result;
}

// The mesh of the open faces may lack vertices that only barriers have.
TEST(BoundaryOutsideBarriers, OnRandomMeshesItIsThePartOfTheBoundaryOnOpenFaces)
{
  Random random(8);
  for (const geodesictest::MeshKind& kind : geodesictest::meshKinds())
  {
    for (int i = 0; i < 25; ++i)
    {
      PlainMesh whole = kind.make(random.between(20, 150), random);
      const double share = random.uniform(0.0, 0.9);
      std::vector<bool> isBarrier(whole.triangles.size());
      for (std::size_t f = 1; f < isBarrier.size(); ++f)
      {
        isBarrier[f] = random.chance(share);
      }
      const bool areVerticesMissing = random.chance(0.4);
      whole = areVerticesMissing ? renumbered(whole, without(whole, isBarrier)) : whole;
      PlainMesh open = without(whole, isBarrier);
      if (areVerticesMissing)
      {
        Index used = 0;
        for (const geodesictest::Triangle& t : open.triangles)
        {
          used = std::max(used, 1 + *std::max_element(t.begin(), t.end()));
        }
        open.points.resize(used);
      }
      SCOPED_TRACE(kind.name);
      expectParts(whole, open);
    }
  }
}

// A barrier inside leaves no gap.
TEST(BoundaryOutsideBarriers, ALoopWithOneGapIsOneCurve)
{
  const PlainMesh whole = geodesictest::regularGrid(3, 3);
  for (std::size_t gap = 0; gap < whole.triangles.size(); ++gap)
  {
    std::vector<bool> isBarrier(whole.triangles.size(), false);
    isBarrier[gap] = true;
    const std::vector<SourceCurve> boundary = numberedBoundary(whole);
    const std::vector<SourceCurve> parts =
      boundaryOutsideBarriers(boundary, engineMesh(without(whole, isBarrier)));
    ASSERT_EQ(parts.size(), 1u) << "barrier " << gap;
    const std::size_t left = boundary[0].faces.size() - parts[0].faces.size();
    EXPECT_LE(left, 2u);
    EXPECT_EQ(parts[0].isClosed(), left == 0);
    EXPECT_EQ(parts[0].points.size(), 13 - left);
    EXPECT_EQ(parts[0].source, 10u);
  }
}

TEST(BoundaryOutsideBarriers, NothingIsLeftIfBarriersHaveTheWholeBoundary)
{
  const PlainMesh whole = geodesictest::regularGrid(4, 4);
  const PlainMesh open{ whole.points, { { 6, 7, 12 } } };
  EXPECT_TRUE(boundaryOutsideBarriers(numberedBoundary(whole), engineMesh(open)).empty());
}

} // anonymous namespace
