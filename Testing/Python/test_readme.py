# SPDX-License-Identifier: BSD-3-Clause
"""The lines of Python that README and HowTo show run as they stand, and give what the pages say; links of the pages lead
somewhere, and folders of the build are where the pages say.

usage: pvpython --dr test_readme.py SOURCES BUILD
"""

import csv
import os
import pathlib
import re
import sys
import tempfile
import unittest
import unittest.mock

import geodesicdistance  # noqa: F401, before Python meets one of its objects, whose class it would not know
import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from geodesic_testing import data, distances, load_plugin
from pixels import read_pixels

BUILD = pathlib.Path(sys.argv.pop())
SOURCES = pathlib.Path(sys.argv.pop()).resolve()
README = (SOURCES / "README.md").read_text()
sys.path.append(str(SOURCES / "Examples/gallery"))
import small_png  # noqa: E402
load_plugin()


def blocks_in(text):
    return re.findall(r"```python\n(.*?)```", text, re.DOTALL)


def blocks(heading):
    return blocks_in(README.split(f"\n## {heading}\n")[1].split("\n## ")[0])


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)


class HowTo(InFolder):
    """On a ball of radius 0.5, whose facets make ways a little shorter."""

    def test_the_lines_run_and_do_what_they_say(self):
        names = dict(vars(simple))
        names["surface"] = simple.Sphere(ThetaResolution=100, PhiResolution=100)
        ezdxf = unittest.mock.MagicMock()  # not packaged everywhere
        picture = np.full((64, 64, 3), 255, np.uint8)
        picture[8:-8, 8:-8] = 200, 0, 0
        small_png.write(picture, "picture.png")
        with unittest.mock.patch.dict(sys.modules, ezdxf=ezdxf):
            for block in blocks_in((SOURCES / "Examples/HowTo.md").read_text()):
                exec(block, names)
        drawn = [call.args[0] for call in ezdxf.new().modelspace().add_polyline3d.call_args_list]
        self.assertEqual([line[0] == line[-1] and len(line) > 10 for line in drawn], 3 * [True])
        quarter = np.pi / 4
        self.assertAlmostEqual(names["ruler"].SourceLength, quarter, delta=0.002)
        self.assertAlmostEqual(distances(names["field"]).max(), 2 * quarter, delta=0.002)
        paths = names["paths"]
        self.assertEqual(paths.NumberOfPaths, 1)
        self.assertEqual(paths.ShortestLength, paths.LongestLength)
        self.assertAlmostEqual(paths.LongestLength, quarter, delta=0.002)
        ids = vtk_to_numpy(data(names["nearest"]).GetPointData().GetArray("SourceId"))
        self.assertEqual(set(ids), {0, 1})
        self.assert_landmarks(names)
        self.assert_pictures(names)
        # Between the pole and where the page has moved the slice to in the end.
        heights = vtk_to_numpy(data(names["middle"]).GetPoints().GetData())[:, 2]
        between = (np.pi/2 + np.arcsin(0.2 / 0.5)) / 2
        np.testing.assert_allclose(np.arcsin(heights / 0.5), between, atol=0.0005)
        self.assert_table()
        self.assert_regions(names)
        self.assert_lines()
        found = distances(names["near"])
        self.assertAlmostEqual(found.max(), 0.4, delta=0.02)
        self.assertEqual(found.min(), -1)
        points = vtk_to_numpy(data(names["around"]).GetPoints().GetData())
        inside = points[:, 0] > 0.43
        self.assertTrue(np.isinf(distances(names["around"])[inside]).all())
        self.assertTrue(np.isfinite(distances(names["around"])[points[:, 0] < 0.37]).all())
        self.assert_cuts(names)
        height = np.arcsin(0.2 / 0.5) * 0.5  # of the last slice, along a meridian
        self.assertAlmostEqual(distances(names["nearest"]).max(), quarter + height, delta=0.002)

    def assert_landmarks(self, names):
        with open("landmarks.csv") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["TargetId"] for row in rows], ["0", "1", "2"])
        places = [[float(row[f"TargetPosition:{k}"] if f"TargetPosition:{k}" in row else row[f"TargetPosition_{k}"])
                   for k in range(3)] for row in rows]
        np.testing.assert_allclose(places, [(0, 0, 0.5), (0.5, 0, 0), (0, -0.5, 0)], atol=0.002)
        table = np.array([[float(row[f"Source{k}"]) for k in range(3)] for row in rows])
        np.testing.assert_allclose(table, np.pi/4*(1 - np.eye(3)), atol=0.002)
        self.assertEqual(set(vtk_to_numpy(data(names["landmarks"]).GetPointData().GetArray("SourceId"))), {0, 1, 2})
        self.assertAlmostEqual(names["field"].LargestDistance, np.pi/2, delta=0.002)
        np.testing.assert_allclose(names["field"].FarthestPoint, (0, 0, -0.5), atol=1e-6)
        cap = 2*np.pi*0.5**2*(1 - np.cos(0.2/0.5))
        self.assertAlmostEqual(names["disk"].CellData["Area"].GetRange()[0], cap, delta=0.002)

    def assert_pictures(self, names):
        self.assertEqual(len(list(pathlib.Path().glob("moving*.png"))), 5)
        view = simple.GetActiveView()
        self.addCleanup(simple.Delete, view)
        view.OrientationAxesVisibility = 0
        simple.HideAll(view)
        simple.Show(names["decal"], view)
        view.CameraParallelProjection, view.CameraParallelScale = 1, 0.6
        view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = (0, 0, 5), (0, 0, 0), (0, 1, 0)
        simple.SaveScreenshot("decal.png", view, ImageResolution=(400, 400))
        red, green, blue = np.moveaxis(read_pixels("decal.png").astype(int), -1, 0)
        rows, columns = np.where((red > 2*green) & (red > 2*blue))
        # Three quarters of 0.3 in a view of 1.2 for 400 pixels: once, in the middle.
        for places in rows, columns:
            self.assertAlmostEqual(np.mean((places.min(), places.max())), 200, delta=5)
            self.assertTrue(60 < np.ptp(places) < 120, np.ptp(places))

    def assert_cuts(self, names):
        strip = data(names["strip"])
        heights = vtk_to_numpy(strip.GetPoints().GetData())[:, 2]
        middle = np.arcsin(0.2 / 0.5)  # of the slice where the page has moved it to in the end
        self.assertAlmostEqual(heights.max(), 0.5 * np.sin(middle + 0.1 / 0.5), delta=0.001)
        self.assertAlmostEqual(heights.min(), 0.5 * np.sin(middle - 0.1 / 0.5), delta=0.001)
        whole = simple.IntegrateVariables(Input=names["surface"])
        whole.UpdatePipeline()
        self.assertAlmostEqual(sum(names["areas"]), whole.CellData["Area"].GetRange()[0], delta=1e-12)
        # Shortest paths are great circles: each corner between them is the angle of two planes.
        corners = np.array(names["corners"]).reshape(4, 3)
        normals = [np.cross(a, b) / np.linalg.norm(np.cross(a, b)) for a, b in zip(corners, np.roll(corners, -1, axis=0))]
        angles = [np.pi - np.arccos(a @ b) for a, b in zip(normals, np.roll(normals, -1, axis=0))]
        self.assertAlmostEqual(names["areas"][0], 0.25 * (sum(angles) - 2 * np.pi), delta=0.002)
        point = data(simple.OutputPort(names["whole"], 1)).GetPoint(0)
        self.assertLess(point[0], 0.001)
        self.assertAlmostEqual(np.linalg.norm(point), 0.5, delta=0.001)

    def test_a_split_along_a_closed_curve_has_areas_to_eight_digits(self):
        """Against planes through the ball, which cut its facets along the same curve."""
        ball = simple.Sphere(ThetaResolution=100, PhiResolution=100)
        for normal in ((0.1, 0.2, 1), (1, -0.3, 0.4)):
            ring = simple.Slice(Input=ball)
            ring.SliceType.Origin, ring.SliceType.Normal = (0, 0, 0.1), normal
            signed = simple.GeodesicDistanceField(Input=ball, Source=ring, GenerateSignedDistance=1,
                                                  RefinementTolerance=0.0001)
            sides = [[], []]
            for invert in (0, 1):
                plane = simple.Clip(Input=ball, ClipType="Plane", Invert=invert)
                plane.ClipType.Origin, plane.ClipType.Normal = (0, 0, 0.1), normal
                side = simple.Clip(Input=signed, ClipType="Scalar", Scalars=["POINTS", "SignedGeodesicDistance"],
                                   Invert=invert)
                side.Value = 0
                for part, areas in zip((plane, side), sides):
                    area = simple.IntegrateVariables(Input=part)
                    area.UpdatePipeline()
                    areas.append(area.CellData["Area"].GetRange()[0])
            np.testing.assert_allclose(sorted(sides[1]), sorted(sides[0]), rtol=1e-8, atol=1e-8)

    def assert_regions(self, names):
        """The ball's faces are numbered from both poles on, then along the meridians: the first region has the caps at
        the poles, and touches all others, which are farthest from each other across a cap."""
        table = data(names["regions"])
        count = table.GetNumberOfRows()
        between = np.array([[table.GetValueByName(i, f"Source{j}").ToDouble() for j in range(count)]
                            for i in range(count)])
        self.assertGreater(count, 5)
        np.testing.assert_array_equal(between, between.T)
        np.testing.assert_array_equal(np.diagonal(between), 0)
        np.testing.assert_allclose(between[0], 0, atol=1e-7)
        self.assertAlmostEqual(between.max(), np.sin(np.pi / 99), delta=0.002)

    def assert_table(self):
        with open("distances.csv") as file:
            found = sorted(float(row["Source0"]) for row in csv.DictReader(file))
        self.assertGreater(len(found), 100)
        self.assertAlmostEqual(found[0], 0, delta=1e-12)
        np.testing.assert_allclose(found[1:], np.pi / 4, atol=0.002)

    def assert_lines(self):
        with open("offsets.csv") as file:
            rows = list(csv.DictReader(file))
        for line, distance in enumerate((0.1, 0.2, 0.3)):
            ring = [row for row in rows if row["LineId"] == str(line)]
            self.assertEqual({float(row["GeodesicDistance"]) for row in ring}, {distance})
            x, y, z = (np.array([float(row.get(f"Points:{k}") or row[f"Points_{k}"]) for row in ring]) for k in range(3))
            np.testing.assert_allclose(z, 0.5 * np.cos(distance / 0.5), atol=0.002)
            turns = np.angle(np.exp(1j * np.diff(np.arctan2(y, x))))
            self.assertTrue((turns > 0).all() or (turns < 0).all(), "points stand in order")


