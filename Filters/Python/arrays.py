# SPDX-License-Identifier: BSD-3-Clause
"""What VTK's data sets hold, as numpy arrays. All blocks of a composite data set count, one after another."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (VTK_BEZIER_CURVE, VTK_CUBIC_LINE, VTK_EMPTY_CELL, VTK_LAGRANGE_CURVE,
                                           VTK_LINE, VTK_POLY_LINE, VTK_POLY_VERTEX, VTK_POLYGON, VTK_QUAD,
                                           VTK_QUADRATIC_EDGE, VTK_TRIANGLE, VTK_VERTEX, vtkCompositeDataSet,
                                           vtkPolyData, vtkUnstructuredGrid)

SURFACES = (vtkPolyData, vtkUnstructuredGrid)
# The cells of a grid that lie beside faces.
NO_FACES = (VTK_EMPTY_CELL, VTK_VERTEX, VTK_POLY_VERTEX, VTK_LINE, VTK_POLY_LINE, VTK_QUADRATIC_EDGE, VTK_CUBIC_LINE,
            VTK_LAGRANGE_CURVE, VTK_BEZIER_CURVE)
FLAT_FACES = (VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON)


def blocks_of(data):
    """The surfaces in a data set that may be composite."""
    if not isinstance(data, vtkCompositeDataSet):
        return [data]
    blocks, iterator = [], data.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        blocks.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return [block for block in blocks if isinstance(block, SURFACES)]


def points_of(data):
    """The coordinates of the points: VTK's own where there are not several blocks."""
    parts = [vtk_to_numpy(block.GetPoints().GetData()) for block in blocks_of(data) if block.GetNumberOfPoints()]
    return parts[0] if len(parts) == 1 else np.concatenate([np.empty((0, 3)), *parts])


def faces_of(data):
    """Indices of points: an array where all faces have as many, else a list of arrays."""
    return _rows(*_cells(data, vtkPolyData.GetPolys))


def corners_of_faces(data):
    """The number of corners of each face, and the corners of all; None where some are curved or in strips."""
    for block in blocks_of(data):
        if isinstance(block, vtkPolyData):
            if block.GetNumberOfStrips():
                return None
        elif any(block.GetCellType(i) not in FLAT_FACES for i in range(block.GetNumberOfCells())):
            return None
    return _cells(data, lambda block: block.GetPolys() if isinstance(block, vtkPolyData) else block.GetCells())


def lines_of(data):
    """Indices of points as faces_of(), and the arrays of the lines alone, by their names."""
    vertices = data.GetNumberOfVerts()  # come first in cell data
    own = slice(vertices, vertices + data.GetNumberOfLines())
    return (_rows(*_cells(data, vtkPolyData.GetLines)),
            {name: array[own] for name, array in arrays_of([data.GetCellData()]).items()})


def arrays_of(attributes):
    """The arrays that all blocks' point or cell data have, by their names."""
    names = [[data.GetArrayName(i) for i in range(data.GetNumberOfArrays()) if data.GetArray(i)]
             for data in attributes]
    common = [name for name in (names[0] if names else []) if all(name in others for others in names)]
    return {name: np.concatenate([vtk_to_numpy(data.GetArray(name)) for data in attributes]) for name in common}


def point_array(data, name):
    """One array at the points."""
    return np.concatenate([vtk_to_numpy(block.GetPointData().GetArray(name)) for block in blocks_of(data)])


def used_points(data):
    """Whether a face uses the point, for each one."""
    used = [np.zeros(block.GetNumberOfPoints(), bool) for block in blocks_of(data)]
    for block, flags in zip(blocks_of(data), used):
        ids = _corners(block)
        flags[ids[(ids >= 0) & (ids < len(flags))]] = True
    return np.concatenate([np.empty(0, bool), *used])


def column_of(table, name):
    """A column in the memory of the table."""
    return vtk_to_numpy(table.GetColumnByName(name))


def columns_of(table):
    """The distances in a table, one row a target."""
    columns = [vtk_to_numpy(table.GetColumn(i)) for i in range(1, table.GetNumberOfColumns())]
    return np.column_stack(columns) if columns else np.empty((table.GetNumberOfRows(), 0))


def with_infinite(table, are_there, axis):
    """A table with rows or columns of infinity where those of are_there are not in it."""
    return np.insert(table, np.cumsum(are_there)[~are_there], np.inf, axis=axis)


def lines_with_points(output):
    """Lines and their points as a dictionary, with the arrays of the lines."""
    lines, of_lines = lines_of(output)
    return {"points": np.array(points_of(output)), "lines": lines, **of_lines}


def frames_of(output):
    """The frames of the sources where angles are measured in them."""
    array = output.GetFieldData().GetArray("SourceFrame")
    return {"SourceFrame": np.array(vtk_to_numpy(array)).reshape(-1, 3, 3)} if array else {}


def _corners(block):
    """The points that faces name, also those that do not exist."""
    if isinstance(block, vtkPolyData):
        return np.concatenate([_points(cells) for cells in (block.GetPolys(), block.GetStrips())])
    are_faces = ~np.isin([block.GetCellType(i) for i in range(block.GetNumberOfCells())], NO_FACES)
    ids = _points(block.GetCells())
    return ids if are_faces.all() else ids[np.repeat(are_faces, _sizes(block.GetCells()))]


def _cells(data, cells_of):
    """The number of points of each cell, and the points of all."""
    sizes, points, start = [np.empty(0, int)], [np.empty(0, int)], 0
    for block in blocks_of(data):
        sizes.append(_sizes(cells_of(block)))
        points.append(start + _points(cells_of(block)))
        start += block.GetNumberOfPoints()
    return np.concatenate(sizes), np.concatenate(points)


def _sizes(cells):
    """The number of points of each cell of a vtkCellArray."""
    return np.diff(vtk_to_numpy(cells.GetOffsetsArray())) if cells.GetNumberOfCells() else np.empty(0, int)


def _points(cells):
    """The points of all cells of a vtkCellArray."""
    return vtk_to_numpy(cells.GetConnectivityArray()) if cells.GetNumberOfCells() else np.empty(0, int)


def _rows(sizes, ids):
    if len(sizes) and (sizes == sizes[0]).all():
        return ids.reshape(-1, sizes[0])
    return np.split(ids, np.cumsum(sizes)[:-1]) if len(sizes) else []
