// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RefinementWorkers.h"

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

// In the exact field, one face determines the whole distance along its edge.
Deviation DistancesInFaces::ofEdge(Id id)
{
  const RedGreenMesh::Edge& edge = this->triangles_.edgeData(id);
  Deviation largest;
  bool isKnown = false;
  this->forEachRefinedFace(edge,
    [&](Id around)
    {
      if (!isKnown)
      {
        const FaceDistance& distance = this->face(around);
        largest.widen(this->between(edge.ends[0], edge.ends[1], distance));
        isKnown = distance.isExact();
      }
    });
  return largest;
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

Deviation RefinementWorkers::deviation(Id edge)
{
  if (edge >= this->edges_.size())
  {
    this->edges_.resize(this->triangles_.numberOfEdges());
  }
  if (!this->edges_[edge].isMeasured)
  {
    this->edges_[edge] = { this->first().distances.ofEdge(edge), true };
  }
  return this->edges_[edge].deviation;
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
  this->run(unknown.size(),
    [&](RefinementWorker& worker, std::size_t i)
    { this->edges_[unknown[i]].deviation = worker.distances.ofEdge(unknown[i]); });
}

void RefinementWorkers::forgetNewEdges()
{
  if (this->edges_.size() > this->triangles_.numberOfEdges())
  {
    this->edges_.resize(this->triangles_.numberOfEdges());
  }
}

}
