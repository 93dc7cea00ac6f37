// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/FieldSolver.h"

#include "PolyData/FilterExecution.h"
#include "PolyData/ParallelFor.h"
#include "field/DistanceField.h"
#include "field/NearestSource.h"
#include "refinement/AdaptiveRefinement.h"
#include "refinement/SolveForRefinement.h"
#include "refinement/SourceRegions.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

namespace
{

// Where the stages end, as fractions of the whole execution.
constexpr double BordersFound = 0.3;
constexpr double DoneBeforeRefinement = 0.55;
constexpr double DoneBeforeExactField = 0.6;

/// For RefinementOptions::cornerPoints: the input's points at the corners of each face, NoId for
/// the faces of other ranks. Empty if points and vertices are the same.
std::vector<Triangle> cornerPointsOf(const PolyDataSurface& surface)
{
  std::vector<Triangle> points;
  if (surface.vertexOf.isIdentity())
  {
    return points;
  }
  const MeshPartition& partition = surface.partition;
  points.assign(surface.mesh().numberOfFaces(), { NoId, NoId, NoId });
  for (Id face = partition.firstOwnFace(); face < partition.endOfOwnFaces(); ++face)
  {
    points[face] = surface.triangle(surface.triangleOf(face));
  }
  return points;
}

/// Solves and refines the surface and the sources of an execution.
class FieldSolver
{
public:
  FieldSolver(FilterExecution& execution, const FieldRequest& request, double end)
    : execution_(execution)
    , surface_(execution.surface())
    , request_(request)
    , end_(!request.arrays.isAny()  ? end
          : request.isApproximate() ? DoneBeforeExactField
                                    : FieldDone)
  {
  }

  SolvedSurface solve() const
  {
    this->execution_.enter(Stage::ComputingDistances);
    SolvedSurface solved;
    if (!this->request_.isRefined)
    {
      const FrontOptions options = this->frontOptions(FilterExecution::InputsRead, this->end_);
      solved.field.emplace(geodesic::solve(
        this->surface_.partition, this->execution_.sourceWindows(options.progress), options));
    }
    else
    {
      solved = this->solveAndRefine();
    }
    if (this->request_.isApproximate() && this->request_.arrays.areFeetNeeded() && !solved.exact)
    {
      this->execution_.enter(Stage::ComputingDistances);
      solved.exact.emplace(
        this->solveExactly(solved.field->relativeErrorBound(), this->facesOf(solved.refined)));
    }
    return solved;
  }

private:
  FrontOptions frontOptions(double begin, double end) const
  {
    FrontOptions options;
    options.relativeError = this->request_.relativeError;
    options.maximumDistance = this->request_.maximumDistance;
    options.keepArrivals = this->request_.arrays.isAny() || this->request_.areBordersRefined;
    options.keepAngles = this->request_.arrays.areAnglesNeeded();
    options.parallelFor = smpParallelFor();
    options.progress = this->execution_.progressBetween(begin, end);
    return options;
  }

  /// Repeats the solve if a border passes faces whose windows were dropped. Each repetition keeps
  /// those of more faces.
  SolvedSurface solveAndRefine() const
  {
    const bool areBordersRefined = this->request_.areBordersRefined;
    std::vector<std::uint8_t> pinned;
    if (areBordersRefined)
    {
      pinned = this->findFacesAtBorders();
    }
    SolvedSurface solved;
    bool isRepeated = true;
    while (isRepeated)
    {
      this->execution_.enter(Stage::ComputingDistances);
      solved.field.emplace(this->solveForRefinement(
        areBordersRefined ? BordersFound : FilterExecution::InputsRead, pinned));
      this->execution_.enter(Stage::Refining);
      this->refine(solved);
      const std::vector<Id>& unknown = solved.refined.mesh.unknownAtBorders;
      for (const Id face : unknown)
      {
        pinned[face] = 1;
      }
      isRepeated = areBordersRefined && this->surface_.exchange().isTrueAnywhere(!unknown.empty());
    }
    return solved;
  }

