# SPDX-License-Identifier: BSD-3-Clause
"""A decal: checkers around a point of a scanned head, by distance and direction from there."""

import sys
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
import scan
from paraview.simple import *

CHECKERS = 6

head = scan.head()
start = PointSource(NumberOfPoints=1, Radius=0, Center=(48, 188, 112))
field = GeodesicDistanceField(Input=head, Source=start, GenerateSourceAngle=1, GenerateTextureCoordinates=1,
                              TextureScale=14)

# The square in the tangent plane, and the rest. A texture would need no more than its file.
u, v = "SourceTextureCoordinates_X", "SourceTextureCoordinates_Y"
reach = Calculator(Input=field, ResultArrayName="Reach", Function=f"max(abs({u}), abs({v}))")
square = Clip(Input=reach, ClipType="Scalar", Scalars=("POINTS", "Reach"), Value=CHECKERS/2)
rest = Clip(Input=reach, ClipType="Scalar", Scalars=("POINTS", "Reach"), Value=CHECKERS/2, Invert=0)
triangles = Triangulate(Input=ExtractSurface(Input=square))
fine = Subdivide(Input=triangles, NumberofSubdivisions=2)
checkers = Calculator(Input=fine, ResultArrayName="Checkers", Function=f"sin(3.14159265*{u})*sin(3.14159265*{v})")

view = look.view(head, direction=(-0.55, 0.83, 0.1), size=(640, 640))
skin, decal = Show(rest, view), Show(checkers, view)
look.plain(skin)
look.steps(decal, ("POINTS", "Checkers"), -1, 1, [look.FAR, look.NEAR])
look.smooth(skin)
look.smooth(decal)
look.note("Squares of 14 mm", at=(0.02, 0.94))
look.save(view, globals())
