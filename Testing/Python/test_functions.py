# SPDX-License-Identifier: BSD-3-Clause
"""The functions of geodesicdistance on numpy arrays, against distances in closed form, and what they raise."""

import math
import re
import unittest
import warnings

import numpy as np

import geodesicdistance
from geodesicdistance import GeodesicError, contour, curve, distance, field, matrix, paths
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

EXACT = 1e-12


def sheet(count=8):
    """The unit square in the plane, of triangles."""
    x, y = np.meshgrid(np.linspace(0, 1, count + 1), np.linspace(0, 1, count + 1))
    points = np.column_stack((x.ravel(), y.ravel(), np.zeros(x.size)))
    i, j = (index.ravel() for index in np.meshgrid(np.arange(count), np.arange(count)))
    a = i + (count + 1) * j
    return points, np.concatenate((np.column_stack((a, a + 1, a + count + 2)),
                                   np.column_stack((a, a + count + 2, a + count + 1))))


def octahedron():
    points = np.concatenate((np.eye(3), -np.eye(3)))
    return points, [(x, y, z) for x in (0, 3) for y in (1, 4) for z in (2, 5)]


def as_poly_data(surface):
    data, points, faces = vtkPolyData(), vtkPoints(), vtkCellArray()
    for point in surface[0]:
        points.InsertNextPoint(*point)
    for face in surface[1]:
        faces.InsertNextCell(len(face), [int(i) for i in face])
    data.SetPoints(points)
    data.SetPolys(faces)
    return data


class Distances(unittest.TestCase):
    def test_at_my_vertices_in_one_line(self):
        points, faces = sheet()
        np.testing.assert_allclose(distance((points, faces), source=0), np.linalg.norm(points, axis=1), atol=EXACT)
        np.testing.assert_allclose(
            distance(octahedron(), 0), [0, *[math.sqrt(2)] * 2, math.sqrt(6), *[math.sqrt(2)] * 2], atol=EXACT)

    def test_are_the_same_of_poly_data_and_of_quads(self):
        points, _ = sheet()
        corners = np.arange(81).reshape(9, 9)[:8, :8].ravel()
        quads = corners[:, None] + [0, 1, 10, 9]
        for surface in (as_poly_data(sheet()), (points, quads), (points.tolist(), quads.tolist())):
            np.testing.assert_allclose(distance(surface, 0), np.linalg.norm(points, axis=1), atol=EXACT)

    def test_from_indices_positions_a_curve_and_the_boundary(self):
        points, faces = sheet()
        x, y = points[:, 0], points[:, 1]
        for source, expected in (
                ([0, 8], np.minimum(np.hypot(x, y), np.hypot(1 - x, y))),
                ([[0.3, 0.4, 0]], np.hypot(x - 0.3, y - 0.4)),
                (curve([(0.25, 0, 0), (0.25, 1, 0)]), np.abs(x - 0.25)),
                (None, np.minimum(np.minimum(x, 1 - x), np.minimum(y, 1 - y)))):
            np.testing.assert_allclose(distance((points, faces), source), expected, atol=EXACT)

    def test_stop_at_a_maximum_and_go_around_barriers(self):
        points, faces = sheet()
        far = distance((points, faces), 0, maximum_distance=0.5)
        near = np.hypot(points[:, 0], points[:, 1]) <= 0.5
        self.assertTrue(np.isfinite(far[near]).all() and np.isinf(far).any())
        middle = points[faces].mean(axis=1)
        wall = (np.abs(middle[:, 0] - 0.5625) < 0.0625) & (middle[:, 1] < 0.5)
        around = distance((points, faces), 0, barriers=wall)
        self.assertAlmostEqual(around[8], math.hypot(0.5, 0.5) + 0.125 + math.hypot(0.375, 0.5), delta=EXACT)

    def test_approximate_ones_are_smaller_by_the_fraction_at_most(self):
        points, faces = sheet(20)
        exact = np.linalg.norm(points - points[7], axis=1)
        near = distance((points, faces), 7, relative_error=0.1)
        self.assertTrue(np.all(near <= exact + EXACT) and np.all(near >= 0.9 * exact - EXACT))

    def test_of_a_refined_surface_begin_with_my_points(self):
        points, faces = sheet()
        refined = field((points, faces), 0, refine_mesh=True)
        np.testing.assert_array_equal(refined["points"][:81], points)
        self.assertGreater(len(refined["faces"]), len(faces))
        np.testing.assert_allclose(
            refined["GeodesicDistance"], np.linalg.norm(refined["points"], axis=1), atol=1e-7)

    def test_come_with_arrays_by_their_names(self):
        points, faces = sheet()
        result = field((points, faces), [0, 8], generate_source_ids=True, generate_gradients=True)
        np.testing.assert_array_equal(result["points"], points)
        np.testing.assert_array_equal(result["faces"], faces)
        self.assertEqual(set(result), {"points", "faces", "GeodesicDistance", "SourceId", "DistanceGradient"})
        self.assertEqual(result["SourceId"][7], 1)


    def test_come_with_coordinates_along_and_across_a_curve(self):
        points, faces = sheet()
        line = curve([(0.25, 0.5, 0), (0.75, 0.5, 0)])
        result = field((points, faces), line, generate_source_arc_length=True, generate_texture_coordinates=True,
                       texture_scale=1)
        x, y = points[:, 0], points[:, 1]
        foot = np.clip(x, 0.25, 0.75)
        along, across = foot - 0.25, np.where(y < 0.5, -1, 1) * np.hypot(x - foot, y - 0.5)
        np.testing.assert_allclose(result["SourceArcLength"], along, atol=EXACT)
        beside = np.abs(y - 0.5) > EXACT  # in line with the curve either side is right
        np.testing.assert_allclose(
            result["SourceTextureCoordinates"][beside], np.column_stack((along, across))[beside], atol=EXACT)

    def test_come_with_angles_around_a_point(self):
        points, faces = sheet()
        result = field((points, faces), [[0.3, 0.4, 0]], generate_source_angle=True)
        ahead, left, normal = result["SourceFrame"][0]
        np.testing.assert_allclose(normal, (0, 0, 1), atol=EXACT)
        angle, away = result["SourceAngle"][:, None], result["GeodesicDistance"][:, None]
        np.testing.assert_allclose(
            (0.3, 0.4, 0) + away * (np.cos(angle) * ahead + np.sin(angle) * left), points, atol=EXACT)


