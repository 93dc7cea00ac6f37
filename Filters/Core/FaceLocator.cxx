// SPDX-License-Identifier: BSD-3-Clause
#include "FaceLocator.h"

#include "SurfaceSnap.h"

#include <algorithm>
#include <numeric>

namespace geodesic
{

namespace
{

constexpr Id FacesInLeaf = 8;

template <typename Box>
void add(Box& box, const Vec3& p)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    box.low[k] = std::min(box.low[k], p[k]);
    box.high[k] = std::max(box.high[k], p[k]);
  }
}

template <typename Box>
double distanceTo(const Box& box, const Vec3& p)
{
  Vec3 outside;
  for (std::size_t k = 0; k < 3; ++k)
  {
    outside[k] = std::max({ box.low[k] - p[k], p[k] - box.high[k], 0.0 });
  }
  return norm(outside);
}

}

struct FaceLocator::Search
{
  const Vec3& point;
  const ProgressCallback& progress;
  double distance = Infinity;
  Id face = NoId;
  /// The fraction of the faces that have been left aside.
  double done = 0.0;
};

FaceLocator::FaceLocator(const TriangleMesh& mesh)
  : mesh_(mesh)
  , faces_(mesh.numberOfFaces())
{
  std::iota(this->faces_.begin(), this->faces_.end(), Id(0));
  this->nodes_.push_back(this->makeNode(0, mesh.numberOfFaces()));
}

Id FaceLocator::closest(const Vec3& point, const ProgressCallback& progress)
{
  Search search{ point, progress };
  this->search(search, 0);
  return search.face;
}

// Thrice: only the order among the faces counts.
double FaceLocator::centre(Id face, std::size_t axis) const
{
  const Triangle& corners = this->mesh_.triangle(face);
  return this->mesh_.point(corners[0])[axis] + this->mesh_.point(corners[1])[axis] +
    this->mesh_.point(corners[2])[axis];
}

FaceLocator::Node FaceLocator::makeNode(Id first, Id last) const
{
  Node node{ {}, first, last };
  for (Id i = first; i < last; ++i)
  {
    for (const Id corner : this->mesh_.triangle(this->faces_[i]))
    {
      add(node.box, this->mesh_.point(corner));
    }
  }
  return node;
}

// The middle of the box where that cuts off a fair share of the faces, else the middle one, so that
// the tree is never deep.
Id FaceLocator::findMiddle(const Node& node)
{
  const Vec3 size = node.box.high - node.box.low;
  const auto axis =
    static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
  const auto first = this->faces_.begin() + node.first;
  const auto last = this->faces_.begin() + node.last;
  const double middle = 1.5 * (node.box.low[axis] + node.box.high[axis]);
  const auto cut =
    std::partition(first, last, [&](Id face) { return this->centre(face, axis) < middle; });
  const std::ptrdiff_t least = (last - first) / 8;
  if (std::min(cut - first, last - cut) >= least)
  {
    return static_cast<Id>(cut - this->faces_.begin());
  }
  const auto half = first + (last - first) / 2;
  std::nth_element(
    first, half, last, [&](Id a, Id b) { return this->centre(a, axis) < this->centre(b, axis); });
  return static_cast<Id>(half - this->faces_.begin());
}

void FaceLocator::split(Id node)
{
  const Node whole = this->nodes_[node];
  const Id middle = this->findMiddle(whole);
  const auto parts = static_cast<Id>(this->nodes_.size());
  this->nodes_.push_back(this->makeNode(whole.first, middle));
  this->nodes_.push_back(this->makeNode(middle, whole.last));
  this->nodes_[node].parts = parts;
}

void FaceLocator::search(Search& search, Id node)
{
  if (distanceTo(this->nodes_[node].box, search.point) > search.distance)
  {
    return;
  }
  const Id size = this->nodes_[node].last - this->nodes_[node].first;
  if (size <= FacesInLeaf)
  {
    for (Id i = this->nodes_[node].first; i < this->nodes_[node].last; ++i)
    {
      const Id face = this->faces_[i];
      const double distance = snapToFace(this->mesh_, face, search.point, 0.0).distance;
      if (distance < search.distance || (distance == search.distance && face < search.face))
      {
        search.distance = distance;
        search.face = face;
      }
    }
    return;
  }
  if (this->nodes_[node].parts == NoId)
  {
    search.done = std::max(
      search.done, 1.0 - static_cast<double>(size) / static_cast<double>(this->faces_.size()));
    if (search.progress && !search.progress(search.done))
    {
      throw Aborted();
    }
    this->split(node);
  }
  const Id parts = this->nodes_[node].parts;
  const bool secondFirst = distanceTo(this->nodes_[parts + 1].box, search.point) <
    distanceTo(this->nodes_[parts].box, search.point);
  this->search(search, secondFirst ? parts + 1 : parts);
  this->search(search, secondFirst ? parts : parts + 1);
}

}
