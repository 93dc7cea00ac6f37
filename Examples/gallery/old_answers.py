# SPDX-License-Identifier: BSD-3-Clause
"""What the filters answer, one picture each: shortest paths, the nearest of several curves, offset
curves, the sides of a curve, ways around barriers, and distances between many points.

usage: pvpython answers.py OUTPUT [--part FILE] [--only NAME]

Writes OUTPUT-paths.png and so on. The surfaces are made here, but that of the paths can be any
file that ParaView reads. The plugin is taken from PV_PLUGIN_PATH, else from the build folder of
this source tree.
"""

import argparse

import numpy as np
from paraview import simple
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

import stripes
from geodesic_distance import load_plugin, read

SIZE = (900, 600)
FROM = (0.45, -0.85, 0.75)
PALE = (0.87, 0.87, 0.85)
DARK = (0.2, 0.2, 0.22)
WHITE = (0.97, 0.96, 0.94)
RED, BLUE = (0.86, 0.36, 0.30), (0.25, 0.42, 0.70)
REGIONS = ((0.98, 0.80, 0.40), (0.87, 0.42, 0.40), (0.45, 0.66, 0.55),
           (0.36, 0.42, 0.68), (0.72, 0.56, 0.76), (0.66, 0.80, 0.90))

BUMPS = "(1 + 0.13*sin(3*coordsX + 1)*cos(4*coordsY)*sin(3*coordsZ + 2))"


# ------------------------------------------------------------------------------- surfaces, curves
def moved(data, function):
    """The data with each point where a formula of its coordinates says."""
    return simple.Calculator(Input=data, CoordinateResults=1, Function=function)


def bumpy(data):
    """What lies on the unit sphere, on a bumpy ball."""
    return moved(data, f"{BUMPS} * coords")


def ball():
    return bumpy(simple.Sphere(Radius=1, ThetaResolution=150, PhiResolution=100))


def polyline(points, closed=False):
    return simple.PolyLineSource(Points=np.ravel(points).tolist(), Closed=int(closed))


def seam(count=120):
    """The seam of a tennis ball, which lies on the unit sphere, on the bumpy ball."""
    t = np.linspace(0, 2 * np.pi, count, endpoint=False)
    points = np.transpose((0.75 * np.cos(t) + 0.25 * np.cos(3 * t),
                           0.75 * np.sin(t) - 0.25 * np.sin(3 * t),
                           np.sqrt(0.75) * np.sin(2 * t)))
    return bumpy(polyline(points, closed=True))


def hills():
    """A sheet of 3 x 2 with hills."""
    sheet = simple.Plane(Origin=(-1.5, -1, 0), Point1=(1.5, -1, 0), Point2=(-1.5, 1, 0),
                         XResolution=210, YResolution=140)
    return on_hills(simple.Triangulate(Input=sheet))


def on_hills(flat):
    """What lies in the plane of x and y, on the hills."""
    return moved(flat, "coordsX*iHat + coordsY*jHat"
                       " + 0.09*(sin(3*coordsX + 1)*cos(4*coordsY) + sin(5*coordsX*coordsY))*kHat")


def curves():
    """Six lines on the hills, as one data set of six cells."""
    corners = (((-1.3, 0.8), (-0.9, 0.3), (-0.4, 0.75)), ((-1.25, -0.3), (-0.95, -0.8)),
               ((-0.35, -0.1), (0.0, -0.3), (-0.25, -0.7)), ((0.3, 0.8), (0.35, 0.2)),
               ((0.8, 0.55), (1.3, 0.7), (1.25, 0.1)), ((0.45, -0.75), (0.8, -0.35), (1.2, -0.65)))
    flat = [polyline([(x, y, 0) for x, y in line]) for line in corners]
    return on_hills(simple.AppendGeometry(Input=flat))


def plate():
    """A bent plate with an outline in curves and two holes."""
    sheet = simple.Plane(Origin=(-1.7, -1.2, 0), Point1=(1.7, -1.2, 0), Point2=(-1.7, 1.2, 0),
                         XResolution=170, YResolution=120)
    outline = "1 - (coordsX/1.6)^4 - (coordsY/(0.85 + 0.25*cos(2.4*coordsX)))^4"
    holes = "min((coordsX - 0.75)^2 + (coordsY - 0.1)^2 - 0.06," \
            " (coordsX + 0.8)^2 + 2*(coordsY + 0.25)^2 - 0.05)"
    marked = simple.Calculator(Input=sheet, ResultArrayName="In", Function=f"min({outline}, {holes})")
    inside = simple.Clip(Input=marked, ClipType="Scalar", Scalars=("POINTS", "In"), Value=0, Invert=0)
    return moved(simple.Triangulate(Input=simple.ExtractSurface(Input=inside)),
                 "coordsX*iHat + coordsY*jHat + (0.2*cos(2*coordsX) - 0.15*coordsY^2)*kHat")


