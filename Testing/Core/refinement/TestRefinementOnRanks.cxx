// SPDX-License-Identifier: BSD-3-Clause
// Refinement over several ranks in one process: the parts of all ranks fit together, and the
// certified bound holds for the whole.
#include "RanksSupport.h"
#include "refinement/RefinementSupport.h"
#include "truth/MeshFiles.h"

#include "refinement/RefinedOnRanks.h"
#include "refinement/SolveForRefinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <mutex>
#include <tuple>

using namespace geodesictest;
using geodesic::DistanceField;
using geodesic::Id;
using geodesic::RefinedMesh;
using geodesic::RefinedPoint;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

/// The input of a refinement.
struct Task
{
  const PlainMesh& mesh;
  const std::vector<Polyline>& curves;
  double tolerance;
  std::uint64_t maximumFaces = 0;
  geodesic::FrontOptions front = {};
};

/// The parts of all ranks, put together.
struct Joined
{
  std::vector<double> vertexDistances;
  RefinedMesh refined;
  double relativeErrorBound = 0.0;
};

/// Joins refined parts. Points of two ranks are one if they are on the same edge and have the same
/// place along it, the same coordinates and the same distance, to the last bit: where any of these
/// differ, the surface comes apart.
class Joiner
{
public:
  Joiner(const TriangleMesh& whole, Joined& joined)
    : whole_(whole)
    , joined_(joined)
  {
    this->joined_.refined.numberOfInputPoints = whole.numberOfVertices();
    this->joined_.vertexDistances.assign(whole.numberOfVertices(), geodesic::Infinity);
  }

  void add(const RankOfRun& rank, const DistanceField& field, const RefinedMesh& refined)
  {
    EXPECT_EQ(refined.numberOfInputPoints, rank.part.numberOfOwnVertices());
    for (std::size_t i = 0; i < rank.wholeVertices.size(); ++i)
    {
      this->joined_.vertexDistances[rank.wholeVertices[i]] = field.vertexDistances()[i];
    }
    std::map<Id, Id> wholeFaceOf;
    for (Id face = rank.part.firstOwnFace(); face < rank.part.endOfOwnFaces(); ++face)
    {
      wholeFaceOf[face] = static_cast<Id>(rank.wholeFaces[rank.part.triangleOf(face)]);
    }
    std::vector<Id> numbers(rank.wholeVertices.begin(), rank.wholeVertices.end());
    for (RefinedPoint point : refined.points)
    {
      point.parents = { numbers[point.parents[0]], numbers[point.parents[1]] };
      point.place = this->placeInWhole(rank, wholeFaceOf, point.place);
      numbers.push_back(this->numberOf(point));
    }
    for (std::size_t i = 0; i < refined.triangles.size(); ++i)
    {
      const geodesic::Triangle& t = refined.triangles[i];
      this->triangles_.push_back(
        { wholeFaceOf.at(refined.faces[i]), { numbers[t[0]], numbers[t[1]], numbers[t[2]] } });
    }
    this->ofRanks_.push_back({ refined.errorBound, refined.stoppedAtMaximum });
    this->joined_.relativeErrorBound = field.relativeErrorBound();
  }

  void finish()
  {
    const auto byFace = [](const Part& a, const Part& b) { return a.face < b.face; };
    std::stable_sort(this->triangles_.begin(), this->triangles_.end(), byFace);
    for (const Part& part : this->triangles_)
    {
      this->joined_.refined.faces.push_back(part.face);
      this->joined_.refined.triangles.push_back(part.corners);
    }
    for (const OfRank& rank : this->ofRanks_)
    {
      EXPECT_EQ(rank.errorBound, this->ofRanks_.front().errorBound);
      EXPECT_EQ(rank.stoppedAtMaximum, this->ofRanks_.front().stoppedAtMaximum);
    }
    this->joined_.refined.errorBound = this->ofRanks_.front().errorBound;
    this->joined_.refined.stoppedAtMaximum = this->ofRanks_.front().stoppedAtMaximum;
  }

private:
  struct Part
  {
    Id face;
    geodesic::Triangle corners;
  };
  struct OfRank
  {
    double errorBound;
    bool stoppedAtMaximum;
  };

