# SPDX-License-Identifier: BSD-3-Clause
"""The lines of Python that README shows run as they stand, and give what it says; its links lead somewhere.

usage: pvpython --dr test_readme.py SOURCES
"""

import os
import pathlib
import re
import sys
import tempfile
import unittest

import geodesicdistance  # noqa: F401, before Python meets one of its objects, whose class it would not know
import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from geodesic_testing import data, distances, load_plugin

SOURCES = pathlib.Path(sys.argv.pop()).resolve()
README = (SOURCES / "README.md").read_text()
load_plugin()


def blocks(heading):
    section = README.split(f"\n## {heading}\n")[1].split("\n## ")[0]
    return re.findall(r"```python\n(.*?)```", section, re.DOTALL)


class Readme(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        os.symlink(SOURCES / "ParaViewPlugin", "ParaViewPlugin")

    def test_the_lines_for_pvpython_run(self):
        names = {}
        for block in blocks("In pvpython"):
            if "Connect(" not in block:  # test_client_server.py has a server
                exec(block, names)
        self.addCleanup(simple.Delete, simple.GetActiveView())
        largest = distances(names["field"]).max()
        self.assertAlmostEqual(largest, np.pi / 4, delta=0.01)  # of a ball of radius 0.5, from a great circle
        values = vtk_to_numpy(data(names["offsets"]).GetCellData().GetArray("GeodesicDistance"))
        self.assertEqual(set(values), {0.1, 0.2, 0.3})
        for file in ("distance.vtp", "offsets.vtp"):
            self.assertTrue(pathlib.Path(file).is_file())
        self.assertAlmostEqual(names["display"].LookupTable.RGBPoints[-4], 32 * 0.05)

    def test_the_drawn_curve_is_made_as_it_says(self):
        call = re.search(r"`(GeodesicDistanceFieldFromDrawnCurve\(.*?\))`", README, re.DOTALL)[1]
        surface = simple.Sphere(ThetaResolution=100, PhiResolution=100)
        self.assertEqual(distances(eval(call, {**vars(simple), "surface": surface})).min(), 0)

    def test_the_lines_for_python_run(self):
        surface = simple.Sphere(ThetaResolution=100, PhiResolution=100)
        curve = simple.Slice(Input=surface)
        names = {"surface": data(surface), "curve": data(curve)}
        for block in blocks("In Python with VTK"):
            exec(block, names)
        expected = distances(simple.GeodesicDistanceField(Input=surface, Source=curve))
        np.testing.assert_array_equal(vtk_to_numpy(names["distance"]), expected)

    def test_its_links_lead_somewhere(self):
        for link in re.findall(r"\]\(([^)]+)\)", README):
            file, _, heading = link.partition("#")
            target = SOURCES / file if file else SOURCES / "README.md"
            self.assertTrue(target.exists(), link)
            if heading:
                headings = re.findall(r"^##+ (.*)$", target.read_text(), re.MULTILINE)
                self.assertIn(heading, [title.lower().replace(" ", "-") for title in headings])


if __name__ == "__main__":
    unittest.main()
