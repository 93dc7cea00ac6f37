// SPDX-License-Identifier: BSD-3-Clause
#include "front/SaddleWedge.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using geodesic::Arrival;
using geodesic::EmittedInterval;
using geodesic::Id;
using geodesic::TriangleMesh;
using geodesic::Vec2;
using geodesic::Vec3;

constexpr double Pi = 3.14159265358979323846;
constexpr double AngleAccuracy = 1e-9;

/// Triangles around vertex 0, closed or with a gap, on request with every third one in the other
/// orientation. Directions at vertex 0 are angles from the first edge.
class Fan
{
public:
  /// \param height of points above and below vertex 0, in turns.
  Fan(Id faces, bool closed, bool mixed, double height = 0.7)
    : mesh_(points(faces, closed, height), triangles(faces, closed, mixed))
  {
    this->start_.push_back(0.0);
    for (Id f = 0; f < faces; ++f)
    {
      const Id corner = 3 * f;
      this->start_.push_back(this->start_.back() + this->mesh_.cornerAngle(corner));
    }
  }

  const TriangleMesh& mesh() const { return this->mesh_; }
  double total() const { return this->start_.back(); }

  /// The direction from vertex 0 to a point of the halfedge opposite it.
  double angle(Id halfedge, double x) const
  {
    const Id face = TriangleMesh::faceOf(halfedge);
    const double first = this->mesh_.length(3 * face);
    const double second = this->mesh_.length(3 * face + 2);
    const double opposite = this->mesh_.length(halfedge);
    // the law of cosines, twice
    const double cosine =
      (first * first + opposite * opposite - second * second) / (2.0 * first * opposite);
    const double to = std::sqrt(first * first + x * x - 2.0 * first * x * cosine);
    const double angle =
      std::acos(std::clamp((first * first + to * to - x * x) / (2.0 * first * to), -1.0, 1.0));
    const bool flipped = this->mesh_.triangle(face)[1] != face + 1;
    const double corner = this->start_[face + 1] - this->start_[face];
    return this->start_[face] + (flipped ? corner - angle : angle);
  }

  /// The result of findSaddleWedge as one flag for each of many directions.
  std::vector<bool> inShadow(const std::vector<EmittedInterval>& halfedges, int directions) const
  {
    std::vector<bool> result(static_cast<std::size_t>(directions), false);
    for (const EmittedInterval& part : halfedges)
    {
      const Id halfedge = TriangleMesh::nextInFace(part.corner);
      const double a = this->angle(halfedge, part.begin);
      const double b = this->angle(halfedge, part.end);
      for (int i = 0; i < directions; ++i)
      {
        const double direction = this->direction(i, directions);
        if (direction > std::min(a, b) && direction < std::max(a, b))
        {
          result[static_cast<std::size_t>(i)] = true;
        }
      }
    }
    return result;
  }

  double direction(int i, int directions) const { return this->total() * (i + 0.5) / directions; }

private:
  static std::vector<Vec3> points(Id faces, bool closed, double height)
  {
    std::vector<Vec3> result{ { 0.0, 0.0, 0.0 } };
    for (Id i = 0; i < faces + (closed ? 0 : 1); ++i)
    {
      const double a = 2.0 * Pi * i / faces * (closed ? 1.0 : 0.95);
      const double radius = 1.0 + 0.2 * std::sin(3.0 * i);
      result.push_back(
        { radius * std::cos(a), radius * std::sin(a), i % 2 == 0 ? height : -height });
    }
    return result;
  }

  static std::vector<geodesic::Triangle> triangles(Id faces, bool closed, bool mixed)
  {
    std::vector<geodesic::Triangle> result;
    for (Id i = 0; i < faces; ++i)
    {
      const Id a = 1 + i;
      const Id b = closed ? 1 + (i + 1) % faces : 2 + i;
      const bool flip = mixed && i % 3 == 1;
      result.push_back({ 0, flip ? b : a, flip ? a : b });
    }
    return result;
  }

  TriangleMesh mesh_;
  std::vector<double> start_;
};

// The shadow consists of exactly the directions that leave at least pi on both sides of the bend.
void expectWedge(const Fan& fan, bool closed, const Arrival& from)
{
  constexpr int directions = 997;
  std::vector<EmittedInterval> halfedges;
  ASSERT_TRUE(findSaddleWedge(fan.mesh(), 0, from, halfedges));
  const std::vector<bool> inShadow = fan.inShadow(halfedges, directions);
  const double arrival = fan.angle(from.halfedge, from.x);
  for (int i = 0; i < directions; ++i)
  {
    const double turn = std::abs(fan.direction(i, directions) - arrival);
    const double smaller = closed ? std::min(turn, fan.total() - turn) : turn;
    if (std::abs(smaller - Pi) > AngleAccuracy)
    {
      EXPECT_EQ(inShadow[static_cast<std::size_t>(i)], smaller > Pi)
        << "arrival at " << arrival << ", direction " << fan.direction(i, directions);
    }
  }
}

class SaddleWedges : public testing::TestWithParam<std::tuple<Id, bool, bool, double>>
{
};

TEST_P(SaddleWedges, AreThePartsThatNoStraightContinuationReaches)
{
  const auto [faces, closed, mixed, height] = this->GetParam();
  const Fan fan(faces, closed, mixed, height);
  ASSERT_EQ(fan.mesh().pseudoSource(0), TriangleMesh::PseudoSource::Saddle);
  for (Id face = 0; face < faces; ++face)
  {
    const Id halfedge = 3 * face + 1;
    for (const double t : { 0.0, 0.25, 0.6, 1.0 })
    {
      expectWedge(fan, closed, { halfedge, {}, t * fan.mesh().length(halfedge) });
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Fans, SaddleWedges,
  testing::Combine(
    testing::Values(6, 9, 12), testing::Bool(), testing::Bool(), testing::Values(0.7)));
// The shadow is so narrow that it begins and ends in one face.
INSTANTIATE_TEST_SUITE_P(LowFans, SaddleWedges,
  testing::Combine(testing::Values(4, 6), testing::Bool(), testing::Bool(), testing::Values(0.2)));

TEST(SaddleWedge, IsNotFoundWithoutAnArrival)
{
  const Fan fan(8, true, false);
  std::vector<EmittedInterval> halfedges;
  EXPECT_FALSE(findSaddleWedge(fan.mesh(), 0, {}, halfedges));
}

TEST(SaddleWedge, IsNotFoundAcrossAnEdgeOfThreeFaces)
{
  // three sheets that meet along the edge from vertex 0 to vertex 1
  const std::vector<Vec3> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1, 0 }, { 0.5, -1, 0 },
    { 0.5, 0, 1 } };
  const TriangleMesh mesh(points, { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } });
  std::vector<EmittedInterval> halfedges;
  EXPECT_FALSE(findSaddleWedge(mesh, 0, { 1, {}, 0.5 }, halfedges));
}

}
