# SPDX-License-Identifier: BSD-3-Clause
"""The forms in which surfaces and points on them are given, as VTK's data."""

from itertools import chain

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkCompositeDataSet, vtkDataObject, vtkPolyData

from .arrays import SURFACES, points_of
from .messages import GeodesicError

FORM = "geodesicdistance.distance((points, faces), source)"
# Names of the arrays that are added to inputs.
BARRIERS, SOURCE_IDS = "barriers", "source_ids"
# The cells of meshio that are faces, and those that lie beside them in its files.
FACE_TYPES, OTHER_TYPES = ("triangle", "quad", "polygon"), ("vertex", "line")


def surface_data(surface):
    """A surface in one of its forms as a data set."""
    surface = unwrapped(surface)
    if isinstance(surface, (*SURFACES, vtkCompositeDataSet)):
        return surface
    if isinstance(surface, vtkDataObject):
        raise GeodesicError(f"A {surface.GetClassName()} is no surface: vtkDataSetSurfaceFilter (in PyVista "
                            "extract_surface()) makes one of it.")
    points, faces = _points_and_faces(surface)
    data = point_set(points, "The points of the surface")
    data.SetPolys(_cell_array(*_corners(faces, data.GetNumberOfPoints())))
    return data


def unwrapped(data):
    """What VTK's dataset_adapter has wrapped, as in ParaView's Programmable Filter."""
    return getattr(data, "VTKObject", data)


def with_barriers(surface, barriers):
    """A shallow copy of a surface with the cell array BARRIERS."""
    copy = _shallow_copy(surface, "Barriers")
    array = numpy_to_vtk(numbers(barriers, "Barriers"), deep=True)
    array.SetName(BARRIERS)
    copy.GetCellData().AddArray(array)
    return copy


def with_ids(source, ids):
    """A shallow copy of a source with the array SOURCE_IDS, at its cells or at its points, as many as there are."""
    ids = _array(ids, "source_ids")
    if source is None or ids.ndim != 1 or not np.issubdtype(ids.dtype, np.integer):
        raise GeodesicError("source_ids has an integer for each part of the source.")
    copy = _shallow_copy(source, "source_ids")
    counts = (copy.GetCellData(), copy.GetNumberOfCells()), (copy.GetPointData(), copy.GetNumberOfPoints())
    if ids.size not in (counts[0][1], counts[1][1]):
        raise GeodesicError(f"source_ids has {ids.size} integers, but the source has {counts[0][1]} cells and "
                            f"{counts[1][1]} points.")
    array = numpy_to_vtkIdTypeArray(ids.astype(np.int64), deep=True)
    array.SetName(SOURCE_IDS)
    for attributes, count in counts:
        if count == ids.size:
            attributes.AddArray(array)
    return copy


def _shallow_copy(data, what):
    if isinstance(data, vtkCompositeDataSet):
        raise GeodesicError(f"{what}: blocks have no array in common; give the name of an array that they have.")
    copy = data.NewInstance()
    copy.ShallowCopy(data)
    return copy


def point_indices(where, count, name):
    """The indices of points of a surface that has so many, or None where these are no indices.

    where: indices, or a mask with True and False for each point. name: what they are, for messages.
    """
    if isinstance(where, vtkDataObject):
        return None
    where = _array(where, name)
    if where.dtype == bool:
        if where.shape != (count,):
            raise GeodesicError(f"{name} is given by True and False, in the shape {where.shape}, but the surface has "
                                f"{count} points.")
        where = np.flatnonzero(where)
    if where.size == 0:
        raise GeodesicError(f"{name} is empty: give at least one point.")
    if where.ndim > 1 or not np.issubdtype(where.dtype, np.integer):
        return None
    return checked(np.atleast_1d(where), count, name)


