// SPDX-License-Identifier: BSD-3-Clause
// Paths that ranks hand on: as long as the brute-force distance, through consecutive faces, to the
// curve that they name, and equal to those of one process.
#include "EngineSupport.h"
#include "OnThreads.h"
#include "RanksSupport.h"
#include "paths/PathChecker.h"

#include "paths/PathInStrip.h"
#include "paths/PathsToSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <mutex>

using namespace geodesictest;
using geodesic::Job;
using geodesic::SurfacePoint;

namespace
{

constexpr std::uint64_t MeshesOfAKind = 2;
constexpr std::size_t Targets = 40;
constexpr std::size_t TargetsInStrips = 3;

class PathsOnRanks : public ::testing::TestWithParam<MeshKind>
{
};

Vec3 plainPlace(const geodesic::Vec3& p)
{
  return { p[0], p[1], p[2] };
}

/// The paths of one process, as places.
std::vector<std::vector<Vec3>> pathsInOnePiece(const RandomCase& c)
{
  const geodesic::TriangleMesh mesh = engineMesh(c.mesh);
  std::vector<SurfacePoint> targets;
  for (const MeshPoint& query : c.queries)
  {
    targets.push_back(enginePoint(mesh, query));
  }
  std::vector<std::vector<Vec3>> result;
  for (const FoundPath& path : findPaths(mesh, engineCurves(mesh, c.curves), targets))
  {
    result.emplace_back();
    std::transform(
      path.places.begin(), path.places.end(), std::back_inserter(result.back()), plainPlace);
  }
  return result;
}

/// Whether a place is within a distance of a face.
bool isInFace(const PlainMesh& mesh, Index face, const Vec3& place, double slack)
{
  using geodesic::operator-;
  const Triangle& t = mesh.triangles[face];
  const auto corner = [&](std::size_t k) -> geodesic::Vec3 {
    return { mesh.points[t[k]][0], mesh.points[t[k]][1], mesh.points[t[k]][2] };
  };
  const geodesic::Vec3 p = { place[0], place[1], place[2] };
  const geodesic::Vec3 normal = geodesic::cross(corner(1) - corner(0), corner(2) - corner(0));
  const double area2 = geodesic::norm(normal);
  double out = std::abs(geodesic::dot(p - corner(0), normal)) / area2;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const geodesic::Vec3 edge = corner((k + 1) % 3) - corner(k);
    const double above =
      geodesic::dot(geodesic::cross(edge, p - corner(k)), normal) / (area2 * geodesic::norm(edge));
    out = std::max(out, -above);
  }
  return out <= slack;
}

bool haveAFaceInCommon(const PlainMesh& mesh, const Vec3& a, const Vec3& b, double slack)
{
  for (Index face = 0; face < mesh.triangles.size(); ++face)
  {
    if (isInFace(mesh, face, a, slack) && isInFace(mesh, face, b, slack))
    {
      return true;
    }
  }
  return false;
}

/// Checks the paths of targets over ranks, and compares them with those of one process.
class CheckedPaths
{
public:
  CheckedPaths(const MeshKind& kind, std::uint64_t seed)
    : case_(randomCase(kind, seed + 81000, Targets))
    , whole_(pathsInOnePiece(this->case_))
    , slack_(accuracyOn(kind) * largestFinite(this->case_.truth.vertices))
  {
  }

  const RandomCase& plain() const { return this->case_; }

  void check(std::size_t target, const FoundPath& path)
  {
    SCOPED_TRACE("target " + std::to_string(target));
    const double truth = this->case_.truth.queries[target];
    ASSERT_EQ(path.places.empty(), !(truth < geodesic::Infinity));
    if (path.places.empty())
    {
      return;
    }
    ASSERT_LT(path.source, this->case_.curves.size());
    const PlainMesh& mesh = this->case_.mesh;
    double length = 0.0;
    for (std::size_t i = 1; i < path.places.size(); ++i)
    {
      const Vec3 a = plainPlace(path.places[i - 1]);
      const Vec3 b = plainPlace(path.places[i]);
      length += spaceDistance(a, b);
      // The target may lie within rounding of a vertex that the path passes.
      EXPECT_TRUE(a != b || i == 1) << "point " << i << " repeats the last one";
      EXPECT_TRUE(haveAFaceInCommon(mesh, a, b, 1e-9)) << "piece " << i;
    }
    EXPECT_LE(std::abs(length - truth), this->slack_);
    const Vec3 begin = plainPlace(path.places.front());
    EXPECT_LE(spaceDistance(begin, position(mesh, this->case_.queries[target])), this->slack_);
    const Vec3 end = plainPlace(path.places.back());
    EXPECT_LE(
      distanceInSpace(mesh, end, toSources({ this->case_.curves[path.source] })), this->slack_);
    ++this->compared_;
    this->different_ += this->isAsInOnePiece(target, path) ? 0 : 1;
  }

