# SPDX-License-Identifier: BSD-3-Clause
"""Regions of faces, and sets of points: their table by labels, and masks of faces as sources."""

import unittest
import warnings

import numpy as np

from geodesicdistance import GeodesicError, Surface, contour, distance, field, matrix, paths
from test_functions import EXACT, as_poly_data, octahedron, sheet
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet

# Rectangles on the sheet's lines, and their labels: two are of one region, two touch in a corner.
RECTANGLES = ((40, (0, 0), (0.25, 0.25)), (7, (0.5, 0.625), (0.75, 0.875)), (3, (0.75, 0), (1, 0.125)),
              (3, (0.375, 0.125), (0.5, 0.25)), (12, (0.5, 0.25), (0.625, 0.375)))
LABELS = (3, 7, 12, 40)


def apart(low, high, other_low, other_high):
    """The distance of two rectangles."""
    return np.linalg.norm(np.max([np.subtract(other_low, high), np.subtract(low, other_high), (0, 0)], axis=0))


def truth(a, b):
    return min(apart(*one[1:], *other[1:]) for one in RECTANGLES if one[0] == a
               for other in RECTANGLES if other[0] == b)


def to_region(points, label):
    return np.array([min(apart(low, high, p[:2], p[:2]) for of, low, high in RECTANGLES if of == label)
                     for p in points])


def labels_at(points):
    """-3 where there is no rectangle."""
    labels = np.full(len(points), -3)
    for label, low, high in RECTANGLES:
        labels[((points[:, :2] >= low) & (points[:, :2] <= high)).all(axis=1)] = label
    return labels


def labelled_sheet():
    points, faces = sheet()
    return (points, faces), labels_at(points[faces].mean(axis=1))


class Tables(unittest.TestCase):
    def test_by_labels_of_faces_have_the_distances_of_regions(self):
        surface, labels = labelled_sheet()
        expected = [[truth(a, b) for a in LABELS] for b in LABELS]
        for given in (surface, as_poly_data(surface)):
            table = matrix(given, labels=labels)
            np.testing.assert_allclose(table, expected, atol=EXACT)
            np.testing.assert_array_equal(table, table.T)
        np.testing.assert_allclose(matrix(surface, labels=labels.tolist()), expected, atol=EXACT)
        table = matrix(surface, labels=np.where(labels == 7, -1, labels).astype(np.int8))
        np.testing.assert_allclose(table, np.delete(np.delete(expected, 1, axis=0), 1, axis=1), atol=EXACT)

    def test_by_labels_of_points_have_the_distances_of_the_nearest_points(self):
        points, faces = sheet()
        labels = np.where(np.arange(81) % 7 == 0, np.arange(81) % 5, -1)
        between = np.linalg.norm(points[:, None] - points, axis=2)
        expected = [[between[labels == a][:, labels == b].min() for b in range(5)] for a in range(5)]
        np.testing.assert_allclose(matrix((points, faces), labels=labels), expected, atol=EXACT)

    def test_are_infinite_where_no_path_leads_and_beyond_the_maximum(self):
        (points, faces), labels = labelled_sheet()
        two = np.concatenate((points, points + (0, 0, 3))), np.concatenate((faces, faces + len(points)))
        both = np.concatenate((labels, np.where(labels < 0, labels, labels + 100)))
        table = matrix(two, labels=both)
        np.testing.assert_array_equal(np.isinf(table), np.kron([[0, 1], [1, 0]], np.ones((4, 4))))
        expected = matrix((points, faces), labels=labels)
        limited = matrix((points, faces), labels=labels, maximum_distance=0.3)
        np.testing.assert_allclose(limited, np.where(expected <= 0.3, expected, np.inf), atol=EXACT)

    def test_have_infinity_for_labels_of_points_that_no_face_uses(self):
        points, faces = sheet()
        more = np.concatenate((points, [(0., 0, 9)])), faces
        labels = np.full(82, -1)
        labels[[0, 8, 81]] = 5, 9, 7
        np.testing.assert_allclose(matrix(more, labels=labels),
                                   [[0, np.inf, 1], [np.inf, np.inf, np.inf], [1, np.inf, 0]], atol=EXACT)
        with self.assertRaisesRegex(GeodesicError, "^No point with a label belongs to a face"):
            matrix(more, labels=np.where(np.arange(82) == 81, 3, -1))

    def test_of_blocks_are_those_of_the_whole(self):
        (points, faces), labels = labelled_sheet()
        blocks = vtkMultiBlockDataSet()
        for i, part in enumerate((faces[:50], faces[50:])):
            blocks.SetBlock(i, as_poly_data((points, part)))
        np.testing.assert_allclose(matrix(blocks, labels=labels), matrix((points, faces), labels=labels), atol=EXACT)

    def test_leave_later_calls_as_they_are(self):
        surface, labels = labelled_sheet()
        kept = Surface(surface)
        before = kept.matrix([0, 40], [8, 80])
        kept.matrix(labels=labels)
        np.testing.assert_array_equal(kept.matrix([0, 40], [8, 80]), before)
        np.testing.assert_array_equal(kept.matrix(pairs=[(0, 8)]), matrix(surface, pairs=[(0, 8)]))

    def test_of_wrong_labels_are_errors(self):
        surface, labels = labelled_sheet()
        for given, message in (
                (labels[1:], "^labels has 127 integers, but the surface has 81 points and 128 faces"),
                (labels.astype(float), "^labels has one integer for each point or for each face; float64"),
                (labels == 3, "bool are given"), (labels[:, None], r"in the shape \(128, 1\)"),
                (np.full(128, -1), "^labels has no region: all are negative"), ([], "one integer"),
                ({1, 2}, "given as a set")):
            with self.subTest(message=message), self.assertRaisesRegex(GeodesicError, message):
                matrix(surface, labels=given)
        for given in (dict(source=0), dict(targets=0), dict(pairs=[(0, 1)]), dict(boundary=True),
                      dict(source_ids=[1])):
            with self.subTest(given=given), self.assertRaisesRegex(GeodesicError, "^labels are the source and the"):
                matrix(surface, labels=labels, **given)

    def test_of_as_many_points_as_faces_are_errors(self):
        points, faces = octahedron()
        more = np.concatenate((points, points[:2] + 9)), faces
        for ask in (lambda: matrix(more, labels=np.arange(8)), lambda: distance(more, np.arange(8) == 3)):
            with self.assertRaisesRegex(GeodesicError, "has 8 values, but the surface has as many points as faces"):
                ask()
        with self.assertRaisesRegex(GeodesicError, "Give points by their indices, or append a point"):
            distance(more, np.arange(8) == 3)
        more = np.concatenate((points, points + 9)), faces
        self.assertEqual(matrix(more, labels=np.arange(8)).shape, (8, 8))


