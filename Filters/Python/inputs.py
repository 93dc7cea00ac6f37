# SPDX-License-Identifier: BSD-3-Clause
"""The forms in which surfaces and points on them are given, as VTK's data."""

from itertools import chain

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_BIQUADRATIC_QUAD, VTK_BIQUADRATIC_TRIANGLE, VTK_POLYGON, VTK_QUAD,
                                           VTK_QUADRATIC_QUAD, VTK_QUADRATIC_TRIANGLE, VTK_TRIANGLE, vtkCellArray,
                                           vtkCompositeDataSet, vtkDataObject, vtkPolyData, vtkUnstructuredGrid)

from .arrays import SURFACES, corners_of_faces, points_of
from .messages import GeodesicError, warn

FORM = "geodesicdistance.distance((points, faces), source)"
SOURCE = "The source"  # as messages call it
# Names of the arrays that are added to inputs.
BARRIERS, SOURCE_IDS = "barriers", "source_ids"
# The cells of meshio that are faces, with VTK's types, and how those begin that may lie beside them.
FACE_TYPES = {"triangle": VTK_TRIANGLE, "quad": VTK_QUAD, "polygon": VTK_POLYGON}
CURVED_TYPES = {"triangle6": VTK_QUADRATIC_TRIANGLE, "triangle7": VTK_BIQUADRATIC_TRIANGLE,
                "quad8": VTK_QUADRATIC_QUAD, "quad9": VTK_BIQUADRATIC_QUAD}
OTHER_TYPES = ("vertex", "line")
# The names that objects have for their points and faces.
POINTS, FACES = ("points", "vertices", "coordinates"), ("faces", "triangles", "cells")


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
    if _are_blocks(faces):
        return _with_blocks(data, faces)
    data.SetPolys(_cell_array(*_corners(*_faces(faces, data.GetNumberOfPoints()), data.GetNumberOfPoints())))
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
    ids = array_of(ids, "source_ids")
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


def faces_with(values, data, count, name):
    """The faces, as corners_of_faces(), if there is a value for each of them; None if not. count: of points."""
    faces = corners_of_faces(data) if values.ndim == 1 else None
    if faces is None or values.size != len(faces[0]):
        return None
    if values.size == count:
        what = "Give points by their indices, or append" if values.dtype == bool else "Append"
        raise GeodesicError(f"{name} has {count} values, but the surface has as many points as faces, so that nothing "
                            f"tells which are meant. {what} a point that no face uses to those of the surface.")
    return faces


def faces_as_source(ids, faces, data):
    """Some of the faces of a surface by their indices, as a data set."""
    sizes, corners = faces
    is_in = np.isin(np.arange(len(sizes)), ids)
    used, corners = np.unique(corners[np.repeat(is_in, sizes)], return_inverse=True)
    source = indexed_points(used, data)
    source.SetPolys(_cell_array(sizes[is_in], corners))
    return source


def masked_faces(where, data, count):
    """The region of a mask with a value for each face; None where it is none. count: of points."""
    where = array_of(where, SOURCE)
    faces = faces_with(where, data, count, SOURCE) if where.dtype == bool else None
    if faces is None:
        return None
    if not where.any():
        raise GeodesicError(f"{SOURCE} is empty: give at least one face.")
    return faces_as_source(np.flatnonzero(where), faces, data)


def labels_of_parts(labels):
    """Labels as an array of integers."""
    labels = array_of(labels, "labels")
    if labels.ndim != 1 or not np.issubdtype(labels.dtype, np.integer):
        raise GeodesicError(f"labels has one integer for each point or for each face; {labels.dtype} are given, in the "
                            f"shape {labels.shape}.")
    if not (labels >= 0).any():
        raise GeodesicError("labels has no region: all are negative, which stands for none.")
    return labels


