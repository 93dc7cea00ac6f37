// SPDX-License-Identifier: BSD-3-Clause
// How far the source is, where on it shortest paths end, on which side, and at which angle they
// leave it: the feet that the field finds, the ends of traced paths, and the field of several
// ranks, each compared with the closed forms of one table (EndCases).
#include "EngineSupport.h"
#include "RanksSupport.h"
#include "paths/EndCases.h"
#include "paths/PathChecker.h"

#include "Errors.h"
#include "Tolerance.h"

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

/// An end as the engine has found it.
struct FoundEnd
{
  Id source = geodesic::NoId;
  double arcLength = 0.0;
  double angle = 0.0;
};

std::vector<PlainFrame> framesOf(const NearestSource& nearest, std::size_t count)
{
  std::vector<PlainFrame> frames;
  for (Id source = 0; source < count; ++source)
  {
    const geodesic::SourceFrame frame = nearest.frameOf(source);
    frames.push_back({ frame.x, frame.y, frame.normal });
  }
  return frames;
}

MeshPoint endOf(const Polyline& line)
{
  return { line.segments.back().face, line.segments.back().to };
}

MeshPoint middleOf(const Polyline& line)
{
  const MeshSegment& last = line.segments.back();
  MeshPoint middle = { last.face, {} };
  for (std::size_t k = 0; k < 3; ++k)
  {
    middle.weights[k] = 0.5 * (last.from[k] + last.to[k]);
  }
  return middle;
}

/// Checks the end of a path against those that it may have. \returns by how much the angle is off.
double expectEnd(
  const EndCase& c, const std::vector<TrueEnd>& ends, const FoundEnd& found, double accuracy)
{
  double least = geodesic::Infinity;
  for (const TrueEnd& end : ends)
  {
    const bool isSame = end.source == found.source &&
      std::abs(end.arcLength - found.arcLength) <= std::max(accuracy, 4.0 * end.slack);
    least = isSame ? std::min(least, gapOfAngles(found.angle, end.angle) - end.slack) : least;
  }
  EXPECT_LE(least, accuracy) << "source " << found.source << ", arc length " << found.arcLength
                             << ", angle " << found.angle << "; expected " << ends.front().source
                             << ", " << ends.front().arcLength << ", " << ends.front().angle;
  EXPECT_GE(found.angle, c.leastAngle);
  EXPECT_LE(found.angle, geodesic::Pi + 1e-12);
  return least;
}

/// Calls test(case, random) for each case of a row.
class PathEnds : public ::testing::TestWithParam<EndConfiguration>
{
protected:
  template <typename Test>
  void forEachCase(const Test& test) const
  {
    for (const double variant : GetParam().variants)
    {
      SCOPED_TRACE(variant);
      for (Random& random : EachSeed(GetParam().seeds))
      {
        test(GetParam().make(random, variant), random);
      }
    }
  }
};

class PathEndsOnRanks : public PathEnds
{
};

std::vector<EndConfiguration> configurationsOnRanks()
{
  std::vector<EndConfiguration> rows;
  std::copy_if(endConfigurations().begin(), endConfigurations().end(), std::back_inserter(rows),
    [](const EndConfiguration& row) { return row.isOnRanks; });
  return rows;
}

std::string nameOf(const ::testing::TestParamInfo<EndConfiguration>& row)
{
  return row.param.name;
}

} // anonymous namespace

