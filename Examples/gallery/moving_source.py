# SPDX-License-Identifier: BSD-3-Clause
"""A moving source: a point travels across a corrugated sheet, and the distance with it."""

import sys
from math import sin
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
from paraview.simple import *

flat = Plane(Origin=(-1.5, -1, 0), Point1=(1.5, -1, 0), Point2=(-1.5, 1, 0), XResolution=120, YResolution=4)
sheet = Calculator(Input=flat, CoordinateResults=1,
                   Function="coordsX*iHat + coordsY*jHat + 0.15*sin(6*coordsX)*kHat")
start = PointSource(NumberOfPoints=1, Radius=0, Center=(-1.2, -0.4, 0.15*sin(-7.2)))
field = GeodesicDistanceField(Input=sheet, Source=start)

# While time goes from 0 to 1, x goes from -1.2 to 1.2 and z, which is coordinate 2, up and down with the sheet.
scene = GetAnimationScene()
scene.NumberOfFrames = 25
for index, place in ((0, lambda x: x), (2, lambda x: 0.15*sin(6*x))):
    track = GetAnimationTrack("Center", index=index, proxy=start)
    track.KeyFrames = [CompositeKeyFrame(KeyTime=i/24, KeyValues=[place(0.1*i - 1.2)]) for i in range(25)]

view = look.view(field, direction=(0.1, -0.7, 0.8), size=(420, 270))
look.stripes(Show(field, view), largest=4)
look.lines(Show(OutputPort(field, 1), view))
look.time(at=(0.66, 0.87))
look.save(view, globals(), times=(0, 0.25, 0.5, 0.75))
