// SPDX-License-Identifier: BSD-3-Clause
// Red-green refinement on small hand-made meshes: completion to four triangles, closures, rollback.
#include "refinement/RefinementSupport.h"

#include "refinement/RedGreenClosure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

using namespace geodesictest;
using geodesic::Id;
using geodesic::NoId;
using geodesic::RedGreenMesh;
using geodesic::TriangleMesh;

namespace
{

/// Splits edges in the middle, with arbitrary distances. The test decides which leaves may stay
/// closed.
class MiddleRules : public geodesic::SplitRules
{
public:
  explicit MiddleRules(std::function<bool(Id)> mayClose)
    : mayClose_(std::move(mayClose))
  {
  }
  RedGreenMesh::Placement place(Id) override { return { 0.5, 0.0 }; }
  bool mayClose(Id triangle) override { return this->mayClose_(triangle); }
  Id edgeToSplitBeforeParts(Id) override { return NoId; }
  Id edgeToSplit(Id triangle) override { return this->edgeToSplit_(triangle); }
  void setEdgeToSplit(std::function<Id(Id)> edgeToSplit)
  {
    this->edgeToSplit_ = std::move(edgeToSplit);
  }

private:
  std::function<bool(Id)> mayClose_;
  std::function<Id(Id)> edgeToSplit_ = [](Id) { return NoId; };
};

/// A mesh under refinement whose edges are split in the middle, without measuring anything.
class ByHand
{
public:
  explicit ByHand(const std::vector<geodesic::Triangle>& triangles, Id vertices = 8)
    : mesh_(somePoints(vertices), triangles)
    , triangles_(
        geodesic::MeshPartition(this->mesh_), std::vector<std::uint8_t>(triangles.size(), 0))
  {
  }
  ByHand(const std::vector<geodesic::Triangle>& triangles, std::vector<std::uint8_t> frozen)
    : mesh_(somePoints(8), triangles)
    , triangles_(geodesic::MeshPartition(this->mesh_), std::move(frozen))
  {
  }

  ByHand(
    const std::vector<geodesic::Vec3>& points, const std::vector<geodesic::Triangle>& triangles)
    : mesh_(points, triangles)
    , triangles_(
        geodesic::MeshPartition(this->mesh_), std::vector<std::uint8_t>(triangles.size(), 0))
  {
  }

  RedGreenMesh& triangles() { return this->triangles_; }
  Id edge(Id triangle, Id k) { return this->triangles_.ensureEdge(triangle, k); }

  /// \returns the leaves that the closure has changed.
  std::vector<Id> split(const std::vector<Id>& edges, const std::function<bool(Id)>& mayClose)
  {
    MiddleRules rules(mayClose);
    rules.setEdgeToSplit([this](Id leaf) { return this->longestIfOnlyOthersAreSplit(leaf); });
    const geodesic::MeshPartition whole(this->mesh_);
    geodesic::RedGreenClosure closure(whole, this->triangles_, rules);
    for (const Id edge : edges)
    {
      closure.split(edge);
    }
    closure.close();
    return closure.takeChanged();
  }
  /// Only bisected leaves may stay.
  std::vector<Id> split(const std::vector<Id>& edges)
  {
    return this->split(
      edges, [this](Id triangle) { return this->triangles_.pointsOnEdges(triangle) == 1; });
  }

  /// The number of output triangles in each face.
  std::vector<Id> count() const
  {
    std::vector<Id> count(this->mesh_.numberOfFaces(), 0);
    Id total = 0;
    this->triangles_.forEachTriangle(
      [&](Id face, const geodesic::Triangle&)
      {
        ++count[face];
        ++total;
      });
    EXPECT_EQ(this->triangles_.numberOfTriangles(), total);
    return count;
  }

  std::vector<geodesic::Triangle> output() const
  {
    std::vector<geodesic::Triangle> result;
    this->triangles_.forEachTriangle(
      [&](Id, const geodesic::Triangle& corners) { result.push_back(corners); });
    return result;
  }

  std::vector<geodesic::Triangle> outputOf(Id wanted) const
  {
    std::vector<geodesic::Triangle> result;
    this->triangles_.forEachTriangle(
      [&](Id face, const geodesic::Triangle& corners)
      {
        if (face == wanted)
        {
          result.push_back(corners);
        }
      });
    return result;
  }

