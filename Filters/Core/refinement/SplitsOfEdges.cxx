// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/SplitsOfEdges.h"

#include "Exchange.h"
#include "mesh/MeshPartition.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace geodesic
{

namespace
{

/// An edge as all ranks know it that own a face there: the face of CutEdge::halfedge, and the
/// halfedge's number in it.
struct EdgeAddress
{
  RankAddress face;
  Id halfedge;
};

/// What a rank tells another one of an edge.
template <typename Item>
struct AtEdge
{
  EdgeAddress edge;
  Item item;
};

EdgeAddress addressOf(const MeshPartition& surface, Id halfedge)
{
  return { surface.addressOf(TriangleMesh::faceOf(halfedge)), TriangleMesh::indexInFace(halfedge) };
}

Id edgeAt(const MeshPartition& surface, CutEdges& edges, const EdgeAddress& address)
{
  return edges.ensure(TriangleMesh::halfedgeOf(surface.faceAt(address.face), address.halfedge));
}

bool isSamePiece(const SplitRequest& a, const SplitRequest& b)
{
  return a.edge == b.edge && a.piece == b.piece;
}

// The most urgent request for each piece, by edges and pieces. The last pieces of an edge come
// first, as splits change the numbers of those behind them.
void keepMostUrgent(std::vector<SplitRequest>& requests)
{
  std::sort(requests.begin(), requests.end(),
    [](const SplitRequest& a, const SplitRequest& b)
    {
      return std::tuple(a.edge, b.piece, a.reason, b.urgency, a.weight) <
        std::tuple(b.edge, a.piece, b.reason, a.urgency, b.weight);
    });
  requests.erase(std::unique(requests.begin(), requests.end(), isSamePiece), requests.end());
}

// For each face of another rank, not 0 if its owner does not refine it; empty in one process.
std::vector<std::uint8_t> frozenOnOtherRanks(const RefinedFaces& faces)
{
  const MeshPartition& surface = faces.field.surface();
  if (!surface.isDistributed())
  {
    return {};
  }
  // Each rank tells those that have a copy of a frozen face: those that have one of its vertices.
  std::vector<std::uint8_t> isFrozenThere(surface.mesh().numberOfFaces(), 0);
  std::vector<Message> messages = surface.exchange().noMessages();
  for (Id face = surface.firstOwnFace(); face < surface.endOfOwnFaces(); ++face)
  {
    for (const Id vertex : surface.mesh().triangle(face))
    {
      for (const RankAddress& other : surface.othersWith(vertex))
      {
        if (faces.isFrozen(face))
        {
          put(messages[rankIndex(other.rank)], face);
        }
      }
    }
  }
  readEach(surface.exchange().step(std::move(messages)),
    [&](int rank, MessageReader& reader) {
      isFrozenThere[surface.copyOf({ rank, reader.get<Id>() })] = 1;
    });
  return isFrozenThere;
}

} // anonymous namespace

SplitsOfEdges::SplitsOfEdges(RefinedFaces& faces, double tolerance, const Job& job)
  : faces_(faces)
  , edges_(faces.edges)
  , isFrozenThere_(frozenOnOtherRanks(faces))
  , tolerance_(tolerance)
  , job_(job)
{
}

// Runs item(splitter, i) for i below the count.
template <typename Item>
void SplitsOfEdges::run(std::size_t count, const Item& item)
{
  this->job_.loopByTasks(
    count,
    [this](std::size_t tasks)
    {
      while (this->splitters_.size() < tasks)
      {
        this->splitters_.push_back(std::make_unique<EdgeSplitter>(this->faces_, this->tolerance_));
      }
    },
    [&](std::size_t task, std::size_t i) { item(*this->splitters_[task], i); });
}

std::vector<SplitRequest> SplitsOfEdges::measureNew()
{
  std::vector<Id> unknown;
  for (Id edge = this->measured_; edge < this->edges_.size(); ++edge)
  {
    if (!this->edges_[edge].pieces.front().isKnown())
    {
      unknown.push_back(edge);
    }
  }
  this->measured_ = this->edges_.size();
  std::vector<EdgeCuts> cuts(unknown.size());
  this->run(unknown.size(),
    [&](EdgeSplitter& splitter, std::size_t i)
    {
      this->edges_[unknown[i]].pieces = splitter.measure(unknown[i]);
      cuts[i] = splitter.fewestCuts(unknown[i]);
    });
  std::vector<SplitRequest> requests;
  for (std::size_t i = 0; i < unknown.size(); ++i)
  {
    if (!cuts[i].splits.empty())
    {
      const double deviation = this->edges_[unknown[i]].pieces.front().largest();
      requests.push_back({ unknown[i], 0, SplitReason::Error, deviation, 0.5 });
      this->fewest_.emplace(unknown[i], std::move(cuts[i]));
    }
  }
  return requests;
}

std::vector<Id> SplitsOfEdges::split(std::vector<SplitRequest> requests)
{
  requests = this->gather(std::move(requests));
  std::vector<Id> edges;
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < requests.size(); ++i)
  {
    if (edges.empty() || edges.back() != requests[i].edge)
    {
      edges.push_back(requests[i].edge);
      first.push_back(i);
    }
  }
  first.push_back(requests.size());
  std::vector<EdgeCuts> cuts(edges.size());
  this->run(edges.size(),
    [&](EdgeSplitter& splitter, std::size_t i) {
      cuts[i] = this->decide(splitter, requests.data() + first[i], requests.data() + first[i + 1]);
    });
  const std::vector<Id> changed = this->share(edges, cuts);
  this->fewest_.clear();
  this->measure(changed);
  return changed;
}

