# SPDX-License-Identifier: BSD-3-Clause
"""The wrapped class in plain Python, with either VTK."""

import math
import unittest

from geodesicdistance import (vtkGeodesicDistanceField, vtkGeodesicDistanceMatrix,
                             vtkGeodesicFarthestPoints, vtkGeodesicPaths)
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


def octahedron():
    points, faces = vtkPoints(), vtkCellArray()
    for axis in range(3):
        for sign in (1, -1):
            points.InsertNextPoint([sign * (axis == k) for k in range(3)])
    for x in (0, 1):
        for y in (2, 3):
            for z in (4, 5):
                faces.InsertNextCell(3, (x, y, z))
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(faces)
    return surface


def point(x, y, z):
    points = vtkPoints()
    points.InsertNextPoint(x, y, z)
    data = vtkPolyData()
    data.SetPoints(points)
    return data


class Module(unittest.TestCase):
    def test_paths_and_matrices_on_the_octahedron_go_over_its_unfolding(self):
        for vtk_class in (vtkGeodesicPaths, vtkGeodesicDistanceMatrix):
            query = vtk_class()
            query.SetInputData(octahedron())
            query.SetSourceData(point(1, 0, 0))
            query.SetTargetsData(point(-1, 0, 0))
            query.Update()
            output = query.GetOutput()
            array = (output.GetCellData().GetArray("GeodesicDistance")
                     if vtk_class is vtkGeodesicPaths else output.GetColumnByName("Source0"))
            self.assertEqual(array.GetNumberOfTuples(), 1)
            self.assertAlmostEqual(array.GetTuple1(0), math.sqrt(6), delta=1e-12)

    def test_the_farthest_point_of_the_octahedron_is_opposite_and_no_more_are_found_than_there_are(self):
        spread = vtkGeodesicFarthestPoints()
        self.assertEqual(spread.GetNumberOfPoints(), 100)
        spread.SetInputData(octahedron())
        spread.SetSourceData(point(1, 0, 0))
        spread.Update()
        ids, distances = (spread.GetOutput().GetColumnByName(name) for name in ("PointId", "GeodesicDistance"))
        self.assertEqual([ids.GetValue(i) for i in range(ids.GetNumberOfValues())], [1, 2, 3, 4, 5])
        for i in range(5):
            self.assertAlmostEqual(distances.GetValue(i), math.sqrt(2 if i > 0 else 6), delta=1e-12)
        spread.SetNumberOfPoints(2)
        spread.Update()
        self.assertEqual(spread.GetOutput().GetNumberOfRows(), 2)

    def test_distances_on_the_octahedron_from_a_vertex_are_those_of_its_unfolding(self):
        source = vtkPolyData()
        points = vtkPoints()
        points.InsertNextPoint(1, 0, 0)
        source.SetPoints(points)

        field = vtkGeodesicDistanceField()
        field.SetInputData(octahedron())
        field.SetSourceData(source)
        field.Update()
        array = field.GetOutput().GetPointData().GetArray(field.GetDistanceArrayName())
        expected = [0, math.sqrt(6)] + 4 * [math.sqrt(2)]
        for i, distance in enumerate(expected):
            self.assertAlmostEqual(array.GetTuple1(i), distance, delta=1e-12)

    def test_every_property_can_be_set_and_read(self):
        field = vtkGeodesicDistanceField()
        for name, default, other in (("SourceType", 0, 2), ("Accuracy", 0, 1),
                                     ("RelativeError", 0.001, 0.1), ("RefineMesh", True, False),
                                     ("RefinementTolerance", 0.001, 0.01),
                                     ("ToleranceIsAbsolute", False, True),
                                     ("AbsoluteRefinementTolerance", 1.0, 0.2),
                                     ("MaximumNumberOfCells", 50000000, 0),
                                     ("OutputPointsPrecision", 2, 0),
                                     ("RefineSourceBorders", False, True),
                                     ("MaximumDistance", 0.0, 1.5),
                                     ("JoinLines", True, False),
                                     ("SourceIdArrayName", None, "labels"),
                                     ("MergeCoincidentPoints", True, False),
                                     ("BarrierArrayName", None, "walls"),
                                     ("DistanceArrayName", "GeodesicDistance", "Depth")):
            self.assertEqual(getattr(field, "Get" + name)(), default, name)
            getattr(field, "Set" + name)(other)
            self.assertEqual(getattr(field, "Get" + name)(), other, name)


if __name__ == "__main__":
    unittest.main()
