// SPDX-License-Identifier: BSD-3-Clause
#include "contours/IsolineJoin.h"

#include "Errors.h"
#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

void IsolineJoin::add(const IsolinePieces& pieces)
{
  const std::size_t before = this->ids_.size();
  if (this->points_.size() + pieces.points.size() >= NoId / 2)
  {
    throw Error(
      "The isolines have too many points. Raise the chord tolerance or give fewer values.");
  }
  const Id shift = static_cast<Id>(this->points_.size()) - this->edgePoints_;
  for (IsolinePieces::Piece piece : pieces.pieces)
  {
    piece.end += before;
    this->pieces_.push_back(piece);
  }
  for (const Id id : pieces.ids)
  {
    this->ids_.push_back(id < this->edgePoints_ ? id : id + shift);
  }
  this->points_.insert(this->points_.end(), pieces.points.begin(), pieces.points.end());
  this->partsCrossedStraight_ += pieces.partsCrossedStraight;
}

Id IsolineJoin::pointAt(PieceEnd end) const
{
  const Id piece = end / 2;
  return this->ids_[end % 2 == 1 ? this->pieces_[piece].end - 1 : this->firstOf(piece)];
}

void IsolineJoin::linkEnds()
{
  constexpr Id more = 3; // than meet where a line goes on
  this->nodes_.assign(this->points_.size(), {});
  for (const Id point : this->ends_)
  {
    this->nodes_[point].count = more;
  }
  for (PieceEnd end = 0; end < 2 * this->pieces_.size(); ++end)
  {
    Node& node = this->nodes_[this->pointAt(end)];
    if (node.count < 2)
    {
      node.ends[node.count] = end;
    }
    ++node.count;
  }
}

IsolineJoin::PieceEnd IsolineJoin::other(PieceEnd end) const
{
  const Node& node = this->nodes_[this->pointAt(end)];
  return node.ends[0] == end ? node.ends[1] : node.ends[0];
}

// Lines that end somewhere first, so that what is left is closed.
Isolines IsolineJoin::finish()
{
  this->linkEnds();
  Isolines result;
  result.partsCrossedStraight = this->partsCrossedStraight_;
  this->isUsed_.assign(this->pieces_.size(), 0);
  for (PieceEnd end = 0; end < 2 * this->pieces_.size(); ++end)
  {
    if (!this->isUsed_[end / 2] && !this->isThrough(end))
    {
      this->follow(end, result);
    }
  }
  for (PieceEnd end = 0; end < 2 * this->pieces_.size(); end += 2)
  {
    if (!this->isUsed_[end / 2])
    {
      this->follow(end, result);
    }
  }
  const auto last = std::remove_if(result.lines.begin(), result.lines.end(),
    [this](Isoline& line) { return !this->shorten(line); });
  result.lines.erase(last, result.lines.end());
  std::stable_sort(result.lines.begin(), result.lines.end(),
    [](const Isoline& a, const Isoline& b) { return a.value < b.value; });
  this->takeUsedPoints(result);
  return result;
}

// The first piece says which way the line runs, should they differ.
void IsolineJoin::follow(PieceEnd begin, Isolines& result)
{
  Isoline line;
  line.value = this->pieces_[begin / 2].value;
  line.points.push_back(this->pointAt(begin));
  std::size_t backwards = 0;
  std::size_t pieces = 0;
  PieceEnd at = begin;
  do
  {
    this->addPiece(at, line);
    this->isUsed_[at / 2] = 1;
    backwards += at % 2;
    ++pieces;
    const PieceEnd end = at ^ 1U;
    at = this->isThrough(end) ? this->other(end) : NoId;
  } while (at != NoId && at != begin && !this->isUsed_[at / 2]);
  if (begin % 2 == 1)
  {
    std::reverse(line.points.begin(), line.points.end());
    std::reverse(line.faces.begin(), line.faces.end());
  }
  result.linesWithoutDirection += backwards > 0 && backwards < pieces ? 1 : 0;
  result.lines.push_back(std::move(line));
}

// From its begin on, or against it from its end.
void IsolineJoin::addPiece(PieceEnd begin, Isoline& line) const
{
  const Id piece = begin / 2;
  const std::size_t first = this->firstOf(piece);
  const std::size_t last = this->pieces_[piece].end - 1;
  for (std::size_t i = 1; i <= last - first; ++i)
  {
    line.points.push_back(this->ids_[begin % 2 == 0 ? first + i : last - i]);
    line.faces.push_back(this->pieces_[piece].face);
  }
}

