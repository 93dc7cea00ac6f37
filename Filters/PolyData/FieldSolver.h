// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FieldSolver_h
#define geodesic_FieldSolver_h

#include "PolyData/writing/SourceArrays.h"
#include "field/DistanceField.h"
#include "refinement/RefinedMesh.h"

#include <cstdint>
#include <optional>

namespace geodesic
{

class FilterExecution;
struct Inputs;

/// What a field is asked for, in the engine's units.
struct FieldRequest
{
  /// 0: exact.
  double relativeError = 0.0;
  double maximumDistance = Infinity;
  SourceArrayChoice arrays;
  bool isRefined = false;
  /// The tolerance of refinement.
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
  /// With all triangles of the surface (addUnmeshedTriangles()).
  RefinedMesh refined;

  const DistanceField& exactField() const { return this->exact ? *this->exact : *this->field; }
};

/// Solves and refines for vtkGeodesicDistanceField.
///
/// \throws geodesic::Error; Aborted
SolvedSurface solveField(
  const Inputs& inputs, const FieldRequest& request, FilterExecution& execution);

}

#endif
