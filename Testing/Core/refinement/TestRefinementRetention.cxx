// SPDX-License-Identifier: BSD-3-Clause
// Dropping windows where the distance is linear, and refinement without them.
#include "EngineSupport.h"
#include "refinement/RefinementSupport.h"
#include "truth/RandomCurves.h"
#include "truth/RandomMeshKinds.h"

#include "Errors.h"
#include "refinement/AdaptiveRefinement.h"
#include "refinement/SolveForRefinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <numeric>
#include <set>

using namespace geodesictest;
using geodesic::DistanceField;
using geodesic::Id;
using geodesic::Job;
using geodesic::RefinedMesh;
using geodesic::TriangleMesh;
using geodesic::Window;

namespace
{

DistanceField solveFor(const TriangleMesh& mesh, const std::vector<geodesic::SourceCurve>& curves,
  double tolerance, double limit = geodesic::Infinity)
{
  geodesic::FrontOptions options;
  options.maximumDistance = limit;
  return solveForRefinement(mesh, curves, tolerance, options);
}

std::size_t droppedFaces(const DistanceField& field)
{
  std::size_t count = 0;
  for (Id face = 0; face < field.mesh().numberOfFaces(); ++face)
  {
    count += field.knowsInside(face) ? 0 : 1;
  }
  return count;
}

/// Refines to a fraction of the largest distance and compares with brute force. \returns the number
/// of faces without windows.
std::size_t compare(const PlainMesh& mesh, const std::vector<Polyline>& curves, double fraction,
  std::size_t count, Random& random)
{
  const TriangleMesh engine = engineMesh(mesh);
  const auto sources = engineCurves(engine, curves);
  const DistanceField all = solveKeepingAll(engine, sources);
  const double largest = largestFinite(all.vertexDistances());
  const double tolerance = fraction * largest;
  const DistanceField field = solveFor(engine, sources, tolerance);
  EXPECT_EQ(field.vertexDistances(), all.vertexDistances());
  const RefinedMesh refined = refineTo(field, tolerance);
  EXPECT_FALSE(refined.stoppedAtMaximum);
  EXPECT_LE(refined.errorBound, tolerance);
  EXPECT_GE(refined.errorBound, field.droppedErrorBound());
  expectSameSurface(all, refined);
  expectRefinedPointsRight(engine, refined, mesh, toSources(curves), 1e-11 * largest);
  const Samples samples = sample(field, refined, count, random);
  const BruteForceResult truth = bruteForceDistances(mesh, toSources(curves), samples.places);
  EXPECT_LE(
    largestDifference(samples, truth.queries), refined.errorBound + EngineAccuracy * largest)
    << describe(curves);
  return droppedFaces(field);
}

class KeptWindows : public ::testing::TestWithParam<MeshKind>
{
};

/// A plane wave over a grid, starting 10 before it, and the windows kept of it for a refinement.
struct GridUnderAWave
{
  static constexpr double Tolerance = 0.01;
  TriangleMesh mesh_ = engineMesh(regularGrid(4, 4));
  std::vector<double> distances_ = planeWave();
  geodesic::WindowPool pool_;
  std::vector<geodesic::WindowPool*> pools_{ &this->pool_ };
  std::unique_ptr<geodesic::RefinementRetention> retention_ = retentionWith({});

  std::unique_ptr<geodesic::RefinementRetention> retentionWith(const std::vector<Id>& pinned) const
  {
    std::vector<std::uint8_t> flags(this->mesh_.numberOfFaces(), 0);
    for (const Id face : pinned)
    {
      flags[face] = 1;
    }
    auto retention = std::make_unique<geodesic::RefinementRetention>(
      geodesic::MeshPartition(this->mesh_), Tolerance, flags);
    retention->start(1, {});
    return retention;
  }

  std::vector<double> planeWave() const
  {
    std::vector<double> result;
    for (Id v = 0; v < this->mesh_.numberOfVertices(); ++v)
    {
      result.push_back(10.0 + this->mesh_.point(v)[0]);
    }
    return result;
  }

  /// A plane wave through the halfedge, closer by this much than the wave of the corners.
  void pass(Id halfedge, double nearer)
  {
    const double length = this->mesh_.length(halfedge);
    const double atOrigin = this->distances_[this->mesh_.origin(halfedge)];
    const double atEnd = this->distances_[this->mesh_.destination(halfedge)];
    const double slope = (atEnd - atOrigin) / length;
    const Window wave{ 0.0, length, slope, std::sqrt(std::max(0.0, 1.0 - slope * slope)),
      atOrigin - nearer, 0.0, Window::Kind::Linear, 1 };
    this->retention_->pass(0,
      { halfedge, this->pool_.copyOf({ &wave, &wave + 1 }), { atOrigin, atEnd } }, 0, this->pool_);
  }

  /// Through every halfedge, except those of the first face.
  void passAll(double nearer, double nearerInFirstFace)
  {
    for (Id halfedge = 0; halfedge < this->mesh_.numberOfHalfedges(); ++halfedge)
    {
      this->pass(halfedge, halfedge < 3 ? nearerInFirstFace : nearer);
    }
  }
  void advance(const std::vector<Id>& settled)
  {
    const geodesic::VertexNumbers distances{ this->distances_.data() };
    this->retention_->advance({ 100.0, settled, distances, distances, this->pools_ });
  }

  void bringFrontPast()
  {
    std::vector<Id> all(this->mesh_.numberOfVertices());
    std::iota(all.begin(), all.end(), Id(0));
    this->advance(all);
  }

  geodesic::KeptWindows finish()
  {
    const geodesic::VertexNumbers distances{ this->distances_.data() };
    this->retention_->finish({ 100.0, {}, distances, distances, this->pools_ });
    return this->retention_->release();
  }

  Id neighboursOfFirstFace() const
  {
    Id count = 0;
    for (Id halfedge = 0; halfedge < 3; ++halfedge)
    {
      count += this->mesh_.isBoundary(halfedge) ? 0 : 1;
    }
    return count;
  }
};

}

TEST_P(KeptWindows, AreEnoughForRefinementOnRandomMeshes)
{
  std::size_t dropped = 0;
  for (Random& random : EachSeed(6, 9100))
  {
    const PlainMesh mesh = GetParam().make(random.between(50, 200), random);
    CurveMaker maker(mesh, random);
    const double fraction = std::pow(10.0, random.uniform(-2.0, -0.5));
    dropped += compare(mesh, maker.anySource(), fraction, 2000, random);
  }
  std::cout << GetParam().name << ": " << dropped << " faces without windows\n";
}

INSTANTIATE_TEST_SUITE_P(Kinds, KeptWindows, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });

// Within the limit the output is as good as without one; faces wholly beyond it stay as they are.
TEST_P(KeptWindows, AreEnoughForRefinementUpToALimit)
{
  std::size_t leftAlone = 0;
  std::size_t dropped = 0;
  for (Random& random : EachSeed(6, 9200))
  {
    const PlainMesh mesh = GetParam().make(random.between(100, 300), random);
    CurveMaker maker(mesh, random);
    const std::vector<Polyline> curves = { maker.any() };
    SCOPED_TRACE(describe(curves));
    const TriangleMesh engine = engineMesh(mesh);
    const auto sources = engineCurves(engine, curves);
    const double largest = largestFinite(solveKeepingAll(engine, sources).vertexDistances());
    const double limit = random.uniform(0.2, 0.6) * largest;
    const double tolerance = std::pow(10.0, random.uniform(-2.5, -1.0)) * limit;
    const DistanceField field = solveFor(engine, sources, tolerance, limit);
    geodesic::RefinementOptions options;
    options.tolerance = tolerance;
    const RefinedMesh refined = geodesic::refine(field, options);
    EXPECT_LE(refined.errorBound, tolerance);
    EXPECT_GE(refined.errorBound, field.droppedErrorBound());
    const Points points(field, refined);
    expectFacesPartitioned(engine, refined, points);
    expectWatertight(engine, refined, points);

    const DistanceField all = solveKeepingAll(engine, sources, 0.0, limit);
    EXPECT_EQ(field.vertexDistances(), all.vertexDistances());
    const std::vector<bool> complete = completeFaces(all);
    const Samples inside = samplesIn(sample(field, refined, 4000, random), complete);
    const BruteForceResult truth = bruteForceDistances(mesh, toSources(curves), inside.places);
    EXPECT_LE(
      largestDifference(inside, truth.queries), refined.errorBound + EngineAccuracy * largest);
    leftAlone += expectLeftAsTheyAre(engine, refined, complete);
    for (Id face = 0; face < engine.numberOfFaces(); ++face)
    {
      dropped += complete[face] && !field.knowsInside(face) ? 1 : 0;
    }
  }
  std::cout << GetParam().name << ": " << leftAlone << " faces beyond the limit, " << dropped
            << " within it without windows\n";
  EXPECT_GT(leftAlone, 0u);
}

namespace
{

/// The number of solves in solveForRefinement(), counted by its batches of tasks.
std::size_t countSolves(
  const TriangleMesh& mesh, const std::vector<geodesic::SourceCurve>& sources, double tolerance)
{
  std::size_t batches = 0;
  geodesic::FrontOptions options;
  const auto threads = [&](std::size_t count, const std::function<void(std::size_t)>& task,
                         const std::function<void()>&)
  {
    ++batches;
    for (std::size_t i = 0; i < count; ++i)
    {
      task(i);
    }
  };
  options.job = Job({}, threads);
  geodesic::solve(mesh, sources, options, geodesic::KeepWindows::All);
  const std::size_t ofOne = batches;
  EXPECT_GT(ofOne, 0u);
  double done = 0.0;
  const auto watcher = [&](double fraction)
  {
    EXPECT_GE(fraction, done);
    done = fraction;
    return true;
  };
  options.job = Job(watcher, threads);
  solveForRefinement(mesh, sources, tolerance, options);
  return batches / std::max<std::size_t>(ofOne, 1) - 1;
}

struct NeedlesOfASheet
{
  std::uint64_t seed;
  Index cells;
  double aspect;
  double amplitude;
  /// The tolerance, relative to the largest distance.
  double fraction;
};

}

// A front that goes through needles reaches vertices long after it has passed around them: faces
// that seemed linear are not, and their windows are gone. In the first two cases the remaining
// windows are off by a third more than reported.
TEST(KeptWindowsOfNeedles, AreSolvedForAgainWhereTheyWereDroppedTooEarly)
{
  const std::vector<NeedlesOfASheet> cases = { { 18, 8, 20.0, 3.0, 0.001 },
    { 36, 12, 3.0, 0.3, 0.001 }, { 1, 12, 20.0, 3.0, 0.05 }, { 2, 12, 20.0, 3.0, 0.05 },
    { 3, 12, 20.0, 3.0, 0.05 }, { 4, 12, 20.0, 3.0, 0.05 }, { 5, 12, 20.0, 3.0, 0.05 } };
  std::size_t again = 0;
  for (const NeedlesOfASheet& sheet : cases)
  {
    SCOPED_TRACE("seed " + std::to_string(sheet.seed));
    Random random(sheet.seed);
    const PlainMesh needles =
      needleSheet(sheet.cells, sheet.cells, sheet.aspect, sheet.amplitude, random);
    const PlainMesh mesh = withSplitFaces(withSplitFaces(needles, 0.5, random), 0.5, random);
    CurveMaker maker(mesh, random);
    const std::vector<Polyline> curves = { maker.point() };
    const TriangleMesh engine = engineMesh(mesh);
    const auto sources = engineCurves(engine, curves);
    const double largest = largestFinite(geodesic::solve(engine, sources).vertexDistances());
    const std::size_t solves = countSolves(engine, sources, sheet.fraction * largest);
    EXPECT_GE(solves, 1u);
    EXPECT_LE(solves, 5u);
    again += solves > 1 ? 1 : 0;
    compare(mesh, curves, sheet.fraction, 10000, random);
  }
  std::cout << again << " of " << cases.size() << " fields solved for again\n";
  EXPECT_GT(again, 1u) << "few had a window that came too late";
}

TEST(RetentionOfAGrid, AsksBetweenTestsOfFacesWhetherToStop)
{
  GridUnderAWave grid;
  bool goesOn = true;
  const Job job([&goesOn](double) { return goesOn; });
  grid.retention_ =
    std::make_unique<geodesic::RefinementRetention>(geodesic::MeshPartition(grid.mesh_),
      grid.Tolerance, std::vector<std::uint8_t>(grid.mesh_.numberOfFaces(), 0), job);
  grid.retention_->start(1, {});
  grid.passAll(0.0, 0.0);
  goesOn = false;
  EXPECT_THROW(grid.bringFrontPast(), geodesic::Aborted);
}

