# SPDX-License-Identifier: BSD-3-Clause
"""Distance from a drawn curve: a curve on a rolled sheet, where the next turn is near only through the air."""

import sys
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
from paraview.simple import *

# Radius and angle grow together, for one and a half turns.
flat = Plane(Origin=(0, -1.2, 0), Point1=(9.5, -1.2, 0), Point2=(0, 1.2, 0), XResolution=190, YResolution=4)
radius = "(0.35 + 0.09*coordsX)"
roll = Calculator(Input=flat, CoordinateResults=1,
                  Function=f"{radius}*cos(coordsX)*iHat + coordsY*jHat + {radius}*sin(coordsX)*kHat")

# In ParaView the curve is drawn: point at the surface and press 1, 2 or P.
field = GeodesicDistanceFieldFromDrawnCurve(Input=roll)
field.Points = [-0.1, -0.9, 1.1, 0.4, -0.4, 0.95, -0.05, 0.1, 1.1, 0.45, 0.5, 0.9, -0.1, 0.9, 1.1]

view = look.view(field, direction=(0.8, -0.55, 0.5))
look.stripes(Show(field, view), width=0.2)
look.lines(Show(OutputPort(field, 1), view))
look.save(view, globals())
