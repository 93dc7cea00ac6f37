# SPDX-License-Identifier: BSD-3-Clause
"""The example of what the filters answer draws its pictures, the answers agree with each other, and
the lines that README shows of it run.

usage: pvpython test_answers.py EXAMPLES
"""

import os
import pathlib
import re
import sys
import tempfile
import unittest

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from geodesic_testing import data, distance_to_segments, distances, points
from pixels import read_pixels

EXAMPLES = pathlib.Path(sys.argv.pop()).resolve()
sys.path.insert(0, str(EXAMPLES))
import answers  # noqa: E402
import geodesic_distance  # noqa: E402

geodesic_distance.load_plugin()

# A fraction of the largest distance.
EXACT = 1e-12


def lines(output):
    """The points of each line."""
    cells, positions = output.GetLines(), points(output)
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    ids = vtk_to_numpy(cells.GetConnectivityArray())
    return [positions[ids[a:b]] for a, b in zip(offsets, offsets[1:])]


def cell_array(output, name):
    return vtk_to_numpy(output.GetCellData().GetArray(name))


def field(surface, source, **more):
    return simple.GeodesicDistanceField(Input=surface, Source=source, RefineMesh=0, **more)


class Answers(unittest.TestCase):
    def test_a_hundred_paths_are_as_long_as_the_distance_at_their_targets(self):
        ball = answers.ball()
        found = answers.paths(ball)
        output = data(found)
        self.assertEqual(output.GetNumberOfLines(), 100)

        lengths = cell_array(output, "GeodesicDistance")
        at_points = distances(field(ball, found.Source))
        for line, length in zip(lines(output), lengths):
            drawn = np.sum(np.linalg.norm(np.diff(line, axis=0), axis=1))
            self.assertAlmostEqual(drawn, length, delta=EXACT * at_points.max())
        vertex = {tuple(position): i for i, position in enumerate(points(data(ball)))}
        targets = points(data(found.Targets))[cell_array(output, "TargetId")]
        expected = at_points[[vertex[tuple(target)] for target in targets]]
        np.testing.assert_allclose(lengths, expected, rtol=0, atol=EXACT * at_points.max())

    def test_a_region_is_where_its_curve_is_the_nearest(self):
        hills, curves = answers.hills(), answers.curves()
        output = data(answers.regions(hills, curves))
        nearest = vtk_to_numpy(output.GetPointData().GetArray("SourceId"))
        together = vtk_to_numpy(output.GetPointData().GetArray("GeodesicDistance"))
        count = data(hills).GetNumberOfPoints()
        alone = np.array([distances(field(hills, answers.on_hills(curve)))
                          for curve in curves.Input.Input])
        self.assertEqual(set(nearest), set(range(len(alone))))
        atol = EXACT * together.max()
        np.testing.assert_allclose(together[:count], alone.min(axis=0), rtol=0, atol=atol)
        of_region = alone[nearest[:count], np.arange(count)]
        np.testing.assert_allclose(of_region, together[:count], rtol=0, atol=atol)

    def test_offset_curves_are_closed_and_at_equal_steps_from_the_rim(self):
        plate = answers.plate()
        output = data(answers.offsets(plate, step=0.1))
        rim = simple.FeatureEdges(Input=plate, FeatureEdges=0, NonManifoldEdges=0)
        segments = lines(data(rim))
        values = cell_array(output, "GeodesicDistance")
        self.assertGreater(len(set(values)), 3)
        np.testing.assert_allclose(sorted(set(values)), 0.1 * np.arange(1, len(set(values)) + 1))
        for line, value in zip(lines(output), values):
            np.testing.assert_array_equal(line[0], line[-1])
            # Through the air it is a little shorter than on the bent plate.
            straight = np.min([distance_to_segments(line[::10], segment) for segment in segments], axis=0)
            self.assertLess(straight.max(), value * (1 + 1e-6))
            self.assertGreater(straight.min(), 0.97 * value)

    def test_the_two_sides_of_the_seam_have_opposite_signs(self):
        output = data(answers.sides(answers.ball(), answers.seam()))
        signed = vtk_to_numpy(output.GetPointData().GetArray("SignedGeodesicDistance"))
        distance = vtk_to_numpy(output.GetPointData().GetArray("GeodesicDistance"))
        np.testing.assert_array_equal(np.abs(signed), distance)
        height = points(output)[:, 2]
        poles = signed[[height.argmax(), height.argmin()]]
        self.assertLess(poles[0] * poles[1], 0)

    def test_walls_make_ways_longer_and_their_insides_are_not_reached(self):
        labyrinth = answers.labyrinth()
        start = simple.PointSource(NumberOfPoints=1, Radius=0, Center=(0.15, -0.05, 0))
        around = distances(answers.around(labyrinth, start))
        straight = distances(field(labyrinth, start))
        around = around[:len(straight)]
        self.assertTrue(np.all(around >= straight * (1 - 1e-12)))
        self.assertTrue(np.any(around[np.isfinite(around)] > 1.5 * straight.max()))
        faces = vtk_to_numpy(data(labyrinth).GetPolys().GetConnectivityArray()).reshape(-1, 3)
        free = cell_array(data(labyrinth), "Wall") == 0
        inside = np.setdiff1d(faces[~free], faces[free])
        np.testing.assert_array_equal(np.flatnonzero(np.isinf(around)), inside)

    def test_the_table_is_an_array_of_targets_and_sources(self):
        ball = answers.ball()
        cloud = simple.MaskPoints(
            Input=answers.seam(), OnRatio=20, GenerateVertices=1, SingleVertexPerCell=1)
        table = answers.table(ball, cloud)
        self.assertEqual((table.shape, table.dtype), ((6, 6), float))
        np.testing.assert_array_equal(np.diag(table), 0)
        np.testing.assert_allclose(table, table.T, rtol=0, atol=EXACT * table.max())
        first = simple.MaskPoints(Input=cloud, OnRatio=6, GenerateVertices=1)
        self.assertEqual(data(first).GetNumberOfPoints(), 1)
        lengths = cell_array(data(simple.GeodesicPaths(Input=ball, Source=first, Targets=cloud)),
                             "GeodesicDistance")
        np.testing.assert_allclose(table[:, 0], lengths, rtol=0, atol=EXACT * table.max())


