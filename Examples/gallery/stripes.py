# SPDX-License-Identifier: BSD-3-Clause
"""Stripes: colors in equal steps show how far it is, and that each step is as far as any other."""

import sys
from math import cos, pi, sin
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
from paraview.simple import *

ring = Clean(Input=Superquadric(Toroidal=1, Size=1, Thickness=3/7, ThetaRoundness=1, PhiRoundness=1,
                                ThetaResolution=80, PhiResolution=160))


def bumpy(data):
    """What lies on the ring, on a bumpy ring."""
    return Calculator(Input=data, CoordinateResults=1,
                      Function="coords*(1 + 0.08*sin(4*coordsX + 1)*cos(5*coordsY)"
                               " + 0.05*cos(7*coordsZ)*sin(6*coordsX))")


def winding(t):
    """A point of a curve that winds around the ring, t from 0 to 1."""
    u, v = 2*pi*(0.85*t + 0.4), 2*pi*(1.6*t + 0.08)
    return (0.7 + 0.3*cos(v))*cos(u), 0.3*sin(v), (0.7 + 0.3*cos(v))*sin(u)


curve = PolyLineSource(Points=[x for i in range(200) for x in winding(i / 199)])
field = GeodesicDistanceField(Input=bumpy(ring), Source=bumpy(curve))

view = look.view(field, direction=(0.45, 1, 0.85), upward=(0, 1, 0))
shown = Show(field, view)
look.smooth(shown)

look.lines(Show(OutputPort(field, 1), view))
look.save(view, globals())
