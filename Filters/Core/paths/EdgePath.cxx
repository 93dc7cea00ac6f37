// SPDX-License-Identifier: BSD-3-Clause
#include "paths/EdgePath.h"

#include <algorithm>
#include <queue>
#include <unordered_map>

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

struct Entry
{
  double estimate;
  double length;
  Id vertex;
  bool operator<(const Entry& other) const { return this->estimate > other.estimate; }
};

} // anonymous namespace

// A*: the remaining distance in space is a lower bound.
double lengthAlongEdges(const TriangleMesh& mesh, const SurfacePoint& first,
  const SurfacePoint& second, const ProgressCallback& progress)
{
  std::unordered_map<Id, double> lengthTo;
  std::priority_queue<Entry> queue;
  const auto reach = [&](Id vertex, double length)
  {
    double& known = lengthTo.try_emplace(vertex, Infinity).first->second;
    if (length < known)
    {
      known = length;
      queue.push({ length + distanceInSpace(mesh, mesh.point(vertex), second), length, vertex });
    }
  };
  for (const Id vertex : verticesAround(mesh, first))
  {
    reach(vertex, distanceInSpace(mesh, mesh.point(vertex), first));
  }
  const std::vector<Id> goals = verticesAround(mesh, second); // the way from there is straight
  double best = Infinity;
  for (std::size_t step = 1; !queue.empty() && queue.top().estimate < best; ++step)
  {
    const Entry top = queue.top();
    queue.pop();
    if (top.length == lengthTo[top.vertex])
    {
      const bool isGoal = std::find(goals.begin(), goals.end(), top.vertex) != goals.end();
      best = isGoal ? top.estimate : best;
      for (const Id corner : mesh.cornersAt(top.vertex))
      {
        const Id previous = TriangleMesh::previousInFace(corner);
        reach(mesh.destination(corner), top.length + mesh.length(corner));
        reach(mesh.origin(previous), top.length + mesh.length(previous));
      }
    }
    constexpr std::size_t stepsPerReport = 4096;
    if (step % stepsPerReport == 0)
    {
      reportProgress(progress, 0.0);
    }
  }
  return best;
}

}
