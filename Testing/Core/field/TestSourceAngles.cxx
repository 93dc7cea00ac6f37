// SPDX-License-Identifier: BSD-3-Clause
// Where along a curve shortest paths end and at which angle they leave it: in closed form, and
// against traced paths.
#include "EngineSupport.h"
#include "OnThreads.h"
#include "RanksSupport.h"
#include "Seeds.h"
#include "truth/DirectionAngles.h"

#include "field/NearestSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <mutex>

using namespace geodesictest;
using geodesic::Foot;
using geodesic::Id;
using geodesic::NearestSource;
using geodesic::SurfacePoint;

namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr double FullAngle = 2.0 * Pi;
constexpr std::size_t NumberOfQueries = 30;
/// What is asked for: of the length of the curve, and in radians of paths longer than this fraction
/// of the largest distance.
constexpr double LengthAccuracy = 1e-9;
constexpr double AngleAccuracy = 1e-8;
constexpr double ShortPath = 1e-3;

geodesic::FrontOptions withAngles(bool keepAngles = true)
{
  geodesic::FrontOptions options;
  options.keepArrivals = true;
  options.keepAngles = keepAngles;
  return options;
}

double gapOfAngles(double a, double b)
{
  return std::abs(std::remainder(a - b, FullAngle));
}

/// A field and its feet.
struct Solved
{
  geodesic::TriangleMesh mesh;
  std::vector<geodesic::SourceCurve> curves;
  geodesic::DistanceField field;
  NearestSource nearest;

  Solved(const PlainMesh& plain, const std::vector<Polyline>& polylines,
    const geodesic::FrontOptions& options = withAngles())
    : mesh(engineMesh(plain))
    , curves(engineCurves(mesh, polylines))
    , field(geodesic::solve(mesh, curves, options, geodesic::KeepWindows::All))
    , nearest(field, geodesic::ReplicatedPatch(mesh), curves)
  {
  }

  Foot footOf(const SurfacePoint& point)
  {
    return point.kind == SurfacePoint::Kind::Vertex
      ? nearest.atVertex(point.id)
      : nearest.of(geodesic::incomingSegmentTo(field, point));
  }
};