  SurfacePoint placeInWhole(
    const RankOfRun& rank, const std::map<Id, Id>& wholeFaceOf, const SurfacePoint& place) const
  {
    if (place.kind == SurfacePoint::Kind::Face)
    {
      return SurfacePoint::inFace(wholeFaceOf.at(place.id), place.u, place.v);
    }
    const TriangleMesh& mesh = rank.part.mesh();
    const auto a = static_cast<Id>(rank.wholeVertices.at(mesh.origin(place.id)));
    const auto b = static_cast<Id>(rank.wholeVertices.at(mesh.destination(place.id)));
    const Id halfedge = this->whole_.halfedgeBetween(a, b);
    return SurfacePoint::onEdge(
      halfedge, this->whole_.origin(halfedge) == a ? place.u : 1.0 - place.u);
  }

  Id numberOf(const RefinedPoint& point)
  {
    const Id next =
      this->whole_.numberOfVertices() + static_cast<Id>(this->joined_.refined.points.size());
    // Inside faces no point belongs to two ranks, but two points may coincide in a flat part.
    const Id element =
      point.place.kind == SurfacePoint::Kind::Face ? point.place.id : geodesic::NoId;
    const auto found = this->numbers_.try_emplace(
      Key{ point.parents, point.weight, point.position, point.distance, element }, next);
    if (found.second)
    {
      this->joined_.refined.points.push_back(point);
    }
    return found.first->second;
  }

  using Key = std::tuple<std::array<Id, 2>, double, geodesic::Vec3, double, Id>;

  const TriangleMesh& whole_;
  Joined& joined_;
  std::map<Key, Id> numbers_;
  std::vector<Part> triangles_;
  std::vector<OfRank> ofRanks_;
};

Joined refineOnRanks(const CutMesh& cut, const Task& task, std::uint64_t disorder = 0)
{
  const TriangleMesh whole = engineMesh(task.mesh);
  Joined joined;
  Joiner joiner(whole, joined);
  std::mutex mutex;
  onRanks(cut, task.curves, disorder,
    [&](const RankOfRun& rank)
    {
      geodesic::FrontOptions front = task.front;
      const DistanceField field =
        solveForRefinement(rank.part, rank.sources, task.tolerance, front);
      geodesic::RefinementOptions options;
      options.tolerance = task.tolerance;
      options.maximumFaces = task.maximumFaces;
      const RefinedMesh refined = refine(field, options);
      for (int turn = 0; turn < rank.exchange.numberOfRanks(); ++turn)
      {
        if (turn == rank.exchange.rank())
        {
          const std::lock_guard<std::mutex> lock(mutex);
          joiner.add(rank, field, refined);
        }
        rank.exchange.isTrueAnywhere(false);
      }
    });
  joiner.finish();
  return joined;
}

/// Checks that the joined parts are one surface, which is the input's.
void expectFitTogether(const TriangleMesh& whole, const Joined& joined)
{
  geodesic::FrontResult front;
  front.vertexDistances = joined.vertexDistances;
  const DistanceField field(geodesic::MeshPartition(whole), front, {});
  const Points points(field, joined.refined);
  expectFacesPartitioned(whole, joined.refined, points);
  expectWatertight(whole, joined.refined, points);
}

Samples samplesOf(
  const TriangleMesh& whole, const Joined& joined, std::size_t count, Random& random)
{
  geodesic::FrontResult front;
  front.vertexDistances = joined.vertexDistances;
  return sample(
    DistanceField(geodesic::MeshPartition(whole), front, {}), joined.refined, count, random);
}

void expectSame(const RefinedMesh& a, const RefinedMesh& b)
{
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.faces, b.faces);
  EXPECT_EQ(a.errorBound, b.errorBound);
  EXPECT_EQ(a.stoppedAtMaximum, b.stoppedAtMaximum);
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i)
  {
    EXPECT_EQ(a.points[i].position, b.points[i].position);
    EXPECT_EQ(a.points[i].distance, b.points[i].distance);
  }
}

