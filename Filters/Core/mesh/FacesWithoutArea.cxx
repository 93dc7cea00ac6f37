// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/FacesWithoutArea.h"

#include "mesh/FaceShape.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>
#include <utility>

namespace geodesic
{

namespace
{

using Key = std::uint64_t;
/// The keys of an edge's ends, the lower one first.
using Edge = std::array<Key, 2>;

Edge edgeBetween(Key a, Key b)
{
  return { std::min(a, b), std::max(a, b) };
}

/// A triangle as one rank tells others.
struct KeyedFace
{
  std::array<Key, 3> keys;
  std::array<Vec3, 3> points;
};

/// Where vertices are, by their keys.
using Places = std::unordered_map<Key, Vec3>;

Places placesOf(const std::vector<KeyedFace>& faces)
{
  Places places;
  for (const KeyedFace& face : faces)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      places.emplace(face.keys[k], face.points[k]); // ranks ascend: the lowest one's
    }
  }
  return places;
}

/// Where edges are cut. Each has one cut, and its halves may be cut again.
struct EdgeCuts
{
  std::map<Edge, Key> middles;
  Places places;

  /// Appends the vertices at which an edge is cut, from a to b.
  void appendBetween(Key a, Key b, std::vector<Key>& keys) const
  {
    std::vector<Key> ends = { b };
    while (!ends.empty())
    {
      const auto middle = this->middles.find(edgeBetween(a, ends.back()));
      if (middle != this->middles.end())
      {
        ends.push_back(middle->second);
        continue;
      }
      a = ends.back();
      ends.pop_back();
      if (!ends.empty())
      {
        keys.push_back(a);
      }
    }
  }

  /// Calls visit(Edge) for the pieces of an edge.
  template <typename Visit>
  void forEachPiece(const Edge& edge, Visit&& visit) const
  {
    std::vector<Key> keys;
    this->appendBetween(edge[0], edge[1], keys);
    keys.push_back(edge[1]);
    Key begin = edge[0];
    for (const Key end : keys)
    {
      visit(edgeBetween(begin, end));
      begin = end;
    }
  }
};

/// Puts the middle corners of caps onto the edges of the other two.
///
/// The longest edge of all caps is cut at the middle corner of one of them, and the others at this
/// edge become two caps each, whose edges are shorter: so the cuts come to an end, and an edge that
/// is cut never comes back.
class CapCuts
{
public:
  explicit CapCuts(const std::vector<KeyedFace>& caps)
  {
    this->cuts_.places = placesOf(caps);
    for (const KeyedFace& cap : caps)
    {
      this->add(cap.keys[0], cap.keys[1], cap.keys[2], LongEdge(Infinity, Edge()));
    }
    while (!this->caps_.empty())
    {
      const auto longest = std::prev(this->caps_.end());
      const auto [edge, corners] = *longest;
      this->caps_.erase(longest);
      this->cut(edge, corners);
    }
  }

  EdgeCuts take() { return std::move(this->cuts_); }

private:
  using LongEdge = std::pair<double, Edge>;

  double length(Key a, Key b) const
  {
    return norm(this->cuts_.places.at(a) - this->cuts_.places.at(b));
  }
  LongEdge longEdge(Key a, Key b) const { return { this->length(a, b), edgeBetween(a, b) }; }

  /// Adds a cap whose longest edge is shorter than another. If rounding makes it as long, two
  /// corners are at one place: a needle, which is for the next round.
  void add(Key a, Key b, Key c, const LongEdge& longer)
  {
    const std::array<std::pair<LongEdge, Key>, 3> edges = { std::pair(this->longEdge(a, b), c),
      std::pair(this->longEdge(b, c), a), std::pair(this->longEdge(c, a), b) };
    const auto& [longest, middle] = *std::max_element(edges.begin(), edges.end());
    if (longest < longer)
    {
      this->caps_[longest].insert(middle);
    }
  }

