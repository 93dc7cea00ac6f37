# SPDX-License-Identifier: BSD-3-Clause
"""What the pictures of the gallery have in common: the plugin, colors, the camera, and files.

Importing this makes the filters known to paraview.simple, where ParaView has not loaded the plugin
already: from the build folder of this source tree, or the installed plugin that ParaView knows.
"""

import pathlib
import sys

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import small_png

NEAR, MIDDLE, FAR = (0.98, 0.84, 0.42), (0.87, 0.36, 0.38), (0.22, 0.26, 0.58)
RED, BLUE = (0.86, 0.36, 0.30), (0.25, 0.42, 0.70)
WHITE, PALE, GRAY, DARK = (0.97, 0.96, 0.94), (0.87, 0.87, 0.85), (0.75, 0.75, 0.75), (0.2, 0.2, 0.22)
REGIONS = ((0.98, 0.80, 0.40), (0.87, 0.42, 0.40), (0.45, 0.66, 0.55),
           (0.36, 0.42, 0.68), (0.72, 0.56, 0.76), (0.66, 0.80, 0.90))


def load_plugin():
    if hasattr(simple, "GeodesicDistanceField"):
        return
    build = pathlib.Path(__file__).resolve().parents[2] / "build"
    plugin = next(build.rglob("GeodesicDistance.so"), None)
    if plugin:
        simple.LoadPlugin(str(plugin), remote=False, ns=vars(simple))
        return
    try:
        simple.LoadDistributedPlugin("GeodesicDistance", remote=False, ns=vars(simple))
    except RuntimeError:
        sys.exit(f"There is no plugin below {build}: build it, or set PV_PLUGIN_PATH to its folder.")


load_plugin()


# ----------------------------------------------------------------------------------------- colors
def mix(a, b, t):
    return [x + t * (y - x) for x, y in zip(a, b)]


def shades(count):
    """Colors from near to far."""
    along = [2 * i / (count - 1) for i in range(count)]
    return [mix(NEAR, MIDDLE, t) if t < 1 else mix(MIDDLE, FAR, t - 1) for t in along]


def striped(colors, darkness=0.28):
    """Every second color darker."""
    return [mix(color, (0, 0, 0), darkness) if i % 2 else color for i, color in enumerate(colors)]


def stripes(display, largest=None, count=24, array="GeodesicDistance"):
    """Colors a display by a distance in stripes of one width, up to the largest distance."""
    simple.ColorBy(display, ("POINTS", array))
    largest = largest or range_of(display)[1]
    steps(display, ("POINTS", array), 0, largest, striped(shades(count)))


def range_of(display):
    """The smallest and the largest number that it is colored by, without those that are infinite."""
    display.LookupTable.ColorSpace = "RGB"  # else the plugin rounds the range
    display.RescaleTransferFunctionToDataRange(False, True)
    return display.LookupTable.RGBPoints[0], display.LookupTable.RGBPoints[-4]


def sides(display, count=12, array="SignedGeodesicDistance"):
    """Colors a display by a signed distance in stripes, blue for negative and red for positive ones."""
    simple.ColorBy(display, ("POINTS", array))
    largest = max(abs(end) for end in range_of(display))
    right, left = (striped([mix(WHITE, color, (i + 1) / count) for i in range(count)], 0.15)
                   for color in (BLUE, RED))
    steps(display, ("POINTS", array), -largest, largest, right[::-1] + left)


def steps(display, array, low, high, colors):
    """Colors a display by an array in equal steps from a low to a high value."""
    simple.ColorBy(display, array)
    ends = np.linspace(low, high, len(colors) + 1)
    table = display.LookupTable
    table.InterpretValuesAsCategories = 0
    table.ColorSpace = "RGB"
    table.RGBPoints = [x for low, high, color in zip(ends, ends[1:], colors)
                       for x in (low, *color, high, *color)]
    table.NumberOfTableValues = 1024
    table.UseAboveRangeColor = 1
    table.AboveRangeColor = GRAY  # what is not reached
    shade(display)
    # Stripes are cut inside each face, not blended from colors at its corners.
    display.InterpolateScalarsBeforeMapping = 1


def regions(display, array="SourceId"):
    """Colors a display by numbers 0, 1, 2 ..., each in a color of its own."""
    steps(display, ("POINTS", array), -0.5, len(REGIONS) - 0.5, REGIONS)
    display.InterpolateScalarsBeforeMapping = 0  # there is no region between two


def plain(display, color=PALE):
    """Shows a surface in one color."""
    simple.ColorBy(display, ("POINTS", None))
    display.AmbientColor = display.DiffuseColor = color
    shade(display)


def shade(display):
    display.Ambient = 0.25
    display.Interpolation = "Flat"  # normals that were made before the surface was bent are wrong


def smooth(display):
    display.Ambient = 0.25
    display.Interpolation = "Gouraud"


def lines(display, color=WHITE, width=5):
    """Shows lines as tubes and points as balls, in one color."""
    plain(display, color)
    round_lines(display, width)


def thin_lines(display, color=WHITE, width=1.5):
    """Shows lines in one color, whatever the light."""
    lines(display, color, width)
    display.Ambient, display.Diffuse = 1, 0


