# SPDX-License-Identifier: BSD-3-Clause
"""An unrolled vessel: a map of its wall along and across a line on it, beside the vessel."""

import sys
from math import exp, pi, sin
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
from paraview.simple import *

# A sheet around a bent axis. Its sides meet behind, but stay apart: there the vessel is cut open.
sheet = Plane(Origin=(0, -pi, 0), Point1=(7, -pi, 0), Point2=(0, pi, 0), XResolution=210, YResolution=90)
BULGES = ((1.9, 0.7, 0.26), (4.3, -0.9, 0.22), (5.6, 0.9, 0.17))
radius = "0.42 + " + " + ".join(f"{height}*exp(-3*(coordsX - {x})^2 - 0.8*(coordsY - {turn})^2)"
                                for x, turn, height in BULGES)
walls = Calculator(Input=sheet, ResultArrayName="Radius", Function=radius)
vessel = Calculator(Input=walls, CoordinateResults=1,
                    Function="coordsX*iHat + (2.8 + 0.4*sin(0.9*coordsX) + Radius*sin(coordsY))*jHat"
                             " + Radius*cos(coordsY)*kHat")


def front(x):
    """A point of the line along the front."""
    return x, 2.8 + 0.4*sin(0.9*x), 0.42 + sum(height*exp(-3*(x - at)**2 - 0.8*turn**2) for at, turn, height in BULGES)


line = PolyLineSource(Points=[x for i in range(71) for x in front(0.1*i)])
field = GeodesicDistanceField(Input=vessel, Source=line, MergeCoincidentPoints=0,
                              GenerateSourceArcLength=1, GenerateSignedDistance=1)
# Without its ends, where there is no line in front.
middle, front_line = (IsoVolume(Input=data, InputScalars=("POINTS", "SourceArcLength"), ThresholdRange=(0.5, 7))
                      for data in (field, OutputPort(field, 1)))
rings = Contour(Input=middle, ContourBy=("POINTS", "SourceArcLength"), Isosurfaces=[0.5*i for i in range(2, 14)],
                ComputeScalars=1)


def unrolled(data):
    """What lies on the vessel, on the map below it: wide places above narrow ones, as the map has a fold at the bend."""
    return Calculator(Input=data, CoordinateResults=1,
                      Function="SourceArcLength*iHat + SignedGeodesicDistance*jHat + 0.01*Radius*kHat")


map_of_vessel = unrolled(middle)
rings_on_map = unrolled(rings)

view = look.view([middle, map_of_vessel], direction=(0, 0.15, 1), upward=(0, 1, 0), size=(840, 640))
view.CameraParallelScale *= 1.17
for shape in middle, map_of_vessel:
    shown = Show(shape, view)
    look.steps(shown, ("POINTS", "Radius"), 0.4, 0.7, look.shades(10))
look.legend(shown, "Radius", [0.4, 0.7], at=(0.7, 0.87), length=0.25)
look.axes(shown, "Along the line", range(1, 8), (-1, 0, 1))
look.note("Around the vessel", at=(0.03, 0.6))
for shape in rings, rings_on_map, front_line:
    look.thin_lines(Show(shape, view))
look.save(view, globals())
