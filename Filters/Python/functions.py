# SPDX-License-Identifier: BSD-3-Clause
"""Exact geodesic distance on triangle meshes in one line each, for numpy arrays and vtkPolyData.

What the functions share:

- surface: a vtkPolyData (a PyVista mesh is one), or a pair (points, faces) of arrays, n x 3 numbers and
  m x 3 (or m x k) indices of points.
- source: a vtkPolyData with curves and points, the index of a point of the surface or several indices, the
  positions of points as an array k x 3, a curve() of positions, or None: the boundary of the surface.
  Points need not lie on the surface: each is put onto its closest point.
- barriers: one number a face; no path passes through faces where it is not 0.
- further keywords set properties of the filter, maximum_distance=2 for SetMaximumDistance(2). All lengths
  are in the units of the points.

A wrong input raises GeodesicError, which says what to do; what looks like a mistake is a warning.
"""

import re
import warnings

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataObject, vtkPolyData

from .vtkFiltersGeodesic import (vtkGeodesicContour, vtkGeodesicDistanceField, vtkGeodesicDistanceMatrix,
                                 vtkGeodesicPaths)


class GeodesicError(ValueError):
    """An input or a property with which there is no result."""


def distance(surface, source, **options):
    """The distance of every point of the surface to the source, as an array; infinite where no path leads."""
    return field(surface, source, **options)[options.get("distance_array_name", "GeodesicDistance")]


def field(surface, source, *, refine_mesh=False, **options):
    """The distances and what else is asked for, as a dictionary of arrays.

    "points" and "faces" are the surface, and the arrays at its points have the names that they have in VTK:
    "GeodesicDistance", and with generate_source_ids=True "SourceId", with generate_closest_points=True
    "ClosestSourcePoint", with generate_gradients=True "DistanceGradient", with
    generate_signed_distance=True "SignedGeodesicDistance", with generate_source_arc_length=True "SourceArcLength",
    with generate_source_angle=True "SourceAngle" and for each source the "SourceFrame" (three vectors), with
    generate_texture_coordinates=True "SourceTextureCoordinates". relative_error=0.001 makes it faster, and distances
    smaller by at most that fraction. With refine_mesh=True faces are split until the distance can be interpolated
    linearly; the points of the surface come first then.
    """
    if "relative_error" in options:
        options.setdefault("accuracy", vtkGeodesicDistanceField.APPROXIMATE)
    output = _run(vtkGeodesicDistanceField(), surface, source, refine_mesh=refine_mesh, **options)
    result = {"points": _points(output), "faces": _cells(output.GetPolys()), **_arrays(output.GetPointData())}
    if options.get("generate_source_angle"):
        result["SourceFrame"] = np.array(vtk_to_numpy(output.GetFieldData().GetArray("SourceFrame"))).reshape(-1, 3, 3)
    return result


def contour(surface, source, distances, **options):
    """The lines at the given distances from the source, as a dictionary of arrays.

    "lines" has the indices into "points" for each line, "GeodesicDistance" the distance of each line.
    """
    values = np.atleast_1d(distances)
    filter = vtkGeodesicContour()
    filter.SetNumberOfContours(len(values))
    for i, value in enumerate(values):
        filter.SetValue(i, value)
    return _lines(_run(filter, surface, source, **options))


def paths(surface, source, targets, **options):
    """The shortest path from each target (given as a source is) to the source, as a dictionary of arrays.

    "lines" has the indices into "points" for each path, "GeodesicDistance" its length, "TargetId" the number of
    its target, "SourceId" the part of the source that it ends on. generate_source_arc_length and
    generate_source_angle add arrays about this end, as for field().
    """
    return _lines(_run(vtkGeodesicPaths(), surface, source, targets, **options))


def matrix(surface, source, targets=None, **options):
    """The distances of each target (row) to each part of the source (column), each alone.

    Targets are given as a source is; without them they are the points of the source.
    """
    output = _run(vtkGeodesicDistanceMatrix(), surface, source, targets, **options)
    columns = [vtk_to_numpy(output.GetColumn(i)) for i in range(1, output.GetNumberOfColumns())]
    return np.column_stack(columns) if columns else np.empty((output.GetNumberOfRows(), 0))


