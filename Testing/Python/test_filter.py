# SPDX-License-Identifier: BSD-3-Clause
"""The filter as pvpython sees it, against distances known in closed form."""

import unittest

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from geodesic_testing import (FLOAT, assert_close, data, distance_to_segments, distances,
                              load_plugin, messages, plane, points, polyline)

GeodesicDistanceField = load_plugin()

# Bends in faces, ends in a face, and lies in the plane of plane().
BENT = [(0.31, 0.42, 0), (1.93, 2.21, 0), (2.57, 0.64, 0), (3.71, 1.13, 0)]


def distance_to_sides(positions):
    x, y = positions[:, 0], positions[:, 1]
    return np.minimum(np.minimum(x, 4 - x), np.minimum(y, 3 - y))


class Sources(unittest.TestCase):
    def test_a_polyline_in_the_plane_gives_euclidean_distance_to_its_segments(self):
        field = GeodesicDistanceField(Input=plane(), Source=polyline(BENT))
        expected = distance_to_segments(points(data(field)), BENT)
        assert_close(distances(field), expected, FLOAT)

    def test_the_boundary_needs_no_source_input(self):
        field = GeodesicDistanceField(Input=plane(), SourceType="Surface Boundary")
        assert_close(distances(field), distance_to_sides(points(data(field))), FLOAT)

    def test_curve_and_boundary_give_the_smaller_of_the_two_distances(self):
        field = GeodesicDistanceField(
            Input=plane(), Source=polyline(BENT), SourceType="Curve and Boundary")
        positions = points(data(field))
        expected = np.minimum(distance_to_segments(positions, BENT), distance_to_sides(positions))
        assert_close(distances(field), expected, FLOAT)

    def test_the_second_output_is_the_curve_as_it_lies_on_the_surface(self):
        lifted = [(x, y, 0.125) for x, y, _ in BENT]
        field = GeodesicDistanceField(Input=plane(), Source=polyline(lifted))
        curve = data(field, port=1)
        self.assertEqual(curve.GetNumberOfLines(), 1)
        positions = points(curve)
        np.testing.assert_allclose(positions[:, 2], 0, atol=FLOAT)
        np.testing.assert_allclose(distance_to_segments(positions, BENT), 0, atol=5 * FLOAT)
        np.testing.assert_allclose(distance_to_segments(np.array(BENT), positions), 0, atol=5 * FLOAT)


class Properties(unittest.TestCase):
    def test_defaults_are_those_of_the_readme(self):
        field = GeodesicDistanceField(Input=plane())
        self.assertEqual(field.SourceType, "Source Curve")
        self.assertEqual(field.MaximumDistance, 0)
        self.assertEqual(field.JoinLines, 1)
        self.assertEqual(field.SourceIdArrayName, "None")
        self.assertEqual(field.MergeCoincidentPoints, 1)
        self.assertEqual(field.BarrierArrayName, "None")
        self.assertEqual(field.DistanceArrayName, "GeodesicDistance")

    def test_every_property_has_help_text(self):
        field = GeodesicDistanceField(Input=plane())
        for name in ("Input", "Source", *field.ListProperties()):
            text = field.GetProperty(name).GetDocumentation()
            self.assertTrue(text and text.GetDescription().strip(), name)
        self.assertTrue(field.SMProxy.GetDocumentation().GetDescription().strip())

    def test_a_contour_inside_maximum_distance_is_whole(self):
        ball = simple.Sphere(ThetaResolution=40, PhiResolution=30)
        source = simple.PointSource(NumberOfPoints=1, Radius=0, Center=(0.5, 0.02, 0.01))

        def contour(limit):
            field = GeodesicDistanceField(Input=ball, Source=source, MaximumDistance=limit)
            line = simple.Contour(Input=field, ContourBy=["POINTS", "GeodesicDistance"])
            line.Isosurfaces = [0.6]
            return data(line)

        whole, limited = contour(0), contour(0.6)
        self.assertGreater(whole.GetNumberOfCells(), 0)
        self.assertEqual(limited.GetNumberOfCells(), whole.GetNumberOfCells())
        a, b = (np.sort(points(x), axis=0) for x in (whole, limited))
        np.testing.assert_allclose(a, b, atol=FLOAT)

    def test_coincident_points_conduct_when_merged_and_separate_when_not(self):
        halves = simple.AppendGeometry(Input=[plane(), plane(origin=(4, 0, 0))])
        field = GeodesicDistanceField(Input=halves, Source=polyline(BENT), RefineMesh=0)
        positions = points(data(field))
        expected = distance_to_segments(positions, BENT)
        assert_close(distances(field), expected, FLOAT)

        field.MergeCoincidentPoints = 0
        second = np.arange(len(positions)) >= len(positions) // 2
        assert_close(distances(field), np.where(second, np.inf, expected), FLOAT)

    def test_the_array_gets_the_name_that_is_asked_for(self):
        field = GeodesicDistanceField(Input=plane(), Source=polyline(BENT), DistanceArrayName="Depth")
        output = data(field).GetPointData()
        self.assertTrue(output.HasArray("Depth"))
        self.assertFalse(output.HasArray("GeodesicDistance"))


