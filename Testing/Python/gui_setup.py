# SPDX-License-Identifier: BSD-3-Clause
"""Run inside the ParaView GUI before the events: a square sheet, and a line down its middle."""

from paraview import simple

sheet = simple.Plane(registrationName="Sheet", XResolution=20, YResolution=20)
simple.PolyLineSource(registrationName="Curve", Points=[0, -0.5, 0, 0, 0.5, 0])
view = simple.GetActiveViewOrCreate("RenderView")
simple.Show(sheet, view)
simple.ResetCamera(view)
simple.SetActiveSource(sheet)
