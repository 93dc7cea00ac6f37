// SPDX-License-Identifier: BSD-3-Clause
#include "paths/JoinPoints.h"

#include "Errors.h"
#include "Tolerance.h"
#include "field/DistanceField.h"
#include "field/RetentionAround.h"
#include "paths/CleanPath.h"
#include "paths/PathInWindows.h"
#include "paths/PathTracer.h"
#include "paths/SubMesh.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// The fraction of the progress at which the search ends.
constexpr double ShareOfSearch = 0.7;

/// Relative error of the search. The strip is as wide as the root of the error: with a smaller
/// error the search takes longer, with a larger one the exact front does.
constexpr double SearchError = 1e-3;

std::vector<double> distancesInSpace(const TriangleMesh& mesh, const SurfacePoint& point)
{
  std::vector<double> distances;
  distances.reserve(mesh.numberOfVertices());
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    distances.push_back(distanceInSpace(mesh, mesh.point(vertex), point));
  }
  return distances;
}

/// Keeps what tracing from the second point needs. The distance of a vertex and its way to the
/// second point add up to a path: the corridor need be no longer.
class StripRetention : public RetentionAround
{
public:
  /// \param least a length below which roundings decide.
  StripRetention(const TriangleMesh& mesh, const SurfacePoint& second,
    const std::vector<double>& toSecond, double least)
    : RetentionAround(mesh, { second })
    , toSecond_(toSecond)
    , least_(least)
  {
    this->keepAroundIrregularEdges();
  }

  double longestPath() const override { return this->longestPath_; }

  void advance(const FrontState& front) override
  {
    RetentionAround::advance(front);
    for (const Id vertex : front.settled)
    {
      const double length = front.distances(vertex) + (1.0 + SearchError) * this->toSecond_[vertex];
      this->longestPath_ = std::min(
        this->longestPath_, std::max(this->least_, (1.0 + tolerance::BoundMargin) * length));
    }
  }

private:
  const std::vector<double>& toSecond_;
  double least_;
  double longestPath_ = Infinity;
};

/// Lower bounds of the distance to the second point. The distances that the search from there has
/// found are lower bounds, except where it left out what no path within the length passes: there
/// the distance exceeds what the way from the first point leaves of the length. Beyond the reach of
/// the search, the reach is a lower bound.
///
/// \param searched the corridor of the search.
std::vector<double> lowerBounds(const TriangleMesh& mesh, const SurfacePoint& second,
  const std::vector<double>& toSecond, double reach, const Corridor& searched)
{
  std::vector<double> bounds = distancesInSpace(mesh, second);
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    const double found =
      std::min({ toSecond[vertex], reach, searched.length - searched.lowerBounds[vertex] });
    bounds[vertex] = std::max(bounds[vertex], (1.0 - tolerance::BoundMargin) * found);
  }
  return bounds;
}

