# SPDX-License-Identifier: BSD-3-Clause
"""Stripes: colors in equal steps show how far it is, and that each step is as far as any other."""

import sys
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
import scan
from paraview.simple import *

brain = scan.brain()
start = PointSource(NumberOfPoints=1, Radius=0, Center=(27.86, 158, 88))
field = GeodesicDistanceField(Input=brain, Source=start)

view = look.view(field, direction=(-1, 0.3, 0.35))
shown = Show(field, view)
look.smooth(shown)
look.balls([start.Center], 2.5)
look.note("Stripes are 10 mm wide")
look.save(view, globals(), colors=128)
