# SPDX-License-Identifier: BSD-3-Clause
"""A session in the real GUI: the field from a drawn curve follows its handles and the panel; copy
and paste of properties, undo and redo, a link, an animation, a state file and the Python trace all
give the data that they should, in the GUI and in a pvpython that reads the state or runs the trace.

usage: pvpython test_gui_session.py PARAVIEW FOLDER
"""

import os
import pathlib
import pickle
import sys

import numpy as np
from paraview import simple

from geodesic_testing import FLOAT, assert_close, distance_to_segments, run_gui

paraview, folder = sys.argv[1], pathlib.Path(sys.argv[2])
os.environ["GEODESIC_GUI_FOLDER"] = str(folder)
import gui_session  # noqa: E402

for old in folder.glob("geodesic-session*"):
    old.unlink()

output = run_gui(paraview, folder, "gui_session.xml", "gui_session.py")
# The sheet is of triangles and the curve is drawn by hand: there is nothing to say, at no time step.
# A handle is dragged off the surface, which is told; nothing else is said.
said = [line for line in output.splitlines() if "vtkGeodesic" in line]
assert said and all("FromDrawnCurve" in line and "away from the surface" in line for line in said), said
assert "Traceback" not in output, output

FIRST, SECOND = "GeodesicDistanceFieldFromDrawnCurve1", "GeodesicDistanceFieldFromDrawnCurve2"


def read(name):
    with open(folder / f"geodesic-session-{name}.pickle", "rb") as file:
        return pickle.load(file)


def noted(step):
    """The filters at a step, by name."""
    return {record["name"]: record for record in read(step)}


def curve_of(properties):
    """Where the drawn curve lies on the sheet, a square from -0.5 to 0.5 in x and y."""
    curve = np.reshape(properties["Points"], (-1, 3)).clip((-0.5, -0.5, 0), (0.5, 0.5, 0))
    return np.vstack((curve, curve[:1])) if properties["Closed"] == [1] else curve


def check_drawn(record):
    """The distance is that to the drawn curve, within the limit if there is one."""
    values = record["output"]["GeodesicDistance"]
    exact = distance_to_segments(record["output"]["points"], curve_of(record["properties"]))
    limit, = record["properties"]["MaximumDistance"]
    if limit:
        reached = np.isfinite(values)
        assert reached[exact < limit].all() and not reached[exact > limit + 0.15].any()
        exact[~reached] = np.inf
    assert_close(values, exact, FLOAT)


def check_point(output, source):
    exact = np.linalg.norm(output["points"] - source, axis=1)
    assert_close(output["GeodesicDistance"], exact, FLOAT)


def check_same(one, other):
    """Two filters with the same properties and the same output."""
    assert one["properties"] == other["properties"], (one["properties"], other["properties"])
    assert one["output"].keys() == other["output"].keys(), (one["output"], other["output"])
    for name, values in one["output"].items():
        np.testing.assert_array_equal(values, other["output"][name])


# -------------------------------------------------------------------------------- the drawn curve
drawn = {step: noted(step)[FIRST] for step in ("default", "dragged", "closed")}
for record in drawn.values():
    check_drawn(record)
assert drawn["default"]["properties"]["Points"] == [-0.5, 0, 0, 0.5, 0, 0]

# A quarter of the view's height is 0.4 of the sheet; a pixel is below 0.01.
start, end = np.reshape(drawn["dragged"]["properties"]["Points"], (-1, 3))
np.testing.assert_array_equal(start, (-0.5, 0, 0))
np.testing.assert_allclose(end, (0.5, 0.4, 0), rtol=0, atol=0.01)
assert end[1] != 0

asked = drawn["closed"]["properties"]
assert len(asked["Points"]) == 9 and asked["Closed"] == [1], asked
assert asked["Points"][:6] == drawn["dragged"]["properties"]["Points"], asked
assert "SourceId" in drawn["closed"]["output"]

# -------------------------------------------------------------- copy and paste, undo and redo, link
pasted = noted("pasted")
check_same(pasted[FIRST], drawn["closed"])
check_same(pasted[SECOND], drawn["closed"])

limited, undone, redone = read("undo")[:3]
assert [run["properties"]["MaximumDistance"] for run in (limited, undone, redone)] == [[0.2], [0], [0.2]]
check_drawn(limited)
check_same(undone, pasted[SECOND])
check_same(redone, limited)
check_same(noted("redone")[SECOND], limited)

linked = noted("linked")
for name in (FIRST, SECOND):
    assert linked[name]["properties"]["RefinementTolerance"] == [0.02], linked[name]["properties"]
    check_drawn(linked[name])
    assert len(linked[name]["output"]["points"]) < len(pasted[name]["output"]["points"])

# ---------------------------------------------------------------------------- a source that moves
frames = read("frames")
along = [frame["source"][0] for frame in frames]
np.testing.assert_allclose(along, np.linspace(-0.4, 0.4, gui_session.FRAMES), rtol=0, atol=1e-12)
for frame in frames:
    check_point(frame["output"], frame["source"])

# ------------------------------------------------------------------------------------- the trace
def now():
    """The filters of this process, by name."""
    for _, proxy in gui_session.filters():
        proxy.UpdatePipeline()
    return {name: {"properties": gui_session.properties_of(proxy),
                   "output": gui_session.output_of(proxy)}
            for name, proxy in gui_session.filters()}


trace = folder / "geodesic-session-trace.py"
exec(compile(trace.read_text(), str(trace), "exec"), {})  # pylint: disable=exec-used
here_now = now()
expected = noted("closed")
assert here_now.keys() == expected.keys(), here_now.keys()
for name, record in expected.items():
    check_same(here_now[name], record)
simple.ResetSession()

# ------------------------------------------------------------------------------------- the state
played, loaded = read("played"), read("loaded")
assert sorted(2 * [record["name"] for record in played]) == sorted(record["name"] for record in loaded)
for record in loaded:
    check_same(record, next(before for before in played if before["name"] == record["name"]))

simple.LoadState(str(folder / "geodesic-session.pvsm"))
here_now = now()
assert len(here_now) == 3
for record in played:
    check_same(here_now[record["name"]], record)

# The link is there, too.
gui_session.named(FIRST).RefinementTolerance = 0.01
assert gui_session.named(SECOND).RefinementTolerance == 0.01
