# SPDX-License-Identifier: BSD-3-Clause
"""A decal: checkers around a point of a scanned head, by distance and direction from there."""

import sys
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
import scan
from paraview.simple import *

CHECKERS = 8

head = scan.head()
start = PointSource(NumberOfPoints=1, Radius=0, Center=(42, 192, 98))
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
look.plain(Show(rest, view))
look.steps(Show(checkers, view), ("POINTS", "Checkers"), -1, 1, [look.FAR, look.NEAR])
look.save(view, globals())