def point_indices(where, count, name):
    """The indices of points of a surface that has so many, or None where these are no indices.

    where: indices, or a mask with True and False for each point. name: what they are, for messages. A mask of 0 and 1
    is refused: it would be the points 0 and 1.
    """
    if isinstance(where, vtkDataObject):
        return None
    where = array_of(where, name)
    if where.dtype == bool:
        if where.shape != (count,):
            raise GeodesicError(f"{name} is given by True and False, in the shape {where.shape}, but the surface has "
                                f"{count} points.")
        where = np.flatnonzero(where)
    if where.size == 0:
        raise GeodesicError(f"{name} is empty: give at least one point.")
    if where.ndim > 1 or not np.issubdtype(where.dtype, np.integer):
        return None
    if where.shape == (count,) and count > 2 and np.isin(where, (0, 1)).all():
        raise GeodesicError(f"{name} has a 0 or 1 for each of the {count} points: as indices these are the points 0 "
                            "and 1 only. If it is a mask, give it as True and False: mask.astype(bool).")
    return checked(np.atleast_1d(where), count, name)


def checked(ids, count, name, owner="the surface"):
    """Indices of points of an owner that has so many."""
    if ids.size and (ids.min() < 0 or ids.max() >= count):
        wrong = ids.max() if ids.max() >= count else ids.min()
        raise GeodesicError(f"{name}: {owner} has {count} points, with indices from 0; there is no {wrong}.")
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
        turned = " Give its transpose (.T) if its columns are the points." if positions.shape[:1] == (3,) else ""
        raise GeodesicError(f"{name}: the positions are given as an array of shape {positions.shape}; it has to be "
                            f"(number, 3). Indices are integers.{turned}")
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
    array = array_of(values, name)
    if array.size == 0 or array.dtype == bool or np.issubdtype(array.dtype, np.number):
        if not np.issubdtype(array.dtype, np.complexfloating):
            return array.astype(float)
    raise GeodesicError(f"{name}: {array.dtype} are given where numbers are needed.")


def array_of(values, name):
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
    """Those of an object that has them (trimesh, meshio, open3d, nilearn), of a pair, or of napari's triple."""
    points = [getattr(surface, name) for name in POINTS if hasattr(surface, name)]
    faces = [getattr(surface, name) for name in FACES if hasattr(surface, name)]
    if points and faces:
        return points[0], faces[0]
    if isinstance(surface, (tuple, list)) and (len(surface) == 2 or _are_with_values(surface)):
        return surface[:2]
    parts = getattr(surface, "parts", None)
    if isinstance(parts, dict) and parts:
        raise GeodesicError(f"A {type(surface).__name__} has several surfaces. Give one of its parts: "
                            f".parts[{next(iter(parts))!r}].")
    raise GeodesicError(f"A {type(surface).__name__} is no surface. Surfaces are a vtkPolyData, points and faces as a "
                        f"pair, as in {FORM}, or an object that has points (or vertices, coordinates) and faces (or "
                        "triangles).")


def _are_with_values(surface):
    """Whether these are points, faces, and a value for each point, or a row of them for each time."""
    if len(surface) != 3:
        return False
    points, values = _shape(surface[0]), _shape(surface[2])
    return len(points) == 2 and values[-1:] == points[:1]


def _shape(values):
    """The shape of an array or of nested lists; () if there is none."""
    try:
        return np.shape(values)
    except ValueError:
        return ()


def _corners(sizes, ids, count):
    """The number of corners of each face, and the corners of all, of points that are so many."""
    if (sizes < 3).any():
        raise GeodesicError(f"Face {np.argmax(sizes < 3)} has {sizes[np.argmax(sizes < 3)]} corners: a face has three "
                            "or more.")
    if ids.size and (ids.min() < 0 or ids.max() >= count):
        raise GeodesicError(f"Faces have indices from {ids.min()} to {ids.max()}, but there are {count} points.")
    return sizes, ids


def _faces(faces, count):
    """The sizes and corners of faces given by VTK's flat list, or by rows."""
    if not isinstance(faces, (list, tuple)) and getattr(faces, "dtype", None) != object:
        _refuse_columns(_integers(faces))
    sizes, ids = _rows(faces)
    return _of_flat_list(ids) if sizes is None else _without_counts(sizes, ids, count)


