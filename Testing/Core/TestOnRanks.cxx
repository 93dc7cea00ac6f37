// SPDX-License-Identifier: BSD-3-Clause
// For every cut of a surface into ranks, in one process, the result is the one process's:
// distances, nearest sources, paths, isolines, refinement. That one process is right other tests
// show.
#include "RanksResults.h"
#include "contours/IsolineSupport.h"
#include "paths/PathChecker.h"
#include "refinement/RefinementSupport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

using namespace geodesictest;
using geodesic::Id;
using geodesic::TriangleMesh;

namespace
{

constexpr std::uint64_t MeshesOfAKind = meshesOfAKind(4);
/// So small that most faces are at a seam.
constexpr Index LeastFaces = 20;
constexpr Index MostFaces = 90;

/// A part of the faces, without single ones or all around some vertices: as beside barriers.
std::vector<Triangle> withoutSome(const PlainMesh& mesh, Random& random)
{
  const double share = random.uniform(0.02, 0.5);
  const bool areAroundVertices = random.chance(0.5);
  std::vector<bool> isMarked(mesh.points.size());
  for (std::size_t i = 0; i < isMarked.size(); ++i)
  {
    isMarked[i] = areAroundVertices && random.chance(0.3 * share);
  }
  std::vector<Triangle> left = { mesh.triangles.front() };
  for (std::size_t f = 1; f < mesh.triangles.size(); ++f)
  {
    const auto& [a, b, c] = mesh.triangles[f];
    const bool isTaken =
      areAroundVertices ? isMarked[a] || isMarked[b] || isMarked[c] : random.chance(share);
    if (!isTaken)
    {
      left.push_back(mesh.triangles[f]);
    }
  }
  return left;
}

bool isOriented(const TriangleMesh& mesh)
{
  for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
  {
    if (!mesh.isBoundary(halfedge) && mesh.acrossOriented(halfedge) == geodesic::NoId)
    {
      return false;
    }
  }
  return true;
}

/// Whether a curve goes back over itself: either side is right there.
bool goesBack(const std::vector<Polyline>& curves)
{
  std::set<std::tuple<Index, Barycentric, Barycentric>> segments;
  for (const Polyline& curve : curves)
  {
    for (const MeshSegment& s : curve.segments)
    {
      segments.emplace(s.face, s.from, s.to);
      if (!curve.isPoint() && segments.count({ s.face, s.to, s.from }) > 0)
      {
        return true;
      }
    }
  }
  return false;
}

/// A random scene, and what one process finds.
struct RandomScene : Scene
{
  TriangleMesh whole;
  geodesic::DistanceField field;
  double largest;
  double accuracy;
  std::vector<double> atQueries;
  bool hasHoles;
  /// Whether isolines and paths have sides: the faces have one orientation, and no curve goes back
  /// over itself.
  bool hasSides;

  /// \param withHoles takes some faces away. At a vertex where holes meet several lines may end.
  RandomScene(const MeshKind& kind, Random& random, bool withHoles = false)
    : Scene(make(kind, random, withHoles))
    , whole(engineMesh(mesh))
    , field(solveKeepingAll(whole, engineCurves(whole, curves)))
    , largest(largestFinite(field.vertexDistances()))
    , accuracy(accuracyOn(kind))
    , atQueries(valuesOf(field, queries).queries)
    , hasHoles(withHoles)
    , hasSides(isOriented(whole) && !goesBack(curves))
  {
    values = randomValues(field.vertexDistances(), largest, { 0.01, 0.3, 0.8 }, random);
    chordTolerance = 1e-4 * largest;
    tolerance = largest * random.uniform(0.005, 0.02);
  }
  CutMesh uncut() const { return { mesh, 1, std::vector<int>(mesh.triangles.size(), 0) }; }

private:
  static Scene make(const MeshKind& kind, Random& random, bool withHoles)
  {
    Scene scene;
    scene.mesh = kind.make(random.between(LeastFaces, MostFaces), random);
    if (withHoles)
    {
      scene.mesh.triangles = withoutSome(scene.mesh, random);
    }
    scene.curves = CurveMaker(scene.mesh, random).anySource();
    scene.queries = randomPoints(scene.mesh, 20, random);
    return scene;
  }
};

/// How many answers are others than those of one process: of equally long paths ranks may find
/// another one, and straight behind the end of a curve either side is right. An octahedron, whose
/// faces are all alike, has most of both.
struct Tally
{
  std::size_t compared = 0;
  std::size_t feet = 0;
  std::size_t directions = 0;
  std::size_t sides = 0;
  std::size_t paths = 0;
  std::size_t pathsCompared = 0;
  std::size_t lost = 0;

