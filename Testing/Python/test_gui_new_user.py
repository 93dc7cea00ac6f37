# SPDX-License-Identifier: BSD-3-Clause
"""A new user in the real GUI: keys draw a curve on the surface, whose length stands in the view; ids have one color
each; gray has a word, and is there only if something is not reached; the color map grows with time.

usage: pvpython test_gui_new_user.py PARAVIEW FOLDER
"""

import json
import pathlib
import sys

import numpy as np

from geodesic_testing import run_gui

paraview, folder = sys.argv[1], pathlib.Path(sys.argv[2])
for old in folder.glob("geodesic-new-user*"):
    old.unlink()

output = run_gui(paraview, folder, "gui_new_user_events.xml")
assert "Traceback" not in output
assert "away from the surface" not in output, "the curve that is there at first is in the air"


def noted(step):
    return json.loads((folder / f"geodesic-new-user-{step}.json").read_text())


# ------------------------------------------------------------------------------------- the drawn curve
curves = {step: np.reshape(noted(step)["points"], (-1, 3))
          for step in ("default", "appended", "beside", "removed")}
np.testing.assert_allclose(np.linalg.norm(curves["default"], axis=1), 0.5, atol=1e-6)
assert len(curves["default"]) == 2 and len(curves["appended"]) == 4, curves
np.testing.assert_array_equal(curves["appended"][:2], curves["default"])
# Where the mouse was: a pixel is below 0.01.
np.testing.assert_allclose(curves["appended"][2:, :2], ((0, 0), (0, 0.2)), atol=0.01)
assert np.all(curves["appended"][2:, 2] > 0.4), curves["appended"]
np.testing.assert_array_equal(curves["beside"], curves["appended"])
np.testing.assert_array_equal(curves["removed"], curves["appended"][:3])

# -------------------------------------------------------------------------- what is selected and shown
for step, name in (("drawn", "GeodesicDistanceFieldFromDrawnCurve1"), ("other", "GeodesicDistanceField1"),
                   ("selected", "GeodesicDistanceField1"), ("front", "GeodesicDistanceField1")):
    seen = noted(f"{step}-shown")
    assert seen["selected"] == name and {f"{name}:0", f"{name}:1"} <= set(seen["shown"]), (step, seen)

# A field hides older ones of the same surface, as it hides the surface.
assert "GeodesicDistanceFieldFromDrawnCurve1:0" in noted("drawn-shown")["shown"]
for step in ("other", "front"):
    shown = noted(f"{step}-shown")["shown"]
    assert not any(name.startswith("GeodesicDistanceFieldFromDrawnCurve1:") for name in shown), (step, shown)

# --------------------------------------------------------------------------------------------- results
ruler = noted("ruler")
assert ruler["length"] > 0.1 and ruler["words"] == [f"Length {ruler['length']:g}"], ruler
assert noted("hidden ruler")["words"] == []
for step in ("panel", "drawn panel"):
    panel = noted(step)
    results = panel["groups"]["Result"]
    assert panel["first"] == results[0] and {"SourceLength", "LargestDistance", "FarthestPoint"} < set(results), panel
place = np.array(ruler["place"])
assert abs(np.linalg.norm(place) - 0.5) < 0.01, ruler
# From the back of the ball to the curve at its front.
to_curve = np.linalg.norm(curves["removed"] - place, axis=1).min()
assert to_curve < ruler["largest"] < to_curve * np.pi / 2 + 0.01, (to_curve, ruler)
assert noted("unused label")["words"] == [], "the curve's length is no other field's"

# ---------------------------------------------------------------------------------------------- colors
near, ids, unused, apart, played = (noted(step) for step in ("other", "ids", "unused", "apart", "played"))
assert ids["array"] == "SourceId" and ids["categories"], ids
# Two curves, one in each half of a slice's many lines: no entry for the ids between.
first, _, second, _ = ids["annotations"]
assert ids["annotations"] == [first, first, second, second] and first == "0" and int(second) > 32, ids
assert len(ids["colors"]) == 6 and ids["colors"][:3] != ids["colors"][3:], ids
for seen in (near, unused):
    assert not seen["has_gray"] and not seen["has_word"], seen
for seen in (apart, played):
    assert seen["has_gray"] and seen["has_word"] and seen["word"] == "not reached", seen

# Nor are they in the bar of ids.
assert "not reached" not in noted("unused ids")["annotations"], noted("unused ids")
assert noted("apart ids")["annotations"][:2] == ["-1", "not reached"], noted("apart ids")

# At the last frame the front goes up to 1.2 in place of 0.4.
assert apart["nodes"][-4] < 0.8 < 1.2 <= played["nodes"][-4], (apart["nodes"], played["nodes"])

# Stripes give way to a texture as long as it is there.
assert noted("texture") == {"array": "", "repeats": 0}, noted("texture")
assert noted("no texture")["array"] == "GeodesicDistance", noted("no texture")