  void cut(const LongEdge& edge, const std::set<Key>& corners)
  {
    const auto [a, b] = edge.second;
    const auto fromMiddle = [this, a = a, b = b](Key corner)
    { return std::pair(std::abs(this->length(a, corner) - this->length(corner, b)), corner); };
    const Key middle = *std::min_element(corners.begin(), corners.end(),
      [&](Key one, Key other) { return fromMiddle(one) < fromMiddle(other); });
    this->cuts_.middles.emplace(edge.second, middle);
    for (const Key corner : corners)
    {
      if (corner != middle)
      {
        this->add(a, middle, corner, edge);
        this->add(middle, b, corner, edge);
      }
    }
  }

  EdgeCuts cuts_;
  /// The middle corners of the caps over each edge.
  std::map<LongEdge, std::set<Key>> caps_;
};

/// Items that are the same, each known by the least.
template <typename Item>
class SameItems
{
public:
  Item leastOf(Item item) const
  {
    auto found = this->lower_.find(item);
    while (found != this->lower_.end() && found->second != item)
    {
      item = found->second;
      found = this->lower_.find(item);
    }
    return item;
  }
  void join(const Item& a, const Item& b)
  {
    this->lower_.emplace(a, a);
    this->lower_.emplace(b, b);
    const auto [least, other] = std::minmax({ this->leastOf(a), this->leastOf(b) });
    this->lower_[other] = least;
  }
  bool has(const Item& item) const { return this->lower_.count(item) > 0; }

private:
  std::map<Item, Item> lower_;
};

/// The corners of needles that become one vertex.
SameItems<Key> joinsOf(const std::vector<KeyedFace>& needles)
{
  SameItems<Key> same;
  for (const KeyedFace& needle : needles)
  {
    const FaceShape shape = shapeOf(needle.points);
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (shape.length[k] == shape.shortest())
      {
        same.join(needle.keys[k], needle.keys[(k + 1) % 3]);
      }
    }
  }
  return same;
}

/// Cuts edges that would become one, although no face joins them, in their middles.
///
/// \param faces of all ranks at vertices that become one.
EdgeCuts cutsOfSlits(
  const std::vector<KeyedFace>& faces, const SameItems<Key>& same, Key& firstNewKey)
{
  SameItems<Edge> joined;
  std::map<Edge, std::set<Edge>> edges;
  for (const KeyedFace& face : faces)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Key a = face.keys[k];
      const Key b = face.keys[(k + 1) % 3];
      const Key c = face.keys[(k + 2) % 3];
      edges[edgeBetween(same.leastOf(a), same.leastOf(b))].insert(edgeBetween(a, b));
      if (same.leastOf(a) == same.leastOf(b))
      {
        joined.join(edgeBetween(a, c), edgeBetween(b, c));
      }
    }
  }
  EdgeCuts cuts;
  cuts.places = placesOf(faces);
  for (const auto& [ends, originals] : edges)
  {
    std::map<Edge, Key> middles; // of each group of edges that faces join
    for (const Edge& edge : originals)
    {
      const Edge group = joined.leastOf(edge);
      if (ends[0] == ends[1] || group == joined.leastOf(*originals.begin()))
      {
        continue;
      }
      const auto [middle, isNew] = middles.emplace(group, firstNewKey);
      if (isNew)
      {
        cuts.places.emplace(
          firstNewKey++, 0.5 * (cuts.places.at(edge[0]) + cuts.places.at(edge[1])));
      }
      cuts.middles.emplace(edge, middle->second);
    }
  }
  return cuts;
}

/// What a part of a triangle is.
enum class PartKind : std::uint8_t
{
  Face,
  /// A triangle without area that conducts by itself.
  KeptFace,
  /// A triangle without area that is no face any more.
  Segment,
  /// Never was a face.
  NoFace
};

/// The vertices at which the edges of a part are cut.
using Splits = std::array<std::vector<Id>, 3>;

