# SPDX-License-Identifier: BSD-3-Clause
"""Connects to a server as the README has it and runs the four filters there.

usage: pvpython client_of_server.py PORT
"""

import os
import sys

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

FLOAT = 1e-6


def arrays(proxy):
    """The output, brought to the client, and the arrays of its cells or rows."""
    output = servermanager.Fetch(proxy)
    data = output.GetRowData() if output.IsA("vtkTable") else output.GetCellData()
    return output, {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)).copy()
                    for i in range(data.GetNumberOfArrays())}


simple.Connect("localhost", int(sys.argv[1]))
for remote in (True, False):
    simple.LoadPlugin(os.environ["GEODESIC_PLUGIN"], remote=remote, ns=vars(simple))
assert servermanager.ActiveConnection.IsRemote()
sheet = simple.Plane(XResolution=10, YResolution=10)
curve = simple.PolyLineSource(Points=[0, -0.5, 0.001, 0, 0.5, 0.001])
targets = simple.PolyLineSource(Points=[0.25, 0, 0, -0.4, 0.1, 0])

# The distance, and the numbers of the result as attributes.
field = simple.GeodesicDistanceField(Input=sheet, Source=curve)
field.UpdatePipeline()
assert abs(field.SourceSnapDistance - 0.001) < FLOAT, field.SourceSnapDistance
assert 0 <= field.InterpolationErrorBound <= 0.0015, field.InterpolationErrorBound
assert field.WindowsPropagatedPerEdge > 0 and field.RelativeErrorBound == 0
output, _ = arrays(field)
distance = vtk_to_numpy(output.GetPointData().GetArray("GeodesicDistance"))
x = vtk_to_numpy(output.GetPoints().GetData())[:, 0]
np.testing.assert_allclose(distance, np.abs(x), atol=FLOAT)
curve.Points = [0, -0.5, 0.002, 0, 0.5, 0.002]
field.UpdatePipeline()
assert abs(field.SourceSnapDistance - 0.002) < FLOAT, field.SourceSnapDistance

# The client learns of an error, and of its end.
field.Source = None
field.UpdatePipeline()
assert "no source" in field.ErrorMessage, field.ErrorMessage
field.Source = curve
field.UpdatePipeline()
assert field.ErrorMessage == "", field.ErrorMessage

contour = simple.GeodesicContour(Input=sheet, Source=curve, Distances=[0.1, 0.3])
lines, values = arrays(contour)
assert sorted(set(values["GeodesicDistance"])) == [0.1, 0.3], values
x = np.abs(vtk_to_numpy(lines.GetPoints().GetData())[:, 0])
assert np.all(np.minimum(np.abs(x - 0.1), np.abs(x - 0.3)) < FLOAT)

paths = simple.GeodesicPaths(Input=sheet, Source=curve, Targets=targets)
_, values = arrays(paths)
lengths = dict(zip(values["TargetId"], values["GeodesicDistance"]))
assert abs(lengths[0] - 0.25) < FLOAT and abs(lengths[1] - 0.4) < FLOAT, lengths

matrix = simple.GeodesicDistanceMatrix(Input=sheet, Source=curve, Targets=targets)
_, values = arrays(matrix)
np.testing.assert_allclose(values["Source0"], [0.25, 0.4], atol=FLOAT)
print("All four filters have run on the server.")