def index_pairs(pairs, count):
    """Pairs of indices of points of a surface that has so many."""
    pairs = _array(pairs, "pairs")
    if pairs.size == 0:
        return np.empty((0, 2), np.int64)
    if pairs.ndim != 2 or pairs.shape[1] != 2 or not np.issubdtype(pairs.dtype, np.integer):
        raise GeodesicError(f"pairs has the shape {pairs.shape} and holds {pairs.dtype}: it has rows of two indices of "
                            "points.")
    return checked(pairs, count, "pairs")


def checked(ids, count, name):
    """Indices of points of a surface that has so many."""
    if ids.size and (ids.min() < 0 or ids.max() >= count):
        wrong = ids.max() if ids.max() >= count else ids.min()
        raise GeodesicError(f"{name}: the surface has {count} points, with indices from 0; there is no {wrong}.")
    return ids.astype(np.int64)


def indexed_points(ids, data):
    """Points of a surface by their indices. These go with them: several points may be at one place."""
    points = point_set(points_of(data)[ids], "The points of the surface")
    if not isinstance(data, vtkCompositeDataSet):  # whose blocks have indices of their own
        array = numpy_to_vtkIdTypeArray(ids, deep=True)
        array.SetName("vtkOriginalPointIds")
        points.GetPointData().AddArray(array)
    return points


def point_set(positions, name):
    """Positions as a vtkPolyData of points alone. name: what they are, for messages."""
    positions = numbers(positions, name)
    if positions.ndim == 1 and positions.size == 3:
        positions = positions[None]
    if positions.ndim != 2 or positions.shape[1] != 3:
        raise GeodesicError(f"{name}: the positions are given as an array of shape {positions.shape}; it has to be "
                            "(number, 3). Indices are integers.")
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(positions), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def curve(positions, closed=False):
    """The polyline through positions, k x 3 numbers, as a source."""
    data = point_set(positions, "The curve")
    count = data.GetNumberOfPoints()
    if not count:
        raise GeodesicError("The curve is empty: give at least one point.")
    data.SetLines(_cell_array(np.array([count + bool(closed)]), np.arange(count + bool(closed)) % count))
    return data


def numbers(values, name):
    """An array of real numbers."""
    array = _array(values, name)
    if array.size == 0 or array.dtype == bool or np.issubdtype(array.dtype, np.number):
        if not np.issubdtype(array.dtype, np.complexfloating):
            return array.astype(float)
    raise GeodesicError(f"{name}: {array.dtype} are given where numbers are needed.")


def _array(values, name):
    """What is given as an array, a list, or columns of pandas."""
    if isinstance(values, (set, frozenset, dict, str, bytes)):
        raise GeodesicError(f"{name} is given as a {type(values).__name__}. It is an index of a point or several, or "
                            "positions (number x 3), as a list or an array.")
    if np.ma.is_masked(values):
        raise GeodesicError(f"{name}: values are masked. Give the others alone.")
    try:
        array = np.asarray(values)
        if array.dtype == object:  # a pandas column of Int64
            array = np.asarray(array.tolist())
    except ValueError as error:
        raise GeodesicError(f"{name}: the rows differ in length.") from error
    if array.dtype == object:
        raise GeodesicError(f"{name} is given as {type(values).__name__}, which is not an array of numbers.")
    return array


def _points_and_faces(surface):
    """Those of a pair, or of an object that has them (trimesh, meshio, open3d)."""
    if isinstance(surface, (tuple, list)) and len(surface) == 2:
        return surface
    points = [getattr(surface, name) for name in ("points", "vertices") if hasattr(surface, name)]
    faces = [getattr(surface, name) for name in ("faces", "triangles", "cells") if hasattr(surface, name)]
    if points and faces:
        return points[0], faces[0]
    raise GeodesicError(f"A {type(surface).__name__} is no surface. Surfaces are a vtkPolyData, points and faces as a "
                        f"pair, as in {FORM}, or an object that has points (or vertices) and faces (or triangles).")


def _corners(faces, count):
    """The number of corners of each face, and the corners of all, of points that are so many."""
    sizes, ids = _faces(faces, count)
    if (sizes < 3).any():
        raise GeodesicError(f"Face {np.argmax(sizes < 3)} has {sizes[np.argmax(sizes < 3)]} corners: a face has three "
                            "or more.")
    if ids.size and (ids.min() < 0 or ids.max() >= count):
        raise GeodesicError(f"Faces have indices from {ids.min()} to {ids.max()}, but there are {count} points.")
    return sizes, ids


