// SPDX-License-Identifier: BSD-3-Clause
// The batches in which the front processes vertices, as its retention sees them.
#include "EngineSupport.h"

#include "front/Retention.h"
#include "front/VertexStates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace geodesictest;
using geodesic::Id;
using geodesic::TriangleMesh;

namespace
{

/// Checks the batches of a front on a mesh without thin faces.
class Batches : public geodesic::KeepNone
{
public:
  explicit Batches(const TriangleMesh& mesh)
  {
    for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
    {
      this->halfAnEdge_ = std::max(this->halfAnEdge_, 0.5 * mesh.length(halfedge));
    }
  }

  void advance(const geodesic::FrontState& front) override
  {
    const double rounding = 1e-6 * this->halfAnEdge_; // widths are in single precision
    EXPECT_GE(front.key, this->key_);
    for (const Id vertex : front.settled)
    {
      const double distance = front.distances(vertex);
      EXPECT_LE(distance, front.key + this->halfAnEdge_ + rounding) << "vertex " << vertex;
      this->settled.insert(vertex);
    }
    EXPECT_EQ(std::set<Id>(front.settled.begin(), front.settled.end()).size(), front.settled.size())
      << "a vertex is in a batch once";
    this->all += front.settled.size();
    this->key_ = front.key;
    KeepNone::advance(front);
  }

  std::set<Id> settled;
  /// Their number, with those that were in several batches.
  std::size_t all = 0;

private:
  double halfAnEdge_ = 0.0;
  double key_ = 0.0;
};

}

TEST(Batches, FollowTheFrontAndAreAsWideAsHalfAnEdgeAtMost)
{
  for (Random& random : EachSeed(20))
  {
    const PlainMesh plain = renumbered(randomPlanar(30, 30, random), random).mesh;
    const TriangleMesh mesh = engineMesh(plain);
    const Sources source{ { randomPoint(plain, random) }, {} };
    geodesic::FrontOptions options;
    options.relativeError = random.chance(0.5) ? 0.01 : 0.0;
    Batches batches(mesh);
    propagate(mesh, engineCurves(mesh, source), options, batches);
    EXPECT_EQ(batches.settled.size(), plain.points.size());
    EXPECT_LE(batches.all, 3 * plain.points.size()) << "each is in few batches";
  }
}

TEST(Batches, DoNotDependOnTheOrderOfFaces)
{
  forMeshesInAnotherOrder(
    [](const TriangleMesh& one, const TriangleMesh& two, const Renumbered& other)
    {
      const geodesic::VertexStates states(one, false, false, {});
      const geodesic::VertexStates otherStates(two, false, false, {});
      for (Id vertex = 0; vertex < states.size(); ++vertex)
      {
        EXPECT_EQ(states[vertex].batchWidth, otherStates[other.vertexMap[vertex]].batchWidth);
      }
    });
}