  /// Of its face.
  double fractionOf(Id face, const geodesic::Triangle& corners) const
  {
    std::array<Barycentric, 3> b;
    for (std::size_t k = 0; k < 3; ++k)
    {
      b[k] = barycentric(this->mesh_, this->triangles_.place(corners[k]), face);
    }
    return determinant(b[0], b[1], b[2]);
  }

  /// The triangles around each edge of the output.
  std::map<std::pair<Id, Id>, Id> around() const
  {
    std::map<std::pair<Id, Id>, Id> edges;
    for (const geodesic::Triangle& t : this->output())
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        ++edges[std::minmax(t[k], t[(k + 1) % 3])];
      }
    }
    return edges;
  }

private:
  Id longestIfOnlyOthersAreSplit(Id leaf)
  {
    const Id longest = this->edge(leaf, this->triangles_.longestEdge(leaf));
    const bool isOnlyUnsplit =
      this->triangles_.splitEdges(leaf) == 2 && !this->triangles_.isSplit(longest);
    return isOnlyUnsplit ? longest : NoId;
  }

  static std::vector<geodesic::Vec3> somePoints(Id count)
  {
    Random random(3);
    std::vector<geodesic::Vec3> points(count);
    for (geodesic::Vec3& p : points)
    {
      p = { random.uniform(), random.uniform(), random.uniform() };
    }
    return points;
  }

  TriangleMesh mesh_;
  RedGreenMesh triangles_;
};

using Counts = std::vector<Id>;

// 0 1 2 and 2 1 3 share the edge 1 2.
const std::vector<geodesic::Triangle> TwoFaces = { { 0, 1, 2 }, { 2, 1, 3 } };

}

TEST(RedGreen, TrianglesBesideTheMeshCountWithEverySplitOfTheirEdge)
{
  const geodesic::TriangleMesh mesh(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } }, TwoFaces);
  const Id rim = mesh.edgeOf(mesh.halfedgeBetween(0, 1));
  const geodesic::MeshPartition whole(mesh);
  RedGreenMesh triangles(whole, { 0, 0 }, { { rim, 2 } });
  MiddleRules rules([&](Id leaf) { return triangles.pointsOnEdges(leaf) == 1; });
  geodesic::RedGreenClosure closure(whole, triangles, rules);
  triangles.begin();
  const Id edge = triangles.ensureEdge(0, 0);
  closure.split(edge);
  closure.close();
  EXPECT_EQ(triangles.numberOfTriangles(), 3u + 2u);
  closure.split(triangles.edgeData(edge).halves);
  closure.close(); // splits the face into four, which is beside a bisected one then
  EXPECT_EQ(triangles.numberOfTriangles(), 5u + 2u + 4u);
  triangles.rollBack();
  EXPECT_EQ(triangles.numberOfTriangles(), 2u);
}

TEST(RedGreen, OneSplitEdgeBisectsTheFacesAroundIt)
{
  ByHand alone(TwoFaces);
  alone.split({ alone.edge(0, 0) });
  EXPECT_EQ(alone.count(), (Counts{ 2, 1 }));
  ByHand shared(TwoFaces);
  shared.split({ shared.edge(0, 1) });
  EXPECT_EQ(shared.count(), (Counts{ 2, 2 }));
  EXPECT_EQ(shared.triangles().points().size(), 1u);
}

TEST(RedGreen, TwoSplitEdgesAreCompletedToFourTriangles)
{
  ByHand mesh(TwoFaces);
  mesh.split({ mesh.edge(0, 0), mesh.edge(0, 2) });
  EXPECT_EQ(mesh.count(), (Counts{ 4, 2 })); // the third edge is shared
  EXPECT_EQ(mesh.triangles().points().size(), 3u);
}

