// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RefinementWorkers.h"

#include <algorithm>
#include <iterator>

namespace geodesic
{

const FaceDistance& DistancesInFaces::face(Id face)
{
  if (!this->last_)
  {
    this->last_.emplace(this->field_, face);
  }
  else if (this->last_->face() != face)
  {
    this->last_.emplace(this->field_, face, this->last_->releaseMemory());
  }
  return *this->last_;
}

double DistancesInFaces::atPoint(Id point) const
{
  const Id inputPoints = this->triangles_.numberOfInputPoints();
  return point < inputPoints ? this->field_.vertexDistances()[point]
                             : this->triangles_.points()[point - inputPoints].distance;
}

double DistancesInFaces::atPoint(Id point, const FaceDistance& face, Vec2 place) const
{
  return face.isExact() ? this->atPoint(point) : face.distance(place);
}

std::shared_ptr<const DistanceAlongEdge> DistancesInFaces::along(Id id)
{
  const RedGreenMesh::Edge& edge = this->triangles_.edgeData(id);
  const auto distance = std::make_shared<DistanceAlongEdge>();
  bool isKnown = false;
  this->forEachRefinedFace(edge,
    [&](Id around)
    {
      if (!isKnown)
      {
        const FaceDistance& inFace = this->face(around);
        const Vec2 begin = this->triangles_.inPlane(edge.ends[0], around);
        const Vec2 end = this->triangles_.inPlane(edge.ends[1], around);
        distance->add(this->envelope_.along(inFace, begin, end), inFace.distance(begin));
        isKnown = inFace.isExact();
      }
    });
  return distance;
}

Deviation DistancesInFaces::between(Id a, Id b, const FaceDistance& face)
{
  const Vec2 p = this->triangles_.inPlane(a, face.face());
  const Vec2 q = this->triangles_.inPlane(b, face.face());
  return largestDeviation(this->envelope_.along(face, p, q), norm(q - p), this->atPoint(a, face, p),
    this->atPoint(b, face, q));
}

double DistancesInFaces::onEdge(Id id, double weight)
{
  const RedGreenMesh::Edge& edge = this->triangles_.edgeData(id);
  double least = Infinity;
  this->forEachRefinedFace(edge,
    [&](Id around)
    {
      const Vec2 p = this->triangles_.inPlane(edge.ends[0], around);
      const Vec2 q = this->triangles_.inPlane(edge.ends[1], around);
      least = std::min(least, this->face(around).distance(p + weight * (q - p)));
    });
  return least;
}

void RefinementWorkers::resize(std::size_t count)
{
  while (this->workers_.size() < count)
  {
    this->workers_.push_back(std::make_unique<RefinementWorker>(this->field_, this->triangles_));
  }
}

// A part of an edge whose distance is known shares it.
std::unique_ptr<RefinementWorkers::PartOfEdge> RefinementWorkers::partOf(
  Id id, RefinementWorker& worker) const
{
  auto part = std::make_unique<PartOfEdge>();
  const RedGreenMesh::Edge& data = this->triangles_.edgeData(id);
  const PartOfEdge* whole = data.parent == NoId ? nullptr : this->edges_[data.parent].part.get();
  if (whole == nullptr)
  {
    part->distance = worker.distances.along(id);
    part->end = this->triangles_.lengthOf(id);
    return part;
  }
  const double middle =
    whole->begin + this->triangles_.placementOf(data.parent).weight * (whole->end - whole->begin);
  const bool isFirst = this->triangles_.edgeData(data.parent).halves == id;
  part->distance = whole->distance;
  part->begin = isFirst ? whole->begin : middle;
  part->end = isFirst ? middle : whole->end;
  std::copy_if(whole->cuts.begin(), whole->cuts.end(), std::back_inserter(part->cuts),
    [&part](double cut) { return cut > part->begin && cut < part->end; });
  return part;
}

// Most edges are within the tolerance, and few of these are split: their distances are not kept.
void RefinementWorkers::measure(Id id, RefinementWorker& worker)
{
  const RedGreenMesh::Edge& data = this->triangles_.edgeData(id);
  std::unique_ptr<PartOfEdge> part = this->partOf(id, worker);
  const std::array<double, 2> ends = { worker.distances.atPoint(data.ends[0]),
    worker.distances.atPoint(data.ends[1]) };
  Edge& edge = this->edges_[id];
  edge.deviation =
    part->distance->deviation(part->begin, part->end, this->isExact_ ? &ends : nullptr);
  if (edge.deviation.largest() > this->tolerance_)
  {
    edge.part = std::move(part);
  }
}

RefinementWorkers::Edge& RefinementWorkers::measured(Id edge)
{
  if (edge >= this->edges_.size())
  {
    this->edges_.resize(this->triangles_.numberOfEdges());
  }
  if (!this->edges_[edge].isMeasured)
  {
    this->measure(edge, this->first());
    this->edges_[edge].isMeasured = true;
    this->releaseWholeOf(edge);
  }
  return this->edges_[edge];
}

// Both halves of an edge have what they need of it.
void RefinementWorkers::releaseWholeOf(Id part)
{
  const Id whole = this->triangles_.edgeData(part).parent;
  if (whole == NoId)
  {
    return;
  }
  const Id halves = this->triangles_.edgeData(whole).halves;
  if (halves + 1 < this->edges_.size() && this->edges_[halves].isMeasured &&
    this->edges_[halves + 1].isMeasured)
  {
    this->edges_[whole].part.reset();
  }
}

double RefinementWorkers::bestSplit(Id id, const StripCorners& corners)
{
  Edge& edge = this->measured(id);
  if (!edge.part)
  {
    edge.part = this->partOf(id, this->first());
  }
  PartOfEdge& part = *edge.part;
  if (part.cuts.empty())
  {
    part.cuts = part.distance->cuts(part.begin, part.end, this->tolerance_, corners);
  }
  double best = part.cuts.empty() ? 0.5 : Infinity;
  for (const double cut : part.cuts)
  {
    const double weight = (cut - part.begin) / (part.end - part.begin);
    best = std::abs(weight - 0.5) < std::abs(best - 0.5) ? weight : best;
  }
  return best;
}

void RefinementWorkers::measure(const std::vector<Id>& edges)
{
  this->edges_.resize(this->triangles_.numberOfEdges());
  std::vector<Id> unknown;
  for (const Id edge : edges)
  {
    if (!this->edges_[edge].isMeasured)
    {
      this->edges_[edge].isMeasured = true; // set early: an edge may occur twice
      unknown.push_back(edge);
    }
  }
  std::sort(unknown.begin(), unknown.end());
  // an edge that another rank has split is measured with its parts, which wait for it
  const auto waits = [&](Id edge)
  {
    return std::binary_search(
      unknown.begin(), unknown.end(), this->triangles_.edgeData(edge).parent);
  };
  this->run(unknown.size(),
    [&](RefinementWorker& worker, std::size_t i)
    {
      if (!waits(unknown[i]))
      {
        this->measure(unknown[i], worker);
      }
    });
  for (const Id edge : unknown)
  {
    if (waits(edge))
    {
      this->measure(edge, this->first());
    }
  }
  std::for_each(unknown.begin(), unknown.end(), [this](Id edge) { this->releaseWholeOf(edge); });
}

void RefinementWorkers::forgetNewEdges()
{
  if (this->edges_.size() > this->triangles_.numberOfEdges())
  {
    this->edges_.resize(this->triangles_.numberOfEdges());
  }
}

}
