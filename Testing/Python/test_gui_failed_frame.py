# SPDX-License-Identifier: BSD-3-Clause
"""The play button of the real GUI, pressed twice, shows every frame of an animation as a pipeline of its
own does, whichever frame has an error; that frame shows nothing. Each error is one message.

usage: pvpython test_gui_failed_frame.py PARAVIEW FOLDER
"""

import os
import pathlib
import pickle
import re
import subprocess
import sys

import failed_frame

paraview, folder = sys.argv[1], pathlib.Path(sys.argv[2])
here = pathlib.Path(__file__).resolve().parent
for old in folder.glob("geodesic-failed*"):
    old.unlink()

# Each event that finds no widget, and each check that does not hold, ends ParaView with an error.
run = subprocess.run(
    ["timeout", "250", paraview, "--dr", f"--test-directory={folder}",
     f"--test-script={here / 'gui_failed_frame_events.xml'}", "--exit"],
    env={**os.environ, "GEODESIC_GUI_FOLDER": str(folder)}, text=True,
    stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
assert run.returncode == 0, run.stdout
print(run.stdout)
assert "Traceback" not in run.stdout, run.stdout

animations = sorted(folder.glob("geodesic-failed-*.pickle"))
assert [file.stem[16:] for file in animations] == ["contour-5", "contour-9", "field-5", "field-9"], animations
for file in animations:
    with open(file, "rb") as pickled:
        record = pickle.load(pickled)
    assert len(record["frames"]) == 2 * failed_frame.FRAMES, len(record["frames"])
    # Where lines cross, the one in front depends on how deep the window's scene is: four pixels of 75,000.
    failed_frame.check(record["frames"], record["failing"], record["fresh"].get, allowed=0.0005)

errors = re.findall(r"ERR\| vtk.*", run.stdout)
assert len(errors) == 2 * len(animations) and all("is empty" in error for error in errors), errors