/// Finds a shortest path between two points of a surface.
///
/// An approximate front from the second point, which costs a fraction of an exact one, gives lower
/// bounds of the distance to that point. An exact front from the first point then goes only where a
/// path can still be as short as the best known one: through a strip of few faces. Hardly any
/// windows are kept, as PathTracer follows the path by the directions in which it came to vertices.
///
/// \param length an upper bound of the path's length. The mesh must contain all faces that a path
///        of that length can touch.
/// \returns the path from the first point to the second, see PathTracer; empty if there is none.
std::vector<SurfacePoint> shortestPath(const TriangleMesh& mesh, const SurfacePoint& first,
  const SurfacePoint& second, double length, const ParallelFor& parallelFor,
  const ProgressCallback& progress)
{
  Corridor corridor{ distancesInSpace(mesh, first), length };
  FrontOptions options;
  options.corridor = &corridor;
  options.parallelFor = parallelFor;
  options.progress = progressBetween(progress, 0.0, ShareOfSearch);
  options.relativeError = SearchError;
  RetentionAround search(mesh, { first });
  const std::vector<double> toSecond =
    propagate(mesh, { pointCurve(second) }, options, search).vertexDistances;

  corridor.lowerBounds = lowerBounds(mesh, second, toSecond, search.reach(), corridor);
  // The two points may be at one place, behind faces without area: there a path is as long as
  // roundings.
  const double least = tolerance::BoundMargin * length;
  corridor.length = std::min(length, std::max(least, (1.0 + SearchError) * search.reach()));
  options.relativeError = 0.0;
  options.keepArrivals = true;
  options.progress = progressBetween(progress, ShareOfSearch, 1.0);
  StripRetention strip(mesh, second, toSecond, least);
  FrontResult front = propagate(mesh, { pointCurve(first) }, options, strip);
  const DistanceField field(MeshPartition(mesh), std::move(front), strip.release());
  std::vector<SurfacePoint> path;
  try
  {
    path = PathTracer(field).trace(second);
  }
  catch (const PathLost&)
  {
    // Seldom: by windows that are all kept, in the corridor alone.
    corridor.length = std::min(corridor.length, strip.longestPath());
    options.keepArrivals = false;
    options.progress = progressBetween(progress, 1.0, 1.0);
    path = pathInWindows(solve(mesh, { pointCurve(first) }, options, KeepWindows::All), second);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

/// Whether consecutive points have a common face. If the path broke off or is empty, its ends have
/// none.
bool isWhole(const TriangleMesh& mesh, const std::vector<SurfacePoint>& path)
{
  const auto areApart = [&](const SurfacePoint& a, const SurfacePoint& b)
  { return commonFace(mesh, a, b) == NoId; };
  return std::adjacent_find(path.begin(), path.end(), areApart) == path.end();
}

/// Gives a path on the surface the two points that it was looked for between as its ends: on the
/// sub-mesh they were rounded.
void setEnds(const TriangleMesh& mesh, const SurfacePoint& first, const SurfacePoint& second,
  std::vector<SurfacePoint>& path)
{
  // A path may begin at a vertex at the place of the first point, behind faces without area.
  const bool isBehind = path.size() > 1 && commonFace(mesh, first, path[1]) == NoId &&
    commonFace(mesh, first, path[0]) != NoId;
  if (path.empty() || isBehind)
  {
    path.insert(path.begin(), first);
  }
  path.resize(std::max<std::size_t>(path.size(), 2));
  path.front() = first;
  path.back() = second;
}

/// If an end lies beside a vertex or an edge by a rounding, the path goes over the vertex or edge:
/// there the sub-mesh has the end, so that the path may leave through another face.
void linkEnds(const TriangleMesh& mesh, std::vector<SurfacePoint>& path)
{
  if (commonFace(mesh, path[0], path[1]) == NoId)
  {
    path.insert(path.begin() + 1, normalized(mesh, path.front()));
  }
  if (commonFace(mesh, path[path.size() - 2], path.back()) == NoId)
  {
    path.insert(path.end() - 1, normalized(mesh, path.back()));
  }
}

std::vector<SurfacePoint> pathBetween(const TriangleMesh& mesh, const SurfacePoint& first,
  const SurfacePoint& second, const ParallelFor& parallelFor, const ProgressCallback& progress)
{
  if (commonFace(mesh, first, second) != NoId)
  {
    return { first, second };
  }
  const SubMesh patch(mesh, first, second, progress);
  if (patch.bound() == Infinity)
  {
    return {};
  }
  const auto find = [&](const SurfacePoint& from, const SurfacePoint& to)
  {
    std::vector<SurfacePoint> path = shortestPath(
      patch.mesh(), patch.onPatch(from), patch.onPatch(to), patch.bound(), parallelFor, progress);
    std::transform(path.begin(), path.end(), path.begin(),
      [&patch](const SurfacePoint& point) { return patch.onSurface(point); });
    setEnds(mesh, from, to, path);
    path = cleanedPath(mesh, path, patch.bound());
    linkEnds(mesh, path);
    return path;
  };
  std::vector<SurfacePoint> path = find(first, second);
  if (!isWhole(mesh, path))
  {
    // The path may begin at a vertex at the place of the first point, behind several faces without
    // area.
    path = find(second, first);
    std::reverse(path.begin(), path.end());
  }
  if (!isWhole(mesh, path))
  {
    throw Error("The shortest path between two points of the source could not be traced.");
  }
  return path;
}

} // anonymous namespace

JoinPoints joinByShortestPaths(const TriangleMesh& mesh, const ParallelFor& parallelFor)
{
  return [&mesh, parallelFor](
           const SurfacePoint& first, const SurfacePoint& second, const ProgressCallback& progress)
  { return pathBetween(mesh, first, second, parallelFor, progress); };
}

JoinPoints JoinedPaths::reusedBy(JoinPoints join)
{
  const auto place = [](const SurfacePoint& p) { return Place(p.kind, p.id, p.u, p.v); };
  return [this, place, join = std::move(join)](
           const SurfacePoint& first, const SurfacePoint& second, const ProgressCallback& progress)
  {
    const auto [used, isNew] = this->used_.try_emplace(Ends(place(first), place(second)));
    if (isNew)
    {
      const auto kept = this->kept_.find(used->first);
      used->second = kept != this->kept_.end() ? kept->second : join(first, second, progress);
    }
    return used->second;
  };
}

}