class RefinementOnRanks : public ::testing::TestWithParam<MeshKind>
{
protected:
  /// A mesh with sources of the kind, of moderate size.
  struct Case
  {
    PlainMesh mesh;
    std::vector<Polyline> curves;
    double largest;
  };
  static Case makeCase(Random& random)
  {
    Case c;
    c.mesh = GetParam().make(random.between(50, 150), random);
    CurveMaker maker(c.mesh, random);
    c.curves = maker.anySource();
    c.largest = largestFinite(bruteForceDistances(c.mesh, toSources(c.curves)).vertices);
    return c;
  }
};

}

TEST_P(RefinementOnRanks, FitsTogetherAndIsNowhereOverTheToleranceHoweverItIsCut)
{
  constexpr std::uint64_t meshes = 2;
  constexpr std::size_t samples = 500;
  std::size_t triangles = 0;
  std::size_t trianglesInOnePiece = 0;
  for (std::uint64_t seed = 0; seed < meshes; ++seed)
  {
    Random random(seed + 300);
    const Case c = makeCase(random);
    const TriangleMesh whole = engineMesh(c.mesh);
    const Task task = { c.mesh, c.curves, c.largest * random.uniform(0.003, 0.02) };
    const RefinedMesh inOnePiece = refineTo(
      solveForRefinement(whole, engineCurves(whole, c.curves), task.tolerance), task.tolerance);
    SCOPED_TRACE("seed " + std::to_string(seed));
    forEachCut(c.mesh, bothWaysToCut({ 1, 2, 3, 4, 7 }), random,
      [&](const CutMesh& cut)
      {
        const Joined joined = refineOnRanks(cut, task);
        EXPECT_FALSE(joined.refined.stoppedAtMaximum);
        EXPECT_LE(joined.refined.errorBound, task.tolerance);
        expectFitTogether(whole, joined);
        expectRefinedPointsRight(
          whole, joined.refined, c.mesh, toSources(c.curves), accuracyOn(GetParam()) * c.largest);
        const Samples there = samplesOf(whole, joined, samples, random);
        const BruteForceResult truth =
          bruteForceDistances(c.mesh, toSources(c.curves), there.places);
        EXPECT_LE(largestDifference(there, truth.queries),
          joined.refined.errorBound + EngineAccuracy * c.largest);
        triangles += joined.refined.triangles.size();
        trianglesInOnePiece += inOnePiece.triangles.size();
      });
  }
  std::cout << GetParam().name << ": "
            << static_cast<double>(triangles) / static_cast<double>(trianglesInOnePiece)
            << " times the triangles of one piece\n";
}

TEST_P(RefinementOnRanks, LeavesWhatIsBeyondALimitAsItIs)
{
  Random random(400);
  const Case c = makeCase(random);
  const TriangleMesh whole = engineMesh(c.mesh);
  Task task = { c.mesh, c.curves, 0.005 * c.largest };
  task.front.maximumDistance = 0.3 * c.largest;
  const std::vector<bool> complete = completeFaces(
    solveKeepingAll(whole, engineCurves(whole, c.curves), 0.0, task.front.maximumDistance));
  forEachCut(c.mesh, bothWaysToCut({ 2, 3, 7 }), random,
    [&](const CutMesh& cut)
    {
      const Joined joined = refineOnRanks(cut, task);
      EXPECT_LE(joined.refined.errorBound, task.tolerance);
      expectFitTogether(whole, joined);
      expectLeftAsTheyAre(whole, joined.refined, complete);
      const Samples there = samplesIn(samplesOf(whole, joined, 500, random), complete);
      const BruteForceResult truth = bruteForceDistances(c.mesh, toSources(c.curves), there.places);
      EXPECT_LE(largestDifference(there, truth.queries),
        joined.refined.errorBound + EngineAccuracy * c.largest);
    });
}

