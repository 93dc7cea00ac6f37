# SPDX-License-Identifier: BSD-3-Clause
"""A matrix in numpy: forty points up a cone in a spiral, and how far it is from each to each."""

import sys
from math import cos, pi, sin
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
import numpy
from paraview.simple import *
from vtkmodules.numpy_interface.dataset_adapter import WrapDataObject

# The source leaves a seam open by a rounding; Clean closes it.
open_cone = Cone(Resolution=96, Height=2, Radius=1, Direction=(0, 0, 1), Center=(0, 0, 1), Capping=0)
cone = Clean(Input=open_cone, Tolerance=1e-6)


def spiral(t):
    """A point of the cone, t from 0 to 1: three turns up."""
    radius = 0.95 - 0.7*t
    return radius*cos(6*pi*t), radius*sin(6*pi*t), 2 - 2*radius


points = PolyLineSource(Points=[x for i in range(40) for x in spiral(i / 39)])
points = MaskPoints(Input=points, OnRatio=1, GenerateVertices=1, SingleVertexPerCell=1)
table = GeodesicDistanceMatrix(Input=cone, Source=points)

rows = WrapDataObject(servermanager.Fetch(table)).RowData
distances = numpy.column_stack(rows.values()[1:])  # all columns but TargetId
a, b = numpy.unravel_index(distances.argmax(), distances.shape)
print(f"The farthest apart are {a} and {b}: {distances[a, b]:.4g}.")

# The matrix as a picture: squares beside the cone, the first row at the top.
squares = Plane(Origin=(1.5, 0, 2), Point1=(3.5, 0, 2), Point2=(1.5, 0, 0), XResolution=40, YResolution=40)
picture = ProgrammableFilter(Input=[squares, table], CopyArrays=0)
picture.Script = """import numpy
rows = numpy.column_stack(inputs[1].RowData.values()[1:])
output.CellData.append(rows.ravel(), "Distance")"""

view = look.view([cone, picture], direction=(0, -1, 0.25), size=(840, 460))
look.plain(Show(cone, view))
Ids = PointAndCellIds if "PointAndCellIds" in globals() else GenerateIds  # of ParaView 6, or 5.11
balls = Show(Ids(registrationName="GenerateIds1", Input=points), view)
look.lines(balls, width=7)
look.steps(balls, ("POINTS", "PointIds"), 0, 40, look.shades(40))
look.steps(Show(picture, view), ("CELLS", "Distance"), 0, distances.max(), look.shades(48))
look.save(view, globals())
