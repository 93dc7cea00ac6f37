// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_IsolineWriter_h
#define geodesic_IsolineWriter_h

#include "PolyData/PowerOfTwoScale.h"
#include "contours/Isolines.h"
#include "source/SourceCurve.h"

#include <vector>

class vtkPolyData;

namespace geodesic
{

/// Lines on a mesh, with their values in the user's units.
struct WrittenIsolines
{
  const TriangleMesh& mesh;
  const Isolines& isolines;
  const std::vector<double>& values;
};

/// Curves on a mesh, which may be another one.
struct WrittenCurves
{
  const TriangleMesh& mesh;
  std::vector<SourceCurve> curves;
};

/// Gives an output lines as polylines that share points, with the value of each as cell and point
/// array `GeodesicDistance`, the active scalars.
///
/// \param atZero the source, put out as the lines of the value 0: a polyline a curve, a vertex
///        where a curve is one point.
/// \param progress called now and then; returning false throws Aborted.
void writeIsolines(const WrittenIsolines& lines, const WrittenCurves& atZero,
  const PowerOfTwoScale& scale, vtkPolyData* output, const ProgressCallback& progress);

/// The same arrays without lines.
void addEmptyIsolineArrays(vtkPolyData* output);

}

#endif