class Masks(unittest.TestCase):
    def test_of_faces_are_regions_as_sources(self):
        surface, labels = labelled_sheet()
        for label in LABELS:
            expected = to_region(surface[0], label)
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                found = distance(surface, labels == label)
            np.testing.assert_allclose(found, expected, atol=EXACT)
            np.testing.assert_array_equal(found[expected == 0], 0)
        whole = distance(octahedron(), np.ones(8, bool))
        np.testing.assert_array_equal(whole, 0)

    def test_of_points_stay_points(self):
        points, faces = sheet()
        mask = labels_at(points) == 3
        expected = np.linalg.norm(points[:, None] - points[mask], axis=2).min(axis=1)
        np.testing.assert_allclose(distance((points, faces), mask), expected, atol=EXACT)

    def test_of_faces_are_sources_of_all_functions(self):
        surface, labels = labelled_sheet()
        mask = labels == 7
        closest = field(surface, mask, generate_closest_points=True)["ClosestSourcePoint"]
        np.testing.assert_allclose(closest, np.clip(surface[0], (0.5, 0.625, 0), (0.75, 0.875, 0)), atol=EXACT)
        lengths = paths(surface, mask, [0, 8])["GeodesicDistance"]
        np.testing.assert_allclose(lengths, to_region(surface[0][[0, 8]], 7), atol=EXACT)
        np.testing.assert_allclose(matrix(surface, mask, [0, 8])[:, 0], lengths, atol=EXACT)
        line = contour(surface, mask, 0.1)
        np.testing.assert_allclose(to_region(line["points"], 7), 0.1, atol=EXACT)

    def test_of_faces_are_measured_beside_barriers(self):
        (points, faces), labels = labelled_sheet()
        barriers = points[faces].mean(axis=1)[:, 0] > 0.875
        found = distance((points, faces), (labels == 40) | barriers, barriers=barriers)
        expected = np.where(points[:, 0] > 0.875, np.inf, to_region(points, 40))
        np.testing.assert_allclose(found, expected, atol=EXACT)
        with self.assertRaisesRegex(GeodesicError, "^All of the source lies in barriers"):
            distance((points, faces), barriers, barriers=barriers)

    def test_without_a_face_or_of_a_wrong_length_are_errors(self):
        surface, labels = labelled_sheet()
        with self.assertRaisesRegex(GeodesicError, "^The source is empty: give at least one face"):
            distance(surface, labels == 99)
        with self.assertRaisesRegex(GeodesicError, "True and False, in the shape .* 81 points"):
            distance(surface, (labels == 3)[1:])


if __name__ == "__main__":
    unittest.main()
