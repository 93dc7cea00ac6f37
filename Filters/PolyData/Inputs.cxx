// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/Inputs.h"

#include "PolyData/FilterExecution.h"
#include "PolyData/SurfaceCache.h"
#include "PolyData/ranks/SourcePatch.h"
#include "PolyData/reading/InputArrays.h"
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

/// The parts of readInputs().
struct InputReader
{
  const InputRequest& request;
  const ExecutionPlan& plan;
  SurfaceCache& cache;
  FilterExecution& execution;
  Inputs& inputs;
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
  NoteOn inputOfTargets() const { return this->request.targets ? NoteOn::Targets : NoteOn::Source; }

  GatheredBlocks gatherTargets() const
  {
    PartArrays arrays;
    arrays.areTargets = true;
    arrays.sourceIds = this->plan.targetIdArray;
    (isChosen(arrays.sourceIds) ? arrays.sourceNames : arrays.targetNames) =
      this->plan.targetNameArray;
    const PartName name = this->nameOfTargets();
    vtkDataObject* data = this->request.targets ? this->request.targets : this->request.source;
    return gatherBlocks(sourceBlocks(data, name, arrays), name, this->exchange);
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
  void readSurface(const Job& job) const
  {
    const bool isInPieces = this->inputs.rank.isInPieces();
    if (isInPieces && !this->plan.supportsPieces)
    {
      throw InputError(
        std::string("The surface (input port 0) is distributed over several ranks, of which ") +
        this->request.filter +
        " needs all on one. Run with one rank, or have the whole surface on one rank or on each.");
    }
    this->cache.update(this->inputs.surfaceBlocks, this->request.merging,
      isInPieces ? this->exchange : OneRank::instance(), job);
    this->inputs.surface = &this->cache.surface();
    noteSurface(*this->inputs.surface, this->notes);
  }

  /// Reads the sources, and makes the patch that they lie on.
  void readSources(const std::vector<PolyDataBlock>& blocks) const
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
    const Job locating = this->execution.begin(Stage::LocateSource);
    SourcePatch faces(this->inputs.surface->partition);
    std::vector<SourceCurve> loops;
    if (this->request.fromBoundary)
    {
      loops = boundaryOfAllFaces(*this->inputs.surface);
      faces.addBoundary(loops);
    }
    if (hasCurve)
    {
      this->readCurves(blocks, faces, locating);
    }
    else
    {
      this->inputs.patch = faces.make();
    }
    if (this->request.fromBoundary)
    {
      this->addBoundary(std::move(loops), hasCurve);
    }
  }

  /// \param targets their name, if the parts are sets of targets; else null.
  SourceCells readParts(
    const std::vector<PolyDataBlock>& blocks, const PartName* targets, const Job& job) const
  {
    return geodesic::readParts({ blocks, targets, targets || this->request.areLinesJoined,
                                 *this->inputs.surface, this->cache.locator() },
      job);
  }

  /// \param faces those on the boundary, if distances are measured from there, too.
  void readCurves(
    const std::vector<PolyDataBlock>& blocks, SourcePatch& faces, const Job& locating) const
  {
    const MeshPartition& surface = this->inputs.surface->partition;
    const bool isDistributed = surface.isDistributed();
    SourceCells source = this->readParts(blocks, nullptr, locating);
    faces.addFacesAround(source.located);
    for (const SourceFace& face : source.faces)
    {
      std::for_each(face.covered.begin(), face.covered.end(),
        [&faces](const RankAddress& covered) { faces.addFacesAround(covered); });
    }
    std::optional<ReplicatedPatch>& patch = this->inputs.patch;
    const auto makePatch = [&]
    {
      patch = faces.make();
      source.located.setFaces(*patch, source.polylines);
    };
    makePatch();
    const Job joining = this->execution.begin(Stage::JoinSource);
    const double patchMade = isDistributed ? 0.8 : 0.0;
    if (isDistributed &&
      faces.addFaces(facesBetweenPoints(
        surface, *patch, source.polylines, source.precision, joining.part(0.0, patchMade))))
    {
      makePatch();
    }
    const TriangleMesh& mesh = patch->mesh();
    JoinedPaths paths;
    SourceCurves curves =
      curvesOn(*patch, source, paths.joinBy(joinByShortestPaths(mesh), this->cache.joinedPaths()),
        joining.part(patchMade, 1.0));
    if (!isDistributed) // else the next patch numbers its faces in another way
    {
      this->cache.joinedPaths() = std::move(paths);
    }
    noteSource(
      *this->inputs.surface, mesh, source, curves, this->plan.noteSourceBeyond, this->notes);
    if (this->plan.needsSides)
    {
      noteSides(mesh, source, curves, this->notes);
    }
    addBordersWithoutCurves(mesh, curves.curves);
    const auto count = static_cast<Id>(source.parts.ids.size());
    this->inputs.sources = { std::move(curves), std::move(source.parts), count };
  }