class Lines(unittest.TestCase):
    def test_of_a_contour_are_at_their_distances(self):
        lines = contour(sheet(), 0, [0.25, 0.5])
        self.assertEqual(sorted(lines["GeodesicDistance"]), [0.25, 0.5])
        for ids, value in zip(lines["lines"], lines["GeodesicDistance"]):
            np.testing.assert_allclose(np.linalg.norm(lines["points"][ids], axis=1), value, atol=1e-12)

    def test_of_paths_go_from_targets_to_the_source(self):
        points, faces = sheet()
        result = paths((points, faces), 0, targets=[80, 8])
        order = np.argsort(result["TargetId"])
        np.testing.assert_allclose(result["GeodesicDistance"][order], [math.sqrt(2), 1], atol=EXACT)
        for ids, target in zip(result["lines"], result["TargetId"]):
            np.testing.assert_allclose(result["points"][ids[0]], points[[80, 8][target]], atol=EXACT)
            np.testing.assert_allclose(result["points"][ids[-1]], 0, atol=EXACT)

    def test_of_paths_tell_where_they_end_on_a_curve(self):
        line = curve([(0.25, 0.5, 0), (0.75, 0.5, 0)])
        result = paths(sheet(), line, [(0.5, 0.9, 0), (0.375, 0.1, 0)],
                       generate_source_arc_length=True, generate_source_angle=True)
        order = np.argsort(result["TargetId"])
        np.testing.assert_allclose(result["SourceArcLength"][order], (0.25, 0.125), atol=EXACT)
        np.testing.assert_allclose(result["SourceAngle"][order], (math.pi / 2, -math.pi / 2), atol=EXACT)

    def test_a_closed_curve_comes_back(self):
        self.assertEqual(curve([(0, 0, 0), (1, 0, 0), (0, 1, 0)], closed=True).GetLines().GetConnectivityArray().GetNumberOfTuples(), 4)


class Matrix(unittest.TestCase):
    def test_has_a_row_a_target_and_a_column_a_source(self):
        points, faces = sheet()
        expected = np.linalg.norm(points[[0, 8, 80]][:, None] - points[[4, 40]][None], axis=2)
        np.testing.assert_allclose(matrix((points, faces), [4, 40], [0, 8, 80]), expected, atol=EXACT)
        each = matrix((points, faces), [4, 40])
        self.assertEqual(each.shape, (2, 2))
        np.testing.assert_allclose(np.diag(each), 0, atol=EXACT)


class Messages(unittest.TestCase):
    def test_what_is_wrong_is_raised(self):
        points, faces = sheet()
        for call, message in (
                (lambda: distance((points, [(0, 1, 99)]), 0), "99, but there are 81 points"),
                (lambda: distance((points, faces), 81), "there is no 81"),
                (lambda: distance((points[:, :2], faces), 0), r"\(number, 3\)"),
                (lambda: distance(octahedron(), None), "^The surface is closed.* Give a source.$"),
                (lambda: contour((points, faces), 0, [-1]), "Value 0 is -1")):
            with self.assertRaisesRegex(GeodesicError, message):
                call()
        with self.assertRaisesRegex(TypeError, "no property flavor"):
            distance((points, faces), 0, flavor=1)

    def test_what_looks_like_a_mistake_is_a_warning(self):
        with self.assertWarnsRegex(UserWarning, "^The source is up to 0.5 away"):
            distance(sheet(), [[0.5, 0.5, 0.5]])
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            distance(sheet(), [[0.5, 0.5, 0]])


class Package(unittest.TestCase):
    def test_has_a_version_and_help(self):
        self.assertRegex(geodesicdistance.__version__, r"^\d+\.\d+\.\d+$")
        for function in (contour, curve, distance, field, matrix, paths, geodesicdistance):
            self.assertTrue(re.search(r"\w", function.__doc__))


if __name__ == "__main__":
    unittest.main()
