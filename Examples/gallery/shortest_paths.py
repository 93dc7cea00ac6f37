# SPDX-License-Identifier: BSD-3-Clause
"""Shortest paths: from sixty places on a flight of steps down to one corner."""

import sys
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
from paraview.simple import *

# A sheet of 4 x 3.5, folded into five steps: 0.4 ahead, then 0.3 up, and so on.
sheet = Plane(Origin=(0, 0, 0), Point1=(4, 0, 0), Point2=(0, 3.5, 0), XResolution=40, YResolution=35)
step, along = "floor(coordsY/0.7 + 0.001)", "(coordsY - 0.7*floor(coordsY/0.7 + 0.001))"
steps = Calculator(Input=sheet, CoordinateResults=1,
                   Function=f"coordsX*iHat + (0.4*{step} + min({along}, 0.4))*jHat"
                            f" + (0.3*{step} + max({along} - 0.4, 0))*kHat")

start = PointSource(NumberOfPoints=1, Radius=0, Center=(0.4, 0.2, 0))
targets = MaskPoints(Input=steps, OnRatio=1, MaximumNumberofPoints=60, RandomSampling=1,
                     RandomSamplingMode="Uniform Spatial Distribution (Surface Sampling)", GenerateVertices=1)
paths = GeodesicPaths(Input=steps, Source=start, Targets=targets)

view = look.view(steps, direction=(0.4, -1, 0.6))
look.plain(Show(steps, view))
look.colored_lines(Show(paths, view))
look.lines(Show(start, view), color=look.DARK, width=7)
look.lines(Show(targets, view), color=look.DARK, width=3)
look.save(view, globals())
