// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/Inputs.h"

#include "PolyData/FilterExecution.h"
#include "PolyData/SurfaceCache.h"
#include "PolyData/ranks/SourcePatch.h"
#include "PolyData/reading/CoveredFaces.h"
#include "paths/FacesBetweenPoints.h"
#include "paths/JoinPoints.h"
#include "source/BoundaryCurves.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>

namespace geodesic
{

namespace
{

const char* const SurfaceName = "the surface (input port 0)";
const char* const SourceName = "the source (input port 1)";
const char* const TargetsName = "the set of targets (input port 2)";

/// Finds out who has what of the surface. All ranks call this together.
RankRole findRole(
  const std::vector<PolyDataBlock>& surfaceBlocks, bool supportsPieces, Exchange& exchange)
{
  using PointsAndFaces = std::array<vtkIdType, 2>;
  constexpr PointsAndFaces nothing{ 0, 0 };
  PointsAndFaces own = nothing;
  for (const PolyDataBlock& block : surfaceBlocks)
  {
    own[0] += block.data->GetNumberOfPoints();
    own[1] += block.data->GetNumberOfPolys() + block.data->GetNumberOfStrips();
  }
  const std::vector<PointsAndFaces> all = valuesOfRanks(exchange, own);
  const auto emptyOnes = std::count(all.begin(), all.end(), nothing);
  const int ranks = exchange.numberOfRanks();
  const bool isFirst = exchange.rank() == 0;
  if (emptyOnes + 1 >= ranks)
  {
    // If all are empty, rank 0 says so.
    const bool isWorking = own != nothing || (isFirst && emptyOnes == ranks);
    return { isWorking ? SurfacePlace::Here : SurfacePlace::OnOtherRank, isFirst };
  }
  bool areSame = std::count(all.begin(), all.end(), own) == ranks;
  if (areSame)
  {
    const Fingerprint key = contentKey(surfaceBlocks);
    const std::vector<Fingerprint> keys = valuesOfRanks(exchange, key);
    areSame = std::count(keys.begin(), keys.end(), key) == ranks;
  }
  const SurfacePlace place = !areSame ? SurfacePlace::InPieces
    : supportsPieces                  ? SurfacePlace::OnEveryRank
    : isFirst                         ? SurfacePlace::Here
                                      : SurfacePlace::OnOtherRank;
  return { place, isFirst };
}

/// The sources and the patch that they lie on.
struct SourcesOnPatch
{
  ReplicatedPatch patch;
  Sources sources;
  /// All ids are below.
  vtkIdType idEnd = 0;
};

/// The parts of readInputs().
struct InputReader
{
  const InputRequest& request;
  const ExecutionPlan& plan;
  SurfaceCache& cache;
  FilterExecution& execution;
  Exchange& exchange = execution.exchange();
  Notes& notes = execution.notes();

  /// \throws InputError if no points are connected that can be the targets.
  void requireTargets() const
  {
    const bool isSourceEnough =
      this->plan.targets == TargetPoints::OfTargetsOrSource && this->request.source;
    if (this->plan.targets != TargetPoints::None && !this->request.targets && !isSourceEnough)
    {
      throw InputError(
        "There are no targets (input port 2): choose a data set with points as Targets.");
    }
  }

  /// Nothing if no source is connected.
  GatheredBlocks gatherSource() const
  {
    if (!this->request.source)
    {
      return {};
    }
    PartArrays arrays;
    if (this->request.fromCurves)
    {
      arrays.sourceIds = this->request.sourceIdArray;
      arrays.sourceNames = this->plan.sourceNameArray;
    }
    if (!this->request.targets && !isChosen(this->plan.targetIdArray))
    {
      arrays.targetNames = this->plan.targetNameArray;
    }
    const PartName name(SourceName);
    return gatherBlocks(sourceBlocks(this->request.source, name, arrays), name, this->exchange);
  }

  PartName nameOfTargets() const
  {
    return PartName(
      this->request.targets ? TargetsName : "the set of targets (points of input port 1)");
  }

  GatheredBlocks gatherTargets() const
  {
    const PartName name = this->nameOfTargets();
    if (isChosen(this->plan.targetIdArray))
    {
      PartArrays arrays;
      arrays.sourceIds = this->plan.targetIdArray;
      arrays.sourceNames = this->plan.targetNameArray;
      arrays.areTargets = true;
      vtkDataObject* data = this->request.targets ? this->request.targets : this->request.source;
      return gatherBlocks(sourceBlocks(data, name, arrays), name, this->exchange);
    }
    return gatherBlocks(
      targetBlocks(this->request.targets, name, this->plan.targetNameArray), name, this->exchange);
  }

