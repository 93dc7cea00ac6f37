# SPDX-License-Identifier: BSD-3-Clause
"""Approximation and refinement as pvpython sees them: every property moved, the bounds kept."""

import unittest

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_DOUBLE, VTK_FLOAT

from geodesic_testing import (FLOAT, assert_close, data, distance_to_segments, distances,
                              load_plugin, messages, plane, points, polyline)

GeodesicDistanceField = load_plugin()

BENT = [(0.31, 0.42, 0), (1.93, 2.21, 0), (2.57, 0.64, 0), (3.71, 1.13, 0)]
DIAGONAL = 5.0


def triangles(field):
    return vtk_to_numpy(data(field).GetPolys().GetConnectivityArray()).reshape(-1, 3)


def bound(field, name="InterpolationErrorBound"):
    return data(field).GetFieldData().GetArray(name).GetTuple1(0)


def measured(field):
    """The largest difference between the interpolant and the distance, at points of triangles."""
    corners, values = points(data(field))[triangles(field)], distances(field)[triangles(field)]
    worst = 0.0
    for weights in np.random.default_rng(1).dirichlet((1, 1, 1), 30):
        positions = np.einsum("k,tkj->tj", weights, corners)
        worst = max(worst, np.max(np.abs(values @ weights - distance_to_segments(positions, BENT))))
    return worst


def longest_at_borders(field, limit=np.inf):
    """The longest edge of the triangles within a limit whose corners are nearest to different sources."""
    sources = vtk_to_numpy(data(field).GetPointData().GetArray("SourceId"))[triangles(field)]
    corners = points(data(field))[triangles(field)]
    edges = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    near = distances(field)[triangles(field)].min(axis=1) < limit
    return edges[near & (sources.min(axis=1) < sources.max(axis=1))].max()


