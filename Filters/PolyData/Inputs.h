// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Inputs_h
#define geodesic_Inputs_h

#include "Job.h"
#include "PolyData/Notes.h"
#include "PolyData/PolyDataBlocks.h"
#include "PolyData/Stages.h"
#include "PolyData/ranks/GatheredBlocks.h"
#include "PolyData/reading/SourceParts.h"
#include "PolyData/reading/SurfaceReader.h"
#include "PolyData/reading/Targets.h"
#include "mesh/ReplicatedPatch.h"
#include "source/PolylineOnSurface.h"
#include "source/SourceWindows.h"

#include <optional>
#include <string>
#include <vector>

class vtkDataObject;

namespace geodesic
{

class FilterExecution;
class SurfaceCache;

/// Where the surface is.
enum class SurfacePlace
{
  /// Whole in this process, which works alone.
  Here,
  /// Whole on every rank, each of which works alone.
  OnEveryRank,
  /// Whole on another rank, which works alone: this one has nothing of it.
  OnOtherRank,
  /// Each rank has a piece, or nothing, and all work together.
  InPieces
};

/// Where the surface is, and what this rank does therefore.
struct RankRole
{
  SurfacePlace surface = SurfacePlace::Here;
  bool isFirst = true;

  /// Whether this rank computes.
  bool isWorking() const { return this->surface != SurfacePlace::OnOtherRank; }
  bool isInPieces() const { return this->surface == SurfacePlace::InPieces; }
  /// Whether this rank writes what all ranks have of the source.
  bool writesSource() const { return !this->isInPieces() || this->isFirst; }
  /// Whether this rank shows the notes to the user. If several ranks have the same notes, one shows
  /// them.
  bool showsNotes() const { return this->surface == SurfacePlace::Here || this->isFirst; }
};

/// Which points are the targets of a filter.
enum class TargetPoints
{
  /// The filter has no targets.
  None,
  /// Those of input port 2.
  OfTargets,
  /// Those of input port 2 or, if nothing is connected there, those of the source.
  OfTargetsOrSource
};

/// What a filter needs of its inputs, and the stages of its work.
struct ExecutionPlan
{
  /// The stages that follow reading the inputs.
  std::vector<Stage> stages;
  TargetPoints targets = TargetPoints::None;
  /// Whether the filter can work on a surface of which each rank has a piece. If each rank has the
  /// whole surface, all ranks work alone, or, if the filter cannot, the first one only.
  bool supportsPieces = true;
  /// A note tells that the source is farther from the surface than this fraction of its diagonal.
  double noteSourceBeyond = FarFraction;
  /// Names of the arrays with the names of the source's parts and of the targets; see PartArrays.
  const char* sourceNameArray = nullptr;
  const char* targetNameArray = nullptr;
  /// Name of the array that makes sets of the targets; see PartArrays.
  const char* targetIdArray = nullptr;
  /// Whether the sides of curves are asked for: a note tells where they are ambiguous.
  bool needsSides = false;

  /// With those of reading the inputs.
  std::vector<Stage> allStages() const;
};

/// The inputs of an execution, and the properties by which they are read.
struct InputRequest
{
  /// On input port 0.
  vtkDataObject* surface;
  /// On input ports 1 and 2, or null.
  vtkDataObject* source;
  vtkDataObject* targets;
  /// Whether distances are measured from the curves of the source, and from the boundary.
  bool fromCurves;
  bool fromBoundary;
  bool areLinesJoined;
  PointMerging merging;
  /// Names of arrays; null, empty and "None": none.
  const char* sourceIdArray;
  const char* barrierArray;
  /// As messages call the filter.
  const char* filter;
};

/// The sources, whose curves lie on the patch: the parts of the source, then the loops of the
/// boundary.
struct Sources
  : SourceCurves
  , PartIds
{
  /// From which place among the ids on they are loops of the boundary.
  Id firstBoundary = 0;
};

/// Whether a property is a length that can be a tolerance.
inline bool isPositive(double length)
{
  return length > 0.0 && length < Infinity;
}

/// The message if a property MaximumDistance is negative or NaN.
inline const char* const WrongMaximumDistance =
  "MaximumDistance is not a number of at least 0: set the distance to stop at, in the units of the "
  "surface, or 0 for no limit.";

/// What an execution has read.
struct Inputs
{
  RankRole rank;
  /// On input port 0; and its blocks, as in PolyDataSurface::blocks.
  vtkDataObject* surfaceInput = nullptr;
  std::vector<PolyDataBlock> surfaceBlocks;
  /// Of all ranks; empty if the plan has no targets.
  GatheredBlocks targetBlocks;

  /// The surface, which the cache keeps. If this rank is not working, it has blocks without points,
  /// and all that follows is empty.
  const PolyDataSurface* surface = nullptr;
  /// What all ranks have of the surface around the source; in one process all of it.
  std::optional<ReplicatedPatch> patch;
  Sources sources;
  Targets targets;
  /// If an array makes sets of the targets, these, read as a source is; the targets have no places.
  std::optional<Sources> targetSets;
  /// Whether the sources are the sets of targets, too: then neither is read again.
  bool areTargetsSources = false;

  /// The targets if an array makes sets of them, else null.
  const Sources* setsOfTargets() const;

  /// A tolerance in the engine's units.
  ///
  /// \param absolute counts if it is absolute, in the units of the surface.
  /// \param relative counts otherwise, as a fraction of the surface's diagonal.
  double toleranceOf(bool isAbsolute, double absolute, double relative) const
  {
    return isAbsolute ? this->surface->scale.toEngine(absolute)
                      : relative * this->surface->diagonal;
  }
  /// A property MaximumDistance, for which 0 is no limit, in the engine's units.
  double limitOf(double maximumDistance) const
  {
    return maximumDistance > 0.0 ? this->surface->scale.toEngine(maximumDistance) : Infinity;
  }

  /// What the sources give the front to begin with.
  ///
  /// \param job of the solve: it can be stopped already.
  SourceWindows sourceWindows(const Job& job) const;
  /// The sum over all ranks that have a piece, which call this together.
  std::size_t sumOverPieces(std::size_t number) const
  {
    return static_cast<std::size_t>(sumOverRanks(this->surface->exchange(), number).all);
  }
};

/// Reads what a filter has planned to work on. All ranks call this together.
///
/// \param cache with the surface of the last execution.
/// \throws geodesic::Error if an input is missing or cannot be used; Aborted.
Inputs readInputs(const InputRequest& request, const ExecutionPlan& plan, SurfaceCache& cache,
  FilterExecution& execution);

}

#endif
