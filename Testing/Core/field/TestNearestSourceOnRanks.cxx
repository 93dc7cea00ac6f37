// SPDX-License-Identifier: BSD-3-Clause
// What is nearest, from which side and in which direction, where ranks have the surface together:
// against the brute force from the curve and from the foot that are named, and against one piece.
#include "RanksSupport.h"

#include "field/NearestSource.h"

#include <gtest/gtest.h>

#include <iostream>
#include <mutex>

using namespace geodesictest;
using geodesic::Foot;
using geodesic::IncomingSegment;
using geodesic::NearestSource;
using geodesic::SurfacePoint;

namespace
{

constexpr std::uint64_t MeshesOfAKind = 2;
constexpr std::size_t NumberOfQueries = 20;
constexpr std::size_t FeetTried = 2; // in each cut

class NearestSourcesOnRanks : public ::testing::TestWithParam<MeshKind>
{
};

/// What is told of a point: in one piece, or on a rank.
struct Told
{
  bool isKnown = false;
  Index curve = 0;
  bool isRight = false;
  MeshPoint foot;
  Vec3 place = {};
  geodesic::Vec3 gradient = {};
};

Told tell(const Foot& foot, const NearestSource& nearest, const IncomingSegment& piece,
  const geodesic::TriangleMesh& mesh)
{
  Told told;
  told.isKnown = foot.isKnown();
  told.gradient = geodesic::gradientOf(mesh, piece);
  if (told.isKnown)
  {
    const SurfacePoint at = nearest.pointOf(foot);
    const geodesic::Id face = geodesic::someFace(nearest.meshOfCurves(), at);
    told.curve = foot.curve;
    told.isRight = foot.isRight;
    told.foot = { face, geodesic::barycentric(nearest.meshOfCurves(), at, face) };
    const geodesic::Vec3 place = geodesic::position(nearest.meshOfCurves(), at);
    told.place = { place[0], place[1], place[2] };
  }
  return told;
}

geodesic::FrontOptions withArrivals()
{
  geodesic::FrontOptions options;
  options.keepArrivals = true;
  return options;
}

/// What is told of the vertices, and of the queries behind them.
std::vector<Told> toldInOnePiece(const RandomCase& c)
{
  const geodesic::TriangleMesh mesh = engineMesh(c.mesh);
  const std::vector<geodesic::SourceCurve> curves = engineCurves(mesh, c.curves);
  const geodesic::DistanceField field =
    geodesic::solve(mesh, curves, withArrivals(), geodesic::KeepWindows::All);
  NearestSource nearest(field, geodesic::ReplicatedPatch(field.mesh()), curves);
  std::vector<Told> told;
  for (geodesic::Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    const IncomingSegment piece =
      geodesic::incomingSegmentTo(field, SurfacePoint::atVertex(vertex));
    told.push_back(tell(nearest.atVertex(vertex), nearest, piece, mesh));
  }
  for (const MeshPoint& query : c.queries)
  {
    const IncomingSegment piece =
      geodesic::incomingSegmentTo(field, geodesic::normalized(mesh, enginePoint(mesh, query)));
    told.push_back(tell(nearest.of(piece), nearest, piece, mesh));
  }
  return told;
}

/// The same by all ranks: of a vertex by each that has it; where windows are kept, of a query by
/// the one that owns its face.
class ToldOnRanks
{
public:
  ToldOnRanks(const RandomCase& c, const CutMesh& cut, geodesic::KeepWindows keep)
    : case_(c)
    , keep_(keep)
    , told_(c.mesh.points.size() + c.queries.size())
  {
    onRanks(cut, c.curves, 0, [this](const RankOfRun& rank) { this->ask(rank); });
  }

  const std::vector<std::vector<Told>>& told() const { return this->told_; }

private:
  void ask(const RankOfRun& rank)
  {
    const geodesic::TriangleMesh& mesh = rank.part.mesh();
    geodesic::FrontOptions options = withArrivals();
    const geodesic::DistanceField field =
      geodesic::solve(rank.part, rank.sources, options, this->keep_);
    NearestSource nearest(field, rank.patch, rank.curvesOnPatch);
    for (geodesic::Id vertex = 0; vertex < rank.wholeVertices.size(); ++vertex)
    {
      const IncomingSegment piece =
        geodesic::incomingSegmentTo(field, SurfacePoint::atVertex(vertex));
      this->add(
        rank, rank.wholeVertices[vertex], tell(nearest.atVertex(vertex), nearest, piece, mesh));
    }
    for (std::size_t i = 0; field.hasWindows() && i < this->case_.queries.size(); ++i)
    {
      const MeshPoint& query = this->case_.queries[i];
      const geodesic::RankAddress face = rank.facesOnRanks[query.face];
      if (face.rank == rank.exchange.rank() && rank.part.isOwn(face.id))
      {
        const IncomingSegment piece = geodesic::incomingSegmentTo(
          field, geodesic::fromBarycentric(mesh, face.id, query.weights));
        this->add(
          rank, this->case_.mesh.points.size() + i, tell(nearest.of(piece), nearest, piece, mesh));
      }
    }
  }