  void expectFew() const
  {
    EXPECT_LE(this->feet, this->compared / 50);
    EXPECT_LE(this->directions, this->compared / 20);
    EXPECT_LE(this->sides, this->compared / 50);
    EXPECT_LE(this->paths, this->pathsCompared / 10);
    EXPECT_LE(this->lost, this->pathsCompared / 50);
  }
};

double gapOf(const geodesic::Vec3& a, const geodesic::Vec3& b)
{
  return geodesic::norm(geodesic::operator-(a, b));
}

/// Compares what ranks find with one process.
class Comparison
{
public:
  Comparison(const RandomScene& scene, Tally& tally)
    : scene_(scene)
    , tally_(tally)
    , nearest_(nearestOnRanks(scene.uncut(), scene))
    , paths_(pathsOnRanks(scene.uncut(), scene))
    , lines_(linesOnRanks(scene.uncut(), scene, false))
  {
    if (scene.hasSides)
    {
      this->leftLines_ = linesOnRanks(scene.uncut(), scene, true);
    }
    for (Index vertex = 0; vertex < scene.mesh.points.size(); ++vertex)
    {
      const bool isReached = scene.field.vertexDistances()[vertex] < geodesic::Infinity;
      this->places_.push_back(isReached ? vertexPoint(scene.mesh, vertex) : MeshPoint());
    }
    this->places_.insert(this->places_.end(), scene.queries.begin(), scene.queries.end());
    this->distances_ = scene.field.vertexDistances();
    this->distances_.insert(this->distances_.end(), scene.atQueries.begin(), scene.atQueries.end());
  }

  void compareField(const CutMesh& cut) const
  {
    const FieldOnRanks result = fieldOnRanks(cut, this->scene_);
    EXPECT_LE(
      worstError(result.distances, this->scene_.field.vertexDistances(), this->scene_.largest),
      1e-12);
  }

  void compareNearest(const CutMesh& cut)
  {
    const std::vector<Nearest> answers = nearestOnRanks(cut, this->scene_);
    for (std::size_t i = 0; i < answers.size(); ++i)
    {
      SCOPED_TRACE("point " + std::to_string(i));
      this->compareNearest(i, answers[i]);
    }
  }

  void comparePaths(const CutMesh& cut)
  {
    const std::vector<FoundPath> paths = pathsOnRanks(cut, this->scene_);
    for (std::size_t i = 0; i < paths.size(); ++i)
    {
      this->comparePath(paths[i], i);
      this->tally_.lost += paths[i].wasLost && !this->paths_[i].wasLost ? 1 : 0;
    }
  }

  // The distance of a target may be short by rounding.
  void comparePathsInStrips(const CutMesh& cut)
  {
    Scene some = this->scene_;
    some.queries.clear();
    std::vector<double> distances;
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < this->scene_.queries.size() && numbers.size() < 3; ++i)
    {
      if (this->scene_.atQueries[i] < geodesic::Infinity)
      {
        numbers.push_back(i);
        some.queries.push_back(this->scene_.queries[i]);
        distances.push_back((1.0 - 1e-12) * this->scene_.atQueries[i]);
      }
    }
    const std::vector<FoundPath> paths = pathsInStrips(cut, some, distances);
    for (std::size_t i = 0; i < paths.size(); ++i)
    {
      this->comparePath(paths[i], numbers[i]);
    }
  }

