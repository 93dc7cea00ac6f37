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
std::string opposedOn(const TriangleMesh& mesh, const std::vector<Points>& curves, bool closed)
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

TEST(OpposedCurves, LieOnEachOtherInOppositeDirections)
{
  const TriangleMesh grid = engineMesh(geodesictest::regularGrid(8, 8));
  const Vec3 a = { 0.3, 1.2, 0 };
  const Vec3 b = { 2.7, 1.9, 0 };
  const Vec3 c = { 5.1, 4.4, 0 };
  struct Case
  {
    const char* what;
    std::vector<Points> curves;
    const char* opposed;
    bool closed = false;
  };
  const std::vector<Case> cases = { { "there and back, closed", { { a, b, c, b } }, "0/2 0/3",
                                      true },
    { "there and back", { { a, b, c, b, a } }, "0/2 0/3" },
    { "one segment there and back", { { a, b, a } }, "0/1" },
    { "along an edge", { { { 1, 2, 0 }, { 5, 2, 0 } }, { { 3, 2, 0 }, { 2, 2, 0 } } }, "1/0" },
    { "along parts of edges",
      { { { 0.5, 2, 0 }, { 1.5, 2, 0 } }, { { 1.25, 2, 0 }, { 0.25, 2, 0 } } }, "1/0" },
    { "a part in a face",
      { { { 1.2, 2.1, 0 }, { 6, 2.1, 0 } }, { { 4.7, 2.1, 0 }, { 4.6, 2.1, 0 } } }, "1/0" },
    { "in one direction", { { a, b, c }, { a, b, c } }, "" },
    { "a closed curve", { { a, b, c } }, "", true },
    { "which meet at their ends", { { { 1, 2, 0 }, { 3, 2, 0 } }, { { 5, 2, 0 }, { 3, 2, 0 } } },
      "" },
    { "which meet at their ends in a face",
      { { { 1.7, 2.1, 0 }, { 1.8, 2.1, 0 } }, { { 1.9, 2.1, 0 }, { 1.8, 2.1, 0 } } }, "" },
    { "beside each other",
      { { { 1, 2.1, 0 }, { 3, 2.1, 0 } }, { { 3, 2.1001, 0 }, { 1, 2.1001, 0 } } }, "" },
    { "which cross", { { { 1, 2.1, 0 }, { 3, 2.1, 0 } }, { { 3, 2.1001, 0 }, { 1, 2.0999, 0 } } },
      "" },
    { "points", { { { 1, 2.1, 0 } }, { { 1, 2.1, 0 } } }, "" } };
  for (const Case& given : cases)
  {
    EXPECT_EQ(opposedOn(grid, given.curves, given.closed), given.opposed) << given.what;
  }
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
