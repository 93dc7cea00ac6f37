# SPDX-License-Identifier: BSD-3-Clause
"""Along a curve: a band of arrows follows a drawn curve over waves, by arc length and distance."""

import sys
from math import pi, sin
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
from paraview.simple import *

HALF_WIDTH, ARROW, ARROWS = 0.15, 0.15, 25

flat = Plane(Origin=(-1.6, -1, 0), Point1=(1.6, -1, 0), Point2=(-1.6, 1, 0), XResolution=160, YResolution=60)
waves = Calculator(Input=flat, CoordinateResults=1,
                   Function="coordsX*iHat + coordsY*jHat + 0.12*sin(6*coordsX)*kHat")


def drawn(t):
    """A point of the curve, t from 0 to 1."""
    x = -1.35 + 2.7*t
    return x, 0.55*sin(2.2*pi*t + 0.6) + 0.1*t, 0.12*sin(6*x)


field = GeodesicDistanceFieldFromDrawnCurve(Input=waves, GenerateSourceArcLength=1)
field.Points = [x for i in range(81) for x in drawn(i / 80)]

band = Clip(Input=field, ClipType="Scalar", Scalars=("POINTS", "GeodesicDistance"), Value=HALF_WIDTH)
# The farther from the curve, the farther back has a point the same number: arrowheads.
arrows = Calculator(Input=band, ResultArrayName="Arrow", Function="SourceArcLength + GeodesicDistance")
whole = IsoVolume(Input=arrows, InputScalars=("POINTS", "Arrow"), ThresholdRange=(ARROW, (ARROWS + 1)*ARROW))

view = look.view(field, direction=(0.1, -0.75, 0.8))
look.plain(Show(field, view))
shown = Show(whole, view)
look.steps(shown, ("POINTS", "Arrow"), ARROW, (ARROWS + 1)*ARROW, ([look.FAR, look.NEAR]*ARROWS)[:ARROWS])
look.nearer(shown, view)
look.note(f"Arrows are {ARROW} long")
look.save(view, globals())