  DistanceField solveForRefinement(double begin, const std::vector<std::uint8_t>& pinned) const
  {
    const FrontOptions options = this->frontOptions(begin, DoneBeforeRefinement);
    return geodesic::solveForRefinement(this->surface_.partition,
      this->execution_.sourceWindows(options.progress), this->request_.tolerance, options, pinned);
  }

  /// With the windows of these faces.
  DistanceField solveExactly(double largestError, std::vector<std::uint8_t> faces) const
  {
    FrontOptions options = this->frontOptions(DoneBeforeExactField, FieldDone);
    options.relativeError = 0.0;
    // A distance within the limit is that much smaller than the exact one at most.
    options.maximumDistance /= 1.0 - std::min(largestError, 0.5);
    KeepFaces retention(this->surface_.mesh(), std::move(faces));
    const MeshPartition& surface = this->surface_.partition;
    FrontResult front =
      propagate(surface, this->execution_.sourceWindows(options.progress), options, retention);
    return { surface, std::move(front), retention.release() };
  }

  /// By an exact solve that keeps no windows.
  std::vector<std::uint8_t> findFacesAtBorders() const
  {
    FrontOptions options = this->frontOptions(FilterExecution::InputsRead, BordersFound);
    options.relativeError = 0.0;
    const DistanceField field = geodesic::solve(
      this->surface_.partition, this->execution_.sourceWindows(options.progress), options);
    const std::vector<SourceCurve>& curves = this->execution_.sources().curves;
    NearestSource nearest(field, this->execution_.patch(), curves, options.progress);
    return SourceRegions(field, nearest, curves, this->request_.arrays.areSidesNeeded())
      .facesAtBorders();
  }

  /// The faces that have points of refinement.
  std::vector<std::uint8_t> facesOf(const RefinedSurface& refined) const
  {
    const TriangleMesh& mesh = this->surface_.mesh();
    std::vector<std::uint8_t> faces(mesh.numberOfFaces(), 0);
    for (std::size_t i = 0; i < refined.numberOfPointsWithPlaces(); ++i)
    {
      forEachFace(mesh, refined.mesh.points[i].place, [&](Id face) { faces[face] = 1; });
    }
    return faces;
  }

  RefinementOptions refinementOptions() const
  {
    RefinementOptions options;
    options.tolerance = this->request_.tolerance;
    if (this->request_.maximumCells > 0)
    {
      const std::uint64_t faces = this->surface_.partition.numberOfGlobalFaces();
      options.maximumFaces =
        this->request_.maximumCells - (this->surface_.countTrianglesOfAllRanks() - faces);
    }
    options.cornerPoints = cornerPointsOf(this->surface_);
    options.numberOfPoints = this->surface_.numberOfPoints;
    options.trianglesBeside = barriersAtEdges(this->surface_);
    options.parallelFor = smpParallelFor();
    options.progress = this->execution_.progressBetween(DoneBeforeRefinement, this->end_);
    return options;
  }

  void refine(SolvedSurface& solved) const
  {
    std::optional<NearestSource> nearest;
    std::optional<SourceRegions> regions;
    if (this->request_.areBordersRefined)
    {
      if (this->request_.isApproximate())
      {
        solved.exact.emplace(this->solveExactly(
          solved.field->relativeErrorBound(), this->surface_.partition.ownFaces()));
      }
      const std::vector<SourceCurve>& curves = this->execution_.sources().curves;
      nearest.emplace(solved.exactField(), this->execution_.patch(), curves);
      regions.emplace(
        solved.exactField(), *nearest, curves, this->request_.arrays.areSidesNeeded());
    }
    RefinementOptions options = this->refinementOptions();
    if (regions)
    {
      options.regionOf = [&regions](const SurfacePoint& point) { return regions->at(point); };
    }
    solved.refined = addUnmeshedTriangles(this->surface_, this->request_.maximumCells,
      options.cornerPoints, geodesic::refine(*solved.field, options));
  }

  FilterExecution& execution_;
  const PolyDataSurface& surface_;
  const FieldRequest& request_;
  /// Where the field and its refinement are done, as a fraction of the whole.
  const double end_;
};

} // anonymous namespace

SolvedSurface solveField(FilterExecution& execution, const FieldRequest& request, double end)
{
  return FieldSolver(execution, request, end).solve();
}

}
