// SPDX-License-Identifier: BSD-3-Clause
// Refinement over several ranks in one process: the parts of all ranks fit together, and what is
// certified holds for the whole.
#include "RanksSupport.h"
#include "refinement/RefinementSupport.h"

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

/// What is refined.
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

/// Puts refined parts together. Points of two ranks are one where they are on one edge and have
/// their place along it, their coordinates and their distance in common, to the last bit: where
/// these differ the surface comes apart.
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
    for (std::size_t i = 0; i < rank.wholeFaces.size(); ++i)
    {
      wholeFaceOf[rank.part.faceOfTriangle(static_cast<Id>(i))] =
        static_cast<Id>(rank.wholeFaces[i]);
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
    // Inside faces no point is of two ranks, but two may be at one place of a flat part.
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
      front.part = &rank.part;
      const DistanceField field =
        solveForRefinement(rank.part.mesh(), rank.sources, task.tolerance, front);
      geodesic::RefinementOptions options;
      options.tolerance = task.tolerance;
      options.maximumFaces = task.maximumFaces;
      options.part = &rank.part;
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

/// The joined parts are one surface, that of the input.
void expectFitTogether(const TriangleMesh& whole, const Joined& joined)
{
  geodesic::FrontResult front;
  front.vertexDistances = joined.vertexDistances;
  const DistanceField field(whole, front, {});
  const Points points(field, joined.refined);
  expectFacesPartitioned(whole, joined.refined, points);
  expectWatertight(whole, joined.refined, points);
}

Samples samplesOf(
  const TriangleMesh& whole, const Joined& joined, std::size_t count, Random& random)
{
  geodesic::FrontResult front;
  front.vertexDistances = joined.vertexDistances;
  return sample(DistanceField(whole, front, {}), joined.refined, count, random);
}

CutMesh cutOf(const PlainMesh& mesh, int ranks, bool inSpace, Random& random)
{
  return inSpace ? cutInSpace(mesh, ranks, random) : cutAtRandom(mesh, ranks, random);
}

std::string nameOf(int ranks, bool inSpace)
{
  return std::to_string(ranks) + (inSpace ? " ranks in space" : " ranks at random");
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
    for (const int ranks : { 1, 2, 3, 4, 7 })
    {
      for (const bool inSpace : { false, true })
      {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", " + nameOf(ranks, inSpace));
        const Joined joined = refineOnRanks(cutOf(c.mesh, ranks, inSpace, random), task);
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
      }
    }
  }
  std::cout << GetParam().name << ": "
            << static_cast<double>(triangles) / static_cast<double>(trianglesInOnePiece)
            << " times the triangles of one piece\n";
}

INSTANTIATE_TEST_SUITE_P(Kinds, RefinementOnRanks, ::testing::ValuesIn(meshKinds()),
  [](const auto& kind) { return std::string(kind.param.name); });