  /// Whether sets of targets are the sources, of the same data by the same arrays.
  bool areTargetsSources() const
  {
    const auto areSame = [](const char* a, const char* b)
    { return isChosen(a) ? isChosen(b) && std::string(a) == b : !isChosen(b); };
    return isChosen(this->plan.targetIdArray) && !this->request.targets &&
      this->request.fromCurves && !this->request.fromBoundary &&
      areSame(this->request.sourceIdArray, this->plan.targetIdArray) &&
      areSame(this->plan.sourceNameArray, this->plan.targetNameArray);
  }

  /// Reads the surface into the cache.
  void readSurface(const std::vector<PolyDataBlock>& blocks, bool isInPieces, const Job& job) const
  {
    if (isInPieces && !this->plan.supportsPieces)
    {
      throw InputError(
        std::string("The surface (input port 0) is distributed over several ranks, of which ") +
        this->request.filter +
        " needs all on one. Run with one rank, or have the whole surface on one rank or on each.");
    }
    this->cache.update(
      blocks, this->request.merging, isInPieces ? this->exchange : OneRank::instance(), job);
    noteSurface(this->cache.surface(), blocks, this->notes);
  }

  SourcesOnPatch readSources(const std::vector<PolyDataBlock>& surfaceBlocks,
    const std::vector<PolyDataBlock>& sourceBlocks) const
  {
    if (!this->request.fromBoundary && !this->request.source)
    {
      throw SourceError(
        "There is no source: choose a Source, or set Source Type to Surface Boundary.");
    }
    const bool hasCurve = this->request.fromCurves && this->request.source;
    if (hasCurve && this->request.source == this->request.surface)
    {
      this->notes.add(NoteOn::Source, "surface",
        "The surface itself is the source: all distances are 0. Choose another Source.");
    }
    const PolyDataSurface& surface = this->cache.surface();
    const Job locating = this->execution.begin(Stage::LocateSource);
    SourcePatch faces(surface.partition);
    std::optional<SurfaceBoundary> boundary;
    if (this->request.fromBoundary)
    {
      boundary.emplace(surface, faces, locating.part(0.0, hasCurve ? 0.0 : 1.0));
    }
    SourcesOnPatch read = hasCurve ? this->readCurves(surfaceBlocks, sourceBlocks, faces, locating)
                                   : SourcesOnPatch{ faces.make(), {}, 0 };
    if (boundary)
    {
      this->addBoundary(boundary->curvesOn(read.patch), hasCurve, read);
    }
    return read;
  }

  /// \param faces those on the boundary, if distances are measured from there, too.
  SourcesOnPatch readCurves(const std::vector<PolyDataBlock>& surfaceBlocks,
    const std::vector<PolyDataBlock>& blocks, SourcePatch& faces, const Job& locating) const
  {
    const PolyDataSurface& surface = this->cache.surface();
    const double outsideBarriers = surface.barriers ? 0.2 : 0.0;
    SourcePolylines source = readSource(blocks, surface, this->request.areLinesJoined,
      this->cache.locator(), locating.part(0.0, outsideBarriers));
    const double precision = coordinatePrecisionOf(blocks);
    LocatedPlaces located = this->cache.locator().locate(
      source.polylines, precision, locating.part(outsideBarriers, 0.9));
    requireOutsideBarriers(
      surface, surfaceBlocks, source.polylines, located, barriersAt(surface, located, precision));
    this->cache.locator().keepOnOneSide(
      source.polylines, precision, located, locating.part(0.9, 1.0));
    faces.addFacesAround(located);
    if (surface.partition.isDistributed() && !source.faces.empty())
    {
      this->addCoveredFaces(source.faces, precision, locating.part(1.0, 1.0), faces);
    }
    ReplicatedPatch patch = faces.make();
    located.setFaces(patch, source.polylines);
    const bool isDistributed = surface.partition.isDistributed();
    const Job joining = this->execution.begin(Stage::JoinSource);
    const double patchMade = isDistributed ? 0.8 : 0.0;
    if (isDistributed &&
      faces.addFaces(facesBetweenPoints(
        surface.partition, patch, source.polylines, precision, joining.part(0.0, patchMade))))
    {
      patch = faces.make();
      located.setFaces(patch, source.polylines);
    }
    const TriangleMesh& mesh = patch.mesh();
    const JoinPoints join = joinByShortestPaths(mesh);
    // With several ranks the next patch numbers its faces in another way.
    const JoinedPaths none;
    JoinedPaths paths;
    SourceCurves curves = curvesOn(mesh, source, precision,
      paths.joinBy(join, isDistributed ? none : this->cache.joinedPaths()),
      joining.part(patchMade, 1.0));
    if (!isDistributed)
    {
      this->cache.joinedPaths() = std::move(paths);
    }
    noteSource(surface, mesh, source, curves, this->plan.noteSourceBeyond, this->notes);
    if (this->plan.needsSides)
    {
      noteSides(mesh, source, curves, this->notes);
    }
    addBorders(mesh, curves.curves);
    const auto count = static_cast<Id>(source.ids.size());
    return { std::move(patch),
      { std::move(curves), std::move(source.ids), arePartsNamed(blocks), count,
        std::move(source.names) },
      source.idEnd };
  }

