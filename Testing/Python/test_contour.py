# SPDX-License-Identifier: BSD-3-Clause
"""Lines of equal distance as pvpython draws them, against shapes known in closed form."""

import unittest

import numpy as np
from paraview import simple

from geodesic_testing import data, load_plugin, plane, points, polyline

load_plugin()
GeodesicContour = simple.GeodesicContour


def lines(contour):
    """Of each line its value and its points."""
    output = data(contour)
    positions = points(output) if output.GetNumberOfPoints() else np.empty((0, 3))
    values = output.GetCellData().GetArray("GeodesicDistance")
    result = []
    for i in range(output.GetNumberOfCells()):
        ids = output.GetCell(i).GetPointIds()
        result.append((values.GetValue(i), positions[[ids.GetId(k) for k in range(ids.GetNumberOfIds())]]))
    return result


def length(line):
    return np.sum(np.linalg.norm(np.diff(line, axis=0), axis=1))


class Lines(unittest.TestCase):
    def test_round_a_point_are_circles_at_the_given_distances(self):
        source = simple.PointSource(NumberOfPoints=1, Radius=0, Center=(2, 1.5, 0))
        contour = GeodesicContour(Input=plane(), Source=source, Distances=[0.5, 1.25, 0.75])
        found = lines(contour)
        self.assertEqual([value for value, _ in found], [0.5, 0.75, 1.25])
        for value, line in found:
            np.testing.assert_allclose(np.linalg.norm(line - (2, 1.5, 0), axis=1), value, rtol=1e-12)
            np.testing.assert_array_equal(line[0], line[-1])
            self.assertAlmostEqual(length(line), 2 * np.pi * value, delta=1e-2)

    def test_the_default_is_one_value_a_tenth_of_the_longest_side_rounded(self):
        surface = plane()
        surface.UpdatePipeline()
        contour = GeodesicContour(Input=surface, Source=polyline([(1, 1, 0), (3, 2, 0)]))
        self.assertEqual(contour.Distances[0], 0.5)
        self.assertEqual(len(contour.Distances), 1)
        self.assertEqual(len(lines(contour)), 1)

    def test_of_the_boundary_need_no_source(self):
        contour = GeodesicContour(Input=plane(), SourceType="Surface Boundary", Distances=[0.3])
        (_, line), = lines(contour)
        self.assertAlmostEqual(length(line), 2 * (3.4 + 2.4), places=6)

    def test_have_as_many_points_as_the_chord_tolerance_asks_for(self):
        source = simple.PointSource(NumberOfPoints=1, Radius=0, Center=(2, 1.5, 0))
        contour = GeodesicContour(Input=plane((2, 2)), Source=source, Distances=[1])
        counts = []
        contour.ToleranceIsAbsolute = 1
        for tolerance in (1e-2, 1e-4, 1e-6):
            contour.AbsoluteChordTolerance = tolerance
            (_, line), = lines(contour)
            middles = 0.5 * (line[1:] + line[:-1])
            self.assertLessEqual(np.max(1 - np.linalg.norm(middles - (2, 1.5, 0), axis=1)), tolerance)
            counts.append(len(line))
        self.assertLess(counts[0], counts[1])
        self.assertLess(counts[1], counts[2])

    def test_signed_distances_are_on_one_side_of_the_curve(self):
        source = polyline([(0.5, 1.5, 0), (3.5, 1.5, 0)])
        contour = GeodesicContour(Input=plane(), Source=source, Distances=[-0.5, 0.25])
        contour.SignedDistances = 1
        found = lines(contour)
        self.assertEqual([value for value, _ in found], [-0.5, 0.25])
        for value, line in found:
            self.assertTrue(np.all((line[:, 1] - 1.5) * value > -1e-6))
            self.assertAlmostEqual(length(line), 3 + np.pi * abs(value), delta=1e-3)


if __name__ == "__main__":
    unittest.main()