  std::size_t compared() const { return this->compared_; }
  std::size_t different() const { return this->different_; }

private:
  bool isAsInOnePiece(std::size_t target, const FoundPath& path) const
  {
    const std::vector<Vec3>& whole = this->whole_[target];
    bool isSame = whole.size() == path.places.size();
    for (std::size_t i = 0; i < whole.size() && isSame; ++i)
    {
      isSame = spaceDistance(whole[i], plainPlace(path.places[i])) <= 1e-6;
    }
    return isSame;
  }

  RandomCase case_;
  std::vector<std::vector<Vec3>> whole_;
  double slack_;
  std::size_t compared_ = 0;
  std::size_t different_ = 0;
};

std::vector<geodesic::SourceCurve> numbered(std::vector<geodesic::SourceCurve> curves)
{
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    curves[i].source = static_cast<geodesic::Id>(i);
  }
  return curves;
}

/// The targets of a rank: those in faces that it owns.
struct TargetsOfRank
{
  std::vector<std::size_t> numbers;
  std::vector<SurfacePoint> points;
};

TargetsOfRank targetsOf(const RankOfRun& rank, const std::vector<MeshPoint>& queries)
{
  TargetsOfRank targets;
  for (std::size_t i = 0; i < queries.size(); ++i)
  {
    const geodesic::RankAddress face = rank.facesOnRanks[queries[i].face];
    if (face.rank == rank.exchange.rank() && rank.part.isOwn(face.id))
    {
      targets.numbers.push_back(i);
      targets.points.push_back(
        geodesic::fromBarycentric(rank.part.mesh(), face.id, queries[i].weights));
    }
  }
  return targets;
}

std::vector<FoundPath> pathsOver(
  const RandomCase& c, const CutMesh& cut, std::uint64_t disorder = 0, bool inParallel = false)
{
  std::vector<FoundPath> paths(c.queries.size());
  std::mutex mutex;
  onRanks(cut, c.curves, disorder,
    [&](const RankOfRun& rank)
    {
      const TargetsOfRank targets = targetsOf(rank, c.queries);
      const Job job = inParallel ? Job({}, onThreads) : Job();
      const std::vector<FoundPath> own =
        findPaths(rank.part, rank.patch, numbered(rank.curvesOnPatch), targets.points, job);
      const std::lock_guard<std::mutex> lock(mutex);
      for (std::size_t i = 0; i < own.size(); ++i)
      {
        paths[targets.numbers[i]] = own[i];
      }
    });
  return paths;
}

struct TargetAtDistance
{
  MeshPoint point;
  double distance;
};

/// The paths that each target's rank finds in a strip; no other rank has one. The front has stopped
/// at the target: it knows no larger distance.
std::vector<FoundPath> pathsInStrips(const CutMesh& cut, const std::vector<Polyline>& curves,
  const std::vector<TargetAtDistance>& targets)
{
  std::vector<FoundPath> paths(targets.size());
  onRanks(cut, curves, 0,
    [&](const RankOfRun& rank)
    {
      geodesic::FrontOptions options;
      const geodesic::DistanceField field = geodesic::solve(rank.part, rank.sources, options);
      const std::vector<geodesic::SourceCurve> onPatch = numbered(rank.curvesOnPatch);
      for (std::size_t i = 0; i < targets.size(); ++i)
      {
        const auto& [point, distance] = targets[i];
        const geodesic::RankAddress face = rank.facesOnRanks[point.face];
        geodesic::FacePoint inFace{};
        if (face.rank == rank.exchange.rank())
        {
          const geodesic::TriangleMesh& mesh = rank.part.mesh();
          inFace = geodesic::toFacePoint(
            mesh, face.id, geodesic::fromBarycentric(mesh, face.id, point.weights));
        }
        inFace = geodesic::valuesOfRanks(rank.exchange, inFace)[geodesic::rankIndex(face.rank)];
        std::vector<double> atVertices = field.vertexDistances();
        for (double& atVertex : atVertices)
        {
          atVertex = atVertex <= distance ? atVertex : geodesic::Infinity;
        }
        const auto found = geodesic::pathInStrip(
          rank.part, rank.patch, onPatch, { face, inFace, distance }, { atVertices, distance }, {});
        EXPECT_EQ(found.has_value(), face.rank == rank.exchange.rank());
        if (found)
        {
          paths[i].take(geodesic::toSource(*found));
        }
      }
    });
  return paths;
}

}

