# SPDX-License-Identifier: BSD-3-Clause
"""What a newcomer to the plugin meets in pvpython: messages, numbers of the result, points that are
not reached, files and data that are not a surface.

usage: pvpython test_first_use.py FOLDER
"""

import csv
import pathlib
import sys
import unittest

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from geodesic_testing import (FLOAT, assert_close, data, distances, load_plugin, messages, plane,
                              points, polyline)

FOLDER = pathlib.Path(sys.argv.pop())
load_plugin()
LINE = [(2, 0, 0), (2, 3, 0)]

# As other programs write them: one strip of three triangles, with -1 where another would begin.
STRIPS = """ply
format ascii 1.0
element vertex 5
property float x
property float y
property float z
element tristrips 1
property list int int vertex_indices
end_header
0 0 0
0 1 0
1 0 0
1 1 0
2 0 0
5 0 1 2 3 4
"""


def all_filters(**inputs):
    """The four filters on the same inputs, with targets where they take some."""
    return [simple.GeodesicDistanceField(**inputs), simple.GeodesicContour(Distances=[0.1], **inputs),
            simple.GeodesicPaths(Targets=polyline(LINE), **inputs),
            simple.GeodesicDistanceMatrix(Targets=polyline(LINE), **inputs)]


def said_by(proxy):
    """What is shown to the user while the proxy is updated."""
    with messages() as window:
        proxy.UpdatePipeline()
    return window.GetOutput()


class Messages(unittest.TestCase):
    def assert_one_message(self, proxy, *words):
        said = said_by(proxy)
        self.assertEqual(said.count("ERROR:") + said.count("Warning:"), 1, said)
        for word in words:
            self.assertIn(word, said)
        self.assertNotIn("SetSource", said)
        self.assertNotIn("SetTargets", said)

    def test_without_a_source_one_message_says_what_to_choose(self):
        for proxy in all_filters(Input=plane()):
            self.assert_one_message(proxy, "choose a Source", "Source Type", "Surface Boundary")

    def test_without_targets_too(self):
        self.assert_one_message(
            simple.GeodesicPaths(Input=plane(), Source=polyline(LINE)), "Targets")

    def test_what_is_no_surface_needs_extract_surface(self):
        volume = simple.Wavelet(WholeExtent=[0, 3, 0, 3, 0, 3])
        for other in (volume, simple.Tetrahedralize(Input=volume)):
            for proxy in all_filters(Input=other, Source=polyline(LINE)):
                self.assert_one_message(proxy, "Extract Surface", "surface")
        shell = simple.AppendDatasets(Input=plane())  # an unstructured grid of quads
        for proxy in all_filters(Input=plane(), Source=volume):
            self.assert_one_message(proxy, "Extract Surface", "source")
        region = simple.GeodesicDistanceField(Input=plane(), Source=shell)
        self.assertEqual(said_by(region), "")
        self.assertEqual(distances(region).max(), 0.0)
        extracted = simple.GeodesicDistanceField(
            Input=simple.ExtractSurface(Input=shell), Source=polyline(LINE))
        assert_close(distances(extracted), np.abs(points(data(extracted))[:, 0] - 2), FLOAT)

    def test_a_file_of_triangle_strips_is_named_as_such(self):
        path = FOLDER / "geodesic-strips.ply"
        path.write_text(STRIPS)
        strips = simple.PLYReader(FileNames=[str(path)])
        self.assertEqual(data(strips).GetNumberOfPoints(), 5)
        for proxy in all_filters(Input=strips, Source=polyline(LINE)):
            self.assert_one_message(proxy, "5 points and no faces", "PLY", "triangle strips")

    def test_nothing_is_said_of_what_every_data_set_may_have(self):
        ball = simple.Sphere(ThetaResolution=20, PhiResolution=20)
        section = simple.Slice(Input=ball)
        for proxy in all_filters(Input=ball, Source=section)[:2]:
            self.assertEqual(said_by(proxy), "")
        for proxy in all_filters(Input=plane(), Source=polyline(LINE, closed=False)):
            self.assertEqual(said_by(proxy), "")

    def test_a_source_far_away_is_told_once_in_an_animation(self):
        curve = polyline([(2, 0, 0.5), (2, 3, 0)])
        field = simple.GeodesicDistanceField(Input=plane(), Source=curve)
        said = said_by(field)
        self.assertIn("up to 0.5 away from the surface (10 % of its size), at 1 of 2 points: "
                      "point 0 of cell 0.", said)
        for height in (0.6, 0.7, 2.0):
            curve.Points = [2, 0, height, 2, 3, 0]
            self.assertEqual(said_by(field), "")
            self.assertAlmostEqual(field.SourceSnapDistance, height, delta=FLOAT)
        simple.Delete(field)


