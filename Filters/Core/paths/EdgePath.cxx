// SPDX-License-Identifier: BSD-3-Clause
#include "paths/EdgePath.h"

#include <algorithm>
#include <queue>

namespace geodesic
{

namespace
{

/// The vertices of the faces around a point, to which the way is straight; of a vertex only itself.
std::vector<Id> verticesAround(const TriangleMesh& mesh, const SurfacePoint& point)
{
  if (point.kind == SurfacePoint::Kind::Vertex)
  {
    return { point.id };
  }
  std::vector<Id> result;
  forEachFace(mesh, point,
    [&](Id face)
    {
      const Triangle& corners = mesh.triangle(face);
      result.insert(result.end(), corners.begin(), corners.end());
    });
  return result;
}

/// Best-first search along mesh edges, from one point to another (A*: the remaining distance in
/// space is a lower bound).
class EdgeSearch
{
public:
  EdgeSearch(const TriangleMesh& mesh, const SurfacePoint& target, std::vector<double>& lengthTo)
    : mesh_(mesh)
    , target_(target)
    , lengthTo_(lengthTo)
  {
    this->lengthTo_.resize(mesh.numberOfVertices(), Infinity);
  }
  ~EdgeSearch()
  {
    for (const Id vertex : this->touched_)
    {
      this->lengthTo_[vertex] = Infinity;
    }
  }
  EdgeSearch(const EdgeSearch&) = delete;
  EdgeSearch& operator=(const EdgeSearch&) = delete;

  void reach(Id vertex, double length)
  {
    if (length < this->lengthTo_[vertex])
    {
      if (this->lengthTo_[vertex] == Infinity)
      {
        this->touched_.push_back(vertex);
      }
      this->lengthTo_[vertex] = length;
      const double left = distanceInSpace(this->mesh_, this->mesh_.point(vertex), this->target_);
      this->queue_.push({ length + left, length, vertex });
    }
  }

  /// Returns the length of the shortest path to the target through one of the goals. From each goal
  /// the way to the target is straight.
  double run(const std::vector<Id>& goals, const ProgressCallback& progress)
  {
    double best = Infinity;
    for (std::size_t step = 1; !this->queue_.empty(); ++step)
    {
      const Entry top = this->queue_.top();
      this->queue_.pop();
      if (top.estimate >= best)
      {
        break;
      }
      if (top.length == this->lengthTo_[top.vertex])
      {
        const bool isGoal = std::find(goals.begin(), goals.end(), top.vertex) != goals.end();
        best = isGoal ? top.estimate : best;
        this->expand(top);
      }
      constexpr std::size_t stepsPerReport = 4096;
      if (step % stepsPerReport == 0)
      {
        reportProgress(progress, 0.0);
      }
    }
    return best;
  }

private:
  struct Entry
  {
    double estimate;
    double length;
    Id vertex;
    bool operator<(const Entry& other) const { return this->estimate > other.estimate; }
  };

  void expand(const Entry& entry)
  {
    for (const Id corner : this->mesh_.cornersAt(entry.vertex))
    {
      const Id previous = TriangleMesh::previousInFace(corner);
      this->reach(this->mesh_.destination(corner), entry.length + this->mesh_.length(corner));
      this->reach(this->mesh_.origin(previous), entry.length + this->mesh_.length(previous));
    }
  }

  const TriangleMesh& mesh_;
  const SurfacePoint target_;
  std::vector<double>& lengthTo_;
  std::vector<Id> touched_;
  std::priority_queue<Entry> queue_;
};

} // anonymous namespace

double lengthAlongEdges(const TriangleMesh& mesh, const SurfacePoint& first,
  const SurfacePoint& second, std::vector<double>& lengthTo, const ProgressCallback& progress)
{
  EdgeSearch search(mesh, second, lengthTo);
  for (const Id vertex : verticesAround(mesh, first))
  {
    search.reach(vertex, distanceInSpace(mesh, mesh.point(vertex), first));
  }
  return search.run(verticesAround(mesh, second), progress);
}

}