class Barriers(unittest.TestCase):
    def walled(self):
        """A sheet whose cells from x = 2 to 3 and up to y = 2 are marked, by their active scalars."""
        marked = simple.Calculator(
            Input=plane(), ResultArrayName="Wall",
            Function="if(abs(coordsX - 2.5) < 0.4 & coordsY < 1.9, 1, 0)")
        surface = simple.PointDatatoCellData(Input=marked)
        surface.UpdatePipeline()  # domains know the arrays then
        return surface

    def test_there_are_none_by_default_though_cells_have_active_scalars(self):
        surface = self.walled()
        self.assertEqual(data(surface).GetCellData().GetScalars().GetName(), "Wall")
        field = GeodesicDistanceField(Input=surface, SourceType="Surface Boundary")
        self.assertEqual(field.BarrierArrayName, "None")
        assert_close(distances(field), distance_to_sides(points(data(field))), FLOAT)

    def test_surfaces_without_cell_arrays_can_be_used(self):
        for surface in (plane(), simple.GroupDatasets(Input=[plane(), self.walled()])):
            surface.UpdatePipeline()
            field = GeodesicDistanceField(Input=surface)
            self.assertTrue(field.GetProperty("Input").SMProperty.IsInDomains())

    def test_the_list_offers_the_cell_arrays_of_the_surface(self):
        field = GeodesicDistanceField(Input=self.walled())
        self.assertEqual(list(field.GetProperty("BarrierArrayName").GetAvailable()), ["None", "Wall"])

    def test_paths_go_around_the_array_that_is_chosen(self):
        source = simple.PointSource(NumberOfPoints=1, Radius=0, Center=(1.5, 0.5, 0))
        field = GeodesicDistanceField(
            Input=self.walled(), Source=source, BarrierArrayName="Wall", RefineMesh=0)
        positions, actual = points(data(field)), distances(field)
        behind = (positions[:, 0] >= 3) & (positions[:, 1] <= 2)
        expected = (np.hypot(0.5, 1.5) + 1 +
                    np.hypot(positions[behind, 0] - 3, positions[behind, 1] - 2))
        assert_close(actual[behind], expected, FLOAT)
        inside = (positions[:, 0] > 2) & (positions[:, 0] < 3) & (positions[:, 1] < 2)
        self.assertTrue(np.all(np.isinf(actual[inside])) and inside.any())
        self.assertTrue(np.all(np.isfinite(actual[~inside])))


class SourceNames(unittest.TestCase):
    def test_points_have_the_label_of_the_nearest(self):
        marks = simple.GroupDatasets(Input=[
            simple.PointSource(NumberOfPoints=1, Radius=0, Center=(x, 0.5, 0)) for x in (0.5, 2.5)])
        labels = simple.Calculator(Input=marks, ResultArrayName="Label", ResultArrayType="Int",
                                   Function="if(coordsX > 1, 8, 3)")
        field = GeodesicDistanceField(Input=plane(), Source=labels, SourceIdArrayName="Label",
                                      GenerateSourceIds=1, RefineMesh=0)
        ids = vtk_to_numpy(data(field).GetPointData().GetArray("SourceId"))
        x = points(data(field))[:, 0]
        self.assertTrue(np.all(ids[x < 1.5] == 3) and np.all(ids[x > 1.5] == 8))