  /// Adds the faces of this rank that belong to the source as a whole, and those around them.
  void addCoveredFaces(const std::vector<LocatedPolyline>& sourceFaces, double precision,
    const Job& job, SourcePatch& faces) const
  {
    for (const CoveredFace& covered :
      findCoveredFaces(this->cache.surface().partition.mesh(), sourceFaces, precision, true, job))
    {
      faces.addFacesAround(covered.face);
    }
  }

  /// Puts polylines onto the surface, with the faces that their regions cover.
  static SourceCurves curvesOn(const TriangleMesh& mesh, const SourcePolylines& source,
    double precision, const JoinPoints& join, const Job& job)
  {
    SourceCurves curves = putOntoSurface(mesh, source.polylines, precision, join, job);
    coverFaces(
      findCoveredFaces(mesh, source.faces, precision, false, job.part(1.0, 1.0)), curves.curves);
    return curves;
  }

  static void addBorders(const TriangleMesh& mesh, std::vector<SourceCurve>& curves)
  {
    std::vector<SourceCurve> borders = bordersWithoutCurves(mesh, curves);
    std::move(borders.begin(), borders.end(), std::back_inserter(curves));
  }

  /// Gives faces to the first curve of their source, which has one.
  static void coverFaces(const std::vector<CoveredFace>& faces, std::vector<SourceCurve>& curves)
  {
    std::unordered_map<Id, std::size_t> first;
    for (std::size_t i = 0; i < curves.size(); ++i)
    {
      first.emplace(curves[i].source, i);
    }
    for (const CoveredFace& covered : faces)
    {
      curves[first.at(covered.source)].coveredFaces.push_back(covered.face);
    }
  }

  /// Adds the loops of the boundary to the curves.
  void addBoundary(std::vector<SourceCurve> loops, bool hasCurve, SourcesOnPatch& read) const
  {
    vtkIdType next = read.idEnd;
    for (SourceCurve& loop : loops)
    {
      loop.source = static_cast<Id>(read.sources.ids.size());
      read.sources.ids.push_back(next++);
    }
    const bool isClosed = loops.empty();
    if (this->cache.surface().barriers)
    {
      loops = boundaryOutsideBarriers(loops, read.patch.mesh());
    }
    const std::string nothing = isClosed
      ? "The surface (input port 0) is closed: it has no boundary to measure from."
      : "The whole boundary of the surface (input port 0) belongs to barriers (BarrierArrayName), "
        "which no path may leave.";
    if (loops.empty() && !hasCurve)
    {
      throw SourceError(nothing + " Set Source Type to Source Curve and choose a Source.");
    }
    if (loops.empty())
    {
      this->notes.add(NoteOn::Surface, "no boundary",
        isClosed ? "The surface is closed, without boundary: the curve alone is the source."
                 : "The whole boundary belongs to barriers: the curve alone is the source.");
    }
    if (!hasCurve && this->request.fromCurves)
    {
      this->notes.add(NoteOn::Source, "no curve",
        "No curve is connected as Source: the boundary alone is the source.");
    }
    std::move(loops.begin(), loops.end(), std::back_inserter(read.sources.curves));
  }

  Targets readTargets(const std::vector<PolyDataBlock>& blocks) const
  {
    const Job job = this->execution.begin(Stage::ReadTargets);
    const PolyDataSurface& surface = this->cache.surface();
    Targets targets =
      geodesic::readTargets(blocks, this->nameOfTargets(), surface, this->cache.locator(), job);
    // If the targets are the points of a source that is far away, the note on the source says so.
    if (this->request.targets || !this->notes.has(NoteOn::Source, FarNote))
    {
      noteTargets(surface, blocks, targets,
        this->request.targets ? NoteOn::Targets : NoteOn::Source, this->notes);
    }
    return targets;
  }

