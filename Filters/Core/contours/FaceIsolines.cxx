// SPDX-License-Identifier: BSD-3-Clause
#include "contours/FaceIsolines.h"

#include "Tolerance.h"
#include "contours/Chords.h"
#include "field/SegmentEnvelope.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

namespace geodesic
{

namespace
{

using Remainder = LevelArrangement::Remainder;

constexpr std::size_t None = static_cast<std::size_t>(-1);

// How often a face may be cut in four. Smaller parts, of a millionth of its size, are crossed
// straight.
constexpr int MaximumDepth = 20;
// And into how many parts in all. Rounding decides at few points.
constexpr std::size_t MaximumParts = 4096;

/// The face or a part of it.
struct FacePart
{
  std::array<Vec2, 3> corners;
  std::vector<OutlinePoint> outline;
  /// Whether corner 0 is below the level.
  bool below;
  int depth;
};

/// Adds points to the outline of a part, seen from the same side of their edge or from the other.
void addTo(std::vector<OutlinePoint>& outline, std::size_t edge, std::vector<OutlinePoint> points,
  bool isOtherSide = false)
{
  if (isOtherSide)
  {
    std::reverse(points.begin(), points.end());
  }
  for (OutlinePoint& point : points)
  {
    outline.push_back({ point.at, point.id, edge, point.leaves != isOtherSide });
  }
}

/// Joins the ends of remainders and the points of a part's outline to lines. Remainders are
/// numbered first, the points of the outline behind them.
class EndJoiner
{
public:
  EndJoiner(const FaceLevel& level, const FacePart& part, const std::vector<Remainder>& remainders,
    const Job& job)
    : level_(level)
    , job_(job)
    , next_(remainders.size() + part.outline.size(), None)
  {
    this->from_.reserve(this->next_.size());
    this->to_.reserve(this->next_.size());
    std::size_t owner = 0;
    for (const Remainder& r : remainders)
    {
      this->from_.push_back({ r.curve->at(r.end), owner });
      this->to_.push_back({ r.curve->at(r.begin), owner++ });
    }
    for (const OutlinePoint& p : part.outline)
    {
      (p.leaves ? this->to_ : this->from_).push_back({ p.at, owner++ });
    }
    std::sort(this->to_.begin(), this->to_.end(),
      [](const LooseEnd& a, const LooseEnd& b)
      { return a.at.x != b.at.x ? a.at.x < b.at.x : a.owner < b.owner; });
  }

  /// Joins ends of lines, the nearest ones first. Returns what follows each remainder, and each
  /// point of the outline that is an entry; nothing if not every line can continue.
  std::optional<std::vector<std::size_t>> run()
  {
    const bool isDone = this->from_.size() == this->to_.size() &&
      (this->joinWithin(this->level_.gap) || this->joinWithin(Infinity));
    return isDone ? std::make_optional(std::move(this->next_)) : std::nullopt;
  }

private:
  /// A place from which a line must continue (the end of a remainder, or an entry), or to which it
  /// can continue (the beginning of a remainder, or an exit).
  struct LooseEnd
  {
    Vec2 at;
    std::size_t owner;
    bool isJoined = false;
  };

  /// Joins loose ends that are no farther apart. Returns whether every line can continue.
  bool joinWithin(double largestGap)
  {
    // The gap between two loose ends, and their numbers.
    std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
    pairs.reserve(2 * this->from_.size());
    for (std::size_t i = 0; i < this->from_.size(); ++i)
    {
      this->job_.look();
      const LooseEnd& from = this->from_[i];
      auto to = std::partition_point(this->to_.begin(), this->to_.end(),
        [&](const LooseEnd& end) { return end.at.x < from.at.x - largestGap; });
      for (; to != this->to_.end() && to->at.x <= from.at.x + largestGap; ++to)
      {
        const double gap = norm(to->at - from.at);
        if (gap <= largestGap && !from.isJoined && !to->isJoined)
        {
          pairs.emplace_back(gap, i, static_cast<std::size_t>(to - this->to_.begin()));
        }
      }
    }
    std::sort(pairs.begin(), pairs.end());
    bool allMeet = true;
    for (const auto& [gap, i, j] : pairs)
    {
      LooseEnd& from = this->from_[i];
      LooseEnd& to = this->to_[j];
      if (!from.isJoined && !to.isJoined)
      {
        from.isJoined = true;
        to.isJoined = true;
        this->next_[from.owner] = to.owner;
        allMeet = allMeet && this->isJoint(from.at, to.at);
      }
    }
    return allMeet &&
      std::all_of(
        this->to_.begin(), this->to_.end(), [](const LooseEnd& to) { return to.isJoined; });
  }

