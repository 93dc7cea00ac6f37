# SPDX-License-Identifier: BSD-3-Clause
"""Distance from the boundary: how far is each point of a leaf from its rim?"""

import sys
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
from paraview.simple import *

# A sheet with the array Leaf, which is positive inside an outline with teeth; bent, then cut out.
sheet = Plane(Origin=(-1.6, -1, 0), Point1=(1.6, -1, 0), Point2=(-1.6, 1, 0),
              XResolution=160, YResolution=101)
outline = "(1 - (coordsX/1.5)^2)*(1 + 0.3*coordsX)*(0.85 - 0.18*abs(sin(8*coordsX))) - abs(coordsY)"
marked = Calculator(Input=sheet, ResultArrayName="Leaf", Function=outline)
bent = Calculator(Input=marked, CoordinateResults=1,
                  Function="coordsX*iHat + coordsY*jHat + 0.2*sin(1.5*coordsX)*kHat")
cut = Clip(Input=bent, ClipType="Scalar", Scalars=("POINTS", "Leaf"), Value=0, Invert=0)
leaf = ExtractSurface(Input=cut)

field = GeodesicDistanceField(Input=leaf, SourceType="Surface Boundary")

view = look.view(field, direction=(0, -0.6, 0.9))
look.stripes(Show(field, view))
look.lines(Show(OutputPort(field, 1), view), color=look.DARK, width=3)
look.save(view, globals())