def _refuse_columns(faces):
    """Refuses an array whose three rows have the corners of triangles, one in each column.

    Its rows may be polygons, too: they are if they hang together, by two edges that are shared in opposite directions,
    and share more than the columns do. Three polygons of which nothing tells that are taken as a list of rows only.
    """
    if faces.ndim != 2 or faces.shape[0] != 3 or faces.shape[1] in (0, 3):
        return
    triangles, polygons = _shared_edges(faces.T), _shared_edges(faces)
    if triangles is None or (polygons is not None and polygons > max(triangles, 1)):
        return
    count = faces.shape[1]
    rows = f" Three faces of {count} corners are given as a list of rows: faces.tolist()." if count > 3 else ""
    raise GeodesicError(f"Faces are given as an array of shape {faces.shape}, whose columns may be triangles: give a "
                        f"row for each, faces.T.{rows}")


def _shared_edges(faces):
    """How many edges two faces share; -1 where one has the same direction twice, None where these are no faces."""
    corners = np.sort(faces, axis=1)
    if faces.shape[1] < 3 or (corners[:, 1:] == corners[:, :-1]).any():
        return None
    edges = np.column_stack((faces.ravel(), np.roll(faces, -1, axis=1).ravel()))
    if len(np.unique(edges, axis=0)) < len(edges):
        return -1
    return len(edges) - len(np.unique(np.sort(edges, axis=1), axis=0))


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


def _are_blocks(faces):
    """Whether these are meshio's blocks of cells."""
    return isinstance(faces, (list, tuple)) and any(isinstance(getattr(block, "type", None), str) for block in faces)


def _with_blocks(data, blocks):
    """A data set of points with those cells of meshio's blocks that are faces: a grid where some are curved."""
    types, sizes, ids, others = [], [np.empty(0, int)], [np.empty(0, int)], {}
    for block in blocks:
        kind = {**FACE_TYPES, **CURVED_TYPES}.get(block.type)
        if kind is None and not block.type.startswith(OTHER_TYPES):
            others[block.type] = others.get(block.type, 0) + len(block.data)
        elif kind is not None and len(block.data):
            own_sizes, own_ids = _rows(block.data)
            types += [kind] * len(own_sizes)
            sizes.append(own_sizes)
            ids.append(own_ids)
    _note_left_out(others, len(types))
    cells = _cell_array(*_corners(np.concatenate(sizes), np.concatenate(ids), data.GetNumberOfPoints()))
    if not set(types) & set(CURVED_TYPES.values()):
        data.SetPolys(cells)
        return data
    grid = vtkUnstructuredGrid()
    grid.SetPoints(data.GetPoints())
    grid.SetCells(numpy_to_vtk(np.array(types, np.uint8), deep=True, array_type=VTK_UNSIGNED_CHAR), cells)
    return grid


def _note_left_out(others, count):
    """Says which cells are not taken. others: how many there are of each type. count: of faces."""
    faces = ", ".join((*FACE_TYPES, *CURVED_TYPES))
    for name, number in others.items():
        if name.startswith(("triangle", "quad")) or (number and not count):
            raise GeodesicError(f"The mesh has cells of type {name}. A surface has cells of the types {faces}: make "
                                "these, for volumes by vtkDataSetSurfaceFilter (in PyVista extract_surface()).")
    left_out = " and ".join(f"{number} of type {name}" for name, number in others.items() if number)
    if left_out:
        warn(f"Of the mesh's cells {left_out} are left out: the surface has its {count} faces alone.")


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
    array = array_of(values, "Faces")
    if array.size and not np.issubdtype(array.dtype, np.integer):
        raise GeodesicError(f"Faces are given as {array.dtype}: indices are integers (faces.astype(int)).")
    return array.astype(np.int64)


def _cell_array(sizes, ids):
    cells = vtkCellArray()
    offsets = np.concatenate(([0], np.cumsum(sizes))).astype(np.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_to_vtkIdTypeArray(np.ascontiguousarray(ids, np.int64), deep=True))
    return cells
