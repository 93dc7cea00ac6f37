# SPDX-License-Identifier: BSD-3-Clause
"""Draws the whole gallery: runs each of its scripts, which write their pictures and states into FOLDER.

usage: pvpython all.py FOLDER
"""

import pathlib
import subprocess
import sys

NO_SCRIPTS = ("all", "look", "small_png")


def main(folder):
    for script in sorted(pathlib.Path(__file__).resolve().parent.glob("*.py")):
        if script.stem not in NO_SCRIPTS:
            print(script.stem, flush=True)
            # --dr: the color map that a script imports is not kept with the user's settings.
            subprocess.run(["pvpython", "--dr", str(script), folder], check=True)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