TEST_P(RefinementOnRanks, OfAnApproximateFieldMeetsTheTolerance)
{
  Random random(500);
  const Case c = makeCase(random);
  const TriangleMesh whole = engineMesh(c.mesh);
  Task task = { c.mesh, c.curves, 0.01 * c.largest };
  task.front.relativeError = 0.01;
  forEachCut(c.mesh, bothWaysToCut({ 2, 4, 7 }), random,
    [&](const CutMesh& cut)
    {
      const Joined joined = refineOnRanks(cut, task);
      EXPECT_LE(joined.refined.errorBound, task.tolerance);
      EXPECT_LE(joined.relativeErrorBound, task.front.relativeError);
      expectFitTogether(whole, joined);
      const Samples there = samplesOf(whole, joined, 500, random);
      const BruteForceResult truth = bruteForceDistances(c.mesh, toSources(c.curves), there.places);
      for (std::size_t i = 0; i < truth.queries.size(); ++i)
      {
        const double bound =
          joined.refined.errorBound + joined.relativeErrorBound * truth.queries[i];
        const double value = there.interpolant[i];
        EXPECT_TRUE(value == truth.queries[i] ||
          std::abs(value - truth.queries[i]) <= bound + EngineAccuracy * c.largest)
          << value << " in place of " << truth.queries[i];
      }
    });
}

TEST_P(RefinementOnRanks, StopsAtAMaximumOfAllRanksTogether)
{
  Random random(600);
  const Case c = makeCase(random);
  const TriangleMesh whole = engineMesh(c.mesh);
  Task task = { c.mesh, c.curves, 1e-6 * c.largest };
  const auto faces = static_cast<std::uint64_t>(whole.numberOfFaces());
  task.maximumFaces = 3 * faces;
  const double inOnePiece =
    refineTo(solveForRefinement(whole, engineCurves(whole, c.curves), task.tolerance),
      task.tolerance, task.maximumFaces)
      .errorBound;
  double largestRatio = 0.0;
  forEachCut(c.mesh, { { 2, false }, { 7, true } }, random,
    [&](const CutMesh& cut)
    {
      const Joined joined = refineOnRanks(cut, task);
      EXPECT_TRUE(joined.refined.stoppedAtMaximum);
      EXPECT_LE(joined.refined.triangles.size(), task.maximumFaces);
      // The size for the next tolerance is unknown, so at least half of the limit is used.
      EXPECT_GE(joined.refined.triangles.size(), 2 * faces);
      expectFitTogether(whole, joined);
      const Samples there = samplesOf(whole, joined, 500, random);
      const BruteForceResult truth = bruteForceDistances(c.mesh, toSources(c.curves), there.places);
      EXPECT_LE(largestDifference(there, truth.queries),
        joined.refined.errorBound + EngineAccuracy * c.largest);
      largestRatio = std::max(largestRatio, joined.refined.errorBound / inOnePiece);
    });
  std::cout << GetParam().name << ": at most " << largestRatio << " times the bound of one piece\n";
}

TEST_P(RefinementOnRanks, DoesNotDependOnWhichRankComesFirst)
{
  Random random(700);
  const Case c = makeCase(random);
  const TriangleMesh whole = engineMesh(c.mesh);
  Task task = { c.mesh, c.curves, 0.01 * c.largest };
  for (const std::uint64_t maximumFaces : { 0U, 400U })
  {
    task.maximumFaces = maximumFaces;
    const CutMesh cut = cutAtRandom(c.mesh, 4, random);
    const RefinedMesh ordered = refineOnRanks(cut, task).refined;
    for (const std::uint64_t disorder : { 1U, 2U })
    {
      expectSame(refineOnRanks(cut, task, disorder).refined, ordered);
    }
  }
}

