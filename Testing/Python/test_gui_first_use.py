# SPDX-License-Identifier: BSD-3-Clause
"""A newcomer's first minutes in the real GUI: the panel says what is missing before Apply; an Apply
without a source gives one message; the next one shows the distance in colors and its numbers on the
panel; properties for points that are not reached do what they say.

usage: pvpython test_gui_first_use.py PARAVIEW FOLDER
"""

import pathlib
import pickle
import re
import sys

import numpy as np
from paraview import simple

from geodesic_testing import run_gui
from pixels import read_pixels

paraview, folder = sys.argv[1], pathlib.Path(sys.argv[2])
here = pathlib.Path(__file__).resolve().parent
for old in folder.glob("geodesic-first*"):
    old.unlink()

events = (here / "gui_first_use_events.xml").read_text()
if simple.GetParaViewVersion() >= (5, 13):
    events = events.replace('infinity "inf"', 'infinity "Infinity"')
(folder / "geodesic-first-events.xml").write_text(events)

output = run_gui(
    paraview, folder, folder / "geodesic-first-events.xml", "gui_first_use_setup.py")

# One message for the Apply without a source. The line is 1.2 % of the sheets' size above them: one
# warning for each filter, though the field is executed five times.
errors = re.findall(r"ERR\| vtk.*", output)
assert len(errors) == 1 and "choose a Source, or set Source Type" in errors[0], errors
warnings = re.findall(r"WARN\| vtkGeodesic.*", output)
assert len(warnings) == 3, warnings
assert all("up to 0.02 away" in warning for warning in warnings), warnings

# Yellow on both sides of the source, which is green; blue far from it; every second stripe darker.
red, green, blue = np.moveaxis(read_pixels(folder / "geodesic-first.png"), -1, 0)
near = ((red > 1.05 * green) & (green > 1.6 * blue)).mean()
far = ((blue > red) & (blue > 1.5 * green)).mean()
source = (green > 1.25 * np.maximum(red, blue)).mean()
assert near > 0.03 and far > 0.03 and source > 0.002, f"near {near:.1%}, far {far:.1%}, source {source:.1%}"


def applied(number):
    with open(folder / f"geodesic-first-{number}.pickle", "rb") as file:
        return pickle.load(file)


count = len(list(folder.glob("geodesic-first-*.pickle")))
assert count == 6, f"{count} executions"
failed, infinite, nan, custom, removed, plain = (applied(number) for number in range(count))
assert len(failed["distances"]) == 0
apart = np.isinf(infinite["distances"])
assert apart.any() and not apart.all()
np.testing.assert_array_equal(np.isnan(nan["distances"]), apart)
np.testing.assert_array_equal(custom["distances"] == -2, apart)
np.testing.assert_array_equal(custom["distances"][~apart], infinite["distances"][~apart])
assert [run["asked"]["UnreachedValue"] for run in (infinite, nan, custom)] == [0, 1, 2]
assert removed["asked"]["RemoveUnusedPoints"] == 1
# Every point of the sheets is used.
np.testing.assert_array_equal(removed["distances"], custom["distances"])
assert len(plain["distances"]) <= len(removed["distances"])