  /// \param patch the whole surface.
  Sources readTargetSets(const std::vector<PolyDataBlock>& surfaceBlocks,
    const std::vector<PolyDataBlock>& blocks, const ReplicatedPatch& patch) const
  {
    const Job job = this->execution.begin(Stage::ReadTargets);
    const PolyDataSurface& surface = this->cache.surface();
    SourcePolylines read = geodesic::readTargetSets(blocks, this->nameOfTargets(), surface);
    const double precision = coordinatePrecisionOf(blocks);
    LocatedPlaces located =
      this->cache.locator().locate(read.polylines, precision, job.part(0.0, 0.8));
    const std::vector<RankAddress> barriers = barriersAt(surface, located, precision);
    leaveOutPointsInBarriers(located, barriers, read);
    requireOutsideBarriers(surface, surfaceBlocks, read.polylines, located, barriers);
    this->cache.locator().keepOnOneSide(read.polylines, precision, located, job.part(0.8, 0.9));
    located.setFaces(patch, read.polylines);
    SourceCurves curves = curvesOn(
      patch.mesh(), read, precision, joinByShortestPaths(patch.mesh()), job.part(0.9, 1.0));
    addBorders(patch.mesh(), curves.curves);
    const NoteOn input = this->request.targets ? NoteOn::Targets : NoteOn::Source;
    noteTargetSets(surface, patch.mesh(), read, input, this->notes);
    return { std::move(curves), std::move(read.ids), true, 0, std::move(read.names) };
  }
};

}

std::vector<Stage> ExecutionPlan::allStages() const
{
  std::vector<Stage> all = { Stage::ReadSurface, Stage::LocateSource, Stage::JoinSource };
  if (this->targets != TargetPoints::None)
  {
    all.push_back(Stage::ReadTargets);
  }
  all.insert(all.end(), this->stages.begin(), this->stages.end());
  return all;
}

const Sources* Inputs::setsOfTargets() const
{
  return this->areTargetsSources ? &this->sources : this->targetSets ? &*this->targetSets : nullptr;
}

SourceWindows Inputs::sourceWindows(const Job& job) const
{
  return sourceWindowsOfPartition(this->surface->partition, *this->patch,
    startingWindows(this->patch->mesh(), this->sources.curves, job));
}

Inputs readInputs(const InputRequest& request, const ExecutionPlan& plan, SurfaceCache& cache,
  FilterExecution& execution)
{
  const InputReader reader{ request, plan, cache, execution };
  reader.requireTargets();
  const Job reading = execution.begin(Stage::ReadSurface);
  Inputs inputs;
  inputs.surfaceInput = request.surface;
  inputs.surfaceBlocks = polyDataBlocks(request.surface, PartName(SurfaceName));
  findBarrierArrays(inputs.surfaceBlocks, request.barrierArray, reader.exchange);
  const GatheredBlocks source = reader.gatherSource();
  if (plan.targets != TargetPoints::None)
  {
    inputs.areTargetsSources = reader.areTargetsSources();
    const bool isSource =
      inputs.areTargetsSources || (!request.targets && !isChosen(plan.targetIdArray));
    inputs.targetBlocks = isSource ? source : reader.gatherTargets();
  }
  inputs.rank = findRole(inputs.surfaceBlocks, plan.supportsPieces, reader.exchange);
  if (!inputs.rank.isWorking())
  {
    return inputs;
  }
  reader.readSurface(inputs.surfaceBlocks, inputs.rank.isInPieces(), reading);
  inputs.surface = &cache.surface();
  SourcesOnPatch onPatch = reader.readSources(inputs.surfaceBlocks, source.blocks);
  inputs.patch = std::move(onPatch.patch);
  inputs.sources = std::move(onPatch.sources);
  if (isChosen(plan.targetIdArray))
  {
    if (!inputs.areTargetsSources)
    {
      inputs.targetSets =
        reader.readTargetSets(inputs.surfaceBlocks, inputs.targetBlocks.blocks, *inputs.patch);
    }
    inputs.targets.count = inputs.setsOfTargets()->ids.size();
    inputs.targets.numbers.resize(inputs.targets.count);
    std::iota(inputs.targets.numbers.begin(), inputs.targets.numbers.end(), std::size_t{ 0 });
  }
  else if (plan.targets != TargetPoints::None)
  {
    inputs.targets = reader.readTargets(inputs.targetBlocks.blocks);
  }
  return inputs;
}

}