namespace
{

/// A triangle by its place in space, with the global numbers of corners that are vertices and the
/// distances of the others.
using Placed = std::array<std::pair<geodesic::Vec3, double>, 3>;
using PlacedFaces = std::map<geodesic::RankAddress, std::vector<Placed>>;

std::pair<geodesic::Vec3, double> placeOfVertex(const geodesic::MeshPartition& part, Id vertex)
{
  return { part.mesh().point(vertex), part.globalId(vertex) };
}

/// The faces that a rank owns.
void addOwn(const RankOfRun& rank, const RefinedMesh& refined, PlacedFaces& faces)
{
  const auto placeOf = [&](Id point) -> std::pair<geodesic::Vec3, double>
  {
    if (point < refined.numberOfInputPoints)
    {
      return placeOfVertex(rank.part, point);
    }
    const RefinedPoint& added = refined.points[point - refined.numberOfInputPoints];
    return { added.position, added.distance };
  };
  for (std::size_t i = 0; i < refined.triangles.size(); ++i)
  {
    const geodesic::Triangle& t = refined.triangles[i];
    faces[{ rank.exchange.rank(), refined.faces[i] }].push_back(
      { placeOf(t[0]), placeOf(t[1]), placeOf(t[2]) });
  }
}

/// The faces of other ranks around those that a rank owns.
PlacedFaces findOthers(const RankOfRun& rank, const RefinedMesh& refined)
{
  std::vector<geodesic::RankAddress> addresses;
  for (Id face = 0; face < rank.part.mesh().numberOfFaces(); ++face)
  {
    if (!rank.part.isOwn(face))
    {
      addresses.push_back(rank.part.ownerOf(face));
    }
  }
  const std::vector<geodesic::RefinedFace> answers =
    findRefinedFaces(addresses, rank.part, refined, {});
  PlacedFaces faces;
  for (std::size_t i = 0; i < addresses.size(); ++i)
  {
    const geodesic::Triangle& corners = rank.part.mesh().triangle(rank.part.copyOf(addresses[i]));
    const auto placeOf = [&](Id point) -> std::pair<geodesic::Vec3, double>
    {
      if (point < 3)
      {
        return placeOfVertex(rank.part, corners[point]);
      }
      const RefinedPoint& added = answers[i].points[point - 3];
      return { added.position, added.distance };
    };
    for (const geodesic::Triangle& t : answers[i].triangles)
    {
      faces[addresses[i]].push_back({ placeOf(t[0]), placeOf(t[1]), placeOf(t[2]) });
    }
  }
  return faces;
}

}

TEST_P(RefinementOnRanks, TellsHowFacesOfOtherRanksAreRefined)
{
  Random random(800);
  const Case c = makeCase(random);
  const CutMesh cut = cutInSpace(c.mesh, 3, random);
  PlacedFaces own;
  PlacedFaces others;
  std::mutex mutex;
  onRanks(cut, c.curves, 0,
    [&](const RankOfRun& rank)
    {
      geodesic::FrontOptions front;
      geodesic::RefinementOptions options;
      options.tolerance = 0.01 * c.largest;
      const DistanceField field =
        solveForRefinement(rank.part, rank.sources, options.tolerance, front);
      const RefinedMesh refined = refine(field, options);
      const PlacedFaces found = findOthers(rank, refined);
      const std::lock_guard<std::mutex> lock(mutex);
      addOwn(rank, refined, own);
      others.insert(found.begin(), found.end());
    });
  EXPECT_FALSE(others.empty());
  for (const auto& [address, triangles] : others)
  {
    EXPECT_EQ(triangles, own.at(address));
  }
}

