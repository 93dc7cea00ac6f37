// SPDX-License-Identifier: BSD-3-Clause
// Directions around a point of the source where rounding or the faces' orientation could mistake
// them. Elsewhere, sides and angles of paths show them.
#include "EngineSupport.h"

#include "field/NearestSource.h"
#include "source/FanAround.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

using namespace geodesictest;
using geodesic::FanAround;
using geodesic::Id;
using geodesic::SegmentEnd;
using geodesic::SideOfCurve;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

constexpr Index Sectors = 6;

/// A segment of a curve from the centre of a disc into the face of a corner there.
SegmentEnd segmentFromCentre(
  const TriangleMesh& mesh, Id corner, geodesic::Vec2 direction, Id point, bool isBeginning)
{
  const Id face = TriangleMesh::faceOf(corner);
  const SurfacePoint to =
    fromBarycentric(mesh, face, geodesic::fromHalfedgeFrame(mesh, corner, 0.3 * direction));
  return { SurfacePoint::atVertex(0), to, face, point, isBeginning };
}

/// A disc in which one face has the opposite orientation, and a segment that leaves its centre.
class TurnedFaceInDisc
{
public:
  explicit TurnedFaceInDisc(Index turnedFace)
    : turnedFace_(turnedFace)
    , mesh_(engineMesh(withTurned(turnedFace)))
  {
  }

  /// The corner of a face at the centre, by the number of faces behind the one that is turned.
  Id corner(Index behindTurned) const
  {
    return this->mesh_.cornerAt(static_cast<Id>((this->turnedFace_ + behindTurned) % Sectors), 0);
  }
  /// With a segment in a face, at a fraction of the face's angle from the corner's halfedge.
  FanAround sides(Index behindTurned, double fraction) const
  {
    const SegmentEnd end = segmentFromCentre(
      this->mesh_, this->corner(behindTurned), direction(fraction), Left.point, true);
    return { this->mesh_, { SurfacePoint::atVertex(0), { end }, Own.point } };
  }
  static geodesic::Vec2 direction(double fraction)
  {
    return { std::cos(fraction * Angle), std::sin(fraction * Angle) };
  }

  static constexpr double Angle = geodesic::Pi / 3.0;
  static constexpr SideOfCurve Own = { 7, false };
  static constexpr SideOfCurve Left = { 3, false };
  static constexpr SideOfCurve Right = { 3, true };

private:
  static PlainMesh withTurned(Index face)
  {
    PlainMesh plain = fan(Sectors, Angle, 1);
    std::swap(plain.triangles[face][1], plain.triangles[face][2]);
    return plain;
  }

  Index turnedFace_;
  TriangleMesh mesh_;
};

}

// Whichever face is the first in the mesh.
TEST(FanAround, SidesEndAtFacesOfOppositeOrientation)
{
  using Disc = TurnedFaceInDisc;
  for (Index turnedFace = 0; turnedFace < Sectors; ++turnedFace)
  {
    const Disc disc(turnedFace);
    const FanAround sides = disc.sides(2, 0.5);
    EXPECT_EQ(sides.sideOf(disc.corner(0), Disc::direction(0.5)), Disc::Own);
    EXPECT_TRUE(sides.sideChangesIn(disc.corner(0)).empty());
    EXPECT_EQ(sides.sideOf(disc.corner(1), Disc::direction(0.5)), Disc::Right);
    for (Index behind = 3; behind < Sectors; ++behind)
    {
      EXPECT_EQ(sides.sideOf(disc.corner(behind), Disc::direction(0.5)), Disc::Left);
    }
  }
}

// Its left side lies counterclockwise from it, as this face is seen.
TEST(FanAround, ASegmentInAFaceOfOppositeOrientationHasItsSidesThere)
{
  using Disc = TurnedFaceInDisc;
  for (Index turnedFace = 0; turnedFace < Sectors; ++turnedFace)
  {
    const Disc disc(turnedFace);
    const FanAround sides = disc.sides(0, 0.3);
    EXPECT_EQ(sides.sideOf(disc.corner(0), Disc::direction(0.1)), Disc::Right);
    EXPECT_EQ(sides.sideOf(disc.corner(0), Disc::direction(0.5)), Disc::Left);
    EXPECT_EQ(sides.sideOf(disc.corner(1), Disc::direction(0.5)), Disc::Own);
    EXPECT_EQ(sides.sideOf(disc.corner(5), Disc::direction(0.5)), Disc::Own);
    const std::vector<geodesic::Vec2> changes = sides.sideChangesIn(disc.corner(0));
    ASSERT_EQ(changes.size(), 1u);
    EXPECT_NEAR(changes[0].x, Disc::direction(0.3).x, 1e-12);
    EXPECT_NEAR(changes[0].y, Disc::direction(0.3).y, 1e-12);
  }
}

namespace
{

/// The angle at which the shortest path to each vertex leaves a curve, and its side.
class SolvedCurve
{
public:
  SolvedCurve(
    const PlainMesh& plain, const std::vector<SurfacePoint>& points, const std::vector<Id>& faces)
    : mesh_(engineMesh(plain))
    , curves_{ { points, faces, std::vector<std::uint8_t>(points.size(), 0) } }
    , field_(geodesic::solve(mesh_, curves_, withAngles(), geodesic::KeepWindows::All))
    , nearest_(field_, geodesic::ReplicatedPatch(mesh_), curves_)
  {
  }

