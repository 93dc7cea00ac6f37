# SPDX-License-Identifier: BSD-3-Clause
"""A surface that is asked several times."""

import functools
import inspect
import os
import threading
from contextlib import contextmanager

import numpy as np
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkDataObject

from . import arrays, inputs, pickling
from .messages import GeodesicError, property_name, run, warn
from .pairs import Places, few_sources, index_pairs
from .vtkFiltersGeodesic import (vtkGeodesicContour, vtkGeodesicDistanceField, vtkGeodesicDistanceMatrix,
                                 vtkGeodesicFarthestPoints, vtkGeodesicPaths)


# VTK's number of threads, its observers and where its messages go are of the whole process, so one call runs at a time.
# Threads that wait for it do not hold Python's own lock.
LOCK = threading.RLock()
if hasattr(os, "register_at_fork"):  # else a process forked during a call waits forever for the end of it
    os.register_at_fork(before=LOCK.acquire, after_in_parent=LOCK.release, after_in_child=LOCK.release)


def _one_at_a_time(function):
    """Holds LOCK during a call. What it returns must have no memory of VTK's: the next call writes there."""
    @functools.wraps(function)
    def alone(*arguments, **options):
        with LOCK:
            return function(*arguments, **options)

    return alone


class Surface:
    """A surface that is asked several times: its structure is kept, and only the first call takes the time to make it.

    surface: as for the functions of this package; of arrays a copy is kept. barriers, merge_coincident_points,
    merge_tolerance, threads: see help(geodesicdistance). Each method is the function of its name without these.

    Several threads may ask at once: their calls wait for each other, and each uses VTK's threads. For calls side by
    side use processes: a Surface can be pickled, and its copy has a copy of the data and makes the structure anew.
    """

    # Where a method begins, locals() are its arguments: they are handed on by their names.

    @_one_at_a_time
    def __init__(self, surface, *, barriers=None, merge_coincident_points=True, merge_tolerance=0, threads=None):
        self._data = inputs.surface_data(surface)
        self._properties = {"merge_coincident_points": merge_coincident_points, "merge_tolerance": merge_tolerance,
                            "barrier_array_name": None}
        if isinstance(barriers, str):
            self._properties["barrier_array_name"] = barriers
        elif barriers is not None:
            self._data = inputs.with_barriers(self._data, barriers)
            self._properties["barrier_array_name"] = inputs.BARRIERS
        self._threads = threads
        self._forget()

    @_one_at_a_time
    def __getstate__(self):
        return {"data": pickling.bytes_of(self._data), "properties": self._properties, "threads": self._threads}

    def __setstate__(self, state):
        self._data = pickling.data_of(*state["data"])
        self._properties, self._threads = dict(state["properties"]), state["threads"]
        self._forget()

    def _forget(self):
        """Has no filters yet."""
        self._filters = {}
        self._used = None, None  # which points faces use, and at which state of the data

    @_one_at_a_time
    def distance(self, source, *, maximum_distance=0, accuracy=None, relative_error=None, unreached_value=0,
                 custom_unreached_value=-1, boundary=False):
        """The distance of every point of the surface to the source, as an array; infinite where no path leads.

        The arguments are those of field().
        """
        output = Surface._solve(**{**FIELD_DEFAULTS, **locals()})
        return arrays.point_array(output, "GeodesicDistance")

    @_one_at_a_time
    def field(self, source, *, maximum_distance=0, accuracy=None, relative_error=None, refine_mesh=False,
              refinement_tolerance=0.001, tolerance_is_absolute=False, absolute_refinement_tolerance=1,
              maximum_number_of_cells=50_000_000, refine_source_borders=False, unreached_value=0,
              custom_unreached_value=-1, remove_unused_points=False, distance_array_name="GeodesicDistance",
              generate_source_ids=False, generate_closest_points=False, generate_gradients=False,
              generate_signed_distance=False, generate_source_arc_length=False, generate_source_angle=False,
              generate_texture_coordinates=False, texture_scale=0, texture_repeats=True, output_points_precision=2,
              boundary=False, join_lines=True, source_ids=None):
        """The distances and what else is asked for, as a dictionary of arrays.

        "points" and "faces" are the surface, and the arrays at its points have the names that they have in VTK:
        "GeodesicDistance", and with generate_source_ids=True "SourceId", with generate_closest_points=True
        "ClosestSourcePoint", with generate_gradients=True "DistanceGradient", with generate_signed_distance=True
        "SignedGeodesicDistance", with generate_source_arc_length=True "SourceArcLength", with
        generate_source_angle=True "SourceAngle" and for each source the "SourceFrame" (three vectors), with
        generate_texture_coordinates=True "SourceTextureCoordinates". relative_error=0.001 makes it faster, and
        distances smaller by at most that fraction. With refine_mesh=True faces are split until the distance can be
        interpolated linearly; the points of the surface come first then.
        """
        output = Surface._solve(**locals())
        at_points = arrays.arrays_of([block.GetPointData() for block in arrays.blocks_of(output)])
        return {**at_points, **arrays.frames_of(output),
                "points": np.array(arrays.points_of(output)), "faces": arrays.faces_of(output)}

    @_one_at_a_time
    def contour(self, source, distances, *, chord_tolerance=0.0001, tolerance_is_absolute=False,
                absolute_chord_tolerance=1, signed_distances=False, boundary=False, join_lines=True, source_ids=None):
        """The lines at the given distances from the source, as a dictionary of arrays.

        "lines" has the indices into "points" for each line, "GeodesicDistance" the distance of each line. At distance 0
        are the lines of the source; its single points are no lines.
        """
        return arrays.lines_with_points(Surface._run(kind=vtkGeodesicContour, **locals()))

    @_one_at_a_time
    def paths(self, source, targets, *, generate_source_arc_length=False, generate_source_angle=False,
              generate_face_ids=False, boundary=False, join_lines=True, source_ids=None):
        """The shortest path from each target (given as a source is) to the source, as a dictionary of arrays.

        "lines" has the indices into "points" for each path, "GeodesicDistance" its length, "TargetId" the number of
        its target, "SourceId" the part of the source that it ends on. generate_source_arc_length and
        generate_source_angle add arrays about this end, as for field(); generate_face_ids adds "FaceId": for
        each of the points the face through which the path goes on. Targets that are not reached have no path.
        """
        given = dict(locals())
        given["targets"], of_faces = self._targets(targets)
        _warn_of_unreached(of_faces, "targets")
        output = Surface._run(kind=vtkGeodesicPaths, **given)
        result = {**arrays.lines_with_points(output), **arrays.frames_of(output)}
        if generate_face_ids:
            result["FaceId"] = arrays.arrays_of([output.GetPointData()])["FaceId"]
        if not of_faces.any():
            return {name: array[:0] for name, array in result.items()}
        if not of_faces.all():
            result["TargetId"] = np.flatnonzero(of_faces)[result["TargetId"]]
        return result

    @_one_at_a_time
    def matrix(self, source=None, targets=None, *, labels=None, pairs=None, maximum_distance=0, boundary=False,
               join_lines=True, source_ids=None):
        """The distances of each target (row) to each part of the source (column), each alone.

        Targets are given as a source is; without them they are the points of the source.

        labels takes the place of source and targets: an integer for each face, or for each point. The faces (points)
        of one label are a region (set), and the table, which is symmetric, has the distances of all of them from one
        another, in the order of numpy.unique(labels[labels >= 0]); negative labels stand for none.

        pairs takes rows of two indices, k x 2, and gives one distance a row, without the whole table: it measures from
        as few points as will do, once from each, no farther than to its partners. The first index of a row is that of
        a point of the source, the second that of a target, both given by positions or by indices; without source and
        targets, both are indices of points of the surface.
        """
        if labels is not None:
            if boundary or any(given is not None for given in (source, targets, pairs, source_ids)):
                raise GeodesicError("labels are the source and the targets: give neither these, nor pairs, boundary or "
                                    "source_ids with it.")
            return self._table_of_labels(labels, maximum_distance=maximum_distance)
        if pairs is None:
            return self._table(source, targets, maximum_distance=maximum_distance, boundary=boundary,
                               join_lines=join_lines, source_ids=source_ids)
        if (source is None) != (targets is None):
            raise GeodesicError("pairs has indices of points of the source and of targets: give both, or neither for "
                                "points of the surface.")
        if boundary or source_ids is not None:
            raise GeodesicError("pairs are of single points: give no boundary and no source_ids with it.")
        return self._distances_of_pairs(pairs, source, targets, maximum_distance=maximum_distance)

    @_one_at_a_time
    def farthest_points(self, count, start=0):
        """Points spread evenly: the indices of so many, and the distance of each to the nearest of those before it.

        The first one is start, an index (or several, as one in each component); each next one is the point of the
        surface that is farthest from all before it, the one of lowest index if several are. So every point is within
        the last distance of the points before the last one. The first distance is infinite. Points to which no path
        leads from the start are left out.
        """
        starts = inputs.point_indices(start, self._number_of_points(), "The start")
        if starts is None:
            raise GeodesicError("The start is an index of a point, or several.")
        if count < len(starts):
            raise GeodesicError(f"count is {count}, but the start alone has {len(starts)}: give a larger count.")
        of_faces = self._are_of_faces(starts)
        if not of_faces.all():
            raise GeodesicError(f"Point {starts[~of_faces][0]} of the start belongs to no face of the surface.")
        between = self.matrix(starts) if len(starts) > 1 else np.empty((1, 1))
        radii = [between[k, :k].min(initial=np.inf) for k in range(len(starts))]
        if count == len(starts):
            return starts.astype(np.int64), np.array(radii)
        found = self._run(vtkGeodesicFarthestPoints, starts, number_of_points=int(count) - len(starts))
        ids = np.concatenate((starts, arrays.column_of(found, "PointId"))).astype(np.int64)
        if len(ids) < count:
            raise GeodesicError(f"count is {count}, but there are only {len(ids)} points at different places to which "
                                "a path leads from the start.")
        return ids, np.concatenate((radii, arrays.column_of(found, "GeodesicDistance")))

    def _solve(self, accuracy, relative_error, **given):
        """The output of the field's filter."""
        kind = vtkGeodesicDistanceField
        if accuracy is None:
            accuracy = kind.EXACT if relative_error is None else kind.APPROXIMATE
        if relative_error is None:
            relative_error = kind().GetRelativeError()
        return self._run(kind, accuracy=accuracy, relative_error=relative_error, **given)

    def _table(self, source, targets, **given):
        """The matrix, in which points that no face uses are infinitely far."""
        data, columns = None, np.ones(0, bool)
        if source is not None:
            data, columns = self._places(source, inputs.SOURCE, may_be_faces=True)
        if given["source_ids"] is not None:
            self._source(source)  # of whose points each has an id: none may be missing
        if columns.size and not columns.any():
            raise GeodesicError("No point of the source belongs to a face of the surface.")
        places, rows = (None, columns) if targets is None else self._targets(targets)
        _warn_of_unreached(rows, "targets")
        table = arrays.columns_of(self._run(vtkGeodesicDistanceMatrix, data, places, **given))
        table = table if rows.any() else table[:0]
        return arrays.with_infinite(arrays.with_infinite(table, rows, axis=0), columns, axis=1)

    def _table_of_labels(self, labels, **given):
        """The matrix of all regions, in which those without a point that a face uses are infinitely far."""
        labels, count = inputs.labels_of_parts(labels), self._number_of_points()
        parts = np.flatnonzero(labels >= 0)
        faces = inputs.faces_with(labels, self._data, count, "labels")
        if faces is not None:
            data = inputs.faces_as_source(parts, faces, self._data)
        elif labels.size == count:
            parts = parts[self._are_of_faces(parts)]
            if not parts.size:
                raise GeodesicError("No point with a label belongs to a face of the surface.")
            data = inputs.indexed_points(parts, self._data)
        else:
            faces = arrays.corners_of_faces(self._data)
            raise GeodesicError(f"labels has {labels.size} integers, but the surface has {count} points and " +
                                (f"{len(faces[0])} faces." if faces else "faces that cannot be labelled: some are "
                                 "curved, or in strips. Make triangles of them (vtkTriangleFilter)."))
        table = arrays.columns_of(self._run(vtkGeodesicDistanceMatrix, data, source_ids=labels[parts],
                                            target_ids=inputs.SOURCE_IDS, **given))
        are_there = np.isin(np.unique(labels[labels >= 0]), labels[parts])
        return arrays.with_infinite(arrays.with_infinite(table, are_there, axis=0), are_there, axis=1)

    def _distances_of_pairs(self, pairs, source, targets, **given):
        """The distance of the two points of each row."""
        places, pairs = self._places_of_pairs(pairs, source, targets)
        is_index = places.ids >= 0
        are_of_faces = np.ones(len(places), bool)
        are_of_faces[is_index] = self._are_of_faces(places.ids[is_index])
        of_faces = are_of_faces[pairs].all(axis=1)
        _warn_of_unreached(of_faces, "pairs")
        rows = np.flatnonzero(of_faces)
        starts, ends = few_sources(pairs[rows])
        order = np.argsort(starts, kind="stable")
        result = np.full(len(pairs), np.inf)
        for group in np.split(order, np.flatnonzero(np.diff(starts[order])) + 1):
            if len(group):
                both = (places[numbers].data_set(self._data) for numbers in (starts[group[:1]], ends[group]))
                result[rows[group]] = arrays.columns_of(self._run(vtkGeodesicDistanceMatrix, *both, **given))[:, 0]
        return result

    def _places_of_pairs(self, pairs, source, targets):
        """The places in pairs, each once, and the pairs as their numbers."""
        if source is None:
            pairs = index_pairs(pairs, [("the surface", self._number_of_points())] * 2)
            return Places.each_once(*map(Places.of_indices, pairs.T))
        sides = self._single_points(source, inputs.SOURCE), self._single_points(targets, "The set of targets")
        pairs = index_pairs(pairs, list(zip(("the source", "the set of targets"), map(len, sides))))
        return Places.each_once(*(side[column] for side, column in zip(sides, pairs.T)))

    def _single_points(self, where, name):
        where = inputs.unwrapped(where)
        if isinstance(where, vtkDataObject):
            raise GeodesicError(f"{name}: pairs index positions or indices of points. Give the points of a data set, "
                                "such as mesh.points of PyVista.")
        ids = inputs.point_indices(where, self._number_of_points(), name)
        return Places.of_positions(where, name) if ids is None else Places.of_indices(ids)

    def _run(self, kind, source, targets=None, *, distances=(), boundary=False, source_ids=None, target_ids=None,
             **properties):
        """The output of a filter of a kind, which is kept. targets: None or a data set. target_ids: an array's name."""
        if kind not in self._filters:
            self._filters[kind] = kind()
            self._filters[kind].SetInputData(self._data)
        filter = self._filters[kind]
        filter.SetSourceType(filter.SURFACE_BOUNDARY if source is None else
                             filter.CURVE_AND_BOUNDARY if boundary else filter.SOURCE_CURVE)
        data = None if source is None else self._source(source)
        if source_ids is not None and not isinstance(source_ids, str):
            data, source_ids = inputs.with_ids(data, source_ids), inputs.SOURCE_IDS
        filter.SetSourceData(data)
        filter.SetSourceIdArrayName(source_ids)
        if filter.GetNumberOfInputPorts() > 2:
            filter.SetTargetsData(targets)
        if kind is vtkGeodesicContour:
            _set_values(filter, distances)
        if kind is vtkGeodesicDistanceMatrix:
            filter.SetTargetIdArrayName(target_ids)
        for argument, value in {**self._properties, **properties}.items():
            _set(filter, argument, value)
        filter.Modified()  # the surface may have been changed in place
        with _threads(self._threads):
            run(filter, ARGUMENTS)
        return filter.GetOutputDataObject(0)

    def _source(self, source):
        data, of_faces = self._places(source, inputs.SOURCE, may_be_faces=True)
        if not of_faces.all():
            point = inputs.point_indices(source, self._number_of_points(), inputs.SOURCE)[~of_faces][0]
            raise GeodesicError(f"Point {point} of the source belongs to no face of the surface.")
        return data

    def _targets(self, targets):
        """The targets as a data set, and which of them belong to faces; one is in the data set also where none does."""
        data, of_faces = self._places(targets, "The set of targets")
        if of_faces.size and not of_faces.any():
            data = inputs.indexed_points(np.flatnonzero(self._used_points())[:1], self._data)
        return data, of_faces

    def _places(self, where, name, may_be_faces=False):
        """A source, or targets, as a data set of the points that belong to faces, and for each point whether it does.

        Those that are not given by index always do. may_be_faces: whether a mask of faces is a region.
        """
        where = inputs.unwrapped(where)
        if isinstance(where, vtkDataObject):
            return where, np.ones(where.GetNumberOfElements(vtkDataObject.POINT), bool)
        region = inputs.masked_faces(where, self._data, self._number_of_points()) if may_be_faces else None
        if region is not None:
            return region, np.ones(region.GetNumberOfPoints(), bool)
        ids = inputs.point_indices(where, self._number_of_points(), name)
        if ids is None:
            data = inputs.point_set(where, name)
            return data, np.ones(data.GetNumberOfPoints(), bool)
        of_faces = self._are_of_faces(ids)
        return inputs.indexed_points(ids[of_faces], self._data), of_faces

    def _are_of_faces(self, ids):
        """Whether a face uses the point, or one at its place that is merged with it."""
        used = self._used_points()
        if used[ids].all() or not used.any():  # where there are no faces the filter says so
            return np.ones(ids.shape, bool)
        if self._properties["merge_coincident_points"]:
            places = np.unique(arrays.points_of(self._data), axis=0, return_inverse=True)[1].ravel()
            used = np.isin(places, places[used])
        return used[ids]

    def _used_points(self):
        if self._used[0] != self._data.GetMTime():
            self._used = self._data.GetMTime(), arrays.used_points(self._data)
        return self._used[1]

    def _number_of_points(self):
        return sum(block.GetNumberOfPoints() for block in arrays.blocks_of(self._data))