  void compareLines(const CutMesh& cut, bool keepsAllWindows) const
  {
    Scene scene = this->scene_;
    scene.keepsAllWindows = keepsAllWindows;
    const std::vector<PlainLine> lines = linesOnRanks(cut, scene, false);
    for (std::size_t value = 0; value < scene.values.size(); ++value)
    {
      this->expectSameLength(lines, this->lines_, value);
      const LineCount joined = countJoined(lines, value);
      const LineCount expected = countJoined(this->lines_, value);
      EXPECT_TRUE(joined == expected || this->isCountOpen(scene.values[value]))
        << "value " << scene.values[value] << " of " << this->scene_.largest << ": " << joined.open
        << " open and " << joined.closed << " closed lines instead of " << expected.open << " and "
        << expected.closed;
    }
    for (const PlainLine& line : lines)
    {
      for (const double distance : valuesOf(this->scene_.field, line.points).queries)
      {
        EXPECT_NEAR(
          distance, scene.values[line.value], this->scene_.accuracy * this->scene_.largest);
      }
    }
    if (this->scene_.hasSides && !this->areSidesOpen_)
    {
      const std::vector<PlainLine> leftLines = linesOnRanks(cut, scene, true);
      for (std::size_t value = 0; value < scene.values.size(); ++value)
      {
        this->expectSameLength(leftLines, this->leftLines_, value);
      }
    }
  }

private:
  void compareNearest(std::size_t i, const Nearest& answer)
  {
    ASSERT_EQ(answer.isKnown, this->distances_[i] < geodesic::Infinity);
    if (!answer.isKnown)
    {
      return;
    }
    const double largest = this->scene_.largest;
    const bool isOff = this->distances_[i] > 1e-9 * largest;
    const double size = geodesic::norm(answer.gradient);
    EXPECT_TRUE(!isOff || std::abs(size - 1.0) <= 1e-14) << "gradient of length " << size;
    ++this->tally_.compared;
    const Nearest& one = this->nearest_[i];
    const double turned = isOff ? gapOf(answer.gradient, one.gradient) : 0.0;
    this->tally_.directions += turned > 1e-6 ? 1 : 0;
    if (answer.curve != one.curve || spaceDistance(answer.place, one.place) > 1e-6 * largest)
    {
      ++this->tally_.feet;
      this->expectAsFar(i, answer);
    }
    else if (this->scene_.hasSides && isOff && turned <= 1e-9 && answer.isRight != one.isRight)
    {
      ++this->tally_.sides;
      this->areSidesOpen_ = true;
    }
  }

  // The distance from the foot alone is the field's, and so is that from the curve.
  void expectAsFar(std::size_t i, const Nearest& answer) const
  {
    const Polyline foot = { { { answer.foot.face, answer.foot.weights, answer.foot.weights } },
      {} };
    for (const Polyline& source : { foot, this->scene_.curves[answer.curve] })
    {
      const TriangleMesh& whole = this->scene_.whole;
      const double distance =
        valuesOf(solveKeepingAll(whole, { engineCurve(whole, source) }), { this->places_[i] })
          .queries[0];
      EXPECT_LE(
        std::abs(distance - this->distances_[i]), this->scene_.accuracy * this->scene_.largest)
        << "curve " << answer.curve;
    }
  }

  void comparePath(const FoundPath& path, std::size_t i)
  {
    SCOPED_TRACE("target " + std::to_string(i));
    const double distance = this->scene_.atQueries[i];
    ASSERT_EQ(path.places.empty(), !(distance < geodesic::Infinity));
    if (path.places.empty())
    {
      return;
    }
    const double slack = this->scene_.accuracy * this->scene_.largest;
    double length = 0.0;
    for (std::size_t k = 1; k < path.places.size(); ++k)
    {
      length += gapOf(path.places[k], path.places[k - 1]);
      // Its ends may lie within rounding of a vertex or an edge that the path passes.
      EXPECT_TRUE(path.places[k] != path.places[k - 1] || k == 1 || k + 1 == path.places.size())
        << "point " << k << " repeats the last one";
    }
    EXPECT_NEAR(length, distance, slack);
    EXPECT_LE(
      spaceDistance(path.places.front(), position(this->scene_.mesh, this->scene_.queries[i])),
      slack);
    ASSERT_LT(path.source, this->scene_.curves.size());
    EXPECT_LE(distanceInSpace(this->scene_.mesh, path.places.back(),
                toSources({ this->scene_.curves[path.source] })),
      slack);
    const FoundPath& one = this->paths_[i];
    bool isSame = one.source == path.source && one.places.size() == path.places.size();
    for (std::size_t k = 0; k < one.places.size() && isSame; ++k)
    {
      isSame = gapOf(one.places[k], path.places[k]) <= 1e-6;
    }
    ++this->tally_.pathsCompared;
    this->tally_.paths += isSame ? 0 : 1;
  }

