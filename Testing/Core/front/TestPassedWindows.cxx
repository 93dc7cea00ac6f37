// SPDX-License-Identifier: BSD-3-Clause
// What the front remembers of windows that have passed, and what rough surfaces gain from it.
#include "front/PassedWindows.h"

#include "EngineSupport.h"
#include "OnThreads.h"
#include "truth/CappedMeshes.h"
#include "truth/RandomMeshKinds.h"
#include "truth/TestMeshes.h"
#include "window/WindowSupport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

using namespace geodesictest;
using geodesic::DistanceField;
using geodesic::Id;
using geodesic::Job;
using geodesic::KeepWindows;
using geodesic::PassedWindows;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;
using geodesic::WindowListBuilder;
using geodesic::WindowPool;

namespace
{

constexpr double Length = 1.0;

// The edges of a face of a spike are 2,000 times longer than it is wide: as on needles, their
// rounding counts. The worst of 2,000 fields was off by 1.3e-11.
constexpr double SpikesAccuracy = 1e-10;

double lowest(const geodesic::WindowRange& windows, double x)
{
  double result = geodesic::Infinity;
  for (const Window& w : windows)
  {
    result = x >= w.begin && x <= w.end ? std::min(result, w.distance(x)) : result;
  }
  return result;
}

geodesic::FrontOptions onSomeThreads()
{
  geodesic::FrontOptions options;
  options.job = Job({}, onThreads);
  return options;
}

// Distances from random curves: exact, and within 1 %, on one thread and on some.
void expectTrueDistances(const PlainMesh& mesh, Random& random)
{
  CurveMaker maker(mesh, random);
  const std::vector<Polyline> lines = maker.anySource();
  const std::vector<MeshPoint> queries = randomPoints(mesh, 30, random);
  const BruteForceResult truth = bruteForceDistances(mesh, toSources(lines), queries);
  const double largest = largestFinite(truth.vertices);
  const TriangleMesh engine = engineMesh(mesh);
  const std::vector<geodesic::SourceCurve> curves = engineCurves(engine, lines);
  for (geodesic::FrontOptions options : { geodesic::FrontOptions(), onSomeThreads() })
  {
    const EngineResult exact =
      valuesOf(geodesic::solve(engine, curves, options, KeepWindows::All), queries);
    EXPECT_LE(worstError(exact.vertices, truth.vertices, largest), SpikesAccuracy);
    EXPECT_LE(worstError(exact.queries, truth.queries, largest), SpikesAccuracy);
    options.relativeError = 0.01;
    expectCertified(geodesic::solve(engine, curves, options, KeepWindows::All), queries,
      { truth.vertices, truth.queries }, SpikesAccuracy);
  }
}

struct Kind
{
  const char* name;
  PlainMesh (*make)(Random& random);
};

const Kind Kinds[] = {
  { "Spikes",
    [](Random& random)
    {
      return bumpySheet(
        random.between(4, 14), random.between(4, 14), 0, random.uniform(3.0, 2000.0), random);
    } },
  { "Strips",
    [](Random& random)
    {
      const Index sides = random.between(10, 60);
      return openCylinder(sides, random.between(1, 3), random.uniform(10.0, 1000.0) * sides);
    } },
  { "Tori",
    [](Random& random)
    {
      return torus(
        random.between(4, 8), random.between(20, 60), std::pow(10.0, random.uniform(0.5, 2.0)));
    } },
  { "Cones",
    [](Random& random)
    {
      const Index sides = random.between(10, 60);
      return roundCone(sides, random.between(1, 3), random.uniform(1.0, 100.0) * sides);
    } },
};

std::ostream& operator<<(std::ostream& os, const Kind& kind)
{
  return os << kind.name;
}

class RoughOrThin : public testing::TestWithParam<Kind>
{
};

}

TEST_P(RoughOrThin, DistancesAreThoseOfTheBruteForceSolver)
{
  for (Random& random : EachSeed(meshesOfAKind(20), 91000))
  {
    const PlainMesh mesh = GetParam().make(random);
    expectTrueDistances(mesh, random);
  }
}

INSTANTIATE_TEST_SUITE_P(
  Kinds, RoughOrThin, testing::ValuesIn(Kinds), [](const auto& kind) { return kind.param.name; });

TEST(PassedWindows, TellsNothingTooShortAndNoMoreThanAFewWindows)
{
  Random random(7);
  WindowPool pool;
  WindowListBuilder builder;
  const auto always = [](Id) { return true; };
  for (int round = 0; round < 200; ++round)
  {
    PassedWindows passed;
    std::vector<Window> all;
    for (int i = 0; i < 20; ++i)
    {
      const Window window = randomWindow(Length, random);
      all.push_back(window);
      passed.add(5, Length, { &window, &window + 1 }, builder, pool, always);
      ASSERT_LE(passed.at(5).size(), 8U);
      for (const double x : { 0.11, 0.37, 0.5, 0.83 })
      {
        const double truth = lowest({ all.data(), all.data() + all.size() }, x);
        ASSERT_GE(lowest(passed.at(5), x), truth * (1.0 - 1e-12));
      }
    }
    EXPECT_GT(passed.at(5).size(), 0U);
    EXPECT_EQ(passed.at(4).size(), 0U);
  }
}

