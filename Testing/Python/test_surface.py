# SPDX-License-Identifier: BSD-3-Clause
"""geodesicdistance.Surface: what the functions give, call after call; pairs; points spread evenly; threads;
points that no face uses."""

import copy
import inspect
import math
import multiprocessing
import os
import pickle
import sys
import threading
import unittest
import warnings

import numpy as np

import geodesicdistance
from geodesicdistance import GeodesicError, Surface, contour, curve, distance, farthest_points, field, matrix, paths
from test_functions import EXACT, as_poly_data, octahedron, sheet
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonDataModel import (VTK_TRIANGLE, vtkCellArray, vtkMultiBlockDataSet, vtkPolyData,
                                           vtkUnstructuredGrid)

LINE = curve([(0.25, 0.5, 0), (0.75, 0.5, 0)])
# A function, its positional arguments and its options: each on the sheet.
CALLS = (
    ("distance", (0,), {}),
    ("field", (LINE,), dict(generate_source_ids=True, generate_signed_distance=True, generate_source_angle=True)),
    ("distance", ([4, 70],), dict(maximum_distance=0.5)),
    ("contour", (0, [0.25, 0.5]), {}),
    ("field", (0,), dict(refine_mesh=True, refinement_tolerance=0.01)),
    ("distance", (None,), {}),
    ("distance", (40,), dict(relative_error=0.1, boundary=True)),
    ("contour", (LINE, 0.25), dict(signed_distances=True)),
    ("paths", (0, [80, 8]), dict(generate_source_angle=True)),
    ("matrix", ([4, 40], [0, 8, 80]), {}),
    ("matrix", (None, [0, 40]), {}),
    ("paths", (None, [40]), {}),
    ("matrix", ([4, 40],), {}),
    ("matrix", (), dict(pairs=[(0, 8), (3, 80), (0, 4)])),
    ("distance", (0,), {}))


def cells(rows):
    array = vtkCellArray()
    for row in rows:
        array.InsertNextCell(len(row), [int(i) for i in row])
    return array


def with_array(name, values, data):
    """A copy of a data set that has a cell array more."""
    other = data.NewInstance()
    other.DeepCopy(data)
    array = numpy_to_vtk(values.astype(float), deep=True)
    array.SetName(name)
    other.GetCellData().AddArray(array)
    return other


def as_grid(data):
    grid = vtkUnstructuredGrid()
    grid.SetPoints(data.GetPoints())
    grid.SetCells(VTK_TRIANGLE, data.GetPolys())
    return grid


def of_subclass(data):
    """As PyVista's meshes are of classes of its own."""
    mesh = type("Mesh", (vtkPolyData,), {})()
    mesh.ShallowCopy(data)
    return mesh


def in_blocks(data):
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, data)
    return blocks


def same(one, other):
    """Whether results are the same, to the last bit."""
    if isinstance(one, dict):
        return list(one) == list(other) and all(same(one[name], other[name]) for name in one)
    if isinstance(one, list):
        return len(one) == len(other) and all(map(same, one, other))
    return np.array_equal(one, other)