class Refinement(unittest.TestCase):
    def field(self, **properties):
        return GeodesicDistanceField(
            Input=plane((8, 6)), Source=polyline(BENT), **properties)

    def test_defaults_are_those_of_the_readme(self):
        field = self.field()
        for name, value in (("Accuracy", "Exact"), ("RelativeError", 0.001), ("RefineMesh", 1),
                            ("RefinementTolerance", 0.001), ("ToleranceIsAbsolute", 0),
                            ("AbsoluteRefinementTolerance", 1),
                            ("MaximumNumberOfCells", 50000000),
                            ("OutputPointsPrecision", "Default")):
            self.assertEqual(getattr(field, name), value, name)

    def test_every_property_has_help_text(self):
        field = self.field()
        for name in field.ListProperties():
            text = field.GetProperty(name).GetDocumentation()
            self.assertTrue(text and text.GetDescription().strip(), name)

    def test_the_interpolant_is_within_the_tolerance(self):
        field = self.field()
        counts = []
        for tolerance in (0.01, 0.001, 0.0002):
            field.RefinementTolerance = tolerance
            self.assertLessEqual(measured(field), bound(field) + FLOAT)
            self.assertLessEqual(bound(field), tolerance * DIAGONAL)
            assert_close(distances(field), distance_to_segments(points(data(field)), BENT), FLOAT)
            counts.append(data(field).GetNumberOfCells())
        self.assertEqual(counts, sorted(set(counts)))

    def test_an_absolute_tolerance_is_in_the_units_of_the_surface(self):
        relative = self.field(RefinementTolerance=0.002)
        absolute = self.field(ToleranceIsAbsolute=1, AbsoluteRefinementTolerance=0.002 * DIAGONAL)
        self.assertEqual(
            data(relative).GetNumberOfCells(), data(absolute).GetNumberOfCells())
        self.assertLessEqual(measured(absolute), bound(absolute) + FLOAT)
        self.assertLessEqual(bound(absolute), 0.002 * DIAGONAL)

        absolute.AbsoluteRefinementTolerance = 0.0007
        self.assertLessEqual(measured(absolute), bound(absolute) + FLOAT)
        self.assertLessEqual(bound(absolute), 0.0007)
        self.assertGreater(data(absolute).GetNumberOfCells(), data(relative).GetNumberOfCells())
        before = data(absolute).GetNumberOfCells()
        absolute.RefinementTolerance = 0.5
        self.assertEqual(data(absolute).GetNumberOfCells(), before)

    def test_borders_between_sources_are_as_narrow_as_the_tolerance(self):
        two = simple.PolyPointSource(Points=[0.9, 0.8, 0, 3.1, 1.9, 0])
        exact = {"Source": two, "RefinementTolerance": 0.01, "GenerateSourceIds": 1}
        for properties in (exact, {**exact, "Accuracy": "Approximate"}, {**exact, "MaximumDistance": 1.5}):
            field = GeodesicDistanceField(Input=plane((8, 6)), **properties)
            plain, limit = data(field).GetNumberOfCells(), field.MaximumDistance or np.inf
            self.assertGreater(longest_at_borders(field, limit), 0.01 * DIAGONAL)
            field.RefineSourceBorders = 1
            self.assertLessEqual(longest_at_borders(field, limit), 0.01 * DIAGONAL * (1 + 1e-6))
            self.assertGreater(data(field).GetNumberOfCells(), plain)
            self.assertLess(data(field).GetNumberOfCells(), plain + 3000)
            self.assertLessEqual(bound(field), 0.01 * DIAGONAL)

    def test_without_refinement_the_points_are_those_of_the_input(self):
        field = self.field(RefineMesh=0)
        self.assertEqual(data(field).GetNumberOfPoints(), 63)
        self.assertFalse(data(field).GetCellData().HasArray("OriginalCellIds"))
        self.assertEqual(bound(field), np.inf)

    def test_original_cells_are_given_where_refined(self):
        field = self.field()
        originals = vtk_to_numpy(data(field).GetCellData().GetArray("OriginalCellIds"))
        self.assertEqual(set(originals), set(range(48)))

    def test_the_cap_is_kept_with_a_warning(self):
        field = self.field(RefinementTolerance=1e-9, MaximumNumberOfCells=2000)
        with messages() as window:
            field.UpdatePipeline()
        self.assertIn("MaximumNumberOfCells (2000) is reached", window.GetOutput())
        self.assertLessEqual(data(field).GetNumberOfCells(), 2000)
        self.assertGreater(bound(field), 1e-9 * DIAGONAL)

    def test_a_cap_of_0_is_none_and_one_below_the_surface_leaves_it_as_it_is(self):
        field = self.field(RefinementTolerance=0.0002)
        whole = data(field).GetNumberOfCells()
        field.MaximumNumberOfCells = 0
        self.assertEqual(data(field).GetNumberOfCells(), whole)

        field.MaximumNumberOfCells = 95
        with messages() as window:
            field.UpdatePipeline()
        self.assertIn("more than MaximumNumberOfCells (95)", window.GetOutput())
        self.assertEqual(data(field).GetNumberOfCells(), 96)
        self.assertEqual(bound(field), np.inf)
        assert_close(distances(field), distance_to_segments(points(data(field)), BENT), FLOAT)

    def test_up_to_the_maximum_distance_the_interpolant_is_within_the_tolerance(self):
        field = self.field(MaximumDistance=0.4)
        values = distances(field)[triangles(field)]
        near = values.min(axis=1) < 0.4
        middles = points(data(field))[triangles(field)][near].mean(axis=1)
        np.testing.assert_allclose(values[near].mean(axis=1), distance_to_segments(middles, BENT),
                                   rtol=0, atol=bound(field) + FLOAT)
        self.assertLessEqual(bound(field), 0.001 * DIAGONAL)
        self.assertTrue(0 < near.sum() < len(near))

    def test_properties_moved_back_give_the_first_output_again(self):
        field = self.field(RelativeError=0.1, RefinementTolerance=0.02)
        first, cells = distances(field).copy(), triangles(field).copy()
        for name, value, before in (
                ("Accuracy", "Approximate", "Exact"), ("RefineMesh", 0, 1),
                ("RefinementTolerance", 0.01, 0.02), ("ToleranceIsAbsolute", 1, 0),
                ("MaximumNumberOfCells", 97, 50000000), ("MaximumDistance", 0.5, 0),
                ("SourceType", "Surface Boundary", "Source Curve")):
            setattr(field, name, value)
            with messages():
                moved = distances(field)
            self.assertFalse(len(moved) == len(first) and np.array_equal(moved, first), name)
            setattr(field, name, before)
            np.testing.assert_array_equal(distances(field), first, name)
            np.testing.assert_array_equal(triangles(field), cells, name)

    def test_data_of_points_and_cells_is_carried_over(self):
        surface = simple.Calculator(
            Input=plane((8, 6)), ResultArrayName="Slope", Function="2*coordsX - coordsY")
        field = GeodesicDistanceField(Input=surface, Source=polyline(BENT))
        positions = points(data(field))
        np.testing.assert_allclose(
            distances(field, "Slope"), 2 * positions[:, 0] - positions[:, 1], atol=1e-5)

    def test_points_have_the_precision_that_is_asked_for(self):
        ball = simple.Sphere()
        field = GeodesicDistanceField(Input=ball, Source=polyline([(0.4, 0.1, 0.2), (0.1, 0.4, 0.3)]))
        for precision, refined, whole in (("Default", VTK_DOUBLE, VTK_FLOAT),
                                          ("Single", VTK_FLOAT, VTK_FLOAT),
                                          ("Double", VTK_DOUBLE, VTK_DOUBLE)):
            field.OutputPointsPrecision = precision
            for field.RefineMesh, expected in ((1, refined), (0, whole)):
                field.UpdatePipeline()
                self.assertEqual(data(field).GetPoints().GetDataType(), expected, precision)

    def test_a_tolerance_that_is_not_positive_is_refused(self):
        for name, flag in (("RefinementTolerance", 0), ("AbsoluteRefinementTolerance", 1)):
            for value in (0, -1, float("nan")):
                field = self.field(ToleranceIsAbsolute=flag)
                setattr(field, name, value)
                with messages() as window:
                    field.UpdatePipeline()
                self.assertIn(name + " is not a positive number", window.GetOutput())
                self.assertEqual(data(field).GetNumberOfPoints(), 0)


