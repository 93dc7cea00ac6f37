// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FieldSolver_h
#define geodesic_FieldSolver_h

#include "PolyData/writing/SourceArrays.h"
#include "PolyData/writing/UnmeshedTriangles.h"
#include "Progress.h"
#include "field/DistanceField.h"
#include "front/Front.h"
#include "refinement/AdaptiveRefinement.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace geodesic
{

class FilterExecution;

/// What a field is asked for, in the engine's units.
struct FieldRequest
{
  /// 0: exact.
  double relativeError = 0.0;
  double maximumDistance = Infinity;
  SourceArrayChoice arrays;
  bool isRefined = false;
  /// Of refinement.
  double tolerance = 0.0;
  /// The largest number of cells of the refined surface; 0: no limit.
  std::uint64_t maximumCells = 0;
  bool areBordersRefined = false;

  bool isApproximate() const { return this->relativeError > 0.0; }
};

/// A field, and what refinement has made of it.
struct SolvedSurface
{
  std::optional<DistanceField> field;
  /// If the field is approximate, the exact one, where paths have to be followed: merged windows
  /// cannot tell where a path ends.
  std::optional<DistanceField> exact;
  RefinedSurface refined;

  const DistanceField& exactField() const { return this->exact ? *this->exact : *this->field; }
};

/// Solves and refines for vtkGeodesicDistanceField: the surface and the sources of an execution.
class FieldSolver
{
public:
  /// Where the field is solved, as a fraction of the whole execution, if arrays are asked for
  /// beside the distance; else at the end of solve().
  static constexpr double FieldDone = 0.85;

  /// \param end where solve() ends if no arrays are asked for, as a fraction of the whole.
  FieldSolver(FilterExecution& execution, const FieldRequest& request, double end);

  /// \throws geodesic::Error; Aborted
  SolvedSurface solve() const;

private:
  FrontOptions frontOptions(double begin, double end) const;
  SolvedSurface solveAndRefine() const;
  DistanceField solveForRefinement(double begin, const std::vector<std::uint8_t>& pinned) const;
  DistanceField solveExactly(double largestError, std::vector<std::uint8_t> faces) const;
  std::vector<std::uint8_t> findFacesAtBorders() const;
  std::vector<std::uint8_t> facesOf(const RefinedSurface& refined) const;
  RefinementOptions refinementOptions() const;
  void refine(SolvedSurface& solved) const;

  FilterExecution& execution_;
  const PolyDataSurface& surface_;
  const FieldRequest& request_;
  /// Where the field and its refinement are done, as a fraction of the whole.
  const double end_;
};

}

#endif