  /// Whether a line may go straight from one end to another.
  bool isJoint(Vec2 a, Vec2 b) const
  {
    const auto isAtValue = [&](double t)
    {
      const double distance = this->level_.face.distance(a + t * (b - a));
      return std::abs(distance - this->level_.value) <= this->level_.slack;
    };
    return norm(b - a) <= this->level_.gap ||
      (isAtValue(0.25) && isAtValue(0.5) && isAtValue(0.75));
  }

  const FaceLevel& level_;
  const Job& job_;
  std::vector<LooseEnd> from_;
  /// Ascending by x.
  std::vector<LooseEnd> to_;
  std::vector<std::size_t> next_;
};

/// Draws one face, whole or in parts.
class FaceDrawing
{
public:
  const FaceLevel& level;
  Id valueId;
  IsolineTask& task;
  /// How many there are.
  std::size_t numberOfParts = 1;

  /// Draws the part without cutting it. Returns whether that was possible.
  bool drawAtOnce(const FacePart& part)
  {
    if (part.outline.empty() && part.below &&
      this->task.arrangement.isWithinOneRegion(part.corners))
    {
      return true;
    }
    const std::vector<Remainder> remainders = this->task.arrangement.remaindersIn(part.corners);
    const auto next = EndJoiner(this->level, part, remainders, this->task.job).run();
    if (next)
    {
      this->addLines(part, remainders, *next);
    }
    return next.has_value();
  }

  /// Cuts a part in four, which share points on the segments between them.
  void split(const FacePart& part)
  {
    std::array<Vec2, 3> middles;
    std::array<bool, 3> cornerBelow{};
    std::array<bool, 3> middleBelow{};
    /// The points of each edge before and behind its middle.
    std::array<std::array<std::vector<OutlinePoint>, 2>, 3> halves;
    bool below = part.below;
    auto point = part.outline.begin();
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vec2 edge = part.corners[(k + 1) % 3] - part.corners[k];
      middles[k] = part.corners[k] + 0.5 * edge;
      cornerBelow[k] = below;
      middleBelow[k] = below;
      for (; point != part.outline.end() && point->edge == k; ++point)
      {
        const bool isBefore = dot(point->at - middles[k], edge) < 0.0 && halves[k][1].empty();
        below = !point->leaves;
        middleBelow[k] = isBefore ? below : middleBelow[k];
        halves[k][isBefore ? 0 : 1].push_back(*point);
      }
    }
    std::array<FacePart, 4> parts;
    this->numberOfParts += parts.size();
    FacePart& center = parts[3];
    center = { middles, {}, middleBelow[0], part.depth + 1 };
    std::array<std::vector<OutlinePoint>, 3> cuts;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t before = (k + 2) % 3;
      cuts[k] =
        this->pointsBetween(middles[k], middles[before], middleBelow[k], middleBelow[before]);
      FacePart& corner = parts[k];
      corner = { { part.corners[k], middles[k], middles[before] }, {}, cornerBelow[k],
        part.depth + 1 };
      addTo(corner.outline, 0, halves[k][0]);
      addTo(corner.outline, 1, cuts[k]);
      addTo(corner.outline, 2, halves[before][1]);
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      addTo(center.outline, k, cuts[(k + 1) % 3], true);
    }
    for (const FacePart& each : parts)
    {
      this->drawPart(each);
    }
  }

private:
  void drawPart(const FacePart& part)
  {
    if (this->drawAtOnce(part))
    {
      return;
    }
    if (part.depth == MaximumDepth || this->numberOfParts >= MaximumParts)
    {
      this->crossStraight(part);
    }
    else
    {
      this->split(part);
    }
  }