TEST_P(PathEnds, OfTheFieldAreThoseInClosedForm)
{
  std::size_t compared = 0;
  double worst = 0.0;
  this->forEachCase(
    [&](const EndCase& c, Random&)
    {
      FieldWithFeet s(c.mesh, c.sources);
      const std::vector<PlainFrame> frames = framesOf(s.nearest, c.sources.size());
      for (const MeshPoint& query : c.queries)
      {
        const std::vector<TrueEnd> ends = c.endsOf(query, frames);
        if (ends.empty())
        {
          continue;
        }
        ++compared;
        const SurfacePoint target = geodesic::normalized(s.mesh, enginePoint(s.mesh, query));
        EXPECT_NEAR(s.field.distance(target), ends.front().length, c.accuracyOfDistance);
        const Foot foot = s.footOf(target);
        ASSERT_TRUE(foot.isKnown());
        const double angle = s.nearest.angleOf(foot);
        worst = std::max(worst,
          expectEnd(c, ends, { foot.curve, s.nearest.arcLengthOf(foot), angle }, c.accuracy));
        const bool isPoint = c.sources[foot.curve].isPoint();
        EXPECT_TRUE(!isPoint || s.nearest.arcLengthOf(foot) == 0.0);
        EXPECT_TRUE(
          isPoint ? !foot.isRight : !ends.front().isInside || foot.isRight == (angle < 0.0));
        const Vec3 found = geodesic::position(s.mesh, s.nearest.pointOf(foot));
        if (isPoint)
        {
          const Vec3 place = position(c.mesh, endOf(c.sources[foot.curve]));
          EXPECT_LE(spaceDistance(found, place),
            2.0 * geodesic::tolerance::PositionRoundings * geodesic::tolerance::Rounding *
              geodesic::largestCoordinate(place));
        }
        else
        {
          const auto isThere = [&](const TrueEnd& end)
          { return spaceDistance(end.place, found) <= std::max(c.accuracy, 1e-12); };
          EXPECT_TRUE(!c.isPlane || std::any_of(ends.begin(), ends.end(), isThere));
        }
      }
    });
  EXPECT_GT(compared, 0U);
  std::cout << GetParam().name << ": " << compared << " paths, worst angle " << worst << "\n";
}

TEST_P(PathEnds, OfTracedPathsAreThoseInClosedForm)
{
  this->forEachCase(
    [&](const EndCase& c, Random&)
    {
      const FieldWithFeet s(c.mesh, c.sources);
      const std::vector<PlainFrame> frames = framesOf(s.nearest, c.sources.size());
      std::vector<SurfacePoint> targets;
      for (const MeshPoint& query : c.queries)
      {
        targets.push_back(geodesic::normalized(s.mesh, enginePoint(s.mesh, query)));
      }
      for (const Polyline& source : c.sources)
      {
        targets.push_back(enginePoint(s.mesh, endOf(source)));
        targets.push_back(enginePoint(s.mesh, middleOf(source)));
      }
      const std::vector<FoundPath> paths = findPaths(s.mesh, s.curves, targets);
      for (std::size_t i = 0; i < c.queries.size(); ++i)
      {
        const std::vector<TrueEnd> ends = c.endsOf(c.queries[i], frames);
        if (!ends.empty())
        {
          expectEnd(
            c, ends, { paths[i].source, paths[i].arcLength, paths[i].angle }, c.accuracyOfPath);
        }
      }
      for (std::size_t i = c.queries.size(); i < targets.size(); ++i)
      {
        ASSERT_FALSE(paths[i].places.empty());
        const bool isOnSource = paths[i].places.front() == paths[i].places.back();
        // In the middle of a segment across a face the place may be off it by a rounding.
        const Barycentric middle = middleOf(c.sources[0]).weights;
        const bool isRounded =
          (i - c.queries.size()) % 2 == 1 && std::count(middle.begin(), middle.end(), 0.0) == 0;
        EXPECT_TRUE(isRounded || !isOnSource || paths[i].angle == 0.0) << "on the source";
        EXPECT_NE(paths[i].source, geodesic::NoId);
      }
    });
}

