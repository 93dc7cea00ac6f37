# SPDX-License-Identifier: BSD-3-Clause
"""A decal: a star in a ring on the side of a scanned head, by distance and direction from a point."""

import sys
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
import scan
from paraview.simple import *

head = scan.head()
start = PointSource(NumberOfPoints=1, Radius=0, Center=(48, 188, 112))
field = GeodesicDistanceField(Input=head, Source=start, GenerateSourceAngle=1, GenerateTextureCoordinates=1,
                              TextureScale=90, TextureRepeats=0)

# One picture, with its middle at the point. A texture would need no more than its file: this one is computed.
near = Clip(Input=field, ClipType="Scalar", Scalars=("POINTS", "GeodesicDistance"), Value=45)
rest = Clip(Input=field, ClipType="Scalar", Scalars=("POINTS", "GeodesicDistance"), Value=45, Invert=0)
triangles = Triangulate(Input=ExtractSurface(Input=near))
fine = Subdivide(Input=triangles, NumberofSubdivisions=3)
picture = ProgrammableFilter(Input=fine)
picture.Script = """import numpy
x, y = (inputs[0].PointData["SourceTextureCoordinates"][:, :2] - 0.5).T
radius, fifth = numpy.hypot(x, y), 2*numpy.pi/5
from_tip = numpy.abs((numpy.arctan2(y, x) + fifth/2) % fifth - fifth/2)
is_star = radius < 0.34*numpy.cos(fifth)/numpy.cos(fifth - from_tip)
output.ShallowCopy(inputs[0].VTKObject)
output.PointData.append(numpy.where(radius > 0.42, 0.0, numpy.where(is_star, 2.0, 1.0)), "Picture")"""

view = look.view(head, direction=(-0.55, 0.83, 0.1), size=(640, 640))
skin, decal = Show(rest, view), Show(picture, view)
look.plain(skin)
look.steps(decal, ("POINTS", "Picture"), -0.5, 2.5, [look.FAR, look.WHITE, look.RED])
look.smooth(skin)
look.smooth(decal)
look.note("A decal, 90 mm wide", at=(0.02, 0.94))
look.save(view, globals())
