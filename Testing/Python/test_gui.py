# SPDX-License-Identifier: BSD-3-Clause
"""In the real GUI the filter is in its menu, takes a source, applies and shows the field.

usage: pvpython test_gui.py PARAVIEW FOLDER
"""

import pathlib
import subprocess
import sys

import numpy as np

from pixels import read_pixels

paraview, folder = sys.argv[1:]
here = pathlib.Path(__file__).resolve().parent
picture = pathlib.Path(folder) / "geodesic-gui.png"
picture.unlink(missing_ok=True)

# Each event that finds no widget ends ParaView with an error. timeout also ends what the launcher
# has started.
subprocess.run(
    ["timeout", "100", paraview, "--dr", f"--test-directory={folder}",
     f"--script={here / 'gui_setup.py'}", f"--test-script={here / 'gui_events.xml'}", "--exit"],
    check=True)

# On the sheet the distance is that from its middle line: from blue there to red at both sides, about
# as much of one as of the other.
colors = read_pixels(picture)
warmth = colors[:, :, 0] - colors[:, :, 2]
near, far = warmth < -60, warmth > 60
assert near.mean() > 0.03 and far.mean() > 0.03, f"near {near.mean():.1%}, far {far.mean():.1%}"
assert 0.5 < near.sum() / far.sum() < 2, f"near {near.mean():.1%}, far {far.mean():.1%}"

middle = np.median(np.where(near | far)[1])
offset_near, offset_far = (np.median(np.abs(np.where(part)[1] - middle)) for part in (near, far))
assert offset_near < 0.5 * offset_far, f"blue is {offset_near} from the middle, red {offset_far}"
