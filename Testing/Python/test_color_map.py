# SPDX-License-Identifier: BSD-3-Clause
"""The color map that comes with the plugin has stripes of one width, and the example draws them as
wide as it is asked to.

usage: pvpython --dr test_color_map.py EXAMPLES

With --dr ParaView does not write what is imported to the user's settings.
"""

import pathlib
import sys
import tempfile

import numpy as np
from paraview import servermanager, simple

from geodesic_testing import load_plugin, plane, polyline
from pixels import read_pixels

sys.path.insert(0, sys.argv[1])
import color_map  # noqa: E402

load_plugin()
LENGTH = 4.0  # of the sheet, away from the source


def edges_of(picture):
    """Where stripes meet along the row in the middle of a picture of the sheet, and its ends."""
    colors = read_pixels(picture)
    row = colors[colors.shape[0] // 2]  # above the legend
    on_sheet = np.flatnonzero(np.any(row != row[0], axis=1))
    sheet = row[on_sheet[0]:on_sheet[-1] + 1]
    return np.flatnonzero(np.abs(np.diff(sheet, axis=0)).max(axis=1) > 8) + 1, len(sheet)


def check_stripes(picture, width):
    """Stripes of that width, in units of the sheet, from its left side on."""
    edges, pixels = edges_of(picture)
    expected = np.arange(1, int(LENGTH / width - 1e-6) + 1) * width / LENGTH * pixels
    assert len(edges) == len(expected), f"{len(edges)} edges, not {len(expected)}"
    assert np.max(np.abs(edges - expected)) <= 1.5, np.column_stack((edges, expected))


# Stripes of one width, every second one darker than its neighbors.
simple.ImportPresets(filename=str(color_map.find_color_map()))
table = simple.GetColorTransferFunction("Any")
assert servermanager.vtkSMTransferFunctionPresets.GetInstance().HasPreset(color_map.STRIPES)
table.ApplyPreset(color_map.STRIPES, False)
nodes = np.reshape(table.RGBPoints, (-1, 4))  # in a table of steps each has the color before it
assert len(nodes) == color_map.COUNT + 1 and table.ColorSpace == "Step"
steps = np.linspace(nodes[0, 0], nodes[-1, 0], len(nodes))
np.testing.assert_allclose(nodes[:, 0], steps, rtol=0, atol=1e-12)
bright = nodes[1:, 1:].sum(axis=1)
assert np.all(bright[1::2] < 0.85 * bright[::2]) and np.all(bright[1:-1:2] < 0.85 * bright[2::2])

# On a sheet with its left side as the source, where the distance is x.
side = polyline([(0, 0, 0), (0, 3, 0)])
field = simple.GeodesicDistanceField(Input=plane(), Source=side)
with tempfile.TemporaryDirectory() as folder:
    file, picture = pathlib.Path(folder) / "field.vtp", pathlib.Path(folder) / "stripes.png"
    simple.SaveData(str(file), field, DataMode="Binary")
    color_map.main(str(file), str(picture))
    check_stripes(picture, LENGTH / color_map.COUNT)
    color_map.main(str(file), str(picture), "0.25")
    check_stripes(picture, 0.25)
