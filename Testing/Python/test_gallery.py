# SPDX-License-Identifier: BSD-3-Clause
"""A script of the gallery gives what is true and draws the gallery's picture; ParaView loads the script as a
state, and the state file that is made from it.

usage: pvpython test_gallery.py EXAMPLES NAME
"""

import pathlib
import re
import runpy
import sys
import tempfile
import unittest

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

NAME = sys.argv.pop()
EXAMPLES = pathlib.Path(sys.argv.pop()).resolve()
GALLERY = EXAMPLES / "gallery"
sys.path.insert(0, str(GALLERY))
import gallery_truth  # noqa: E402
import scan  # noqa: E402
from all import lacks_scan, start_anew  # noqa: E402
from geodesic_testing import data  # noqa: E402
from pixels import read_pixels  # noqa: E402


def run(folder):
    """The variables of the script, which has written its files into the folder."""
    before = sys.argv
    sys.argv = [f"{NAME}.py", str(folder)]
    try:
        return runpy.run_path(str(GALLERY / f"{NAME}.py"))
    finally:
        sys.argv = before


def load_script_as_state():
    """Executes the script as ParaView's File > Load State... does: it gives a script its path, but neither
    arguments nor a place to import from."""
    before = sys.argv, sys.path, sys.modules.pop("look", None)
    sys.argv, sys.path = [""], [place for place in sys.path if place != str(GALLERY)]
    path = str(GALLERY / f"{NAME}.py")
    try:
        simple.RemoveViewsAndLayouts()
        exec(compile(pathlib.Path(path).read_text(), path, "exec"), {"sys": sys, "__file__": path})
    finally:
        sys.argv, sys.path, sys.modules["look"] = before


def arrays(output):
    """All numbers of a data set, by what they are."""
    if output.IsA("vtkCompositeDataSet"):
        blocks = [output.GetBlock(i) for i in range(output.GetNumberOfBlocks())]
        return {(i, *key): value for i, block in enumerate(blocks) for key, value in arrays(block).items()}
    found = {}
    if output.IsA("vtkPointSet"):
        found["points",] = vtk_to_numpy(output.GetPoints().GetData())
    for kind in ("PointData", "CellData", "RowData"):
        attributes = getattr(output, f"Get{kind}", lambda: None)()
        for i in range(attributes.GetNumberOfArrays() if attributes else 0):
            if attributes.GetArray(i):  # else words
                found[kind, attributes.GetArrayName(i)] = vtk_to_numpy(attributes.GetArray(i))
    return {key: np.array(value) for key, value in found.items()}


def pipeline():
    """The numbers of each source and filter, by its name in the pipeline browser. Each column is sorted: VTK 9.6 clips
    on threads, which give points any order."""
    return {name: {key: np.sort(values, axis=0) for key, values in arrays(data(proxy)).items()}
            for (name, _), proxy in simple.GetSources().items()}


def assert_alike(test, drawn, shipped):
    """Up to the few colors of the shipped one, and how a machine draws edges: ParaView 5.11 and 5.13, with Mesa 22
    and 25, differ in less than 4e-4 of the pixels."""
    test.assertEqual(drawn.shape, shipped.shape)
    apart = np.abs(drawn - shipped).max(axis=2)
    test.assertLess((apart > 48).mean(), 0.002, f"{NAME}.png has changed: draw the gallery again")


class Script(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.names = run(cls.folder)
        cls.made = pipeline()
        simple.SaveState(str(cls.folder / f"{NAME}.pvsm"))

    def test_1_gives_what_is_true(self):
        getattr(gallery_truth, NAME)(self.names)

    def test_2_draws_the_picture_of_the_gallery(self):
        colors = read_pixels(self.folder / f"{NAME}.png")
        drawn = np.any(colors != 255, axis=2)
        self.assertGreater(drawn.mean(), 0.25)
        self.assertGreater(len(np.unique(colors[drawn] // 32, axis=0)), 10)
        assert_alike(self, colors, read_pixels(GALLERY / f"{NAME}.png"))

    def test_3_the_state_file_names_no_file_of_this_machine(self):
        state = (self.folder / f"{NAME}.pvsm").read_text()
        self.assertEqual(re.findall(r'"(?:/|~/|[A-Za-z]:[\\/]|file:)[^"/>][^"]*"', state), [])

    def test_4_the_state_file_brings_back_what_the_script_made(self):
        self.check_loading(lambda: simple.LoadState(str(self.folder / f"{NAME}.pvsm")))

    def test_5_the_script_loads_as_a_state(self):
        self.check_loading(load_script_as_state)

    def check_loading(self, load):
        start_anew()
        self.addCleanup(start_anew)
        load()
        loaded = pipeline()
        self.assertEqual(sorted(loaded), sorted(self.made))
        for name, numbers in self.made.items():
            self.assertEqual(loaded[name].keys(), numbers.keys(), name)
            for key, values in numbers.items():
                np.testing.assert_allclose(loaded[name][key], values, rtol=0, atol=1e-6, err_msg=f"{name} {key}")
        views = simple.GetRenderViews()
        self.assertEqual(len(views), 1)
        picture = self.folder / f"{NAME}-loaded.png"
        simple.SaveScreenshot(str(picture), views[0], ImageResolution=views[0].ViewSize)
        shown, shipped = read_pixels(picture), read_pixels(GALLERY / f"{NAME}.png")
        rows, columns = shown.shape[:2]  # of an animation the first picture
        assert_alike(self, shown, shipped[-rows:, :columns])


if __name__ == "__main__":
    if lacks_scan(GALLERY / f"{NAME}.py"):
        print(f"Skipped: {scan.MISSING}")
        sys.exit(77)
    unittest.main()
