// SPDX-License-Identifier: BSD-3-Clause
// How isolines are drawn in one face, and how pieces are joined, where rounding has moved points.
// Rounding moves them too little to decide anything in a test, so here they are moved further.
#include "contours/IsolineSupport.h"

#include "contours/FaceIsolines.h"
#include "contours/IsolineJoin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

using namespace geodesictest;
using geodesic::FaceDistance;
using geodesic::Id;
using geodesic::IsolinePieces;
using geodesic::OutlinePoint;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;
using geodesic::operator+;
using geodesic::operator*;

namespace
{

/// One equilateral face with sides of length 2.
PlainMesh equilateral()
{
  return { { { 0, 0, 0 }, { 2, 0, 0 }, { 1, std::sqrt(3.0), 0 } }, { { 0, 1, 2 } } };
}

/// A point of its outline: how far along which edge, and whether the distance grows there.
struct OnOutline
{
  std::size_t edge;
  double along;
  bool rises;
};

/// One face with sources, in which isolines are drawn with an outline that is given.
class DrawnFace
{
public:
  DrawnFace(
    const std::vector<Barycentric>& sources, double level, const std::vector<OnOutline>& outline)
    : level_(level)
  {
    Sources points;
    for (const Barycentric& source : sources)
    {
      points.points.push_back({ 0, source });
      this->sources_.push_back(position(this->plain_, points.points.back()));
    }
    this->field_.emplace(solveKeepingAll(this->mesh_, engineCurves(this->mesh_, points)));
    const FaceDistance face(*this->field_, 0);
    const geodesic::Job job;
    geodesic::IsolineTask task{ this->mesh_, static_cast<Id>(outline.size()), 1e-3, job,
      geodesic::LevelArrangement(job), {} };
    for (const OnOutline& p : outline)
    {
      Barycentric weights{};
      weights[(p.edge + 1) % 3] = 0.5 * p.along;
      weights[p.edge] = 1.0 - 0.5 * p.along;
      this->places_.push_back(position(this->plain_, { 0, weights }));
      this->outline_.push_back(
        { face.inPlane(weights), static_cast<Id>(this->outline_.size()), p.rises });
    }
    drawInFace(face, level, 0, this->outline_, field_->vertexDistances()[0] < level, task);
    for (const SurfacePoint& point : task.result.points)
    {
      this->places_.push_back(position(this->mesh_, point));
    }
    this->pieces_ = std::move(task.result);
  }

  std::size_t numberOfPieces() const { return this->pieces_.pieces.size(); }

  /// The lines, put together of pieces, by the ids of their points. Checks that each begins at an
  /// entry and ends at an exit, or is closed, and that no piece is left or used twice.
  std::vector<std::vector<Id>> lines() const
  {
    std::vector<std::vector<Id>> pieces;
    std::size_t begin = 0;
    for (const IsolinePieces::Piece& piece : this->pieces_.pieces)
    {
      pieces.emplace_back(this->pieces_.ids.begin() + static_cast<std::ptrdiff_t>(begin),
        this->pieces_.ids.begin() + static_cast<std::ptrdiff_t>(piece.end));
      begin = piece.end;
    }
    std::vector<std::vector<Id>> lines;
    for (const OutlinePoint& entry : this->outline_)
    {
      if (entry.leaves)
      {
        continue;
      }
      std::vector<Id> line = { entry.id };
      for (bool goesOn = true; goesOn;)
      {
        const auto next = std::find_if(pieces.begin(), pieces.end(),
          [&](const std::vector<Id>& piece) { return piece.front() == line.back(); });
        goesOn = next != pieces.end();
        if (goesOn)
        {
          line.insert(line.end(), next->begin() + 1, next->end());
          pieces.erase(next);
        }
      }
      EXPECT_LT(line.back(), this->outline_.size()) << "the line ends inside the face";
      EXPECT_TRUE(line.back() < this->outline_.size() && this->outline_[line.back()].leaves);
      lines.push_back(line);
    }
    EXPECT_TRUE(std::all_of(pieces.begin(), pieces.end(),
      [](const std::vector<Id>& piece) { return piece.front() == piece.back(); }));
    return lines;
  }

  const Vec3& place(Id id) const { return this->places_[id]; }

  /// The largest difference of the true distance and the value in the middles of chords.
  double worst(const std::vector<Id>& line) const
  {
    double worst = 0.0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
    {
      const Vec3 middle = 0.5 * (this->place(line[i]) + this->place(line[i + 1]));
      double distance = geodesic::Infinity;
      for (const Vec3& source : this->sources_)
      {
        distance = std::min(distance, spaceDistance(middle, source));
      }
      worst = std::max(worst, std::abs(distance - this->level_));
    }
    return worst;
  }

