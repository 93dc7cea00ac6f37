# SPDX-License-Identifier: BSD-3-Clause
"""Distance from feature edges: how far is each point of a gear wheel from its sharp edges?"""

import sys
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
from paraview.simple import *

# A ring with twelve teeth, extruded.
ring = Disk(InnerRadius=0.35, OuterRadius=1, RadialResolution=16, CircumferentialResolution=144)
teeth = "(1 + 0.22*clamp(0, 0.5 + cos(12*atan2(coordsY, coordsX)), 1)" \
        "*(sqrt(coordsX^2 + coordsY^2) - 0.35)/0.65)"
toothed = Calculator(Input=ring, CoordinateResults=1, Function=f"coords*{teeth}")
gear = LinearExtrusion(Input=toothed, Vector=(0, 0, 0.5))

edges = FeatureEdges(Input=gear, FeatureAngle=30, BoundaryEdges=0, NonManifoldEdges=0)
field = GeodesicDistanceField(Input=gear, Source=edges)

view = look.view(field)
look.stripes(Show(field, view), width=0.02)
look.lines(Show(edges, view), width=3)
look.save(view, globals())
