# SPDX-License-Identifier: BSD-3-Clause
"""In an animation in which one frame has an error every other frame looks as that of a pipeline of
its own, before and after; the one with the error shows nothing of the filter, and scripts learn of it.

usage: pvpython --dr test_failed_frame.py [FOLDER]

FOLDER is where the pictures stay.
"""

import functools
import pathlib
import sys
import tempfile
import unittest

from paraview import simple

import failed_frame
from geodesic_testing import load_plugin, messages, view_of
from pixels import read_pixels

load_plugin()
FOLDER = sys.argv.pop(1) if len(sys.argv) > 1 else None


def picture(view, name):
    view.ViewSize = (300, 250)
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(FOLDER or folder) / f"failed-frame-{name}.png"
        simple.SaveScreenshot(str(file), view, ImageResolution=view.ViewSize)
        return read_pixels(file)


@functools.lru_cache(maxsize=None)
def fresh_picture(kind, place):
    """That of a pipeline and a view which have never seen another place."""
    view = simple.CreateView("RenderView")
    view.OrientationAxesVisibility = 0
    made, _ = failed_frame.pipeline(kind, place)
    failed_frame.show(made, view)
    colors = picture(view, f"{kind.__name__}-fresh-{place:.3f}")
    failed_frame.delete(made)
    simple.Delete(view)
    return colors


class OneFrameFails(unittest.TestCase):
    def check(self, kind, failing):
        view = view_of(self)
        made, section = failed_frame.pipeline(kind, 0.0)
        failed_frame.show(made, view)
        scene = failed_frame.animate(section, failing)
        algorithm = made.GetClientSideObject()
        frames = []
        for time in [*failed_frame.TIMES] * 2:
            is_wrong = len(frames) % failed_frame.FRAMES == failing
            with messages() as said:
                scene.AnimationTime = time
                colors = picture(view, f"{kind.__name__}-{failing}-{len(frames)}")
            frames.append((section.SliceType.Origin[0], colors))
            self.assertEqual("source (input port 1) is empty" in said.GetOutput(), is_wrong)
            self.assertEqual(algorithm.GetErrorCode() != 0, is_wrong)
            self.assertEqual("source (input port 1) is empty" in made.ErrorMessage, is_wrong)
            self.assertEqual(made.ErrorMessage != "", is_wrong)
            self.assertEqual(made.GetDataInformation().GetNumberOfPoints() == 0, is_wrong)
        failed_frame.check(frames, failing, functools.partial(fresh_picture, kind))

    def test_the_last_one_of_a_field(self):
        self.check(failed_frame.field, failed_frame.FRAMES - 1)

    def test_one_in_the_middle_of_a_field(self):
        self.check(failed_frame.field, 5)

    def test_the_last_one_of_a_contour(self):
        self.check(failed_frame.contour, failed_frame.FRAMES - 1)

    def test_one_in_the_middle_of_a_contour(self):
        self.check(failed_frame.contour, 5)


if __name__ == "__main__":
    unittest.main()
