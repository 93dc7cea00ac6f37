# SPDX-License-Identifier: BSD-3-Clause
"""Distances come up in stripes of one round width, which a picture shows where they are, with ticks of
the scalar bar where stripes meet; the side of a curve in two colors; ParaView's colors without it.

usage: pvpython --dr test_color_map.py

With --dr ParaView does not write what the plugin adds to its presets to the user's settings.
"""

import pathlib
import tempfile
import unittest

import numpy as np
from paraview import servermanager, simple

from geodesic_testing import load_plugin, plane, polyline, view_of
from pixels import read_pixels

load_plugin()
LENGTH = 4.0  # of the sheet
PRESETS = "Geodesic Distance Stripes", "Signed Geodesic Distance Stripes"


def edges_of(picture):
    """Where stripes meet along the row in the middle of a picture of the sheet, and its ends."""
    colors = read_pixels(picture)
    row = colors[colors.shape[0] // 2]
    on_sheet = np.flatnonzero(np.any(row != row[0], axis=1))
    sheet = row[on_sheet[0]:on_sheet[-1] + 1]
    return np.flatnonzero(np.abs(np.diff(sheet, axis=0)).max(axis=1) > 8) + 1, len(sheet)


def nodes(table):
    """Position and color; in a table of steps each has the color before it."""
    return np.reshape(table.RGBPoints, (-1, 4))


def field_at(x, **asked):
    """Of a sheet from x = 0 to 4, from a line across it."""
    return simple.GeodesicDistanceField(Input=plane(), Source=polyline([(x, 0, 0), (x, 3, 0)]), **asked)


class Stripes(unittest.TestCase):
    def setUp(self):
        self.view = view_of(self)

    def show(self, field, array=None):
        display = simple.Show(field, self.view)
        if array:
            simple.ColorBy(display, ("POINTS", array))
            display.RescaleTransferFunctionToDataRange(False, True)
        return display

    def assert_stripes(self, table, low, high, width):
        self.assertEqual(table.ColorSpace, "Step")
        expected = np.arange(round(low / width), round(high / width) + 1) * width
        np.testing.assert_allclose(nodes(table)[:, 0], expected, atol=1e-9)

    def test_are_there_when_a_field_is_shown_first(self):
        display = self.show(field_at(0))
        self.assertEqual(list(display.ColorArrayName), ["POINTS", "GeodesicDistance"])
        self.assert_stripes(display.LookupTable, 0, 4, 0.1)
        bright = nodes(display.LookupTable)[1:, 1:].sum(axis=1)
        self.assertTrue(np.all(bright[1::2] < 0.85 * bright[::2]))
        self.assertTrue(np.all(bright[1:-1:2] < 0.85 * bright[2::2]))

    def test_have_a_round_width_and_there_are_15_to_40_of_them(self):
        table = self.show(field_at(0)).LookupTable
        for scale in np.geomspace(1e-7, 1e7, 60):
            table.RescaleTransferFunction(0, scale)
            ends = nodes(table)[:, 0]
            width = ends[1]
            self.assertTrue(15 <= len(ends) - 1 <= 40, (scale, len(ends)))
            self.assertTrue(scale * (1 - 1e-6) <= ends[-1] < scale + width, (scale, ends[-1]))
            self.assertIn(f"{width:e}"[:3], ("1.0", "2.0", "5.0"))
            self.assertEqual(ends[0], 0)

    def test_are_seen_where_they_are(self):
        display = self.show(field_at(0))
        simple.ResetCamera(self.view)
        with tempfile.TemporaryDirectory() as folder:
            for largest, width in ((4, 0.1), (8, 0.2)):
                display.LookupTable.RescaleTransferFunction(0, largest)
                picture = pathlib.Path(folder) / "stripes.png"
                simple.SaveScreenshot(str(picture), self.view, ImageResolution=self.view.ViewSize)
                edges, pixels = edges_of(picture)
                expected = np.arange(1, round(LENGTH / width)) * width / LENGTH * pixels
                self.assertEqual(len(edges), len(expected))
                self.assertLessEqual(np.max(np.abs(edges - expected)), 1.5)

    def test_ticks_of_the_bar_are_where_stripes_meet(self):
        display = self.show(field_at(0))
        display.SetScalarBarVisibility(self.view, True)
        bar = simple.GetScalarBar(display.LookupTable, self.view)
        self.assertEqual(bar.UseCustomLabels, 1)
        np.testing.assert_allclose(list(bar.CustomLabels), np.arange(0, 4.1, 0.5), atol=1e-9)
        display.LookupTable.RescaleTransferFunction(0, 0.41)
        self.assert_stripes(display.LookupTable, 0, 0.42, 0.02)
        np.testing.assert_allclose(list(bar.CustomLabels), np.arange(0, 0.41, 0.1), atol=1e-9)
        display.LookupTable.ApplyPreset("Cool to Warm", True)
        self.assertEqual(bar.UseCustomLabels, 0)

    def test_of_the_signed_distance_have_two_sides(self):
        table = self.show(field_at(1, GenerateSignedDistance=1), "SignedGeodesicDistance").LookupTable
        self.assert_stripes(table, -3, 3, 0.2)
        red, _, blue = nodes(table)[1:, 1:].T
        # Told apart from the first stripe on: by a tenth of all brightness at least.
        self.assertTrue(np.all(blue[:15] - red[:15] > 0.1) and np.all(red[-15:] - blue[-15:] > 0.1))

    def test_can_be_switched_off_before_and_after(self):
        field = field_at(0, ColorByStripes=0)
        table = self.show(field).LookupTable
        self.assertNotEqual(table.ColorSpace, "Step")
        field.ColorByStripes = 1
        field.UpdatePipeline()
        self.assert_stripes(table, 0, 4, 0.1)
        field.ColorByStripes = 0
        field.UpdatePipeline()
        self.assertNotEqual(table.ColorSpace, "Step")
        np.testing.assert_allclose(nodes(table)[[0, -1], 0], (0, 4))

    def test_of_the_preset_have_the_width_that_the_user_asks_for(self):
        display = self.show(field_at(0, ColorByStripes=0))
        table = display.LookupTable
        self.assertTrue(table.ApplyPreset(PRESETS[0], True))
        table.RescaleTransferFunction(0, 32 * 0.03)
        np.testing.assert_allclose(nodes(table)[:, 0], 0.03 * np.arange(33), atol=1e-9)
        display.SetScalarBarVisibility(self.view, True)
        self.assertEqual(simple.GetScalarBar(table, self.view).UseCustomLabels, 0)

    def test_colors_that_the_user_has_chosen_stay(self):
        field = field_at(0)
        table = self.show(field).LookupTable
        table.ApplyPreset("Cool to Warm", True)
        field.Source.Points = [1, 0, 0, 1, 3, 0]
        field.UpdatePipeline()
        self.show(field)
        self.assertNotEqual(table.ColorSpace, "Step")

    def test_fit_what_begins_to_use_a_color_map_that_is_there_already(self):
        whole = field_at(1.0, GenerateSourceIds=1)
        self.assertFalse(self.show(whole).LookupTable.UseAboveRangeColor)
        near = field_at(1.0, GenerateSourceIds=1, MaximumDistance=1.0)
        near.UpdatePipeline()
        self.assertTrue(self.show(near).LookupTable.UseAboveRangeColor)
        for field, annotations in ((whole, ["0", "0"]), (near, ["-1", "not reached", "0", "0"])):
            display = simple.Show(field, self.view)
            simple.ColorBy(display, ("POINTS", "SourceId"))
            self.assertEqual(list(display.LookupTable.Annotations), annotations)

    def test_of_a_state_stay_as_they_were_saved(self):
        self.show(field_at(0, DistanceArrayName="Far")).LookupTable.RescaleTransferFunction(0, 8)
        with tempfile.TemporaryDirectory() as folder:
            file = f"{folder}/state.pvsm"
            simple.SaveState(file)
            simple.Delete(self.view)
            simple.ResetSession()
            simple.LoadState(file)
        self.view = simple.GetRenderViews()[0]
        self.addCleanup(simple.Delete, self.view)
        self.assert_stripes(simple.GetColorTransferFunction("Far"), 0, 8, 0.2)

    def test_are_among_the_presets_once(self):
        presets = servermanager.vtkSMTransferFunctionPresets.GetInstance()
        names = [presets.GetPresetName(i) for i in range(presets.GetNumberOfPresets())]
        for name in PRESETS:
            self.assertEqual(names.count(name), 1)


if __name__ == "__main__":
    unittest.main()
