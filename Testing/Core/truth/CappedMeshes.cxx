// SPDX-License-Identifier: BSD-3-Clause
#include "truth/CappedMeshes.h"

#include <algorithm>
#include <map>

namespace geodesictest
{

namespace
{

struct PointOnEdge
{
  double fraction;
  Index vertex;
  bool operator<(const PointOnEdge& other) const { return this->fraction < other.fraction; }
};

/// Vertices on an edge, in their order.
using Chain = std::vector<PointOnEdge>;
/// Vertices on the edges of a face, from each corner to the next.
using Splits = std::array<std::vector<Index>, 3>;

/// An edge of a face; without a face it is the edge of a pocket.
struct Side
{
  static constexpr Index NoFace = ~Index(0);
  Index face = NoFace;
  std::size_t k = 0;
};

Vec3 beside(const Vec3& place, double offset, Random& random)
{
  Vec3 moved = place;
  for (double& x : moved)
  {
    x += offset > 0.0 ? offset * random.uniform(-1.0, 1.0) : 0.0;
  }
  return moved;
}

/// Adds new vertices on the edge from a to b.
Chain addPoints(
  PlainMesh& mesh, const std::pair<Index, Index>& edge, Index count, Random& random, double offset)
{
  const Vec3 p = mesh.points[edge.first];
  const Vec3 q = mesh.points[edge.second];
  const double shift = random.uniform(0.0, 0.5);
  Chain points;
  for (Index i = 0; i < count; ++i)
  {
    const double t = (i + shift + random.uniform(0.05, 0.4)) / count;
    points.push_back({ t, static_cast<Index>(mesh.points.size()) });
    mesh.points.push_back(beside(
      { (1.0 - t) * p[0] + t * q[0], (1.0 - t) * p[1] + t * q[1], (1.0 - t) * p[2] + t * q[2] },
      offset, random));
  }
  return points;
}

/// Appends a face that is cut at points on its edges.
void addCut(std::vector<Triangle>& triangles, const Triangle& face, const Splits& splits)
{
  const auto cut = std::find_if(
    splits.begin(), splits.end(), [](const std::vector<Index>& edge) { return !edge.empty(); });
  if (cut == splits.end())
  {
    triangles.push_back(face);
    return;
  }
  const auto k = static_cast<std::size_t>(cut - splits.begin());
  const std::size_t next = (k + 1) % 3;
  const std::size_t previous = (k + 2) % 3;
  const Index point = cut->front();
  addCut(triangles, { face[k], point, face[previous] }, { { {}, {}, splits[previous] } });
  addCut(triangles, { point, face[next], face[previous] },
    { { std::vector<Index>(cut->begin() + 1, cut->end()), splits[next], {} } });
}

/// Cuts off the corners of a polygon in any order.
void addPolygon(std::vector<Triangle>& triangles, std::vector<Index> polygon, Random& random)
{
  while (polygon.size() > 2)
  {
    const std::size_t n = polygon.size();
    const std::size_t i = random.below(n);
    triangles.push_back({ polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n] });
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

std::vector<Index> verticesOf(const Chain& points, bool isReversed)
{
  std::vector<Index> vertices;
  for (const PointOnEdge& p : points)
  {
    vertices.push_back(p.vertex);
  }
  if (isReversed)
  {
    std::reverse(vertices.begin(), vertices.end());
  }
  return vertices;
}

/// Adds loose faces on one line.
void addLooseFaces(std::vector<Triangle>& triangles, const std::vector<Index>& line, Random& random)
{
  for (Index extra = random.between(0, 5); extra > 0 && line.size() > 2; --extra)
  {
    const auto size = static_cast<Index>(line.size());
    const Index i = random.below(size);
    const Index j = (i + random.between(1, size - 1)) % size;
    const Index l = random.below(size);
    if (l != i && l != j)
    {
      triangles.push_back({ line[i], line[j], line[l] });
    }
  }
}

/// Puts new vertices onto edges.
class Capper
{
public:
  Capper(const PlainMesh& mesh, Caps caps, Random& random, double offset)
    : before_(mesh)
    , caps_(caps)
    , random_(random)
    , offset_(offset)
    , own_(mesh.triangles.size())
    , all_(mesh.triangles.size())
    , isDone_(mesh.triangles.size(), false)
  {
    this->result_.mesh.points = mesh.points;
  }

  CappedMesh run(double fraction)
  {
    std::map<std::pair<Index, Index>, std::vector<Side>> sidesAt;
    for (Index f = 0; f < this->before_.triangles.size(); ++f)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Triangle& t = this->before_.triangles[f];
        sidesAt[std::minmax({ t[k], t[(k + 1) % 3] })].push_back({ f, k });
      }
    }
    for (const auto& [edge, sides] : sidesAt)
    {
      if (this->mayHaveCaps(sides) && this->random_.chance(fraction))
      {
        this->addCaps(edge, sides);
      }
    }
    for (Index f = 0; f < this->before_.triangles.size(); ++f)
    {
      addCut(this->result_.mesh.triangles, this->before_.triangles[f], this->own_[f]);
      this->result_.facesBefore.resize(this->result_.mesh.triangles.size(), { f });
      addCut(this->result_.conforming.triangles, this->before_.triangles[f], this->all_[f]);
      this->result_.faceBefore.resize(this->result_.conforming.triangles.size(), f);
    }
    const auto insertAtEnd = [](auto& to, const auto& from)
    { to.insert(to.end(), from.begin(), from.end()); };
    insertAtEnd(this->result_.mesh.triangles, this->flat_);
    insertAtEnd(this->result_.facesBefore, this->facesAtFlat_);
    for (Index i = 0; i < this->result_.mesh.points.size(); ++i)
    {
      this->result_.vertexOf.push_back(i);
    }
    this->result_.conforming.points = this->result_.mesh.points;
    return this->result_;
  }

private:
  bool mayHaveCaps(const std::vector<Side>& sides) const
  {
    return this->caps_ >= Caps::Any ||
      (sides.size() == 2 && !this->isDone_[sides[0].face] && !this->isDone_[sides[1].face]);
  }

