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


def half(data, normal):
    """What lies on the side of the origin that the normal points to."""
    clip = Clip(Input=data, ClipType="Plane", Invert=0)
    clip.ClipType.Origin, clip.ClipType.Normal = (0, 0, 0), normal
    return clip


# For the picture the quarters that four ranks have are apart, each in a color of its own.
QUARTERS = (-1, -1), (-1, 1), (1, -1), (1, 1)
view = look.view(field, direction=(0.25, -0.8, 0.7))
view.CameraParallelScale *= 1.05
for rank, (x, y) in enumerate(QUARTERS):
    look.note(f"rank {rank}", at=((0.03, 0.25), (0.07, 0.85), (0.87, 0.25), (0.90, 0.71))[rank])
    light = look.REGIONS[rank]
    for data in field, OutputPort(field, 1):
        quarter = half(half(data, (x, 0, 0)), (0, y, 0))
        shown = Show(quarter, view)
        look.move(shown, (1.5*x, 1.5*y, 0))
        if data is field:
            look.steps(shown, ("POINTS", "GeodesicDistance"), 0, 40, [light, look.mix(light, (0, 0, 0), 0.3)]*10,
                       separate=True)
        else:
            look.lines(shown)
look.note("Stripes are 2 wide")
look.save(view, globals())