struct Part
{
  Triangle corners;
  Id triangle;
  PartKind kind;
  /// Whether it may be a face without area: it is one when a round begins.
  bool isNew;
};

/// Removes faces without area, round by round: needles that there are, else caps. Cutting a face
/// may make others.
struct Remover
{
  std::vector<Vec3>& points;
  std::vector<Key>& keys;
  Key firstNewKey;
  const std::vector<Triangle>& triangles;
  const std::vector<std::uint8_t>& areFaces;
  Exchange& exchange;
  std::vector<Part> parts{};
  /// For each vertex the one that it has become.
  std::vector<Id> sameVertices{};

  CutTriangles run(const Job& job)
  {
    if (!this->exchange.isTrueAnywhere(this->isAnyFlat(job)))
    {
      return {};
    }
    this->makeParts();
    // Cuts end by themselves; what resists so long for its roundings stays a face.
    constexpr int mostRounds = 100;
    for (int round = 0; round < mostRounds; ++round)
    {
      std::vector<KeyedFace> flat = this->exchanged(this->flatParts());
      if (flat.empty())
      {
        break;
      }
      const auto isNeedleFace = [](const KeyedFace& face)
      { return isNeedle(shapeOf(face.points)); };
      const auto firstCap = std::stable_partition(flat.begin(), flat.end(), isNeedleFace);
      if (firstCap != flat.begin())
      {
        flat.erase(firstCap, flat.end());
        this->joinNeedles(flat);
      }
      else
      {
        this->cutAtCaps(CapCuts(flat).take());
      }
      job.reach(1.0);
    }
    return this->result();
  }

  Key keyOf(Id vertex) const { return this->keys.empty() ? vertex : this->keys[vertex]; }

  std::array<Vec3, 3> places(const Triangle& t) const
  {
    return { this->points[t[0]], this->points[t[1]], this->points[t[2]] };
  }
  KeyedFace keyed(const Triangle& t) const
  {
    return { { this->keyOf(t[0]), this->keyOf(t[1]), this->keyOf(t[2]) }, this->places(t) };
  }
  bool isFlat(const Triangle& t) const
  {
    const std::array<Vec3, 3> corners = this->places(t);
    return hasThreeVertices(t) && isWithoutArea(shapeOf(corners), corners);
  }

  std::vector<KeyedFace> exchanged(const std::vector<KeyedFace>& own) const
  {
    return valuesOfRanks(this->exchange, own);
  }

  bool isFace(std::size_t triangle) const
  {
    return this->areFaces.empty() || this->areFaces[triangle] != 0;
  }

  bool isAnyFlat(const Job& job) const
  {
    const std::vector<int> areFlat = job.resultsOfRanges(this->triangles.size(),
      [&](std::size_t begin, std::size_t end)
      {
        int isAny = 0;
        for (std::size_t i = begin; i < end; ++i)
        {
          isAny = this->isFace(i) && this->isFlat(this->triangles[i]) ? 1 : isAny;
        }
        return isAny;
      });
    return std::find(areFlat.begin(), areFlat.end(), 1) != areFlat.end();
  }

  void makeParts()
  {
    for (std::size_t i = 0; i < this->triangles.size(); ++i)
    {
      const PartKind kind = this->isFace(i) ? PartKind::Face : PartKind::NoFace;
      this->parts.push_back({ this->triangles[i], static_cast<Id>(i), kind, true });
    }
    this->sameVertices.resize(this->points.size());
    std::iota(this->sameVertices.begin(), this->sameVertices.end(), Id(0));
  }

  std::vector<KeyedFace> flatParts()
  {
    std::vector<KeyedFace> flat;
    for (Part& part : this->parts)
    {
      if (part.isNew && part.kind == PartKind::Face && this->isFlat(part.corners))
      {
        flat.push_back(this->keyed(part.corners));
      }
      else
      {
        part.isNew = false;
      }
    }
    return flat;
  }