  /// Adds first the lines that cross the part, then the closed ones that are left. Each owner
  /// follows at most one other, and none follows an entry, so that no other loop is possible.
  void addLines(const FacePart& part, const std::vector<Remainder>& remainders,
    const std::vector<std::size_t>& next)
  {
    std::vector<std::uint8_t> used(remainders.size(), 0);
    // Follows a line from the end of the owner to an exit, or to the end of the owner again.
    const auto followFrom = [&](std::size_t owner, Line& line)
    {
      std::size_t at = next[owner];
      for (; at < remainders.size(); at = next[at])
      {
        used[at] = 1;
        follow(remainders[at], this->task.chordTolerance, line);
        if (at == owner)
        {
          return;
        }
      }
      if (line.size() > 1)
      {
        line.pop_back(); // the exit stands for it
      }
      const OutlinePoint& exit = part.outline[at - remainders.size()];
      line.push_back({ exit.at, exit.id });
    };
    for (std::size_t i = 0; i < part.outline.size(); ++i)
    {
      if (!part.outline[i].leaves)
      {
        Line line = { { part.outline[i].at, part.outline[i].id } };
        followFrom(remainders.size() + i, line);
        this->addLine(line, false);
      }
    }
    for (std::size_t i = 0; i < remainders.size(); ++i)
    {
      if (!used[i])
      {
        Line line = { { remainders[i].curve->at(remainders[i].end) } };
        followFrom(i, line);
        if (line.size() > 3) // others are scraps between two places that rounding tells apart
        {
          this->addLine(line, true);
        }
      }
    }
  }

  /// Adds a line without the points that the chord tolerance does not need.
  void addLine(const Line& line, bool isClosed)
  {
    std::vector<Id>& ids = this->task.result.ids;
    const std::size_t begin = ids.size();
    const std::size_t last = line.size() - 1;
    const auto idOf = [&](const LinePoint& p)
    { return p.id == NoId ? this->addPoint(p.at) : p.id; };
    ids.push_back(idOf(line.front()));
    for (std::size_t at = 0; at < last;)
    {
      // A closed line has three corners at least.
      const std::size_t third = at < last / 3 ? last / 3 : at < 2 * last / 3 ? 2 * last / 3 : last;
      const std::size_t next =
        std::min(chordFrom(at, line, this->task.chordTolerance), isClosed ? third : last);
      ids.push_back(isClosed && next == last ? ids[begin] : idOf(line[next]));
      at = next;
    }
    this->closePiece();
  }

  void closePiece()
  {
    IsolinePieces& result = this->task.result;
    result.pieces.push_back({ this->level.face.face(), this->valueId, result.ids.size() });
  }

  Id addPoint(Vec2 p)
  {
    const FaceDistance& face = this->level.face;
    std::vector<SurfacePoint>& points = this->task.result.points;
    points.push_back(fromBarycentric(this->task.mesh, face.face(), face.fromPlane(p)));
    return this->task.firstNewId + static_cast<Id>(points.size() - 1);
  }

  std::vector<OutlinePoint> pointsBetween(Vec2 a, Vec2 b, bool aIsBelow, bool bIsBelow)
  {
    SegmentEnvelope envelope;
    std::vector<SegmentCrossing> crossings;
    envelope.findCrossings(
      this->level.face, a, b, this->level.value, aIsBelow, bIsBelow, crossings);
    const double length = norm(b - a);
    std::vector<OutlinePoint> points;
    for (const SegmentCrossing& crossing : crossings)
    {
      const Vec2 at = length > 0.0 ? a + (crossing.at / length) * (b - a) : a;
      points.push_back({ at, this->addPoint(at), 1, crossing.rises });
    }
    return points;
  }

  /// Joins each entry to the exit beside it, so that no two lines cross.
  void crossStraight(const FacePart& part)
  {
    IsolinePieces& result = this->task.result;
    const std::size_t count = part.outline.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      if (!part.outline[i].leaves)
      {
        result.ids.push_back(part.outline[i].id);
        result.ids.push_back(part.outline[(i + 1) % count].id);
        this->closePiece();
      }
    }
  }
};

} // anonymous namespace

// Draws the face in one part if that is possible. Paths that bend at a window's end or at a regular
// corner only fill gaps that rounding leaves between pencils: they are tried last. So is a larger
// offset between curves, which orders curves that nearly coincide.
void drawInFace(const FaceDistance& face, double level, Id valueId,
  const std::vector<OutlinePoint>& outline, bool below, IsolineTask& task)
{
  const FaceLevel faceLevel(face, level);
  const FacePart whole = { faceLevel.corners, outline, below, 0 };
  FaceDrawing drawing{ faceLevel, valueId, task };
  for (const bool withBent : { false, true })
  {
    for (const double offset : { tolerance::CurveOffset, tolerance::LargerCurveOffset })
    {
      task.arrangement.assign(faceLevel, withBent, offset);
      if (drawing.drawAtOnce(whole))
      {
        return;
      }
    }
  }
  drawing.split(whole);
}

}