  /// Puts polylines onto the surface, with the faces that their regions cover: the first curve of
  /// their source, which has one, gets them.
  static SourceCurves curvesOn(
    const ReplicatedPatch& patch, const SourceCells& source, const JoinPoints& join, const Job& job)
  {
    SourceCurves on = putOntoSurface(patch.mesh(), source.polylines, source.precision, join, job);
    std::unordered_map<Id, std::size_t> first;
    for (std::size_t i = 0; i < on.curves.size(); ++i)
    {
      first.emplace(on.curves[i].source, i);
    }
    for (const SourceFace& face : source.faces)
    {
      for (const RankAddress& covered : face.covered)
      {
        std::vector<Id>& faces = on.curves[first.at(face.outline.source)].coveredFaces;
        faces.push_back(patch.faceAt(covered));
      }
    }
    return on;
  }

  /// Adds the loops of the boundary to the curves.
  void addBoundary(std::vector<SourceCurve> loops, bool hasCurve) const
  {
    Sources& sources = this->inputs.sources;
    const ReplicatedPatch& patch = *this->inputs.patch;
    const Id globalIds = this->inputs.surface->partition.numberOfGlobalVertices();
    for (SourceCurve& loop : loops)
    {
      loop.source = static_cast<Id>(sources.ids.size());
      sources.ids.push_back(sources.idEnd++);
      for (SurfacePoint& point : loop.points)
      {
        // Vertices that only barriers have keep their numbers, behind those of the patch.
        point.id = point.id < globalIds ? patch.vertexAt(GlobalId{ point.id }) : point.id;
      }
    }
    const bool isClosed = loops.empty();
    loops = boundaryOutsideBarriers(loops, patch.mesh());
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
    std::move(loops.begin(), loops.end(), std::back_inserter(sources.curves));
  }

  void readTargets() const
  {
    if (this->plan.targets == TargetPoints::None)
    {
      return;
    }
    if (!isChosen(this->plan.targetIdArray))
    {
      this->readTargetPoints();
      return;
    }
    if (!this->inputs.areTargetsSources)
    {
      this->readTargetSets();
    }
    Targets& targets = this->inputs.targets;
    targets.count = this->inputs.setsOfTargets()->ids.size();
    targets.numbers.resize(targets.count);
    std::iota(targets.numbers.begin(), targets.numbers.end(), std::size_t{ 0 });
  }

  void readTargetPoints() const
  {
    const Job job = this->execution.begin(Stage::ReadTargets);
    const std::vector<PolyDataBlock>& blocks = this->inputs.targetBlocks.blocks;
    this->inputs.targets = geodesic::readTargets(
      blocks, this->nameOfTargets(), *this->inputs.surface, this->cache.locator(), job);
    // If the targets are the points of a source that is far away, the note on the source says so.
    if (this->request.targets || !this->notes.has(NoteOn::Source, FarNote))
    {
      noteTargets(
        *this->inputs.surface, blocks, this->inputs.targets, this->inputOfTargets(), this->notes);
    }
  }

  /// In one process: the patch is the whole surface.
  void readTargetSets() const
  {
    const Job job = this->execution.begin(Stage::ReadTargets);
    const PartName name = this->nameOfTargets();
    SourceCells read = this->readParts(this->inputs.targetBlocks.blocks, &name, job.part(0.0, 0.9));
    const TriangleMesh& mesh = this->inputs.patch->mesh();
    read.located.setFaces(*this->inputs.patch, read.polylines);
    SourceCurves curves =
      curvesOn(*this->inputs.patch, read, joinByShortestPaths(mesh), job.part(0.9, 1.0));
    addBordersWithoutCurves(mesh, curves.curves);
    noteTargetSets(*this->inputs.surface, mesh, read, this->inputOfTargets(), this->notes);
    this->inputs.targetSets = Sources{ std::move(curves), std::move(read.parts), 0 };
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
  return makeSourceWindows(this->surface->partition, *this->patch, this->sources.curves, job);
}

Inputs readInputs(const InputRequest& request, const ExecutionPlan& plan, SurfaceCache& cache,
  FilterExecution& execution)
{
  Inputs inputs;
  const InputReader reader{ request, plan, cache, execution, inputs };
  reader.requireTargets();
  const Job reading = execution.begin(Stage::ReadSurface);
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
    inputs.surface = &cache.keepNothing(inputs.surfaceBlocks.size());
  }
  else
  {
    reader.readSurface(reading);
    reader.readSources(source.blocks);
    reader.readTargets();
  }
  return inputs;
}

}
