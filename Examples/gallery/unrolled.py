# SPDX-License-Identifier: BSD-3-Clause
"""An unrolled vessel: a map of its wall, along and across a line on it, shows where it bulges."""

import sys
from math import cos, pi, sin
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
from paraview.simple import *

# A sheet around a bent axis, closed but for a seam, at which it is cut open.
sheet = Plane(Origin=(0, -0.5, 0), Point1=(6, -0.5, 0), Point2=(0, 0.5, 0), XResolution=240, YResolution=80)
bulges = "0.3*exp(-8*((coordsX - 2)^2 + (coordsY - 0.12)^2*6)) + 0.22*exp(-9*((coordsX - 4.2)^2 + (coordsY + 0.2)^2*6))"
radius = Calculator(Input=sheet, ResultArrayName="Radius", Function=f"0.35 + {bulges}")
turn = "(2*3.141592653589793*coordsY)"
axis = "0.5*sin(1.1*coordsX)"
vessel = Calculator(Input=radius, CoordinateResults=1,
                    Function=f"(coordsX - 0.4*sin(2.2*coordsX)*0.1)*iHat + ({axis} + Radius*sin({turn}))*jHat + Radius*cos({turn})*kHat")
