# SPDX-License-Identifier: BSD-3-Clause
"""A cut along a closed curve: the cover of a tennis ball comes apart at its seam, into two halves of one area."""

import sys
from math import cos, pi, sin, sqrt
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
from paraview.simple import *


def seam(t):
    return 0.75*cos(t) + 0.25*cos(3*t), 0.75*sin(t) - 0.25*sin(3*t), sqrt(0.75)*sin(2*t)


ball = Sphere(Radius=1, ThetaResolution=150, PhiResolution=100)
curve = PolyLineSource(Points=[x for i in range(240) for x in seam(2*pi*i/240)], Closed=1)
field = GeodesicDistanceField(Input=ball, Source=curve, GenerateSignedDistance=1, RefinementTolerance=0.0001)

left = Clip(Input=field, ClipType="Scalar", Scalars=["POINTS", "SignedGeodesicDistance"], Invert=0)
right = Clip(Input=field, ClipType="Scalar", Scalars=["POINTS", "SignedGeodesicDistance"], Invert=1)
left.Value = right.Value = 0

# For the picture one half is moved away from the other.
away = Transform(Input=left)
away.Transform.Translate = [0.9, 0, 0]
view = look.view([right, away])
for shown, color in ((Show(right, view), look.PALE_BLUE), (Show(away, view), look.PALE_RED)):
    look.plain(shown, color)
    look.smooth(shown)
look.save(view, globals())