TEST_P(PathEnds, OfPathsFoundInStripsAreThoseInClosedForm)
{
  this->forEachCase(
    [&](const EndCase& c, Random&)
    {
      const FieldWithFeet s(c.mesh, c.sources);
      const std::vector<PlainFrame> frames = framesOf(s.nearest, c.sources.size());
      std::vector<SurfacePoint> targets;
      std::vector<std::vector<TrueEnd>> ends;
      for (const MeshPoint& query : c.queries)
      {
        const std::vector<TrueEnd> truth = c.endsOf(query, frames);
        if (!truth.empty() && targets.size() < 20)
        {
          targets.push_back(geodesic::normalized(s.mesh, enginePoint(s.mesh, query)));
          ends.push_back(truth);
        }
      }
      const std::vector<FoundPath> paths = findPathsInStrips(s.mesh, s.curves, targets);
      double longest = 0.0;
      for (Id face = 0; face < s.mesh.numberOfFaces(); ++face)
      {
        longest = std::max(longest, s.mesh.shape(face).longest());
      }
      for (std::size_t i = 0; i < targets.size(); ++i)
      {
        // A last piece from a vertex beside the source has rounded ends.
        const FoundPath& path = paths[i];
        const double last = spaceDistance(path.places.end()[-2], path.places.back());
        const double rounding = geodesic::tolerance::PlaceRounding * longest;
        expectEnd(c, ends[i], { path.source, path.arcLength, path.angle },
          std::max(c.accuracyOfPath, rounding / last));
      }
    });
}

// At the vertices. The faces have another order than in one process, and frames by this order.
TEST_P(PathEndsOnRanks, AreThoseInClosedForm)
{
  this->forEachCase(
    [&](const EndCase& c, Random& random)
    {
      forEachCut(c.mesh, { { 2, true }, { 5, false } }, random,
        [&](const CutMesh& cut)
        {
          std::mutex mutex;
          onRanks(cut, c.sources, 0,
            [&](const RankOfRun& rank)
            {
              const geodesic::DistanceField field = geodesic::solve(
                rank.part, rank.sources, FieldWithFeet::withAngles(), geodesic::KeepWindows::None);
              NearestSource nearest(field, rank.patch, rank.curvesOnPatch);
              const std::vector<PlainFrame> frames = framesOf(nearest, c.sources.size());
              const std::lock_guard<std::mutex> lock(mutex);
              for (Id vertex = 0; vertex < rank.wholeVertices.size(); ++vertex)
              {
                const std::vector<TrueEnd> ends =
                  c.endsOf(vertexPoint(c.mesh, rank.wholeVertices[vertex]), frames);
                if (!ends.empty())
                {
                  const Foot foot = nearest.atVertex(vertex);
                  expectEnd(c, ends,
                    { foot.curve, nearest.arcLengthOf(foot), nearest.angleOf(foot) }, c.accuracy);
                }
              }
            });
        });
    });
}

INSTANTIATE_TEST_SUITE_P(Table, PathEnds, ::testing::ValuesIn(endConfigurations()), nameOf);
INSTANTIATE_TEST_SUITE_P(
  Table, PathEndsOnRanks, ::testing::ValuesIn(configurationsOnRanks()), nameOf);

namespace
{

/// Checks that a point's frame has its x axis along an edge of the mesh.
void expectAlong(const PlainMesh& mesh, const MeshPoint& source, Index from, Index to)
{
  const geodesic::SourceFrame frame = FieldWithFeet(mesh, { pointLine(source) }).nearest.frameOf(0);
  const Vec3 edge = minus(mesh.points[to], mesh.points[from]);
  EXPECT_NEAR(geodesic::dot(frame.x, edge), geodesic::norm(edge), 1e-13 * geodesic::norm(edge));
  EXPECT_NEAR(geodesic::dot(frame.x, frame.y), 0.0, 1e-13);
  EXPECT_NEAR(geodesic::norm(frame.normal), 1.0, 1e-13);
}

} // anonymous namespace

