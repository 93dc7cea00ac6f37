# SPDX-License-Identifier: BSD-3-Clause
"""In the real GUI the field's filter is in its menu, takes a source, applies and shows the field;
every property of its panel, moved there, does what it says. The other filters are in the menu, take
a source and targets on their panels, and show lines by distance, or a table.

usage: pvpython test_gui.py PARAVIEW FOLDER
"""

import json
import pathlib
import pickle
import sys

import numpy as np

from geodesic_testing import FLOAT, assert_close, distance_to_segments, run_gui
from pixels import read_pixels

paraview, folder = sys.argv[1], pathlib.Path(sys.argv[2])
picture = folder / "geodesic-gui.png"
picture.unlink(missing_ok=True)
for old in folder.glob("geodesic-gui-*.*"):
    old.unlink()

run_gui(paraview, folder, "gui_events.xml", "gui_setup.py")

# On the sheet the distance is that from its middle line: from yellow there over red to blue at both
# sides, about as much yellow as blue.
red, green, blue = np.moveaxis(read_pixels(picture), -1, 0)
near, far = (red > 1.05 * green) & (green > 1.6 * blue), (blue > red) & (blue > 1.5 * green)
assert near.mean() > 0.03 and far.mean() > 0.03, f"near {near.mean():.1%}, far {far.mean():.1%}"
assert 0.5 < near.sum() / far.sum() < 2, f"near {near.mean():.1%}, far {far.mean():.1%}"

middle = np.median(np.where(near | far)[1])
offset_near, offset_far = (np.median(np.abs(np.where(part)[1] - middle)) for part in (near, far))
assert offset_near < 0.5 * offset_far, f"blue is {offset_near} from the middle, red {offset_far}"

# ------------------------------------------------------------------------------ what was applied
SHEET = 800  # triangles
DIAGONAL = np.sqrt(2)
ANGLES = np.linspace(0, 2 * np.pi, 61)
RING = [(-0.25 + 0.15 * np.cos(angle), 0.15 * np.sin(angle), 0) for angle in ANGLES]
LINE = [(0, -0.5, 0), (0, 0.5, 0)]
DEFAULTS = {"Input": "Sheet", "Source": None, "SourceType": 0, "Accuracy": 0, "RelativeError": 0.001,
            "RefineMesh": 1, "RefinementTolerance": 0.001, "ToleranceIsAbsolute": 0,
            "AbsoluteRefinementTolerance": 1, "MaximumNumberOfCells": 50000000,
            "OutputPointsPrecision": 2,
            "RefineSourceBorders": 0, "MaximumDistance": 0, "MergeCoincidentPoints": 1,
            "MergeTolerance": 0,
            "UnreachedValue": 0, "CustomUnreachedValue": -1, "RemoveUnusedPoints": 0,
            "BarrierArrayName": "None", "JoinLines": 1, "SourceIdArrayName": "None",
            "DistanceArrayName": "GeodesicDistance",
            "GenerateSourceIds": 0, "GenerateClosestPoints": 0, "GenerateGradients": 0,
            "GenerateSignedDistance": 0, "GenerateSourceArcLength": 0, "GenerateSourceAngle": 0,
            "GenerateTextureCoordinates": 0, "TextureScale": 0, "TextureRepeats": 1, "ColorByStripes": 1}


