# SPDX-License-Identifier: BSD-3-Clause
"""A decal: checkers around a point of a scanned head, by distance and direction from there."""

import sys
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
import scan
from paraview.simple import *

SIDE, CHECKERS = 110, 8  # millimeters

head = scan.head()
start = PointSource(NumberOfPoints=1, Radius=0, Center=(50, 180, 128))
field = GeodesicDistanceField(Input=head, Source=start, MaximumDistance=SIDE,
                              GenerateSourceAngle=1, GenerateTextureCoordinates=1)

# The square in the tangent plane, and the rest. A texture would need no more than its file.
u, v = "SourceTextureCoordinates_X", "SourceTextureCoordinates_Y"
reach = Calculator(Input=field, ResultArrayName="Reach", Function=f"max(abs({u}), abs({v}))")
square = Clip(Input=reach, ClipType="Scalar", Scalars=("POINTS", "Reach"), Value=SIDE/2)
rest = Clip(Input=reach, ClipType="Scalar", Scalars=("POINTS", "Reach"), Value=SIDE/2, Invert=0)
fine = LinearSubdivision(Input=ExtractSurface(Input=square), NumberofSubdivisions=2)
turns = f"{CHECKERS/SIDE}*3.14159265"
checkers = Calculator(Input=fine, ResultArrayName="Checkers", Function=f"sin({turns}*{u})*sin({turns}*{v})")

view = look.view(head, direction=(-0.55, 0.8, 0.25), size=(640, 640))
shown = Show(rest, view)
look.plain(shown)
shown = Show(checkers, view)
look.steps(shown, ("POINTS", "Checkers"), -1, 1, [look.FAR, look.NEAR])
look.save(view, globals())
