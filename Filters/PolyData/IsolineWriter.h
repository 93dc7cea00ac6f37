// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_IsolineWriter_h
#define geodesic_IsolineWriter_h

#include "PolyData/PowerOfTwoScale.h"
#include "field/Isolines.h"
#include "source/SourceCurve.h"

#include <vector>

class vtkPolyData;

namespace geodesic
{

/// Gives an output lines as polylines that share points, with the value of each as cell and point
/// array `GeodesicDistance`, the active scalars.
///
/// \param values of the lines, in the user's units.
/// \param atZero the source, put out as the lines of the value 0: a polyline a curve, a vertex
/// where
///        a curve is one point.
/// \param progress called now and then; returning false throws Aborted.
void writeIsolines(const TriangleMesh& mesh, const PowerOfTwoScale& scale, const Isolines& isolines,
  const std::vector<double>& values, const std::vector<SourceCurve>& atZero, vtkPolyData* output,
  const ProgressCallback& progress);

}

#endif
