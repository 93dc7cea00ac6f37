// SPDX-License-Identifier: BSD-3-Clause
// Refinement along the borders of source regions: by brute force to each curve alone, all corners
// of a triangle have the same nearest curve, unless the triangle is as small as the tolerance.
#include "EngineSupport.h"
#include "OnThreads.h"
#include "RanksSupport.h"
#include "refinement/RefinementSupport.h"

#include "refinement/SolveForRefinement.h"
#include "refinement/SourceRegions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <utility>

using namespace geodesictest;
using geodesic::DistanceField;
using geodesic::Id;
using geodesic::Job;
using geodesic::NearestSource;
using geodesic::RefinedMesh;
using geodesic::SourceRegions;
using geodesic::TriangleMesh;

namespace
{

enum class By
{
  Sources,
  Sides
};

/// The input of a refinement, on one rank or in one process.
struct Task
{
  const geodesic::MeshPartition& surface;
  const geodesic::SourceWindows& sources;
  const geodesic::ReplicatedPatch& patch;
  const std::vector<geodesic::SourceCurve>& curves;
  double tolerance;
  By by = By::Sources;
  std::uint64_t maximumFaces = 0;
  geodesic::Job job = {};

  geodesic::FrontOptions frontOptions() const
  {
    geodesic::FrontOptions options;
    options.keepArrivals = true;
    options.job = this->job;
    return options;
  }
};

struct Result
{
  DistanceField field;
  RefinedMesh refined;
};

geodesic::PinnedFaces facesAtBorders(const Task& task)
{
  const DistanceField atVertices = geodesic::solve(task.surface, task.sources, task.frontOptions());
  NearestSource nearest(atVertices, task.patch, task.curves);
  return SourceRegions(atVertices, nearest, task.curves, task.by == By::Sides).facesAtBorders();
}

Result refineOf(const Task& task, DistanceField field)
{
  NearestSource nearest(field, task.patch, task.curves);
  SourceRegions regions(field, nearest, task.curves, task.by == By::Sides);
  geodesic::RefinementOptions options;
  options.tolerance = task.tolerance;
  options.maximumFaces = task.maximumFaces;
  options.job = task.job;
  options.regions = &regions;
  RefinedMesh refined = refine(field, options);
  return { std::move(field), std::move(refined) };
}

/// Solves for the borders of regions and refines, until the windows of all faces at borders are
/// kept.
Result refineAlongBorders(const Task& task)
{
  geodesic::PinnedFaces pinned = facesAtBorders(task);
  for (;;)
  {
    Result result = refineOf(task,
      geodesic::solveForRefinement(
        task.surface, task.sources, task.tolerance, task.frontOptions(), pinned));
    for (const Id face : result.refined.unknownAtBorders)
    {
      EXPECT_EQ(pinned[face], 0);
    }
    if (!geodesic::pinMissing(task.surface, result.refined.unknownAtBorders, pinned))
    {
      return result;
    }
  }
}

/// A task of one process.
class Whole
{
public:
  Whole(const PlainMesh& plain, const std::vector<Polyline>& curves)
    : mesh(engineMesh(plain))
    , sources(numbered(engineCurves(this->mesh, curves)))
    , largest(largestFinite(geodesic::solve(this->mesh, this->sources).vertexDistances()))
    , surface_(this->mesh)
    , windows_(geodesic::makeSourceWindows(this->mesh, this->sources, {}))
    , patch_(this->mesh)
  {
  }

  Task task(double tolerance) const
  {
    return { this->surface_, this->windows_, this->patch_, this->sources, tolerance };
  }

  const TriangleMesh mesh;
  const std::vector<geodesic::SourceCurve> sources;
  const double largest;

private:
  static std::vector<geodesic::SourceCurve> numbered(std::vector<geodesic::SourceCurve> curves)
  {
    for (std::size_t i = 0; i < curves.size(); ++i)
    {
      curves[i].source = static_cast<Id>(i);
    }
    return curves;
  }

  geodesic::MeshPartition surface_;
  geodesic::SourceWindows windows_;
  geodesic::ReplicatedPatch patch_;
};

double longestEdge(const geodesic::Triangle& t, const Points& points)
{
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec3 a = points.position(t[k]);
    const Vec3 b = points.position(t[(k + 1) % 3]);
    longest = std::max(longest, std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]));
  }
  return longest;
}

/// All points of a refined mesh in the brute force's format.
///
/// \param wholeFace (Id face) -> the face's number in the whole mesh.
template <typename WholeFace>
std::vector<MeshPoint> placesOf(const Result& result, const WholeFace& wholeFace)
{
  const TriangleMesh& mesh = result.field.mesh();
  const Points points(result.field, result.refined);
  std::vector<MeshPoint> places(result.refined.numberOfInputPoints + result.refined.points.size());
  for (std::size_t i = 0; i < result.refined.triangles.size(); ++i)
  {
    const Id face = result.refined.faces[i];
    for (const Id point : result.refined.triangles[i])
    {
      places[point] = { wholeFace(face), barycentric(mesh, points.place(point), face) };
    }
  }
  return places;
}