  /// Makes one vertex of the ends of the needles' short edges.
  void joinNeedles(const std::vector<KeyedFace>& needles)
  {
    const SameItems<Key> same = joinsOf(needles);
    std::vector<KeyedFace> around;
    for (const Part& part : this->parts)
    {
      const KeyedFace face = this->keyed(part.corners);
      const bool isAround =
        std::any_of(face.keys.begin(), face.keys.end(), [&same](Key key) { return same.has(key); });
      if (isAround && (part.kind == PartKind::Face || part.kind == PartKind::KeptFace))
      {
        around.push_back(face);
      }
    }
    around = this->exchanged(around);
    Key newKey = this->firstNewKey;
    const EdgeCuts slits = cutsOfSlits(around, same, this->firstNewKey);
    for (; this->keys.empty() && newKey < this->firstNewKey; ++newKey)
    {
      this->addVertex(newKey, slits.places.at(newKey)); // numbers are keys
    }
    this->cut(slits);
    this->joinVertices(same, placesOf(around));
  }

  void joinVertices(const SameItems<Key>& same, const Places& places)
  {
    // A rank need not have the vertex that stands for the others: its first one does so.
    std::unordered_map<Key, Id> first;
    for (Id vertex = 0; vertex < this->points.size(); ++vertex)
    {
      const Key key = this->keyOf(vertex);
      if (this->sameVertices[vertex] == vertex && same.has(key))
      {
        const auto [found, isNew] = first.emplace(same.leastOf(key), vertex);
        if (!isNew && key == found->first)
        {
          found->second = vertex;
        }
      }
    }
    for (Id& to : this->sameVertices)
    {
      const Key key = this->keyOf(to);
      to = same.has(key) ? first.at(same.leastOf(key)) : to;
    }
    for (const auto& [key, vertex] : first)
    {
      this->points[vertex] = places.at(key);
      if (!this->keys.empty())
      {
        this->keys[vertex] = key;
      }
    }
    for (Part& part : this->parts)
    {
      for (Id& corner : part.corners)
      {
        corner = this->sameVertices[corner];
        part.isNew = part.isNew || same.has(this->keyOf(corner));
      }
      if (part.kind != PartKind::NoFace && !hasThreeVertices(part.corners))
      {
        part.kind = PartKind::Segment;
      }
    }
  }

  /// Cuts the faces beside caps. A cap with a piece of its edge that has no face conducts there.
  void cutAtCaps(const EdgeCuts& cuts)
  {
    std::vector<Edge> own;
    for (const Part& part : this->parts)
    {
      if (part.kind == PartKind::Face && !part.isNew)
      {
        // A piece on two edges has nothing between them.
        std::set<Edge> outline;
        this->forEachEdge(part.corners, cuts,
          [&](std::size_t, const Edge& edge)
          {
            cuts.forEachPiece(edge,
              [&outline](const Edge& piece)
              {
                if (!outline.insert(piece).second)
                {
                  outline.erase(piece);
                }
              });
          });
        own.insert(own.end(), outline.begin(), outline.end());
      }
    }
    const std::vector<Edge> all = valuesOfRanks(this->exchange, own);
    const std::set<Edge> withFace(all.begin(), all.end());
    for (Part& part : this->parts)
    {
      if (part.isNew)
      {
        bool isWhole = true;
        cuts.forEachPiece(this->longEdge(part.corners),
          [&](const Edge& piece) { isWhole = isWhole && withFace.count(piece) > 0; });
        part.kind = isWhole ? PartKind::Segment : PartKind::KeptFace;
      }
    }
    this->cut(cuts);
  }

  Edge edgeOf(const Triangle& t, std::size_t k) const
  {
    return edgeBetween(this->keyOf(t[k]), this->keyOf(t[(k + 1) % 3]));
  }
  Edge longEdge(const Triangle& t) const
  {
    return this->edgeOf(t, shapeOf(this->places(t)).longestEdge());
  }

