// SPDX-License-Identifier: BSD-3-Clause
// Edges that are shorter than the rounding of the other edges of their faces, because their ends
// nearly coincide, and edges without length. GEODESIC_TEST_SEEDS takes other seeds.
#include "EngineSupport.h"
#include "Seeds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <future>
#include <iostream>
#include <map>
#include <string>
#include <thread>

using namespace geodesictest;

namespace
{

constexpr std::uint64_t MeshesOfAKind = 12;
constexpr std::size_t NumberOfQueries = 20;

/// A mesh with vertices that nearly coincide, and the mesh where they are one vertex.
struct SplitMesh
{
  PlainMesh mesh;
  PlainMesh whole;
  /// For each vertex, the vertex of `whole` that it was split from.
  std::vector<Index> vertexOfWhole;

  /// The values of `whole` at the vertices.
  std::vector<double> atVertices(const std::vector<double>& ofWhole) const
  {
    std::vector<double> result;
    for (const Index v : this->vertexOfWhole)
    {
      result.push_back(ofWhole[v]);
    }
    return result;
  }
};

/// A face at a vertex, which is its corner k, and its two other vertices in the order of the faces
/// around the vertex.
struct FanFace
{
  Index face;
  Index k;
  Index before;
  Index behind;
};

/// The faces of a vertex in the order around it; empty where they are not one fan.
std::vector<FanFace> fanAround(const PlainMesh& mesh, Index vertex)
{
  std::vector<FanFace> fan;
  std::map<Index, int> facesAtEdgeTo;
  for (Index f = 0; f < mesh.triangles.size(); ++f)
  {
    for (Index k = 0; k < 3; ++k)
    {
      const Triangle& t = mesh.triangles[f];
      if (t[k] == vertex)
      {
        fan.push_back({ f, k, t[(k + 1) % 3], t[(k + 2) % 3] });
        ++facesAtEdgeTo[t[(k + 1) % 3]];
        ++facesAtEdgeTo[t[(k + 2) % 3]];
      }
    }
  }
  // An open fan begins at an edge with one face.
  Index last = fan.empty() ? 0 : fan.front().before;
  for (const auto& [neighbour, faces] : facesAtEdgeTo)
  {
    if (faces > 2)
    {
      return {};
    }
    last = faces == 1 ? neighbour : last;
  }
  for (auto place = fan.begin(); place != fan.end(); ++place)
  {
    const auto next = std::find_if(
      place, fan.end(), [last](const FanFace& f) { return f.before == last || f.behind == last; });
    if (next == fan.end())
    {
      return {};
    }
    std::swap(*place, *next);
    if (place->before != last)
    {
      std::swap(place->before, place->behind);
    }
    last = place->behind;
  }
  return fan;
}

/// Splits a vertex in two: some consecutive faces go to the new vertex, and one or two new faces
/// close the gap. \returns false if the vertex has too few faces.
bool splitVertex(SplitMesh& split, Index vertex, const Vec3& place, Random& random)
{
  PlainMesh& mesh = split.mesh;
  const std::vector<FanFace> fan = fanAround(mesh, vertex);
  if (fan.size() < 2)
  {
    return false;
  }
  const bool isClosed = fan.back().behind == fan.front().before;
  const Index first = isClosed ? random.below(fan.size() - 1) : 0;
  const Index last = random.between(first, static_cast<Index>(fan.size()) - 2);
  const Index added = static_cast<Index>(mesh.points.size());
  mesh.points.push_back(place);
  split.vertexOfWhole.push_back(split.vertexOfWhole[vertex]);
  for (Index i = first; i <= last; ++i)
  {
    mesh.triangles[fan[i].face][fan[i].k] = added;
  }
  if (isClosed)
  {
    mesh.triangles.push_back({ vertex, fan[first].before, added });
  }
  mesh.triangles.push_back({ vertex, added, fan[last].behind });
  return true;
}

/// The vertex moves to the origin, where doubles are dense enough for gaps between `smallest` and
/// `largest`.
SplitMesh withTinyEdges(const PlainMesh& mesh, double smallest, double largest, Random& random)
{
  SplitMesh split{ mesh, {}, {} };
  for (Index v = 0; v < mesh.points.size(); ++v)
  {
    split.vertexOfWhole.push_back(v);
  }
  Index vertex = random.below(mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size() && fanAround(mesh, vertex).size() < 2; ++i)
  {
    vertex = static_cast<Index>((vertex + 1) % mesh.points.size());
  }
  const Vec3 origin = mesh.points[vertex];
  for (Vec3& p : split.mesh.points)
  {
    p = { p[0] - origin[0], p[1] - origin[1], p[2] - origin[2] };
  }
  split.whole = split.mesh;
  const Index splits = random.between(1, 3);
  for (Index i = 0; i < splits; ++i)
  {
    const double gap = std::pow(10.0, random.uniform(std::log10(smallest), std::log10(largest)));
    const bool isAxis = random.chance(0.3);
    const Vec3 place = { gap * random.uniform(-1.0, 1.0),
      isAxis ? 0.0 : gap * random.uniform(-1.0, 1.0),
      isAxis ? 0.0 : gap * random.uniform(-1.0, 1.0) };
    EXPECT_TRUE(splitVertex(split, vertex, place, random) || i > 0);
    vertex = random.chance(0.5) ? vertex : static_cast<Index>(split.mesh.points.size() - 1);
  }
  return split;
}

class TinyEdges : public ::testing::TestWithParam<MeshKind>
{
};

}