Vec3 minus(const Vec3& a, const Vec3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

/// The truth of a case, from its plain data.
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

  /// How far a length along a curve is from a place that the curve passes.
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
    const auto isBeside = [&](const SegmentAt& s) { return !around.hasFace(s.direction.face); };
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

  // Those of the segments that pass the place, by the side on which the path is in a segment's face.
  std::vector<double> rightAngles(
    std::size_t curve, const Vec3& place, const Direction& path) const
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
    const auto place = [this](const MeshSegment& s, const Barycentric& w)
    { return position(this->mesh_, { s.face, w }); };
    const Vec3 first = place(segments.front(), segments.front().from);
    const Vec3 last = place(segments.back(), segments.back().to);
    const bool isClosed = spaceDistance(first, last) <= 1e-12;
    const std::size_t firstPass = this->passes_;
    for (const MeshSegment& s : segments)
    {
      const Vec3 a = place(s, s.from);
      const Vec3 b = place(s, s.to);
      const bool closes = isClosed && &s == &segments.back();
      this->ends_.push_back({ { s.face, s.from }, a, { { s.face, minus(b, a) }, c, this->passes_, true },
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

/// Worst of many values, and how many have not been as they should.
struct Tally
{
  std::size_t compared = 0;
  std::size_t ties = 0;
  std::size_t others = 0;
  std::size_t beside = 0;
  double worstLength = 0.0;
  double worstAngle = 0.0;
};

} // anonymous namespace

TEST_P(SourceAngles, AreThoseOfTracedPaths)
{
  const Seeds seeds = seedsOfTest(meshesOfAKind(12));
  Tally tally;
  for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
  {
    const RandomCase c = randomCase(GetParam(), seed, NumberOfQueries);
    Solved s(c.mesh, c.curves);
    const PlainTruth truth(c.mesh, c.curves);
    const double largest = largestFinite(c.truth.vertices);
    std::vector<SurfacePoint> targets;
    for (Id vertex = 0; vertex < s.mesh.numberOfVertices(); ++vertex)
    {
      targets.push_back(SurfacePoint::atVertex(vertex));
    }
    for (const MeshPoint& query : c.queries)
    {
      targets.push_back(geodesic::normalized(s.mesh, enginePoint(s.mesh, query)));
    }
    const std::vector<FoundPath> paths = findPaths(s.mesh, s.curves, targets);
    for (std::size_t i = 0; i < targets.size(); ++i)
    {
      const Foot foot = s.footOf(targets[i]);
      const FoundPath& path = paths[i];
      if (!foot.isKnown() || path.points.size() < 2)
      {
        continue;
      }
      const double distance = i < c.truth.vertices.size()
        ? c.truth.vertices[i]
        : c.truth.queries[i - c.truth.vertices.size()];
      const std::size_t n = path.points.size();
      const Vec3 end = path.places[n - 1];
      const double length = truth.lengthOf(foot.curve);
      const double arc = s.nearest.arcLengthOf(foot);
      ++tally.compared;
      if (spaceDistance(end, geodesic::position(s.mesh, s.nearest.pointOf(foot))) > 1e-6 * largest)
      {
        ++tally.ties;
        continue;
      }
      const double miss = truth.missOf(foot.curve, arc, end) / std::max(length, largest);
      if (miss > LengthAccuracy) std::cout << "MISS " << GetParam().name << " " << seed << " " << i << " foot " << arc << " around " << foot.around << " dist " << distance/largest << "\n";
      EXPECT_LE(miss, LengthAccuracy) << GetParam().name << ", seed " << seed << ", point " << i;
      tally.worstLength = std::max(tally.worstLength, miss);
      if (!(distance > ShortPath * largest))
      {
        continue;
      }
      const Id face = geodesic::commonFace(s.mesh, path.points[n - 2], path.points[n - 1]);
      const Vec3 along = minus(path.places[n - 2], end);
      const double piece = geodesic::norm(along);
      if (!(piece > 1e-6 * largest))
      {
        continue; // too short to tell a direction
      }
      const SurfacePoint at = s.nearest.pointOf(foot);
      const Id faceAt = geodesic::someFace(s.mesh, at);
      const std::vector<double> angles = truth.anglesOf(foot.curve,
        { faceAt, geodesic::barycentric(s.mesh, at, faceAt) }, { face, along }, 1e-9 * largest);
      if (angles.empty())
      {
        ++tally.beside;
        continue;
      }
      const double angle = s.nearest.angleOf(foot);
      double gap = 1e300;
      for (const double a : angles)
      {
        gap = std::min(gap, gapOfAngles(a, angle));
      }
      if (gap > AngleAccuracy)
      {
        std::cout << GetParam().name << " seed " << seed << " point " << i << " gap " << gap << " angle " << angle
                  << " expected " << angles.front() << " or " << (angles.size() > 1 ? angles[1] : 0.0) << " or " << (angles.size() > 2 ? angles[2] : 0.0) << " dist " << distance / largest << " piece " << piece
                  << " arc " << arc << " curve " << foot.curve << " n " << n << " around " << foot.around
                  << " kind " << int(s.nearest.pointOf(foot).kind) << " nexpected " << angles.size() << "\n";
        ++tally.others;
        continue;
      }
      tally.worstAngle = std::max(tally.worstAngle, gap);
    }
  }
  std::cout << GetParam().name << ": of " << tally.compared << " paths " << tally.ties
            << " ties, " << tally.others << " others, " << tally.beside << " beside, worst length " << tally.worstLength << ", worst angle "
            << tally.worstAngle << "\n";
}

INSTANTIATE_TEST_SUITE_P(Kinds, SourceAngles, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });
