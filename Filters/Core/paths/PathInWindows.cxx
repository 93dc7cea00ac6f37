// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathInWindows.h"

#include "Tolerance.h"
#include "field/DistanceField.h"
#include "field/Solve.h"
#include "paths/NotePassedFaces.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// The way back from the target: what no path goes through is left out.
struct ReverseSearch
{
  std::vector<double> atVertices;
  NotePassedFaces strip;
};

ReverseSearch findWayBack(const TriangleMesh& mesh, const SurfacePoint& target, double length,
  const KnownDistances& known, FrontOptions options)
{
  const Corridor corridor = corridorTo(length, known);
  options.corridor = &corridor;
  ReverseSearch back;
  back.atVertices = propagate(mesh, { pointCurve(target) }, options, back.strip).vertexDistances;
  return back;
}

/// Lower bounds of the way from vertices of the strip to the target; elsewhere there is none. A
/// path may also run along edges, from vertex to vertex, where no window goes.
std::vector<double> boundsInStrip(const TriangleMesh& mesh, const SurfacePoint& target,
  double length, const KnownDistances& known, const ReverseSearch& back)
{
  std::vector<double> bounds(mesh.numberOfVertices(), Infinity);
  const auto open = [&](Id vertex)
  {
    bounds[vertex] =
      (1.0 - tolerance::BoundMargin) * distanceInSpace(mesh, mesh.point(vertex), target);
  };
  const auto openFace = [&](Id face)
  {
    const Triangle& corners = mesh.triangle(face);
    std::for_each(corners.begin(), corners.end(), open);
  };
  forEachFace(mesh, target, openFace);
  back.strip.forEachFace(openFace);
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    if ((1.0 - tolerance::BoundMargin) * known.atVertices[vertex] + back.atVertices[vertex] <=
      length)
    {
      open(vertex);
    }
  }
  return bounds;
}

} // anonymous namespace

Corridor corridorTo(double length, const KnownDistances& known)
{
  Corridor corridor{ known.atVertices, length };
  for (double& bound : corridor.lowerBounds)
  {
    bound = (1.0 - tolerance::BoundMargin) * std::min(bound, known.reach);
  }
  return corridor;
}

std::vector<SurfacePoint> pathInWindows(const TriangleMesh& mesh,
  const std::vector<SourceCurve>& sources, const SurfacePoint& target, double distance,
  const KnownDistances& known, const ParallelFor& parallelFor, const ProgressCallback& progress)
{
  FrontOptions options;
  options.parallelFor = parallelFor;
  options.progress = progress;
  const double length = (1.0 + tolerance::BoundMargin) * distance;
  const ReverseSearch back = findWayBack(mesh, target, length, known, options);
  const Corridor strip{ boundsInStrip(mesh, target, length, known, back), length };
  options.corridor = &strip;
  return solve(mesh, sources, options, KeepWindows::All).path(target);
}

}
