# SPDX-License-Identifier: BSD-3-Clause
"""Run by several ranks of pvbatch: each refuses with a clear error and gives no field, unless it is
told to work alone."""

import sys

from paraview import simple
from geodesic_testing import load_plugin, messages, plane
from geodesicdistance import vtkGeodesicDistanceField
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController

ranks = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
if ranks < 2:
    sys.exit(f"this test is for several ranks, not for {ranks}")

field = load_plugin()(Input=plane(), SourceType="Surface Boundary")
with messages() as window:
    field.UpdatePipeline()
said = window.GetOutput()
if "rank" not in said and "process" not in said:
    sys.exit(f"no clear error, but: {said!r}")
if field.PointData.GetArray("GeodesicDistance"):
    sys.exit("a distance was given all the same")

# A filter that is told to work alone does so on whichever rank executes it.
if vtkMultiProcessController.GetGlobalController().GetLocalProcessId() == 1:
    sphere = vtkSphereSource()
    sphere.SetEndTheta(180)
    alone = vtkGeodesicDistanceField()
    alone.SetInputConnection(sphere.GetOutputPort())
    alone.SetSourceTypeToSurfaceBoundary()
    alone.SetController(None)
    alone.Update()
    if not alone.GetOutput().GetPointData().GetArray("GeodesicDistance"):
        sys.exit("alone on rank 1 it gave no distance")
print("every rank has refused")
