// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CellArrays_h
#define geodesic_CellArrays_h

#include "vtkType.h"

#include <string>

class vtkCellArray;
class vtkPolyData;

namespace geodesic
{

/// Makes sure that the cells of a cell array can be read: that there are offsets, and that none
/// decreases or points past the end of the point ids. Neither vtkCellArray nor VTK's readers check
/// that. What the ids are is left to those who read them.
///
/// \param kind what the cells are: "polygons".
/// \param firstCell number of the first of these cells in the data set.
/// \param name as messages call the data set.
/// \throws InputError that names the first cell that cannot be read.
void requireReadable(
  vtkCellArray* cells, const std::string& kind, vtkIdType firstCell, const std::string& name);

/// The same for all four kinds of cells of a vtkPolyData.
void requireReadable(vtkPolyData* data, const std::string& name);

}

#endif