  double length(const std::vector<Id>& line) const
  {
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
    {
      length += spaceDistance(this->place(line[i]), this->place(line[i + 1]));
    }
    return length;
  }

private:
  PlainMesh plain_ = equilateral();
  TriangleMesh mesh_ = engineMesh(this->plain_);
  double level_;
  std::vector<Vec3> sources_;
  std::optional<geodesic::DistanceField> field_;
  std::vector<OutlinePoint> outline_;
  std::vector<Vec3> places_;
  IsolinePieces pieces_;
};

constexpr double ChordTolerance = 1e-3;
constexpr double Pi = 3.14159265358979323846;
const Barycentric Top = { 0.0, 0.0, 1.0 };
const std::vector<Barycentric> Corners = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, Top };

}

// Three arcs, one around each corner. The first point is off by more and more, at last beyond the
// middle of its edge.
TEST(FaceIsolines, GoStraightWithoutCrossingEachOtherWhereTheirEndsDoNotMeet)
{
  for (const double level : { 0.7, 0.9 })
  {
    for (const double off : { 0.0, 1e-8, 1e-5, 1e-3, -1e-3, 0.05, -0.05, 0.15 })
    {
      SCOPED_TRACE(::testing::Message() << level << ", off by " << off);
      const DrawnFace drawn(Corners, level,
        { { 0, level + off, true }, { 0, 2.0 - level, false }, { 1, level, true },
          { 1, 2.0 - level, false }, { 2, level, true }, { 2, 2.0 - level, false } });
      EXPECT_EQ(drawn.numberOfPieces(), 3U);
      const std::vector<std::vector<Id>> lines = drawn.lines();
      ASSERT_EQ(lines.size(), 3U);
      for (const std::vector<Id>& line : lines)
      {
        // In at point 2 k + 1, out at the next one around the corner.
        EXPECT_EQ(line.back(), (line.front() + 1) % 6);
        if (off == 0.0)
        {
          EXPECT_LE(drawn.worst(line), ChordTolerance);
          EXPECT_NEAR(drawn.length(line), level * Pi / 3.0, ChordTolerance);
        }
        else
        {
          EXPECT_EQ(line.size(), 2U);
        }
      }
    }
  }
}

// The arc around the top bulges through the lowest edge. The point where the line leaves is put
// beyond the one where it comes back: in the middle of the way there the distance is the value.
TEST(FaceIsolines, GoStraightOnlyWhereTheDistanceIsTheValueAllTheWay)
{
  const double level = 1.75;
  const double half = std::sqrt(level * level - 3.0);
  for (const bool isMoved : { false, true })
  {
    const DrawnFace drawn({ Top }, level,
      { { 0, 1.0 - half, false }, { 0, isMoved ? 1.0 - 3.0 * half : 1.0 + half, true },
        { 1, 2.0 - level, false }, { 2, level, true } });
    for (const std::vector<Id>& line : drawn.lines())
    {
      EXPECT_EQ(line.size() == 2U, isMoved);
    }
  }
}

TEST(JoinedPieces, OfAClosedLineInOneFaceStayClosedWhereItsLastChordHasHardlyAnyLength)
{
  const TriangleMesh mesh = engineMesh(equilateral());
  IsolinePieces drawn;
  drawn.points = { SurfacePoint::inFace(0, 0.3, 0.3), SurfacePoint::inFace(0, 0.4, 0.3),
    SurfacePoint::inFace(0, 0.3, 0.4), SurfacePoint::inFace(0, 0.3, 0.3 + 1e-12) };
  drawn.ids = { 0, 1, 2, 3, 0 };
  drawn.pieces = { { 0, 0, drawn.ids.size() } };
  const geodesic::Isolines joined = joinPieces(mesh, { 1.0 }, {}, {}, { drawn });
  ASSERT_EQ(joined.lines.size(), 1U);
  EXPECT_TRUE(joined.lines[0].isClosed());
  EXPECT_EQ(joined.lines[0].points.size(), 4U);
  EXPECT_EQ(joined.points.size(), 3U);
}

// A curve also meets the lines along a region's rays, beyond the region, and those of the face's
// edges.
TEST(LevelArrangements, HardlyCutCurvesBesideRegions)
{
  const geodesic::Job job;
  std::size_t compared = 0;
  std::size_t touching = 0;
  for (Random& random : EachSeed(20))
  {
    const PlainMesh plain = bumpySheet(5, 5, 0, 0.5, random);
    const geodesic::TriangleMesh mesh = engineMesh(plain);
    const geodesic::DistanceField field =
      solveKeepingAll(mesh, engineCurves(mesh, CurveMaker(plain, random).anySource()));
    geodesic::LevelArrangement arrangement(job);
    for (geodesic::Id face = 0; face < mesh.numberOfFaces(); ++face)
    {
      const geodesic::FaceDistance distance(field, face);
      const geodesic::FaceLevel level(
        distance, distance.distance(distance.inPlane(randomWeights(random))));
      arrangement.assign(level, false, geodesic::tolerance::CurveOffset);
      const auto remainders = arrangement.remainders();
      for (std::size_t i = 1; i < remainders.size(); ++i)
      {
        if (remainders[i].curve == remainders[i - 1].curve)
        {
          ++compared;
          touching += remainders[i].begin > remainders[i - 1].end ? 0 : 1;
        }
      }
    }
  }
  EXPECT_GT(compared, 0U);
  EXPECT_LE(2 * touching, compared);
}
