// SPDX-License-Identifier: BSD-3-Clause
// The arc lengths at which shortest paths end on a curve, and the angles at which they leave it, on
// random meshes: compared with traced paths, at other points, with threads and on ranks.
#include "EngineSupport.h"
#include "OnThreads.h"
#include "RanksSupport.h"
#include "Seeds.h"
#include "truth/DirectionAngles.h"
#include "truth/PlaneEnds.h"

#include "refinement/AdaptiveRefinement.h"
#include "refinement/SolveForRefinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <mutex>

using namespace geodesictest;
using geodesic::Foot;
using geodesic::Id;
using geodesic::Job;
using geodesic::NearestSource;
using geodesic::SurfacePoint;

namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr double FullAngle = 2.0 * Pi;
constexpr std::size_t NumberOfQueries = 30;
/// Relative to the length of the curve, and in radians for paths longer than this fraction of the
/// largest distance.
constexpr double LengthAccuracy = 1e-9;
constexpr double AngleAccuracy = 1e-8;
constexpr double ShortPath = 1e-3;
/// A segment of a curve shorter than this, relative to the largest distance, has hardly a
/// direction.
constexpr double ShortSegment = 1e-6;
constexpr double SamePlace = 1e-9;

/// Two paths whose directions differ by less than this angle, in radians, may be equally long
/// within the accuracy of distances: a bend lengthens a path by the square of its angle.
double bendOn(const MeshKind& kind)
{
  return std::sqrt(8.0 * accuracyOn(kind));
}

/// The true answers for a case, computed from its plain data.
class PlainTruth
{
public:
  PlainTruth(const PlainMesh& mesh, const std::vector<Polyline>& curves)
    : mesh_(mesh)
    , curves_(curves)
  {
    for (std::size_t c = 0; c < curves.size(); ++c)
    {
      this->addEnds(c);
    }
  }

  double lengthOf(std::size_t curve) const
  {
    double length = 0.0;
    for (const MeshSegment& s : this->curves_[curve].segments)
    {
      length += this->lengthOf(s);
    }
    return length;
  }

  /// The difference between a length along a curve and a place that the curve passes.
  double missOf(std::size_t curve, double arcLength, const Vec3& place) const
  {
    double begin = 0.0;
    double least = Infinity;
    for (const MeshSegment& s : this->curves_[curve].segments)
    {
      const double length = this->lengthOf(s);
      const double t = length > 0.0 ? std::clamp((arcLength - begin) / length, 0.0, 1.0) : 0.0;
      const Vec3 a = position(this->mesh_, { s.face, s.from });
      const Vec3 b = position(this->mesh_, { s.face, s.to });
      Vec3 at = a;
      for (std::size_t k = 0; k < 3; ++k)
      {
        at[k] += t * (b[k] - a[k]);
      }
      const double beside = std::abs(arcLength - (begin + t * length));
      least = std::min(least, spaceDistance(at, place) + beside);
      begin += length;
    }
    return least;
  }

  /// All angles that a path may have: a curve may pass a place several times. None if the place
  /// is a rounding beside an edge or a vertex.
  ///
  /// \param from where the path leaves the curve.
  std::vector<double> anglesOf(
    std::size_t curve, const MeshPoint& from, const Direction& path, double near) const
  {
    const DirectionAngles around(this->mesh_, from);
    if (!around.hasFace(path.face))
    {
      return {};
    }
    if (this->curves_[curve].isPoint())
    {
      return { around.ofPoint(path) };
    }
    const Vec3 place = position(this->mesh_, from);
    const std::vector<SegmentAt> segments = this->segmentsAt(place, near);
    const auto isBeside = [&](const SegmentAt& s)
    {
      return !around.hasFace(s.direction.face) ||
        geodesic::norm(s.direction.along) < near * ShortSegment / SamePlace;
    };
    if (std::any_of(segments.begin(), segments.end(), isBeside))
    {
      return {};
    }
    return segments.empty() ? this->rightAngles(curve, place, path)
                            : around.ofCurve(path, segments, curve);
  }

private:
  static constexpr double Infinity = 1e300;

  struct EndAt
  {
    MeshPoint point;
    Vec3 place;
    SegmentAt segment;
    /// Whether the curve ends there.
    bool isLast;
  };

  double lengthOf(const MeshSegment& s) const
  {
    return spaceDistance(
      position(this->mesh_, { s.face, s.from }), position(this->mesh_, { s.face, s.to }));
  }

