// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_GridSurface_h
#define geodesic_GridSurface_h

#include "PolyData/PolyDataBlocks.h"

class vtkUnstructuredGrid;

namespace geodesic
{

/// The surface that a grid of two-dimensional cells is: a vtkPolyData with the points and all
/// arrays of the grid, and with its cells in their order. Triangles, quads and polygons stay as
/// they are; if the grid has no other cells, it shares them. Strips become triangles, as do
/// quadratic and other curved cells, through all their points, as Extract Surface makes them. Lines
/// and vertices are only counted.
///
/// \param grid whose cells can be read, and have types.
/// \param name as messages call the grid.
/// \throws InputError that names the first cell that is three-dimensional, or of a type that VTK
///         does not know.
PolyDataBlock surfaceOfGrid(vtkUnstructuredGrid* grid, const PartName& name);

/// Adds the vertices, lines and flat faces of a grid to a block that has its points. Other cells
/// become lines without points, so that these keep their numbers.
PolyDataBlock sourceOfGrid(vtkUnstructuredGrid* grid, PolyDataBlock points);

}

#endif