class Applied:
    """What an execution was asked for and gave."""

    def __init__(self, number):
        with open(folder / f"geodesic-gui-{number}.pickle", "rb") as file:
            record = pickle.load(file)
        self.properties = record["properties"]
        self.points, self.triangles = record["points"], record["triangles"]
        self.distances = record["arrays"].get(self.properties["DistanceArrayName"])
        self.arrays = set(record["arrays"])
        self.error = record["field data"]["RelativeErrorBound"]
        self.interpolation = record["field data"]["InterpolationErrorBound"]

    def to(self, curve):
        return distance_to_segments(self.points, curve)

    def to_sides(self):
        """To the boundary of each half, the seam included."""
        x, y = np.abs(self.points[:, 0]), np.abs(self.points[:, 1])
        return np.minimum(np.minimum(x, 0.5 - x), 0.5 - y)

    def measured(self, curve):
        """The largest difference between interpolant and distance that occurs at some points."""
        corners, values = self.points[self.triangles], self.distances[self.triangles]
        worst = 0
        for weights in np.random.default_rng(1).dirichlet((1, 1, 1), 30):
            positions = np.einsum("k,tkj->tj", weights, corners)
            truth = distance_to_segments(positions, curve)
            worst = max(worst, np.max(np.abs(values @ weights - truth)))
        return worst


count = len(list(folder.glob("geodesic-gui-[0-9]*.pickle")))
assert count == 21, f"{count} executions"
runs = [Applied(number) for number in range(count)]

# Of two applies nothing but what was moved differs.
asked = dict(DEFAULTS)
for number, moved in enumerate((
        {"Source": "Curve"}, {"Source": "Ring"}, {"RefinementTolerance": 0.005},
        {"ToleranceIsAbsolute": 1, "AbsoluteRefinementTolerance": 0.0003},
        {"MaximumNumberOfCells": 1500}, {"RefineMesh": 0}, {"Accuracy": 1}, {"RelativeError": 0.1},
        {"Accuracy": 0, "MaximumDistance": 0.3}, {"MaximumDistance": 0, "MergeCoincidentPoints": 0, "JoinLines": 0},
        {"DistanceArrayName": "Depth"}, {"SourceType": 1}, {"SourceType": 2},
        {"BarrierArrayName": "Wall"}, {"GenerateSourceIds": 1}, {"GenerateClosestPoints": 1},
        {"GenerateGradients": 1}, {"GenerateSignedDistance": 1}, {"GenerateSourceArcLength": 1},
        {"GenerateSourceAngle": 1}, {"GenerateTextureCoordinates": 1, "TextureScale": 0.25})):
    asked.update(moved)
    assert runs[number].properties == asked, f"{number}: {runs[number].properties}"
MOVED_ELSEWHERE = {"ColorByStripes", "TextureRepeats", "UnreachedValue", "CustomUnreachedValue", "RemoveUnusedPoints",
                   "RefineSourceBorders", "OutputPointsPrecision", "SourceIdArrayName",
                   "MergeTolerance"}
assert not DEFAULTS.keys() - {"Input"} - MOVED_ELSEWHERE - {
    name for name in DEFAULTS if any(run.properties[name] != DEFAULTS[name] for run in runs)}

assert_close(runs[0].distances, runs[0].to(LINE), FLOAT)
for run in runs[1:6]:
    assert_close(run.distances, run.to(RING), FLOAT)

# The tolerances, the cap, and no refinement.
fine, coarse, absolute, capped, plain = runs[1:6]
for run, tolerance in ((fine, 0.001 * DIAGONAL), (coarse, 0.005 * DIAGONAL), (absolute, 0.0003)):
    assert run.measured(RING) <= run.interpolation + FLOAT
    assert run.interpolation <= tolerance, f"{run.interpolation} for {tolerance}"
sizes = [len(run.triangles) for run in (plain, coarse, fine, absolute)]
assert sizes[0] == SHEET and sizes == sorted(set(sizes)), sizes
assert SHEET < len(capped.triangles) <= 1500, len(capped.triangles)
assert 0.0003 < capped.interpolation and capped.measured(RING) <= capped.interpolation + FLOAT
assert plain.interpolation == np.inf

# Approximate: never over the exact distance, and as far under it as certified.
for run, epsilon in ((runs[6], 0.001), (runs[7], 0.1)):
    exact = run.to(RING)
    assert 0 < run.error <= epsilon, run.error
    assert np.all(run.distances <= exact + FLOAT)
    assert np.all(exact - run.distances <= run.error * exact + FLOAT)
