# SPDX-License-Identifier: BSD-3-Clause
"""Lines of equal distance as pvpython draws them, against shapes known in closed form."""

import unittest

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from geodesic_testing import data, load_plugin, messages, plane, points, polyline, tube

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

    def test_of_the_boundary_of_a_tube_are_rings(self):
        contour = GeodesicContour(Input=tube(), SourceType="Surface Boundary", Distances=[0.3, 0.9])
        found = lines(contour)
        self.assertEqual(sorted(value for value, _ in found), [0.3, 0.3, 0.9, 0.9])
        for value, line in found:
            np.testing.assert_allclose(np.abs(line[:, 1]), 1 - value, atol=1e-6)
            np.testing.assert_array_equal(line[0], line[-1])

    def test_at_zero_are_the_source(self):
        curve = [(0.5, 0.5, 0), (3.5, 1.25, 0)]
        contour = GeodesicContour(Input=plane(), Source=polyline(curve), Distances=[0])
        (value, line), = lines(contour)
        self.assertEqual(value, 0)
        self.assertAlmostEqual(length(line), np.hypot(3, 0.75), places=6)

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

    def test_wrong_distances_are_an_error_that_says_so(self):
        source = polyline([(1, 1, 0), (3, 2, 0)])
        for wrong, words in (([], "no value"), ([-1], "Value 0 is -1"), ([float("nan")], "nan")):
            contour = GeodesicContour(Input=plane(), Source=source, Distances=[1])
            contour.Distances = wrong
            with messages() as said:
                contour.UpdatePipeline()
            self.assertIn(words, said.GetOutput())
            self.assertEqual(data(contour).GetNumberOfPoints(), 0)

    def test_values_stand_at_points_too(self):
        source = polyline([(1, 1, 0), (3, 2, 0)])
        output = data(GeodesicContour(Input=plane(), Source=source, Distances=[0.1, 0.2]))
        values = vtk_to_numpy(output.GetPointData().GetArray("GeodesicDistance"))
        self.assertEqual(set(values), {0.1, 0.2})


if __name__ == "__main__":
    unittest.main()
