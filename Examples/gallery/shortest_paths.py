# SPDX-License-Identifier: BSD-3-Clause
"""Shortest paths: from 150 places on the surface of a brain to one, through its folds."""

import sys
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
import scan
from paraview.simple import *

brain = scan.brain()
start = PointSource(NumberOfPoints=1, Radius=0, Center=(27.86, 158, 88))
targets = MaskPoints(Input=brain, OnRatio=1, MaximumNumberofPoints=150, RandomSampling=1,
                     RandomSamplingMode="Uniform Spatial Distribution (Surface Sampling)", GenerateVertices=1)
paths = GeodesicPaths(Input=brain, Source=start, Targets=targets)

view = look.view(brain, direction=(-1, 0.3, 0.35))
shown = Show(brain, view)
look.plain(shown)
look.smooth(shown)
shown = Show(paths, view)
look.colored_lines(shown, largest=250, colors=look.shades(7)[2:])
look.legend(shown, "Length of the path (mm)", [0, 250])
look.nearer(look.balls(look.points_of(targets), 1.5, color=look.DARK), view)  # as near as the lines that end there
look.nearer(look.balls([start.Center], 4, color=look.DARK), view, by=0.1)
look.save(view, globals(), colors=48)
