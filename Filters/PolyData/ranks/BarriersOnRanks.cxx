// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/ranks/BarriersOnRanks.h"

#include "mesh/BarrierFaces.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

BarrierTriangles::BarrierTriangles(
  std::vector<Triangle> onVertices, const std::vector<Vec3>& positions, const RankLabels& labels)
  : triangles(std::move(onVertices))
{
  std::vector<Id> numbers(this->triangles.empty() ? 0 : positions.size(), NoId);
  for (Triangle& triangle : this->triangles)
  {
    for (Id& vertex : triangle)
    {
      if (numbers[vertex] == NoId)
      {
        numbers[vertex] = static_cast<Id>(this->points.size());
        this->points.push_back(positions[vertex]);
        this->vertices.push_back(vertex);
        this->keys.push_back(labels.labels[vertex]);
      }
      vertex = numbers[vertex];
    }
  }
}

std::unique_ptr<BarriersOnRanks> BarriersOnRanks::make(BarrierTriangles barriers,
  const std::vector<Id>& vertices, const MeshPartition& open, const RemoteVertices& borrowed)
{
  if (!open.exchange().isTrueAnywhere(!barriers.triangles.empty()))
  {
    return nullptr;
  }
  for (Id& vertex : barriers.vertices)
  {
    vertex = vertices[vertex];
  }
  auto part = std::make_unique<MeshPartition>(
    std::move(barriers.points), std::move(barriers.triangles), barriers.keys, open.exchange());
  return std::unique_ptr<BarriersOnRanks>(
    new BarriersOnRanks(open, std::move(part), std::move(barriers.vertices), borrowed));
}

BarriersOnRanks::BarriersOnRanks(const MeshPartition& open, std::unique_ptr<MeshPartition> part,
  std::vector<Id> vertices, const RemoteVertices& borrowed)
  : open_(open)
  , part_(std::move(part))
  , vertices_(std::move(vertices))
{
  std::vector<std::uint8_t> hasOpenFace(open.mesh().numberOfVertices(), 1);
  borrowed.append(std::uint8_t(0), hasOpenFace, open.exchange());
  for (const Id vertex : this->vertices_)
  {
    this->isInner_.push_back(hasOpenFace[vertex] != 0 ? 0 : 1);
  }
}

Id BarriersOnRanks::triangleOf(Id face) const
{
  Id triangle = 0;
  while (this->part_->faceOfTriangle(triangle) != face)
  {
    ++triangle;
  }
  return triangle;
}

Id BarriersOnRanks::countInnerVertices() const
{
  Id count = 0;
  for (Id vertex = 0; vertex < this->part_->numberOfOwnVertices(); ++vertex)
  {
    count += this->isInner_[vertex] != 0 && this->part_->isCountedHere(vertex) ? 1 : 0;
  }
  return count;
}

std::vector<RankAddress> BarriersOnRanks::barriersAt(const std::vector<Vec3>& points,
  const std::vector<std::vector<LocatorOnRanks::Found>>& closest, double coordinatePrecision)
{
  if (!this->locator_)
  {
    this->locator_.emplace(*this->part_);
  }
  Exchange& exchange = this->open_.exchange();
  std::vector<double> toOpen(points.size(), Infinity);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (const LocatorOnRanks::Found& found : closest[i])
    {
      if (found.face.rank == exchange.rank())
      {
        toOpen[i] = std::min(toOpen[i],
          snapToFace(this->open_.mesh(), found.face.id, points[i], coordinatePrecision).distance);
      }
    }
  }
  exchange.findLeast(toOpen);

  const std::vector<std::vector<LocatorOnRanks::Found>> barriers =
    this->locator_->locate(points, coordinatePrecision);
  // Each rank says of its barriers which of them hold a point; the first one counts.
  std::vector<double> first(points.size(), Infinity);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t k = 0; k < barriers[i].size() && first[i] == Infinity; ++k)
    {
      const RankAddress& face = barriers[i][k].face;
      if (face.rank == exchange.rank() &&
        isInBarrier(
          snapToFace(this->part_->mesh(), face.id, points[i], coordinatePrecision), toOpen[i]))
      {
        first[i] = static_cast<double>(k);
      }
    }
  }
  exchange.findLeast(first);
  std::vector<RankAddress> result(points.size(), RankAddress{ -1, NoId });
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (first[i] < Infinity)
    {
      result[i] = barriers[i][static_cast<std::size_t>(first[i])].face;
    }
  }
  return result;
}

}
