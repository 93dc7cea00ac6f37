# SPDX-License-Identifier: BSD-3-Clause
"""A script of the gallery gives what is true, its picture and its state are those in the gallery, and
the state brings back in a new session what the script made.

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
            found[kind, attributes.GetArrayName(i)] = vtk_to_numpy(attributes.GetArray(i))
    return {key: np.array(value) for key, value in found.items()}


def pipeline():
    """The numbers of each source and filter, by its name in the pipeline browser."""
    return {name: arrays(data(proxy)) for (name, _), proxy in simple.GetSources().items()}


def start_anew():
    """A session with nothing in it. What draws goes first: ParaView does not survive its going last."""
    for view in simple.GetRenderViews():
        simple.Delete(view)
    simple.ResetSession()


def assert_alike(test, picture, shipped):
    """Up to the few colors of the shipped one, and how a machine draws edges."""
    drawn, expected = read_pixels(picture), read_pixels(shipped)
    test.assertEqual(drawn.shape, expected.shape)
    apart = np.abs(drawn - expected).max(axis=2)
    test.assertLess((apart > 48).mean(), 0.02, f"{picture.name} has changed: draw the gallery again")


class Script(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.names = run(cls.folder)
        cls.made = pipeline()

    def test_1_gives_what_is_true(self):
        getattr(gallery_truth, NAME)(self.names)

    def test_2_draws_the_picture_of_the_gallery(self):
        colors = read_pixels(self.folder / f"{NAME}.png")
        drawn = np.any(colors != 255, axis=2)
        self.assertGreater(drawn.mean(), 0.25)
        self.assertGreater(len(np.unique(colors[drawn] // 32, axis=0)), 10)
        assert_alike(self, self.folder / f"{NAME}.png", GALLERY / f"{NAME}.png")

    def test_3_the_state_of_the_gallery_knows_no_machine(self):
        state = (GALLERY / f"{NAME}.pvsm").read_text()
        self.assertEqual(re.findall(r'"(?:/|~/|[A-Za-z]:[\\/]|file:)[^"/>][^"]*"', state), [])

    def test_4_the_state_brings_back_what_the_script_made(self):
        start_anew()
        self.addCleanup(start_anew)
        simple.LoadState(str(GALLERY / f"{NAME}.pvsm"))
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
        apart = np.abs(shown - shipped[-rows:, :columns]).max(axis=2)
        self.assertLess((apart > 48).mean(), 0.02)


if __name__ == "__main__":
    unittest.main()
