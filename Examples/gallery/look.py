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
RED, BLUE = (0.76, 0.16, 0.18), (0.12, 0.27, 0.60)
GREEN = (0.1, 0.55, 0.3)
PALE_RED, PALE_BLUE = (0.98, 0.72, 0.58), (0.62, 0.80, 0.95)
WHITE, PALE, GRAY, DARK = (0.97, 0.96, 0.94), (0.87, 0.87, 0.85), (0.75, 0.75, 0.75), (0.2, 0.2, 0.22)
RINGS = (0.15, 0.45, 0.65), (0.35, 0.70, 0.60), (0.55, 0.45, 0.70), (0.25, 0.25, 0.28)
REGIONS = ((0.98, 0.80, 0.40), (0.87, 0.42, 0.40), (0.45, 0.66, 0.55),
           (0.36, 0.42, 0.68), (0.72, 0.56, 0.76), (0.66, 0.80, 0.90))
CORNER = (0.02, 0.03)  # of a picture, in fractions of its width and height


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


def stripes(display, width=None, largest=None, unit="", at=CORNER):
    """Colors a display by its distance in stripes of one round width, up to the largest distance, and notes the
    width in the picture at a place, if one is given."""
    array = ("POINTS", "GeodesicDistance")
    simple.ColorBy(display, array)
    largest = largest or range_of(display)[1]
    width = width or round_width(largest)
    count = int(np.ceil(largest / width))
    steps(display, array, 0, count * width, striped(shades(count)))
    if at is not None:
        note(f"Stripes are {width:g}{unit} wide", at)


def round_width(largest, most=30):
    """The smallest width of 1, 2 or 5 times a power of ten that gives no more stripes than that."""
    decade = 10.0 ** np.floor(np.log10(largest / most))
    return next(factor * decade for factor in (1, 2, 5, 10) if factor * decade * most >= largest)


def range_of(display):
    """The smallest and the largest number that it is colored by, without those that are infinite."""
    display.LookupTable.ColorSpace = "RGB"  # else the plugin rounds the range
    display.RescaleTransferFunctionToDataRange(False, True)
    return display.LookupTable.RGBPoints[0], display.LookupTable.RGBPoints[-4]


def sides(display, width):
    """Colors a display by its signed distance in stripes of one width, blue for negative and red for positive ones,
    and notes the width."""
    array = ("POINTS", "SignedGeodesicDistance")
    simple.ColorBy(display, array)
    count = int(np.ceil(max(abs(end) for end in range_of(display)) / width))
    right, left = (striped([mix(pale, color, i / (count - 1)) for i in range(count)], 0.2)
                   for pale, color in ((PALE_BLUE, BLUE), (PALE_RED, RED)))
    steps(display, array, -count * width, count * width, right[::-1] + left)
    note(f"Stripes are {width:g} wide")


def steps(display, array, low, high, colors, separate=False):
    """Colors a display by an array in equal steps from a low to a high value, also with a color map of its own."""
    simple.ColorBy(display, array, separate)
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


def colored_lines(display, largest=None, width=3, colors=None):
    """Shows lines by their distance, from near to far, on a pale surface."""
    simple.ColorBy(display, ("POINTS", "GeodesicDistance"))
    largest = largest or 1.001 * range_of(display)[1]
    steps(display, ("POINTS", "GeodesicDistance"), 0, largest, colors or shades(36)[9:])
    display.LineWidth = width
    display.RenderLinesAsTubes = 0
    display.Ambient, display.Diffuse = 1, 0
    nearer(display, simple.GetActiveView())  # plain lines, as some drivers draw thin tubes as dashes


def nearer(display, view, by=0.01):
    """Shows something a little nearer to the eye than the surface that it lies on. In a parallel projection that moves
    nothing in the picture."""
    move(display, by * np.subtract(view.CameraPosition, view.CameraFocalPoint))


def move(display, way):
    name = "Translation" if hasattr(display, "Translation") else "Position"  # as of ParaView 5.13, or before
    setattr(display, name, list(way))