class Kept(unittest.TestCase):
    def test_gives_what_the_functions_give_whatever_was_asked_before(self):
        walls = np.arange(128) % 9 == 8
        for options in ({}, {"barriers": walls}, {"merge_coincident_points": False}):
            kept = Surface(sheet(), **options)
            for name, arguments, more in CALLS + CALLS[::-1]:
                expected = getattr(geodesicdistance, name)(sheet(), *arguments, **more, **options)
                self.assertTrue(same(getattr(kept, name)(*arguments, **more), expected), name)

    def test_makes_the_structure_once(self):
        """The second time the filter reports no progress of reading the surface."""
        kept = Surface(sheet(40))
        with self.assertRaises(GeodesicError):
            kept.distance(0, maximum_distance=-1)  # makes the filter, and reads nothing
        (filter,) = kept._filters.values()
        steps = []
        filter.AddObserver("ProgressEvent", lambda *_: steps[-1].append(filter.GetProgress()))
        for ask, arguments in ((kept.distance, (0,)), (kept.field, (5,)), (kept.distance, (None,))):
            steps.append([])
            ask(*arguments)
        reading = [[value for value in values if 0 < value < 0.1] for values in steps]
        self.assertGreater(len(reading[0]), 5)
        self.assertEqual(reading[1:], [[], []])

    def test_goes_on_after_an_error(self):
        kept = Surface(sheet())
        expected = kept.distance(3)
        with self.assertRaises(GeodesicError):
            kept.distance(3, maximum_distance=-1)
        with self.assertRaises(GeodesicError):
            kept.contour(3, [])
        kept.matrix([3, 4])
        with self.assertRaisesRegex(GeodesicError, "There are no targets"):
            kept.matrix(None)
        np.testing.assert_array_equal(kept.distance(3), expected)

    def test_has_a_copy_of_arrays_but_follows_a_data_set(self):
        points, faces = sheet()
        data = as_poly_data((points, faces))
        kept, following = Surface((points, faces)), Surface(data)
        expected = kept.distance(0)
        np.testing.assert_allclose(following.distance(0), expected, atol=EXACT)
        points *= 2
        np.testing.assert_array_equal(kept.distance(0), expected)
        for i in range(len(points)):
            data.GetPoints().SetPoint(i, points[i])
        data.Modified()
        np.testing.assert_allclose(following.distance(0), 2 * expected, atol=EXACT)
        inside = following.distance(None)
        vtk_to_numpy(data.GetPoints().GetData())[:] *= 2  # of which VTK learns nothing
        np.testing.assert_allclose(following.distance(None), 2 * inside, atol=EXACT)

    def test_follows_what_faces_use(self):
        points, faces = sheet()
        data = as_poly_data((np.concatenate((points, [(1.5, 0, 0)])), faces))
        kept = Surface(data)
        with self.assertRaisesRegex(GeodesicError, "belongs to no face"):
            kept.distance(81)
        data.SetPolys(cells([*faces, (8, 81, 17)]))
        self.assertAlmostEqual(kept.distance(81)[8], 0.5, delta=EXACT)

    def test_results_stay_when_more_is_asked(self):
        kept = Surface(sheet())
        first = kept.field(0, generate_gradients=True)
        before = {name: array.copy() for name, array in first.items()}
        kept.field(80, generate_gradients=True)
        self.assertTrue(same(first, before))

    def test_warns_each_time_of_a_source_far_away(self):
        kept = Surface(sheet())
        for _ in range(3):
            with self.assertWarnsRegex(UserWarning, "^The source is up to 0.5 away"):
                kept.distance([(0.5, 0.5, 0.5)])

    def test_takes_the_arguments_of_the_functions(self):
        own = inspect.signature(Surface).parameters
        for name in ("distance", "field", "contour", "paths", "matrix", "farthest_points"):
            self.assertIn("\n", getattr(geodesicdistance, name).__doc__)
            function = inspect.signature(getattr(geodesicdistance, name)).parameters
            method = inspect.signature(getattr(Surface, name)).parameters
            self.assertEqual(list(function), ["surface", *list(method)[1:], *list(own)[1:]])
            for parameter in function.values():
                self.assertIn(parameter.kind, (parameter.POSITIONAL_OR_KEYWORD, parameter.KEYWORD_ONLY))
                origin = {**own, **method}[parameter.name]
                self.assertEqual((parameter.default, parameter.kind), (origin.default, origin.kind))


class Properties(unittest.TestCase):
    def test_have_the_defaults_of_the_filters(self):
        filters = {"field": geodesicdistance.vtkGeodesicDistanceField, "contour": geodesicdistance.vtkGeodesicContour,
                   "paths": geodesicdistance.vtkGeodesicPaths, "matrix": geodesicdistance.vtkGeodesicDistanceMatrix}
        not_theirs = {"surface", "source", "targets", "distances", "pairs", "boundary", "barriers", "threads",
                      "source_ids", "labels"}
        chosen_here = {"refine_mesh": False, "accuracy": None, "relative_error": None}
        for name, kind in filters.items():
            for argument, parameter in inspect.signature(getattr(geodesicdistance, name)).parameters.items():
                if argument not in not_theirs:
                    with self.subTest(function=name, argument=argument):
                        getter = "Get" + "".join(word.capitalize() for word in argument.split("_"))
                        default = chosen_here.get(argument, getattr(kind(), getter)())
                        self.assertEqual(parameter.default, default)

    def test_are_all_arguments(self):
        """Each setter of the filters is an argument, or has another name here."""
        others = {"Controller", "SourceType", "SourceConnection", "SourceData", "BarrierArrayName", "SourceIdArrayName",
                  "TargetIdArrayName",  # labels
                  # a numpy array has no names, and nothing but distances
                  "SourceNameArrayName", "TargetNameArrayName", "GenerateTargetPositions",
                  "TargetsConnection", "TargetsData", "NumberOfContours", "Value"}
        for name, kind in (("field", "DistanceField"), ("contour", "Contour"), ("paths", "Paths"),
                           ("matrix", "DistanceMatrix")):
            kind = getattr(geodesicdistance, f"vtkGeodesic{kind}")
            own = set(dir(kind)) - set(dir(kind.__mro__[2]))
            setters = {method[3:] for method in own if method.startswith("Set") and "To" not in method[3:]}
            setters |= {method[3:] for method in own if method.startswith("SetTo")}
            arguments = {"".join(word.capitalize() for word in argument.split("_"))
                         for argument in inspect.signature(getattr(geodesicdistance, name)).parameters}
            self.assertEqual(setters - others - arguments, set(), name)

    def test_of_a_wrong_type_are_errors_that_name_the_argument(self):
        for name, value in (("maximum_distance", "far"), ("maximum_number_of_cells", 1.5)):
            with self.assertRaisesRegex(TypeError, f"^{name} cannot be "):
                field(sheet(), 0, **{name: value})
        for value in (np.float32(0.5), np.float64(0.5), 0.5):
            np.testing.assert_array_equal(distance(sheet(), 0, maximum_distance=value),
                                          distance(sheet(), 0, maximum_distance=0.5))
        self.assertIn("SourceId", field(sheet(), 0, generate_source_ids=np.True_))
        np.testing.assert_array_equal(distance(sheet(), 0, maximum_distance=np.int64(1)),
                                      distance(sheet(), 0, maximum_distance=1))

    def test_boundary_is_a_source_beside_others(self):
        points, faces = sheet()
        x, y = points[:, 0], points[:, 1]
        edge = np.minimum(np.minimum(x, 1 - x), np.minimum(y, 1 - y))
        np.testing.assert_allclose(distance((points, faces), [(0.4, 0.5, 0)], boundary=True),
                                   np.minimum(edge, np.hypot(x - 0.4, y - 0.5)), atol=EXACT)
        np.testing.assert_allclose(distance((points, faces), None, boundary=True), edge, atol=EXACT)
        self.assertEqual(matrix((points, faces), [40, 0], [80], boundary=True).shape, (1, 3))


