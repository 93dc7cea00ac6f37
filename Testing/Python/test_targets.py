# SPDX-License-Identifier: BSD-3-Clause
"""Paths and matrices as pvpython sees them, against distances known in closed form."""

import unittest

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from geodesic_testing import FLOAT, data, load_plugin, messages, plane, points, polyline

load_plugin()

CURVE = [(0.5, 0.25, 0), (0.5, 2.75, 0)]
TARGETS = [(3.5, 1.25, 0), (0.25, 2.0, 0), (2.125, 0.5, 0), (0.5, 1.5, 0)]


def to_curve(positions):
    """In the plane, for points between the curve's ends."""
    return np.abs(positions[:, 0] - 0.5)


def lines(output):
    """The points of each line."""
    cells, positions = output.GetLines(), points(output)
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    ids = vtk_to_numpy(cells.GetConnectivityArray())
    return [positions[ids[a:b]] for a, b in zip(offsets, offsets[1:])]


def cell_array(output, name):
    return vtk_to_numpy(output.GetCellData().GetArray(name))


def columns(table):
    return {table.GetColumnName(i): vtk_to_numpy(table.GetColumn(i))
            for i in range(table.GetNumberOfColumns())}


class Paths(unittest.TestCase):
    def test_paths_in_the_plane_are_straight_and_their_arrays_tell_of_them(self):
        paths = simple.GeodesicPaths(
            Input=plane(), Source=polyline(CURVE), Targets=polyline(TARGETS))
        output = data(paths)
        expected = to_curve(np.array(TARGETS))
        self.assertEqual(output.GetNumberOfLines(), len(TARGETS))
        np.testing.assert_array_equal(cell_array(output, "TargetId"), range(len(TARGETS)))
        np.testing.assert_array_equal(cell_array(output, "SourceId"), 0)
        np.testing.assert_allclose(cell_array(output, "TargetSnapDistance"), 0, atol=FLOAT)
        np.testing.assert_allclose(cell_array(output, "GeodesicDistance"), expected, atol=FLOAT)
        for line, target in zip(lines(output), TARGETS):
            np.testing.assert_allclose(line[0], target, atol=FLOAT)
            np.testing.assert_allclose(line[:, 1], target[1], atol=FLOAT)
            np.testing.assert_allclose(line[-1, 0], 0.5, atol=FLOAT)
        left = vtk_to_numpy(output.GetPointData().GetArray("GeodesicDistance"))
        np.testing.assert_allclose(left, to_curve(points(output)), atol=FLOAT)
        self.assertEqual(output.GetPointData().GetScalars().GetName(), "GeodesicDistance")

    def test_to_the_boundary_no_source_is_needed(self):
        paths = simple.GeodesicPaths(
            Input=plane(), Targets=polyline(TARGETS), SourceType="Surface Boundary")
        x, y = np.array(TARGETS).T[:2]
        expected = np.min([x, 4 - x, y, 3 - y], axis=0)
        np.testing.assert_allclose(
            cell_array(data(paths), "GeodesicDistance"), expected, atol=FLOAT)

    def test_without_targets_there_is_an_error(self):
        paths = simple.GeodesicPaths(Input=plane(), Source=polyline(CURVE), Targets=None)
        with messages() as said:
            paths.UpdatePipeline()
        self.assertIn("no targets", said.GetOutput())
        self.assertIn("port 2", said.GetOutput())


class Matrix(unittest.TestCase):
    def test_the_table_has_a_row_a_target_and_a_column_a_source(self):
        sources = simple.AppendGeometry(
            Input=[polyline(CURVE), polyline([(3, 0.5, 0), (3, 2.5, 0)])])
        matrix = simple.GeodesicDistanceMatrix(
            Input=plane(), Source=sources, Targets=polyline(TARGETS))
        table = columns(data(matrix))
        self.assertEqual(list(table), ["TargetId", "Source0", "Source1"])
        np.testing.assert_array_equal(table["TargetId"], range(len(TARGETS)))
        x = np.array(TARGETS)[:, 0]
        np.testing.assert_allclose(table["Source0"], np.abs(x - 0.5), atol=FLOAT)
        np.testing.assert_allclose(table["Source1"], np.abs(x - 3), atol=FLOAT)

    def test_without_targets_it_is_between_the_points_of_the_source(self):
        # The Point Source puts all points into one cell, which would be one source.
        cloud = simple.PointSource(NumberOfPoints=5, Radius=0.4, Center=(2, 1.5, 0))
        cells = simple.MaskPoints(Input=cloud, OnRatio=1, GenerateVertices=1, SingleVertexPerCell=1)
        flat = simple.Transform(Input=cells)
        flat.Transform.Scale = (1, 1, 0)
        matrix = simple.GeodesicDistanceMatrix(Input=plane(), Source=flat)
        table = columns(data(matrix))
        positions = points(data(flat))
        expected = np.linalg.norm(positions[:, None] - positions[None], axis=2)
        actual = np.array([table[f"Source{i}"] for i in range(5)])
        np.testing.assert_allclose(actual, expected, atol=FLOAT)

    def test_beyond_the_maximum_distance_it_is_infinite(self):
        matrix = simple.GeodesicDistanceMatrix(
            Input=plane(), Source=polyline(CURVE), Targets=polyline(TARGETS), MaximumDistance=1)
        self.assertEqual(matrix.MaximumDistance, 1)
        expected = to_curve(np.array(TARGETS))
        expected[expected > 1] = np.inf
        np.testing.assert_allclose(columns(data(matrix))["Source0"], expected, atol=FLOAT)


class Panel(unittest.TestCase):
    def test_every_property_has_a_help_text(self):
        for name in ("GeodesicPaths", "GeodesicDistanceMatrix"):
            proxy = getattr(simple, name)(Input=plane(), Source=polyline(CURVE))
            self.assertTrue(proxy.GetDocumentation().GetLongHelp())
            for prop in proxy.ListProperties():
                documentation = proxy.GetProperty(prop).GetDocumentation()
                self.assertTrue(documentation and documentation.GetDescription().strip(), prop)


if __name__ == "__main__":
    unittest.main()
