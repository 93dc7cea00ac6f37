# SPDX-License-Identifier: BSD-3-Clause
"""Offset curves: where does a tool go that clears a bent plate, always at one step from the last round?"""

import sys
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
from paraview.simple import *

STEP = 0.04

# A sheet with the array Plate, which is positive inside the outline and outside two holes; bent, then cut out.
sheet = Plane(Origin=(-1.7, -1.2, 0), Point1=(1.7, -1.2, 0), Point2=(-1.7, 1.2, 0),
              XResolution=170, YResolution=120)
outline = "1 - (coordsX/1.6)^4 - (coordsY/(0.85 + 0.25*cos(2.4*coordsX)))^4"
holes = "min((coordsX - 0.75)^2 + (coordsY - 0.1)^2 - 0.06, (coordsX + 0.8)^2 + 2*(coordsY + 0.25)^2 - 0.05)"
marked = Calculator(Input=sheet, ResultArrayName="Plate", Function=f"min({outline}, {holes})")
bent = Calculator(Input=marked, CoordinateResults=1,
                  Function="coordsX*iHat + coordsY*jHat + 0.25*cos(2*coordsX)*kHat")
cut = Clip(Input=bent, ClipType="Scalar", Scalars=("POINTS", "Plate"), Value=0, Invert=0)
plate = ExtractSurface(Input=cut)

offsets = GeodesicContour(Input=plate, SourceType="Surface Boundary",
                          Distances=[STEP * i for i in range(1, 30)])

view = look.view(plate, direction=(0.2, -0.7, 0.9))
look.plain(Show(plate, view))
look.colored_lines(Show(offsets, view))
rim = FeatureEdges(Input=plate, FeatureEdges=0, NonManifoldEdges=0)
look.lines(Show(rim, view), color=look.DARK, width=3)
look.note(f"Lines are {STEP} apart")
look.save(view, globals())
