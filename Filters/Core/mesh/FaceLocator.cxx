// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/FaceLocator.h"

#include "Tolerance.h"
#include "mesh/SurfaceSnap.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace geodesic
{

namespace
{

constexpr Id FacesInLeaf = 8;

/// Each part of a node has at least this fraction of its faces, so that the tree stays shallow.
constexpr std::ptrdiff_t LeastPart = 8;

using Candidate = FaceLocator::Candidate;

/// Whether a face has all vertices of a part of another face.
bool hasPart(const Triangle& corners, const Triangle& part)
{
  return std::all_of(part.begin(), part.end(),
    [&](Id vertex) {
      return vertex == NoId || std::find(corners.begin(), corners.end(), vertex) != corners.end();
    });
}

/// Whether a face is farther than another although rounding may make their distances equal: its
/// closest point is also a point of the other face, which has a closer one.
bool isFartherThan(const Candidate& face, const Candidate& other)
{
  return hasPart(other.corners, face.support) && !hasPart(face.corners, other.support) &&
    norm(other.toClosest - face.toClosest) > face.precision;
}

/// The faces whose distances cannot be distinguished from the least, in their order. Around the
/// centre of a sphere there are many.
std::vector<const Candidate*> closestOf(const std::vector<Candidate>& faces, double least)
{
  std::vector<const Candidate*> closest;
  std::vector<std::pair<Id, const Candidate*>> atVertices;
  for (const Candidate& face : faces)
  {
    if (face.distance <= least + face.measuring)
    {
      closest.push_back(&face);
    }
    for (const Id vertex : face.corners)
    {
      atVertices.emplace_back(vertex, &face);
    }
  }
  std::sort(atVertices.begin(), atVertices.end());
  const auto isFarther = [&](const Candidate* face)
  {
    const Id vertex = *std::min_element(face->support.begin(), face->support.end());
    auto at = std::lower_bound(atVertices.begin(), atVertices.end(), vertex,
      [](const auto& entry, Id wanted) { return entry.first < wanted; });
    while (at != atVertices.end() && at->first == vertex && !isFartherThan(*face, *at->second))
    {
      ++at;
    }
    return at != atVertices.end() && at->first == vertex;
  };
  const auto last = std::remove_if(closest.begin(), closest.end(), isFarther);
  if (last != closest.begin()) // else each loses to another, by rounding
  {
    closest.erase(last, closest.end());
  }
  return closest;
}

}

struct FaceLocator::Search
{
  const Vec3& point;
  const double coordinatePrecision;
  const ProgressCallback& progress;
  double distance;
  std::vector<Candidate> found;
  /// The fraction of the faces that the search has excluded while the tree grows.
  double done;

  double precisionFor(const Box& box) const
  {
    return tolerance::SnapRoundings * this->coordinatePrecision *
      std::max(box.largestCoordinate(), largestCoordinate(this->point));
  }
};

FaceLocator::FaceLocator(const TriangleMesh& mesh)
  : mesh_(mesh)
  , faces_(mesh.numberOfFaces())
{
  std::iota(this->faces_.begin(), this->faces_.end(), Id(0));
  this->nodes_.push_back(this->makeNode(0, mesh.numberOfFaces()));
}

std::vector<FaceLocator::Candidate> FaceLocator::candidates(
  const Vec3& point, double coordinatePrecision, const ProgressCallback& progress)
{
  Search search{ point, coordinatePrecision, progress, Infinity, {}, 0.0 };
  this->search(search, 0);
  std::vector<Candidate>& found = search.found;
  const auto isOver = [&](const Candidate& f) { return !f.isClosest(search.distance); };
  found.erase(std::remove_if(found.begin(), found.end(), isOver), found.end());
  for (Candidate& candidate : found)
  {
    this->complete(candidate, point, coordinatePrecision);
  }
  return std::move(found);
}

std::vector<FaceLocator::Candidate> FaceLocator::chosen(const std::vector<Candidate>& closest)
{
  if (closest.empty())
  {
    return {}; // a surface without faces
  }
  const auto isCloser = [](const Candidate& a, const Candidate& b)
  { return a.distance < b.distance; };
  const double least = std::min_element(closest.begin(), closest.end(), isCloser)->distance;
  const std::vector<const Candidate*> equal = closestOf(closest, least);
  const Candidate& best = **std::min_element(equal.begin(), equal.end(),
    [&](const Candidate* a, const Candidate* b) { return isCloser(*a, *b); });
  std::vector<Candidate> result;
  std::copy_if(closest.begin(), closest.end(), std::back_inserter(result),
    [&](const Candidate& face)
    {
      return norm(face.toPlace - best.toClosest) <= face.precision ||
        std::binary_search(equal.begin(), equal.end(), &face);
    });
  return result;
}

// Three times the centre: only the order of the faces matters.
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
      node.box.add(this->mesh_.point(corner));
    }
  }
  return node;
}

