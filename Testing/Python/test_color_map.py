# SPDX-License-Identifier: BSD-3-Clause
"""The color map that comes with the plugin has stripes of one width, and shows them as wide as it is
scaled to.

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

load_plugin()
sys.path.insert(0, f"{sys.argv[1]}/gallery")
import look  # noqa: E402

LENGTH = 4.0  # of the sheet, away from the source


def edges_of(picture):
    """Where stripes meet along the row in the middle of a picture of the sheet, and its ends."""
    colors = read_pixels(picture)
    row = colors[colors.shape[0] // 2]
    on_sheet = np.flatnonzero(np.any(row != row[0], axis=1))
    sheet = row[on_sheet[0]:on_sheet[-1] + 1]
    return np.flatnonzero(np.abs(np.diff(sheet, axis=0)).max(axis=1) > 8) + 1, len(sheet)


def check_stripes(picture, width):
    """Stripes of that width, in units of the sheet, from its left side on."""
    edges, pixels = edges_of(picture)
    expected = np.arange(1, int(LENGTH / width - 1e-6) + 1) * width / LENGTH * pixels
    assert len(edges) == len(expected), f"{len(edges)} edges, not {len(expected)}"
    assert np.max(np.abs(edges - expected)) <= 1.5, np.column_stack((edges, expected))


def draw(field, picture, width):
    view = simple.CreateView("RenderView")
    view.ViewSize = (900, 700)
    view.OrientationAxesVisibility = 0
    display = simple.Show(field, view)
    simple.ColorBy(display, ("POINTS", "GeodesicDistance"))
    display.LookupTable.ApplyPreset(look.COLOR_MAP, True)
    display.LookupTable.RescaleTransferFunction(0, look.COUNT * width)
    simple.ResetCamera(view)
    simple.SaveScreenshot(str(picture), view, ImageResolution=view.ViewSize)


# Stripes of one width, every second one darker than its neighbors.
look.import_color_map()
table = simple.GetColorTransferFunction("Any")
assert servermanager.vtkSMTransferFunctionPresets.GetInstance().HasPreset(look.COLOR_MAP)
table.ApplyPreset(look.COLOR_MAP, False)
nodes = np.reshape(table.RGBPoints, (-1, 4))  # in a table of steps each has the color before it
assert len(nodes) == look.COUNT + 1 and table.ColorSpace == "Step"
steps = np.linspace(nodes[0, 0], nodes[-1, 0], len(nodes))
np.testing.assert_allclose(nodes[:, 0], steps, rtol=0, atol=1e-12)
bright = nodes[1:, 1:].sum(axis=1)
assert np.all(bright[1::2] < 0.85 * bright[::2]) and np.all(bright[1:-1:2] < 0.85 * bright[2::2])

# On a sheet with its left side as the source, where the distance is x.
side = polyline([(0, 0, 0), (0, 3, 0)])
field = simple.GeodesicDistanceField(Input=plane(), Source=side)
with tempfile.TemporaryDirectory() as folder:
    picture = pathlib.Path(folder) / "stripes.png"
    for width in (LENGTH / look.COUNT, 0.25):
        draw(field, picture, width)
        check_stripes(picture, width)