namespace
{

/// A point that a rank has added to an edge, and the point that the rank stores it as.
struct PointOnEdge
{
  geodesic::RankAddress own;
  geodesic::RankAddress taken;
  bool isKnown;
};
/// Keys are the global ends of the edge and the place in space: refined parts fit together, so they
/// are equal on all ranks.
using PointsOnEdges =
  std::map<std::tuple<std::size_t, std::size_t, geodesic::Vec3>, std::vector<PointOnEdge>>;

void addPointsOnEdges(const RankOfRun& rank, const DistanceField& field, const RefinedMesh& refined,
  const geodesic::SeamPoints& seams, PointsOnEdges& points)
{
  std::vector<geodesic::RankAddress> taken;
  for (Id i = 0; i < refined.points.size(); ++i)
  {
    taken.push_back({ rank.exchange.rank(), i });
  }
  for (std::size_t i = 0; i < seams.here.size(); ++i)
  {
    taken[seams.here[i]] = seams.there[i];
  }
  for (Id i = 0; i < refined.points.size(); ++i)
  {
    const SurfacePoint& place = refined.points[i].place;
    if (place.kind == SurfacePoint::Kind::Edge)
    {
      const auto ends = std::minmax(rank.wholeVertices.at(rank.part.mesh().origin(place.id)),
        rank.wholeVertices.at(rank.part.mesh().destination(place.id)));
      bool isKnown = false;
      forEachFace(rank.part.mesh(), place,
        [&](Id face) { isKnown = isKnown || (rank.part.isOwn(face) && field.knowsInside(face)); });
      points[{ ends.first, ends.second, refined.points[i].position }].push_back(
        { { rank.exchange.rank(), i }, taken[i], isKnown });
    }
  }
}

bool areSame(const geodesic::RankAddress& a, const geodesic::RankAddress& b)
{
  return a.rank == b.rank && a.id == b.id;
}

/// \returns the number of points that several ranks share.
int expectToldByTheLowestThatKnows(const PointsOnEdges& points)
{
  int shared = 0;
  for (const auto& [place, ofRanks] : points)
  {
    const PointOnEdge* teller = nullptr;
    for (const PointOnEdge& point : ofRanks)
    {
      const bool isLower = teller == nullptr || point.own < teller->own;
      teller = point.isKnown && isLower ? &point : teller;
    }
    for (const PointOnEdge& point : ofRanks)
    {
      EXPECT_TRUE(areSame(point.taken, teller != nullptr ? teller->own : point.own));
    }
    shared += ofRanks.size() > 1 ? 1 : 0;
  }
  return shared;
}

}

TEST_P(RefinementOnRanks, TellsOfAPointOnASeamByTheLowestRankThatKnows)
{
  Random random(900);
  const Case c = makeCase(random);
  int shared = 0;
  for (const double limit : { geodesic::Infinity, 0.3 * c.largest })
  {
    PointsOnEdges points;
    std::mutex mutex;
    onRanks(cutAtRandom(c.mesh, 4, random), c.curves, 0,
      [&](const RankOfRun& rank)
      {
        geodesic::FrontOptions front;
        front.maximumDistance = limit;
        geodesic::RefinementOptions options;
        options.tolerance = 0.01 * c.largest;
        const DistanceField field =
          solveForRefinement(rank.part, rank.sources, options.tolerance, front);
        const RefinedMesh refined = refine(field, options);
        const geodesic::SeamPoints seams =
          findSeamPoints(refined.points, refined.points.size(), field, field);
        const std::lock_guard<std::mutex> lock(mutex);
        addPointsOnEdges(rank, field, refined, seams, points);
      });
    shared += expectToldByTheLowestThatKnows(points);
  }
  EXPECT_GT(shared, 0);
}

INSTANTIATE_TEST_SUITE_P(Kinds, RefinementOnRanks, ::testing::ValuesIn(meshKinds()),
  [](const auto& kind) { return std::string(kind.param.name); });

namespace
{

/// Each row of a grid belongs to another rank.
CutMesh inBands(const PlainMesh& mesh, int ranks)
{
  CutMesh cut = { mesh, ranks, {} };
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face)
  {
    cut.rankOfFace.push_back(
      static_cast<int>(face * static_cast<std::size_t>(ranks) / mesh.triangles.size()));
  }
  return cut;
}

}

// Faces on seams keep their windows, others do not.
TEST(RefinementOfAPart, KeepsFewWindowsWhereTheDistanceIsLinear)
{
  const PlainMesh grid = regularGrid(20, 20);
  const std::vector<Polyline> curves = { { { { 0, { 1, 0, 0 }, { 0, 1, 0 } } }, {} } };
  onRanks(inBands(grid, 2), curves, 0,
    [&](const RankOfRun& rank)
    {
      geodesic::FrontOptions front;
      const double tolerance = 1.0;
      const DistanceField field = solveForRefinement(rank.part, rank.sources, tolerance, front);
      int kept = 0;
      for (Id face = 0; face < rank.part.mesh().numberOfFaces(); ++face)
      {
        kept += field.knowsInside(face) ? 1 : 0;
        EXPECT_TRUE(!field.knowsInside(face) || rank.part.isOwn(face));
      }
      const int atSeam = 20;
      EXPECT_GE(kept, atSeam);
      EXPECT_LE(kept, 3 * atSeam);
    });
}

