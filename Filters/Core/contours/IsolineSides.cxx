// SPDX-License-Identifier: BSD-3-Clause
#include "contours/IsolineSides.h"

#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

namespace
{

// How often a chord is halved to find where its side changes: down to rounding.
constexpr int Halvings = 50;

/// A chord that is on one side, or a part of one, with its end.
struct SidedChord
{
  Id face;
  Id end;
  bool isOnRight;
};

class Cutter
{
public:
  Cutter(const DistanceField& field, NearestSource& nearest,
    const std::function<bool(const Foot&)>& isOnRight, const Isolines& isolines, const Job& job)
    : field_(field)
    , mesh_(field.mesh())
    , nearest_(nearest)
    , isOnRight_(isOnRight)
    , job_(job)
  {
    for (const Isoline& line : isolines.lines)
    {
      this->chords_ += static_cast<double>(line.faces.size());
    }
    this->result.points = isolines.points;
    this->result.linesWithoutDirection = isolines.linesWithoutDirection;
  }

  /// A closed line that is cut begins where its side changes. Parts on the right-hand side are
  /// turned around.
  void cut(const Isoline& line, const SidedValue& value)
  {
    std::vector<SidedChord> chords = this->withSides(line);
    Id at = line.points.front();
    const auto change = std::adjacent_find(chords.begin(), chords.end(),
      [](const SidedChord& a, const SidedChord& b) { return a.isOnRight != b.isOnRight; });
    if (line.isClosed() && change != chords.end())
    {
      at = change->end;
      std::rotate(chords.begin(), change + 1, chords.end());
    }
    for (auto chord = chords.begin(); chord != chords.end();)
    {
      const bool isRight = chord->isOnRight;
      Isoline part = { isRight ? value.right : value.left, { at }, {} };
      for (; chord != chords.end() && chord->isOnRight == isRight; ++chord)
      {
        at = chord->end;
        part.points.push_back(at);
        part.faces.push_back(chord->face);
      }
      if (isRight)
      {
        std::reverse(part.points.begin(), part.points.end());
        std::reverse(part.faces.begin(), part.faces.end());
      }
      if (part.value != SidedValue::None)
      {
        this->result.lines.push_back(std::move(part));
      }
    }
  }

  Isolines result;

private:
  Barycentric onChord(const Isoline& line, std::size_t chord, double t) const
  {
    const Id face = line.faces[chord];
    const auto place = [&](std::size_t i)
    { return barycentric(this->mesh_, this->result.points[line.points[i]], face); };
    return between(place(chord), place(chord + 1), t);
  }

  bool isOnRightAt(const SurfacePoint& place)
  {
    return this->isOnRight_(this->nearest_.of(incomingSegmentTo(this->field_, place)));
  }

  std::vector<SidedChord> withSides(const Isoline& line)
  {
    std::vector<SidedChord> chords;
    for (std::size_t chord = 0; chord < line.faces.size(); ++chord)
    {
      this->job_.look(this->chordsDone_++ / this->chords_);
      const Id face = line.faces[chord];
      const auto isRightAt = [&](double t) {
        return this->isOnRightAt(fromBarycentric(this->mesh_, face, this->onChord(line, chord, t)));
      };
      const bool before = isRightAt(tolerance::BesideChordEnd);
      const bool behind = isRightAt(1.0 - tolerance::BesideChordEnd);
      if (before != behind)
      {
        chords.push_back({ face, this->addChange(line, chord, before), before });
      }
      chords.push_back({ face, line.points[chord + 1], behind });
    }
    return chords;
  }

  /// A point of a chord, moved along the ray that comes to it, to the value of the line: along a
  /// ray the distance changes as much as the place.
  SurfacePoint onLine(const Isoline& line, std::size_t chord, double t, double value) const
  {
    const Id face = line.faces[chord];
    const Id frame = longestHalfedge(this->mesh_, face);
    const Barycentric place = this->onChord(line, chord, t);
    const IncomingSegment piece =
      incomingSegmentTo(this->field_, fromBarycentric(this->mesh_, face, place));
    Vec2 at = inHalfedgeFrame(this->mesh_, frame, place);
    const double length = norm(piece.ray.vector);
    if (piece.ray.halfedge != NoId && TriangleMesh::faceOf(piece.ray.halfedge) == face &&
      length > 0.0)
    {
      const Vec2 along =
        turned(this->mesh_, (1.0 / length) * piece.ray.vector, piece.ray.halfedge, frame);
      at = at + (value - piece.distance) * along;
    }
    return fromBarycentric(this->mesh_, face, fromHalfedgeFrame(this->mesh_, frame, at));
  }

  /// Adds the point of the line where the side changes. On the chord the change may be elsewhere,
  /// and from there a ray leads to where the other side is nearer.
  Id addChange(const Isoline& line, std::size_t chord, bool isRightBefore)
  {
    const double value =
      incomingSegmentTo(this->field_, this->result.points[line.points[chord]]).distance;
    double begin = tolerance::BesideChordEnd;
    double end = 1.0 - tolerance::BesideChordEnd;
    for (int i = 0; i < Halvings; ++i)
    {
      const double middle = 0.5 * (begin + end);
      const bool isRight = this->isOnRightAt(this->onLine(line, chord, middle, value));
      (isRight == isRightBefore ? begin : end) = middle;
    }
    this->result.points.push_back(this->onLine(line, chord, begin, value));
    return static_cast<Id>(this->result.points.size() - 1);
  }

  const DistanceField& field_;
  const TriangleMesh& mesh_;
  NearestSource& nearest_;
  const std::function<bool(const Foot&)>& isOnRight_;
  const Job& job_;
  /// The number of chords of all lines, and how many are done.
  double chords_ = 0.0;
  double chordsDone_ = 0.0;
};

} // anonymous namespace

Isolines linesOnSides(const DistanceField& field, NearestSource& nearest,
  const std::function<bool(const Foot&)>& isOnRight, const Isolines& isolines,
  const std::vector<SidedValue>& values, const Job& job)
{
  Cutter cutter(field, nearest, isOnRight, isolines, job);
  for (const Isoline& line : isolines.lines)
  {
    cutter.cut(line, values[line.value]);
  }
  std::stable_sort(cutter.result.lines.begin(), cutter.result.lines.end(),
    [](const Isoline& a, const Isoline& b) { return a.value < b.value; });
  return std::move(cutter.result);
}

}