  // Those of the segments that pass the place, by the side on which the path is in a segment's
  // face.
  std::vector<double> rightAngles(std::size_t curve, const Vec3& place, const Direction& path) const
  {
    std::vector<double> angles;
    for (const MeshSegment& s : this->curves_[curve].segments)
    {
      const Vec3 a = position(this->mesh_, { s.face, s.from });
      const Vec3 b = position(this->mesh_, { s.face, s.to });
      const double length = spaceDistance(a, b);
      if (length > 0.0 &&
        spaceDistance(a, place) + spaceDistance(b, place) <= (1.0 + 1e-12) * length)
      {
        const Triangle& t = this->mesh_.triangles[s.face];
        const geodesic::Vec3& corner = this->mesh_.points[t[0]];
        const Vec3 normal = geodesic::cross(
          minus(this->mesh_.points[t[1]], corner), minus(this->mesh_.points[t[2]], corner));
        const double side = geodesic::dot(geodesic::cross(minus(b, a), path.along), normal);
        for (const double angle : { -0.5 * Pi, 0.5 * Pi })
        {
          if (path.face != s.face || angle * side > 0.0)
          {
            angles.push_back(angle);
          }
        }
      }
    }
    return angles;
  }

  // Segments without length have no direction.
  void addEnds(std::size_t c)
  {
    std::vector<MeshSegment> segments;
    for (const MeshSegment& s : this->curves_[c].segments)
    {
      if (this->lengthOf(s) > 0.0)
      {
        segments.push_back(s);
      }
    }
    if (segments.empty())
    {
      return;
    }
    const auto place = [this](const MeshSegment& s, const Barycentric& w) {
      return position(this->mesh_, { s.face, w });
    };
    const Vec3 first = place(segments.front(), segments.front().from);
    const Vec3 last = place(segments.back(), segments.back().to);
    const bool isClosed = spaceDistance(first, last) <= 1e-12;
    const std::size_t firstPass = this->passes_;
    for (const MeshSegment& s : segments)
    {
      const Vec3 a = place(s, s.from);
      const Vec3 b = place(s, s.to);
      const bool closes = isClosed && &s == &segments.back();
      this->ends_.push_back(
        { { s.face, s.from }, a, { { s.face, minus(b, a) }, c, this->passes_, true },
          !isClosed && &s == &segments.front() });
      ++this->passes_;
      this->ends_.push_back({ { s.face, s.to }, b,
        { { s.face, minus(a, b) }, c, closes ? firstPass : this->passes_, false },
        !isClosed && &s == &segments.back() });
    }
    ++this->passes_;
  }

  // Two curves that end there, and no third, continue one another.
  std::vector<SegmentAt> segmentsAt(const Vec3& place, double near) const
  {
    std::vector<SegmentAt> segments;
    std::vector<std::size_t> lasts;
    for (const EndAt& end : this->ends_)
    {
      if (spaceDistance(end.place, place) <= near)
      {
        if (end.isLast)
        {
          lasts.push_back(segments.size());
        }
        segments.push_back(end.segment);
      }
    }
    if (lasts.size() == 2)
    {
      segments[lasts[1]].pass = segments[lasts[0]].pass;
    }
    return segments;
  }

  const PlainMesh& mesh_;
  const std::vector<Polyline>& curves_;
  std::vector<EndAt> ends_;
  std::size_t passes_ = 0;
};

class SourceAngles : public ::testing::TestWithParam<MeshKind>
{
};

/// The results of comparisons.
struct Tally
{
  std::size_t compared = 0;
  /// Equally long paths to other places or in other directions.
  std::size_t others = 0;
  /// Paths that differ by no more than bendOn().
  std::size_t bent = 0;
  /// Sources within rounding of an edge or a vertex, where the truth has no angle.
  std::size_t beside = 0;
  double worstLength = 0.0;
  double worstAngle = 0.0;

  bool isOther(double gap, double bend)
  {
    this->bent += gap > AngleAccuracy && gap <= bend ? 1 : 0;
    this->others += gap > bend ? 1 : 0;
    return gap > AngleAccuracy;
  }
};

std::ostream& operator<<(std::ostream& os, const Tally& t)
{
  return os << "of " << t.compared << " points " << t.others << " have other paths, " << t.bent
            << " bent ones, " << t.beside << " have no angle; worst length " << t.worstLength
            << ", worst angle " << t.worstAngle;
}

/// Compares the feet of a case with traced paths.
class AgainstPaths
{
public:
  AgainstPaths(const MeshKind& kind, const RandomCase& c, Tally& tally)
    : truth_(c.mesh, c.curves)
    , largest_(largestFinite(c.truth.vertices))
    , bend_(bendOn(kind))
    , tally_(tally)
  {
  }

