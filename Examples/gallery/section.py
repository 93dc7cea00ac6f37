# SPDX-License-Identifier: BSD-3-Clause
"""Distance from a section: a tilted plane cuts a fluted column, and the cut is the source."""

import sys
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
from paraview.simple import *

# Long narrow facets, without a point between their ends.
column = Cylinder(Resolution=240, Radius=1, Height=2.2, Capping=0)
flutes = "(1 + 0.14*cos(6*atan2(coordsZ, coordsX)))"
fluted = Calculator(Input=column, CoordinateResults=1,
                    Function=f"coordsX*{flutes}*iHat + coordsY*jHat + coordsZ*{flutes}*kHat")

section = Slice(Input=fluted)
section.SliceType.Normal = (-0.5, 1, 0.4)
field = GeodesicDistanceField(Input=fluted, Source=section)

view = look.view(field, direction=(0.3, 0.55, 1), upward=(0, 1, 0))
look.stripes(Show(field, view))
look.lines(Show(OutputPort(field, 1), view))
look.save(view, globals())
