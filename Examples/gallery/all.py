# SPDX-License-Identifier: BSD-3-Clause
"""Makes the whole gallery: runs each of its scripts and writes their pictures, or their states, into FOLDER.

usage: pvpython all.py [--states] FOLDER
"""

import pathlib
import runpy
import subprocess
import sys

import scan
from paraview import simple

NO_SCRIPTS = ("all", "look", "scan", "small_png")


def draw(script, folder):
    # --dr: the color maps of the plugin are not kept with the user's settings.
    subprocess.run(["pvpython", "--dr", str(script), folder], check=True)


def save_state(script, folder):
    """Needs no screen, as nothing is drawn."""
    sys.argv = [str(script)]
    runpy.run_path(str(script))
    simple.SaveState(f"{folder}/{script.stem}.pvsm")
    start_anew()


def start_anew():
    """Leaves a session with nothing in it. ParaView crashes unless the views are deleted first."""
    for view in simple.GetRenderViews():
        simple.Delete(view)
    simple.ResetSession()


def lacks_scan(script):
    return not scan.FOLDER.exists() and "= scan." in script.read_text()


def main(make, folder):
    pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
    for script in sorted(pathlib.Path(__file__).resolve().parent.glob("*.py")):
        if script.stem in NO_SCRIPTS:
            continue
        if lacks_scan(script):
            print(f"{script.stem} is left out: {scan.MISSING}", flush=True)
            continue
        print(script.stem, flush=True)
        make(script, folder)


if __name__ == "__main__":
    *options, folder = sys.argv[1:] or [None]
    if folder is None or options not in ([], ["--states"]):
        sys.exit(__doc__)
    main(save_state if options else draw, folder)