// A line that passes a vertex has a point there from each edge around. In a face pieces may meet a
// rounding apart.
bool IsolineJoin::isShort(const SurfacePoint& a, const SurfacePoint& b, Id face, double level) const
{
  using Kind = SurfacePoint::Kind;
  if (a.kind == Kind::Vertex && b.kind == Kind::Vertex)
  {
    return a.id == b.id;
  }
  if (a.kind != Kind::Face && b.kind != Kind::Face)
  {
    return false; // neither point can be spared
  }
  const double least = tolerance::IsolineGap * std::min(this->mesh_.shape(face).longest(), level);
  return distanceInSpace(this->mesh_, a, b) <= least;
}

// Round a vertex at exactly the value, or a vertex that is beyond it by rounding alone.
bool IsolineJoin::isSpeck(const Isoline& line) const
{
  const SurfacePoint& first = this->points_[line.points.front()];
  double longest = 0.0;
  double extent = 0.0;
  for (std::size_t i = 0; i < line.faces.size(); ++i)
  {
    const SurfacePoint& next = this->points_[line.points[i + 1]];
    longest = std::max(longest, this->mesh_.shape(line.faces[i]).longest());
    extent = std::max(extent, distanceInSpace(this->mesh_, first, next));
  }
  const double gap = tolerance::IsolineGap * std::min(longest, this->levels_[line.value]);
  return extent <= gap && (line.faces.empty() || this->isRoundOnePlace(line, gap));
}

// Whether a line so short goes round a vertex or a place of an edge. Across faces that are no
// higher than that, lines are as short but go on.
bool IsolineJoin::isRoundOnePlace(const Isoline& line, double gap) const
{
  using Kind = SurfacePoint::Kind;
  const auto all = [&](auto&& isThere)
  {
    return std::all_of(line.points.begin(), line.points.end(),
      [&](Id id) { return this->points_[id].kind == Kind::Face || isThere(this->points_[id]); });
  };
  for (Id corner = 3 * line.faces.front(); corner < 3 * line.faces.front() + 3; ++corner)
  {
    const Id vertex = this->mesh_.origin(corner);
    const auto isBeside = [&](const SurfacePoint& p)
    {
      return p.kind == Kind::Vertex
        ? p.id == vertex
        : (this->mesh_.origin(p.id) == vertex || this->mesh_.destination(p.id) == vertex) &&
          norm(position(this->mesh_, p) - this->mesh_.point(vertex)) <= gap;
    };
    const auto isOnEdge = [&](const SurfacePoint& p)
    { return p.kind == Kind::Edge && this->mesh_.edgeOf(p.id) == this->mesh_.edgeOf(corner); };
    if (all(isBeside) || all(isOnEdge))
    {
      return true;
    }
  }
  return false;
}

// Drops the chords of a line that have hardly any length. Returns whether anything is left. The
// face of a chord still holds both of its ends: a point inside a face has both chords in it, a
// vertex is in all faces around.
bool IsolineJoin::shorten(Isoline& line) const
{
  const Isoline whole = line;
  line.points = { whole.points.front() };
  line.faces.clear();
  for (std::size_t i = 0; i < whole.faces.size(); ++i)
  {
    const Id next = whole.points[i + 1];
    const Id face = whole.faces[i];
    if (!this->isShort(
          this->points_[line.points.back()], this->points_[next], face, this->levels_[line.value]))
    {
      line.points.push_back(next);
      line.faces.push_back(face);
    }
    else if (this->points_[next].kind != SurfacePoint::Kind::Face || i + 1 == whole.faces.size())
    {
      line.points.back() = next; // the one that is needed, or that other lines may share
    }
  }
  line.points.front() = whole.points.front();
  const auto goesOn = [this](Id point)
  { return std::binary_search(this->ends_.begin(), this->ends_.end(), point); };
  return goesOn(line.points.front()) || goesOn(line.points.back()) ? !line.faces.empty()
                                                                   : !this->isSpeck(line);
}

void IsolineJoin::takeUsedPoints(Isolines& result) const
{
  std::vector<Id> number(this->points_.size(), NoId);
  for (Isoline& line : result.lines)
  {
    for (Id& point : line.points)
    {
      if (number[point] == NoId)
      {
        number[point] = static_cast<Id>(result.points.size());
        result.points.push_back(this->points_[point]);
      }
      point = number[point];
    }
  }
}

}