  double distance(Id vertex) const { return this->field_.vertexDistances()[vertex]; }
  double angle(Id vertex) { return this->nearest_.angleOf(this->nearest_.atVertex(vertex)); }
  bool isRight(Id vertex) const { return this->nearest_.atVertex(vertex).isRight; }

private:
  static geodesic::FrontOptions withAngles()
  {
    geodesic::FrontOptions options;
    options.keepArrivals = true;
    options.keepAngles = true;
    return options;
  }

  TriangleMesh mesh_;
  std::vector<geodesic::SourceCurve> curves_;
  geodesic::DistanceField field_;
  geodesic::NearestSource nearest_;
};

}

// From a place on a spoke, nearer to the centre of a disc than rounding tells, outwards.
TEST(FanAround, OfACurveThatEndsARoundingFromAVertexAnglesAreThoseInThePlane)
{
  const double angle = geodesic::Pi / 3.0;
  const PlainMesh plain = fan(Sectors, angle, 1);
  const TriangleMesh mesh = engineMesh(plain);
  for (const bool isOutgoing : { true, false })
  {
    SCOPED_TRACE(isOutgoing);
    const Id corner = *mesh.cornersAt(0).begin();
    const Id spoke = isOutgoing ? corner : TriangleMesh::previousInFace(corner);
    const Id face = TriangleMesh::faceOf(corner);
    const double beside = 10.0 * std::numeric_limits<double>::epsilon();
    SurfacePoint to = SurfacePoint::inFace(face, 0.0, 0.0);
    (TriangleMesh::nextIndex(corner) == 1 ? to.u : to.v) = 0.2;
    (TriangleMesh::previousIndex(corner) == 2 ? to.v : to.u) = 0.2;
    SolvedCurve solved(
      plain, { SurfacePoint::onEdge(spoke, isOutgoing ? beside : 1.0 - beside), to }, { face });
    for (Id vertex = 1; vertex <= Sectors; ++vertex)
    {
      const geodesic::Vec3 p = mesh.point(vertex);
      const geodesic::Vec3 q = geodesic::position(mesh, to);
      const double expected =
        std::remainder(std::atan2(p[1], p[0]) - std::atan2(q[1], q[0]), 2.0 * geodesic::Pi);
      if (std::abs(expected) > 0.5 * geodesic::Pi + 0.1) // the path leaves the end at the centre
      {
        EXPECT_NEAR(solved.distance(vertex), 1.0, 1e-12);
        EXPECT_NEAR(solved.angle(vertex), expected, 1e-9);
        EXPECT_EQ(solved.isRight(vertex), expected < 0.0);
      }
    }
  }
}

// A curve across an edge, with a point in a face a rounding before the edge and one on it.
TEST(FanAround, OfACurveWithASegmentWithoutLengthAnglesAreThoseOfTheOthers)
{
  const PlainMesh plain = { { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1, 0 }, { 0.5, -1, 0 } },
    { { 0, 1, 2 }, { 1, 0, 3 } } };
  const std::vector<SurfacePoint> points = { SurfacePoint::inFace(0, 0.3, 0.4),
    SurfacePoint::inFace(0, 0.5, 1e-17), SurfacePoint::onEdge(0, 0.5),
    SurfacePoint::inFace(1, 0.3, 0.4) };
  SolvedCurve solved(plain, points, { 0, 0, 1 });
  for (const Id vertex : { 0U, 1U })
  {
    EXPECT_NEAR(solved.distance(vertex), 0.5, 1e-12);
    EXPECT_NEAR(solved.angle(vertex), vertex == 0 ? -0.5 * geodesic::Pi : 0.5 * geodesic::Pi, 1e-9);
    EXPECT_EQ(solved.isRight(vertex), vertex == 0);
  }
}

// At the centre of a disc, in the wide sector above the ends at 340 and 200 degrees.
TEST(FanAround, AnglesAreScaledBetweenEndsThatContinueEachOtherOnly)
{
  const PlainMesh plain = fan(Sectors, geodesic::Pi / 3.0, 1);
  const TriangleMesh mesh = engineMesh(plain);
  constexpr double degree = geodesic::Pi / 180.0;
  const auto directionOf = [&](double angle)
  {
    const auto sector = static_cast<Id>(angle / 60.0);
    const double turn = (angle - 60.0 * static_cast<double>(sector)) * degree;
    const Id corner = mesh.cornerAt(sector, 0);
    return std::make_pair(corner, geodesic::Vec2{ std::cos(turn), std::sin(turn) });
  };
  const auto end = [&](double angle, Id point, bool isBeginning)
  {
    const auto [corner, direction] = directionOf(angle);
    return segmentFromCentre(mesh, corner, direction, point, isBeginning);
  };
  const std::vector<SegmentEnd> one = { end(200, 0, false), end(340, 0, true) };
  // Of two curves, or of one that crosses itself.
  const std::vector<SegmentEnd> crossing = { end(200, 1, false), end(250, 0, false),
    end(290, 1, true), end(340, 0, true) };
  for (const double turn : { 20.0, 70.0, 100.0, 120.0, 200.0 })
  {
    SCOPED_TRACE(turn);
    const auto angleAmong = [&](const std::vector<SegmentEnd>& ends)
    {
      const FanAround around(mesh, { SurfacePoint::atVertex(0), ends, 0 });
      const auto [corner, direction] = directionOf(std::fmod(340.0 + turn, 360.0));
      return around.angleFromCurve(around.angleOf(corner, direction)) / degree;
    };
    const double ofNearer = turn < 110.0 ? turn : 180.0 - (220.0 - turn);
    EXPECT_NEAR(angleAmong(one), turn * 180.0 / 220.0, 1e-9);
    EXPECT_NEAR(angleAmong(crossing), ofNearer, 1e-9);
  }
}