TEST(TinyEdgesFound, ARayDoesNotPassAnEdgeFromItsFarSide)
{
  for (const double gap : { 0.0, 1e-25, 1e-20, 1e-17, 1e-16, 1e-15, 1e-13, 1e-10 })
  {
    PlainMesh mesh;
    mesh.points = { { 0, 0, 0 }, { -gap, 0, 0 }, { 1.75, .75, .25 }, { -.75, 1.75, 0 },
      { -1.75, -.75, -1 }, { .75, -1.75, .25 }, { 1, 2.5, .75 }, { -2.5, 1, .75 },
      { -1, -2.5, -.25 }, { 2.5, -1, .25 } };
    mesh.triangles = { { 0, 2, 3 }, { 1, 3, 4 }, { 1, 4, 5 }, { 1, 5, 2 }, { 0, 3, 1 }, { 0, 1, 2 },
      { 3, 2, 6 }, { 4, 3, 7 }, { 5, 4, 8 }, { 2, 5, 9 } };
    Sources source;
    source.points = { { 8, { 0.0, 0.5, 0.5 } } };
    const BruteForceResult truth = bruteForceDistances(mesh, source);
    const EngineResult result = engineDistances(mesh, source);
    EXPECT_LE(
      worstError(result.vertices, truth.vertices, largestFinite(truth.vertices)), OrdinaryAccuracy)
      << "gap " << gap;
  }
}

namespace
{

void compareWithWhole(const MeshKind& kind, Seeds seeds)
{
  double worst = 0.0;
  for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed + 47000);
    const SplitMesh split =
      withTinyEdges(kind.make(random.between(20, 80), random), 1e-25, 1e-13, random);
    CurveMaker maker(split.whole, random);
    const Sources sources = toSources(maker.anySource());
    const std::vector<MeshPoint> queries = randomPoints(split.whole, NumberOfQueries, random);
    const BruteForceResult truth = bruteForceDistances(split.whole, sources, queries);
    const double largest = largestFinite(truth.vertices);

    const geodesic::TriangleMesh engine = engineMesh(split.mesh);
    const std::vector<geodesic::SourceCurve> curves = engineCurves(engine, sources);
    const EngineResult result = engineDistances(split.mesh, curves, engine, queries);
    const double error =
      std::max(worstError(result.vertices, split.atVertices(truth.vertices), largest),
        worstError(result.queries, truth.queries, largest));
    EXPECT_LE(error, accuracyOn(kind));
    worst = std::max(worst, error);
    expectCertified(solveKeepingAll(engine, curves, 0.01), queries,
      { split.atVertices(truth.vertices), truth.queries }, accuracyOn(kind));
  }
  std::cout << "worst relative error on " << kind.name << ": " << worst << "\n";
}

} // anonymous namespace

TEST_P(TinyEdges, DistancesAreThoseWithoutThem)
{
  compareWithWhole(GetParam(), seedsOfTest(MeshesOfAKind));
}

// The wedge at the end of a segment was measured around only one of two coincident vertices. It
// missed the faces around the other and was too narrow.
TEST(TinyEdgesFound, AWedgeIsMeasuredAroundAllVerticesAtItsPlace)
{
  for (const auto& [name, seed] :
    { std::pair("PlanarWithHoles", 40984U), std::pair("MoebiusStrip", 41593U) })
  {
    for (const MeshKind& kind : meshKinds())
    {
      if (kind.name == std::string(name))
      {
        compareWithWhole(kind, { seed, 1 });
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, TinyEdges, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });

namespace
{

/// Runs a function and ends the program where it takes longer than a minute.
template <typename Run>
auto withinAMinute(Run run)
{
  std::packaged_task<decltype(run())()> task(std::move(run));
  auto result = task.get_future();
  std::thread thread(std::move(task));
  if (result.wait_for(std::chrono::minutes(1)) != std::future_status::ready)
  {
    std::cout << "[  FAILED  ] no end within a minute" << std::endl;
    std::_Exit(EXIT_FAILURE); // nothing else stops the thread
  }
  thread.join();
  return result.get();
}

}

// Every second column lies where the last one does, so that edges across have no length, and from
// many vertices nothing is within the batch width but what is equally far. The surface is a flat
// strip still.
TEST(EdgesWithoutLength, LeaveDistancesAsTheyAreAndTheFrontEnds)
{
  for (Random& random : EachSeed(20))
  {
    PlainMesh mesh = renumbered(regularGrid(40, 40), random).mesh;
    for (Vec3& p : mesh.points)
    {
      p[0] = 2.0 * std::floor(0.5 * p[0]);
    }
    Sources sources;
    sources.points = { vertexPoint(mesh, 0) };
    const EngineResult result = withinAMinute([&]() { return engineDistances(mesh, sources); });
    for (Index v = 0; v < mesh.points.size(); ++v)
    {
      EXPECT_NEAR(result.vertices[v], spaceDistance(mesh.points[v], mesh.points[0]), 1e-12)
        << "vertex " << v;
    }
  }
}
