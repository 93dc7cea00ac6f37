# SPDX-License-Identifier: BSD-3-Clause
"""The installed Python module, in python3 or pvpython.

usage: python3 check_module.py PREFIX
"""

import sys

from geodesicdistance import vtkGeodesicDistanceField
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource

import sphere_bounds

prefix = sys.argv[1]

sphere = vtkSphereSource()
sphere.SetRadius(1)
sphere.SetThetaResolution(60)
sphere.SetPhiResolution(61)
points = vtkPoints()
points.InsertNextPoint(0, 0, 1)
pole = vtkPolyData()
pole.SetPoints(points)

field = vtkGeodesicDistanceField()
field.SetInputConnection(sphere.GetOutputPort())
field.SetSourceData(pole)
field.Update()
least, largest = field.GetOutput().GetPointData().GetArray("GeodesicDistance").GetRange()
low, high = sphere_bounds.of_pole_to_pole(1, 60, 61)
assert abs(least) < 1e-6, least
assert low - 1e-6 < largest < high + 1e-6, (low, largest, high)

with open("/proc/self/maps", encoding="ascii") as maps:
    loaded = {line.split()[-1] for line in maps if "Geodesic" in line}
assert len(loaded) >= 2 and all(name.startswith(prefix) for name in loaded), loaded
print(f"The module's range is {least} to {largest}; loaded: {', '.join(sorted(loaded))}")