def balls(centers, radius, color=WHITE):
    """Shows balls, in the view that is active. A point drawn as a ball may be lost in a bent surface."""
    points = simple.PolyPointSource(Points=np.ravel(centers))
    placed = simple.Glyph(Input=points, GlyphType="Sphere", GlyphMode="All Points", ScaleFactor=2 * radius)
    placed.GlyphType.ThetaResolution = placed.GlyphType.PhiResolution = 32
    placed.ScaleArray = placed.OrientationArray = ["POINTS", ""]
    display = simple.Show(placed)
    plain(display, color)
    smooth(display)
    return display


def round_lines(display, width):
    display.LineWidth = width
    display.PointSize = 2 * width
    display.RenderLinesAsTubes = 1
    display.RenderPointsAsSpheres = 1
    # As for the plugin's own lines: the shader reads the depth before it writes it, where Mesa 25 has any number.
    display.ShaderReplacements = """[{ "type": "fragment", "original": "//VTK::UniformFlow::Impl",
        "replacement": "gl_FragDepth = gl_FragCoord.z;\\n//VTK::UniformFlow::Impl\\n" }]"""
    display.UseShaderReplacements = 1


def with_normals(surface):
    """A surface that bends without facets when it is shown smooth. Of its arrays none stays: normals from before it was
    bent would be kept (ParaView 5.13)."""
    bare = simple.PassArrays(registrationName="Bare", Input=surface, PointDataArrays=[], CellDataArrays=[])
    Normals = getattr(simple, "SurfaceNormals", None) or simple.GenerateSurfaceNormals  # of ParaView 5.12, or 5.11
    return Normals(registrationName="Normals", Input=bare, Splitting=0)


# ------------------------------------------------------------------------------------------ words
def note(text, at=CORNER, size=18):
    """Writes words into the view that is active, from a place on in fractions of its width and height."""
    display = simple.Show(simple.Text(Text=text))
    display.WindowLocation = "Any Location"
    display.Position = at
    display.FontSize = size
    display.Color = DARK


def time(at=(0.5, 0.03), size=18):
    """Writes the animation's time into the view that is active."""
    display = simple.Show(simple.AnnotateTime(Format="Time {time:.2f}"))
    display.WindowLocation = "Any Location"
    display.Position = at
    display.FontSize = size
    display.Color = DARK


def legend(display, title, ends, at=(0.03, 0.05), length=0.3):
    """Shows the colors of a display as a bar in the view that is active, with the numbers at its ends."""
    view = simple.GetActiveView()
    bar = simple.GetScalarBar(display.LookupTable, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.Orientation, bar.WindowLocation = "Horizontal", "Any Location"
    bar.Position, bar.ScalarBarLength, bar.ScalarBarThickness = at, length, 12
    bar.TitleFontSize = bar.LabelFontSize = 18
    bar.TitleColor = bar.LabelColor = DARK
    bar.UseCustomLabels, bar.CustomLabels = 1, ends
    bar.AddRangeLabels = bar.DrawTickMarks = display.LookupTable.UseAboveRangeColor = 0
    bar.Visibility = 1
    bar.TitleJustification = "Left"


def axes(display, title, x_labels, y_labels):
    """Shows numbers at the left and the lower side of what lies in the plane of x and y, and a title below."""
    grid = display.DataAxesGrid
    grid.GridAxesVisibility, grid.ShowGrid, grid.ShowEdges, grid.ShowTicks = 1, 0, 0, 0
    grid.XTitle, grid.YTitle, grid.ZTitle = title, "", ""
    grid.FacesToRender, grid.AxesToLabel = 4, 3
    for axis in "XY":
        for words in "Title", "Label":
            setattr(grid, f"{axis}{words}FontSize", 18)
            setattr(grid, f"{axis}{words}Color", DARK)
    grid.XAxisUseCustomLabels, grid.XAxisLabels = 1, list(x_labels)
    grid.YAxisUseCustomLabels, grid.YAxisLabels = 1, list(y_labels)


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
