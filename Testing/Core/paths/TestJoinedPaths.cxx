// SPDX-License-Identifier: BSD-3-Clause
// Paths between far points of curves: which paths are kept for the next use, and how much memory a
// search needs.
#include "EngineSupport.h"

#include "field/RetentionAround.h"
#include "front/Front.h"
#include "paths/JoinPoints.h"

#include <gtest/gtest.h>

using namespace geodesictest;
using geodesic::JoinPoints;
using geodesic::SurfacePoint;

TEST(JoinedPaths, ArePathsOfTheLastUseOnly)
{
  int joins = 0;
  const JoinPoints join = [&joins](
                            const SurfacePoint& a, const SurfacePoint& b, const geodesic::Job&)
  {
    ++joins;
    return std::vector<SurfacePoint>{ a, b };
  };
  geodesic::JoinedPaths paths;
  const auto use = [&](const std::vector<geodesic::Id>& vertices)
  {
    joins = 0;
    geodesic::JoinedPaths used;
    const JoinPoints reused = used.joinBy(join, paths);
    for (std::size_t i = 1; i < vertices.size(); ++i)
    {
      const std::vector<SurfacePoint> path =
        reused(SurfacePoint::atVertex(vertices[i - 1]), SurfacePoint::atVertex(vertices[i]), {});
      EXPECT_EQ(path.back().id, vertices[i]);
    }
    paths = std::move(used);
    return joins;
  };
  EXPECT_EQ(use({ 1, 2, 3, 4, 5 }), 4);
  EXPECT_EQ(use({ 1, 2, 3, 4, 5 }), 0);
  EXPECT_EQ(use({ 1, 2, 9, 4, 5 }), 2) << "two segments meet in the point that has moved";
  EXPECT_EQ(use({ 1, 2, 3, 4, 5 }), 2) << "paths that were not asked for are forgotten";
}

// The search for a path across a large surface keeps no windows and stops at the path's end.
TEST(RetentionAround, KeepsFewWindowsAndStopsAtTheTarget)
{
  Random random(3);
  const PlainMesh mesh = bumpySheet(40, 40, 0, 0.3, random);
  const geodesic::TriangleMesh engine = engineMesh(mesh);
  const auto source = engineCurves(engine, Sources{ { vertexPoint(mesh, 820) }, {} });
  const MeshPoint target = { 1500, { 0.2, 0.3, 0.5 } };
  geodesic::RetentionAround retention(engine, { enginePoint(engine, target) });
  geodesic::FrontOptions options;
  options.keepArrivals = true;
  const geodesic::FrontResult front = propagate(engine, source, options, retention);
  const geodesic::KeptWindows kept = retention.release();
  std::size_t faces = 0;
  for (geodesic::Id halfedge = 0; halfedge < engine.numberOfHalfedges(); ++halfedge)
  {
    faces += kept.windows.at(halfedge).empty() ? 0 : 1;
  }
  EXPECT_GE(faces, 1U);
  EXPECT_LE(faces, 3U);
  const double truth =
    bruteForceDistances(mesh, Sources{ { vertexPoint(mesh, 820) }, {} }, { target }).queries[0];
  EXPECT_LT(truth, retention.neededDistance() * (1.0 + 1e-9));
  std::size_t unreached = 0;
  for (const double distance : front.vertexDistances)
  {
    unreached += distance < geodesic::Infinity ? 0 : 1;
  }
  EXPECT_GT(unreached, 0U) << "vertices farther than the target are left alone";
}
