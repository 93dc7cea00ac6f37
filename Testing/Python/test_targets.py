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

    def test_each_piece_names_its_cell(self):
        """Cells are squares of 1/6, the number of one at (i / 6, j / 6) is i + 24 j."""
        paths = simple.GeodesicPaths(Input=plane(), Source=polyline(CURVE), Targets=polyline(TARGETS))
        self.assertFalse(data(paths).GetPointData().HasArray("FaceId"))
        paths.GenerateFaceIds = 1
        output = data(paths)
        cells = vtk_to_numpy(output.GetPointData().GetArray("FaceId"))
        begin = 0
        for line in lines(output):
            own = cells[begin:begin + len(line)]
            corner = np.column_stack((own[:-1] % 24, own[:-1] // 24)) / 6
            middle = (line[1:, :2] + line[:-1, :2]) / 2
            self.assertTrue(np.all((corner - FLOAT <= middle) & (middle <= corner + 1 / 6 + FLOAT)))
            self.assertEqual(own[-1], own[-2])
            begin += len(line)

    def test_without_targets_there_is_an_error(self):
        paths = simple.GeodesicPaths(Input=plane(), Source=polyline(CURVE), Targets=None)
        with messages() as said:
            paths.UpdatePipeline()
        self.assertIn("no targets", said.GetOutput())
        self.assertIn("port 2", said.GetOutput())
        self.assertIn("no targets", paths.ErrorMessage)
        paths.Targets = polyline(TARGETS)
        paths.UpdatePipeline()
        self.assertEqual(paths.ErrorMessage, "")


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
        # The Point Source puts all points into one cell: they are five sources all the same.
        cloud = simple.PointSource(NumberOfPoints=5, Radius=0.4, Center=(2, 1.5, 0))
        flat = simple.Transform(Input=cloud)
        flat.Transform.Scale = (1, 1, 0)
        matrix = simple.GeodesicDistanceMatrix(Input=plane(), Source=flat)
        table = columns(data(matrix))
        positions = points(data(flat))
        expected = np.linalg.norm(positions[:, None] - positions[None], axis=2)
        actual = np.array([table[f"Source{i}"] for i in range(5)])
        np.testing.assert_allclose(actual, expected, atol=FLOAT)

    def test_arrays_name_columns_and_rows(self):
        def named(names):
            source = simple.ProgrammableSource(Script=f"""
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
points, names = vtkPoints(), vtkStringArray()
names.SetName("electrode")
for i, name in enumerate({names}):
    points.InsertNextPoint(0.5 + i, 1, 0)
    names.InsertNextValue(name)
self.GetPolyDataOutput().SetPoints(points)
self.GetPolyDataOutput().GetPointData().AddArray(names)""")
            source.OutputDataSetType = "vtkPolyData"
            return source

        matrix = simple.GeodesicDistanceMatrix(
            Input=plane(), Source=named(["Cz", "left ear", "Cz"]), Targets=named(["Pz", "Oz"]),
            SourceNameArrayName="electrode", TargetNameArrayName="electrode")
        table = data(matrix)
        self.assertEqual([table.GetColumnName(i) for i in range(table.GetNumberOfColumns())],
                         ["TargetId", "TargetName", "Cz", "left ear", "Cz_2"])
        self.assertEqual([table.GetColumn(1).GetValue(i) for i in range(2)], ["Pz", "Oz"])
        np.testing.assert_allclose(vtk_to_numpy(table.GetColumn(4)), [2, 1], atol=FLOAT)
        matrix.SourceNameArrayName = matrix.TargetNameArrayName = "None"
        self.assertEqual(list(columns(data(matrix))), ["TargetId", "Source0", "Source1", "Source2"])

    def test_beyond_the_maximum_distance_it_is_infinite(self):
        matrix = simple.GeodesicDistanceMatrix(
            Input=plane(), Source=polyline(CURVE), Targets=polyline(TARGETS), MaximumDistance=1)
        self.assertEqual(matrix.MaximumDistance, 1)
        expected = to_curve(np.array(TARGETS))
        expected[expected > 1] = np.inf
        np.testing.assert_allclose(columns(data(matrix))["Source0"], expected, atol=FLOAT)


def selected_points(surface, ids):
    """As Extract Selection gives clicked points: an unstructured grid of vertices."""
    pairs = [number for i in ids for number in (0, i)]
    selection = simple.IDSelectionSource(IDs=pairs, FieldType="POINT")
    return simple.ExtractSelection(Input=surface, Selection=selection)


class ClickedPoints(unittest.TestCase):
    """Points of the sheet, whose number i + 25 j is at (i / 6, j / 6)."""
    IDS = [55, 137, 412]

    def positions(self):
        return np.array([(i % 25 / 6, i // 25 / 6) for i in self.IDS])

    def test_are_sources_each_of_its_own(self):
        sheet = plane()
        clicked = selected_points(sheet, self.IDS)
        self.assertEqual(data(clicked).GetClassName(), "vtkUnstructuredGrid")
        field = simple.GeodesicDistanceField(
            Input=sheet, Source=clicked, GenerateSourceIds=1, RefineMesh=0)
        flat = points(data(field))[:, :2]
        each = np.linalg.norm(flat[:, None] - self.positions()[None], axis=2)
        point_data = data(field).GetPointData()
        np.testing.assert_allclose(
            vtk_to_numpy(point_data.GetArray("GeodesicDistance")), each.min(axis=1), atol=FLOAT)
        ids = vtk_to_numpy(point_data.GetArray("SourceId"))
        np.testing.assert_allclose(
            each[np.arange(len(ids)), ids], each.min(axis=1), atol=FLOAT)
        table = columns(data(simple.GeodesicDistanceMatrix(Input=sheet, Source=clicked)))
        expected = np.linalg.norm(self.positions()[:, None] - self.positions()[None], axis=2)
        actual = np.array([table[f"Source{i}"] for i in range(3)])
        np.testing.assert_allclose(actual, expected, atol=FLOAT)

    def test_are_targets(self):
        sheet = plane()
        clicked = selected_points(sheet, self.IDS)
        paths = simple.GeodesicPaths(Input=sheet, Source=polyline(CURVE), Targets=clicked)
        np.testing.assert_allclose(
            cell_array(data(paths), "GeodesicDistance"), to_curve(self.positions()), atol=FLOAT)
        matrix = simple.GeodesicDistanceMatrix(
            Input=sheet, Source=polyline(CURVE), Targets=clicked)
        np.testing.assert_allclose(
            columns(data(matrix))["Source0"], to_curve(self.positions()), atol=FLOAT)

    def test_of_a_composite_surface_are_both(self):
        sheets = simple.GroupDatasets(Input=[plane(), plane(origin=(4, 0, 0))])
        selection = simple.CompositeDataIDSelectionSource(
            IDs=[1, 0, 30, 2, 0, 137], FieldType="POINT")
        clicked = simple.ExtractSelection(Input=sheets, Selection=selection)
        self.assertTrue(data(clicked).IsA("vtkCompositeDataSet"))
        matrix = simple.GeodesicDistanceMatrix(Input=sheets, Source=clicked, Targets=clicked)
        table = columns(data(matrix))
        between = np.hypot(4 + 12 / 6 - 5 / 6, 5 / 6 - 1 / 6)
        np.testing.assert_allclose(table["Source0"], [0, between], atol=FLOAT)
        np.testing.assert_allclose(table["Source1"], [between, 0], atol=FLOAT)

    def test_what_has_no_points_of_its_own_is_not_let_in_and_what_has_is(self):
        image = simple.Wavelet(WholeExtent=[0, 3, 0, 3, 0, 3])
        sheet = plane()
        for proxy in (simple.GeodesicPaths(Input=sheet), simple.GeodesicDistanceMatrix(Input=sheet),
                      simple.GeodesicDistanceField(Input=sheet), simple.GeodesicContour(Input=sheet)):
            for name in {"Source", "Targets"} & set(proxy.ListProperties()):
                domain = proxy.GetProperty(name).GetDomain("input_type")
                for source, expected in ((image, 0), (sheet, 1), (selected_points(sheet, [0]), 1)):
                    source.UpdatePipeline()
                    self.assertEqual(domain.IsInDomain(source.SMProxy, 0), expected, name)


class Regions(unittest.TestCase):
    def test_of_one_label_are_one_target(self):
        """Columns of squares: the label is that of the sixth of the plane's width, and there are 24."""
        faces = simple.GenerateIds(Input=plane(), CellIdsArrayName="Face")
        strips = simple.Calculator(Input=faces, AttributeType="Cell Data", ResultArrayName="Label",
                                   Function="floor((Face - 24 * floor(Face / 24)) / 8)")
        between = simple.GeodesicDistanceMatrix(Input=plane(), Source=strips, SourceIdArrayName="Label",
                                                TargetIdArrayName="Label")
        table = columns(data(between))
        np.testing.assert_array_equal(table["TargetId"], range(3))
        for i in range(3):
            expected = np.maximum(np.abs(np.arange(3) - i) - 1, 0) * 4 / 3
            np.testing.assert_allclose(table[f"Source{i}"], expected, atol=FLOAT)
        from_point = simple.GeodesicDistanceMatrix(Input=plane(), Source=polyline([(0.5, 1, 0)] * 2), Targets=strips,
                                                   TargetIdArrayName="Label")
        np.testing.assert_allclose(columns(data(from_point))["Source0"], [0, 4 / 3 - 0.5, 8 / 3 - 0.5], atol=FLOAT)


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
