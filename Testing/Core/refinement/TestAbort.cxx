// SPDX-License-Identifier: BSD-3-Clause
// On any mesh the engine tells the watcher of a job often, and stops soon after the watcher asks it
// to. GEODESIC_TEST_SEEDS=FIRST,COUNT takes other seeds.
#include "EngineSupport.h"
#include "Seeds.h"
#include "truth/CappedMeshes.h"

#include "Errors.h"
#include "contours/Isolines.h"
#include "contours/SolveForIsolines.h"
#include "field/DistanceMatrix.h"
#include "paths/JoinPoints.h"
#include "paths/PathsToSource.h"
#include "refinement/AdaptiveRefinement.h"
#include "refinement/SolveForRefinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <iostream>
#include <string>

using namespace geodesictest;
using geodesic::Job;
using geodesic::SourceCurve;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

/// The mesh is small: even a slow machine or a sanitizer needs far less than this. It is processor
/// time, so other processes do not count.
constexpr double LongestSilence = 1.0;

/// Some solves would take minutes and gigabytes, as edges of many faces multiply windows. They are
/// stopped.
constexpr double LongestRun = 0.2;

double processorTime()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// A watcher that asks to stop from one of its calls on, or once a run takes too long,
/// and that measures the time between calls.
class Watch
{
public:
  explicit Watch(std::uint64_t lastCall)
    : lastCall_(lastCall)
    , begin_(processorTime())
    , before_(this->begin_)
  {
  }

  Job job()
  {
    return Job(
      [this](double)
      {
        this->look();
        ++this->calls_;
        this->hasStopped_ = this->hasStopped_ || this->calls_ >= this->lastCall_ ||
          this->before_ - this->begin_ > LongestRun;
        return !this->hasStopped_;
      });
  }

  void look()
  {
    const double now = processorTime();
    this->longest_ = std::max(this->longest_, now - this->before_);
    this->before_ = now;
  }

  bool hasStopped() const { return this->hasStopped_; }
  double longest() const { return this->longest_; }

private:
  std::uint64_t lastCall_;
  std::uint64_t calls_ = 0;
  bool hasStopped_ = false;
  double begin_;
  double before_;
  double longest_ = 0.0;
};

/// One vertex with all faces around it, near and far.
PlainMesh spikyFan(Index faces, Random& random)
{
  PlainMesh mesh;
  mesh.points.push_back({ 0.0, 0.0, 0.0 });
  const double height = random.chance(0.3) ? 0.0 : 1.0;
  const double spread = random.uniform(0.0, 3.0);
  for (Index i = 0; i < faces; ++i)
  {
    const double angle = 6.28318530717958648 * i / faces;
    const double radius = std::pow(10.0, random.uniform(0.0, spread));
    mesh.points.push_back(
      { radius * std::cos(angle), radius * std::sin(angle), height * random.uniform(-1.0, 1.0) });
    mesh.triangles.push_back({ 0, i + 1, (i + 1) % faces + 1 });
  }
  return mesh;
}

/// Hundreds of faces at each edge of a spine.
PlainMesh manyPages(Index faces, Random& random)
{
  const Index rows = random.between(1, 3);
  return book(std::max<Index>(3, faces / (2 * rows)), rows, 1, 0.4, random);
}

/// Random faces between a few points: edges and vertices have many faces, and faces intersect.
PlainMesh soup(Index faces, Random& random)
{
  PlainMesh mesh;
  const Index points = random.between(8, 60);
  const double flat = random.chance(0.3) ? 0.0 : 1.0;
  for (Index i = 0; i < points; ++i)
  {
    mesh.points.push_back(
      { random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), flat * random.uniform(-1.0, 1.0) });
  }
  for (Index i = 0; i < faces; ++i)
  {
    const Index a = random.below(points);
    const Index b = (a + random.between(1, points - 1)) % points;
    const Index c = random.below(points);
    if (c != a && c != b)
    {
      mesh.triangles.push_back({ a, b, c });
    }
  }
  return compacted(mesh);
}

void addSpikes(PlainMesh& mesh, Random& random)
{
  for (Index i = random.between(1, 20); i > 0; --i)
  {
    Vec3& p = mesh.points[random.below(mesh.points.size())];
    p[2] += std::pow(10.0, random.uniform(-1.0, 4.0));
  }
}

// Edges without length.
void joinPlaces(PlainMesh& mesh, Random& random)
{
  for (Index i = random.between(1, 50); i > 0; --i)
  {
    const auto& t = mesh.triangles[random.below(mesh.triangles.size())];
    mesh.points[t[0]] = mesh.points[t[1]];
  }
}

PlainMesh badMesh(Random& random)
{
  const Index faces = random.between(20, 900);
  const Index kind = random.below(meshKinds().size() + 3);
  PlainMesh mesh = kind == meshKinds().size() ? spikyFan(faces, random)
    : kind == meshKinds().size() + 1          ? manyPages(faces, random)
    : kind == meshKinds().size() + 2          ? soup(faces, random)
                                              : meshKinds()[kind].make(faces, random);
  if (random.chance(0.3))
  {
    mesh = withCaps(mesh, Caps::AnyAndLoose, random.uniform(0.01, 0.2), random).mesh;
  }
  if (random.chance(0.3))
  {
    addSpikes(mesh, random);
  }
  if (random.chance(0.3))
  {
    joinPlaces(mesh, random);
  }
  return mesh;
}

