# SPDX-License-Identifier: BSD-3-Clause
"""Draws distances in stripes of one width, with the color map that comes with the plugin.

usage: pvpython color_map.py FIELD PICTURE [STEP]

FIELD is a file with the point array GeodesicDistance, such as geodesic_distance.py writes, PICTURE
a .png to write. The 32 stripes go up to the largest distance, or are as wide as STEP.
"""

import pathlib
import sys

from paraview import servermanager, simple

STRIPES = "Geodesic Distance Stripes"
COUNT = 32


def find_color_map():
    """The file of the color map: in the source tree, or where the package has put it."""
    here = pathlib.Path(__file__).resolve()
    places = [folder / place for folder in here.parents
              for place in ("ParaViewPlugin", "share/geodesic-distance")]
    files = [place / "GeodesicDistanceStripes.json" for place in places]
    found = next((file for file in files if file.is_file()), None)
    return found or sys.exit("There is no GeodesicDistanceStripes.json above this script.")


def color_by_stripes(display, step=None, array="GeodesicDistance"):
    """Colors a display by the color map, up to the largest distance or in stripes of a width."""
    # ParaView keeps what is imported with the user's settings, once more each time.
    if not servermanager.vtkSMTransferFunctionPresets.GetInstance().HasPreset(STRIPES):
        simple.ImportPresets(filename=str(find_color_map()))
    simple.ColorBy(display, ("POINTS", array))
    display.LookupTable.ApplyPreset(STRIPES, True)
    largest = display.LookupTable.RGBPoints[-4]
    display.LookupTable.RescaleTransferFunction(0, COUNT * step if step else largest)


def main(field_file, picture, step=None):
    view = simple.CreateView("RenderView")
    view.ViewSize = (900, 700)
    view.OrientationAxesVisibility = 0
    display = simple.Show(simple.OpenDataFile(field_file), view)
    color_by_stripes(display, float(step) if step else None)
    display.SetScalarBarVisibility(view, True)
    simple.ResetCamera(view)
    simple.SaveScreenshot(picture, view, ImageResolution=view.ViewSize)


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(*sys.argv[1:])
