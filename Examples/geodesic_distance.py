# SPDX-License-Identifier: BSD-3-Clause
"""Exact geodesic distance to a curve on a surface, and a picture of it.

usage: pvpython geodesic_distance.py SURFACE CURVE OUTPUT

Reads whatever ParaView reads, writes OUTPUT.vtp and OUTPUT.png. The plugin is taken from
PV_PLUGIN_PATH, else from the build folder of this source tree.
"""

import math
import pathlib
import sys

from paraview import simple

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "gallery"))
import look  # noqa: E402, which loads the plugin


def read(file_name):
    """The file's points, lines and faces as one vtkPolyData."""
    if not pathlib.Path(file_name).is_file():
        sys.exit(f"There is no file {file_name}.")
    reader = simple.OpenDataFile(file_name)
    if not reader:
        sys.exit(f"ParaView has no reader for {file_name}.")
    reader.UpdatePipeline()
    if reader.GetDataInformation().GetDataSetTypeAsString() != "vtkPolyData":
        reader = simple.ExtractSurface(Input=simple.MergeBlocks(Input=reader))
    return reader


def main(surface_file, curve_file, output):
    field = simple.GeodesicDistanceField(Input=read(surface_file), Source=read(curve_file))
    field.UpdatePipeline()
    array = field.PointData.GetArray(field.DistanceArrayName)
    if not array:
        sys.exit("There is no distance: see the filter's message above.")
    largest = array.GetRange()[1]
    print(f"largest distance: {largest:g}" + (" (not all was reached)" if math.isinf(largest) else ""))

    simple.SaveData(output + ".vtp", field, DataMode="Binary")
    draw(field, output + ".png")


def draw(field, file_name):
    """Draws the field with stripes, and the source on top of it."""
    view = look.view(field, size=(1200, 800))
    look.stripes(simple.Show(field, view))
    look.lines(simple.Show(simple.OutputPort(field, 1), view), width=7)
    simple.SaveScreenshot(file_name, view, ImageResolution=view.ViewSize)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