FIELD_DEFAULTS = {name: parameter.default for name, parameter in inspect.signature(Surface.field).parameters.items()
                  if parameter.kind == parameter.KEYWORD_ONLY}
METHODS = (Surface.distance, Surface.field, Surface.contour, Surface.paths, Surface.matrix,
           Surface.farthest_points)
# Properties of the filters, as their messages name them, and what they are called here.
ARGUMENTS = {property_name(argument): argument for function in (Surface, *METHODS)
             for argument in inspect.signature(function).parameters if "_" in argument}
ARGUMENTS.update(BarrierArrayName="barriers", SourceIdArrayName="source_ids", TargetIdArrayName="labels")


def _set(filter, argument, value):
    try:
        getattr(filter, "Set" + property_name(argument))(value)
    except TypeError as error:
        raise TypeError(f"{argument} cannot be {value!r}: {error}") from None


def _set_values(filter, distances):
    values = np.atleast_1d(inputs.numbers(distances, "distances"))
    filter.SetNumberOfContours(len(values))
    for i, value in enumerate(values):
        filter.SetValue(i, value)


@contextmanager
def _threads(number):
    """Has vtkSMPTools use so many threads meanwhile; None: as many as it does."""
    if number is None:
        yield
        return
    if number < 1:
        raise GeodesicError(f"threads is {number}: give at least 1, or None for what vtkSMPTools is set to.")
    backend = vtkSMPTools.GetBackend()
    # In VTK 9.6 TBB's number of threads, once made smaller, stays so.
    if backend == "TBB" or (number > 1 and backend == "Sequential"):
        vtkSMPTools.SetBackend("STDThread")
    before = vtkSMPTools.GetEstimatedNumberOfThreads()
    vtkSMPTools.Initialize(number)
    try:
        yield
    finally:
        vtkSMPTools.Initialize(before)
        vtkSMPTools.SetBackend(backend)


def _warn_of_unreached(of_faces, what):
    """Counts those that are not on the surface."""
    lost = np.flatnonzero(~of_faces)
    if len(lost):
        names = ", ".join(map(str, lost[:3])) + (f" and {len(lost) - 3} more" if len(lost) > 3 else "")
        warn(f"{len(lost)} of {len(of_faces)} {what} not reached, as points that no face uses are not on the surface: "
             f"number {names}.")