TEST(PathsOnSeams, OfTargetsOnTheSourceAreTwoEqualPoints)
{
  RandomCase c;
  c.mesh = regularGrid(4, 4);
  // At vertices inside and on the boundary, most of which several ranks have.
  for (Index face = 0; face < c.mesh.triangles.size(); face += 3)
  {
    MeshPoint corner = { face, {} };
    corner.weights[face % 2] = 1.0;
    c.curves = { { { { face, corner.weights, corner.weights } }, {} } };
    c.queries = { corner };
    Random random(face);
    forEachCut(c.mesh, bothWaysToCut({ 2, 3 }), random,
      [&](const CutMesh& cut)
      {
        const FoundPath path = pathsOver(c, cut).front();
        ASSERT_EQ(path.places.size(), 2U) << "face " << face;
        EXPECT_EQ(path.places.front(), path.places.back());
        EXPECT_EQ(path.source, 0U);
      });
  }
}

// At each edge of three faces the ranks around it are asked anew, whatever those at the last one
// said.
TEST(PathsOnSeams, AcrossTwoRowsOfEdgesOfThreeFacesAreFollowedToTheSource)
{
  // A sheet with a fin at x = 2 and at x = 4. Each of the five parts goes to a rank of its own
  // choice.
  RandomCase c;
  std::vector<std::size_t> partOf;
  const auto addCell = [&](const std::array<Index, 4>& corners, std::size_t part)
  {
    c.mesh.triangles.push_back({ corners[0], corners[1], corners[2] });
    c.mesh.triangles.push_back({ corners[0], corners[2], corners[3] });
    partOf.insert(partOf.end(), 2, part);
  };
  for (Index y = 0; y < 4; ++y)
  {
    for (Index x = 0; x < 7; ++x)
    {
      c.mesh.points.push_back({ 1.0 * x, 1.0 * y, 0.0 });
    }
    c.mesh.points.push_back({ 2.0, 1.0 * y, 1.0 });
    c.mesh.points.push_back({ 4.0, 1.0 * y, 1.0 });
  }
  constexpr Index row = 9;
  for (Index y = 0; y < 3; ++y)
  {
    for (Index x = 0; x < 6; ++x)
    {
      const Index corner = row * y + x;
      addCell({ corner, corner + 1, corner + row + 1, corner + row }, x / 2);
    }
    for (const Index fin : { 0U, 1U })
    {
      const Index foot = row * y + 2 + 2 * fin;
      const Index top = row * y + 7 + fin;
      addCell({ foot, foot + row, top + row, top }, 3 + fin);
    }
  }
  const MeshPoint source = { 16, { 0.5, 0.2, 0.3 } }; // in the row of cells in the middle
  c.curves = { { { { source.face, source.weights, source.weights } }, {} } };
  c.queries = { { 10, { 0.2, 0.5, 0.3 } }, { 26, { 0.3, 0.4, 0.3 } }, { 43, { 0.1, 0.3, 0.6 } } };
  for (std::uint64_t seed = 0; seed < 15; ++seed)
  {
    Random random(seed);
    std::array<int, 5> rankOfPart;
    std::generate(
      rankOfPart.begin(), rankOfPart.end(), [&]() { return static_cast<int>(random.below(3)); });
    CutMesh cut{ c.mesh, 3, {} };
    for (const std::size_t part : partOf)
    {
      cut.rankOfFace.push_back(rankOfPart[part]);
    }
    const std::vector<FoundPath> paths = pathsOver(c, cut);
    for (std::size_t i = 0; i < paths.size(); ++i)
    {
      EXPECT_FALSE(paths[i].wasLost) << "seed " << seed << ", target " << i;
      double length = 0.0;
      for (std::size_t k = 1; k < paths[i].places.size(); ++k)
      {
        length += spaceDistance(paths[i].places[k - 1], paths[i].places[k]);
      }
      EXPECT_NEAR(
        length, spaceDistance(position(c.mesh, source), position(c.mesh, c.queries[i])), 1e-12);
    }
  }
}

