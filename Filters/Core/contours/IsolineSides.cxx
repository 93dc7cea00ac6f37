// SPDX-License-Identifier: BSD-3-Clause
#include "contours/IsolineSides.h"

#include "PacedProgress.h"

#include <algorithm>

namespace geodesic
{

namespace
{

// Where the side of a chord is found, as a fraction of the chord from its ends: at the ends
// themselves two sides may meet.
constexpr double BesideEnd = 1e-6;
// How often a chord is halved to find where its side changes: down to rounding.
constexpr int Halvings = 50;

/// A line each of whose chords is on one side.
struct SidedLine
{
  Isoline line;
  std::vector<std::uint8_t> isOnRight;
};

class Cutter
{
public:
  Cutter(const DistanceField& field, NearestSource& nearest,
    const std::function<bool(const Foot&)>& isOnRight, const Isolines& isolines,
    const ProgressCallback& progress)
    : field_(field)
    , mesh_(field.mesh())
    , nearest_(nearest)
    , isOnRight_(isOnRight)
    , progress_(paced(progress))
    , chords_(1)
  {
    for (const Isoline& line : isolines.lines)
    {
      this->chords_ += line.faces.size();
    }
    this->result_.points = isolines.points;
    this->result_.linesWithoutDirection = isolines.linesWithoutDirection;
    this->result_.partsCrossedStraight = isolines.partsCrossedStraight;
  }

  void cut(const Isoline& line, const SidedValue& value);
  Isolines release() { return std::move(this->result_); }

private:
  Barycentric onChord(const Isoline& line, std::size_t chord, double t) const;
  IncomingSegment pieceTo(const Isoline& line, std::size_t chord, double t) const;
  bool isOnRightAt(const Isoline& line, std::size_t chord, double t);
  void report();
  SidedLine withSides(const Isoline& line);
  Id addChange(const Isoline& line, std::size_t chord, bool isRightBefore);
  void addPart(const SidedLine& sided, std::size_t first, std::size_t last, std::size_t value);