TEST(RedGreen, ThreeSplitEdgesAreFourTriangles)
{
  ByHand mesh({ { 0, 1, 2 } });
  mesh.split({ mesh.edge(0, 0), mesh.edge(0, 1), mesh.edge(0, 2) });
  EXPECT_EQ(mesh.count(), (Counts{ 4 }));
  const std::vector<geodesic::Triangle> output = mesh.output();
  const Id first = mesh.triangles().numberOfInputPoints();
  const std::set<std::set<Id>> expected = { { 0, first, first + 2 }, { 1, first, first + 1 },
    { 2, first + 1, first + 2 }, { first, first + 1, first + 2 } };
  std::set<std::set<Id>> found;
  for (const geodesic::Triangle& t : output)
  {
    found.insert({ t[0], t[1], t[2] });
  }
  EXPECT_EQ(found, expected);
}

TEST(RedGreen, CompletionGoesOnToNeighboursThatHaveTwoSplitEdgesByIt)
{
  // a strip: completing the first face splits the second edge of the next one, and so on
  ByHand mesh({ { 0, 1, 2 }, { 2, 1, 3 }, { 2, 3, 4 }, { 4, 3, 5 } });
  mesh.split({ mesh.edge(0, 0), mesh.edge(0, 2), mesh.edge(1, 1) });
  EXPECT_EQ(mesh.count(), (Counts{ 4, 4, 2, 1 }));
}

TEST(RedGreen, ANonManifoldEdgeIsSplitOnceForAllItsFaces)
{
  ByHand mesh({ { 0, 1, 2 }, { 0, 1, 3 }, { 1, 0, 4 }, { 5, 0, 1 } });
  mesh.split({ mesh.edge(0, 0) });
  EXPECT_EQ(mesh.count(), (Counts{ 2, 2, 2, 2 }));
  EXPECT_EQ(mesh.triangles().points().size(), 1u);
  const Id middle = mesh.triangles().numberOfInputPoints();
  const std::pair<Id, Id> half = { 0, middle };
  EXPECT_EQ(mesh.around().at(half), 4u);
}

TEST(RedGreen, AnEdgeSplitTwiceSplitsTheTriangleBesideItIntoFourUnlessItMayStay)
{
  for (const bool mayStay : { false, true })
  {
    ByHand mesh(TwoFaces);
    mesh.split({ mesh.edge(0, 0), mesh.edge(0, 1), mesh.edge(0, 2) });
    EXPECT_EQ(mesh.count(), (Counts{ 4, 2 }));
    // part 1 of the first face has corner 1 and half of the shared edge
    const Id part = 2 + 1;
    mesh.split({ mesh.edge(part, 1) },
      [&](Id leaf) { return mayStay || mesh.triangles().pointsOnEdges(leaf) == 1; });
    EXPECT_EQ(mesh.count(), mayStay ? (Counts{ 5, 3 }) : (Counts{ 5, 5 }));
  }
}

TEST(RedGreen, TheClosureTellsWhichLeavesHaveChanged)
{
  ByHand mesh({ { 0, 1, 2 }, { 2, 1, 3 }, { 2, 3, 4 }, { 4, 3, 5 } });
  EXPECT_EQ(mesh.split({ mesh.edge(0, 0) }), (std::vector<Id>{ 0 }));
  EXPECT_EQ(mesh.split({ mesh.edge(2, 0) }), (std::vector<Id>{ 1, 2 }));
  // completed to four, which bisects the face beside it a second time: that is completed, too
  const std::vector<Id> changed = mesh.split({ mesh.edge(0, 2) });
  EXPECT_EQ(std::count(changed.begin(), changed.end(), 0u), 0) << "no leaf any more";
  EXPECT_EQ(std::count(changed.begin(), changed.end(), 1u), 0);
  for (const Id triangle : changed)
  {
    EXPECT_TRUE(mesh.triangles().isLeaf(triangle));
  }
  EXPECT_EQ(changed.size(), 8u) << "the parts of two faces; nothing of the next was split again";
  EXPECT_EQ(mesh.count(), (Counts{ 4, 4, 2, 1 }));
}

TEST(RedGreen, ABisectedTriangleIsSplitIntoFourAsIfItHadNeverBeen)
{
  ByHand mesh({ { 0, 1, 2 } });
  mesh.split({ mesh.edge(0, 0) });
  EXPECT_EQ(mesh.count(), (Counts{ 2 }));
  const Id middle = mesh.triangles().numberOfInputPoints();
  const std::pair<Id, Id> bisector = { 2, middle };
  EXPECT_EQ(mesh.around().count(bisector), 1u);
  mesh.split({ mesh.edge(0, 1) });
  EXPECT_EQ(mesh.count(), (Counts{ 4 }));
  EXPECT_EQ(mesh.around().count(bisector), 0u);
}

