// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceIsolines_h
#define geodesic_FaceIsolines_h

#include "Progress.h"
#include "contours/LevelCurves.h"
#include "field/SegmentCrossings.h"
#include "field/SegmentEnvelope.h"

#include <array>
#include <vector>

namespace geodesic
{

/// A point where an isoline crosses the outline of a face, or of a part of it.
struct OutlinePoint
{
  Vec2 at;
  Id id;
  /// The edge that it is on, from corner k to corner k + 1.
  std::size_t edge;
  /// Whether the line leaves there, run through so that the distance grows to its left.
  bool leaves;
};

/// The pieces of isolines in some faces. Points have ids: the caller gives those of the outlines,
/// from 0 on, and FaceIsolines gives higher ones to new points.
struct IsolinePieces
{
  struct Piece
  {
    Id face;
    /// Which of the values.
    Id value;
    /// The end of its points in `ids`, which begin where the piece before ends. A closed piece has
    /// its first point again at the end.
    std::size_t end;
  };

  struct NewPoint
  {
    Id face;
    Barycentric place;
  };

  std::vector<Piece> pieces;
  std::vector<Id> ids;
  std::vector<NewPoint> points;
};

/// Draws the isolines in one face after another.
///
/// Each distance candidate reaches a region within the value; the isoline is the outline of the
/// union of these regions. Each level curve is cut where it meets another one, a ray at the end of
/// a pencil, or an edge. Its parts outside all other regions remain. They are joined where one ends
/// and another begins, and to the points of the face's outline. If some ends do not meet, rounding
/// has decided something: then the face is cut in four, down to parts in which a straight line will
/// do.
class FaceIsolines
{
public:
  /// \param firstNewId for the points inside faces.
  /// \param chordTolerance the largest distance of a chord from its arc.
  /// \param progress called often in faces with very many windows; must outlive this.
  FaceIsolines(Id firstNewId, double chordTolerance, const ProgressCallback& progress)
    : firstNewId_(firstNewId)
    , chordTolerance_(chordTolerance)
    , progress_(progress)
  {
  }

  /// Draws the isoline of one value.
  ///
  /// \param face must not change between calls for it.
  /// \param level the value, see tolerance::BelowValue.
  /// \param valueId goes into the pieces.
  /// \param outline the points of the isoline on the face's edges, with the face to the left from
  ///        corner 0 on; entries and exits alternate.
  /// \param below whether corner 0 is below the level.
  /// \throws Aborted
  void draw(const FaceDistance& face, double level, Id valueId,
    const std::vector<OutlinePoint>& outline, bool below);

  const IsolinePieces& pieces() const { return this->result_; }
  IsolinePieces release() { return std::move(this->result_); }
  /// How many parts were so small that they were crossed straight.
  std::size_t partsCrossedStraight() const { return this->partsCrossedStraight_; }

private:
  /// The face or a part of it.
  struct Part
  {
    std::array<Vec2, 3> corners;
    std::vector<OutlinePoint> outline;
    /// Whether corner 0 is below the level.
    bool below;
    int depth;
  };
  /// What remains of a level curve.
  struct Remainder
  {
    std::size_t curve;
    double begin;
    double end;
  };
  /// A place from which a line must continue (the end of a remainder, or an entry), or to which it
  /// can continue (the beginning of a remainder, or an exit).
  struct LooseEnd
  {
    Vec2 at;
    /// Number of the remainder, or behind these of the outline's point.
    std::size_t owner;
  };
  /// A point of a line: where parts of level curves meet, or one inside an arc.
  struct LinePoint
  {
    Vec2 at;
    /// NoId for a new one.
    Id id = NoId;
    /// The largest distance of the line from its chord, between this point and the next one.
    double sagitta = 0.0;
  };
  struct Pair
  {
    double gap;
    std::size_t from;
    std::size_t to;
  };

  bool drawWhole(const Part& whole);
  void findRegions(bool withBent, double offset);
  void addRegion(const DistanceCandidate& candidate, double offset);
  bool isBelowThroughout(const Part& part) const;
  bool drawAtOnce(const Part& part);
  void drawPart(const Part& part);
  void findRemainders(const Part& part);
  void cutCurve(std::size_t curve, const Part& part);
  void cutCurveBetween(std::size_t curve, double first, double last);
  bool remains(Vec2 p) const;
  bool joinEnds(const Part& part);
  bool joinEndsWithin(double largestGap);
  bool isJoint(Vec2 a, Vec2 b) const;
  void addLines(const Part& part);
  void followFrom(std::size_t owner, const Part& part);
  void followRemainder(const Remainder& remainder);
  void addLine(bool isClosed);
  std::size_t chordFrom(std::size_t first) const;
  void closePiece();
  Id addPoint(Vec2 p);
  void split(const Part& part);
  std::vector<OutlinePoint> pointsBetween(Vec2 a, Vec2 b, bool aIsBelow, bool bIsBelow);
  void crossStraight(const Part& part);
  void work(std::size_t steps);

  Id firstNewId_;
  double chordTolerance_;
  const ProgressCallback& progress_;
  std::size_t stepsSinceLook_ = 0;
  IsolinePieces result_;
  std::size_t partsCrossedStraight_ = 0;

  /// Of the face and value at hand.
  const FaceDistance* face_ = nullptr;
  double level_ = 0.0;
  /// The face's longest edge, and how far apart two ends may be that meet.
  double size_ = 0.0;
  double gap_ = 0.0;
  /// What offsets of curves are fractions of, see tolerance::CurveOffset.
  double offsetScale_ = 0.0;
  /// By how much rounding may change the distance at the level.
  double slack_ = 0.0;
  Id valueId_ = 0;
  std::size_t parts_ = 0;
  /// Paths that bend at the ends of windows.
  std::vector<DistanceCandidate> bent_;
  std::vector<LevelRegion> regions_;
  std::vector<LevelCurve> curves_;

  /// Of the part at hand.
  std::vector<Remainder> remainders_;
  std::vector<LooseEnd> from_;
  std::vector<LooseEnd> to_;
  std::vector<Pair> pairs_;
  /// What follows each owner.
  std::vector<std::size_t> next_;
  std::vector<std::uint8_t> used_;
  std::vector<LinePoint> line_;

  CurvePlaces places_;
  CurvePlaces innerPlaces_;
  /// The regions near the part of a curve that is cut.
  std::vector<std::size_t> near_;
  SegmentEnvelope envelope_;
  std::vector<SegmentCrossing> crossings_;
};

}

#endif
