# SPDX-License-Identifier: BSD-3-Clause
"""A matrix in numpy: how far each of 37 electrodes on a head is from each."""

import sys
from math import cos, pi, sin
from os.path import dirname

sys.path.append(dirname(__file__))  # File > Load State... does not look there
import look
import numpy
import scan
from paraview.simple import *
from vtkmodules.numpy_interface.dataset_adapter import WrapDataObject

head = scan.head()
from_middle = look.points_of(head) - (90, 104, 72)


def electrode(ring, turn):
    """The point of the skin in a direction from the head's middle: rings are 25 degrees apart, from the top down."""
    down, around = ring*25*pi/180, 2*pi*turn
    direction = sin(down)*sin(around), sin(down)*cos(around), cos(down)
    along = from_middle @ direction
    near = along > 0.9995*numpy.linalg.norm(from_middle, axis=1)
    return from_middle[near][along[near].argmax()] + (90, 104, 72)


COUNTS = 1, 6, 12, 18
places = [electrode(ring, i/count) for ring, count in enumerate(COUNTS) for i in range(count)]
electrodes = PolyLineSource(Points=numpy.ravel(places))
electrodes = MaskPoints(Input=electrodes, OnRatio=1, GenerateVertices=1, SingleVertexPerCell=1)
table = GeodesicDistanceMatrix(Input=head, Source=electrodes)

rows = WrapDataObject(servermanager.Fetch(table)).RowData
distances = numpy.column_stack(rows.values()[1:])  # all columns but TargetId
a, b = numpy.unravel_index(distances.argmax(), distances.shape)
print(f"The farthest apart are {a} and {b}: {distances[a, b]:.4g} mm.")

# The matrix as a picture: squares beside the head, upright in the view, the first row at the top.
back = numpy.array((0.28, 0.8, 0.53))
right = numpy.cross((0, 0, 1), back) / numpy.hypot(*back[:2])
down = numpy.cross(right, back)
corner = (90, 104, 75) + 115*right - 95*down
squares = Plane(Origin=corner, Point1=corner + 190*right, Point2=corner + 190*down, XResolution=37, YResolution=37)
picture = ProgrammableFilter(Input=[squares, table], CopyArrays=0)
picture.Script = """import numpy
rows = numpy.column_stack(inputs[1].RowData.values()[1:])
output.CellData.append(rows.ravel(), "Distance")"""

view = look.view([head, picture], direction=back)
skin = Show(head, view)
look.plain(skin)
look.smooth(skin)
shown = Show(picture, view)
look.steps(shown, ("CELLS", "Distance"), 0, 300, look.shades(30))
look.legend(shown, "Distance (mm)", [0, 300], at=(0.53, 0.04))
look.note("to", (0.525, 0.91))
look.note("from", (0.445, 0.84))
# A color a ring, on the head and along both sides of the matrix.
ends = numpy.cumsum((0, *COUNTS))
for first, last, color in zip(ends, ends[1:], look.RINGS):
    look.balls(places[first:last], 4, color)
    for side, along in (-7*down, right), (-7*right, down):
        begin, end = (corner + side + way*along for way in (first*190/37 + 1, last*190/37 - 1))
        bar = Show(Line(Point1=begin, Point2=end), view)
        look.thin_lines(bar, color, 8)
look.save(view, globals())
