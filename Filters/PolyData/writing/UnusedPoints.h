// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_UnusedPoints_h
#define geodesic_UnusedPoints_h

class vtkPolyData;

namespace geodesic
{

/// Leaves out of a data set of polygons the points that none of them uses; the others keep their
/// order and their data. Arrays are replaced, not changed: other data sets may have them, too.
///
/// \throws NotEnoughMemory
void removeUnusedPoints(vtkPolyData* data);

}

#endif