  // Roundings decide whether a line goes through a vertex or around it. Where holes meet at a
  // vertex more than two lines may end.
  bool isCountOpen(double value) const
  {
    const std::vector<double>& distances = this->scene_.field.vertexDistances();
    return this->scene_.hasHoles ||
      std::any_of(distances.begin(), distances.end(),
        [&](double d) { return std::abs(d - value) <= 1e-12 * this->scene_.largest; });
  }

  static double lengthOf(const std::vector<PlainLine>& lines, std::size_t value)
  {
    double length = 0.0;
    for (const PlainLine& line : lines)
    {
      for (std::size_t i = 1; i < line.places.size() && line.value == value; ++i)
      {
        length += spaceDistance(line.places[i], line.places[i - 1]);
      }
    }
    return length;
  }

  // Ranks may cut windows, and so arcs into chords, at other places.
  void expectSameLength(const std::vector<PlainLine>& lines, const std::vector<PlainLine>& whole,
    std::size_t value) const
  {
    EXPECT_NEAR(lengthOf(lines, value), lengthOf(whole, value), 1e-4 * this->scene_.largest)
      << "value " << value;
  }

  // Lines are joined where exactly two ends have the same coordinates.
  static LineCount countJoined(const std::vector<PlainLine>& lines, std::size_t value)
  {
    std::map<Vec3, std::vector<std::size_t>> linesAt;
    std::vector<std::size_t> group(lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
      group[i] = i;
      if (lines[i].value == value)
      {
        linesAt[lines[i].places.front()].push_back(i);
        linesAt[lines[i].places.back()].push_back(i);
      }
    }
    const auto root = [&](std::size_t i)
    {
      while (group[i] != i)
      {
        i = group[i];
      }
      return i;
    };
    for (const auto& [place, at] : linesAt)
    {
      if (at.size() == 2)
      {
        group[root(at[0])] = root(at[1]);
      }
    }
    std::map<std::size_t, bool> isOpen;
    for (const auto& [place, at] : linesAt)
    {
      for (const std::size_t i : at)
      {
        bool& open = isOpen[root(i)];
        open = open || at.size() != 2;
      }
    }
    LineCount count;
    for (const auto& [line, open] : isOpen)
    {
      ++(open ? count.open : count.closed);
    }
    return count;
  }

  const RandomScene& scene_;
  Tally& tally_;
  std::vector<Nearest> nearest_;
  std::vector<FoundPath> paths_;
  std::vector<PlainLine> lines_;
  std::vector<PlainLine> leftLines_;
  std::vector<MeshPoint> places_;
  std::vector<double> distances_;
  /// Whether one process and the ranks have chosen different sides somewhere.
  bool areSidesOpen_ = false;
};

/// Checks a refinement over ranks: it is one surface, and its interpolant differs from the distance
/// by no more than it says, in faces that have exact values.
Joined expectRefined(const CutMesh& cut, const RandomScene& scene, Random& random,
  const std::vector<bool>* complete = nullptr)
{
  const Joined joined = refineOnRanks(cut, scene);
  EXPECT_TRUE(joined.refined.errorBound <= scene.tolerance || joined.refined.stoppedAtMaximum);
  EXPECT_LE(joined.relativeErrorBound, scene.relativeError);
  expectFitTogether(scene.whole, joined);
  const double slack = EngineAccuracy * scene.largest;
  const bool isExact = joined.relativeErrorBound == 0.0;
  for (const geodesic::RefinedPoint& point : joined.refined.points)
  {
    const bool isRight = std::abs(point.distance - scene.field.distance(point.place)) <=
      scene.accuracy * scene.largest;
    EXPECT_TRUE(isRight || !isExact || complete) << point.distance;
  }
  Samples samples = samplesOf(scene.whole, joined, 300, random);
  samples = complete ? samplesIn(samples, *complete) : samples;
  const std::vector<double> truth = valuesOf(scene.field, samples.places).queries;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    const double value = samples.interpolant[i];
    const double bound = joined.refined.errorBound + joined.relativeErrorBound * truth[i] + slack;
    EXPECT_TRUE(value == truth[i] || std::abs(value - truth[i]) <= bound)
      << value << " in place of " << truth[i];
  }
  return joined;
}

