// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FilterExecution_h
#define geodesic_FilterExecution_h

#include "Exchange.h"
#include "Job.h"
#include "PolyData/Memory.h"
#include "PolyData/Notes.h"
#include "PolyData/PolyDataBlocks.h"
#include "PolyData/Stages.h"
#include "PolyData/SurfaceCache.h"
#include "PolyData/reading/SourcesAndTargets.h"
#include "mesh/ReplicatedPatch.h"
#include "source/PolylineOnSurface.h"
#include "source/SourceWindows.h"

#include <optional>
#include <vector>

class vtkDataObject;
class vtkGeodesicAlgorithm;

namespace geodesic
{

class SourcePatch;

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

/// What all filters do in one execution: read the surface and the source, tell how far they
/// are, obey abort, and collect what the user should know.
class FilterExecution
{
public:
  /// \param filter whose properties count, and which is told how far the work is.
  /// \param cache with the surface of the last execution.
  /// \param stage set to the current one, for whoever catches an exception.
  /// \param surface on input port 0.
  /// \param source on input port 1, or null.
  /// \param targets on input port 2, or null.
  /// \param exchange with the other ranks, all of which have such an execution.
  FilterExecution(vtkGeodesicAlgorithm* filter, SurfaceCache& cache, Stage& stage,
    vtkDataObject* surface, vtkDataObject* source, vtkDataObject* targets, Exchange& exchange);
  FilterExecution(const FilterExecution&) = delete;
  FilterExecution& operator=(const FilterExecution&) = delete;

  /// Reads the surface, and the source as SourceType has it. If the surface is OnOtherRank there is
  /// nothing to read, and everything is empty.
  ///
  /// \param next the stages that will follow.
  /// \param supportsPieces whether the filter can work on a surface of which each rank has a piece.
  ///        If each rank has the whole surface, all ranks work alone, or the first one only.
  /// \throws geodesic::Error if one of them cannot be used; Aborted.
  void readInputs(const std::vector<Stage>& next, bool supportsPieces);
  SurfacePlace surfacePlace() const { return this->place_; }
  /// Between all ranks.
  Exchange& exchange() const { return this->exchange_; }
  /// Gives ranks for which the surface is OnOtherRank what the working rank has found. All ranks
  /// call this.
  template <typename... Values>
  void shareResults(Values&... values)
  {
    Message message;
    (put(message, values), ...);
    message = this->ofWorkingRank(message);
    MessageReader reader(message);
    ((values = reader.get<Values>()), ...);
  }
  template <typename Value>
  void shareResults(std::vector<Value>& values)
  {
    Message message;
    putAll(message, values);
    message = this->ofWorkingRank(message);
    values = MessageReader(message).getAll<Value>();
  }
  /// Whether this is the rank that puts out what is there once: the first one.
  bool isFirstRank() const { return this->exchange_.rank() == 0; }
  /// Waits until all ranks have come to their end; nothing can fail after it.
  ///
  /// \throws Error, Aborted where another rank has failed.
  void finish() { this->exchange_.step(this->exchange_.noMessages()); }
  /// Puts the points of the targets onto the surface, after readInputs(). If no targets are
  /// connected, the points of the source are the targets.
  ///
  /// \throws geodesic::Error if they cannot be used; Aborted.
  Targets readTargets();
  /// \param sourcesAreTargets whether the points of the source can serve as targets.
  /// \throws InputError if no targets are connected.
  void requireTargets(bool sourcesAreTargets = false) const;

  vtkDataObject* surfaceInput() const { return this->surfaceInput_; }
  /// The blocks of the surface's input, as in PolyDataSurface::blocks.
  const std::vector<PolyDataBlock>& surfaceBlocks() const { return this->surfaceBlocks_; }
  const PolyDataSurface& surface() const { return this->cache_.surface(); }
  const SourceCurves& sources() const { return this->sources_; }
  /// Whether this rank puts out what all have of the source.
  bool hasSourceOutput() const
  {
    return this->place_ != SurfacePlace::InPieces || this->isFirstRank();
  }
  /// What all ranks have of the surface around the source; in one process all of it. The curves of
  /// sources() lie on it.
  const ReplicatedPatch& patch() const { return *this->patch_; }
  /// The rank whose input had a target, by its number; 0 where all had it.
  int rankOfTarget(std::size_t number) const { return this->gatheredTargets_.rankOfPoint(number); }
  /// What the sources give the front to begin with.
  ///
  /// \param job of the solve: it can be stopped already.
  SourceWindows sourceWindows(const Job& job) const;
  /// The sum over all ranks that have a piece, which call this together.
  std::size_t sumOverPieces(std::size_t number) const
  {
    return static_cast<std::size_t>(sumOverRanks(this->surface().exchange(), number).all);
  }
  /// The ids of the parts of the source, ascending: the cells of port 1 (the points of a set of
  /// points), or the values of the array that names them, then the loops of the boundary.
  /// SourceCurve::source is the place of an id here.
  const std::vector<vtkIdType>& sourceIds() const { return this->sourceIds_; }
  /// Whether an array has named them.
  bool areSourcesNamed() const { return this->areSourcesNamed_; }
  /// From which of these places on they are loops of the boundary.
  Id firstBoundarySource() const { return this->firstBoundarySource_; }

  /// Begins a stage, or begins it again.
  ///
  /// \returns its job, on the threads that vtkSMPTools is set to use. Whoever tells it how far the
  ///          stage is, throws NotEnoughMemory if the system has hardly any left.
  /// \throws Aborted
  Job begin(Stage stage);
  /// The threads and the watcher, for short loops between stages.
  const Job& job() const { return this->job_; }

  /// What the user should know.
  Notes& notes() { return this->notes_; }
  /// Whether this rank shows the notes to the user. If several ranks have the same notes, one shows
  /// them.
  bool reportsWarnings() const { return this->place_ == SurfacePlace::Here || this->isFirstRank(); }

private:
  Message ofWorkingRank(const Message& own) const;
  bool tellFilter(double done);
  void findSurface(bool supportsPieces);
  void readSources();
  void readCurves(SourcePatch& faces, const Job& locating);
  void addBoundary(std::vector<SourceCurve> boundary, bool hasCurve);

  vtkGeodesicAlgorithm* filter_;
  SurfaceCache& cache_;
  Stage& stage_;
  std::vector<Stage> stages_;
  Job job_;
  MemoryWatch memory_;
  vtkDataObject* surfaceInput_;
  vtkDataObject* sourceInput_;
  vtkDataObject* targetsInput_;
  Exchange& exchange_;
  SurfacePlace place_ = SurfacePlace::Here;
  std::vector<PolyDataBlock> surfaceBlocks_;
  /// Those of all ranks. If no targets are connected, the source has them.
  GatheredBlocks gatheredSource_;
  GatheredBlocks gatheredTargets_;
  std::optional<ReplicatedPatch> patch_;
  SourceCurves sources_;
  std::vector<vtkIdType> sourceIds_;
  bool areSourcesNamed_ = false;
  Id firstBoundarySource_ = 0;
  vtkIdType firstBoundaryId_ = 0;
  Notes notes_;
};

}

#endif
