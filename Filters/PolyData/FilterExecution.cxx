// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/FilterExecution.h"

#include "PolyData/ParallelFor.h"
#include "PolyData/PolyDataSource.h"
#include "field/JoinPoints.h"
#include "source/BoundaryCurves.h"
#include "vtkGeodesicAlgorithm.h"

#include "vtkVersionMacros.h"

#include <iterator>
#include <utility>

namespace geodesic
{

namespace
{

// Where the stages end, as fractions of the whole.
constexpr double SurfaceRead = 0.15;
constexpr double SourceLocated = 0.2;

}

const char* describe(Stage stage)
{
  switch (stage)
  {
    case Stage::ReadingSurface:
      return "reading the surface";
    case Stage::ReadingSource:
      return "putting the source onto the surface, after reading the surface";
    case Stage::ReadingTargets:
      return "putting the targets onto the surface, after reading the surface and the source";
    case Stage::ComputingDistances:
      return "computing the distances, after reading the surface and the source";
    case Stage::Refining:
      return "refining the surface, after computing the distances";
    case Stage::DrawingLines:
      return "drawing the lines, after computing the distances";
    case Stage::WritingOutputs:
      return "writing the outputs, after all was computed";
  }
  return "";
}

FilterExecution::FilterExecution(vtkGeodesicAlgorithm* filter, SurfaceCache& cache, Stage& stage,
  vtkDataObject* surface, vtkDataObject* source, vtkDataObject* targets)
  : filter_(filter)
  , cache_(cache)
  , stage_(stage)
  , surfaceInput_(surface)
  , sourceInput_(source)
  , targetsInput_(targets)
{
}

void FilterExecution::readInputs()
{
  this->enter(Stage::ReadingSurface);
  this->surfaceBlocks_ = polyDataBlocks(this->surfaceInput_, "the surface (input port 0)");
  const BarrierArrays barriers(this->surfaceBlocks_, this->filter_->GetBarrierArrayName());
  this->cache_.update(this->surfaceBlocks_, barriers, this->filter_->GetMergeCoincidentPoints(),
    this->progressBetween(0.0, SurfaceRead));
  noteSurface(this->surface(), this->notes_);
  this->reach(SurfaceRead);
  this->enter(Stage::ReadingSource);
  this->readSources();
}

void FilterExecution::requireTargets(bool sourcesAreTargets) const
{
  if (!this->targetsInput_ && !(sourcesAreTargets && this->sourceInput_))
  {
    throw InputError(
      "There are no targets (input port 2): choose a data set with points as Targets.");
  }
}

Targets FilterExecution::readTargets(double end)
{
  this->enter(Stage::ReadingTargets);
  const std::string name = this->targetsInput_ ? "the set of targets (input port 2)"
                                               : "the set of targets (points of input port 1)";
  vtkDataObject* input = this->targetsInput_ ? this->targetsInput_ : this->sourceInput_;
  Targets targets = geodesic::readTargets(polyDataBlocks(input, name), name, this->surface(),
    this->locator(), this->progressBetween(InputsRead, end));
  this->reach(end);
  return targets;
}

void FilterExecution::readSources()
{
  const int type = this->filter_->GetSourceType();
  if (type == vtkGeodesicAlgorithm::SOURCE_CURVE && !this->sourceInput_)
  {
    throw SourceError(
      "There is no source (port 1): choose a Source, or set Source Type to Surface Boundary.");
  }
  const bool hasCurve = type != vtkGeodesicAlgorithm::SURFACE_BOUNDARY && this->sourceInput_;
  if (hasCurve)
  {
    const std::vector<PolyDataBlock> blocks =
      polyDataBlocks(this->sourceInput_, "the source (input port 1)");
    const SourcePolylines source = readSource(blocks, this->surface().scale(), this->locator(),
      this->progressBetween(SurfaceRead, SourceLocated));
    const SnapOptions snapping = snapOptionsFor(blocks);
    requireOutsideBarriers(
      this->surface(), this->surfaceBlocks_, source.polylines, snapping.coordinatePrecision);
    JoinedPaths& paths = this->cache_.joinedPaths();
    paths.beginUse();
    this->sources_ = putOntoSurface(this->surface().mesh(), source.polylines, snapping,
      paths.reusedBy(joinByShortestPaths(this->surface().mesh(), smpParallelFor())),
      this->progressBetween(SourceLocated, InputsRead));
    paths.endUse();
    this->numberOfSources_ = source.numberOfSources;
    if (!this->isSourceDrawn_)
    {
      noteSource(this->surface(), source, this->sources_, this->notes_);
    }
  }
  this->firstBoundarySource_ = this->numberOfSources_;
  if (type != vtkGeodesicAlgorithm::SOURCE_CURVE)
  {
    this->addBoundary(hasCurve);
  }
}

std::vector<SourceCurve> FilterExecution::numberedBoundary(const TriangleMesh& mesh)
{
  std::vector<SourceCurve> boundary = boundaryCurves(mesh);
  for (SourceCurve& loop : boundary)
  {
    loop.source = this->numberOfSources_++;
  }
  return boundary;
}

void FilterExecution::addBoundary(bool hasCurve)
{
  // Rims of barriers are no boundary: loops are those of the whole surface, numbered as if it had
  // no barriers.
  const bool hasBarriers = this->surface().barriers() != nullptr;
  std::vector<SourceCurve> boundary = this->numberedBoundary(hasBarriers
      ? *this->surface().meshWithBarriers(
          this->progressBetween(hasCurve ? InputsRead : SurfaceRead, InputsRead))
      : this->surface().mesh());
  const bool isClosed = boundary.empty();
  if (hasBarriers)
  {
    boundary = boundaryOutsideBarriers(boundary, this->surface().mesh());
  }
  const std::string nothing = isClosed
    ? "The surface (input port 0) is closed: it has no boundary to measure from."
    : "The whole boundary of the surface (input port 0) belongs to barriers (BarrierArrayName), "
      "which no path may leave.";
  if (boundary.empty() && !hasCurve)
  {
    throw SourceError(nothing + " Set Source Type to Source Curve and choose a Source (port 1).");
  }
  if (boundary.empty())
  {
    this->notes_.add(NoteOn::Surface, "no boundary",
      isClosed ? "The surface is closed, without boundary: the curve alone is the source."
               : "The whole boundary belongs to barriers: the curve alone is the source.");
  }
  if (!hasCurve && this->filter_->GetSourceType() == vtkGeodesicAlgorithm::CURVE_AND_BOUNDARY)
  {
    this->notes_.add(NoteOn::Source, "no curve",
      "No curve is connected as Source (port 1): the boundary alone is the source.");
  }
  std::move(boundary.begin(), boundary.end(), std::back_inserter(this->sources_.curves));
}

ProgressCallback FilterExecution::progressBetween(double begin, double end)
{
  return [filter = this->filter_, &memory = this->memory_, begin, end](double fraction)
  {
    memory.look();
    filter->UpdateProgress(begin + fraction * (end - begin));
#if VTK_VERSION_NUMBER >= 90220220630ULL
    return !filter->CheckAbort();
#else
    return !filter->GetAbortExecute();
#endif
  };
}

void FilterExecution::reach(double fraction)
{
  if (!this->progressBetween(fraction, fraction)(1.0))
  {
    throw Aborted();
  }
}

}