  void add(const RankOfRun& rank, std::size_t point, Told told)
  {
    if (told.isKnown)
    {
      told.foot.face = wholeFaceOf(rank, rank.patch.ownerOf(told.foot.face));
    }
    const std::lock_guard<std::mutex> lock(this->mutex_);
    this->told_[point].push_back(told);
  }

  const RandomCase& case_;
  geodesic::KeepWindows keep_;
  std::vector<std::vector<Told>> told_;
  std::mutex mutex_;
};

double gapOf(const geodesic::Vec3& a, const geodesic::Vec3& b)
{
  return geodesic::norm(geodesic::operator-(a, b));
}

/// What is known of a case, and what differs from one piece.
class Checked
{
public:
  explicit Checked(const MeshKind& kind, std::uint64_t seed)
    : case_(randomCase(kind, seed, NumberOfQueries))
    , whole_(toldInOnePiece(this->case_))
    , truth_(this->case_.truth.vertices)
    , largest_(largestFinite(this->case_.truth.vertices))
    , accuracy_(accuracyOn(kind))
  {
    this->truth_.insert(
      this->truth_.end(), this->case_.truth.queries.begin(), this->case_.truth.queries.end());
    std::vector<MeshPoint> places;
    for (Index vertex = 0; vertex < this->case_.mesh.points.size(); ++vertex)
    {
      places.push_back(atVertex(vertex));
    }
    places.insert(places.end(), this->case_.queries.begin(), this->case_.queries.end());
    this->places_ = places;
    for (const Polyline& curve : this->case_.curves)
    {
      this->alone_.push_back(
        bruteForceDistances(this->case_.mesh, toSources({ curve }), places).queries);
    }
  }

  const RandomCase& plain() const { return this->case_; }

  void check(
    const CutMesh& cut, Random& random, geodesic::KeepWindows keep = geodesic::KeepWindows::All)
  {
    const ToldOnRanks ranks(this->case_, cut, keep);
    for (std::size_t i = 0; i < this->places_.size(); ++i)
    {
      SCOPED_TRACE("point " + std::to_string(i));
      for (const Told& told : ranks.told()[i])
      {
        this->checkOne(i, told);
        EXPECT_EQ(told.curve, ranks.told()[i].front().curve) << "ranks differ";
        EXPECT_EQ(told.isRight, ranks.told()[i].front().isRight) << "ranks differ";
        EXPECT_EQ(told.place, ranks.told()[i].front().place) << "ranks differ";
      }
    }
    for (std::size_t n = 0; n < FeetTried; ++n)
    {
      const std::size_t i = random.below(this->places_.size());
      if (!ranks.told()[i].empty() && ranks.told()[i].front().isKnown)
      {
        this->checkFoot(i, ranks.told()[i].front());
      }
    }
  }