// Rank 1 owns nothing and still takes part in every step.
TEST(RefinementOfAPart, ArrivesWhereARankHasNoFaces)
{
  const PlainMesh grid = regularGrid(4, 4);
  const std::vector<Polyline> curves = { { { { 0, { 1, 0, 0 }, { 1, 0, 0 } } }, {} } };
  CutMesh cut = inBands(grid, 2);
  std::replace(cut.rankOfFace.begin(), cut.rankOfFace.end(), 1, 2);
  cut.numberOfRanks = 3;
  const Task task = { grid, curves, 0.01 };
  const Joined joined = refineOnRanks(cut, task);
  EXPECT_LE(joined.refined.errorBound, task.tolerance);
  EXPECT_GT(joined.refined.triangles.size(), grid.triangles.size());
  expectFitTogether(engineMesh(grid), joined);
}

// One rank stops in the middle of refinement, before any output.
TEST(RefinementOfAPart, EndsOnAllRanksWhenOneIsStopped)
{
  const PlainMesh grid = regularGrid(10, 10);
  const std::vector<Polyline> curves = { { { { 0, { 1, 0, 0 }, { 1, 0, 0 } } }, {} } };
  double last = 0.0;
  EXPECT_THROW(onRanks(inBands(grid, 3), curves, 0,
                 [&](const RankOfRun& rank)
                 {
                   geodesic::FrontOptions front;
                   const DistanceField field =
                     solveForRefinement(rank.part, rank.sources, 1e-3, front);
                   geodesic::RefinementOptions options;
                   options.tolerance = 1e-3;
                   options.job = geodesic::Job(
                     [&](double done)
                     {
                       const bool isStopped = rank.exchange.rank() == 2 && done > 0.35;
                       if (isStopped)
                       {
                         last = done; // by one rank only: they run at the same time
                       }
                       return !isStopped;
                     });
                   refine(field, options);
                 }),
    geodesic::Aborted);
  EXPECT_GT(last, 0.35);
  EXPECT_LT(last, 0.9);
}

namespace
{

class RefinementOfRealMeshesOnRanks : public ::testing::TestWithParam<const char*>
{
};

}

TEST_P(RefinementOfRealMeshesOnRanks, FitsTogetherWithAsManyTrianglesAsInOnePiece)
{
  if (meshFolder().empty())
  {
    GTEST_SKIP() << noMeshFolder(GetParam());
  }
  const PlainMesh mesh = readMesh(GetParam());
  ASSERT_FALSE(mesh.triangles.empty());
  const TriangleMesh whole = engineMesh(mesh);
  const std::vector<Polyline> curves = { { { { 0, { 1, 0, 0 }, { 0, 1, 0 } } }, {} } };
  const DistanceField plain = geodesic::solve(whole, engineCurves(whole, curves));
  const Task task = { mesh, curves, 2e-4 * largestFinite(plain.vertexDistances()) };
  const RefinedMesh inOnePiece = refineTo(
    solveForRefinement(whole, engineCurves(whole, curves), task.tolerance), task.tolerance);
  Random random(1);
  for (const int ranks : { 2, 5 })
  {
    SCOPED_TRACE(ranks);
    const Joined joined = refineOnRanks(cutInSpace(mesh, ranks, random), task);
    EXPECT_LE(joined.refined.errorBound, task.tolerance);
    expectFitTogether(whole, joined);
    const double ratio = static_cast<double>(joined.refined.triangles.size()) /
      static_cast<double>(inOnePiece.triangles.size());
    EXPECT_NEAR(ratio, 1.0, 0.02);
    std::cout << testName(GetParam()) << ": " << joined.refined.triangles.size() << " triangles of "
              << mesh.triangles.size() << " faces, " << ratio << " times those of one piece\n";
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, RefinementOfRealMeshesOnRanks,
  ::testing::Values("spot.obj", "fandisk.obj"),
  [](const auto& file) { return testName(file.param); });
