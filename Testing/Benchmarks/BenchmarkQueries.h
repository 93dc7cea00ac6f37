// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchmarkQueries_h
#define BenchmarkQueries_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <vector>

class vtkPolyData;

/// What a filter took that had read its surface before: an Update() measured so is a solve, what is
/// made from it, and little else.
struct QueryRun
{
  double seconds = 0.0;
  /// The largest resident size meanwhile, and what the process had before: the meshes, the
  /// structure of the surface, and the filter's last output.
  std::uint64_t peakBytes = 0;
  std::uint64_t loadedBytes = 0;
  vtkIdType outputPoints = 0;
  vtkIdType outputCells = 0;
};

/// A surface with its field, for choosing what to ask.
struct QuerySubject
{
  vtkPolyData* surface = nullptr;
  /// Null: the boundary.
  vtkPolyData* source = nullptr;
  /// Of the surface's points, from the source.
  std::vector<double> distances;
  double largestDistance = 0.0;
};

/// Random points in faces that are wholly within a distance of the source, of which the first is
/// the farthest. The same in each run.
///
/// \param seed other numbers give other points.
/// \throws std::runtime_error where no face is.
vtkSmartPointer<vtkPolyData> randomPoints(
  const QuerySubject& subject, double distance, int count, unsigned int seed);

/// \name Each executes a vtkGeodesic* filter twice and measures the second time.
/// \throws std::runtime_error where the filter fails.
///@{
/// vtkGeodesicDistanceField, not refined.
///
/// \param arrays with all the arrays that it can generate.
QueryRun runField(const QuerySubject& subject, bool arrays);
/// vtkGeodesicPaths.
QueryRun runPaths(const QuerySubject& subject, vtkPolyData* targets);
/// vtkGeodesicContour with values at equal steps between 0 and the largest distance.
///
/// \param chordTolerance as a fraction of the diagonal; 0: the filter's own.
QueryRun runContour(const QuerySubject& subject, int values, double chordTolerance);
/// The same lines by vtkContourFilter from a field refined to a tolerance.
///
/// \param refine as a fraction of the diagonal, positive.
QueryRun runRefinedContour(const QuerySubject& subject, int values, double refine);
/// vtkGeodesicDistanceMatrix.
QueryRun runMatrix(vtkPolyData* surface, vtkPolyData* sources, vtkPolyData* targets);
///@}

#endif
