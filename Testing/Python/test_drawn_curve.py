# SPDX-License-Identifier: BSD-3-Clause
"""Geodesic Distance Field From Drawn Curve in pvpython: its curve is a property, lies across the
surface's top at first, may be open, closed or one point and anywhere in space, and all else is as of
Geodesic Distance Field."""

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from geodesic_testing import (FLOAT, assert_close, data, distance_to_segments, distances,
                              load_plugin, messages, plane, points)

GeodesicDistanceField = load_plugin()
drawn_field = simple.GeodesicDistanceFieldFromDrawnCurve


def flat(curve):
    return [x for point in curve for x in point]


def updated(source):
    source.UpdatePipeline()
    return source


# ------------------------------------------------------------------------ the curve that is there
sheet = updated(plane())
field = drawn_field(Input=sheet)
assert list(field.Points) == [0, 1.5, 0, 4, 1.5, 0] and field.Closed == 0, field.Points
assert_close(distances(field), np.abs(points(data(field))[:, 1] - 1.5), FLOAT)

# On a box it runs over the top. The way to a side is down over the edge, or around the corner.
box = updated(simple.Box())
field = drawn_field(Input=box)
x, y, z = points(data(field)).T
at_side = np.minimum(1 - z, np.hypot(1 - np.abs(x), 0.5 - z))
at_end = np.hypot(y, 0.5 - z)
is_top, is_side, is_end = z == 0.5, np.abs(y) == 0.5, np.abs(x) == 0.5
expected = np.where(is_top, np.abs(y), np.where(is_side, at_side, at_end))
known = is_top | is_side | is_end
assert known.sum() > 100 and is_side.sum() > 20 and is_end.sum() > 20
assert_close(distances(field)[known], expected[known], FLOAT)

# -------------------------------------------------------------------- open, closed, points, changes
bent = [(0.5, 0.5, 0), (3.1, 0.7, 0), (2.3, 2.4, 0)]
field = drawn_field(Input=sheet, Points=flat(bent))
assert_close(distances(field), distance_to_segments(points(data(field)), bent), FLOAT)
length = vtk_to_numpy(data(field, 1).GetLines().GetConnectivityArray()).size
field.Closed = 1
ring = bent + bent[:1]
assert_close(distances(field), distance_to_segments(points(data(field)), ring), FLOAT)
assert vtk_to_numpy(data(field, 1).GetLines().GetConnectivityArray()).size > length

# One coordinate, more points, fewer, one.
bent[1] = (3.1, 0.2, 0)
field.Points = flat(bent)
assert_close(distances(field), distance_to_segments(points(data(field)), bent + bent[:1]), FLOAT)
longer = bent + [(1.2, 2.9, 0)]
field.Points = flat(longer)
assert_close(distances(field), distance_to_segments(points(data(field)), longer + bent[:1]), FLOAT)
field.Points = flat(bent[:2])
assert_close(distances(field), distance_to_segments(points(data(field)), bent[:2]), FLOAT)
field.Points = bent[0]
to_point = np.linalg.norm(points(data(field)) - bent[0], axis=1)
assert_close(distances(field), to_point, FLOAT)

# Dragged off the sheet, which is told, and once only.
field = drawn_field(Input=simple.Triangulate(Input=sheet), Points=flat([(1, 1, 5), (3, 2, -0.5)]))
with messages() as said:
    values = distances(field)
assert "up to 5 away from the surface" in said.GetOutput(), said.GetOutput()
assert_close(values, distance_to_segments(points(data(field)), [(1, 1, 0), (3, 2, 0)]), FLOAT)
assert vtk_to_numpy(data(field).GetFieldData().GetArray("SourceSnapDistance"))[0] == 5

# Coordinates are not rounded to 32 bits.
away = [(1 + 1e-10, 1, 0), (1 + 1e-10, 2, 0)]
field = drawn_field(Input=sheet, Points=flat(away))
line = points(data(field, 1))
assert np.all(line[:, 0] == away[0][0]), line[:, 0] - 1

# ------------------------------------------------------------------------------- without a curve
field.Points = []
with messages() as said:
    assert data(field).GetNumberOfPoints() == 0
assert "The curve has no points" in said.GetOutput(), said.GetOutput()
field.SourceType = "Surface Boundary"
x, y, _ = points(data(field)).T
assert_close(distances(field), np.minimum(np.minimum(x, 4 - x), np.minimum(y, 3 - y)), FLOAT)
field.SourceType = "Source Curve"
field.Points = flat(bent)
assert_close(distances(field), distance_to_segments(points(data(field)), bent), FLOAT)

# --------------------------------------------------------------- all else is as of the other proxy
plain = GeodesicDistanceField(Input=sheet).SMProxy
drawn = drawn_field(Input=sheet).SMProxy
names = [simple.servermanager.PropertyIterator(proxy) for proxy in (plain, drawn)]
names = [{prop.GetXMLName() for prop in each if not prop.GetIsInternal()} for each in names]
assert names[1] - names[0] == {"Points", "PointsOnly", "Closed"}, names
assert names[0] - names[1] == {"Source", "SourceIsMissing", "JoinLines", "SourceIdArrayName"}, names
for name in names[0] & names[1] - {"Input"}:
    one, other = plain.GetProperty(name), drawn.GetProperty(name)
    assert one.GetXMLLabel() == other.GetXMLLabel() and one.GetCommand() == other.GetCommand(), name
    assert one.GetDocumentation().GetDescription() == other.GetDocumentation().GetDescription(), name