  const DistanceField& field_;
  const TriangleMesh& mesh_;
  NearestSource& nearest_;
  const std::function<bool(const Foot&)>& isOnRight_;
  ProgressCallback progress_;
  /// The number of chords of all lines, and how many are done.
  std::size_t chords_;
  std::size_t chordsDone_ = 0;
  Isolines result_;
};

void Cutter::report()
{
  reportProgress(
    this->progress_, static_cast<double>(this->chordsDone_++) / static_cast<double>(this->chords_));
}

Barycentric Cutter::onChord(const Isoline& line, std::size_t chord, double t) const
{
  const Id face = line.faces[chord];
  const Barycentric a = barycentric(this->mesh_, this->result_.points[line.points[chord]], face);
  const Barycentric b =
    barycentric(this->mesh_, this->result_.points[line.points[chord + 1]], face);
  return between(a, b, t);
}

IncomingSegment Cutter::pieceTo(const Isoline& line, std::size_t chord, double t) const
{
  return incomingSegmentTo(
    this->field_, fromBarycentric(this->mesh_, line.faces[chord], this->onChord(line, chord, t)));
}

bool Cutter::isOnRightAt(const Isoline& line, std::size_t chord, double t)
{
  return this->isOnRight_(this->nearest_.of(this->pieceTo(line, chord, t)));
}

SidedLine Cutter::withSides(const Isoline& line)
{
  SidedLine sided;
  sided.line.value = line.value;
  sided.line.points = { line.points.front() };
  const auto add = [&sided](Id face, Id point, bool isRight)
  {
    sided.line.faces.push_back(face);
    sided.line.points.push_back(point);
    sided.isOnRight.push_back(isRight ? 1 : 0);
  };
  for (std::size_t chord = 0; chord < line.faces.size(); ++chord)
  {
    this->report();
    const bool before = this->isOnRightAt(line, chord, BesideEnd);
    const bool behind = this->isOnRightAt(line, chord, 1.0 - BesideEnd);
    if (before != behind)
    {
      add(line.faces[chord], this->addChange(line, chord, before), before);
    }
    add(line.faces[chord], line.points[chord + 1], behind);
  }
  return sided;
}

// Adds the point where the side changes. It is moved along the ray that comes to it, to the value
// of the line: along a ray the distance changes as much as the place.
Id Cutter::addChange(const Isoline& line, std::size_t chord, bool isRightBefore)
{
  double begin = BesideEnd;
  double end = 1.0 - BesideEnd;
  for (int i = 0; i < Halvings; ++i)
  {
    const double middle = 0.5 * (begin + end);
    (this->isOnRightAt(line, chord, middle) == isRightBefore ? begin : end) = middle;
  }
  const Id face = line.faces[chord];
  const Id frame = longestHalfedge(this->mesh_, face);
  const IncomingSegment piece = this->pieceTo(line, chord, begin);
  Vec2 at = inHalfedgeFrame(this->mesh_, frame, this->onChord(line, chord, begin));
  const double length = norm(piece.direction);
  if (piece.frame != NoId && TriangleMesh::faceOf(piece.frame) == face && length > 0.0)
  {
    const Vec2 along = turned(this->mesh_, (1.0 / length) * piece.direction, piece.frame, frame);
    const double value =
      incomingSegmentTo(this->field_, this->result_.points[line.points[chord]]).distance;
    at = at + (value - piece.distance) * along;
  }
  this->result_.points.push_back(
    fromBarycentric(this->mesh_, face, fromHalfedgeFrame(this->mesh_, frame, at)));
  return static_cast<Id>(this->result_.points.size() - 1);
}

// A closed line that is cut begins where its side changes.
void Cutter::cut(const Isoline& line, const SidedValue& value)
{
  SidedLine sided = this->withSides(line);
  const std::size_t chords = sided.isOnRight.size();
  std::size_t first = 0;
  if (line.isClosed())
  {
    const auto change = std::adjacent_find(
      sided.isOnRight.begin(), sided.isOnRight.end(), std::not_equal_to<std::uint8_t>());
    if (change != sided.isOnRight.end())
    {
      const std::ptrdiff_t turn = change + 1 - sided.isOnRight.begin();
      std::rotate(sided.isOnRight.begin(), change + 1, sided.isOnRight.end());
      std::rotate(
        sided.line.faces.begin(), sided.line.faces.begin() + turn, sided.line.faces.end());
      sided.line.points.pop_back();
      std::rotate(
        sided.line.points.begin(), sided.line.points.begin() + turn, sided.line.points.end());
      sided.line.points.push_back(sided.line.points.front());
    }
  }
  while (first < chords)
  {
    std::size_t last = first;
    while (last < chords && sided.isOnRight[last] == sided.isOnRight[first])
    {
      ++last;
    }
    const std::size_t number = sided.isOnRight[first] != 0 ? value.right : value.left;
    if (number != SidedValue::None)
    {
      this->addPart(sided, first, last, number);
    }
    first = last;
  }
}

void Cutter::addPart(const SidedLine& sided, std::size_t first, std::size_t last, std::size_t value)
{
  const auto chord = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
  Isoline part;
  part.value = value;
  part.points.assign(
    sided.line.points.begin() + chord(first), sided.line.points.begin() + chord(last) + 1);
  part.faces.assign(
    sided.line.faces.begin() + chord(first), sided.line.faces.begin() + chord(last));
  if (sided.isOnRight[first] != 0)
  {
    std::reverse(part.points.begin(), part.points.end());
    std::reverse(part.faces.begin(), part.faces.end());
  }
  this->result_.lines.push_back(std::move(part));
}

} // anonymous namespace

Isolines linesOnSides(const DistanceField& field, NearestSource& nearest,
  const std::function<bool(const Foot&)>& isOnRight, const Isolines& isolines,
  const std::vector<SidedValue>& values, const ProgressCallback& progress)
{
  Cutter cutter(field, nearest, isOnRight, isolines, progress);
  for (const Isoline& line : isolines.lines)
  {
    cutter.cut(line, values[line.value]);
  }
  Isolines result = cutter.release();
  std::stable_sort(result.lines.begin(), result.lines.end(),
    [](const Isoline& a, const Isoline& b) { return a.value < b.value; });
  return result;
}

}