class Numbers(unittest.TestCase):
    def test_they_are_attributes_right_after_an_update(self):
        curve = polyline([(2, 0, 0.01), (2, 3, 0.01)])
        field = simple.GeodesicDistanceField(Input=plane(), Source=curve)
        field.UpdatePipeline()
        self.assertAlmostEqual(field.SourceSnapDistance, 0.01, delta=FLOAT)
        self.assertGreater(field.WindowsPropagatedPerEdge, 0)
        self.assertEqual(field.RelativeErrorBound, 0)
        self.assertLessEqual(field.InterpolationErrorBound, 0.005)
        curve.Points = [2, 0, 0.02, 2, 3, 0.02]
        field.RefineMesh = 0
        field.UpdatePipeline()
        self.assertAlmostEqual(field.SourceSnapDistance, 0.02, delta=FLOAT)
        self.assertEqual(field.InterpolationErrorBound, np.inf)

    def test_they_are_those_of_the_field_data(self):
        field = simple.GeodesicDistanceField(
            Input=plane(), Source=polyline([(2, 0, 0.01), (2.5, 3, 0)]), Accuracy="Approximate")
        said = data(field).GetFieldData()
        for name in ("SourceLength", "SourceSnapDistance", "WindowsPropagatedPerEdge", "RelativeErrorBound",
                     "InterpolationErrorBound", "SeamPointsJoined"):
            self.assertEqual(getattr(field, name), said.GetArray(name).GetTuple1(0), name)

    def test_the_length_of_the_source_is_one(self):
        field = simple.GeodesicDistanceField(Input=plane(), Source=polyline([(0, 0, 0), (4, 3, 0)]))
        field.UpdatePipeline()
        self.assertAlmostEqual(field.SourceLength, 5, delta=FLOAT)

    def test_those_of_paths_are_their_number_and_lengths(self):
        paths = simple.GeodesicPaths(
            Input=plane(), Source=polyline([(0, 0, 0), (0, 3, 0)]), Targets=polyline([(1, 1, 0), (3, 2, 0), (2, 3, 0)]))
        paths.UpdatePipeline()
        self.assertEqual(paths.NumberOfPaths, 3)
        self.assertAlmostEqual(paths.ShortestLength, 1, delta=FLOAT)
        self.assertAlmostEqual(paths.LongestLength, 3, delta=FLOAT)

    def test_they_cannot_be_set(self):
        field = simple.GeodesicDistanceField(Input=plane())
        with self.assertRaises(Exception):
            field.SourceSnapDistance = 1


