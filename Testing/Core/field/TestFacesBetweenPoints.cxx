// SPDX-License-Identifier: BSD-3-Clause
// Far points of a curve on a surface that ranks have in pieces: the path that joins them is the
// shortest of the whole.
#include "RanksSupport.h"

#include "field/FacesBetweenPoints.h"
#include "field/JoinPoints.h"

#include <gtest/gtest.h>

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

/// A polyline of two points on a patch.
geodesic::LocatedPolyline lineBetween(const geodesic::SurfacePatch& patch,
  const geodesic::SurfacePoint& a, const geodesic::SurfacePoint& b)
{
  geodesic::LocatedPolyline line;
  for (const geodesic::SurfacePoint& p : { a, b })
  {
    line.points.push_back(position(patch.mesh(), p));
    line.faces.push_back({ someFace(patch.mesh(), p) });
  }
  return line;
}

}

TEST_P(FacesBetweenPoints, HoldTheShortestPathOfTheWhole)
{
  for (std::uint64_t seed = 0; seed < 8; ++seed)
  {
    Random random(seed);
    const PlainMesh mesh = GetParam().make(randomSize(random), random);
    const MeshPoint from = randomFacePoint(mesh, random);
    const MeshPoint to = randomVertexPoint(mesh, random);
    const auto pointAt = [](const MeshPoint& p) {
      return Polyline{ { { p.face, p.weights, p.weights } }, {} };
    };
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
            rank.part, rank.patch, { lineBetween(rank.patch, a, b) }, geodesic::SnapOptions());
          const auto select = [&](const geodesic::SurfacePoint& p)
          {
            const geodesic::Id face = rank.patch.faceOfPart(someFace(rank.patch.mesh(), p));
            if (face != geodesic::NoId && rank.part.isOwn(face))
            {
              faces.push_back(face);
            }
          };
          select(a);
          select(b);
          const geodesic::SurfacePatch strip(rank.part, faces);
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

INSTANTIATE_TEST_SUITE_P(Kinds, FacesBetweenPoints, ::testing::ValuesIn(meshKinds()),
  [](const auto& kind) { return std::string(kind.param.name); });