TEST(PassedWindows, LetsGoOfWhatIsNotNeeded)
{
  Random random(8);
  WindowPool pool;
  WindowListBuilder builder;
  PassedWindows passed;
  const Window window = randomWindow(Length, random);
  Id front = 0;
  const auto isNeeded = [&front](Id halfedge) { return halfedge >= front; };
  constexpr Id halfedges = 2000;
  for (Id halfedge = 0; halfedge < halfedges; ++halfedge)
  {
    front = halfedge < 10 ? 0 : halfedge - 10;
    passed.add(halfedge, Length, { &window, &window + 1 }, builder, pool, isNeeded);
  }
  Id kept = 0;
  for (Id halfedge = 0; halfedge < halfedges; ++halfedge)
  {
    kept += passed.at(halfedge).size() > 0 ? 1 : 0;
    EXPECT_TRUE(!isNeeded(halfedge) || passed.at(halfedge).size() > 0);
  }
  EXPECT_LE(kept, 100U);
}

// On slopes of 1000 : 1 windows run ahead along long edges, and nearly all are beaten later.
TEST(PassedWindows, OfSpikesFewWindowsGoOn)
{
  Random random(9);
  const TriangleMesh mesh = engineMesh(bumpySheet(40, 40, 0, 1500.0, random));
  const DistanceField field =
    geodesic::solve(mesh, { geodesic::pointCurve(SurfacePoint::atVertex(0)) });
  EXPECT_LE(field.windowsPropagated(), 25U * mesh.numberOfHalfedges());
}

// Windows of neighbouring strips pass together, so that the approximate solver can merge them.
TEST(ThinFaces, OfStripsFewWindowsGoOn)
{
  const TriangleMesh mesh = engineMesh(openCylinder(400, 1, 3000.0));
  geodesic::FrontOptions options;
  options.relativeError = 1e-3;
  const DistanceField field =
    geodesic::solve(mesh, { geodesic::pointCurve(SurfacePoint::atVertex(0)) }, options);
  EXPECT_LE(field.windowsPropagated(), 12U * numberOfEdges(mesh));
}

namespace
{

/// Counts the lists that pass through thin faces, and those whose nearest window is behind the
/// front then.
class LateLists : public geodesic::Retention
{
public:
  explicit LateLists(const TriangleMesh& mesh)
    : mesh_(mesh)
  {
  }

  bool needsInside() const override { return true; }
  void pass(std::size_t, const geodesic::PassedList& list, Id, WindowPool& pool) override
  {
    if (this->mesh_.shape(TriangleMesh::faceOf(list.halfedge)).isThin())
    {
      double nearest = geodesic::Infinity;
      for (const Window& w : list.windows.range())
      {
        nearest = std::min(nearest, w.minimum());
      }
      this->nearest_.push_back(nearest);
    }
    pool.free(list.windows);
  }
  void advance(const geodesic::FrontState& front) override
  {
    this->all += this->nearest_.size();
    for (const double nearest : this->nearest_)
    {
      this->late += nearest < front.key * (1.0 - 1e-12) ? 1 : 0;
    }
    this->nearest_.clear();
  }

  std::size_t all = 0;
  std::size_t late = 0;

private:
  const TriangleMesh& mesh_;
  std::vector<double> nearest_; // of the lists of this batch
};

}

// As in MMP, whatever other windows of the list or of its vertex are due when.
TEST(ThinFaces, ListsPassWhenTheFrontIsAsFarAsTheirNearestWindow)
{
  for (Random& random : EachSeed(10))
  {
    for (const PlainMesh& plain :
      { openCylinder(random.between(50, 200), random.between(1, 4), 3000.0),
        torus(random.between(4, 8), random.between(20, 60), 30.0),
        roundCone(random.between(20, 60), random.between(1, 3), 2000.0) })
    {
      const TriangleMesh mesh = engineMesh(plain);
      const Id source = static_cast<Id>(random.below(mesh.numberOfVertices()));
      LateLists lists(mesh);
      propagate(mesh, { geodesic::pointCurve(SurfacePoint::atVertex(source)) }, {}, lists);
      EXPECT_GT(lists.all, 0U);
      EXPECT_EQ(lists.late, 0U) << "of " << lists.all;
    }
  }
}

// Thin faces that meet in sharp vertices, also three and more at an edge: flat ones that hang
// loose, bent by noise. Rays go around such a vertex thousands of times before they leave; on the
// third surface they made more windows than a minute is enough for.
TEST(PassedWindows, OfSliversAroundSharpVerticesFewWindowsGoOn)
{
  for (const std::uint64_t seed : { 4, 35, 77 })
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    PlainMesh mesh =
      meshKinds()[random.below(meshKinds().size())].make(random.between(4, 80), random);
    mesh = withCaps(mesh, Caps::AnyAndLoose, random.uniform(0.02, 0.5), random).mesh;
    const double noise = std::pow(10.0, random.uniform(-11.0, -3.0));
    addNoise(mesh, noise, random);
    const TriangleMesh engine = cleanedEngineMesh(mesh);
    const auto curves = engineCurves(engine, Sources{ { vertexPoint(mesh, 0) }, {} });
    const DistanceField field = geodesic::solve(engine, curves, {});
    EXPECT_LE(field.windowsPropagated(), 1000U * engine.numberOfFaces());
  }
}