class Unreached(unittest.TestCase):
    def field(self, **asked):
        both = simple.AppendGeometry(Input=[plane(), plane(origin=(0, 0, 1))])
        return simple.GeodesicDistanceField(
            Input=both, Source=polyline(LINE), RefineMesh=0, **asked)

    def test_each_value_stands_where_no_path_leads(self):
        apart = points(data(self.field()))[:, 2] > 0.5
        for asked, expected in (({}, np.inf), ({"UnreachedValue": "NaN"}, np.nan),
                                ({"UnreachedValue": "Custom"}, -1),
                                ({"UnreachedValue": "Custom", "CustomUnreachedValue": 99.5}, 99.5)):
            field = self.field(GenerateSignedDistance=1, **asked)
            for name in ("GeodesicDistance", "SignedGeodesicDistance"):
                actual = distances(field, name)
                np.testing.assert_array_equal(actual[apart], np.full(apart.sum(), expected))
                self.assertTrue(np.all(np.abs(actual[~apart]) <= 2))

    def test_a_surface_warped_by_a_custom_value_is_finite(self):
        warped = simple.WarpByScalar(Input=self.field(UnreachedValue="Custom"),
                                     Scalars=["POINTS", "GeodesicDistance"])
        positions = points(data(warped))
        self.assertTrue(np.isfinite(positions).all())
        bounds = warped.GetDataInformation().GetBounds()
        self.assertTrue(np.isfinite(bounds).all(), bounds)
        infinite = simple.WarpByScalar(Input=self.field(), Scalars=["POINTS", "GeodesicDistance"])
        self.assertFalse(np.isfinite(points(data(infinite))).all())

    def test_ranges_on_the_information_panel(self):
        expected = {"Infinity": (0, np.inf), "NaN": (0, 2), "Custom": (-1, 2)}
        for value, (least, largest) in expected.items():
            field = self.field(UnreachedValue=value)
            field.UpdatePipeline()
            actual = field.PointData["GeodesicDistance"].GetRange()
            self.assertAlmostEqual(actual[0], least, delta=FLOAT)
            self.assertTrue(actual[1] == largest or abs(actual[1] - largest) < FLOAT, (value, actual))

    def test_csv_files_have_them_as_numbers_that_python_reads(self):
        for value, isRight in (("Infinity", np.isposinf), ("NaN", np.isnan),
                               ("Custom", lambda x: x == -1)):
            field = self.field(UnreachedValue=value)
            apart = points(data(field))[:, 2] > 0.5
            path = FOLDER / f"geodesic-{value}.csv"
            simple.SaveData(str(path), field)
            with open(path, newline="") as file:
                column = np.array([float(row["GeodesicDistance"]) for row in csv.DictReader(file)])
            np.testing.assert_array_equal(isRight(column), apart)

    def test_unused_points_can_be_left_out(self):
        # Threshold keeps the points of what it drops nowhere: a merge with them does.
        source = simple.ProgrammableSource(OutputDataSetType="vtkPolyData", Script="""
import vtkmodules.vtkCommonDataModel as d, vtkmodules.vtkCommonCore as c
p = c.vtkPoints()
for x in ((9, 9, 9), (0, 0, 0), (1, 0, 0), (8, 8, 8), (0, 1, 0)):
    p.InsertNextPoint(x)
cells = d.vtkCellArray()
cells.InsertNextCell(3)
for i in (1, 2, 4):
    cells.InsertCellPoint(i)
self.GetOutput().SetPoints(p)
self.GetOutput().SetPolys(cells)
""")
        curve = polyline([(0, 0, 0), (0, 1, 0)])
        field = simple.GeodesicDistanceField(Input=source, Source=curve, RefineMesh=0)
        self.assertEqual(said_by(field), "")
        np.testing.assert_array_equal(np.isinf(distances(field)), [True, False, False, True, False])
        field.RemoveUnusedPoints = 1
        np.testing.assert_allclose(distances(field), [0, 1, 0], atol=FLOAT)
        np.testing.assert_array_equal(points(data(field)), [(0, 0, 0), (1, 0, 0), (0, 1, 0)])


class Colors(unittest.TestCase):
    def test_after_a_failed_execution_the_next_one_is_colored_by_distance(self):
        view = simple.CreateView("RenderView")
        field = simple.GeodesicDistanceField(Input=plane())
        with messages():
            shown = simple.Show(field, view)
        self.assertFalse(shown.ColorArrayName[1])
        field.Source = polyline(LINE)
        field.UpdatePipeline()
        self.assertEqual(list(shown.ColorArrayName), ["POINTS", "GeodesicDistance"])

    def test_what_the_user_has_chosen_stays(self):
        view = simple.CreateView("RenderView")
        curve = polyline(LINE)
        field = simple.GeodesicDistanceField(Input=plane(), Source=curve)
        shown = simple.Show(field, view)
        self.assertEqual(list(shown.ColorArrayName), ["POINTS", "GeodesicDistance"])
        simple.ColorBy(shown, None)
        field.Source = None
        with messages():
            field.UpdatePipeline()
        field.Source = curve
        field.UpdatePipeline()
        self.assertFalse(shown.ColorArrayName[1])


if __name__ == "__main__":
    unittest.main()