class Parts(unittest.TestCase):
    def test_of_a_source_have_the_ids_that_are_given(self):
        points, faces = sheet()
        for source in ([0, 8, 80], points[[0, 8, 80]], as_poly_data((points[[0, 8, 80]], []))):
            result = field((points, faces), source, source_ids=[7, 3, 7], generate_source_ids=True)
            self.assertEqual(result["SourceId"][[0, 8, 80]].tolist(), [7, 3, 7])
            table = matrix((points, faces), source, [0, 8, 80, 71], source_ids=[7, 3, 7])
            expected = [distance((points, faces), ids)[[0, 8, 80, 71]] for ids in ([8], [0, 80])]
            np.testing.assert_allclose(table.T, expected, atol=EXACT)
            ways = paths((points, faces), source, [8, 80], source_ids=[7, 3, 7])
            self.assertEqual(ways["SourceId"].tolist(), [3, 7])
        two = as_poly_data(([(0.25, y, 0) for y in (0.25, 0.75)] + [(0.75, y, 0) for y in (0.25, 0.75)], []))
        two.SetLines(cells([(0, 2), (1, 3)]))
        nearest = np.where(points[:, 1] < 0.5, 5, 9)[points[:, 1] != 0.5]
        for ids, expected in (([5, 9], nearest), (None, nearest // 9)):
            result = field((points, faces), two, generate_source_ids=True, source_ids=ids)
            self.assertEqual(result["SourceId"][points[:, 1] != 0.5].tolist(), expected.tolist())

    def test_that_are_two_point_lines_are_joined_unless_that_is_off(self):
        points, faces = sheet()
        pieces = as_poly_data(([(0.25, 0.5, 0), (0.5, 0.5, 0), (0.75, 0.5, 0)], []))
        pieces.SetLines(cells([(0, 1), (1, 2)]))
        joined = field((points, faces), pieces, generate_source_ids=True, generate_source_arc_length=True)
        whole = field((points, faces), LINE, generate_source_ids=True, generate_source_arc_length=True)
        for name in ("SourceId", "SourceArcLength", "GeodesicDistance"):
            np.testing.assert_allclose(joined[name], whole[name], atol=EXACT)
        apart = field((points, faces), pieces, generate_source_ids=True, join_lines=False)
        self.assertEqual(set(apart["SourceId"]), {0, 1})
        self.assertEqual(matrix((points, faces), pieces, 0).shape, (1, 1))
        self.assertEqual(matrix((points, faces), pieces, 0, join_lines=False).shape, (1, 2))

    def test_that_are_wrong_are_refused(self):
        for arguments, message in (({"source_ids": [1, 2, 3]}, "3 integers, but the source has 0 cells and 2 points"),
                                   ({"source_ids": [1.5, 2]}, "an integer for each"),
                                   ({"source_ids": 3}, "an integer for each"),
                                   ({"source_ids": {1, 2}}, "given as a set"), ({"source_ids": "regions"}, "regions")):
            with self.assertRaisesRegex(GeodesicError, message):
                field(sheet(), [0, 8], **arguments)
        with self.assertRaisesRegex(GeodesicError, "an integer for each"):
            field(sheet(), None, source_ids=[0])


class Joined(unittest.TestCase):
    def test_are_boundary_points_within_the_tolerance(self):
        left, right = sheet(2), sheet(2)
        points = np.concatenate((left[0], right[0] + (1.001, 0, 0)))
        faces = np.concatenate((left[1], right[1] + len(left[0])))
        apart = distance((points, faces), 0)
        self.assertTrue(np.isinf(apart[9:]).all())
        whole = distance((points, faces), 0, merge_tolerance=0.01)
        np.testing.assert_allclose(whole, np.linalg.norm(points, axis=1), atol=0.01)

    def test_are_faces_to_the_points_of_paths(self):
        points, faces = sheet()
        way = paths((points, faces), 0, [(0.9, 0.35, 0)], generate_face_ids=True)
        self.assertEqual(len(way["FaceId"]), len(way["points"]))
        ids = way["lines"][0]
        for start, end in zip(ids, ids[1:]):
            corners = points[faces[way["FaceId"][start]]]
            middle = way["points"][[start, end]].mean(axis=0)
            weights = np.linalg.solve(np.column_stack((corners[:, :2], np.ones(3))).T, (*middle[:2], 1))
            self.assertTrue((weights > -EXACT).all())


class Pairs(unittest.TestCase):
    def test_have_the_distances_of_the_whole_table(self):
        random = np.random.default_rng(7)
        points, faces = sheet(12)
        points = points + random.uniform(-0.02, 0.02, points.shape)
        ids = random.choice(len(points), 12, replace=False)
        table = matrix((points, faces), ids)
        for rows in (40, 1):
            chosen = random.integers(0, len(ids), (rows, 2))
            given = matrix((points, faces), pairs=ids[chosen])
            self.assertEqual(given.shape, (rows,))
            np.testing.assert_allclose(given, table[chosen[:, 1], chosen[:, 0]], atol=EXACT)

    def test_of_positions_and_indices_have_the_distances_of_the_whole_table(self):
        random = np.random.default_rng(53)
        points, faces = sheet(12)
        points = points + random.uniform(-0.02, 0.02, points.shape)
        positions = [random.uniform((0, 0, 0), (1, 1, 0), (count, 3)) for count in (7, 9)]
        indices = [random.choice(len(points), count, replace=False) for count in (7, 9)]
        kept = Surface((points, faces))
        for source in positions[0], indices[0]:
            for targets in positions[1], indices[1]:
                table = kept.matrix(source, targets)
                for rows in (60, 5, 1):
                    chosen = np.column_stack((random.integers(0, 7, rows), random.integers(0, 9, rows)))
                    given = kept.matrix(source, targets, pairs=chosen)
                    np.testing.assert_allclose(given, table[chosen[:, 1], chosen[:, 0]], atol=EXACT)

    def test_index_the_source_first_and_then_the_targets(self):
        ends = np.array([(0.1, 0.2, 0), (0.6, 0.2, 0)]), np.array([(0.1, 0.9, 0), (0.1, 0.5, 0), (0.9, 0.6, 0)])
        np.testing.assert_allclose(matrix(sheet(), *ends, pairs=[(0, 1), (1, 2), (0, 0)]), [0.3, 0.5, 0.7], atol=EXACT)
        mask = np.zeros(81, bool)
        mask[[0, 8]] = True
        np.testing.assert_allclose(matrix(sheet(), mask, 80, pairs=[(1, 0), (0, 0)]), [1, 2**0.5], atol=EXACT)
        self.assertEqual(matrix(sheet(), *ends, pairs=[]).shape, (0,))
        np.testing.assert_array_equal(matrix(sheet(), *ends, pairs=[(0, 1), (0, 0)], maximum_distance=0.5) < np.inf,
                                      [True, False])

    def test_of_indices_tell_points_at_one_place_apart(self):
        points, faces = sheet()
        two = np.concatenate((points, points)), np.concatenate((faces, np.array(faces) + len(points)))
        given = matrix(two, [0, 81], [8, 89], pairs=[(0, 0), (0, 1), (1, 1)], merge_coincident_points=False)
        np.testing.assert_allclose(given, [1, np.inf, 1], atol=EXACT)

    def test_are_measured_from_as_few_points_as_will_do(self):
        kept = Surface(sheet())
        ids = range(80)
        kept.matrix(0, 1)
        (filter,) = kept._filters.values()
        solves = []
        filter.AddObserver("StartEvent", lambda *_: solves.append(1))
        for pairs, number in (([(i, 5) for i in ids], 1), ([(5, i) for i in ids], 1),
                              ([(i, 5)[::(-1) ** i] for i in ids], 1), ([(1, 8), (2, 8), (1, 9), (3, 9)], 2)):
            solves.clear()
            kept.matrix(pairs=pairs)
            self.assertEqual(len(solves), number)
        places = np.random.default_rng(1).uniform((0, 0, 0), (1, 1, 0), (80, 3))
        for sides in ((places, places[:1]), (places[:1], places), (places, places[[5] * 80])):
            solves.clear()
            kept.matrix(*sides, pairs=[(i % len(sides[0]), i % len(sides[1])) for i in ids])
            self.assertEqual(len(solves), 1)

    def test_stop_at_a_maximum_and_where_there_is_no_path(self):
        points, faces = sheet()
        two = np.concatenate((points, points + (0, 0, 3))), np.concatenate((faces, np.array(faces) + len(points)))
        np.testing.assert_array_equal(matrix(two, pairs=[(0, 81), (8, 8), (0, 8)], maximum_distance=0.5),
                                      [np.inf, 0, np.inf])
        self.assertEqual(matrix(two, pairs=[]).shape, (0,))

    def test_that_are_wrong_are_refused(self):
        for arguments, message in (({"pairs": [(0, 81)]}, "there is no 81"), ({"pairs": [(0, -1)]}, "there is no -1"),
                                   ({"pairs": [0, 1]}, "two indices"), ({"pairs": [(0, 1, 2)]}, "two indices"),
                                   ({"pairs": [(0.0, 1.0)]}, "two indices"), ({"pairs": {(0, 1)}}, "given as a set"),
                                   ({"source": 0, "pairs": [(0, 1)]}, "give both, or neither"),
                                   ({"targets": 0, "pairs": [(0, 1)]}, "give both, or neither"),
                                   ({"pairs": [(0, 1)], "boundary": True}, "no boundary"),
                                   ({"pairs": [(0, 1)], "source_ids": [1]}, "no boundary and no source_ids"),
                                   ({"source": [3, 4], "targets": 0, "pairs": [(2, 0)]}, "source has 2 .* no 2"),
                                   ({"source": [3, 4], "targets": 0, "pairs": [(1, 1)]}, "targets has 1 .* no 1"),
                                   ({"source": [3, 4], "targets": 0, "pairs": [(-1, 0)]}, "there is no -1"),
                                   ({"source": LINE, "targets": 0, "pairs": [(0, 0)]}, "mesh.points of PyVista"),
                                   ({"source": 0, "targets": [(0., 0)], "pairs": [(0, 0)]}, r"\(number, 3\)")):
            with self.subTest(message=message), self.assertRaisesRegex(GeodesicError, message):
                matrix(sheet(), **arguments)


def rough_sheet(random):
    """A sheet of bumps and valleys, with no two distances alike."""
    points, faces = sheet(12)
    return points + random.uniform(-0.03, 0.03, points.shape), faces


class SpreadPoints(unittest.TestCase):
    def assert_each_is_the_farthest_of_all_before(self, surface, ids, radii, starts=1, **options):
        """By a field of all before it, without a limit."""
        for k in range(1, len(ids)):
            known = distance(surface, ids[:k], **options)
            self.assertAlmostEqual(known[ids[k]], radii[k], delta=EXACT)
            if k >= starts:
                self.assertAlmostEqual(known[known < np.inf].max(), radii[k], delta=EXACT)

    def test_are_each_the_farthest_of_all_before(self):
        random = np.random.default_rng(4)
        for start in (0, 77, [5, 100, 6]):
            surface = rough_sheet(random)
            ids, radii = farthest_points(surface, 40, start)
            starts = np.atleast_1d(start)
            self.assertEqual(ids.shape + radii.shape, (40, 40))
            self.assertEqual(ids[:len(starts)].tolist(), starts.tolist())
            self.assertEqual(len(set(ids)), 40)
            self.assertEqual(radii[0], np.inf)
            self.assertTrue((np.diff(radii[len(starts):]) <= 0).all())
            self.assert_each_is_the_farthest_of_all_before(surface, ids, radii, len(starts))

    def test_are_those_of_a_loop_without_limits(self):
        points, faces = rough_sheet(np.random.default_rng(8))
        kept, known, expected = Surface((points, faces)), np.full(len(points), np.inf), [0]
        ids, radii = kept.farthest_points(len(points))
        for radius in radii[1:]:
            known = np.minimum(known, kept.distance(expected[-1]))
            expected.append(known.argmax())
            self.assertEqual(known.max(), radius)
        self.assertEqual(ids.tolist(), expected)

    def test_are_those_of_a_loop_without_limits_around_barriers_in_parts_and_on_threads(self):
        random = np.random.default_rng(9)
        for threads in (1, 3):
            (points, faces), (others, _) = rough_sheet(random), rough_sheet(random)
            faces = np.array(faces)
            two = np.concatenate((points, others + (0, 0, 3))), np.concatenate((faces, faces + len(points)))
            walls = random.uniform(size=len(two[1])) < 0.2
            kept, starts = Surface(two, barriers=walls, threads=threads), [14, len(points) + 60, 90]
            starts = [id for id in starts if id in two[1][~walls]]
            known = np.min([kept.distance(start) for start in starts], axis=0)
            ids, radii = kept.farthest_points(len(starts) + 50, starts)
            for id, radius in zip(ids[len(starts):], radii[len(starts):]):
                found = np.where(known < np.inf, known, -1).argmax()
                self.assertEqual(id, found)
                self.assertAlmostEqual(radius, known[found], delta=EXACT)
                known = np.minimum(known, kept.distance(id))

    def test_that_tie_come_in_the_order_of_their_indices(self):
        ids, radii = farthest_points(sheet(), 4)
        self.assertEqual(ids.tolist(), [0, 80, 8, 72])
        np.testing.assert_allclose(radii, [np.inf, 2**0.5, 1, 1], atol=EXACT)

    def test_are_spread_around_barriers_and_not_inside(self):
        points, faces = sheet()
        middles = points[np.array(faces)].mean(axis=1)
        walls = (np.abs(middles[:, 0] - 0.5) < 0.2) & (middles[:, 1] < 0.8)
        outside = np.unique(np.array(faces)[~walls])
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            ids, radii = farthest_points((points, faces), len(outside), barriers=walls)
        self.assertEqual(set(ids), set(outside))
        self.assertGreater(radii[1], 1.5)
        self.assert_each_is_the_farthest_of_all_before((points, faces), ids[:12], radii[:12], barriers=walls)

    def test_are_only_where_a_path_leads_from_the_start(self):
        points, faces = sheet()
        two = np.concatenate((points, points + (0, 0, 3))), np.concatenate((faces, np.array(faces) + len(points)))
        with self.assertWarnsRegex(UserWarning, "^81 points are left out, .* such as point 81: give a start in each"):
            ids, radii = farthest_points(two, 10)
        self.assertLess(ids.max(), 81)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            ids, radii = farthest_points(two, 4, [0, 81])
        np.testing.assert_allclose(radii, [np.inf, np.inf, 2**0.5, 2**0.5], atol=EXACT)
        self.assertEqual(ids.tolist(), [0, 81, 80, 161])

    def test_leave_out_points_that_no_face_uses_and_a_place_that_is_taken(self):
        points, faces = sheet()
        more = np.concatenate((points, [(9., 9, 9)], points[[8]])), faces
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertEqual(set(farthest_points(more, 81, 82)[0]), {*range(81), 82} - {8})
        with self.assertRaisesRegex(GeodesicError, "^count is 82, but there are only 81 points at different places"):
            farthest_points(more, 82)

    def test_of_wrong_arguments_are_errors(self):
        for count, start, message in ((1, 81, "there is no 81"), (1, [0, 1], "the start alone has 2: give"),
                                      (0, 0, "^count is 0, but the start alone has 1"), (2, [(0., 0, 0)], "an index of a point"),
                                      (2, 81, "Point 81 of the start belongs to no face")):
            points, faces = sheet()
            points = points if "there is" in message else np.concatenate((points, [(9., 9, 9)]))
            with self.subTest(message=message), self.assertRaisesRegex(GeodesicError, message):
                farthest_points((points, faces), count, start)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertEqual([array.tolist() for array in farthest_points(sheet(), 1, 7)], [[7], [np.inf]])


class UnusedPoints(unittest.TestCase):
    """Point 81 hangs over point 0, 82 is at the place of point 8, and no face uses them."""

    def setUp(self):
        points, self.faces = sheet()
        self.points = np.concatenate((points, points[[0]] + (0, 0, 0.001), points[[8]]))
        self.surface = self.points, self.faces

    def test_are_infinitely_far_in_matrices_as_in_fields(self):
        far = distance(self.surface, 3)
        for targets in ([81], [0, 81], [81, 82, 0, 80], list(range(83))):
            with self.assertWarnsRegex(UserWarning, f"^1 of {len(targets)} targets not reached, .*: number"):
                np.testing.assert_array_equal(matrix(self.surface, 3, targets)[:, 0], far[targets])
        with self.assertWarnsRegex(UserWarning, r"^3 of 3 targets not reached, .*: number 0, 1, 2\.$"):
            np.testing.assert_array_equal(matrix(self.surface, [0, 3], [81] * 3), np.full((3, 2), np.inf))
        with self.assertWarns(UserWarning):
            self.assertEqual(matrix(self.surface, None, 81).tolist(), [[np.inf]])
        with self.assertWarns(UserWarning):
            self.assertEqual(matrix(self.surface, None, [81, 0]).tolist(), [[np.inf], [0]])
        with self.assertWarns(UserWarning):
            table = matrix(self.surface, [0, 81, 82])
        np.testing.assert_allclose(table, [[0, np.inf, 1], [np.inf] * 3, [1, np.inf, 0]], atol=EXACT)

    def test_are_infinitely_far_in_pairs_of_a_source_and_targets(self):
        with self.assertWarnsRegex(UserWarning, r"^1 of 3 pairs not reached, .*: number 1\.$"):
            given = matrix(self.surface, [0, 81], [(1., 0, 0), (0, 0, 0)], pairs=[(0, 0), (1, 0), (0, 1)])
        np.testing.assert_allclose(given, [1, np.inf, 0], atol=EXACT)

    def test_are_infinitely_far_in_pairs(self):
        with self.assertWarnsRegex(UserWarning, r"^2 of 4 pairs not reached, .*: number 1, 3\.$"):
            result = matrix(self.surface, pairs=[(0, 8), (81, 0), (82, 0), (8, 81)])
        np.testing.assert_allclose(result, [1, np.inf, 1, np.inf], atol=EXACT)

    def test_have_no_paths(self):
        with self.assertWarnsRegex(UserWarning, r"^1 of 3 targets not reached, .*: number 1\.$"):
            result = paths(self.surface, 0, [80, 81, 8])
        self.assertEqual(result["TargetId"].tolist(), [0, 2])
        np.testing.assert_allclose(result["GeodesicDistance"], [math.sqrt(2), 1], atol=EXACT)
        with self.assertWarns(UserWarning):
            result = paths(self.surface, 0, 81)
        self.assertTrue(all(len(array) == 0 for array in result.values()))

    def test_at_a_place_of_the_surface_are_on_it_only_where_points_are_merged(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertAlmostEqual(matrix(self.surface, 0, 82)[0, 0], 1, delta=EXACT)
        with self.assertWarns(UserWarning):
            self.assertEqual(matrix(self.surface, 0, 82, merge_coincident_points=False)[0, 0], np.inf)
        self.assertEqual(distance(self.surface, 0, merge_coincident_points=False)[82], np.inf)

    def test_by_their_positions_are_put_onto_the_surface(self):
        self.assertAlmostEqual(matrix(self.surface, 8, self.points[[81]])[0, 0], 1, delta=EXACT)


class Threads(unittest.TestCase):
    def test_are_as_many_as_asked_for_during_a_call(self):
        before = vtkSMPTools.GetBackend(), vtkSMPTools.GetEstimatedNumberOfThreads()
        for number in (1, 2):
            seen = set()
            kept = Surface(sheet(), threads=number)
            kept.distance(0)
            for filter in kept._filters.values():
                filter.AddObserver("ProgressEvent", lambda *_: seen.add(vtkSMPTools.GetEstimatedNumberOfThreads()))
            result = kept.distance(0)
            self.assertEqual(seen, {number})
            np.testing.assert_array_equal(result, distance(sheet(), 0))
            with self.assertRaises(GeodesicError):
                kept.distance(0, maximum_distance=-1)
            self.assertEqual((vtkSMPTools.GetBackend(), vtkSMPTools.GetEstimatedNumberOfThreads()), before)
        with self.assertRaisesRegex(GeodesicError, "threads is 0"):
            distance(sheet(), 0, threads=0)


class Callers(unittest.TestCase):
    """Threads of Python's that use surfaces at once, and are switched between as often as can be."""

    CALLS = [call for call in CALLS if not call[2].get("refine_mesh")]

    def setUp(self):
        self.addCleanup(sys.setswitchinterval, sys.getswitchinterval())
        sys.setswitchinterval(1e-6)

    def in_threads(self, ask, number=8):
        """Calls ask(i) in so many threads at once; what they raise is raised here."""
        errors = []

        def work(i, barrier=threading.Barrier(number)):
            try:
                barrier.wait()
                ask(i)
            except BaseException as error:
                errors.append(error)

        threads = [threading.Thread(target=work, args=(i,)) for i in range(number)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        if errors:
            raise errors[0]

    def test_have_their_own_results_of_one_surface(self):
        kept = Surface(sheet())
        expected = [getattr(kept, name)(*arguments, **more) for name, arguments, more in self.CALLS]
        wrong = []

        def ask(i):
            for k in range(40):
                number = (i * 5 + k * 7) % len(self.CALLS)
                name, arguments, more = self.CALLS[number]
                if not same(getattr(kept, name)(*arguments, **more), expected[number]):
                    wrong.append(name)

        self.in_threads(ask)
        self.assertEqual(wrong, [])

    def test_have_their_own_errors_and_warnings(self):
        """And numbers of threads: those of one call are not put back in the middle of another."""
        before = vtkSMPTools.GetBackend(), vtkSMPTools.GetEstimatedNumberOfThreads()
        kept = Surface(sheet())

        def ask(i):
            own = Surface(sheet(), threads=1 + i % 2)
            for k in range(10):
                if i % 4 == 0:
                    with self.assertRaisesRegex(GeodesicError, "maximum_distance"):
                        kept.distance(i, maximum_distance=-1)
                else:
                    self.assertEqual(kept.distance(i)[i], 0)
                self.assertEqual(own.distance(k)[k], 0)
                self.assertEqual(distance(sheet(), k, threads=1 + k % 2)[k], 0)

        self.in_threads(ask)
        self.assertEqual((vtkSMPTools.GetBackend(), vtkSMPTools.GetEstimatedNumberOfThreads()), before)

    def test_may_be_processes(self):
        kept = Surface(sheet(), barriers=np.arange(128) % 9 == 8)
        for method in multiprocessing.get_all_start_methods():
            with multiprocessing.get_context(method).Pool(2) as pool:
                for source, result in enumerate(pool.map(kept.distance, range(4))):
                    np.testing.assert_array_equal(result, kept.distance(source))

    @unittest.skipUnless(hasattr(os, "register_at_fork"), "this system has no fork")
    def test_may_be_processes_forked_during_a_call(self):
        kept, is_over = Surface(sheet(40)), threading.Event()

        def ask():
            while not is_over.is_set():
                kept.distance(0)

        other = threading.Thread(target=ask)
        other.start()
        try:
            context = multiprocessing.get_context("fork")
            for _ in range(5):
                process = context.Process(target=Surface, args=(sheet(),))
                process.start()
                process.join(60)
                self.assertEqual(process.exitcode, 0)
        finally:
            is_over.set()
            other.join()


class Pickles(unittest.TestCase):
    def test_answer_as_the_surface_does(self):
        walls = np.arange(128) % 9 == 8
        data = as_poly_data(sheet())
        named = with_array("walls", walls, data)
        for surface, options in ((sheet(), {}), (sheet(), {"barriers": walls}), (data, {"barriers": walls}),
                                 (named, {"barriers": "walls", "threads": 1}), (as_grid(data), {}),
                                 (in_blocks(data), {}), (sheet(), {"merge_coincident_points": False}),
                                 (of_subclass(data), {})):
            kept = Surface(surface, **options)
            for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
                twins = [pickle.loads(pickle.dumps(kept, protocol))]
                kept.distance(0)
                twins += [pickle.loads(pickle.dumps(kept, protocol)), copy.deepcopy(kept)]
            for twin in twins:
                for name, arguments, more in CALLS:
                    expected = getattr(kept, name)(*arguments, **more)
                    self.assertTrue(same(getattr(twin, name)(*arguments, **more), expected), name)

    def test_have_the_data_of_their_time(self):
        data = as_poly_data(sheet())
        kept = Surface(data)
        before, twin = kept.distance(0), pickle.loads(pickle.dumps(kept))
        for i in range(data.GetNumberOfPoints()):
            data.GetPoints().SetPoint(i, 2 * np.array(data.GetPoint(i)))
        data.Modified()
        np.testing.assert_array_equal(twin.distance(0), before)
        np.testing.assert_array_equal(kept.distance(0), 2 * before)


class Results(unittest.TestCase):
    def test_have_one_value_a_line_also_where_the_source_has_points(self):
        square = [(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0)], [(0, 1, 2), (0, 2, 3)]
        for source in (0, [0, 2], curve([(1, 1, 0), (1, 2, 0)])):
            for values in ([0, 1, 2, 3], [3, 0, 1], [0]):
                lines = contour(square, source, values)
                self.assertEqual(len(lines["lines"]), len(lines["GeodesicDistance"]))
                for ids, value in zip(lines["lines"], lines["GeodesicDistance"]):
                    places = lines["points"][ids]
                    far = matrix(square, source, places).min(axis=1)
                    np.testing.assert_allclose(far, value, atol=1e-3 if value else EXACT)
        self.assertEqual(contour(square, 0, [0, 1, 2, 3])["GeodesicDistance"].tolist(), [1, 2, 3])

    def test_never_lie_before_the_beginning_of_a_curve_or_behind_its_end(self):
        """Not by a rounding: on turned sheets the feet at an end of the curve did."""
        points, faces = sheet(4)
        for seed in range(150):
            random = np.random.default_rng(seed)
            turn, across = np.linalg.qr(random.normal(size=(3, 2)))[0].T
            turned = random.choice([1, 0.001, 37.1]) * (points[:, :1] * turn + points[:, 1:2] * across)
            kept = Surface((turned, faces))
            line = turned[random.choice(len(points), (3, 1 + seed % 2))].mean(axis=1)
            along = kept.field(curve(line), generate_source_arc_length=True)["SourceArcLength"]
            (filter,) = kept._filters.values()
            of_line = vtk_to_numpy(filter.GetOutputDataObject(1).GetPointData().GetArray("SourceArcLength"))
            with self.subTest(seed=seed):
                self.assertGreaterEqual(along.min(), 0)
                if not np.allclose(line[0], line[-1]):  # else the end is the beginning, and has 0
                    self.assertLessEqual(along.max(), of_line.max())

    def test_of_a_field_are_a_surface_again(self):
        refined = field(octahedron(), 0, refine_mesh=True)
        np.testing.assert_allclose(distance((refined["points"], refined["faces"]), 0), refined["GeodesicDistance"],
                                   atol=EXACT)


if __name__ == "__main__":
    unittest.main()
