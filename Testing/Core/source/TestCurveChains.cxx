// SPDX-License-Identifier: BSD-3-Clause
// Curves with common ends become one curve, whatever their directions.
#include "EngineSupport.h"

#include "source/CurveChains.h"

#include <gtest/gtest.h>

using namespace geodesictest;
using geodesic::CurveChains;
using geodesic::SourceCurve;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

/// Along the middle of a row of 4 x 1 squares, across edges at the given x.
SourceCurve throughRow(const TriangleMesh& mesh, const std::vector<double>& xs)
{
  SourceCurve curve;
  for (const double x : xs)
  {
    for (geodesic::Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
    {
      const SurfacePoint middle = SurfacePoint::onEdge(halfedge, 0.5);
      if (position(mesh, middle) == geodesic::Vec3{ x, 0.5, 0.0 })
      {
        curve.points.push_back(middle);
        break;
      }
    }
  }
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
  {
    curve.faces.push_back(commonFace(mesh, curve.points[i], curve.points[i + 1]));
  }
  curve.isCut.assign(curve.points.size(), 0);
  return curve;
}

}

TEST(CurveChains, ACurveThatRunsAgainstTheChainKeepsWhereItIsCutAndWhereItBends)
{
  const TriangleMesh mesh = engineMesh(regularGrid(4, 1));
  const SourceCurve first = throughRow(mesh, { 0.0, 0.5, 1.0 });
  SourceCurve second = throughRow(mesh, { 3.0, 2.5, 2.0, 1.5, 1.0 });
  ASSERT_EQ(second.points.size(), 5U);
  second.isCut = { 0, 1, 0, 0, 0 };
  const CurveChains chains(mesh, { first, second });
  ASSERT_EQ(chains.curves().size(), 1U);
  const SourceCurve& chain = chains.curves().front();
  ASSERT_EQ(chain.points.size(), 7U);
  for (std::size_t i = 0; i < chain.points.size(); ++i)
  {
    const geodesic::Vec3 p = position(mesh, chain.points[i]);
    EXPECT_EQ(p[0], 0.5 * static_cast<double>(i));
    EXPECT_EQ(chain.isCut[i], p[0] == 2.5 ? 1 : 0) << "at " << p[0];
  }
  EXPECT_FALSE(chains.inChain(chains.curveAt(0, 0.5)).isReversed);
  EXPECT_TRUE(chains.inChain(chains.curveAt(0, 1.5)).isReversed);
}

// The parameter of a path's end is computed from the path, with roundings.
TEST(CurveChains, LengthsAlongACurveAreFromZeroToItsLength)
{
  const TriangleMesh mesh = engineMesh(regularGrid(4, 1));
  const SourceCurve first = throughRow(mesh, { 0.0, 0.5, 1.0 });
  const SourceCurve second = throughRow(mesh, { 3.0, 2.5, 2.0, 1.5, 1.0 });
  const CurveChains chains(mesh, { first, second });
  ASSERT_EQ(chains.curves().size(), 1U);
  EXPECT_EQ(chains.arcLength(0, 0.25), 0.25);
  EXPECT_EQ(chains.arcLength(1, 2.75), 0.25);
  EXPECT_EQ(chains.arcLength(0, -8.7e-19), 0.0);
  EXPECT_EQ(chains.arcLength(0, 1.0 + 1e-15), 1.0);
  EXPECT_EQ(chains.arcLength(1, 1.0 - 1e-15), 2.0);
  EXPECT_EQ(chains.arcLength(1, 3.0 + 1e-15), 0.0);
}

// Windows on both sides of such a segment are told apart by their parameters.
TEST(CurveChains, PlacesIncreaseAcrossASegmentWithoutLength)
{
  const TriangleMesh mesh =
    engineMesh({ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 1, 1, 0 } },
      { { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 } } });
  ASSERT_EQ(mesh.numberOfFaces(), 3U);
  SourceCurve curve;
  for (const geodesic::Id vertex : { 0U, 1U, 2U, 3U })
  {
    curve.points.push_back(SurfacePoint::atVertex(vertex));
  }
  curve.faces = { 0, 1, 2 };
  curve.isCut.assign(curve.points.size(), 0);
  const CurveChains chains(mesh, { curve });
  const std::vector<double>& parameters = chains.parameters(0);
  ASSERT_EQ(parameters.size(), 4U);
  EXPECT_GT(parameters[2], parameters[1]);
  EXPECT_NEAR(parameters[2], 1.0, 1e-15);
  EXPECT_NEAR(parameters[3], 2.0, 1e-15);
}
