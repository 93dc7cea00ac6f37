# SPDX-License-Identifier: BSD-3-Clause
"""A moving source: a point travels across a corrugated sheet, and the distance with it."""

import look
from paraview.simple import *

flat = Plane(Origin=(-1.5, -1, 0), Point1=(1.5, -1, 0), Point2=(-1.5, 1, 0), XResolution=120, YResolution=4)
sheet = Calculator(Input=flat, CoordinateResults=1,
                   Function="coordsX*iHat + coordsY*jHat + 0.15*sin(6*coordsX)*kHat")
start = PointSource(NumberOfPoints=1, Radius=0, Center=(-1.2, -0.4, 0))
field = GeodesicDistanceField(Input=sheet, Source=start)

# The first coordinate of the point goes from -1.2 to 1.2 while time goes from 0 to 1.
scene = GetAnimationScene()
scene.NumberOfFrames = 25
track = GetAnimationTrack("Center", index=0, proxy=start)
track.KeyFrames = [CompositeKeyFrame(KeyTime=time, KeyValues=[2.4*time - 1.2]) for time in (0, 1)]

view = look.view(field, direction=(0.1, -0.7, 0.8), size=(360, 230))
look.stripes(Show(field, view), largest=4)
look.lines(Show(OutputPort(field, 1), view))
look.save(view, globals(), times=(0, 0.25, 0.5, 0.75))