class Readme(InFolder):

    def test_the_lines_for_pvpython_run(self):
        names = {}
        exec(blocks("In Python")[0], names)
        largest = distances(names["field"]).max()
        self.assertAlmostEqual(largest, np.pi / 4, delta=0.01)  # of a ball of radius 0.5, from a great circle
        values = vtk_to_numpy(data(names["offsets"]).GetCellData().GetArray("GeodesicDistance"))
        self.assertEqual(set(values), {0.1, 0.2, 0.3})
        for file in ("distance.vtp", "offsets.vtp"):
            self.assertTrue(pathlib.Path(file).is_file())

    def test_the_lines_for_python_run(self):
        names = {}
        exec(blocks("In Python")[1], names)
        distances = names["distances"]
        points = vtk_to_numpy(names["surface"].GetPoints().GetData())
        self.assertEqual(distances[np.argmax(points[:, 2])], 0)
        # On coarse facets of a ball of radius 0.5: shorter than half a great circle, longer than the diameter.
        self.assertTrue(1 < distances.max() < np.pi / 2)
        self.assertEqual(sorted(names["lines"]["GeodesicDistance"]), [0.1, 0.2, 0.3])

    def test_folders_of_the_build_are_where_the_pages_say(self):
        for page, name, there in (
                ("README.md", r"PV_PLUGIN_PATH=\$PWD/build/(\S+)", f"{os.environ['GEODESIC_PLUGIN']}/.."),
                ("README.md", r"`build/(\S+)` in `PYTHONPATH`", f"{geodesicdistance.__file__}/../.."),
                ("Testing/Benchmarks/README.md", r"PV_PLUGIN_PATH=\$PWD/build/(\S+)", f"{os.environ['GEODESIC_PLUGIN']}/.."),
                ("Filters/Reference.md", r'"build/(\S+\.so)"', os.environ["GEODESIC_PLUGIN"])):
            said = re.findall(name, (SOURCES / page).read_text())
            self.assertEqual(len(said), 1, name)
            self.assertTrue(os.path.samefile(BUILD / said[0], os.path.normpath(there)), said)

    def test_links_lead_somewhere(self):
        for page in ("README.md", "CONTRIBUTING.md", "Examples/HowTo.md", "Examples/Python.md", "Filters/Reference.md",
                     "Filters/Core/README.md", "Testing/Platforms.md"):
            self.check_links(page)

    def check_links(self, page):
        folder = (SOURCES / page).parent
        for link in re.findall(r"\]\(([^)]+)\)", (SOURCES / page).read_text()):
            if link.startswith("https:"):
                continue
            file, _, heading = link.partition("#")
            target = folder / file if file else SOURCES / page
            self.assertTrue(target.exists(), link)
            if heading:
                headings = re.findall(r"^##+ (.*)$", target.read_text(), re.MULTILINE)
                self.assertIn(heading, [re.sub(r"[^\w -]", "", title.lower()).replace(" ", "-") for title in headings])


if __name__ == "__main__":
    unittest.main()
