# SPDX-License-Identifier: BSD-3-Clause
"""The nearest of several curves: each of six lines on hills has its region."""

import sys
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
from paraview.simple import *


def on_hills(flat):
    """What lies in the plane of x and y, on the hills."""
    return Calculator(Input=flat, CoordinateResults=1,
                      Function="coordsX*iHat + coordsY*jHat"
                               " + 0.09*(sin(3*coordsX + 1)*cos(4*coordsY) + sin(5*coordsX*coordsY))*kHat")


sheet = Plane(Origin=(-1.5, -1, 0), Point1=(1.5, -1, 0), Point2=(-1.5, 1, 0), XResolution=150, YResolution=100)
hills = on_hills(Triangulate(Input=sheet))
lines = [PolyLineSource(Points=points) for points in (
    [-1.3, 0.8, 0, -0.9, 0.3, 0, -0.4, 0.75, 0],
    [-1.25, -0.3, 0, -0.95, -0.8, 0],
    [-0.35, -0.1, 0, 0.0, -0.3, 0, -0.25, -0.7, 0],
    [0.3, 0.8, 0, 0.35, 0.2, 0],
    [0.8, 0.55, 0, 1.3, 0.7, 0, 1.25, 0.1, 0],
    [0.45, -0.75, 0, 0.8, -0.35, 0, 1.2, -0.65, 0])]
curves = on_hills(AppendGeometry(Input=lines))

field = GeodesicDistanceField(Input=hills, Source=curves, GenerateSourceIds=1, RefineSourceBorders=1)
rings = GeodesicContour(Input=hills, Source=curves, Distances=[0.1 * i for i in range(1, 10)])

view = look.view(field, direction=(0.2, -0.7, 0.9))
look.regions(Show(field, view), "SourceId")
look.thin_lines(Show(rings, view))
look.lines(Show(OutputPort(field, 1), view), color=look.DARK)
look.note("Lines are 0.1 apart")
look.save(view, globals())
