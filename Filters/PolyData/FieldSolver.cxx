// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/FieldSolver.h"

#include "PolyData/FilterExecution.h"
#include "PolyData/Inputs.h"
#include "PolyData/writing/UnmeshedTriangles.h"
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

/// For RefinementOptions::cornerPoints: the input's points at the corners of each face, NoId for
/// the faces of other ranks. Empty if points and vertices are the same.
std::vector<Triangle> cornerPointsOf(const PolyDataSurface& surface)
{
  if (surface.vertexOf.isIdentity())
  {
    return {};
  }
  const MeshPartition& partition = surface.partition;
  std::vector<Triangle> points(surface.mesh().numberOfFaces(), { NoId, NoId, NoId });
  for (Id face = partition.firstOwnFace(); face < partition.endOfOwnFaces(); ++face)
  {
    points[face] = surface.cornersOf(surface.partOf(face));
  }
  return points;
}

/// The parts of solveField(), for what an execution has read.
struct FieldSolver
{
  const Inputs& inputs;
  const FieldRequest& request;
  FilterExecution& execution;
  const PolyDataSurface& surface = *inputs.surface;

  SolvedSurface solve() const
  {
    SolvedSurface solved;
    const FrontOptions options = this->frontOptions(Stage::Solve);
    solved.field.emplace(
      geodesic::solve(this->surface.partition, this->inputs.sourceWindows(options.job), options));
    return solved;
  }

  FrontOptions frontOptions(Stage stage) const
  {
    FrontOptions options;
    options.relativeError = this->request.relativeError;
    options.maximumDistance = this->request.maximumDistance;
    options.keepArrivals = this->request.arrays.isAny() || this->request.areBordersRefined;
    options.keepAngles = this->request.arrays.areAnglesNeeded();
    options.job = this->execution.begin(stage);
    return options;
  }

  /// The solve keeps the windows where the distance is not linear. If refinement finds that a
  /// border also passes elsewhere, solves again and keeps the windows there, too.
  SolvedSurface solveAndRefine() const
  {
    // An approximate solve keeps all windows.
    PinnedFaces pinned = this->request.areBordersRefined && !this->request.isApproximate()
      ? this->findFacesAtBorders()
      : PinnedFaces(this->surface.mesh().numberOfFaces(), 0);
    SolvedSurface solved;
    do
    {
      solved = SolvedSurface(); // to have memory for the next
      const FrontOptions options = this->frontOptions(Stage::Solve);
      solved.field.emplace(solveForRefinement(this->surface.partition,
        this->inputs.sourceWindows(options.job), this->request.tolerance, options, pinned));
      this->refine(solved);
    } while (pinMissing(this->surface.partition, solved.refined.unknownAtBorders, pinned));
    return solved;
  }

  /// With the windows of these faces.
  DistanceField solveExactly(double largestError, std::vector<std::uint8_t> faces) const
  {
    FrontOptions options = this->frontOptions(Stage::SolveExactly);
    options.relativeError = 0.0;
    // A distance within the limit is that much smaller than the exact one at most.
    options.maximumDistance /= 1.0 - std::min(largestError, 0.5);
    return solveKeeping(
      this->surface.partition, this->inputs.sourceWindows(options.job), options, std::move(faces));
  }

  /// By a solve that keeps no windows.
  PinnedFaces findFacesAtBorders() const
  {
    const FrontOptions options = this->frontOptions(Stage::FindBorders);
    const DistanceField field =
      geodesic::solve(this->surface.partition, this->inputs.sourceWindows(options.job), options);
    const std::vector<SourceCurve>& curves = this->inputs.sources.curves;
    NearestSource nearest(field, *this->inputs.patch, curves, options.job.part(1.0, 1.0));
    return SourceRegions(field, nearest, curves, this->request.arrays.areSidesNeeded())
      .facesAtBorders();
  }

  /// The faces that have points of refinement.
  std::vector<std::uint8_t> facesOf(const RefinedMesh& refined) const
  {
    const TriangleMesh& mesh = this->surface.mesh();
    std::vector<std::uint8_t> faces(mesh.numberOfFaces(), 0);
    for (std::size_t i = 0; i < refined.numberOfPointsWithPlaces(); ++i)
    {
      if (refined.points[i].hasPlace())
      {
        forEachFace(mesh, refined.points[i].place, [&](Id face) { faces[face] = 1; });
      }
    }
    return faces;
  }

  RefinementOptions refinementOptions(const UnmeshedTriangles& unmeshed) const
  {
    RefinementOptions options;
    options.tolerance = this->request.tolerance;
    if (this->request.maximumCells > 0)
    {
      const std::uint64_t faces = this->surface.partition.numberOfGlobalFaces();
      options.maximumFaces =
        this->request.maximumCells - (this->surface.countPartsOfAllRanks() - faces);
    }
    options.cornerPoints = cornerPointsOf(this->surface);
    options.numberOfPoints =
      this->surface.numberOfPoints + static_cast<Id>(this->surface.cutPoints.size());
    options.trianglesBeside = unmeshed.countAtEdges();
    options.job = this->execution.begin(Stage::Refine);
    return options;
  }

  void refine(SolvedSurface& solved) const
  {
    std::optional<NearestSource> nearest;
    std::optional<SourceRegions> regions;
    if (this->request.areBordersRefined)
    {
      if (this->request.isApproximate())
      {
        solved.exact.emplace(this->solveExactly(
          solved.field->relativeErrorBound(), this->surface.partition.ownFaces()));
      }
      const std::vector<SourceCurve>& curves = this->inputs.sources.curves;
      nearest.emplace(solved.exactField(), *this->inputs.patch, curves);
      regions.emplace(solved.exactField(), *nearest, curves, this->request.arrays.areSidesNeeded());
    }
    const UnmeshedTriangles unmeshed(this->surface);
    RefinementOptions options = this->refinementOptions(unmeshed);
    options.regions = regions ? &*regions : nullptr;
    solved.refined =
      addUnmeshedTriangles(unmeshed, this->request.maximumCells, options.cornerPoints,
        solved.field->vertexDistances(), geodesic::refine(*solved.field, options));
  }
};

} // anonymous namespace

SolvedSurface solveField(
  const Inputs& inputs, const FieldRequest& request, FilterExecution& execution)
{
  const FieldSolver solver{ inputs, request, execution };
  SolvedSurface solved = request.isRefined ? solver.solveAndRefine() : solver.solve();
  if (request.isApproximate() && request.arrays.areFeetNeeded() && !solved.exact)
  {
    solved.exact.emplace(
      solver.solveExactly(solved.field->relativeErrorBound(), solver.facesOf(solved.refined)));
  }
  return solved;
}

}