TEST(AnglesAtPoints, BeginAtTheEdgeThatIsFirstInTheInput)
{
  const PlainMesh plain = regularGrid(4, 4);
  const geodesic::TriangleMesh mesh = engineMesh(plain);
  expectAlong(plain, { 7, { 0.3, 0.3, 0.4 } }, plain.triangles[7][0], plain.triangles[7][1]);
  // Both faces at an edge, whichever face names the point.
  for (Index face = 0; face < plain.triangles.size(); ++face)
  {
    const MeshPoint middle = { face, { 0.0, 0.5, 0.5 } };
    Index first = 0;
    while (!geodesic::contains(mesh, first, enginePoint(mesh, middle)))
    {
      ++first;
    }
    expectAlong(plain, middle, plain.triangles[first][0], plain.triangles[first][1]);
  }
  // The edge that leaves an inner vertex in its first face; on the boundary the edge with the
  // surface on its left.
  for (Index vertex = 0; vertex < plain.points.size(); ++vertex)
  {
    Id edge = geodesic::NoId;
    for (Id corner = 0; corner < mesh.numberOfHalfedges(); ++corner)
    {
      const bool isFirst = edge == geodesic::NoId || mesh.isBoundary(corner);
      edge = mesh.origin(corner) == vertex && isFirst ? corner : edge;
    }
    expectAlong(plain, vertexPoint(plain, vertex), vertex, mesh.destination(edge));
  }
}

// Along the boundary angles are not scaled: at a corner of the rectangle the sector is a right
// angle.
TEST(AnglesAtBoundaries, AreNotScaled)
{
  constexpr Index n = 8;
  const geodesic::TriangleMesh mesh = engineMesh(regularGrid(n, n));
  const std::vector<geodesic::SourceCurve> loops = geodesic::boundaryCurves(mesh);
  ASSERT_EQ(loops.size(), 1U);
  const geodesic::DistanceField field =
    geodesic::solve(mesh, loops, FieldWithFeet::withAngles(), geodesic::KeepWindows::All);
  NearestSource nearest(field, geodesic::ReplicatedPatch(mesh), loops);
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    const double angle = std::abs(nearest.angleOf(nearest.atVertex(vertex)));
    const bool isOnSource = field.vertexDistances()[vertex] == 0.0;
    EXPECT_NEAR(angle, isOnSource ? 0.0 : geodesic::RightAngle, 1e-14);
  }
  // The length of the whole loop, and the places of its points.
  const std::vector<double> lengths = nearest.arcLengthsOf(0);
  ASSERT_EQ(lengths.size(), 4U * n + 1);
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    EXPECT_EQ(lengths[i], static_cast<double>(i));
  }
}

// Of three curves of one line, each has its own length, from its own first point, with the bits of
// feet there.
TEST(ArcLengths, OfCurvesThatAreJoinedAreTheirOwn)
{
  Random random(1);
  const auto row = std::find_if(endConfigurations().begin(), endConfigurations().end(),
    [](const EndConfiguration& configuration)
    { return configuration.name == "LineOfThreeCurves"; });
  const EndCase c = row->make(random, 0.0);
  FieldWithFeet s(c.mesh, c.sources);
  for (Id curve = 0; curve < 3; ++curve)
  {
    const std::vector<double> lengths = s.nearest.arcLengthsOf(curve);
    const std::vector<SurfacePoint>& points = s.curves[curve].points;
    ASSERT_EQ(lengths.size(), points.size());
    for (std::size_t i = 0; i < lengths.size(); ++i)
    {
      EXPECT_EQ(lengths[i], static_cast<double>(i));
      const Foot foot = s.nearest.atVertex(points[i].id);
      EXPECT_TRUE(foot.curve != curve || s.nearest.arcLengthOf(foot) == lengths[i]);
    }
    EXPECT_NEAR(s.nearest.frameOf(curve).x[0], curve == 1 ? -1.0 : 1.0, 1e-14);
  }
}

TEST(AnglesAtPoints, AreRefusedWhereTheSolveDidNotKeepThem)
{
  const PlainMesh plain = regularGrid(2, 2);
  FieldWithFeet s(plain, { pointLine(vertexPoint(plain, 4)) }, FieldWithFeet::withAngles(false));
  EXPECT_EQ(s.nearest.arcLengthOf(s.nearest.atVertex(0)), 0.0);
  EXPECT_THROW(s.nearest.angleOf(s.nearest.atVertex(0)), geodesic::Error);
}