// The first face is pinned, has a source, or its lists are nearer than the corners say.
TEST(RetentionOfAGrid, FacesKeepTheirWindowsWhereTheyOrNeighboursMayNeedThem)
{
  const Id around = 1 + GridUnderAWave().neighboursOfFirstFace();
  const Id all = GridUnderAWave().mesh_.numberOfFaces();
  struct Passing
  {
    const char* what;
    bool isPinned;
    bool hasSource;
    /// In tolerances, of all other faces and of the first one.
    double nearer;
    double nearerInFirstFace;
    /// How much farther all corners are later.
    double farther;
    Id kept;
  };
  const Passing cases[] = { { "linear everywhere", false, false, 0.0, 0.0, 0.0, 0 },
    { "lists farther than the tolerance", false, false, 1.1, 1.1, 0.0, all },
    { "what was found of a list, for other corners", false, false, 0.0, 0.0, 2.0, all },
    { "neighbours of a pinned face", true, false, 0.0, 0.0, 0.0, around },
    { "neighbours of a face with a source", false, true, 0.0, 0.0, 0.0, around },
    // One split at least halves a deviation, so edges of neighbours are not split further.
    { "a face that one split refines", false, false, 0.0, 1.9, 0.0, 1 },
    { "neighbours of a face that takes more splits", false, false, 0.0, 2.1, 0.0, around } };
  for (const Passing& c : cases)
  {
    SCOPED_TRACE(c.what);
    constexpr double tolerance = GridUnderAWave::Tolerance;
    GridUnderAWave grid;
    if (c.isPinned)
    {
      grid.retention_ = grid.retentionWith({ 0 });
    }
    if (c.hasSource)
    {
      const Barycentric inside = { 0.3, 0.3, 0.4 };
      grid.retention_->start(1, { { 0, inside, inside } });
    }
    grid.passAll(c.nearer * tolerance, c.nearerInFirstFace * tolerance);
    for (double& distance : grid.distances_)
    {
      distance += c.farther * tolerance;
    }
    grid.bringFrontPast();
    EXPECT_TRUE(grid.retention_->missing().empty());
    const geodesic::KeptWindows windows = grid.finish();
    EXPECT_EQ(static_cast<Id>(std::count(windows.faces.begin(), windows.faces.end(), 1)), c.kept);
    // The bound computed from lists as they pass is wide.
    EXPECT_TRUE(c.kept > 0 || windows.droppedErrorBound <= 1e-6 * tolerance);
  }
}

TEST(RetentionOfAGrid, FacesDroppedTooEarlyAreMissing)
{
  for (const bool isListLate : { true, false })
  {
    GridUnderAWave grid;
    grid.passAll(0.0, 0.0);
    grid.bringFrontPast();
    if (isListLate)
    {
      grid.pass(0, 0.0);
      grid.advance({});
      EXPECT_EQ(grid.retention_->missing(), std::vector<Id>{ 0 });
    }
    else
    {
      grid.retention_->shortenDistance(0); // a corner gets nearer
      EXPECT_EQ(grid.retention_->missing().size(), grid.mesh_.cornersAt(0).size());
    }
  }
}

TEST(KeptWindowsOfASheet, AreFewAndRefuseWhatTheyCannotTell)
{
  Random random(11);
  const PlainMesh mesh = bumpySheet(16, 16, 0, 0.1, random);
  const TriangleMesh engine = engineMesh(mesh);
  const auto curves = engineCurves(engine, Sources{ { vertexPoint(mesh, 0) }, {} });
  const DistanceField field = solveFor(engine, curves, 0.5);
  EXPECT_GT(droppedFaces(field), engine.numberOfFaces() / 2);
  EXPECT_THROW(static_cast<void>(field.distance(geodesic::SurfacePoint::inFace(0, 0.3, 0.3))),
    geodesic::Error);
  geodesic::RefinementOptions options;
  options.tolerance = 0.25;
  EXPECT_THROW(geodesic::refine(field, options), geodesic::Error);
}

// Faces without windows are cut where their neighbours split their edges.
TEST(KeptWindowsOfASheet, TrianglesOfOtherFacesCountForTheCap)
{
  Random random(11);
  const PlainMesh mesh = bumpySheet(16, 16, 0, 0.1, random);
  const TriangleMesh engine = engineMesh(mesh);
  const auto curves = engineCurves(engine, Sources{ { vertexPoint(mesh, 0) }, {} });
  std::size_t cut = 0;
  for (const double tolerance : { 0.05, 0.02, 0.01 })
  {
    const DistanceField field = solveFor(engine, curves, tolerance);
    const RefinedMesh whole = refineTo(field, tolerance);
    for (std::size_t i = 1; i < whole.faces.size(); ++i)
    {
      const Id face = whole.faces[i];
      cut += face == whole.faces[i - 1] && !field.knowsInside(face) ? 1 : 0;
    }
    const RefinedMesh capped = refineTo(field, tolerance, whole.triangles.size() - 1);
    EXPECT_LT(capped.triangles.size(), whole.triangles.size());
    EXPECT_TRUE(capped.stoppedAtMaximum);
  }
  EXPECT_GT(cut, 0u);
}
