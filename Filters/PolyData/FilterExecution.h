// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FilterExecution_h
#define geodesic_FilterExecution_h

#include "PolyData/Memory.h"
#include "PolyData/Notes.h"
#include "PolyData/PolyDataBlocks.h"
#include "PolyData/PolyDataTargets.h"
#include "PolyData/SurfaceCache.h"
#include "Progress.h"
#include "source/PolylineOnSurface.h"

#include <vector>

class vtkDataObject;
class vtkGeodesicAlgorithm;

namespace geodesic
{

/// What an execution is doing.
enum class Stage
{
  ReadingSurface,
  ReadingSource,
  ReadingTargets,
  ComputingDistances,
  Refining,
  DrawingLines,
  WritingOutputs
};

/// "computing the distances, after reading the surface and the source", for messages.
const char* describe(Stage stage);

/// What all filters do in one execution: read the surface and the source, report progress, obey
/// abort, and collect what the user should know.
class FilterExecution
{
public:
  /// Where reading the inputs ends, as a fraction of the whole.
  static constexpr double InputsRead = 0.25;

  /// \param filter whose properties count and whose progress it is.
  /// \param cache with the surface of the last execution.
  /// \param stage told what is being done, for the one who catches an exception.
  /// \param surface on input port 0.
  /// \param source on input port 1, or null.
  /// \param targets on input port 2, or null.
  FilterExecution(vtkGeodesicAlgorithm* filter, SurfaceCache& cache, Stage& stage,
    vtkDataObject* surface, vtkDataObject* source, vtkDataObject* targets);

  /// The source was drawn by hand and is meant to be put onto the surface: how far it was from
  /// there is then no news.
  void expectDrawnSource() { this->isSourceDrawn_ = true; }
  /// Reads the surface, and the source as SourceType has it, up to InputsRead.
  ///
  /// \throws geodesic::Error where one of them cannot be used; Aborted.
  void readInputs();
  /// Puts the points of the targets onto the surface, after readInputs(); those of the source where
  /// no targets are connected.
  ///
  /// \param end what is reached then, as a fraction of the whole.
  /// \throws geodesic::Error where they cannot be used; Aborted.
  Targets readTargets(double end);
  /// \param sourcesAreTargets whether the points of the source will do in their place.
  /// \throws InputError where no targets are connected.
  void requireTargets(bool sourcesAreTargets = false) const;

  vtkDataObject* surfaceInput() const { return this->surfaceInput_; }
  /// The blocks of the surface's input, as in PolyDataSurface::blocks().
  const std::vector<PolyDataBlock>& surfaceBlocks() const { return this->surfaceBlocks_; }
  const PolyDataSurface& surface() const { return this->cache_.surface(); }
  PolylineLocator& locator() const { return this->cache_.locator(); }
  const SourceCurves& sources() const { return this->sources_; }
  /// How many parts the source has: the cells of port 1 (points where there are no cells), then the
  /// loops of the boundary. SourceCurve::source of each curve is below.
  Id numberOfSources() const { return this->numberOfSources_; }
  /// From which of them on they are loops of the boundary.
  Id firstBoundarySource() const { return this->firstBoundarySource_; }

  /// What follows is this.
  void enter(Stage stage) { this->stage_ = stage; }
  /// A callback for a part of the work, from one fraction of the whole to another. It throws
  /// NotEnoughMemory where the system has hardly any left.
  ProgressCallback progressBetween(double begin, double end);
  /// Reports that the work has come so far.
  ///
  /// \throws Aborted
  void reach(double fraction);

  /// What the user should know.
  Notes& notes() { return this->notes_; }

private:
  void readSources();
  std::vector<SourceCurve> numberedBoundary(const TriangleMesh& mesh);
  void addBoundary(bool hasCurve);

  vtkGeodesicAlgorithm* filter_;
  SurfaceCache& cache_;
  Stage& stage_;
  MemoryWatch memory_;
  vtkDataObject* surfaceInput_;
  vtkDataObject* sourceInput_;
  vtkDataObject* targetsInput_;
  std::vector<PolyDataBlock> surfaceBlocks_;
  SourceCurves sources_;
  bool isSourceDrawn_ = false;
  Id numberOfSources_ = 0;
  Id firstBoundarySource_ = 0;
  Notes notes_;
};

}

#endif