  std::size_t compared() const { return this->compared_; }
  std::size_t feetElsewhere() const { return this->feetElsewhere_; }
  std::size_t directionsElsewhere() const { return this->directionsElsewhere_; }
  std::size_t sidesElsewhere() const { return this->sidesElsewhere_; }

private:
  // A point that mesh and truth name by a face.
  MeshPoint atVertex(Index vertex) const
  {
    for (Index face = 0; face < this->case_.mesh.triangles.size(); ++face)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        if (this->case_.mesh.triangles[face][k] == vertex)
        {
          MeshPoint point{ face, {} };
          point.weights[k] = 1.0;
          return point;
        }
      }
    }
    ADD_FAILURE() << "vertex " << vertex << " has no face";
    return {};
  }

  void checkOne(std::size_t i, const Told& told)
  {
    ASSERT_EQ(told.isKnown, this->truth_[i] < geodesic::Infinity);
    if (!told.isKnown)
    {
      return;
    }
    EXPECT_LE(
      std::abs(this->alone_[told.curve][i] - this->truth_[i]), this->accuracy_ * this->largest_)
      << "curve " << told.curve;
    const bool isOff = this->truth_[i] > 1e-9 * this->largest_;
    const double size = geodesic::norm(told.gradient);
    EXPECT_TRUE(!isOff || std::abs(size - 1.0) <= 1e-14) << "gradient of length " << size;
    ++this->compared_;
    const Told& one = this->whole_[i];
    const bool isOneWay =
      isOff && gapOf(told.gradient, one.gradient) <= 1e-9 && told.curve == one.curve;
    if (isOff && gapOf(told.gradient, one.gradient) > 1e-6)
    {
      ++this->directionsElsewhere_;
    }
    if (told.curve != one.curve || spaceDistance(told.place, one.place) > 1e-6 * this->largest_)
    {
      ++this->feetElsewhere_;
      this->checkFoot(i, told);
    }
    else if (isOneWay && told.isRight != one.isRight)
    {
      ++this->sidesElsewhere_;
    }
  }

  // The distance from the foot, as a point, is the field's.
  void checkFoot(std::size_t i, const Told& told)
  {
    Sources source;
    source.points = { told.foot };
    BruteForceOptions options;
    options.maximumDistance = 1.001 * this->truth_[i];
    const double distance =
      bruteForceDistances(this->case_.mesh, source, { this->places_[i] }, options).queries[0];
    EXPECT_LE(std::abs(distance - this->truth_[i]), this->accuracy_ * this->largest_)
      << "foot of point " << i << " on curve " << told.curve;
  }

  RandomCase case_;
  std::vector<Told> whole_;
  std::vector<double> truth_;
  std::vector<MeshPoint> places_;
  /// The distances of all points from each curve alone.
  std::vector<std::vector<double>> alone_;
  double largest_;
  double accuracy_;
  std::size_t compared_ = 0;
  std::size_t feetElsewhere_ = 0;
  std::size_t directionsElsewhere_ = 0;
  std::size_t sidesElsewhere_ = 0;
};

}

TEST_P(NearestSourcesOnRanks, AreThoseOfTheWholeHoweverItIsCut)
{
  std::size_t compared = 0;
  std::size_t feet = 0;
  std::size_t directions = 0;
  std::size_t sides = 0;
  for (std::uint64_t seed = 0; seed < MeshesOfAKind; ++seed)
  {
    Checked checked(GetParam(), seed);
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    forEachCut(checked.plain().mesh, someWaysToCut(), random,
      [&](const CutMesh& cut) { checked.check(cut, random); });
    compared += checked.compared();
    feet += checked.feetElsewhere();
    directions += checked.directionsElsewhere();
    sides += checked.sidesElsewhere();
  }
  // Of equally long paths another one may be told, and straight behind the end of a curve either
  // side: most on an octahedron, which is the same from all its faces.
  EXPECT_LE(feet, compared / 50);
  EXPECT_LE(directions, compared / 20);
  EXPECT_LE(sides, compared / 50);
  std::cout << GetParam().name << ": of " << compared << " points " << feet
            << " have other feet than in one piece, " << directions << " other directions, "
            << sides << " other sides\n";
}

// Without windows nothing but a vertex's arrival names the pseudo-source that its path comes from.
TEST_P(NearestSourcesOnRanks, AreTheSameAtVerticesWithoutWindows)
{
  const RandomCase c = randomCase(GetParam(), MeshesOfAKind, 0);
  Random random(MeshesOfAKind);
  forEachCut(c.mesh, { { 7, true } }, random,
    [&](const CutMesh& cut)
    {
      const ToldOnRanks with(c, cut, geodesic::KeepWindows::All);
      const ToldOnRanks without(c, cut, geodesic::KeepWindows::None);
      for (std::size_t i = 0; i < c.truth.vertices.size(); ++i)
      {
        SCOPED_TRACE("vertex " + std::to_string(i));
        for (const Told& told : without.told()[i])
        {
          EXPECT_EQ(told.isKnown, c.truth.vertices[i] < geodesic::Infinity);
          EXPECT_EQ(told.curve, with.told()[i].front().curve);
          EXPECT_EQ(told.isRight, with.told()[i].front().isRight);
          EXPECT_EQ(told.place, with.told()[i].front().place);
        }
      }
    });
}

INSTANTIATE_TEST_SUITE_P(Kinds, NearestSourcesOnRanks, ::testing::ValuesIn(meshKinds()),
  [](const auto& kind) { return std::string(kind.param.name); });