TEST_P(PathsOnRanks, AreShortestAndThoseOfOnePieceHoweverItIsCut)
{
  std::size_t compared = 0;
  std::size_t different = 0;
  for (std::uint64_t seed = 0; seed < MeshesOfAKind; ++seed)
  {
    CheckedPaths checked(GetParam(), seed);
    const RandomCase& c = checked.plain();
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    forEachCut(c.mesh, someWaysToCut(), random,
      [&](const CutMesh& cut)
      {
        const std::vector<FoundPath> paths = pathsOver(c, cut);
        for (std::size_t i = 0; i < paths.size(); ++i)
        {
          checked.check(i, paths[i]);
        }
      });
    compared += checked.compared();
    different += checked.different();
  }
  // Of equally long paths ranks may find another one.
  EXPECT_LE(different, compared / 10);
  std::cout << GetParam().name << ": of " << compared << " paths " << different
            << " are others than in one piece\n";
}

// Searches all paths as those that tracing has lost. The distance of a target may be short by
// rounding.
TEST_P(PathsOnRanks, InStripsAreShortest)
{
  CheckedPaths checked(GetParam(), 7);
  const RandomCase& c = checked.plain();
  Random random(7);
  const CutMesh cut = cutInSpace(c.mesh, 3, random);
  std::vector<std::size_t> numbers;
  std::vector<TargetAtDistance> targets;
  for (std::size_t i = 0; i < c.queries.size() && targets.size() < TargetsInStrips; ++i)
  {
    if (c.truth.queries[i] < geodesic::Infinity)
    {
      numbers.push_back(i);
      targets.push_back({ c.queries[i], (1.0 - 1e-12) * c.truth.queries[i] });
    }
  }
  const std::vector<FoundPath> paths = pathsInStrips(cut, c.curves, targets);
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    checked.check(numbers[i], paths[i]);
  }
  EXPECT_GT(checked.compared(), 0U);
}

TEST_P(PathsOnRanks, DoNotDependOnThreadsOrWhichRankComesFirst)
{
  const RandomCase c = randomCase(GetParam(), 82000, 20);
  Random random(1);
  const CutMesh cut = cutAtRandom(c.mesh, 3, random);
  const std::vector<FoundPath> ordered = pathsOver(c, cut);
  const std::vector<FoundPath> other = pathsOver(c, cut, 3, true);
  for (std::size_t i = 0; i < ordered.size(); ++i)
  {
    EXPECT_EQ(ordered[i].places, other[i].places) << "target " << i;
    EXPECT_EQ(ordered[i].source, other[i].source) << "target " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, PathsOnRanks, ::testing::ValuesIn(meshKinds()),
  [](const auto& kind) { return std::string(kind.param.name); });

// Triangles in a row that share only vertices: no window goes from one to the next. The known
// distances are short by rounding, by more than the margin of the bounds near the target, where the
// triangles are small.
TEST(PathsInStrips, RunAlongEdgesWhereNoWindowGoes)
{
  constexpr Index Length = 12;
  const auto place = [](Index i) { return i < 10 ? static_cast<double>(i) : 9.0 + 1e-4 * (i - 9); };
  PlainMesh mesh;
  for (Index i = 0; i <= Length; ++i)
  {
    mesh.points.push_back({ place(i), 0.0, 0.0 });
  }
  for (Index i = 0; i < Length; ++i)
  {
    const double size = place(i + 1) - place(i);
    mesh.points.push_back({ place(i) + 0.5 * size, size, 0.0 });
    mesh.triangles.push_back({ i, i + 1, Length + 1 + i });
  }
  const MeshPoint source = vertexPoint(mesh, 0);
  std::vector<TargetAtDistance> targets;
  for (const double along : { 0.5, 1.0 })
  {
    const MeshPoint target = { Length - 1, { 1.0 - along, along, 0.0 } };
    targets.push_back({ target, position(mesh, target)[0] * (1.0 - 1e-12) });
  }
  Random random(1);
  for (const int ranks : { 1, 3 })
  {
    const std::vector<FoundPath> paths = pathsInStrips(cutAtRandom(mesh, ranks, random),
      { { { { source.face, source.weights, source.weights } }, {} } }, targets);
    for (std::size_t i = 0; i < paths.size(); ++i)
    {
      SCOPED_TRACE(std::to_string(ranks) + " ranks, target " + std::to_string(i));
      const std::vector<geodesic::Vec3>& points = paths[i].places;
      ASSERT_EQ(points.size(), Length + 1U);
      EXPECT_LE(spaceDistance(plainPlace(points[0]), position(mesh, targets[i].point)), 1e-14);
      for (Index k = 1; k <= Length; ++k)
      {
        EXPECT_EQ(plainPlace(points[k]), mesh.points[Length - k]);
      }
    }
  }
}