assert runs[7].error > runs[6].error and all(run.error == 0 for run in runs[:6] + runs[8:])

# Up to the maximum distance, in whole triangles.
limited = runs[8]
exact, reached = limited.to(RING), np.isfinite(limited.distances)
assert_close(limited.distances[reached], exact[reached], FLOAT)
touched = exact[limited.triangles].min(axis=1) < 0.3
assert reached[limited.triangles[touched]].all() and not reached[exact > 0.4].any()

# The halves share no points: without merging the ring's half alone is reached.
is_left = np.isin(np.arange(len(plain.points)), plain.triangles[
    plain.points[plain.triangles].mean(axis=1)[:, 0] < 0])
assert_close(runs[9].distances, np.where(is_left, runs[9].to(RING), np.inf), FLOAT)

named = runs[10]
assert "Depth" in named.arrays and "GeodesicDistance" not in named.arrays, named.arrays
np.testing.assert_array_equal(named.distances, runs[9].distances)

boundary, both, walled = runs[11:14]
assert_close(boundary.distances, boundary.to_sides(), FLOAT)
expected = np.where(is_left, np.minimum(both.to_sides(), both.to(RING)), both.to_sides())
assert_close(both.distances, expected, FLOAT)

# The strip between 0.2 and 0.3 is a barrier, which parts the right half in two.
x, y = walled.points[:, 0], np.abs(walled.points[:, 1])
to_end = np.where(x < 0.25, x, 0.5 - x)
right = np.where((x > 0.2 + FLOAT) & (x < 0.3 - FLOAT), np.inf, np.minimum(to_end, 0.5 - y))
assert_close(walled.distances, np.where(is_left, expected, right), FLOAT)

# Each array comes with its property, and changes no distance.
for before, after, name in zip(runs[13:], runs[14:], (
        "SourceId", "ClosestSourcePoint", "DistanceGradient", "SignedGeodesicDistance", "SourceArcLength",
        "SourceAngle", "SourceTextureCoordinates")):
    assert after.arrays == before.arrays | {name}, after.arrays
    np.testing.assert_array_equal(after.distances, walled.distances)


# ----------------------------------------------------------------------------- the other filters
def answer(name, **asked):
    """What another filter has given, having been asked for that."""
    with open(folder / f"geodesic-gui-{name}.pickle", "rb") as file:
        record = pickle.load(file)
    asked.update({"Input": "Sheet", "Source": "Curve", "SourceType": 0, "BarrierArrayName": "None"})
    wrong = {key: record["properties"].get(key) for key in asked
             if record["properties"].get(key) != asked[key]}
    assert not wrong, f"{name}: {wrong}"
    return record["arrays"], record["points"]


# A tenth of the sheet's side at both sides of the line along its seam.
arrays, points = answer("GeodesicContour", Distances=0.1, ToleranceIsAbsolute=0, SignedDistances=0)
np.testing.assert_array_equal(arrays["GeodesicDistance"], [0.1, 0.1])
assert_close(np.abs(points[:, 0]), np.full(len(points), 0.1), FLOAT)

ring = np.array(RING[:-1])
arrays, points = answer("GeodesicPaths", Targets="Ring")
assert_close(arrays["GeodesicDistance"], -ring[arrays["TargetId"], 0], FLOAT)
assert len(arrays["TargetId"]) == len(ring)

arrays, _ = answer("GeodesicDistanceMatrix", Targets="Ring", MaximumDistance=0)
assert list(arrays) == ["TargetId", "Source0"], list(arrays)
assert_close(arrays["Source0"], -ring[:, 0], FLOAT)
shown = json.loads((folder / "geodesic-gui-shown.json").read_text())
assert shown["views"] == ["RenderView", "SpreadSheetView"], shown
for name in ("GeodesicContour", "GeodesicPaths"):
    assert not shown["colors"][name][1], shown
    assert shown["visible"][name], shown