def colored_lines(display, largest=None, width=3):
    """Shows lines by their distance, from near to far, on a pale surface."""
    simple.ColorBy(display, ("POINTS", "GeodesicDistance"))
    largest = largest or 1.001 * range_of(display)[1]
    steps(display, ("POINTS", "GeodesicDistance"), 0, largest, shades(36)[9:])
    display.LineWidth = width
    display.RenderLinesAsTubes = 0
    display.Ambient, display.Diffuse = 1, 0
    # Plain lines, as some drivers draw thin tubes as dashes, and a little nearer to the eye than the
    # surface that they lie on. In a parallel projection that moves nothing in the picture.
    view = simple.GetActiveView()
    name = "Translation" if hasattr(display, "Translation") else "Position"  # as of ParaView 5.13, or before
    setattr(display, name, list(0.01 * np.subtract(view.CameraPosition, view.CameraFocalPoint)))


def ball(center, radius, color=WHITE):
    """Shows a ball, in the view that is active. A point drawn as a ball may be lost in a bent surface."""
    display = simple.Show(simple.Sphere(Center=center, Radius=radius, ThetaResolution=32, PhiResolution=32))
    plain(display, color)
    smooth(display)


def round_lines(display, width):
    display.LineWidth = width
    display.PointSize = 2 * width
    display.RenderLinesAsTubes = 1
    display.RenderPointsAsSpheres = 1
    # As for the plugin's own lines: the shader reads the depth before it writes it, where Mesa 25 has any number.
    display.ShaderReplacements = """[{ "type": "fragment", "original": "//VTK::UniformFlow::Impl",
        "replacement": "gl_FragDepth = gl_FragCoord.z;\\n//VTK::UniformFlow::Impl\\n" }]"""
    display.UseShaderReplacements = 1


# ----------------------------------------------------------------------------------------- camera
def view(surfaces, direction=(0.45, -0.85, 0.75), upward=(0, 0, 1), size=(840, 560)):
    """A white view that looks at a surface, or several, from a direction, and is filled by them."""
    new = simple.CreateView("RenderView")
    new.ViewSize = size
    new.OrientationAxesVisibility = 0
    new.UseColorPaletteForBackground = 0
    new.Background = (1, 1, 1)
    look_along(new, surfaces, direction, upward)
    simple.AssignViewToLayout(new)
    return new


def look_along(view, surfaces, direction, upward):
    """Looks back along the direction, with the surfaces filling the view."""
    back = np.array(direction) / np.linalg.norm(direction)
    right = np.cross(upward, back)
    right /= np.linalg.norm(right)
    up = np.cross(back, right)
    surfaces = surfaces if isinstance(surfaces, list) else [surfaces]
    along = np.concatenate([points_of(surface) for surface in surfaces]) @ np.transpose((right, up, back))
    low, high = along.min(axis=0), along.max(axis=0)
    center = (low + high) / 2 @ (right, up, back)
    width, height, depth = high - low

    view.CameraParallelProjection = 1
    view.CameraFocalPoint = center
    view.CameraPosition = center + (width + height + depth) * back
    view.CameraViewUp = up
    columns, rows = view.ViewSize
    view.CameraParallelScale = 0.52 * max(height, width * rows / columns)


def points_of(proxy):
    """All points of what a filter puts out, of all blocks."""
    data = servermanager.Fetch(proxy)
    blocks = [data] if data.IsA("vtkPointSet") else [
        data.GetBlock(i) for i in range(data.GetNumberOfBlocks())]
    return np.concatenate([vtk_to_numpy(block.GetPoints().GetData()) for block in blocks]).astype(float)


# ------------------------------------------------------------------------------------------ files
def save(view, script, times=(), colors=240):
    """Names the pipeline and, with a FOLDER on the script's command line, writes FOLDER/NAME.png.

    The script is given by its variables, globals(): the pipeline takes its names from them. The
    picture is of the view, or, two in a row, of the view at several times, and has so many colors.
    """
    for name, value in script.items():
        if isinstance(value, servermanager.Proxy) and value.GetXMLGroup() in ("sources", "filters"):
            simple.RenameSource(name, value)
    if len(sys.argv) < 2:
        return
    output = pathlib.Path(sys.argv[1]) / pathlib.Path(script["__file__"]).stem
    output.parent.mkdir(parents=True, exist_ok=True)
    if times:
        save_film(view, times, f"{output}.png")
    else:
        save_picture(view, f"{output}.png", colors)


def save_picture(view, file_name, colors=240):
    """Writes what a view shows."""
    simple.SaveScreenshot(file_name, view, ImageResolution=view.ViewSize)
    small_png.write(small_png.read(file_name), file_name, colors)


def save_film(view, times, file_name):
    """Writes what a view shows at several times, two in a row."""
    scene = simple.GetAnimationScene()
    pictures = []
    for time in times:
        scene.AnimationTime = time
        simple.SaveScreenshot(file_name, view, ImageResolution=view.ViewSize)
        pictures.append(small_png.read(file_name))
    scene.AnimationTime = times[0]
    rows = [np.concatenate(pictures[i:i + 2], axis=1) for i in range(0, len(pictures), 2)]
    small_png.write(np.concatenate(rows), file_name)