class OnRanks : public ::testing::TestWithParam<MeshKind>
{
};

}

TEST_P(OnRanks, TheResultIsThatOfOneProcessHoweverTheSurfaceIsCut)
{
  Tally tally;
  std::size_t toldFaces = 0;
  std::size_t sharedPoints = 0;
  for (std::uint64_t seed = 0; seed < MeshesOfAKind; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed + 79000);
    const RandomScene scene(GetParam(), random, seed + 1 == MeshesOfAKind);
    if (!(scene.largest > 0.0))
    {
      continue; // the source goes through all vertices
    }
    Comparison comparison(scene, tally);
    forEachCut(scene.mesh, someWaysToCut(), random,
      [&](const CutMesh& cut)
      {
        comparison.compareField(cut);
        comparison.compareNearest(cut);
        comparison.comparePaths(cut);
        comparison.compareLines(cut, cut.numberOfRanks == 3);
        if (cut.numberOfRanks == 3)
        {
          comparison.comparePathsInStrips(cut);
        }
        const Joined joined = expectRefined(cut, scene, random);
        EXPECT_FALSE(joined.refined.stoppedAtMaximum);
        toldFaces += joined.toldFaces;
        sharedPoints += joined.sharedPoints;
      });
  }
  tally.expectFew();
  EXPECT_GT(tally.compared, 0U);
  EXPECT_GT(toldFaces, 0U);
  EXPECT_GT(sharedPoints, 0U);
}

TEST_P(OnRanks, FrontsStopAtALimitWhereOneProcessDoes)
{
  for (std::uint64_t seed = 0; seed < MeshesOfAKind; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed + 400);
    RandomScene scene(GetParam(), random, seed + 1 == MeshesOfAKind);
    scene.maximumDistance = 0.3 * scene.largest;
    const FieldOnRanks one = fieldOnRanks(scene.uncut(), scene);
    const std::vector<bool> complete = completeFaces(solveKeepingAll(
      scene.whole, engineCurves(scene.whole, scene.curves), 0.0, scene.maximumDistance));
    forEachCut(scene.mesh, { { 2, true }, { 4, false }, { 7, true } }, random,
      [&](const CutMesh& cut)
      {
        const FieldOnRanks many = fieldOnRanks(cut, scene);
        EXPECT_LE(worstError(many.distances, one.distances, scene.largest), 1e-12);
        const Joined joined = expectRefined(cut, scene, random, &complete);
        expectLeftAsTheyAre(scene.whole, joined.refined, complete);
      });
  }
}

TEST_P(OnRanks, ApproximateFieldsKeepTheCertifiedBound)
{
  for (Random& random : EachSeed(meshesOfAKind(2), 500))
  {
    RandomScene scene(GetParam(), random);
    scene.relativeError = 0.01;
    const double rounding = scene.accuracy * scene.largest;
    forEachCut(scene.mesh, { { 2, true }, { 7, false } }, random,
      [&](const CutMesh& cut)
      {
        const FieldOnRanks result = fieldOnRanks(cut, scene);
        EXPECT_LE(result.relativeErrorBound, scene.relativeError);
        for (std::size_t i = 0; i < result.distances.size(); ++i)
        {
          const double truth = scene.field.vertexDistances()[i];
          const double least = truth * (1.0 - result.relativeErrorBound) - rounding;
          EXPECT_TRUE(result.distances[i] >= least && result.distances[i] <= truth + rounding)
            << "vertex " << i;
        }
        expectRefined(cut, scene, random);
      });
  }
}

TEST_P(OnRanks, RefinementStopsAtAMaximumOfAllRanksTogether)
{
  Random random(600);
  RandomScene scene(GetParam(), random);
  // As needs more room than there is, but not a thousand times as much; needles need less.
  const bool isThin = scene.accuracy > OrdinaryAccuracy;
  scene.tolerance = (isThin ? 1e-6 : 1e-4) * scene.largest;
  const auto faces = static_cast<std::uint64_t>(scene.whole.numberOfFaces());
  scene.maximumFaces = 3 * faces;
  forEachCut(scene.mesh, { { 2, false }, { 7, true } }, random,
    [&](const CutMesh& cut)
    {
      const Joined joined = expectRefined(cut, scene, random);
      EXPECT_TRUE(joined.refined.stoppedAtMaximum);
      EXPECT_LE(joined.refined.triangles.size(), scene.maximumFaces);
      // The size for the next tolerance is unknown, so at least half of the limit is used.
      EXPECT_GE(joined.refined.triangles.size(), 2 * faces);
    });
}

