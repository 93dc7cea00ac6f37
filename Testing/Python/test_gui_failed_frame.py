# SPDX-License-Identifier: BSD-3-Clause
"""The play button of the real GUI, pressed twice, shows every frame of an animation as a pipeline of its
own does, whichever frame has an error; that frame shows nothing. Each error is one message.

usage: pvpython test_gui_failed_frame.py PARAVIEW FOLDER
"""

import pathlib
import pickle
import re
import sys

import failed_frame
from geodesic_testing import run_gui

paraview, folder = sys.argv[1], pathlib.Path(sys.argv[2])
for old in folder.glob("geodesic-failed*"):
    old.unlink()

output = run_gui(paraview, folder, "gui_failed_frame_events.xml")
assert "Traceback" not in output, output

animations = sorted(folder.glob("geodesic-failed-*.pickle"))
assert [file.stem[16:] for file in animations] == ["contour-5", "field-9"], animations
for file in animations:
    with open(file, "rb") as pickled:
        record = pickle.load(pickled)
    assert len(record["frames"]) == 2 * failed_frame.FRAMES, len(record["frames"])
    # Where lines cross, the one in front depends on how deep the window's scene is: four pixels of 75,000.
    failed_frame.check(record["frames"], record["failing"], record["fresh"].get, allowed=0.0005)

errors = re.findall(r"ERR\| vtk.*", output)
assert len(errors) == 2 * len(animations) and all("is empty" in error for error in errors), errors
