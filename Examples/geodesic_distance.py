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

import stripes


def load_plugin():
    """Makes GeodesicDistanceField known to paraview.simple."""
    if hasattr(simple, "GeodesicDistanceField"):
        return
    build = pathlib.Path(__file__).resolve().parent.parent / "build"
    plugin = next(build.rglob("GeodesicDistance.so"), None)
    if not plugin:
        sys.exit(f"There is no plugin below {build}: build it, or set PV_PLUGIN_PATH to its folder.")
    simple.LoadPlugin(str(plugin), remote=False, ns=vars(simple))


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
    load_plugin()
    field = simple.GeodesicDistanceField(Input=read(surface_file), Source=read(curve_file))
    field.UpdatePipeline()
    array = field.PointData.GetArray(field.DistanceArrayName)
    if not array:
        sys.exit("There is no distance: see the filter's message above.")
    largest = array.GetRange()[1]
    print(f"largest distance: {largest:g}" + (" (not all was reached)" if math.isinf(largest) else ""))

    simple.SaveData(output + ".vtp", field, DataMode="Binary")
    stripes.draw(field, field.DistanceArrayName, output + ".png")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