TEST_P(OnRanks, NothingDependsOnThreadsOrOnWhichRankComesFirst)
{
  Random random(700);
  RandomScene scene(GetParam(), random);
  const CutMesh cut = cutAtRandom(scene.mesh, 4, random);
  const FieldOnRanks field = fieldOnRanks(cut, scene);
  const std::vector<FoundPath> paths = pathsOnRanks(cut, scene);
  scene.hasThreads = true;
  for (const std::uint64_t maximumFaces : { 0U, 400U })
  {
    scene.disorder = 0;
    scene.maximumFaces = maximumFaces;
    const geodesic::RefinedMesh refined = refineOnRanks(cut, scene).refined;
    for (const std::uint64_t disorder : { 1U, 2U })
    {
      scene.disorder = disorder;
      const FieldOnRanks otherField = fieldOnRanks(cut, scene);
      EXPECT_EQ(otherField.distances, field.distances);
      EXPECT_EQ(otherField.windowsPropagated, field.windowsPropagated);
      const std::vector<FoundPath> otherPaths = pathsOnRanks(cut, scene);
      for (std::size_t i = 0; i < paths.size(); ++i)
      {
        EXPECT_EQ(otherPaths[i].places, paths[i].places) << "target " << i;
        EXPECT_EQ(otherPaths[i].source, paths[i].source) << "target " << i;
      }
      const geodesic::RefinedMesh other = refineOnRanks(cut, scene).refined;
      EXPECT_EQ(other.triangles, refined.triangles);
      EXPECT_EQ(other.faces, refined.faces);
      EXPECT_EQ(other.errorBound, refined.errorBound);
      EXPECT_EQ(other.stoppedAtMaximum, refined.stoppedAtMaximum);
      EXPECT_TRUE(std::equal(other.points.begin(), other.points.end(), refined.points.begin(),
        refined.points.end(),
        [](const geodesic::RefinedPoint& a, const geodesic::RefinedPoint& b)
        { return a.position == b.position && a.distance == b.distance; }));
    }
  }
}

// The last bits differ where two paths have the same length, or three lists meet on an edge.
TEST(BitsOnRanks, OfNearlyAllFieldsAndOfMostRefinedSurfacesAreThoseOfOneProcess)
{
  const auto pointsOf = [](const Joined& joined)
  {
    std::set<std::pair<geodesic::Vec3, double>> points;
    for (const geodesic::RefinedPoint& point : joined.refined.points)
    {
      points.emplace(point.position, point.distance);
    }
    return points;
  };
  std::size_t scenes = 0;
  std::size_t sameFields = 0;
  std::size_t sameSurfaces = 0;
  for (const MeshKind& kind : meshKinds())
  {
    for (Random& random : EachSeed(meshesOfAKind(5), 800))
    {
      const RandomScene scene(kind, random);
      const CutMesh cut = cutAtRandom(scene.mesh, 3, random);
      const bool isSame =
        fieldOnRanks(cut, scene).distances == fieldOnRanks(scene.uncut(), scene).distances;
      sameFields += isSame ? 1 : 0;
      const Joined one = refineOnRanks(scene.uncut(), scene);
      const Joined other = refineOnRanks(cut, scene);
      const bool isSameSurface = other.refined.triangles.size() == one.refined.triangles.size() &&
        pointsOf(other) == pointsOf(one);
      sameSurfaces += isSameSurface ? 1 : 0;
      ++scenes;
    }
  }
  EXPECT_GE(20 * sameFields, 19 * scenes) << sameFields << " of " << scenes;
  EXPECT_GE(20 * sameSurfaces, 17 * scenes) << sameSurfaces << " of " << scenes;
}

INSTANTIATE_TEST_SUITE_P(Kinds, OnRanks, ::testing::ValuesIn(meshKinds()),
  [](const auto& kind) { return std::string(kind.param.name); });
