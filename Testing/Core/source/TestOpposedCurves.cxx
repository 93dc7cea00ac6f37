// SPDX-License-Identifier: BSD-3-Clause
// Segments that lie on each other in opposite directions are found, and no others.
#include "EngineSupport.h"

#include "source/OpposedCurves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>

namespace
{

using namespace geodesic;
using geodesictest::engineMesh;
using geodesictest::Random;

using Points = std::vector<Vec3>;

SourceCurves put(const TriangleMesh& mesh, const std::vector<Points>& curves, bool closed = false)
{
  std::vector<LocatedPolyline> lines;
  for (const Points& points : curves)
  {
    LocatedPolyline line;
    line.points = points;
    line.closed = closed;
    lines.push_back(line);
  }
  geodesictest::locate(mesh, lines);
  return putOntoSurface(mesh, lines, DBL_EPSILON, joinByShortestPaths(mesh));
}

/// The given segments that are opposed, as "curve/segment".
std::string opposedOn(
  const TriangleMesh& mesh, const std::vector<Points>& curves, bool closed = false)
{
  const SourceCurves onSurface = put(mesh, curves, closed);
  std::string text;
  std::string before;
  for (const SegmentOfCurve& at : opposedSegments(mesh, onSurface.curves))
  {
    const SegmentOfPolyline& given = onSurface.given[at.curve][at.segment];
    const std::string name = std::to_string(given.polyline) + "/" + std::to_string(given.segment);
    text += name == before ? "" : (text.empty() ? "" : " ") + name;
    before = name;
  }
  return text;
}

TriangleMesh grid()
{
  return engineMesh(geodesictest::regularGrid(8, 8));
}

TEST(OpposedCurves, ACurveThereAndBackIsOpposed)
{
  const Points there = { { 0.3, 1.2, 0 }, { 2.7, 1.9, 0 }, { 5.1, 4.4, 0 } };
  Points thereAndBack = there;
  thereAndBack.push_back(there[1]);
  EXPECT_EQ(opposedOn(grid(), { thereAndBack }, true), "0/2 0/3");
  thereAndBack.push_back(there[0]);
  EXPECT_EQ(opposedOn(grid(), { thereAndBack }), "0/2 0/3");
  EXPECT_EQ(opposedOn(grid(), { { there[0], there[1], there[0] } }), "0/1");
}

TEST(OpposedCurves, TwoCurvesAlongAnEdgeInOppositeDirectionsAreOpposed)
{
  EXPECT_EQ(
    opposedOn(grid(), { { { 1, 2, 0 }, { 5, 2, 0 } }, { { 3, 2, 0 }, { 2, 2, 0 } } }), "1/0");
  EXPECT_EQ(
    opposedOn(grid(), { { { 0.5, 2, 0 }, { 1.5, 2, 0 } }, { { 1.25, 2, 0 }, { 0.25, 2, 0 } } }),
    "1/0");
}

TEST(OpposedCurves, PartsOfSegmentsInAFaceAreOpposed)
{
  EXPECT_EQ(
    opposedOn(grid(), { { { 1.2, 2.1, 0 }, { 6, 2.1, 0 } }, { { 4.7, 2.1, 0 }, { 4.6, 2.1, 0 } } }),
    "1/0");
}

TEST(OpposedCurves, OtherCurvesAreNot)
{
  const Points line = { { 0.3, 1.2, 0 }, { 2.7, 1.9, 0 }, { 5.1, 4.4, 0 } };
  EXPECT_EQ(opposedOn(grid(), { line, line }), "") << "in one direction";
  EXPECT_EQ(opposedOn(grid(), { line }, true), "") << "a closed curve";
  EXPECT_EQ(opposedOn(grid(), { { { 1, 2, 0 }, { 3, 2, 0 } }, { { 5, 2, 0 }, { 3, 2, 0 } } }), "")
    << "which meet at their ends";
  EXPECT_EQ(
    opposedOn(grid(), { { { 1, 2.1, 0 }, { 3, 2.1, 0 } }, { { 3, 2.1001, 0 }, { 1, 2.1001, 0 } } }),
    "")
    << "beside each other";
  EXPECT_EQ(
    opposedOn(grid(), { { { 1, 2.1, 0 }, { 3, 2.1, 0 } }, { { 3, 2.1001, 0 }, { 1, 2.0999, 0 } } }),
    "")
    << "which cross";
  EXPECT_EQ(opposedOn(grid(), { { { 1, 2.1, 0 } }, { { 1, 2.1, 0 } } }), "") << "points";
}

/// Shortest paths there and back are traced separately.
TEST(OpposedCurves, FarPointsThereAndBackAreOpposedAllAlong)
{
  const geodesictest::PlainMesh plain = geodesictest::octasphere(6);
  const TriangleMesh mesh = engineMesh(plain);
  for (Random& random : geodesictest::EachSeed(20))
  {
    Points points;
    for (int i = 0; i < 2; ++i)
    {
      points.push_back(position(plain, geodesictest::randomFacePoint(plain, random)));
    }
    points.push_back(points.front());
    const SourceCurves onSurface = put(mesh, { points });
    const std::vector<SegmentOfCurve> opposed = opposedSegments(mesh, onSurface.curves);
    const auto back = std::count_if(onSurface.given.at(0).begin(), onSurface.given.at(0).end(),
      [](const SegmentOfPolyline& given) { return given.segment == 1; });
    EXPECT_EQ(opposed.size(), static_cast<std::size_t>(back));
  }
}

}
