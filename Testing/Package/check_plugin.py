# SPDX-License-Identifier: BSD-3-Clause
"""The installed plugin, in pvpython: ParaView 5.11 has loaded it when it started, later ones of Debian offer it
by its name, and it works.

usage: pvpython check_plugin.py PREFIX
"""

import math
import sys

from paraview import simple

import sphere_bounds

prefix = sys.argv[1]

if simple.GetParaViewVersion() >= (5, 13):
    simple.LoadDistributedPlugin("GeodesicDistance", remote=False, ns=vars(simple))
assert hasattr(simple, "GeodesicDistanceField"), "ParaView has not loaded the plugin when it started"
sphere = simple.Sphere(Radius=1, ThetaResolution=60, PhiResolution=61)
pole = simple.PointSource(Center=[0, 0, 1], Radius=0, NumberOfPoints=1)
field = simple.GeodesicDistanceField(Input=sphere, Source=pole)
field.UpdatePipeline()
least, largest = field.PointData["GeodesicDistance"].GetRange()
low, high = sphere_bounds.of_pole_to_pole(1, 60, 61)
assert abs(least) < 1e-6, least
assert low - 1e-6 < largest < high + 1e-6, (low, largest, high)
assert 0.99 * math.pi < low, low

with open("/proc/self/maps", encoding="ascii") as maps:
    loaded = {line.split()[-1] for line in maps if "Geodesic" in line}
assert len(loaded) == 2 and all(name.startswith(prefix) for name in loaded), loaded
print(f"The plugin's range is {least} to {largest}; loaded: {', '.join(sorted(loaded))}")
