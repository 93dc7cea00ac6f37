// SPDX-License-Identifier: BSD-3-Clause
// Far points of a curve on a surface that is cut over ranks: the path that joins them is the
// shortest on the whole surface.
#include "RanksSupport.h"

#include "paths/FacesBetweenPoints.h"
#include "paths/JoinPoints.h"
#include "paths/PathCorridor.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <mutex>

using namespace geodesictest;

namespace
{

class FacesBetweenPoints : public ::testing::TestWithParam<MeshKind>
{
};

using geodesic::operator-;
using geodesic::norm;

double lengthOf(const geodesic::TriangleMesh& mesh, const std::vector<geodesic::SurfacePoint>& path)
{
  double length = path.empty() ? geodesic::Infinity : 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    length += norm(position(mesh, path[i]) - position(mesh, path[i - 1]));
  }
  return length;
}

Polyline pointAt(const MeshPoint& p)
{
  return { { { p.face, p.weights, p.weights } }, {} };
}

/// A polyline on a patch.
geodesic::LocatedPolyline lineThrough(
  const geodesic::ReplicatedPatch& patch, const std::vector<geodesic::SurfacePoint>& points)
{
  geodesic::LocatedPolyline line;
  for (const geodesic::SurfacePoint& p : points)
  {
    line.points.push_back(position(patch.mesh(), p));
    line.faces.push_back({ someFace(patch.mesh(), p) });
  }
  return line;
}

}

TEST_P(FacesBetweenPoints, HoldTheShortestPathOfTheWhole)
{
  for (std::uint64_t seed = 0; seed < meshesOfAKind(8); ++seed)
  {
    Random random(seed);
    const PlainMesh mesh = GetParam().make(randomSize(random), random);
    const MeshPoint from = randomFacePoint(mesh, random);
    const MeshPoint to = randomVertexPoint(mesh, random);
    const std::vector<Polyline> ends = { pointAt(from), pointAt(to) };
    Sources source;
    source.points = { from };
    const double truth = bruteForceDistances(mesh, source, { to }).queries.front();
    for (const int ranks : { 2, 4 })
    {
      onRanks(cutInSpace(mesh, ranks, random), ends, 0,
        [&](const RankOfRun& rank)
        {
          const geodesic::SurfacePoint a = rank.curvesOnPatch[0].points.front();
          const geodesic::SurfacePoint b = rank.curvesOnPatch[1].points.front();
          std::vector<geodesic::Id> faces = facesBetweenPoints(
            rank.part, rank.patch, { lineThrough(rank.patch, { a, b }) }, DBL_EPSILON);
          const auto select = [&](const geodesic::SurfacePoint& p)
          {
            const geodesic::Id face =
              rank.part.faceAt(rank.patch.ownerOf(someFace(rank.patch.mesh(), p)));
            if (face != geodesic::NoId && rank.part.isOwn(face))
            {
              faces.push_back(face);
            }
          };
          select(a);
          select(b);
          const geodesic::ReplicatedPatch strip(rank.part, faces);
          const auto onStrip = [&](const geodesic::SurfacePoint& p)
          {
            const geodesic::Id face = someFace(rank.patch.mesh(), p);
            return fromBarycentric(strip.mesh(), strip.faceAt(rank.patch.ownerOf(face)),
              barycentric(rank.patch.mesh(), p, face));
          };
          const auto path = geodesic::joinByShortestPaths(strip.mesh())(onStrip(a), onStrip(b), {});
          const double length = lengthOf(strip.mesh(), path);
          if (std::isfinite(truth))
          {
            EXPECT_NEAR(length, truth, accuracyOn(GetParam()) * std::max(truth, 1e-300))
              << GetParam().name << ", seed " << seed << ", " << ranks << " ranks, "
              << strip.mesh().numberOfFaces() << " of " << mesh.triangles.size() << " faces";
          }
          else
          {
            EXPECT_EQ(length, geodesic::Infinity);
          }
        });
    }
  }
}

// The bounds used instead of distances are no larger, and those used instead of a path no shorter.
TEST_P(FacesBetweenPoints, AreFoundByBoundsOfTheWays)
{
  for (Random& random : EachSeed(5))
  {
    const PlainMesh mesh = GetParam().make(randomSize(random), random);
    Sources source;
    source.points = { randomFacePoint(mesh, random) };
    const MeshPoint to = randomVertexPoint(mesh, random);
    const BruteForceResult truth = bruteForceDistances(mesh, source, { to });
    const double slack = accuracyOn(GetParam()) * largestFinite(truth.vertices);
    for (const int ranks : { 1, 3 })
    {
      onRanks(cutInSpace(mesh, ranks, random), { pointAt(source.points[0]), pointAt(to) }, 0,
        [&](const RankOfRun& rank)
        {
          const geodesic::Corridor ways =
            corridorTo(rank.part, rank.patch, rank.curvesOnPatch[0].points.front(),
              rank.curvesOnPatch[1].points.front(), nullptr, {});
          EXPECT_GE(ways.length, truth.queries.front() - slack);
          for (std::size_t i = 0; i < rank.wholeVertices.size(); ++i)
          {
            EXPECT_LE(ways.lowerBounds[i], truth.vertices[rank.wholeVertices[i]] + slack);
          }
        });
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, FacesBetweenPoints, ::testing::ValuesIn(meshKinds()),
  [](const auto& kind) { return std::string(kind.param.name); });

// Of three corners of a square, the last and the first are joined across its middle.
TEST(FacesBetweenPoints, OfAClosedPolylineJoinTheLastPointAndTheFirst)
{
  const Index n = 20;
  const PlainMesh mesh = regularGrid(n, n);
  const auto inCell = [](Index i, Index j) {
    return pointAt({ 2 * (j * n + i), { 0.2, 0.5, 0.3 } });
  };
  const Index middle = 2 * (n / 2 * n + n / 2);
  Random random(1);
  for (const int ranks : { 1, 3 })
  {
    for (const bool isClosed : { false, true })
    {
      int holdingTheMiddle = 0;
      std::mutex mutex;
      onRanks(cutInSpace(mesh, ranks, random),
        { inCell(0, 0), inCell(n - 1, 0), inCell(n - 1, n - 1) }, 0,
        [&](const RankOfRun& rank)
        {
          std::vector<geodesic::SurfacePoint> points;
          for (const geodesic::SourceCurve& curve : rank.curvesOnPatch)
          {
            points.push_back(curve.points.front());
          }
          geodesic::LocatedPolyline line = lineThrough(rank.patch, points);
          line.closed = isClosed;
          const std::vector<geodesic::Id> faces =
            facesBetweenPoints(rank.part, rank.patch, { line }, DBL_EPSILON);
          const std::lock_guard<std::mutex> lock(mutex);
          for (const geodesic::Id face : faces)
          {
            holdingTheMiddle += wholeFaceOf(rank, rank.part.addressOf(face)) == middle ? 1 : 0;
          }
        });
      EXPECT_EQ(holdingTheMiddle, isClosed ? 1 : 0) << ranks << " ranks";
    }
  }
}