TEST(RedGreen, ThinBisectionsAreReplacedInTwoRounds)
{
  ByHand mesh({ { 0, 1, 2 }, { 2, 1, 3 }, { 2, 3, 4 }, { 4, 3, 5 } });
  mesh.split({ mesh.edge(0, 0) }, [](Id) { return false; });
  EXPECT_EQ(mesh.count(), (Counts{ 4, 4, 2, 1 }));
}

TEST(RedGreen, WhatMayBeClosedIsPutOutInEveryWayAsAPartitionOfTheLeaf)
{
  for (const std::vector<Id>& edges :
    { std::vector<Id>{ 0, 1 }, { 1, 2 }, { 2, 0 }, { 0 }, { 1 }, { 2 }, { 0, 1, 2 } })
  {
    ByHand mesh(TwoFaces);
    std::vector<Id> split;
    for (const Id k : edges)
    {
      split.push_back(mesh.edge(0, k));
    }
    mesh.split(split, [](Id) { return true; });
    const Id splits = static_cast<Id>(edges.size());
    const Id ways = mesh.triangles().waysToClose(0);
    std::set<std::set<std::set<Id>>> different;
    for (Id way = 0; way < ways; ++way)
    {
      mesh.triangles().setWay(0, way);
      const bool sharedToo = std::count(edges.begin(), edges.end(), 1u) > 0;
      EXPECT_EQ(mesh.count(), (Counts{ 1 + splits, sharedToo ? 2u : 1u }));
      // both faces together have a boundary of four input edges, of which splits are halved
      std::size_t boundary = 0;
      for (const auto& [ends, triangles] : mesh.around())
      {
        EXPECT_LE(triangles, 2u);
        boundary += triangles == 1 ? 1 : 0;
      }
      EXPECT_EQ(boundary, 4 + edges.size() - (sharedToo ? 1 : 0));
      std::set<std::set<Id>> output;
      for (const geodesic::Triangle& t : mesh.output())
      {
        output.insert({ t[0], t[1], t[2] });
      }
      different.insert(output);
    }
    EXPECT_EQ(different.size(), ways);
  }
}

TEST(RedGreen, AFrozenFaceIsOnlyClosed)
{
  ByHand mesh(TwoFaces, { 0, 1 });
  mesh.split({ mesh.edge(0, 0), mesh.edge(0, 1), mesh.edge(0, 2) });
  mesh.split({ mesh.edge(2 + 1, 1) });
  EXPECT_EQ(mesh.count(), (Counts{ 5, 3 }));
  for (const auto& [ends, triangles] : mesh.around())
  {
    EXPECT_LE(triangles, 2u) << ends.first << ", " << ends.second;
  }
}

// Its edges are split unevenly.
TEST(RedGreen, AFrozenFaceIsClosedBetweenManyPointsOfItsThreeEdges)
{
  for (const std::array<int, 3>& rounds :
    { std::array<int, 3>{ 3, 3, 3 }, { 4, 2, 1 }, { 1, 4, 0 }, { 0, 1, 4 }, { 5, 5, 0 } })
  {
    ByHand mesh({ { 0, 1, 2 }, { 1, 0, 3 }, { 2, 1, 4 }, { 0, 2, 5 } }, { 1, 0, 0, 0 });
    Id onEdges = 0;
    for (Id k = 0; k < 3; ++k)
    {
      std::vector<Id> along = { mesh.edge(k + 1, 0) }; // the neighbours' edges to the frozen face
      for (int round = 0; round < rounds[k]; ++round)
      {
        for (const Id edge : along)
        {
          ASSERT_EQ(mesh.triangles().edgeData(edge).split, NoId);
        }
        mesh.split(along);
        onEdges += static_cast<Id>(along.size());
        std::vector<Id> halves;
        for (const Id edge : along)
        {
          const Id first = mesh.triangles().edgeData(edge).halves;
          halves.insert(halves.end(), { first, first + 1 });
        }
        along = halves;
      }
    }
    EXPECT_EQ(mesh.count()[0], onEdges + 1) << "each point of the edges is a corner";
    const auto around = mesh.around();
    double covered = 0.0;
    for (const geodesic::Triangle& t : mesh.outputOf(0))
    {
      const double part = mesh.fractionOf(0, t);
      EXPECT_GT(part, 0.0) << "turned over or empty";
      covered += part;
      for (std::size_t k = 0; k < 3; ++k)
      {
        EXPECT_EQ(around.at(std::minmax(t[k], t[(k + 1) % 3])), 2u) << "a point on an edge";
      }
    }
    EXPECT_NEAR(covered, 1.0, 1e-13);
  }
}

