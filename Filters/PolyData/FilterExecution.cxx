// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/FilterExecution.h"

#include "PolyData/ranks/SourcePatch.h"
#include "ThreadTeam.h"
#include "paths/FacesBetweenPoints.h"
#include "paths/JoinPoints.h"
#include "source/BoundaryCurves.h"
#include "source/SourceWindows.h"
#include "vtkGeodesicAlgorithm.h"

#include "vtkSMPTools.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>

namespace geodesic
{

namespace
{

const char* const SourceName = "the source (input port 1)";
const char* const TargetsName = "the set of targets (input port 2)";

}

FilterExecution::FilterExecution(vtkGeodesicAlgorithm* filter, SurfaceCache& cache, Stage& stage,
  vtkDataObject* surface, vtkDataObject* source, vtkDataObject* targets, Exchange& exchange)
  : filter_(filter)
  , cache_(cache)
  , stage_(stage)
  , job_([this](double done) { return this->tellFilter(done); },
      teamOf(static_cast<std::size_t>(vtkSMPTools::GetEstimatedNumberOfThreads())))
  , surfaceInput_(surface)
  , sourceInput_(source)
  , targetsInput_(targets)
  , exchange_(exchange)
{
}

bool FilterExecution::tellFilter(double done)
{
  this->memory_.look();
  this->filter_->UpdateProgress(done);
#if VTK_VERSION_NUMBER >= 90220220630ULL
  return !this->filter_->CheckAbort();
#else
  return !this->filter_->GetAbortExecute();
#endif
}

Job FilterExecution::begin(Stage stage)
{
  this->stage_ = stage;
  const Stretch stretch = stretchOf(stage, this->stages_);
  const Job job = this->job_.part(stretch.begin, stretch.end);
  job.reach(0.0);
  return job;
}

void FilterExecution::readInputs(const std::vector<Stage>& next, bool supportsPieces)
{
  this->stages_ = { Stage::ReadSurface, Stage::LocateSource, Stage::JoinSource };
  this->stages_.insert(this->stages_.end(), next.begin(), next.end());
  const Job reading = this->begin(Stage::ReadSurface);
  this->surfaceBlocks_ =
    polyDataBlocks(this->surfaceInput_, PartName("the surface (input port 0)"));
  findBarrierArrays(this->surfaceBlocks_, this->filter_->GetBarrierArrayName(), this->exchange_);
  if (this->sourceInput_)
  {
    const bool isSource = this->filter_->GetSourceType() != vtkGeodesicAlgorithm::SURFACE_BOUNDARY;
    const char* idArray = isSource ? this->filter_->GetSourceIdArrayName() : nullptr;
    const PartName name(SourceName);
    this->gatheredSource_ =
      gatherBlocks(sourceBlocks(this->sourceInput_, name, idArray), name, this->exchange_);
  }
  const PartName targets(TargetsName);
  this->gatheredTargets_ = this->targetsInput_
    ? gatherBlocks(targetBlocks(this->targetsInput_, targets), targets, this->exchange_)
    : this->gatheredSource_;
  this->findSurface(supportsPieces);
  if (this->place_ == SurfacePlace::OnOtherRank)
  {
    return;
  }
  const bool isInPieces = this->place_ == SurfacePlace::InPieces;
  if (isInPieces && !supportsPieces)
  {
    throw InputError(
      std::string("The surface (input port 0) is distributed over several ranks, of which ") +
      this->filter_->GetClassName() +
      " needs all on one. Run with one rank, or have the whole surface on one rank or on each.");
  }
  this->cache_.update(this->surfaceBlocks_,
    { this->filter_->GetMergeCoincidentPoints(), this->filter_->GetMergeTolerance() },
    isInPieces ? this->exchange_ : OneRank::instance(), reading);
  noteSurface(this->surface(), this->notes_);
  this->readSources();
}

/// The message of the first rank that has the surface.
Message FilterExecution::ofWorkingRank(const Message& own) const
{
  const bool works = this->place_ != SurfacePlace::OnOtherRank;
  const std::vector<Message> told = this->exchange_.tellAll(works ? own : Message());
  return *std::find_if(told.begin(), told.end(), [](const Message& m) { return !m.empty(); });
}

/// Finds out who has what of the surface.
void FilterExecution::findSurface(bool supportsPieces)
{
  using PointsAndFaces = std::array<vtkIdType, 2>;
  constexpr PointsAndFaces nothing{ 0, 0 };
  PointsAndFaces own = nothing;
  for (const PolyDataBlock& block : this->surfaceBlocks_)
  {
    own[0] += block.data->GetNumberOfPoints();
    own[1] += block.data->GetNumberOfPolys() + block.data->GetNumberOfStrips();
  }
  const std::vector<PointsAndFaces> all = valuesOfRanks(this->exchange_, own);
  const auto emptyOnes = std::count(all.begin(), all.end(), nothing);
  const int ranks = this->exchange_.numberOfRanks();
  if (emptyOnes + 1 >= ranks)
  {
    // If all are empty, rank 0 says so.
    const bool isWorker = own != nothing || (this->isFirstRank() && emptyOnes == ranks);
    this->place_ = isWorker ? SurfacePlace::Here : SurfacePlace::OnOtherRank;
    return;
  }
  bool areSame = std::count(all.begin(), all.end(), own) == ranks;
  if (areSame)
  {
    const Fingerprint key = contentKey(this->surfaceBlocks_);
    const std::vector<Fingerprint> keys = valuesOfRanks(this->exchange_, key);
    areSame = std::count(keys.begin(), keys.end(), key) == ranks;
  }
  this->place_ = !areSame ? SurfacePlace::InPieces
    : supportsPieces      ? SurfacePlace::OnEveryRank
    : this->isFirstRank() ? SurfacePlace::Here
                          : SurfacePlace::OnOtherRank;
}

SourceWindows FilterExecution::sourceWindows(const Job& job) const
{
  return sourceWindowsOfPartition(this->surface().partition, this->patch(),
    startingWindows(this->patch().mesh(), this->sources_.curves, job));
}

void FilterExecution::requireTargets(bool sourcesAreTargets) const
{
  if (!this->targetsInput_ && !(sourcesAreTargets && this->sourceInput_))
  {
    throw InputError(
      "There are no targets (input port 2): choose a data set with points as Targets.");
  }
}

Targets FilterExecution::readTargets()
{
  const Job job = this->begin(Stage::ReadTargets);
  const PartName name(
    this->targetsInput_ ? TargetsName : "the set of targets (points of input port 1)");
  const std::vector<PolyDataBlock>& blocks = this->gatheredTargets_.blocks;
  Targets targets =
    geodesic::readTargets(blocks, name, this->surface(), this->cache_.locator(), job);
  // If the targets are the points of a source that is far away, the note on the source says so.
  if (this->targetsInput_ || !this->notes_.has(NoteOn::Source, FarNote))
  {
    noteTargets(this->surface(), blocks, targets,
      this->targetsInput_ ? NoteOn::Targets : NoteOn::Source, this->notes_);
  }
  return targets;
}

void FilterExecution::readSources()
{
  const int type = this->filter_->GetSourceType();
  if (type == vtkGeodesicAlgorithm::SOURCE_CURVE && !this->sourceInput_)
  {
    throw SourceError(
      "There is no source: choose a Source, or set Source Type to Surface Boundary.");
  }
  const bool hasCurve = type != vtkGeodesicAlgorithm::SURFACE_BOUNDARY && this->sourceInput_;
  if (hasCurve && this->sourceInput_ == this->surfaceInput_)
  {
    this->notes_.add(NoteOn::Source, "surface",
      "The surface itself is the source: distances are measured from the outlines of all its "
      "faces. Choose another Source.");
  }
  const Job locating = this->begin(Stage::LocateSource);
  SourcePatch faces(this->surface().partition);
  std::optional<SurfaceBoundary> boundary;
  if (type != vtkGeodesicAlgorithm::SOURCE_CURVE)
  {
    boundary.emplace(this->surface(), faces, locating.part(0.0, hasCurve ? 0.0 : 1.0));
  }
  if (hasCurve)
  {
    this->readCurves(faces, locating);
  }
  else
  {
    this->patch_ = faces.make();
  }
  if (boundary)
  {
    this->addBoundary(boundary->curvesOn(this->patch()), hasCurve);
  }
}

void FilterExecution::readCurves(SourcePatch& faces, const Job& locating)
{
  const std::vector<PolyDataBlock>& blocks = this->gatheredSource_.blocks;
  const PolyDataSurface& surface = this->surface();
  SourcePolylines source = readSource(blocks, surface, this->filter_->GetJoinLines());
  const double precision = coordinatePrecisionOf(blocks);
  const LocatedPlaces located =
    this->cache_.locator().locate(source.polylines, precision, locating);
  requireOutsideBarriers(surface, this->surfaceBlocks_, source.polylines, located, precision);
  faces.addFacesAround(located);
  this->patch_ = faces.make();
  located.setFaces(this->patch(), source.polylines);
  const bool isDistributed = surface.partition.isDistributed();
  const Job joining = this->begin(Stage::JoinSource);
  const double patchMade = isDistributed ? 0.8 : 0.0;
  if (isDistributed &&
    faces.addFaces(facesBetweenPoints(
      surface.partition, this->patch(), source.polylines, precision, joining.part(0.0, patchMade))))
  {
    this->patch_ = faces.make();
    located.setFaces(this->patch(), source.polylines);
  }
  const TriangleMesh& mesh = this->patch().mesh();
  const JoinPoints join = joinByShortestPaths(mesh);
  // With several ranks the next patch numbers its faces in another way.
  JoinedPaths ofThisPatch;
  JoinedPaths& paths = isDistributed ? ofThisPatch : this->cache_.joinedPaths();
  paths.beginUse();
  this->sources_ = putOntoSurface(
    mesh, source.polylines, precision, paths.reusedBy(join), joining.part(patchMade, 1.0));
  paths.endUse();
  this->sourceIds_ = source.ids;
  this->areSourcesNamed_ = std::any_of(blocks.begin(), blocks.end(),
    [](const PolyDataBlock& block) { return !block.sourceIds.empty(); });
  this->firstBoundarySource_ = static_cast<Id>(source.ids.size());
  this->firstBoundaryId_ = source.idEnd;
  noteSource(surface, mesh, source, this->sources_, this->notes_);
}

void FilterExecution::addBoundary(std::vector<SourceCurve> boundary, bool hasCurve)
{
  vtkIdType next = this->firstBoundaryId_;
  for (SourceCurve& loop : boundary)
  {
    loop.source = static_cast<Id>(this->sourceIds_.size());
    this->sourceIds_.push_back(next++);
  }
  const bool isClosed = boundary.empty();
  if (this->surface().barriers)
  {
    boundary = boundaryOutsideBarriers(boundary, this->patch().mesh());
  }
  const std::string nothing = isClosed
    ? "The surface (input port 0) is closed: it has no boundary to measure from."
    : "The whole boundary of the surface (input port 0) belongs to barriers (BarrierArrayName), "
      "which no path may leave.";
  if (boundary.empty() && !hasCurve)
  {
    throw SourceError(nothing + " Set Source Type to Source Curve and choose a Source.");
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
      "No curve is connected as Source: the boundary alone is the source.");
  }
  std::move(boundary.begin(), boundary.end(), std::back_inserter(this->sources_.curves));
}

}
