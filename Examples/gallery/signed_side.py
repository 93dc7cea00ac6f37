# SPDX-License-Identifier: BSD-3-Clause
"""Signed distance: on which side of a closed curve, and how far? Red is on its left, blue on its right."""

import sys
from math import cos, pi, sin, sqrt
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
from paraview.simple import *


def bumpy(data):
    """What lies on the unit sphere, on a bumpy ball."""
    return Calculator(Input=data, CoordinateResults=1,
                      Function="coords*(1 + 0.13*sin(3*coordsX + 1)*cos(4*coordsY)*sin(3*coordsZ + 2))")


def seam(t):
    """A point of a tennis ball's seam."""
    return 0.75*cos(t) + 0.25*cos(3*t), 0.75*sin(t) - 0.25*sin(3*t), sqrt(0.75)*sin(2*t)


ball = look.with_normals(bumpy(Sphere(Radius=1, ThetaResolution=150, PhiResolution=100)))
curve = bumpy(PolyLineSource(Points=[x for i in range(120) for x in seam(2*pi*i/120)], Closed=1))
field = GeodesicDistanceField(Input=ball, Source=curve, GenerateSignedDistance=1)

view = look.view(field)
shown = Show(field, view)
look.sides(shown, width=0.1)
look.smooth(shown)
look.lines(Show(OutputPort(field, 1), view), color=look.DARK)
look.save(view, globals())