def labyrinth():
    """A dome whose cell array Wall is not 0 in two rings with gaps."""
    disk = simple.Disk(InnerRadius=0.001, OuterRadius=1, RadialResolution=49,
                       CircumferentialResolution=180)
    radius = "sqrt(coordsX^2 + coordsY^2)"
    walls = f"(abs({radius} - 0.34) < 0.015 & coordsX < 0.8*{radius}) |" \
            f" (abs({radius} - 0.68) < 0.015 & coordsX > -0.8*{radius})"
    marked = simple.Calculator(Input=disk, ResultArrayName="Wall", Function=f"if({walls}, 1, 0)")
    return moved(simple.Triangulate(Input=simple.PointDatatoCellData(Input=marked)),
                 "coordsX*iHat + coordsY*jHat - 0.4*(coordsX^2 + coordsY^2)*kHat")


def corner(surface, direction):
    """The surface's point that is the farthest in a direction."""
    points = vtk_to_numpy(simple.servermanager.Fetch(surface).GetPoints().GetData())
    return points[np.argmax(points @ direction)].astype(float).tolist()


# ---------------------------------------------------------------------------------------- answers
def paths(part):
    start = simple.PointSource(NumberOfPoints=1, Radius=0, Center=corner(part, FROM))
    targets = simple.MaskPoints(Input=part, OnRatio=1, MaximumNumberofPoints=100,
                                GenerateVertices=1, RandomSampling=1,
                                RandomSamplingMode="Uniform Spatial Distribution (Surface Sampling)")
    return simple.GeodesicPaths(Input=part, Source=start, Targets=targets)


def regions(surface, curves):
    return simple.GeodesicDistanceField(Input=surface, Source=curves, GenerateSourceIds=1)


def offsets(surface, step=0.04):
    return simple.GeodesicContour(Input=surface, SourceType="Surface Boundary",
                                  Distances=[step * i for i in range(1, 30)])


def sides(surface, curve):
    return simple.GeodesicDistanceField(Input=surface, Source=curve, GenerateSignedDistance=1)


def around(surface, start):
    return simple.GeodesicDistanceField(Input=surface, Source=start, BarrierArrayName="Wall")


def table(surface, points):
    """The distances between points as an array: a row a target, a column a source."""
    matrix = simple.GeodesicDistanceMatrix(Input=surface, Source=points)
    rows = dataset_adapter.WrapDataObject(simple.servermanager.Fetch(matrix)).RowData
    return np.column_stack(rows.values()[1:])  # the first is TargetId


# --------------------------------------------------------------------------------------- pictures
def new_view(surface, direction=FROM, size=SIZE):
    view = stripes.new_view(size)
    stripes.look_along(view, direction, simple.servermanager.Fetch(surface))
    return view


def color_lines(display, lines):
    """By distance, from near to far."""
    largest = lines.PointData["GeodesicDistance"].GetRange()[1]
    array = ("POINTS", "GeodesicDistance")
    stripes.color_by_steps(display, array, 0, 1.001 * largest, stripes.shades(36)[9:])


def draw_paths(file_name, part):
    found = paths(part)
    view = new_view(part)
    stripes.show_plain(view, part, PALE)
    color_lines(stripes.show_thin_lines(view, found, width=4), found)
    stripes.show_lines(view, found.Source, DARK, 8)
    stripes.show_lines(view, found.Targets, DARK, 4)
    stripes.save(view, file_name)


def draw_regions(file_name):
    field = regions(hills(), curves())
    rings = simple.GeodesicContour(Input=field.Input, Source=field.Source,
                                   Distances=[0.05 * i for i in range(1, 40)])
    view = new_view(field, (0.2, -0.7, 0.9), (900, 540))
    surface = simple.Show(field, view)
    stripes.color_by_steps(surface, ("POINTS", "SourceId"), -0.5, len(REGIONS) - 0.5, REGIONS)
    surface.InterpolateScalarsBeforeMapping = 0  # there is no region between two
    surface.Ambient = 0.15
    stripes.show_thin_lines(view, rings)
    stripes.show_lines(view, simple.OutputPort(field, 1), DARK)
    stripes.save(view, file_name)


