# SPDX-License-Identifier: BSD-3-Clause
"""Draws a distance field with stripes, and the curve it is measured from."""

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

NEAR = (0.98, 0.84, 0.42)
MIDDLE = (0.87, 0.36, 0.38)
FAR = (0.22, 0.26, 0.58)
UNREACHED = (0.75, 0.75, 0.75)


def mix(a, b, t):
    return [x + t * (y - x) for x, y in zip(a, b)]


def _color(t):
    return mix(NEAR, MIDDLE, 2 * t) if t < 0.5 else mix(MIDDLE, FAR, 2 * t - 1)


def color_by_stripes(display, array, count=24):
    """Colors a display by a distance array of its points, every second stripe darker."""
    simple.ColorBy(display, ("POINTS", array))
    largest = display.LookupTable.RGBPoints[-4]
    color_by_steps(display, ("POINTS", array), 0, largest, striped(shades(count)))


def shades(count):
    """Colors from near to far."""
    return [_color(i / (count - 1)) for i in range(count)]


def striped(colors, darkness=0.28):
    """Every second color darker."""
    return [mix(color, (0, 0, 0), darkness) if i % 2 else color for i, color in enumerate(colors)]


def color_by_steps(display, array, low, high, colors):
    """Colors a display by an array in equal steps from a low to a high value."""
    simple.ColorBy(display, array)
    steps = []
    for i, color in enumerate(colors):
        for end in (i, i + 1):
            steps += [low + (high - low) * end / len(colors), *color]
    table = display.LookupTable
    table.ColorSpace = "RGB"
    table.RGBPoints = steps
    table.NumberOfTableValues = 1024
    table.UseAboveRangeColor = 1
    table.AboveRangeColor = UNREACHED
    # Stripes are cut inside each face, not blended from colors at its corners.
    display.InterpolateScalarsBeforeMapping = 1


def look_along(view, direction, surface, upward=(0, 0, 1)):
    """Looks back along the direction, with the surface filling the view."""
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    back = np.array(direction) / np.linalg.norm(direction)
    right = np.cross(upward, back)
    right /= np.linalg.norm(right)
    up = np.cross(back, right)
    along = points @ np.transpose((right, up, back))
    low, high = along.min(axis=0), along.max(axis=0)
    center = (low + high) / 2 @ (right, up, back)
    width, height, depth = high - low

    view.CameraParallelProjection = 1
    view.CameraFocalPoint = center
    view.CameraPosition = center + (width + height + depth) * back
    view.CameraViewUp = up
    columns, rows = view.ViewSize
    view.CameraParallelScale = 0.52 * max(height, width * rows / columns)


def new_view(size):
    """A white view without axes."""
    view = simple.CreateView("RenderView")
    view.ViewSize = size
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = (1, 1, 1)
    return view


def show(view, field, array, direction, upward=(0, 0, 1), edges=False):
    """Shows the result of a GeodesicDistanceField with stripes, its source on top of it."""
    surface = simple.Show(field, view)
    color_by_stripes(surface, array)
    surface.Ambient = 0.15
    surface.SetScalarBarVisibility(view, False)
    if edges:
        surface.SetRepresentationType("Surface With Edges")
        surface.EdgeColor = (0.1, 0.1, 0.1)

    show_lines(view, simple.OutputPort(field, 1), width=3 if edges else 7)
    look_along(view, direction, simple.servermanager.Fetch(field), upward)


def show_plain(view, surface, color):
    """Shows a surface in one color."""
    display = simple.Show(surface, view)
    simple.ColorBy(display, ("POINTS", None))
    display.AmbientColor = display.DiffuseColor = color
    display.Ambient = 0.15
    return display


def show_lines(view, lines, color=(1, 1, 1), width=7):
    """Shows lines as tubes and points as balls, in one color."""
    display = simple.Show(lines, view)
    simple.ColorBy(display, ("POINTS", None))
    display.AmbientColor = display.DiffuseColor = color
    display.LineWidth = width
    display.PointSize = 2 * width
    display.RenderLinesAsTubes = 1
    display.RenderPointsAsSpheres = 1
    return display


def show_thin_lines(view, lines, color=(1, 1, 1), width=2):
    """Shows lines in one color, whatever the light."""
    display = show_lines(view, lines, color, width)
    display.Ambient, display.Diffuse = 1, 0
    return display


def draw(field, array, file_name, size=(1200, 800), direction=(0.45, -0.85, 0.75)):
    """Draws the result of a GeodesicDistanceField with stripes."""
    view = new_view(size)
    show(view, field, array, direction)
    simple.SaveScreenshot(file_name, view, ImageResolution=size)


def new_pair(fields, array, edges, direction, upward, size=(500, 500)):
    """Two views beside each other, each with a result, and with the edges of its triangles or not."""
    views = []
    for field, with_edges in zip(fields, edges):
        view = new_view(size)
        show(view, field, array, direction, upward, with_edges)
        views.append(view)
    return views


def zoom(view, center, factor):
    """Closes in on a point; without one, on the middle of the view."""
    if center is not None:
        back = np.subtract(view.CameraPosition, view.CameraFocalPoint)
        view.CameraFocalPoint = center
        view.CameraPosition = center + back
    view.CameraParallelScale /= factor


def save(view, file_name):
    """Writes what a view shows, and closes it."""
    simple.SaveScreenshot(file_name, view, ImageResolution=view.ViewSize, CompressionLevel="9")
    simple.Delete(view)


def save_pair(views, file_name):
    """Writes what two views show, side by side, and closes them."""
    layout = simple.CreateLayout()
    layout.SplitHorizontal(0, 0.5)
    for place, view in enumerate(views, start=1):
        simple.AssignViewToLayout(view, layout, place)
    columns, rows = views[0].ViewSize
    size = (2 * columns, rows)
    layout.SetSize(*size)
    simple.SaveScreenshot(file_name, layout, ImageResolution=size, CompressionLevel="9")
    for view in views:
        simple.Delete(view)
