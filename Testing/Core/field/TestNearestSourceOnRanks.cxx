// SPDX-License-Identifier: BSD-3-Clause
// The nearest source, its side and the direction to it on a surface cut over ranks: compared with
// brute force from the nearest curve and from the foot, and with one process.
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

/// The nearest source of a point, as one process or a rank finds it.
struct Answer
{
  bool isKnown = false;
  Index curve = 0;
  bool isRight = false;
  MeshPoint foot;
  Vec3 place = {};
  geodesic::Vec3 gradient = {};
};

Answer answerFor(const Foot& foot, const NearestSource& nearest, const IncomingSegment& piece,
  const geodesic::TriangleMesh& mesh)
{
  Answer answer;
  answer.isKnown = foot.isKnown();
  answer.gradient = geodesic::gradientOf(mesh, piece);
  if (answer.isKnown)
  {
    const SurfacePoint at = nearest.pointOf(foot);
    const geodesic::Id face = geodesic::someFace(nearest.meshOfCurves(), at);
    answer.curve = foot.curve;
    answer.isRight = foot.isRight;
    answer.foot = { face, geodesic::barycentric(nearest.meshOfCurves(), at, face) };
    const geodesic::Vec3 place = geodesic::position(nearest.meshOfCurves(), at);
    answer.place = { place[0], place[1], place[2] };
  }
  return answer;
}

geodesic::FrontOptions withArrivals()
{
  geodesic::FrontOptions options;
  options.keepArrivals = true;
  return options;
}

/// The answers for the vertices, then for the queries.
std::vector<Answer> answersInOnePiece(const RandomCase& c)
{
  const geodesic::TriangleMesh mesh = engineMesh(c.mesh);
  const std::vector<geodesic::SourceCurve> curves = engineCurves(mesh, c.curves);
  const geodesic::DistanceField field =
    geodesic::solve(mesh, curves, withArrivals(), geodesic::KeepWindows::All);
  NearestSource nearest(field, geodesic::ReplicatedPatch(field.mesh()), curves);
  std::vector<Answer> answers;
  for (geodesic::Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    const IncomingSegment piece =
      geodesic::incomingSegmentTo(field, SurfacePoint::atVertex(vertex));
    answers.push_back(answerFor(nearest.atVertex(vertex), nearest, piece, mesh));
  }
  for (const MeshPoint& query : c.queries)
  {
    const IncomingSegment piece =
      geodesic::incomingSegmentTo(field, geodesic::normalized(mesh, enginePoint(mesh, query)));
    answers.push_back(answerFor(nearest.of(piece), nearest, piece, mesh));
  }
  return answers;
}

/// The answers of all ranks: for a vertex from each rank that has it, and, where windows are kept,
/// for a query from the rank that owns its face.
class AnswersOnRanks
{
public:
  AnswersOnRanks(const RandomCase& c, const CutMesh& cut, geodesic::KeepWindows keep)
    : case_(c)
    , keep_(keep)
    , answers_(c.mesh.points.size() + c.queries.size())
  {
    onRanks(cut, c.curves, 0, [this](const RankOfRun& rank) { this->ask(rank); });
  }

  const std::vector<std::vector<Answer>>& answers() const { return this->answers_; }

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
      this->add(rank, rank.wholeVertices[vertex],
        answerFor(nearest.atVertex(vertex), nearest, piece, mesh));
    }
    for (std::size_t i = 0; field.hasWindows() && i < this->case_.queries.size(); ++i)
    {
      const MeshPoint& query = this->case_.queries[i];
      const geodesic::RankAddress face = rank.facesOnRanks[query.face];
      if (face.rank == rank.exchange.rank() && rank.part.isOwn(face.id))
      {
        const IncomingSegment piece = geodesic::incomingSegmentTo(
          field, geodesic::fromBarycentric(mesh, face.id, query.weights));
        this->add(rank, this->case_.mesh.points.size() + i,
          answerFor(nearest.of(piece), nearest, piece, mesh));
      }
    }
  }

  void add(const RankOfRun& rank, std::size_t point, Answer answer)
  {
    if (answer.isKnown)
    {
      answer.foot.face = wholeFaceOf(rank, rank.patch.ownerOf(answer.foot.face));
    }
    const std::lock_guard<std::mutex> lock(this->mutex_);
    this->answers_[point].push_back(answer);
  }

  const RandomCase& case_;
  geodesic::KeepWindows keep_;
  std::vector<std::vector<Answer>> answers_;
  std::mutex mutex_;
};

double gapOf(const geodesic::Vec3& a, const geodesic::Vec3& b)
{
  return geodesic::norm(geodesic::operator-(a, b));
}

