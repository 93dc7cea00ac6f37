# SPDX-License-Identifier: BSD-3-Clause
"""Contours, paths and the source on the surface come up as whole lines in one color, on a surface in its own
colors or in stripes; distances of a contour begin with a round one and go up to the largest one.

usage: pvpython --dr test_lines.py
"""

import pathlib
import tempfile
import unittest

import numpy as np
from paraview import simple

from geodesic_testing import load_plugin, plane, polyline, view_of
from pixels import read_pixels

load_plugin()
SIDE = [(0, 0, 0), (0, 3, 0)]


def is_line(colors):
    """Where pixels are greener than any stripe or surface, or cyan."""
    red, green, blue = np.moveaxis(colors, -1, 0)
    return (green > 1.25 * red) & (green > 0.7 * blue)


class Lines(unittest.TestCase):
    def setUp(self):
        self.view = view_of(self)

    def assert_whole(self, what, across):
        """The line goes up from the bottom of the view, its pixels at every height as many as across."""
        display = simple.Show(what, self.view)
        self.assertFalse(display.ColorArrayName[1])
        with tempfile.TemporaryDirectory() as folder:
            picture = pathlib.Path(folder) / "lines.png"
            simple.SaveScreenshot(str(picture), self.view, ImageResolution=self.view.ViewSize)
            pixels = is_line(read_pixels(picture)).sum(axis=1)
        heights = np.flatnonzero(pixels)
        self.assertGreater(len(heights), 100)
        whole = pixels[heights[0] + 6:heights[-1] - 6]
        self.assertTrue(np.all((across[0] <= whole) & (whole <= across[1])), whole)

    def look_at(self, shown, position):
        simple.Show(shown, self.view)
        self.view.CameraPosition = position
        self.view.CameraFocalPoint = (2, 1.5, 0)
        self.view.CameraViewUp = (0, 1, 0)
        simple.ResetCamera(self.view)

    def test_a_point_is_a_whole_ball(self):
        surface = simple.Sphere(Radius=70, ThetaResolution=100, PhiResolution=100)
        start = simple.PointSource(NumberOfPoints=1, Radius=0)
        field = simple.GeodesicDistanceField(Input=surface, Source=start)
        simple.Show(field, self.view)
        display = simple.Show(simple.OutputPort(field, 1), self.view)
        disk = np.pi / 4 * display.PointSize ** 2
        for direction in ((-1, 0, 0), (-0.7, 0.7, 0.1), (-0.9, 0.3, 0.3), (-0.5, 0.2, 0.8)):
            start.Center = 70 * np.array(direction) / np.linalg.norm(direction)
            self.view.CameraPosition, self.view.CameraFocalPoint = (-400, 120, 140), (0, 0, 0)
            with tempfile.TemporaryDirectory() as folder:
                picture = pathlib.Path(folder) / "ball.png"
                simple.SaveScreenshot(str(picture), self.view, ImageResolution=self.view.ViewSize)
                pixels = is_line(read_pixels(picture)).sum()
            self.assertTrue(0.6 * disk < pixels < 1.2 * disk, (direction, pixels, disk))

    def test_are_whole_from_above_and_aslant(self):
        surface, source = plane(), polyline([(1.03, 0, 0), (1.07, 3, 0)])
        lines = (
            simple.GeodesicContour(Input=surface, Source=polyline(SIDE), Distances=[1.5]),
            simple.GeodesicPaths(Input=surface, Source=polyline([(2.1, 0, 0)] * 2), Targets=polyline([(1.9, 3, 0)] * 2)),
            simple.OutputPort(simple.GeodesicDistanceField(Input=surface, Source=source), 1))
        for line in lines:
            for shown in (surface, simple.GeodesicDistanceField(Input=surface, Source=polyline(SIDE))):
                for position in ((2, 1.5, 9), (-3, -2, 4)):
                    self.look_at(shown, position)
                    self.assert_whole(line, (3, 9))
                    simple.HideAll(self.view)

    def test_are_whole_on_a_ball(self):
        ball = simple.Sphere(ThetaResolution=60, PhiResolution=40, Radius=1)
        middle = polyline([(0, np.cos(t), np.sin(t)) for t in np.linspace(-1.5, 1.5, 100)])
        field = simple.GeodesicDistanceField(Input=ball, Source=middle)
        self.look_at(field, (0, 0, 9))
        self.view.CameraFocalPoint = (0, 0, 0)
        simple.ResetCamera(self.view)
        self.assert_whole(simple.OutputPort(field, 1), (3, 9))

    def test_what_the_user_sets_stays(self):
        contour = simple.GeodesicContour(Input=plane(), Source=polyline(SIDE), Distances=[0.5])
        display = simple.Show(contour, self.view)
        display.LineWidth = 2
        contour.Distances = [0.7]
        self.assertEqual(simple.Show(contour, self.view).LineWidth, 2)


class Distances(unittest.TestCase):
    def range_of(self, contour):
        values = contour.SMProxy.GetProperty("Distances").GetDomain("range")
        return values.GetMinimum(0), values.GetMaximum(0)

    def test_begin_with_a_round_number(self):
        for size, expected in ((1, 0.1), (0.155699, 0.02), (31, 5)):
            surface = simple.Plane(Point1=(-0.5 + size, -0.5, 0))
            surface.Point2 = (-0.5, -0.5 + size, 0)
            surface.UpdatePipeline()
            contour = simple.GeodesicContour(Input=surface)
            self.assertEqual(list(contour.Distances), [expected])

    def test_that_are_asked_for_are_not_rounded(self):
        surface = plane()
        surface.UpdatePipeline()
        self.assertEqual(list(simple.GeodesicContour(Input=surface, Distances=[0.37]).Distances), [0.37])

    def test_of_a_series_go_up_to_the_largest_one(self):
        surface, source = plane(), polyline([(1, 0, 0), (1, 3, 0)])
        surface.UpdatePipeline()
        contour = simple.GeodesicContour(Input=surface, Source=source)
        self.assertEqual(self.range_of(contour), (0, 4))  # the longest side
        other = simple.GeodesicDistanceField(Input=surface, Source=polyline(SIDE), MaximumDistance=0.5)
        other.UpdatePipeline()
        self.assertLess(self.range_of(contour)[1], 1)
        simple.GeodesicDistanceField(Input=surface, Source=source).UpdatePipeline()
        low, high = self.range_of(contour)
        self.assertEqual(low, 0)
        self.assertAlmostEqual(high, 3, places=6)
        self.assertAlmostEqual(self.range_of(simple.GeodesicContour(Input=surface, Source=source))[1], 3, places=6)


if __name__ == "__main__":
    unittest.main()