def curve(positions, closed=False):
    """The polyline through positions, k x 3 numbers, as a source."""
    data = _point_set(positions)
    ids = np.arange(data.GetNumberOfPoints() + bool(closed)) % data.GetNumberOfPoints()
    lines = vtkCellArray()
    lines.InsertNextCell(len(ids), ids.tolist())
    data.SetLines(lines)
    return data


def _run(filter, surface, source, targets=None, *, barriers=None, **options):
    """The output of a filter, whose errors are raised."""
    data = _surface(surface)
    if barriers is not None:
        copy = vtkPolyData()
        copy.ShallowCopy(data)
        array = numpy_to_vtk(np.asarray(barriers, float), deep=True)
        array.SetName("Barriers")
        copy.GetCellData().AddArray(array)
        filter.SetBarrierArrayName("Barriers")
        data = copy
    filter.SetInputData(data)
    if source is None:
        filter.SetSourceType(filter.SURFACE_BOUNDARY)
    else:
        filter.SetSourceData(_positions(source, data))
    if targets is not None:
        filter.SetTargetsData(_positions(targets, data))
    for name, value in options.items():
        setter = getattr(filter, "Set" + "".join(word.capitalize() for word in name.split("_")), None)
        if not setter:
            raise TypeError(f"{filter.GetClassName()} has no property {name}.")
        setter(value)
    errors = _observe(filter, "ErrorEvent")
    told = _observe(filter, "WarningEvent")
    filter.Update()
    for text in told:
        warnings.warn(text, stacklevel=3)
    if errors:
        raise GeodesicError("\n".join(errors))
    return filter.GetOutputDataObject(0)


def _observe(filter, event):
    """The texts of a kind of messages, without where in VTK they come from."""
    texts = []

    def note(_caller, _event, text):
        texts.append(re.sub(r"^.*?\(0x[0-9a-f]+\): ", "", text, flags=re.DOTALL).strip())

    note.CallDataType = "string0"
    for sender in (filter, filter.GetExecutive()):
        sender.AddObserver(event, note)
    return texts


def _surface(surface):
    if isinstance(surface, vtkDataObject):
        return surface
    points, faces = surface
    data = _point_set(points)
    faces = np.atleast_2d(np.asarray(faces, np.int64))
    if faces.size and (faces.min() < 0 or faces.max() >= data.GetNumberOfPoints()):
        raise GeodesicError(f"Faces have indices from {faces.min()} to {faces.max()}, but there are "
                            f"{data.GetNumberOfPoints()} points.")
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(np.arange(len(faces) + 1, dtype=np.int64) * faces.shape[1], deep=True),
                  numpy_to_vtkIdTypeArray(faces.ravel(), deep=True))
    data.SetPolys(cells)
    return data


def _positions(where, surface):
    """A source, or targets: as it is, points of the surface by their indices, or positions."""
    if isinstance(where, vtkDataObject):
        return where
    where = np.asarray(where)
    if np.issubdtype(where.dtype, np.integer) and where.ndim < 2:
        count, ids = surface.GetNumberOfPoints(), np.atleast_1d(where)
        if ids.size and (ids.min() < 0 or ids.max() >= count):
            raise GeodesicError(f"The surface has {count} points, with indices from 0: there is no "
                                f"{ids.max() if ids.max() >= count else ids.min()}.")
        where = _points(surface)[ids]
    return _point_set(where)


def _point_set(positions):
    positions = np.atleast_2d(np.asarray(positions, float))
    if positions.ndim != 2 or positions.shape[1] != 3:
        raise GeodesicError(f"Points are given as an array of shape {positions.shape}: it has to be (number, 3).")
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(positions), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def _points(data):
    return np.array(vtk_to_numpy(data.GetPoints().GetData())) if data.GetNumberOfPoints() else np.empty((0, 3))


def _cells(cells):
    """Indices of points: an array where all cells have as many, else a list of arrays."""
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    ids = np.array(vtk_to_numpy(cells.GetConnectivityArray()))
    sizes = set(np.diff(offsets))
    if len(sizes) == 1:
        return ids.reshape(-1, sizes.pop())
    return [ids[begin:end] for begin, end in zip(offsets, offsets[1:])]


def _arrays(attributes):
    arrays = [attributes.GetArray(i) for i in range(attributes.GetNumberOfArrays())]
    return {array.GetName(): np.array(vtk_to_numpy(array)) for array in arrays if array}


def _lines(output):
    return {"points": _points(output), "lines": _cells(output.GetLines()), **_arrays(output.GetCellData())}