def draw_offsets(file_name):
    surface = plate()
    found = offsets(surface)
    view = new_view(surface, (0.2, -0.7, 0.9), (900, 500))
    stripes.show_plain(view, surface, PALE)
    color_lines(stripes.show_thin_lines(view, found, width=3), found)
    rim = simple.FeatureEdges(Input=surface, FeatureEdges=0, NonManifoldEdges=0)
    stripes.show_lines(view, rim, DARK, 4)
    stripes.save(view, file_name)


def draw_sides(file_name, steps=12):
    field = sides(ball(), seam())
    view = new_view(field, size=(700, 600))
    surface = simple.Show(field, view)
    array = "SignedGeodesicDistance"
    largest = np.abs(field.PointData[array].GetRange()).max()
    right, left = ([stripes.mix(WHITE, color, (i + 1) / steps) for i in range(steps)]
                   for color in (BLUE, RED))
    right, left = stripes.striped(right, 0.15), stripes.striped(left, 0.15)
    stripes.color_by_steps(surface, ("POINTS", array), -largest, largest, right[::-1] + left)
    surface.Ambient = 0.15
    stripes.show_lines(view, simple.OutputPort(field, 1), DARK)
    stripes.save(view, file_name)


def draw_around(file_name):
    start = simple.PointSource(NumberOfPoints=1, Radius=0, Center=(0.15, -0.05, 0))
    field = around(labyrinth(), start)
    view = new_view(field, (0.1, -0.7, 0.9), (800, 600))
    floor, walls = (simple.Threshold(Input=field, Scalars=("CELLS", "Wall"), Invert=invert)
                    for invert in (0, 1))
    floor.UpperThreshold = walls.UpperThreshold = 0
    surface = simple.Show(floor, view)
    stripes.color_by_stripes(surface, "GeodesicDistance")
    surface.Ambient = 0.15
    stripes.show_plain(view, walls, DARK)
    stripes.show_lines(view, simple.OutputPort(field, 1))
    stripes.save(view, file_name)


def heat_map(values):
    """An array as squares with the cell array Distance, the first row at the top."""
    rows, columns = values.shape
    image = vtkImageData()
    image.SetDimensions(columns + 1, rows + 1, 1)
    image.GetCellData().SetScalars(numpy_to_vtk(values[::-1].ravel(), deep=1))
    image.GetCellData().GetScalars().SetName("Distance")
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(image)
    return simple.ExtractSurface(Input=producer)


def draw_table(file_name):
    surface = ball()
    points = simple.MaskPoints(Input=seam(), OnRatio=3, GenerateVertices=1, SingleVertexPerCell=1)
    values = table(surface, points)
    squares = heat_map(values)
    views = [new_view(surface, size=(500, 500)), stripes.new_view((500, 500))]
    stripes.look_along(views[1], (0, 0, 1), simple.servermanager.Fetch(squares), (0, 1, 0))

    stripes.show_plain(views[0], surface, PALE)
    numbered = simple.GenerateIds(Input=points)
    dots = stripes.show_lines(views[0], numbered, width=7)
    stripes.color_by_steps(dots, ("POINTS", "PointIds"), 0, len(values), stripes.shades(24))
    colors = simple.Show(squares, views[1])
    stripes.color_by_steps(colors, ("CELLS", "Distance"), 0, values.max(), stripes.shades(48))
    colors.Ambient, colors.Diffuse = 1, 0
    stripes.save_pair(views, file_name)


ANSWERS = {"paths": draw_paths, "regions": draw_regions, "offsets": draw_offsets,
           "sides": draw_sides, "around": draw_around, "table": draw_table}


def draw(output, part=None, only=None):
    """Writes OUTPUT-NAME.png of every answer, or of one, with the paths on a part or on the ball."""
    for name, draw_answer in ANSWERS.items():
        if only in (None, name):
            on = [part or ball()] if name == "paths" else []
            draw_answer(f"{output}-{name}.png", *on)


def main():
    usage = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    usage.add_argument("output", metavar="OUTPUT", help="how the names of the pictures begin")
    usage.add_argument("--part", metavar="FILE", help="the surface of the paths")
    usage.add_argument("--only", choices=ANSWERS, help="this picture alone")
    arguments = usage.parse_args()
    load_plugin()
    part = read(arguments.part) if arguments.part else None
    draw(arguments.output, part, arguments.only)


if __name__ == "__main__":
    main()