// The rank of the first face there that is refined, from that of CutEdge::halfedge on: it measures
// what one process would. All ranks have these faces in one order. This rank refines one of its
// own: it has asked for the split.
int SplitsOfEdges::deciderOf(Id edge) const
{
  const MeshPartition& surface = this->faces_.field.surface();
  int rank = surface.exchange().rank();
  bool isFound = !surface.isDistributed();
  if (!isFound)
  {
    forEachFace(surface.mesh(), SurfacePoint::onEdge(this->edges_[edge].halfedge, 0.5),
      [&](Id face)
      {
        if (!isFound && this->isFrozenThere_[face] == 0)
        {
          rank = surface.addressOf(face).rank;
          isFound = true;
        }
      });
  }
  return rank;
}

// The requests about which this rank decides.
std::vector<SplitRequest> SplitsOfEdges::gather(std::vector<SplitRequest> requests)
{
  const MeshPartition& surface = this->faces_.field.surface();
  keepMostUrgent(requests);
  if (!surface.isDistributed())
  {
    return requests;
  }
  std::vector<Message> messages = surface.exchange().noMessages();
  std::vector<SplitRequest> own;
  for (const SplitRequest& request : requests)
  {
    const int decider = this->deciderOf(request.edge);
    if (decider == surface.exchange().rank())
    {
      own.push_back(request);
    }
    else
    {
      put(messages[rankIndex(decider)],
        AtEdge<SplitRequest>{ addressOf(surface, this->edges_[request.edge].halfedge), request });
    }
  }
  readEach(surface.exchange().step(std::move(messages)),
    [&](int, MessageReader& reader)
    {
      const auto message = reader.get<AtEdge<SplitRequest>>();
      own.push_back(message.item);
      own.back().edge = edgeAt(surface, this->edges_, message.edge);
    });
  keepMostUrgent(own);
  return own;
}

EdgeCuts SplitsOfEdges::decide(
  EdgeSplitter& splitter, const SplitRequest* first, const SplitRequest* last)
{
  const Id edge = first->edge;
  EdgeCuts cuts;
  if (this->edges_[edge].points.empty() && first->reason == SplitReason::Error)
  {
    const auto known = this->fewest_.find(edge);
    cuts = known == this->fewest_.end() ? splitter.fewestCuts(edge) : known->second;
  }
  const bool isCut = !cuts.splits.empty();
  for (; !isCut && first != last; ++first)
  {
    cuts.splits.push_back(
      splitter.split(edge, first->piece, first->weight, first->reason == SplitReason::Shape));
  }
  return cuts;
}

// Makes this rank's splits, tells the other ranks with faces there, and makes theirs.
std::vector<Id> SplitsOfEdges::share(
  const std::vector<Id>& edges, const std::vector<EdgeCuts>& cuts)
{
  const MeshPartition& surface = this->faces_.field.surface();
  std::vector<Message> messages = surface.exchange().noMessages();
  std::vector<Id> changed = edges;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const Id halfedge = this->edges_[edges[i]].halfedge;
    const std::vector<int> others =
      surface.isDistributed() ? surface.otherRanksAt(halfedge) : std::vector<int>();
    for (const EdgeSplit& split : cuts[i].splits)
    {
      this->edges_.split(edges[i], split);
      for (const int other : others)
      {
        put(messages[rankIndex(other)], AtEdge<EdgeSplit>{ addressOf(surface, halfedge), split });
      }
    }
    if (cuts[i].pieces.size() == this->edges_[edges[i]].numberOfPieces())
    {
      this->edges_[edges[i]].pieces = cuts[i].pieces;
    }
  }
  if (surface.isDistributed())
  {
    readEach(surface.exchange().step(std::move(messages)),
      [&](int, MessageReader& reader)
      {
        const auto message = reader.get<AtEdge<EdgeSplit>>();
        changed.push_back(edgeAt(surface, this->edges_, message.edge));
        this->edges_.split(changed.back(), message.item);
      });
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  }
  return changed;
}

void SplitsOfEdges::measure(const std::vector<Id>& edges)
{
  this->run(edges.size(),
    [&](EdgeSplitter& splitter, std::size_t i)
    { this->edges_[edges[i]].pieces = splitter.measure(edges[i]); });
}

}
