// SPDX-License-Identifier: BSD-3-Clause
#include "contours/FaceIsolines.h"

#include "Tolerance.h"
#include "Trigonometry.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace geodesic
{

namespace
{

using Remainder = LevelArrangement::Remainder;

constexpr std::size_t None = static_cast<std::size_t>(-1);

/// Joins the ends of remainders and the points of a face's outline to lines. Remainders are
/// numbered first, the points of the outline behind them.
class EndJoiner
{
public:
  EndJoiner(const FaceLevel& level, const std::vector<OutlinePoint>& outline,
    const std::vector<Remainder>& remainders, const Job& job)
    : level_(level)
    , job_(job)
    , next_(remainders.size() + outline.size(), None)
  {
    this->from_.reserve(this->next_.size());
    this->to_.reserve(this->next_.size());
    std::size_t owner = 0;
    for (const Remainder& r : remainders)
    {
      this->from_.push_back({ r.curve->at(r.end), owner });
      this->to_.push_back({ r.curve->at(r.begin), owner++ });
    }
    for (const OutlinePoint& p : outline)
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

/// A point of a line: where parts of level curves meet, or one inside an arc.
struct LinePoint
{
  Vec2 at;
  /// NoId for a new one.
  Id id = NoId;
  /// The largest distance of the line from its chord, between this point and the next one.
  double sagitta = 0.0;
};
using Line = std::vector<LinePoint>;

// The largest angle of a chord, so that a circle looks like one, and the tangent of its half.
constexpr double LargestStep = Pi / 6.0;
constexpr double TangentOfHalfStep = 0.2679491924311227; // 2 - sqrt(3)

/// The distance of an arc from its chord.
///
/// \param halfTangent the tangent of half the arc's angle.
double sagittaOf(double radius, double halfTangent)
{
  const double squared = halfTangent * halfTangent;
  const double root = std::sqrt(1.0 + squared);
  return radius * squared / (root * (1.0 + root));
}

/// Adds the points of a remainder to the end of a line, of an arc so many that no chord is farther
/// from the arc than the tolerance. Most arcs are one chord. Points are at the value only up to a
/// tie, so that no chord need be nearer to its arc.
void follow(const Remainder& remainder, double chordTolerance, Line& line)
{
  const auto& [curve, begin, end] = remainder;
  const double halfTangent = (end - begin) / (1.0 + end * begin);
  line.back().sagitta = curve->isArc ? sagittaOf(curve->radius, halfTangent) : 0.0;
  if (curve->isArc && (line.back().sagitta > chordTolerance || halfTangent > TangentOfHalfStep))
  {
    const double first = 2.0 * polarAngle({ 1.0, begin });
    const double angle = 2.0 * polarAngle({ 1.0, halfTangent });
    const double least = std::clamp(chordTolerance / curve->radius, tolerance::Tie, 1.0);
    const double step = std::min(LargestStep, 4.0 * arcSine(std::sqrt(0.5 * least)));
    const double chords = std::max(1.0, std::ceil(angle / step));
    const double sagitta = sagittaOf(curve->radius, tangent(0.5 * angle / chords));
    line.back().sagitta = sagitta;
    const auto count = static_cast<std::size_t>(chords);
    for (std::size_t i = 1; i < count; ++i)
    {
      const double parameter = tangent(0.5 * (first + static_cast<double>(i) / chords * angle));
      line.push_back({ curve->at(parameter), NoId, sagitta });
    }
  }
  line.push_back({ curve->at(end) });
}

/// The end of the longest chord from a point that is near enough to all of the line below it.
std::size_t chordFrom(std::size_t first, const Line& line, double chordTolerance)
{
  const auto isNear = [&](std::size_t end)
  {
    const Vec2 chord = line[end].at - line[first].at;
    const double squared = dot(chord, chord);
    for (std::size_t i = first + 1; i < end; ++i)
    {
      const Vec2 p = line[i].at - line[first].at;
      const double t = squared > 0.0 ? std::clamp(dot(p, chord) / squared, 0.0, 1.0) : 0.0;
      const double sagitta = std::max(line[i - 1].sagitta, line[i].sagitta);
      if (!(norm(p - t * chord) + sagitta <= chordTolerance))
      {
        return false;
      }
    }
    return true;
  };
  std::size_t end = first + 1;
  while (end + 1 < line.size() && isNear(end + 1))
  {
    ++end;
  }
  return end;
}

/// Draws one face.
class FaceDrawing
{
public:
  const FaceLevel& level;
  Id valueId;
  const std::vector<OutlinePoint>& outline;
  /// Whether corner 0 is below the level.
  bool below;
  IsolineTask& task;

  /// Draws the lines by the task's arrangement. Returns whether that was possible.
  bool draw()
  {
    if (this->outline.empty() && this->below && this->task.arrangement.isWithinOneRegion())
    {
      return true;
    }
    const std::vector<Remainder> remainders = this->task.arrangement.remainders();
    const auto next = EndJoiner(this->level, this->outline, remainders, this->task.job).run();
    if (next)
    {
      this->addLines(remainders, *next);
    }
    return next.has_value();
  }

  /// Joins each entry to the exit beside it, so that no two lines cross.
  void crossStraight()
  {
    IsolinePieces& result = this->task.result;
    const std::size_t count = this->outline.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      if (!this->outline[i].leaves)
      {
        result.ids.push_back(this->outline[i].id);
        result.ids.push_back(this->outline[(i + 1) % count].id);
        this->closePiece();
      }
    }
  }

private:
  /// Adds first the lines that cross the face, then the closed ones that are left. Each owner
  /// follows at most one other, and none follows an entry, so that no other loop is possible.
  void addLines(const std::vector<Remainder>& remainders, const std::vector<std::size_t>& next)
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
      const OutlinePoint& exit = this->outline[at - remainders.size()];
      line.push_back({ exit.at, exit.id });
    };
    for (std::size_t i = 0; i < this->outline.size(); ++i)
    {
      if (!this->outline[i].leaves)
      {
        Line line = { { this->outline[i].at, this->outline[i].id } };
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
    {
      if (p.id != NoId)
      {
        return p.id;
      }
      const FaceDistance& face = this->level.face;
      std::vector<SurfacePoint>& points = this->task.result.points;
      points.push_back(fromBarycentric(this->task.mesh, face.face(), face.fromPlane(p.at)));
      return this->task.firstNewId + static_cast<Id>(points.size() - 1);
    };
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
};

} // anonymous namespace

// Paths that bend at a window's end or at a regular corner only fill gaps that rounding leaves
// between pencils: they are tried last. So is a larger offset between curves, which orders curves
// that nearly coincide.
void drawInFace(const FaceDistance& face, double level, Id valueId,
  const std::vector<OutlinePoint>& outline, bool below, IsolineTask& task)
{
  const FaceLevel faceLevel(face, level);
  FaceDrawing drawing{ faceLevel, valueId, outline, below, task };
  for (const bool withBent : { false, true })
  {
    for (const double offset : { tolerance::CurveOffset, tolerance::LargerCurveOffset })
    {
      task.arrangement.assign(faceLevel, withBent, offset);
      if (drawing.draw())
      {
        return;
      }
    }
  }
  drawing.crossStraight();
}

}