class Approximation(unittest.TestCase):
    def test_the_error_is_within_the_bound_and_that_within_the_request(self):
        ball = simple.Sphere(ThetaResolution=60, PhiResolution=60)
        source = polyline([(0.4, 0.1, 0.2), (0.1, 0.4, 0.3), (-0.3, 0.3, 0.1)])
        field = GeodesicDistanceField(Input=ball, Source=source, RefineMesh=0)
        exact = distances(field).copy()
        self.assertEqual(bound(field, "RelativeErrorBound"), 0)
        field.Accuracy = "Approximate"
        for epsilon in (0.1, 0.001):
            field.RelativeError = epsilon
            reported = bound(field, "RelativeErrorBound")
            self.assertTrue(0 < reported <= epsilon, reported)
            self.assertTrue(np.all(distances(field) <= exact * (1 + 1e-9)))
            self.assertTrue(np.all(exact - distances(field) <= (reported + 1e-9) * exact))

        field.RelativeError = 0
        np.testing.assert_array_equal(distances(field), exact)

    def test_a_refined_field_is_within_both_bounds_of_the_distance(self):
        ring = [(2 + np.cos(angle), 1.5 + np.sin(angle), 0)
                for angle in np.linspace(0, 2 * np.pi, 61)]
        for epsilon in (0.1, 0.001):
            field = GeodesicDistanceField(Input=plane((8, 6)), Source=polyline(ring[:-1], closed=True),
                                          Accuracy="Approximate", RelativeError=epsilon)
            relative, absolute = bound(field, "RelativeErrorBound"), bound(field)
            self.assertTrue(0 < relative <= epsilon, relative)
            self.assertTrue(0 < absolute <= 0.001 * DIAGONAL, absolute)
            corners, values = points(data(field))[triangles(field)], distances(field)[triangles(field)]
            for weights in np.random.default_rng(2).dirichlet((1, 1, 1), 30):
                exact = distance_to_segments(np.einsum("k,tkj->tj", weights, corners), ring)
                excess = np.abs(values @ weights - exact) - relative * exact - absolute
                self.assertLessEqual(np.max(excess), FLOAT)

    def test_a_relative_error_that_is_negative_or_nan_is_refused(self):
        for value in (-0.1, float("nan")):
            field = GeodesicDistanceField(Input=plane(), Source=polyline(BENT),
                                          Accuracy="Approximate", RelativeError=value)
            with messages() as window:
                field.UpdatePipeline()
            self.assertIn("RelativeError", window.GetOutput())
            self.assertEqual(data(field).GetNumberOfPoints(), 0)


if __name__ == "__main__":
    unittest.main()
