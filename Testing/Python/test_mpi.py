# SPDX-License-Identifier: BSD-3-Clause
"""Run by several ranks of pvbatch: each refuses with a clear error and gives no field."""

import sys

from paraview import simple
from geodesic_testing import load_plugin, messages, plane
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
print("every rank has refused")