  Index numberOfPoints(bool isFirst)
  {
    if (this->caps_ == Caps::One)
    {
      return isFirst ? 1 : 0;
    }
    return isFirst                ? this->random_.between(1, 3)
      : this->random_.chance(0.6) ? 0
                                  : this->random_.between(1, 2);
  }

  void addCaps(const std::pair<Index, Index>& edge, std::vector<Side> sides)
  {
    std::vector<Index> faces;
    for (const Side& side : sides)
    {
      faces.push_back(side.face);
      this->isDone_[side.face] = true;
    }
    sides.resize(sides.size() + (this->caps_ >= Caps::Any ? this->random_.below(3) : 0));
    std::rotate(sides.begin(), sides.begin() + this->random_.below(sides.size()), sides.end());
    std::vector<Chain> chains;
    Chain all;
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      chains.push_back(addPoints(
        this->result_.mesh, edge, this->numberOfPoints(i == 0), this->random_, this->offset_));
      all.insert(all.end(), chains[i].begin(), chains[i].end());
      if (i > 0)
      {
        this->closeGap(edge, chains[this->random_.below(i)], chains[i]);
      }
    }
    std::sort(all.begin(), all.end());
    if (this->caps_ == Caps::AnyAndLoose)
    {
      std::vector<Index> line = verticesOf(all, false);
      line.insert(line.end(), { edge.first, edge.second });
      addLooseFaces(this->flat_, line, this->random_);
    }
    this->facesAtFlat_.resize(this->flat_.size(), faces);
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      if (sides[i].face != Side::NoFace)
      {
        const auto [f, k] = sides[i];
        const bool isReversed = this->before_.triangles[f][k] != edge.first;
        this->own_[f][k] = verticesOf(chains[i], isReversed);
        this->all_[f][k] = verticesOf(all, isReversed);
      }
    }
  }

  void closeGap(const std::pair<Index, Index>& edge, const Chain& left, const Chain& right)
  {
    std::vector<Index> gap = { edge.second };
    const std::vector<Index> back = verticesOf(left, true);
    gap.insert(gap.end(), back.begin(), back.end());
    gap.push_back(edge.first);
    const std::vector<Index> forth = verticesOf(right, false);
    gap.insert(gap.end(), forth.begin(), forth.end());
    addPolygon(this->flat_, gap, this->random_);
  }

  const PlainMesh& before_;
  Caps caps_;
  Random& random_;
  double offset_;
  CappedMesh result_;
  /// Those without area, and the faces at their edges.
  std::vector<Triangle> flat_;
  std::vector<std::vector<Index>> facesAtFlat_;
  /// The vertices of each face's own, and of all at its edges.
  std::vector<Splits> own_;
  std::vector<Splits> all_;
  std::vector<bool> isDone_;
};

} // anonymous namespace

CappedMesh withCaps(
  const PlainMesh& mesh, Caps caps, double fraction, Random& random, double offset)
{
  return Capper(mesh, caps, random, offset).run(fraction);
}

void addNeedles(CappedMesh& both, double fraction, Random& random, double offset)
{
  PlainMesh& mesh = both.mesh;
  std::vector<std::vector<Index>> facesAt(mesh.points.size());
  for (Index f = 0; f < mesh.triangles.size(); ++f)
  {
    for (const Index v : mesh.triangles[f])
    {
      facesAt[v].push_back(f);
    }
  }
  for (Index v = 0; v < facesAt.size(); ++v)
  {
    if (facesAt[v].empty() || !random.chance(fraction))
    {
      continue;
    }
    const auto other = static_cast<Index>(mesh.points.size());
    mesh.points.push_back(beside(mesh.points[v], offset, random));
    both.conforming.points.push_back(mesh.points.back());
    both.vertexOf.push_back(both.vertexOf[v]);
    const Index f = facesAt[v][random.below(facesAt[v].size())];
    Triangle& t = mesh.triangles[f];
    const auto k = static_cast<std::size_t>(std::find(t.begin(), t.end(), v) - t.begin());
    t[k] = other;
    const Triangle before = t;
    mesh.triangles.push_back({ v, before[(k + 1) % 3], other });
    mesh.triangles.push_back({ v, other, before[(k + 2) % 3] });
    const std::vector<Index> faces = both.facesBefore[f];
    both.facesBefore.resize(mesh.triangles.size(), faces);
  }
}

}