class Readme(unittest.TestCase):
    def test_its_lines_run_as_they_stand(self):
        text = (EXAMPLES.parent / "README.md").read_text()
        section = text.split("\n## What it answers\n")[1].split("\n## ")[0]
        blocks = re.findall(r"```python\n(.*?)```", section, re.DOTALL)
        self.assertEqual(len(blocks), len(answers.ANSWERS))

        lines = answers.curves().Input.Input
        names = {**vars(simple), "lines": [answers.on_hills(line) for line in lines],
                 "hills": answers.hills(), "plate": answers.plate(), "dome": answers.labyrinth(),
                 "ball": answers.ball(), "seam": answers.seam()}
        names["corner"] = answers.corner(names["ball"], answers.FROM)
        self.addCleanup(os.chdir, os.getcwd())
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            simple.SaveData("part.vtp", names["ball"], DataMode="Binary")
            for block in blocks:
                exec(block.replace("fandisk.obj", "part.vtp"), names)
            self.assertTrue(pathlib.Path("offsets.vtp").is_file())
        simple.Delete(simple.GetActiveView())

        for name, array in (("paths", "GeodesicDistance"), ("regions", "SourceId"),
                            ("offsets", "GeodesicDistance"), ("sides", "SignedGeodesicDistance"),
                            ("around", "GeodesicDistance")):
            self.assertTrue(data(names[name]).GetPointData().HasArray(array), name)
        self.assertEqual(names["distances"].shape, (40, 40))


class Pictures(unittest.TestCase):
    def test_there_is_one_an_answer_and_it_shows_something(self):
        with tempfile.TemporaryDirectory() as folder:
            answers.draw(f"{folder}/answer")
            files = sorted(pathlib.Path(folder).iterdir())
            self.assertEqual([file.name for file in files],
                             sorted(f"answer-{name}.png" for name in answers.ANSWERS))
            for file in files:
                colors = read_pixels(file)
                drawn = np.any(colors != 255, axis=2)
                self.assertGreater(drawn.mean(), 0.3, file.name)
                self.assertGreater(len(np.unique(colors[drawn] // 32, axis=0)), 10, file.name)


if __name__ == "__main__":
    unittest.main()