class Results(unittest.TestCase):
    def blocks(self, field):
        """The blocks of a composite output that are a vtkPolyData."""
        output = data(field)
        self.assertTrue(output.IsA("vtkCompositeDataSet"), output.GetClassName())
        iterator = output.NewIterator()
        iterator.InitTraversal()
        result = []
        while not iterator.IsDoneWithTraversal():
            result.append(iterator.GetCurrentDataObject())
            iterator.GoToNextItem()
        return result

    def assert_blocks_close(self, field, curve):
        for block in self.blocks(field):
            array = block.GetPointData().GetArray("GeodesicDistance")
            actual = np.array([array.GetTuple1(i) for i in range(array.GetNumberOfTuples())])
            assert_close(actual, distance_to_segments(points(block), curve), FLOAT)

    def test_surface_and_source_can_both_be_composite(self):
        surfaces = simple.GroupDatasets(Input=[plane(), plane(origin=(4, 0, 0))])
        curves = simple.GroupDatasets(Input=[polyline(BENT[:2]), polyline(BENT[1:])])
        self.assert_blocks_close(GeodesicDistanceField(Input=surfaces, Source=curves), BENT)

    def test_a_collection_of_partitioned_surfaces_keeps_its_kind(self):
        surfaces = simple.ConvertToPartitionedDataSetCollection(
            Input=simple.GroupDatasets(Input=[plane(), plane(origin=(4, 0, 0))]))
        field = GeodesicDistanceField(Input=surfaces, Source=polyline(BENT))
        self.assertEqual(data(field).GetClassName(), "vtkPartitionedDataSetCollection")
        self.assert_blocks_close(field, BENT)

    def test_surfaces_composites_and_grids_are_offered_by_the_domains_and_images_are_not(self):
        field = GeodesicDistanceField(Input=plane(), Source=polyline(BENT))
        grid, volume = clip(plane()), simple.Wavelet()
        offered = [grid, simple.GroupDatasets(Input=[plane(), plane()]),
                   simple.GroupDatasets(Input=[plane(), grid]), clip(simple.GroupDatasets(Input=[plane(), plane()]))]
        others = [volume, simple.GroupDatasets(Input=[plane(), volume])]
        for proxy in offered + others:
            proxy.UpdatePipeline()
        for name in ("Input", "Source"):
            prop = field.SMProxy.GetProperty(name)
            domain = prop.GetDomain("input_type")
            for proxy, expected in [(proxy, 1) for proxy in offered] + [(proxy, 0) for proxy in others]:
                prop.RemoveAllUncheckedProxies()
                prop.AddUncheckedInputConnection(proxy.SMProxy, 0)
                self.assertEqual(domain.IsInDomain(prop), expected, name)
            prop.ClearUncheckedElements()


def clip(surface):
    """What is below a slanted line, which leaves cells of 3, 4 and 5 corners as triangles and quads."""
    clipped = simple.Clip(Input=surface, ClipType="Plane")
    clipped.ClipType.Origin = (2, 2.61, 0)
    clipped.ClipType.Normal = (0.1, 1, 0)
    return clipped


class Grids(unittest.TestCase):
    """What filters make of surfaces as unstructured grids are surfaces, too."""

    def assert_field(self, grid):
        for refined in (0, 1):
            field = GeodesicDistanceField(Input=grid, Source=polyline(BENT), RefineMesh=refined)
            with messages() as window:
                output = data(field)
            self.assertEqual(window.GetOutput(), "")
            self.assertTrue(output.IsA("vtkPolyData"))
            assert_close(distances(field), distance_to_segments(points(output), BENT), FLOAT)
        return output

    def test_of_a_clip(self):
        grid = clip(plane())
        self.assertTrue(data(grid).IsA("vtkUnstructuredGrid"), data(grid).GetClassName())
        output = self.assert_field(grid)
        self.assertLess(points(output)[:, 1].max(), 2.9)

    def test_of_a_data_set_redistributed(self):
        self.assert_field(simple.RedistributeDataSet(Input=plane()))

    def test_of_blocks_is_one_surface_with_blocks_that_are_grids_or_not(self):
        both = [plane(), plane(origin=(4, 0, 0))]
        for blocks in (clip(simple.GroupDatasets(Input=both)),
                       simple.GroupDatasets(Input=[both[0], simple.AppendDatasets(Input=both[1:])])):
            output = data(GeodesicDistanceField(Input=blocks, Source=polyline(BENT)))
            self.assertEqual(output.GetNumberOfBlocks(), 2)
            for i in range(2):
                block = output.GetBlock(i)
                self.assertTrue(block.IsA("vtkPolyData"))
                actual = vtk_to_numpy(block.GetPointData().GetArray("GeodesicDistance"))
                assert_close(actual, distance_to_segments(points(block), BENT), FLOAT)

    def test_other_filters_take_them(self):
        grid = clip(plane())
        ends = polyline(BENT)
        lines = data(simple.GeodesicContour(Input=grid, Source=ends, Distances=[0.25]))
        np.testing.assert_allclose(distance_to_segments(points(lines), BENT), 0.25, atol=4 * FLOAT)
        paths = data(simple.GeodesicPaths(Input=grid, Source=ends, Targets=grid))
        self.assertEqual(paths.GetNumberOfLines(), data(grid).GetNumberOfPoints())
        table = data(simple.GeodesicDistanceMatrix(Input=grid, Source=ends, Targets=grid))
        assert_close(vtk_to_numpy(table.GetColumnByName("Source0")),
                     distance_to_segments(points(data(grid)), BENT), FLOAT)


class Errors(unittest.TestCase):
    def assert_refused(self, field, *words):
        """The filter says all the words, and gives no field."""
        with messages() as window:
            field.UpdatePipeline()
        said = window.GetOutput()
        for word in words:
            self.assertIn(word.lower(), said.lower())
        self.assertIsNone(data(field).GetPointData().GetArray("GeodesicDistance"))

    def test_after_an_error_the_filter_works_again(self):
        field = GeodesicDistanceField(Input=plane())
        self.assert_refused(field, "source")
        field.Source = polyline(BENT)
        assert_close(distances(field), distance_to_segments(points(data(field)), BENT), FLOAT)


if __name__ == "__main__":
    unittest.main()
