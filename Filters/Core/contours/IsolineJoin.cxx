// SPDX-License-Identifier: BSD-3-Clause
#include "contours/IsolineJoin.h"

#include "Chains.h"
#include "Errors.h"
#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

namespace
{

class PieceJoiner
{
public:
  PieceJoiner(const TriangleMesh& mesh, const std::vector<double>& levels,
    std::vector<SurfacePoint> onEdges, const std::vector<Id>& atSeams)
    : mesh_(mesh)
    , levels_(levels)
    , atSeams_(atSeams)
    , edgePoints_(static_cast<Id>(onEdges.size()))
    , points_(std::move(onEdges))
  {
  }

  void add(const IsolinePieces& drawn)
  {
    if (this->points_.size() + drawn.points.size() >= NoId / 2)
    {
      throw Error(
        "The isolines have too many points. Raise the chord tolerance or give fewer values.");
    }
    const std::size_t before = this->ids_.size();
    const Id shift = static_cast<Id>(this->points_.size()) - this->edgePoints_;
    for (const IsolinePieces::Piece& piece : drawn.pieces)
    {
      this->pieces_.push_back({ piece.face, piece.value, before + piece.end });
    }
    for (const Id id : drawn.ids)
    {
      this->ids_.push_back(id < this->edgePoints_ ? id : id + shift);
    }
    this->points_.insert(this->points_.end(), drawn.points.begin(), drawn.points.end());
  }

  Isolines run()
  {
    std::vector<Chain> chains = followChains(this->pointsAtEnds());
    beginAtLowestEnds(chains);
    for (const Chain& chain : chains)
    {
      this->addLine(chain);
    }
    std::vector<Isoline>& lines = this->result_.lines;
    const auto last = std::remove_if(
      lines.begin(), lines.end(), [this](Isoline& line) { return !this->shorten(line); });
    lines.erase(last, lines.end());
    std::stable_sort(lines.begin(), lines.end(),
      [](const Isoline& a, const Isoline& b) { return a.value < b.value; });
    this->takeUsedPoints();
    return std::move(this->result_);
  }

private:
  std::size_t firstOf(Id piece) const { return piece == 0 ? 0 : this->pieces_[piece - 1].end; }

  Id pointAt(Id end) const
  {
    const Id piece = end / 2;
    return this->ids_[end % 2 == 1 ? this->pieces_[piece].end - 1 : this->firstOf(piece)];
  }

  /// Of all pieces; NoId where the line of another rank continues.
  std::vector<Id> pointsAtEnds() const
  {
    std::vector<Id> points(2 * this->pieces_.size());
    for (Id end = 0; end < points.size(); ++end)
    {
      const Id point = this->pointAt(end);
      points[end] = this->isAtSeam(point) ? NoId : point;
    }
    return points;
  }

  bool isAtSeam(Id point) const
  {
    return std::binary_search(this->atSeams_.begin(), this->atSeams_.end(), point);
  }

  // If the directions of pieces differ, the first one says which way the line runs.
  void addLine(const Chain& chain)
  {
    const Id begin = chain.ends.front();
    Isoline line = { this->pieces_[begin / 2].value, { this->pointAt(begin) }, {} };
    std::size_t backwards = 0;
    for (const Id end : chain.ends)
    {
      const IsolinePieces::Piece& piece = this->pieces_[end / 2];
      const std::size_t first = this->firstOf(end / 2);
      const std::size_t last = piece.end - 1;
      for (std::size_t i = 1; i <= last - first; ++i)
      {
        line.points.push_back(this->ids_[end % 2 == 0 ? first + i : last - i]);
        line.faces.push_back(piece.face);
      }
      backwards += end % 2;
    }
    if (begin % 2 == 1)
    {
      std::reverse(line.points.begin(), line.points.end());
      std::reverse(line.faces.begin(), line.faces.end());
    }
    this->result_.linesWithoutDirection += backwards > 0 && backwards < chain.ends.size() ? 1 : 0;
    this->result_.lines.push_back(std::move(line));
  }

  // A line that passes a vertex has a point there from each edge around. In a face pieces may meet
  // a rounding apart.
  bool isShort(const SurfacePoint& a, const SurfacePoint& b, Id face, double level) const
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
  bool isSpeck(const Isoline& line) const
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
  bool isRoundOnePlace(const Isoline& line, double gap) const
  {
    using Kind = SurfacePoint::Kind;
    const auto all = [&](auto&& isThere)
    {
      return std::all_of(line.points.begin(), line.points.end(),
        [&](Id id) { return this->points_[id].kind == Kind::Face || isThere(this->points_[id]); });
    };
    for (const Id corner : TriangleMesh::halfedgesOf(line.faces.front()))
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
  bool shorten(Isoline& line) const
  {
    const Isoline whole = line;
    line.points = { whole.points.front() };
    line.faces.clear();
    for (std::size_t i = 0; i < whole.faces.size(); ++i)
    {
      const Id next = whole.points[i + 1];
      const Id face = whole.faces[i];
      if (!this->isShort(this->points_[line.points.back()], this->points_[next], face,
            this->levels_[line.value]))
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
    return this->isAtSeam(line.points.front()) || this->isAtSeam(line.points.back())
      ? !line.faces.empty()
      : !this->isSpeck(line);
  }

  void takeUsedPoints()
  {
    std::vector<Id> number(this->points_.size(), NoId);
    for (Isoline& line : this->result_.lines)
    {
      for (Id& point : line.points)
      {
        if (number[point] == NoId)
        {
          number[point] = static_cast<Id>(this->result_.points.size());
          this->result_.points.push_back(this->points_[point]);
        }
        point = number[point];
      }
    }
  }

  const TriangleMesh& mesh_;
  const std::vector<double>& levels_;
  const std::vector<Id>& atSeams_;
  Id edgePoints_;
  /// The pieces, as in IsolinePieces.
  std::vector<IsolinePieces::Piece> pieces_;
  std::vector<Id> ids_;
  std::vector<SurfacePoint> points_;
  Isolines result_;
};

} // anonymous namespace

Isolines joinPieces(const TriangleMesh& mesh, const std::vector<double>& levels,
  std::vector<SurfacePoint> onEdges, const std::vector<Id>& atSeams,
  std::vector<IsolinePieces> drawn)
{
  PieceJoiner joiner(mesh, levels, std::move(onEdges), atSeams);
  for (IsolinePieces& pieces : drawn)
  {
    joiner.add(pieces);
    pieces = IsolinePieces(); // frees the memory
  }
  return joiner.run();
}

}
