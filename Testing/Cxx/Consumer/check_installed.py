# SPDX-License-Identifier: BSD-3-Clause
"""Loads the installed plugin and Python module: both must take the installed library."""

import os
import sys

plugin, packages, library = sys.argv[1:]

from paraview import simple

simple.LoadPlugin(plugin, remote=False, ns=globals())
field = GeodesicDistanceField(Input=simple.Plane(), SourceType="Surface Boundary")
field.UpdatePipeline()
assert "GeodesicDistance" in field.PointData.keys(), field.PointData.keys()

sys.path.insert(0, packages)
import geodesicdistance

assert geodesicdistance.__file__.startswith(packages), geodesicdistance.__file__
assert geodesicdistance.vtkGeodesicDistanceField().GetSourceType() == 0

with open("/proc/self/maps") as maps:
    loaded = {line.split()[-1] for line in maps if "libvtkFiltersGeodesic" in line}
assert loaded == {os.path.realpath(library)}, loaded