  void compare(FieldWithFeet& s, const SurfacePoint& target, const FoundPath& path)
  {
    const Foot foot = s.footOf(target);
    if (!foot.isKnown() || path.points.size() < 2)
    {
      return;
    }
    ++this->tally_.compared;
    const std::size_t n = path.points.size();
    const Vec3 end = path.places[n - 1];
    const SurfacePoint at = s.nearest.pointOf(foot);
    const double gap = spaceDistance(end, geodesic::position(s.mesh, at)) / this->largest_;
    if (this->tally_.isOther(gap, this->bend_))
    {
      return;
    }
    const double scale = std::max(this->truth_.lengthOf(foot.curve), this->largest_);
    const double miss =
      this->truth_.missOf(foot.curve, s.nearest.arcLengthOf(foot), end) / scale - gap;
    EXPECT_LE(miss, LengthAccuracy);
    this->tally_.worstLength = std::max(this->tally_.worstLength, miss);
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < n; ++i)
    {
      length += spaceDistance(path.places[i], path.places[i + 1]);
    }
    const Vec3 along = minus(path.places[n - 2], end);
    if (length > ShortPath * this->largest_ &&
      geodesic::norm(along) > ShortSegment * this->largest_)
    {
      const Id face = geodesic::commonFace(s.mesh, path.points[n - 2], path.points[n - 1]);
      this->compareAngle(s, foot, at, { face, along });
    }
  }

private:
  void compareAngle(
    FieldWithFeet& s, const Foot& foot, const SurfacePoint& at, const Direction& path)
  {
    const Id face = geodesic::someFace(s.mesh, at);
    const std::vector<double> angles = this->truth_.anglesOf(foot.curve,
      { face, geodesic::barycentric(s.mesh, at, face) }, path, SamePlace * this->largest_);
    if (angles.empty())
    {
      ++this->tally_.beside;
      return;
    }
    double gap = FullAngle;
    for (const double angle : angles)
    {
      gap = std::min(gap, gapOfAngles(angle, s.nearest.angleOf(foot)));
    }
    if (!this->tally_.isOther(gap, this->bend_))
    {
      this->tally_.worstAngle = std::max(this->tally_.worstAngle, gap);
    }
  }

  PlainTruth truth_;
  double largest_;
  double bend_;
  Tally& tally_;
};

/// The nearest source of a point, as numbers that can be compared.
struct Answer
{
  Id curve = geodesic::NoId;
  double arcLength = 0.0;
  double angle = 0.0;
};

Answer answerFor(NearestSource& nearest, const Foot& foot)
{
  return foot.isKnown() ? Answer{ foot.curve, nearest.arcLengthOf(foot), nearest.angleOf(foot) }
                        : Answer();
}

/// Compares two answers for a point. Either of two equally long paths may be the answer.
void compare(const Answer& a, const Answer& b, double scale, double bend, Tally& tally)
{
  ++tally.compared;
  const double length = std::abs(a.arcLength - b.arcLength) / scale;
  const double angle = gapOfAngles(a.angle, b.angle);
  const double gap = a.curve != b.curve ? FullAngle : std::max(length, angle);
  if (!tally.isOther(gap, bend))
  {
    tally.worstLength = std::max(tally.worstLength, length);
    tally.worstAngle = std::max(tally.worstAngle, angle);
  }
}

} // anonymous namespace

TEST_P(SourceAngles, AreThoseOfTracedPaths)
{
  const Seeds seeds = seedsOfTest(meshesOfAKind(12));
  Tally tally;
  for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
  {
    const RandomCase c = randomCase(GetParam(), seed, NumberOfQueries);
    FieldWithFeet s(c.mesh, c.curves);
    AgainstPaths against(GetParam(), c, tally);
    const std::vector<SurfacePoint> targets = verticesAnd(s.mesh, c.queries);
    const std::vector<FoundPath> paths = findPaths(s.mesh, s.curves, targets);
    for (std::size_t i = 0; i < targets.size(); ++i)
    {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", point " + std::to_string(i));
      against.compare(s, targets[i], paths[i]);
    }
  }
  EXPECT_LE(tally.others, tally.compared / 50);
  EXPECT_LE(tally.bent, tally.compared / 20);
  EXPECT_LE(tally.beside, tally.compared / 10);
  std::cout << GetParam().name << ": " << tally << "\n";
}

TEST_P(SourceAngles, ChangeNoDistance)
{
  for (std::uint64_t seed = 0; seed < meshesOfAKind(4); ++seed)
  {
    const RandomCase c = randomCase(GetParam(), seed, NumberOfQueries);
    for (const double relativeError : { 0.0, 1e-3 })
    {
      geodesic::FrontOptions with = FieldWithFeet::withAngles(true);
      geodesic::FrontOptions without = FieldWithFeet::withAngles(false);
      with.relativeError = relativeError;
      without.relativeError = relativeError;
      const FieldWithFeet a(c.mesh, c.curves, with);
      const FieldWithFeet b(c.mesh, c.curves, without);
      EXPECT_EQ(a.field.vertexDistances(), b.field.vertexDistances());
      EXPECT_EQ(a.field.windowsPropagated(), b.field.windowsPropagated());
      EXPECT_EQ(a.field.relativeErrorBound(), b.field.relativeErrorBound());
      EXPECT_EQ(valuesOf(a.field, c.queries).queries, valuesOf(b.field, c.queries).queries);
    }
  }
}