// Divides the faces of a node into two parts: at the middle of its box if that leaves a fair share
// on both sides, else into halves.
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
  if (std::min(cut - first, last - cut) >= (last - first) / LeastPart)
  {
    return static_cast<Id>(cut - this->faces_.begin());
  }
  const auto half = first + (last - first) / 2;
  std::nth_element(
    first, half, last, [&](Id a, Id b) { return this->centre(a, axis) < this->centre(b, axis); });
  return static_cast<Id>(half - this->faces_.begin());
}

void FaceLocator::split(Id node, Search& search)
{
  const Node whole = this->nodes_[node];
  const double size = static_cast<double>(whole.last - whole.first);
  search.done = std::max(search.done, 1.0 - size / static_cast<double>(this->faces_.size()));
  reportProgress(search.progress, search.done);
  const Id middle = this->findMiddle(whole);
  const auto parts = static_cast<Id>(this->nodes_.size());
  this->nodes_.push_back(this->makeNode(whole.first, middle));
  this->nodes_.push_back(this->makeNode(middle, whole.last));
  this->nodes_[node].parts = parts;
}

void FaceLocator::search(Search& search, Id node)
{
  const Box& box = this->nodes_[node].box;
  if (box.distanceTo(search.point) > search.distance + search.precisionFor(box))
  {
    return;
  }
  const Id first = this->nodes_[node].first;
  const Id last = this->nodes_[node].last;
  if (last - first <= FacesInLeaf)
  {
    for (Id i = first; i < last; ++i)
    {
      this->tryFace(search, this->faces_[i]);
    }
    return;
  }
  if (this->nodes_[node].parts == NoId)
  {
    this->split(node, search);
  }
  const Id parts = this->nodes_[node].parts;
  const bool secondFirst = this->nodes_[parts + 1].box.distanceTo(search.point) <
    this->nodes_[parts].box.distanceTo(search.point);
  this->search(search, secondFirst ? parts + 1 : parts);
  this->search(search, secondFirst ? parts : parts + 1);
}

void FaceLocator::tryFace(Search& search, Id face) const
{
  Box box;
  for (const Id corner : this->mesh_.triangle(face))
  {
    box.add(this->mesh_.point(corner));
  }
  const double byCoordinates = search.precisionFor(box);
  if (box.distanceTo(search.point) > search.distance + byCoordinates)
  {
    return; // measuring takes several times as long
  }
  const double distance = norm(snapToFace(this->mesh_, face, search.point, 0.0).offset);
  // Far from the origin roundings may be as large as faces; then the closest face counts.
  const double precision =
    std::min(byCoordinates, tolerance::SnapFraction * this->mesh_.shape(face).longest());
  if (distance <= search.distance + precision)
  {
    const double rounding = byCoordinates / search.coordinatePrecision * tolerance::Rounding;
    search.distance = std::min(search.distance, distance);
    search.found.push_back({ { 0, face }, distance, precision, rounding, 0.0, {}, {}, {}, {} });
  }
}

void FaceLocator::complete(
  Candidate& candidate, const Vec3& point, double coordinatePrecision) const
{
  const SnappedPoint closest = snapToFace(this->mesh_, candidate.face.id, point, 0.0);
  const std::array<double, 3> weights = barycentric(this->mesh_, closest.place, candidate.face.id);
  candidate.measuring = tolerance::SnapRoundings * tolerance::Rounding *
    (candidate.distance + this->mesh_.shape(candidate.face.id).longest());
  candidate.toClosest = closest.offset;
  candidate.toPlace = snapToFace(this->mesh_, candidate.face.id, point, coordinatePrecision).offset;
  candidate.corners = this->mesh_.triangle(candidate.face.id);
  for (std::size_t k = 0; k < 3; ++k)
  {
    candidate.support[k] = weights[k] != 0.0 ? candidate.corners[k] : NoId;
  }
}

}