def _faces(faces, count):
    """As _corners(), of the blocks of meshio, of VTK's flat list, or of rows."""
    if isinstance(faces, (list, tuple)) and any(isinstance(getattr(block, "type", None), str) for block in faces):
        return _of_blocks(faces)
    sizes, ids = _rows(faces)
    return _of_flat_list(ids) if sizes is None else _without_counts(sizes, ids, count)


def _rows(faces):
    """Sizes and entries of the rows of an array or of a list; no sizes where there are no rows."""
    faces = faces.tolist() if getattr(faces, "dtype", None) == object else faces
    if isinstance(faces, (list, tuple)) and all(hasattr(row, "__len__") for row in faces):
        sizes = np.fromiter(map(len, faces), np.int64)
        if len(set(sizes)) > 1:
            return sizes, _integers(list(chain.from_iterable(faces)))
    array = _integers(faces)
    if array.ndim > 2:
        raise GeodesicError(f"Faces are given as an array of shape {array.shape}: it has to be (number, corners).")
    return (np.full(array.shape[0], array.shape[1]) if array.ndim == 2 else None), array.ravel()


def _of_blocks(blocks):
    sizes, ids = [np.empty(0, int)], [np.empty(0, int)]
    for block in blocks:
        if block.type in FACE_TYPES:
            own_sizes, own_ids = _rows(block.data)
            if own_sizes is not None:
                sizes.append(own_sizes)
                ids.append(own_ids)
        elif block.type not in OTHER_TYPES:
            raise GeodesicError(f"The mesh has cells of type {block.type}. A surface has cells of the types "
                                f"{', '.join(FACE_TYPES)}.")
    return np.concatenate(sizes), np.concatenate(ids)


def _of_flat_list(ids):
    """Of the numbers of corners with the corners behind them, as VTK has them."""
    values, sizes = ids.tolist(), []
    at = 0
    while at < len(values) and values[at] > 2:
        sizes.append(values[at])
        at += values[at] + 1
    if at != len(values):
        raise GeodesicError("Faces are given as a flat list, which is not one of VTK's: that has before each face's "
                            "corners their number. Give a row for each face, such as faces.reshape(-1, 3).")
    sizes = np.array(sizes, np.int64)
    return sizes, np.delete(ids, np.cumsum(sizes + 1) - sizes - 1)


def _without_counts(sizes, ids, count):
    """Takes the numbers of corners away that rows begin with where they come from VTK's list.

    They do where each row begins with the number of the others and one row at least cannot be a face, as it
    names a point twice or one that does not exist. Where all of them could be faces around one point,
    nothing tells which is meant.
    """
    starts = np.cumsum(sizes) - sizes
    if not len(sizes) or sizes.min() < 4 or (ids[starts] != sizes - 1).any():
        return sizes, ids
    if ids[starts].max() < count and (ids == np.repeat(ids[starts], sizes)).sum() == len(sizes):
        raise GeodesicError(
            "Each row of faces begins with the number of its other entries: these may be VTK's lists with counts, or "
            "faces that all begin at one point. Give faces[:, 1:] where they are counts, numpy.roll(faces, 1, axis=1) "
            "where they are corners.")
    return sizes - 1, np.delete(ids, starts)


def _integers(values):
    array = _array(values, "Faces")
    if array.size and not np.issubdtype(array.dtype, np.integer):
        raise GeodesicError(f"Faces are given as {array.dtype}: indices are integers (faces.astype(int)).")
    return array.astype(np.int64)


def _cell_array(sizes, ids):
    cells = vtkCellArray()
    offsets = np.concatenate(([0], np.cumsum(sizes))).astype(np.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_to_vtkIdTypeArray(np.ascontiguousarray(ids, np.int64), deep=True))
    return cells
