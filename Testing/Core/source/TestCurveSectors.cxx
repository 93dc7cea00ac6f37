// SPDX-License-Identifier: BSD-3-Clause
// The sides of directions around a point of the source, compared with angles measured around it.
#include "EngineSupport.h"

#include "source/CurveSectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace geodesictest;
using geodesic::CurveSectors;
using geodesic::Id;
using geodesic::SegmentEnd;
using geodesic::SideOfCurve;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

constexpr Index Sectors = 6;

/// Faces around vertex 0 that all have the same angle there, and directions by the angle around it.
class Around
{
public:
  explicit Around(double angleOfAFace)
    : angle(angleOfAFace)
    , mesh(engineMesh(fan(Sectors, angleOfAFace, 1)))
  {
    Id corner = *this->mesh.cornersAt(0).begin();
    for (Index i = 0; i < Sectors; ++i)
    {
      this->corners.push_back(corner);
      corner = this->mesh.acrossOriented(TriangleMesh::previousInFace(corner));
    }
  }

  double total() const { return this->angle * Sectors; }
  Id cornerOf(double around) const
  {
    return this->corners[static_cast<std::size_t>(around / this->angle)];
  }
  geodesic::Vec2 direction(double around) const
  {
    const double inFace = std::fmod(around, this->angle);
    return { std::cos(inFace), std::sin(inFace) };
  }
  /// A segment that leaves the vertex.
  SegmentEnd end(double around, Id curve) const
  {
    const Id corner = this->cornerOf(around);
    const geodesic::Barycentric to =
      geodesic::fromHalfedgeFrame(this->mesh, corner, 0.3 * this->direction(around));
    const Id face = TriangleMesh::faceOf(corner);
    return { SurfacePoint::atVertex(0), fromBarycentric(this->mesh, face, to), face, curve, 0.0,
      true };
  }
  /// The angles around the vertex at which the origin changes.
  std::vector<double> changes(const CurveSectors& sectors) const
  {
    std::vector<double> changes;
    for (std::size_t i = 0; i < Sectors; ++i)
    {
      for (const geodesic::Vec2& d : sectors.changesIn(this->corners[i]))
      {
        changes.push_back(static_cast<double>(i) * this->angle + std::atan2(d.y, d.x));
      }
    }
    std::sort(changes.begin(), changes.end());
    return changes;
  }

  const double angle;
  const TriangleMesh mesh;
  /// Counterclockwise, as the halfedges that begin at the vertex.
  std::vector<Id> corners;
};

}

// At the three segments and in the middle between consecutive ones, even across the first face.
TEST(CurveSectors, OfThreeCurvesAtAVertexEachHasTheDirectionsNearestByAngle)
{
  Random random(1);
  for (int i = 0; i < 100; ++i)
  {
    SCOPED_TRACE(i);
    const Around around(random.uniform(0.5, 1.3));
    std::vector<double> at;
    std::vector<SegmentEnd> ends;
    for (Id curve = 0; curve < 3; ++curve)
    {
      at.push_back(random.uniform(0.0, around.total()));
      ends.push_back(around.end(at.back(), curve));
    }
    CurveSectors sectors(around.mesh);
    sectors.assign(SurfacePoint::atVertex(0), ends, 0, 0.0);

    std::vector<double> expected = at;
    std::sort(expected.begin(), expected.end());
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double next = k < 2 ? expected[k + 1] : expected[0] + around.total();
      expected.push_back(std::fmod(0.5 * (expected[k] + next), around.total()));
    }
    std::sort(expected.begin(), expected.end());
    const std::vector<double> changes = around.changes(sectors);
    ASSERT_EQ(changes.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k)
    {
      EXPECT_NEAR(changes[k], expected[k], 1e-12);
    }

    for (int k = 0; k < 20; ++k)
    {
      const double direction = random.uniform(0.0, around.total());
      Id nearest = 0;
      double least = around.total();
      bool isLeft = false;
      for (Id curve = 0; curve < 3; ++curve)
      {
        const double turn =
          std::fmod(direction - at[curve] + around.total(), around.total()); // counterclockwise
        const double away = std::min(turn, around.total() - turn);
        if (away < least)
        {
          least = away;
          nearest = curve;
          isLeft = turn < around.total() - turn;
        }
      }
      const SideOfCurve side = sectors.of(around.cornerOf(direction), around.direction(direction));
      EXPECT_EQ(side.curve, nearest);
      EXPECT_EQ(side.isRight, !isLeft);
    }
  }
}