/// Checks that no triangle longer than the tolerance has corners that are nearest to different
/// curves. \returns the number of triangles that have such corners.
///
/// \param distances to each curve alone, at all points of the refined mesh.
std::size_t expectNarrowBorders(const Result& result,
  const std::array<std::vector<double>, 2>& distances, double largest, double tolerance)
{
  const Points points(result.field, result.refined);
  const auto isNearer = [&](std::size_t i, Id point)
  { return distances[i][point] < distances[1 - i][point] - 1e-8 * largest; };
  std::size_t atBorders = 0;
  for (const geodesic::Triangle& t : result.refined.triangles)
  {
    const auto isAnyNearer = [&](std::size_t i)
    { return isNearer(i, t[0]) || isNearer(i, t[1]) || isNearer(i, t[2]); };
    if (isAnyNearer(0) && isAnyNearer(1))
    {
      ++atBorders;
      EXPECT_LE(longestEdge(t, points), (1.0 + 1e-9) * tolerance);
    }
  }
  return atBorders;
}

std::array<std::vector<double>, 2> distancesToEach(
  const PlainMesh& mesh, const std::vector<Polyline>& curves, const std::vector<MeshPoint>& places)
{
  std::array<std::vector<double>, 2> distances;
  for (std::size_t i = 0; i < 2; ++i)
  {
    distances[i] = bruteForceDistances(mesh, toSources({ curves[i] }), places).queries;
  }
  return distances;
}

class Regions : public ::testing::TestWithParam<MeshKind>
{
protected:
  struct Case
  {
    PlainMesh mesh;
    std::vector<Polyline> curves;
  };
  static Case makeCase(Random& random)
  {
    Case c;
    c.mesh = GetParam().make(random.between(20, 150), random);
    CurveMaker maker(c.mesh, random);
    c.curves = { maker.any(), maker.any() };
    return c;
  }
};

/// The side of a straight line in the plane z = 0 that each point is on; 0 on the line.
int sideOf(const Vec3& p, const Vec3& a, const Vec3& b)
{
  const double turned = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
  return std::abs(turned) < 1e-9 ? 0 : turned > 0.0 ? 1 : -1;
}

}

TEST_P(Regions, HaveBordersAsNarrowAsTheTolerance)
{
  std::size_t atBorders = 0;
  for (Random& random : EachSeed(meshesOfAKind(4), 8100))
  {
    const Case c = makeCase(random);
    const Whole whole(c.mesh, c.curves);
    const double tolerance = random.uniform(0.01, 0.1) * whole.largest;
    const Result result = refineAlongBorders(whole.task(tolerance));
    EXPECT_LE(result.refined.errorBound, tolerance);
    EXPECT_FALSE(result.refined.stoppedAtMaximum);
    const Points points(result.field, result.refined);
    expectFacesPartitioned(whole.mesh, result.refined, points);
    expectWatertight(whole.mesh, result.refined, points);
    const auto distances =
      distancesToEach(c.mesh, c.curves, placesOf(result, [](Id face) { return face; }));
    atBorders += expectNarrowBorders(result, distances, whole.largest, tolerance);
  }
  std::cout << GetParam().name << ": " << atBorders << " triangles at borders\n";
}

TEST_P(Regions, HaveNarrowBordersOnSeveralRanks)
{
  Random random(8200);
  const Case c = makeCase(random);
  const Whole whole(c.mesh, c.curves);
  const double tolerance = 0.05 * whole.largest;
  forEachCut(c.mesh, someWaysToCut(), random,
    [&](const CutMesh& cut)
    {
      onRanks(cut, c.curves, 0,
        [&](const RankOfRun& rank)
        {
          std::vector<geodesic::SourceCurve> curves = rank.curvesOnPatch;
          for (std::size_t i = 0; i < curves.size(); ++i)
          {
            curves[i].source = static_cast<Id>(i);
          }
          const Result result =
            refineAlongBorders({ rank.part, rank.sources, rank.patch, curves, tolerance });
          EXPECT_LE(result.refined.errorBound, tolerance);
          std::vector<Id> wholeFaces(rank.part.mesh().numberOfFaces(), geodesic::NoId);
          for (Id face = rank.part.firstOwnFace(); face < rank.part.endOfOwnFaces(); ++face)
          {
            wholeFaces[face] = static_cast<Id>(rank.wholeFaces[rank.part.triangleOf(face)]);
          }
          const auto places = placesOf(result, [&](Id face) { return wholeFaces[face]; });
          expectNarrowBorders(
            result, distancesToEach(c.mesh, c.curves, places), whole.largest, tolerance);
        });
    });
}

TEST_P(Regions, DoNotDependOnThreads)
{
  Random random(8300);
  const Case c = makeCase(random);
  const Whole whole(c.mesh, c.curves);
  Task task = whole.task(0.03 * whole.largest);
  const Result result = refineAlongBorders(task);
  task.job = Job({}, onThreads);
  const Result other = refineAlongBorders(task);
  EXPECT_EQ(result.refined.triangles, other.refined.triangles);
  EXPECT_EQ(result.refined.errorBound, other.refined.errorBound);
}

