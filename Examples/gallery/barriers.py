# SPDX-License-Identifier: BSD-3-Clause
"""Barriers: how far is it from everywhere on a floor to the way out, around the walls?"""

import sys
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
from paraview.simple import *

# A floor of 12 x 8 in squares of 0.1, whose cell array Wall is not 0 along the walls, which have doors.
floor = Plane(Origin=(0, 0, 0), Point1=(12, 0, 0), Point2=(0, 8, 0), XResolution=120, YResolution=80)
walls = " | ".join(f"({wall})" for wall in (
    "abs(coordsY - 4.8) < 0.01 & abs(coordsX - 2) > 0.5 & abs(coordsX - 8.5) > 0.5",
    "abs(coordsY - 3.2) < 0.01 & abs(coordsX - 5) > 0.5 & abs(coordsX - 11) > 0.5 & coordsX > 2.99",
    "abs(coordsX - 4) < 0.01 & coordsY > 4.8",
    "abs(coordsX - 7) < 0.01 & coordsY > 4.8 & abs(coordsY - 7) > 0.5",
    "abs(coordsX - 3) < 0.01 & coordsY < 3.2 & abs(coordsY - 0.8) > 0.5",
    "abs(coordsX - 8) < 0.01 & coordsY < 3.2"))
marked = Calculator(Input=floor, ResultArrayName="Wall", Function=f"if({walls}, 1, 0)")
plan = PointDatatoCellData(Input=marked)

way_out = PolyLineSource(Points=[0, 3.6, 0, 0, 4.4, 0])
field = GeodesicDistanceField(Input=plan, Source=way_out, BarrierArrayName="Wall")
people = PolyLineSource(Points=[1, 7, 0, 5.5, 7.5, 0, 11, 6, 0, 4, 0.5, 0, 6, 2.5, 0, 9, 0.5, 0])
paths = GeodesicPaths(Input=plan, Source=way_out, Targets=people, BarrierArrayName="Wall")

# For the picture the walls are raised.
rooms = Threshold(Input=field, Scalars=("CELLS", "Wall"), ThresholdMethod="Below Lower Threshold")
low = Threshold(Input=plan, Scalars=("CELLS", "Wall"), ThresholdMethod="Above Upper Threshold", UpperThreshold=0.01)
raised = LinearExtrusion(Input=ExtractSurface(Input=low), Vector=(0, 0, 0.7))
view = look.view([rooms, raised], direction=(0.15, -0.6, 0.9))
look.stripes(Show(rooms, view), width=0.5, unit=" m")
look.plain(Show(raised, view))
look.lines(Show(paths, view), width=3)
look.balls(people.Points, 0.15, color=look.DARK)
look.lines(Show(OutputPort(field, 1), view), color=look.GREEN, width=9)
look.note("door", (0.02, 0.66))
look.save(view, globals())
