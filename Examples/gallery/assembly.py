# SPDX-License-Identifier: BSD-3-Clause
"""An assembly: how far up is it, on a house of six panels, from the ground?"""

import sys
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
from paraview.simple import *


def panel(origin, along, up, resolution):
    columns, rows = resolution
    return Plane(Origin=origin, Point1=along, Point2=up, XResolution=columns, YResolution=rows)


def gable(x):
    """A wall that goes up to the ridge in its middle."""
    wall = panel((x, -1, 0), (x, 1, 0), (x, -1, 1), (20, 10))
    return Calculator(Input=wall, CoordinateResults=1,
                      Function="coordsX*iHat + coordsY*jHat + coordsZ*(1.8 - 0.8*abs(coordsY))*kHat")


house = GroupDatasets(Input=[
    panel((0, -1, 0), (3, -1, 0), (0, -1, 1), (30, 10)), panel((0, 1, 0), (3, 1, 0), (0, 1, 1), (30, 10)),
    panel((0, -1, 1), (3, -1, 1), (0, 0, 1.8), (30, 10)), panel((0, 1, 1), (3, 1, 1), (0, 0, 1.8), (30, 10)),
    gable(0), gable(3)])

# One surface: where panels meet is no boundary, what is left of it runs along the ground.
field = GeodesicDistanceField(Input=house, SourceType="Surface Boundary")

view = look.view(field, direction=(0.6, -0.8, 0.6))
look.stripes(Show(field, view))
outlines = FeatureEdges(Input=house, FeatureEdges=0, NonManifoldEdges=0)
look.lines(Show(outlines, view), color=look.DARK, width=1.5)
look.lines(Show(OutputPort(field, 1), view), color=look.DARK, width=6)
look.save(view, globals())