TEST_P(Regions, KeepTheMaximumAndCertifyWhatIsReached)
{
  Random random(8400);
  const Case c = makeCase(random);
  const Whole whole(c.mesh, c.curves);
  Task task = whole.task(0.005 * whole.largest);
  const Result plain = { solveForRefinement(whole.mesh, whole.sources, task.tolerance),
    refineTo(solveForRefinement(whole.mesh, whole.sources, task.tolerance), task.tolerance) };
  const Result all = refineAlongBorders(task);
  if (all.refined.triangles.size() < plain.refined.triangles.size() + 100)
  {
    return; // there is no border to speak of
  }
  task.maximumFaces = plain.refined.triangles.size() + 50;
  const Result result = refineAlongBorders(task);
  EXPECT_TRUE(result.refined.stoppedAtMaximum);
  EXPECT_LE(result.refined.triangles.size(), task.maximumFaces);
  const Samples samples = sample(result.field, result.refined, 500, random);
  const BruteForceResult truth = bruteForceDistances(c.mesh, toSources(c.curves), samples.places);
  EXPECT_LE(largestDifference(samples, truth.queries),
    result.refined.errorBound + EngineAccuracy * whole.largest);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Regions, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });

// Where a straight line between two points of the plane crosses the curve, the distances of both
// sides meet without a jump; elsewhere they jump behind the curve's ends.
TEST(RegionsBySides, AreNarrowBehindTheEndsAndNotRefinedAlongTheCurve)
{
  std::size_t atBorders = 0;
  std::size_t longAtCurve = 0;
  for (Random& random : EachSeed(meshesOfAKind(30), 8500))
  {
    const PlainMesh plain = regularGrid(9, 7);
    CurveMaker maker(plain, random);
    const std::vector<Polyline> curves = { maker.straight(12) };
    if (curves.front().isPoint())
    {
      continue;
    }
    const Whole whole(plain, curves);
    Task task = whole.task(0.01 * whole.largest);
    task.by = By::Sides;
    const Result result = refineAlongBorders(task);
    const Points points(result.field, result.refined);
    const geodesic::SourceCurve& curve = whole.sources.front();
    const Vec3 a = position(whole.mesh, curve.points.front());
    const Vec3 b = position(whole.mesh, curve.points.back());
    const auto isJump = [&](Id p, Id q)
    {
      const Vec3 x = points.position(p);
      const Vec3 y = points.position(q);
      const double length = std::hypot(y[0] - x[0], y[1] - x[1]);
      return sideOf(x, a, b) * sideOf(y, a, b) < 0 &&
        points.distance(p) + points.distance(q) > (1.0 + 1e-9) * length;
    };
    for (const geodesic::Triangle& t : result.refined.triangles)
    {
      const double longest = longestEdge(t, points);
      if (isJump(t[0], t[1]) || isJump(t[1], t[2]) || isJump(t[2], t[0]))
      {
        ++atBorders;
        EXPECT_LE(longest, (1.0 + 1e-9) * task.tolerance);
      }
      const auto isOnCurve = [&](Id p) { return points.distance(p) < 1e-9; };
      const bool isAtCurve = isOnCurve(t[0]) || isOnCurve(t[1]) || isOnCurve(t[2]);
      longAtCurve += isAtCurve && longest > 2.0 * task.tolerance ? 1 : 0;
    }
  }
  EXPECT_GT(atBorders, 0U);
  EXPECT_GT(longAtCurve, 0U);
}

// The sources are seen from afar in almost the same direction: the distance is nearly linear across
// the border, so its faces are dropped unless they are pinned.
TEST(RegionsFarFromTheirSources, AreRefinedOnlyWithTheWindowsOfFacesAtTheBorder)
{
  const PlainMesh plain = regularGrid(30, 3);
  Random random(1);
  const CurveMaker maker(plain, random);
  const std::vector<Polyline> curves = { maker.point(vertexPoint(plain, 0)),
    maker.point(vertexPoint(plain, 3 * 31)) };
  const Whole whole(plain, curves);
  const Task task = whole.task(0.3);
  DistanceField field =
    solveForRefinement(task.surface, task.sources, task.tolerance, task.frontOptions());
  std::vector<Id> dropped; // with corners on both sides of the border, y = 1.5
  for (Id face = 0; face < whole.mesh.numberOfFaces(); ++face)
  {
    std::size_t above = 0;
    for (const Id vertex : whole.mesh.triangle(face))
    {
      above += whole.mesh.point(vertex)[1] > 1.5 ? 1 : 0;
    }
    if (above % 3 != 0 && field.isDropped(face))
    {
      dropped.push_back(face);
    }
  }
  ASSERT_FALSE(dropped.empty());
  EXPECT_EQ(refineOf(task, std::move(field)).refined.unknownAtBorders, dropped);
}