/// The results of a case, and where they differ from those of one process.
class Checked
{
public:
  explicit Checked(const MeshKind& kind, std::uint64_t seed)
    : case_(randomCase(kind, seed, NumberOfQueries))
    , whole_(answersInOnePiece(this->case_))
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
    const AnswersOnRanks ranks(this->case_, cut, keep);
    for (std::size_t i = 0; i < this->places_.size(); ++i)
    {
      SCOPED_TRACE("point " + std::to_string(i));
      for (const Answer& answer : ranks.answers()[i])
      {
        this->checkOne(i, answer);
        EXPECT_EQ(answer.curve, ranks.answers()[i].front().curve) << "ranks differ";
        EXPECT_EQ(answer.isRight, ranks.answers()[i].front().isRight) << "ranks differ";
        EXPECT_EQ(answer.place, ranks.answers()[i].front().place) << "ranks differ";
      }
    }
    for (std::size_t n = 0; n < FeetTried; ++n)
    {
      const std::size_t i = random.below(this->places_.size());
      if (!ranks.answers()[i].empty() && ranks.answers()[i].front().isKnown)
      {
        this->checkFoot(i, ranks.answers()[i].front());
      }
    }
  }

  std::size_t compared() const { return this->compared_; }
  std::size_t feetElsewhere() const { return this->feetElsewhere_; }
  std::size_t directionsElsewhere() const { return this->directionsElsewhere_; }
  std::size_t sidesElsewhere() const { return this->sidesElsewhere_; }

private:
  // A point that the mesh and the truth name by the same face.
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

  void checkOne(std::size_t i, const Answer& answer)
  {
    ASSERT_EQ(answer.isKnown, this->truth_[i] < geodesic::Infinity);
    if (!answer.isKnown)
    {
      return;
    }
    EXPECT_LE(
      std::abs(this->alone_[answer.curve][i] - this->truth_[i]), this->accuracy_ * this->largest_)
      << "curve " << answer.curve;
    const bool isOff = this->truth_[i] > 1e-9 * this->largest_;
    const double size = geodesic::norm(answer.gradient);
    EXPECT_TRUE(!isOff || std::abs(size - 1.0) <= 1e-14) << "gradient of length " << size;
    ++this->compared_;
    const Answer& one = this->whole_[i];
    const bool isOneWay =
      isOff && gapOf(answer.gradient, one.gradient) <= 1e-9 && answer.curve == one.curve;
    if (isOff && gapOf(answer.gradient, one.gradient) > 1e-6)
    {
      ++this->directionsElsewhere_;
    }
    if (answer.curve != one.curve || spaceDistance(answer.place, one.place) > 1e-6 * this->largest_)
    {
      ++this->feetElsewhere_;
      this->checkFoot(i, answer);
    }
    else if (isOneWay && answer.isRight != one.isRight)
    {
      ++this->sidesElsewhere_;
    }
  }

  // The brute-force distance from the foot alone equals the field's.
  void checkFoot(std::size_t i, const Answer& answer)
  {
    Sources source;
    source.points = { answer.foot };
    BruteForceOptions options;
    options.maximumDistance = 1.001 * this->truth_[i];
    const double distance =
      bruteForceDistances(this->case_.mesh, source, { this->places_[i] }, options).queries[0];
    EXPECT_LE(std::abs(distance - this->truth_[i]), this->accuracy_ * this->largest_)
      << "foot of point " << i << " on curve " << answer.curve;
  }

  RandomCase case_;
  std::vector<Answer> whole_;
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
  // Of equally long paths ranks may find another one, and straight behind the end of a curve either
  // side is right. An octahedron, whose faces are all alike, has most of both.
  EXPECT_LE(feet, compared / 50);
  EXPECT_LE(directions, compared / 20);
  EXPECT_LE(sides, compared / 50);
  std::cout << GetParam().name << ": of " << compared << " points " << feet
            << " have other feet than in one piece, " << directions << " other directions, "
            << sides << " other sides\n";
}

// Without windows, only the arrival at a vertex names the pseudo-source of its path.
TEST_P(NearestSourcesOnRanks, AreTheSameAtVerticesWithoutWindows)
{
  const RandomCase c = randomCase(GetParam(), MeshesOfAKind, 0);
  Random random(MeshesOfAKind);
  forEachCut(c.mesh, { { 7, true } }, random,
    [&](const CutMesh& cut)
    {
      const AnswersOnRanks with(c, cut, geodesic::KeepWindows::All);
      const AnswersOnRanks without(c, cut, geodesic::KeepWindows::None);
      for (std::size_t i = 0; i < c.truth.vertices.size(); ++i)
      {
        SCOPED_TRACE("vertex " + std::to_string(i));
        for (const Answer& answer : without.answers()[i])
        {
          EXPECT_EQ(answer.isKnown, c.truth.vertices[i] < geodesic::Infinity);
          EXPECT_EQ(answer.curve, with.answers()[i].front().curve);
          EXPECT_EQ(answer.isRight, with.answers()[i].front().isRight);
          EXPECT_EQ(answer.place, with.answers()[i].front().place);
        }
      }
    });
}

INSTANTIATE_TEST_SUITE_P(Kinds, NearestSourcesOnRanks, ::testing::ValuesIn(meshKinds()),
  [](const auto& kind) { return std::string(kind.param.name); });