namespace
{

/// Checks that the output covers the only face once, with a corner at each point of its edges.
void expectStrip(const ByHand& mesh, Id pointsOnEdges)
{
  EXPECT_EQ(mesh.count(), (Counts{ pointsOnEdges + 1 }));
  double covered = 0.0;
  for (const geodesic::Triangle& t : mesh.output())
  {
    const double part = mesh.fractionOf(0, t);
    EXPECT_GT(part, 0.0) << "turned over or empty";
    covered += part;
  }
  EXPECT_NEAR(covered, 1.0, 1e-13);
  Id boundary = 0;
  for (const auto& [ends, triangles] : mesh.around())
  {
    EXPECT_LE(triangles, 2u);
    boundary += triangles == 1 ? 1 : 0;
  }
  EXPECT_EQ(boundary, pointsOnEdges + 3);
}

}

TEST(RedGreen, AThinLeafIsClosedByAStripBetweenManyPointsOfItsEdgesAndCanBeDivided)
{
  for (std::uint64_t seed = 0; seed < 300; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const std::vector<geodesic::Vec3> corners = { { 0, 0, 0 }, { 1, 0, 0 },
      { random.uniform(-0.2, 1.2), 0.1 * random.uniform(), 0 } };
    ByHand mesh(corners, std::vector<geodesic::Triangle>{ { 0, 1, 2 } });
    RedGreenMesh& triangles = mesh.triangles();
    ASSERT_TRUE(triangles.isThin(0));
    const auto splitSome = [&](Id leaf)
    {
      for (Id splits = random.between(1, 12); splits > 0; --splits)
      {
        std::vector<Id> parts;
        triangles.forEachPartOfEdges(leaf, [&](Id edge) { parts.push_back(edge); });
        mesh.split({ parts[random.below(parts.size())] });
      }
    };
    splitSome(0);
    const Id onEdges = triangles.pointsOnEdges(0);
    expectStrip(mesh, onEdges);
    const std::vector<geodesic::Triangle> before = mesh.output();
    triangles.begin();
    triangles.divide(0);
    EXPECT_EQ(mesh.output(), before) << "each triangle is a part";
    mesh.count();
    const Id part = 1 + random.below(onEdges + 1);
    mesh.split({ mesh.edge(part, 0) }, [](Id) { return true; });
    EXPECT_GT(mesh.output().size(), before.size());
    mesh.count();
    triangles.rollBack();
    EXPECT_EQ(mesh.output(), before);
    expectStrip(mesh, onEdges);
  }
}

TEST(RedGreen, RollingBackUndoesEverythingSinceTheBeginning)
{
  ByHand mesh({ { 0, 1, 2 }, { 2, 1, 3 }, { 2, 3, 4 } });
  mesh.split({ mesh.edge(0, 0), mesh.edge(0, 2) });
  const std::vector<geodesic::Triangle> before = mesh.output();
  const auto splitMore = [&mesh]() { mesh.split({ mesh.edge(1, 1), mesh.edge(3, 1) }); };
  mesh.triangles().begin();
  splitMore();
  const std::vector<geodesic::Triangle> after = mesh.output();
  EXPECT_NE(before, after);
  mesh.triangles().rollBack();
  EXPECT_EQ(mesh.output(), before);
  EXPECT_EQ(mesh.count(), (Counts{ 4, 2, 1 }));
  splitMore();
  EXPECT_EQ(mesh.output(), after);
}
