# SPDX-License-Identifier: BSD-3-Clause
"""Several ranks: distance over a corrugated sheet that comes in pieces, one on each process.

mpirun -n 4 pvbatch several_ranks.py FOLDER draws the same picture as one process.
"""

import sys
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
from paraview.simple import *

# ParaView hands each rank a piece of this grid, and bends it there.
grid = Wavelet(WholeExtent=[-45, 45, -30, 30, 0, 0])
sheet = ExtractSurface(Input=grid)
bent = Calculator(Input=sheet, CoordinateResults=1,
                  Function="coordsX*iHat + coordsY*jHat + 5*sin(coordsX/6)*kHat")

# A curve over all pieces, which the first rank has. Nothing says that there are several.
curve = PolyLineSource(Points=[-36, -18, 1.4, -12, 15, -4.5, 9, -15, 5, 33, 12, -3.5])
field = GeodesicDistanceField(Input=bent, Source=curve)

view = look.view(field, direction=(0.25, -0.8, 0.7))
look.stripes(Show(field, view))
look.lines(Show(OutputPort(field, 1), view))
look.save(view, globals())