TEST_P(SourceAngles, HaveTheSameBitsOnAnyNumberOfThreads)
{
  const RandomCase c = randomCase(GetParam(), 1, NumberOfQueries);
  std::vector<std::array<double, 3>> expected;
  for (const geodesic::ParallelFor& way : waysToRun())
  {
    geodesic::FrontOptions options = FieldWithFeet::withAngles();
    options.job = Job({}, way);
    FieldWithFeet s(c.mesh, c.curves, options);
    std::vector<std::array<double, 3>> answers;
    for (const SurfacePoint& point : verticesAnd(s.mesh, c.queries))
    {
      const Answer t = answerFor(s.nearest, s.footOf(point));
      answers.push_back({ static_cast<double>(t.curve), t.arcLength, t.angle });
    }
    EXPECT_TRUE(expected.empty() || answers == expected);
    expected = answers;
  }
}

// With the windows that refinement keeps.
TEST_P(SourceAngles, AreKnownAtPointsThatRefinementAdds)
{
  Tally tally;
  for (std::uint64_t seed = 0; seed < meshesOfAKind(3); ++seed)
  {
    const RandomCase c = randomCase(GetParam(), seed, 0);
    FieldWithFeet s(c.mesh, c.curves);
    constexpr double tolerance = 0.02;
    const geodesic::DistanceField field =
      solveForRefinement(s.mesh, s.curves, tolerance, FieldWithFeet::withAngles());
    NearestSource nearest(field, geodesic::ReplicatedPatch(s.mesh), s.curves);
    geodesic::RefinementOptions options;
    options.tolerance = tolerance;
    options.maximumFaces = std::uint64_t(4) * s.mesh.numberOfFaces();
    const geodesic::RefinedMesh refined = geodesic::refine(field, options);
    for (std::size_t i = 0; i < refined.points.size(); i += 7)
    {
      const SurfacePoint& place = refined.points[i].place;
      const Foot foot = nearest.of(geodesic::incomingSegmentTo(field, place));
      compare(answerFor(nearest, foot), answerFor(s.nearest, s.footOf(place)),
        largestFinite(c.truth.vertices), bendOn(GetParam()), tally);
    }
  }
  EXPECT_LE(tally.others, tally.compared / 50);
  EXPECT_LE(tally.bent, tally.compared / 20);
  std::cout << GetParam().name << ": " << tally << "\n";
}

// Each rank owns consecutive faces of the input.
TEST_P(SourceAngles, AreTheSameOnRanks)
{
  Tally tally;
  for (std::uint64_t seed = 0; seed < meshesOfAKind(3); ++seed)
  {
    const RandomCase c = randomCase(GetParam(), seed, 0);
    FieldWithFeet s(c.mesh, c.curves);
    for (const int ranks : { 1, 2, 4 })
    {
      CutMesh cut = { c.mesh, ranks, {} };
      for (Index face = 0; face < c.mesh.triangles.size(); ++face)
      {
        cut.rankOfFace.push_back(
          static_cast<int>(face * static_cast<std::size_t>(ranks) / c.mesh.triangles.size()));
      }
      std::mutex mutex;
      onRanks(cut, c.curves, 0,
        [&](const RankOfRun& rank)
        {
          const geodesic::DistanceField field = geodesic::solve(
            rank.part, rank.sources, FieldWithFeet::withAngles(), geodesic::KeepWindows::None);
          NearestSource nearest(field, rank.patch, rank.curvesOnPatch);
          const std::lock_guard<std::mutex> lock(mutex);
          for (Id vertex = 0; vertex < rank.wholeVertices.size(); ++vertex)
          {
            compare(answerFor(nearest, nearest.atVertex(vertex)),
              answerFor(s.nearest, s.nearest.atVertex(rank.wholeVertices[vertex])),
              largestFinite(c.truth.vertices), bendOn(GetParam()), tally);
          }
        });
    }
  }
  EXPECT_GT(tally.compared, 0U);
  EXPECT_LE(tally.others, tally.compared / 50);
  EXPECT_LE(tally.bent, tally.compared / 20);
  std::cout << GetParam().name << ": " << tally << "\n";
}

INSTANTIATE_TEST_SUITE_P(Kinds, SourceAngles, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });
