// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchmarkFilter_h
#define BenchmarkFilter_h

#include "vtkType.h"

class vtkPolyData;

struct FilterRun
{
  /// Of Update().
  double seconds = 0.0;
  vtkIdType outputCells = 0;
};

/// Executes a fresh vtkGeodesicDistanceField.
///
/// \param source null: the boundary.
/// \param relativeError 0: exact.
/// \param refine the refinement's relative tolerance; 0: not refined.
/// \throws std::runtime_error where the filter fails.
FilterRun runFilter(vtkPolyData* surface, vtkPolyData* source, double relativeError, double refine);

/// The same with a MaximumDistance next to nothing, so that what takes time is the structure of the
/// mesh and the output. Not refined.
///
/// \throws std::runtime_error where the filter fails.
FilterRun runFilterWithoutReach(vtkPolyData* surface, vtkPolyData* source);

#endif
