// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/SplitsOfEdges.h"

#include "mesh/MeshPartition.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace geodesic
{

namespace
{

/// A split for another rank. All ranks that own a face at the edge know CutEdge::halfedge by its
/// face and its number there.
struct SentSplit
{
  RankAddress face;
  Id halfedge;
  EdgeSplit split;
};

// The most urgent request for each piece, by edges and pieces. The last pieces of an edge come
// first, as splits change the numbers of those behind them.
void keepMostUrgent(std::vector<EdgeSplit>& requests)
{
  std::sort(requests.begin(), requests.end(),
    [](const EdgeSplit& a, const EdgeSplit& b)
    {
      return std::tuple(a.edge, b.piece, a.reason, b.urgency, a.weight) <
        std::tuple(b.edge, a.piece, b.reason, a.urgency, b.weight);
    });
  const auto isSamePiece = [](const EdgeSplit& a, const EdgeSplit& b)
  { return a.edge == b.edge && a.piece == b.piece; };
  requests.erase(std::unique(requests.begin(), requests.end(), isSamePiece), requests.end());
}

} // anonymous namespace

// Runs item(splitter, i) for i below the count.
template <typename Item>
void SplitsOfEdges::run(std::size_t count, const Item& item)
{
  this->job_.loopByTasks(count,
    [&](std::size_t task, std::size_t i)
    {
      std::unique_ptr<EdgeSplitter>& splitter = this->splitters_[task];
      if (!splitter)
      {
        splitter = std::make_unique<EdgeSplitter>(this->faces_, this->tolerance_);
      }
      item(*splitter, i);
    });
}

std::vector<EdgeSplit> SplitsOfEdges::measureNew()
{
  std::vector<Id> edges;
  for (; this->measured_ < this->edges_.size(); ++this->measured_)
  {
    edges.push_back(this->measured_);
  }
  for (; this->measuredPoints_ < this->edges_.points().size(); ++this->measuredPoints_)
  {
    edges.push_back(this->edges_.points()[this->measuredPoints_].edge);
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<EdgeCuts> cuts(edges.size());
  this->run(edges.size(),
    [&](EdgeSplitter& splitter, std::size_t i)
    {
      CutEdge& edge = this->edges_[edges[i]];
      edge.pieces = splitter.measure(edges[i]);
      if (edge.points.empty())
      {
        cuts[i] = splitter.fewestCuts(edges[i]);
      }
    });
  std::vector<EdgeSplit> requests;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    if (!cuts[i].splits.empty())
    {
      const double deviation = this->edges_[edges[i]].pieces.front().largest();
      requests.push_back({ edges[i], 0, SplitReason::Error, deviation, 0.5 });
      this->fewest_.emplace(edges[i], std::move(cuts[i]));
    }
  }
  return requests;
}

void SplitsOfEdges::split(std::vector<EdgeSplit> requests)
{
  std::vector<Message> messages = this->faces_.field.surface().exchange().noMessages();
  for (const EdgeSplit& request : requests)
  {
    this->tell(this->deciderOf(request.edge), request, messages);
  }
  requests = this->exchange(std::move(messages)); // about which this rank decides
  keepMostUrgent(requests);
  std::vector<std::size_t> first; // of each edge
  for (std::size_t i = 0; i < requests.size(); ++i)
  {
    if (i == 0 || requests[i].edge != requests[i - 1].edge)
    {
      first.push_back(i);
    }
  }
  std::vector<EdgeCuts> cuts(first.size());
  first.push_back(requests.size());
  this->run(cuts.size(),
    [&](EdgeSplitter& splitter, std::size_t i)
    {
      cuts[i] =
        this->decide(splitter, { requests.data() + first[i], requests.data() + first[i + 1] });
    });
  this->fewest_.clear();
  this->cut(cuts);
}

// The rank of the first face there that is refined, from that of CutEdge::halfedge on: it measures
// what one process would. All ranks have these faces in one order.
int SplitsOfEdges::deciderOf(Id edge) const
{
  const MeshPartition& surface = this->faces_.field.surface();
  int rank = -1;
  forEachFace(surface.mesh(), SurfacePoint::onEdge(this->edges_[edge].halfedge, 0.5),
    [&](Id face)
    { rank = rank < 0 && this->faces_.isRefined(face) ? surface.addressOf(face).rank : rank; });
  return rank;
}

void SplitsOfEdges::tell(int rank, const EdgeSplit& split, std::vector<Message>& messages) const
{
  const Id halfedge = this->edges_[split.edge].halfedge;
  put(messages[rankIndex(rank)],
    SentSplit{ this->faces_.field.surface().addressOf(TriangleMesh::faceOf(halfedge)),
      TriangleMesh::indexInFace(halfedge), split });
}

// What all ranks tell this one, with this rank's edges.
std::vector<EdgeSplit> SplitsOfEdges::exchange(std::vector<Message> messages)
{
  const MeshPartition& surface = this->faces_.field.surface();
  std::vector<EdgeSplit> splits;
  readEach(surface.exchange().step(std::move(messages)),
    [&](int, MessageReader& reader)
    {
      const auto sent = reader.get<SentSplit>();
      splits.push_back(sent.split);
      splits.back().edge =
        this->edges_.ensure(TriangleMesh::halfedgeOf(surface.faceAt(sent.face), sent.halfedge));
    });
  return splits;
}

// The cuts of one edge.
EdgeCuts SplitsOfEdges::decide(EdgeSplitter& splitter, ArrayRange<EdgeSplit> requests) const
{
  const EdgeSplit& first = *requests.begin();
  EdgeCuts cuts;
  if (this->edges_[first.edge].points.empty() && first.reason == SplitReason::Error)
  {
    const auto known = this->fewest_.find(first.edge);
    cuts = known == this->fewest_.end() ? splitter.fewestCuts(first.edge) : known->second;
  }
  if (cuts.splits.empty())
  {
    cuts.splits.assign(requests.begin(), requests.end());
    for (EdgeSplit& split : cuts.splits)
    {
      splitter.complete(split);
    }
  }
  return cuts;
}

// Makes this rank's splits, tells the other ranks with faces there, and makes theirs.
void SplitsOfEdges::cut(const std::vector<EdgeCuts>& cuts)
{
  const MeshPartition& surface = this->faces_.field.surface();
  std::vector<Message> messages = surface.exchange().noMessages();
  for (const EdgeCuts& cut : cuts)
  {
    const Id edge = cut.splits.front().edge;
    const std::vector<int> others = surface.otherRanksAt(this->edges_[edge].halfedge);
    for (const EdgeSplit& split : cut.splits)
    {
      this->edges_.split(split);
      for (const int other : others)
      {
        this->tell(other, split, messages);
      }
    }
    if (cut.pieces.size() == this->edges_[edge].numberOfPieces())
    {
      this->edges_[edge].pieces = cut.pieces;
    }
  }
  for (const EdgeSplit& split : this->exchange(std::move(messages)))
  {
    this->edges_.split(split);
  }
}

}