/// The input of all public operations.
struct Question
{
  TriangleMesh mesh;
  std::vector<SourceCurve> sources;
  std::vector<SurfacePoint> points;
  double size = 0.0;
};

struct Answer
{
  const char* name;
  std::function<void(const Question&, const Job&)> run;
};

geodesic::FrontOptions frontOptions(const Job& job)
{
  geodesic::FrontOptions options;
  options.job = job;
  return options;
}

void refine(const Question& q, const Job& job)
{
  const double tolerance = 0.01 * q.size;
  const geodesic::DistanceField field =
    solveForRefinement(q.mesh, q.sources, tolerance, frontOptions(job));
  geodesic::RefinementOptions options;
  options.tolerance = tolerance;
  options.maximumFaces = 5000;
  options.job = job;
  geodesic::refine(field, options);
}

void drawIsolines(const Question& q, const Job& job)
{
  geodesic::IsolineOptions options;
  for (int i = 1; i <= 100; ++i)
  {
    options.values.push_back(0.01 * i * q.size);
  }
  options.chordTolerance = 1e-3 * q.size;
  options.job = job;
  geodesic::drawIsolines(
    solveForIsolines(q.mesh, q.sources, options.values, frontOptions(job)), options);
}

const std::vector<Answer> Answers = {
  { "exact",
    [](const Question& q, const Job& job)
    { solve(q.mesh, q.sources, frontOptions(job), geodesic::KeepWindows::All); } },
  { "approximate",
    [](const Question& q, const Job& job)
    {
      geodesic::FrontOptions options = frontOptions(job);
      options.relativeError = 0.01;
      solve(q.mesh, q.sources, options);
    } },
  { "within a limit",
    [](const Question& q, const Job& job)
    {
      geodesic::FrontOptions options = frontOptions(job);
      options.maximumDistance = 0.3 * q.size;
      solve(q.mesh, q.sources, options, geodesic::KeepWindows::All);
    } },
  { "refined", refine },
  { "isolines", drawIsolines },
  { "paths",
    [](const Question& q, const Job& job) { findPaths(q.mesh, q.sources, q.points, job); } },
  { "path between points",
    [](const Question& q, const Job& job)
    { geodesic::joinByShortestPaths(q.mesh)(q.points.front(), q.points.back(), job); } },
  { "matrix",
    [](const Question& q, const Job& job)
    {
      distanceMatrix(
        q.mesh, setsOf(q.sources, q.sources.size()), setsOf(q.points), geodesic::Infinity, job);
    } },
};

Question randomQuestion(Random& random)
{
  const PlainMesh mesh = badMesh(random);
  Question q;
  q.mesh = engineMesh(mesh);
  for (Index i = 0; i < 5; ++i)
  {
    const auto face = random.below(q.mesh.numberOfFaces());
    const Barycentric w = randomWeights(random);
    q.points.push_back(random.chance(0.5) ? SurfacePoint::atVertex(q.mesh.triangle(face)[0])
                                          : fromBarycentric(q.mesh, face, w));
  }
  for (Index i = random.between(1, 3); i > 0; --i)
  {
    q.sources.push_back(geodesic::pointCurve(q.points[i]));
    q.sources.back().source = i - 1;
  }
  std::reverse(q.sources.begin(), q.sources.end());
  for (const Vec3& p : mesh.points)
  {
    q.size = std::max(q.size, spaceDistance(p, mesh.points.front()));
  }
  return q;
}

} // anonymous namespace

TEST(Abort, ComesSoonOnAnyMesh)
{
  const Seeds seeds = seedsOfTest(meshesOfAKind(60));
  double worst = 0.0;
  for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
  {
    Random random(seed + 130);
    const Question question = randomQuestion(random);
    const Answer& answer = Answers[random.below(Answers.size())];
    // Some of these run to their end.
    const auto lastCall = static_cast<std::uint64_t>(std::pow(10.0, random.uniform(0.0, 3.0)));
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + answer.name);
    Watch watch(lastCall);
    try
    {
      answer.run(question, watch.job());
      EXPECT_FALSE(watch.hasStopped());
    }
    catch (const geodesic::Aborted&)
    {
      EXPECT_TRUE(watch.hasStopped());
    }
    catch (const geodesic::Error& e) // whether the answer is right is asked elsewhere
    {
      std::cout << "seed " << seed << ", " << answer.name << ": " << e.what() << "\n";
    }
    watch.look();
    EXPECT_LE(watch.longest(), LongestSilence);
    worst = std::max(worst, watch.longest());
  }
  std::cout << "longest silence " << worst << " s\n";
}

// Two faces with very many triangles each.
TEST(Abort, IsAskedForWhileALargeFaceIsRefined)
{
  const TriangleMesh mesh = engineMesh(regularGrid(1, 1));
  const geodesic::DistanceField field =
    solveKeepingAll(mesh, { geodesic::pointCurve(SurfacePoint::inFace(0, 0.3, 0.3)) });
  geodesic::RefinementOptions options;
  options.tolerance = 1e-6;
  int calls = 0;
  options.job = Job([&](double) { return ++calls < 20; });
  EXPECT_THROW(refine(field, options), geodesic::Aborted);
}