  /// Calls visit(k, edge) for the edges of a triangle whose ends are vertices of cuts.
  template <typename Visit>
  void forEachEdge(const Triangle& t, const EdgeCuts& cuts, Visit&& visit) const
  {
    std::array<bool, 3> isKnown{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      isKnown[k] = cuts.places.count(this->keyOf(t[k])) > 0;
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (isKnown[k] && isKnown[(k + 1) % 3])
      {
        visit(k, this->edgeOf(t, k));
      }
    }
  }

  /// Cuts all parts at cuts of their edges. Segments stay whole at their long edges, where nothing
  /// is beside them any more.
  void cut(const EdgeCuts& cuts)
  {
    if (cuts.middles.empty())
    {
      return;
    }
    std::unordered_map<Key, Id> vertices;
    for (Id vertex = 0; vertex < this->points.size(); ++vertex)
    {
      if (this->sameVertices[vertex] == vertex && cuts.places.count(this->keyOf(vertex)) > 0)
      {
        vertices.emplace(this->keyOf(vertex), vertex);
      }
    }
    std::vector<Part> cutParts;
    std::vector<Triangle> pieces;
    for (const Part& part : this->parts)
    {
      const Splits splits = this->splitsOf(part, cuts, vertices);
      if (part.kind == PartKind::KeptFace || splits == Splits())
      {
        cutParts.push_back(part);
        continue;
      }
      const PartKind segment = part.kind == PartKind::Face ? PartKind::Segment : part.kind;
      pieces.clear();
      cutAtEdges(
        part.corners, splits, [this](Id vertex) { return this->points[vertex]; }, pieces);
      for (const Triangle& piece : pieces)
      {
        cutParts.push_back(
          { piece, part.triangle, hasThreeVertices(piece) ? part.kind : segment, true });
      }
    }
    this->parts = std::move(cutParts);
  }

  /// The vertices at which a part's edges are cut, which are added if this rank does not have them.
  Splits splitsOf(const Part& part, const EdgeCuts& cuts, std::unordered_map<Key, Id>& vertices)
  {
    Splits splits;
    const bool isSegment = part.kind == PartKind::Segment;
    this->forEachEdge(part.corners, cuts,
      [&](std::size_t k, const Edge& edge)
      {
        if (isSegment && edge == this->longEdge(part.corners))
        {
          return;
        }
        std::vector<Key> middles;
        cuts.appendBetween(
          this->keyOf(part.corners[k]), this->keyOf(part.corners[(k + 1) % 3]), middles);
        for (const Key key : middles)
        {
          const auto [found, isNew] = vertices.emplace(key, static_cast<Id>(this->points.size()));
          if (isNew)
          {
            this->addVertex(key, cuts.places.at(key));
          }
          splits[k].push_back(found->second);
        }
      });
    return splits;
  }

  void addVertex(Key key, const Vec3& place)
  {
    this->sameVertices.push_back(static_cast<Id>(this->points.size()));
    this->points.push_back(place);
    if (!this->keys.empty())
    {
      this->keys.push_back(key);
    }
  }

  CutTriangles result() const
  {
    CutTriangles result;
    for (const Part& part : this->parts)
    {
      result.parts.push_back(part.corners);
      result.triangles.push_back(part.triangle);
      const bool isFace = part.kind == PartKind::Face || part.kind == PartKind::KeptFace;
      result.areFaces.push_back(isFace ? 1 : 0);
    }
    result.same = this->sameVertices;
    return result;
  }
};

} // anonymous namespace

CutTriangles removeFacesWithoutArea(std::vector<Vec3>& points, std::vector<std::uint64_t>& keys,
  std::uint64_t firstNewKey, const std::vector<Triangle>& triangles,
  const std::vector<std::uint8_t>& areFaces, Exchange& exchange, const Job& job)
{
  return Remover{ points, keys, firstNewKey, triangles, areFaces, exchange }.run(job);
}

}
