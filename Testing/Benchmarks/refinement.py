# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of exact distance on a refined mesh, and how accurate refinement makes it.

usage: pvpython refinement.py OUTPUT
       pvpython refinement.py OUTPUT --surface FILE [--curve FILE] [more: see --help]

Without a surface, refines the plane in data/ for each of two curves to 2, 4 and 8 times the
faces, and prints by which factor the largest error over 100,000 random points falls; the picture is of
the first. With a surface, measures from the curve, or without it from the surface's boundary. OUTPUT.png
has stripes at equal distance and the edges of the refined mesh.
"""

import argparse
import pathlib
import sys

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

HERE = pathlib.Path(__file__).resolve().parent
EXAMPLES = HERE.parents[1] / "Examples"
sys.path[:0] = [str(EXAMPLES), str(EXAMPLES / "gallery")]
import look  # noqa: E402
import small_png  # noqa: E402
from geodesic_distance import read  # noqa: E402

SAMPLES = 100000


def points_of(poly_data):
    return vtk_to_numpy(poly_data.GetPoints().GetData()).astype(float)


def distance_in_plane(points, corners):
    """The distance of points in a convex part of a plane to a polyline."""
    nearest = np.full(len(points), np.inf)
    for start, end in zip(corners[:-1], corners[1:]):
        along = end - start
        t = np.clip((points - start) @ along / (along @ along), 0, 1)
        nearest = np.minimum(nearest, np.linalg.norm(points - start - t[:, None] * along, axis=1))
    return nearest


def largest_error(field, corners):
    """Of the linear interpolant against the true distance, over random points of the faces."""
    output = simple.servermanager.Fetch(field)
    points = points_of(output)
    distance = vtk_to_numpy(output.GetPointData().GetArray(field.DistanceArrayName))
    faces = vtk_to_numpy(output.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = (points[faces[:, i]] for i in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)

    random = np.random.default_rng(1)
    face = random.choice(len(faces), SAMPLES, p=area / area.sum())
    # Equally distributed in a triangle, which is one half of a parallelogram.
    u, v = random.random((2, SAMPLES))
    u, v = np.where(u + v > 1, (1 - u, 1 - v), (u, v))
    weights = np.stack((1 - u - v, u, v), axis=1)
    samples = np.einsum("ij,ijk->ik", weights, points[faces[face]])
    interpolant = np.einsum("ij,ij->i", weights, distance[faces[face]])
    return np.abs(interpolant - distance_in_plane(samples, corners)).max()


def number_of_faces(field):
    field.UpdatePipeline()
    return field.GetDataInformation().GetNumberOfCells()


def refine_to(field, faces):
    """Sets the smallest tolerance, to a thousandth, that gives at most so many faces."""
    field.RefineMesh = 1
    field.ToleranceIsAbsolute = 0
    low, high = 1e-9, 1.0
    while high > 1.001 * low:
        field.RefinementTolerance = np.sqrt(low * high)
        if number_of_faces(field) > faces:
            low = field.RefinementTolerance
        else:
            high = field.RefinementTolerance
    field.RefinementTolerance = high
    return number_of_faces(field)


def bound(field):
    """What the filter certifies about its linear interpolant."""
    data = simple.servermanager.Fetch(field).GetFieldData()
    return data.GetArray("InterpolationErrorBound").GetValue(0)


def refine_plane(surface, curve):
    """Prints how the error falls. Returns the field on the plane, and when refined to 4 times the faces."""
    corners = points_of(simple.servermanager.Fetch(curve))
    original = simple.GeodesicDistanceField(Input=surface, Source=curve, RefineMesh=0)
    faces = number_of_faces(original)
    error = largest_error(original, corners)
    print(f"{faces} faces: largest error {error:.3g}")

    fields = {}
    for times in (2, 4, 8):
        field = fields[times] = simple.GeodesicDistanceField(Input=surface, Source=curve)
        refined = refine_to(field, times * faces)
        now = largest_error(field, corners)
        print(
            f"{refined} faces ({refined / faces:.2f} times) at tolerance {field.RefinementTolerance:.3g}: "
            f"largest error {now:.3g} (certified {bound(field):.3g}), {error / now:.1f} times smaller"
        )
    return original, fields[4]


def view_of(field, edges, direction, upward):
    """A view of the field with stripes, and with the edges of its triangles or not."""
    view = look.view(field, direction, upward, (500, 500))
    display = simple.Show(field, view)
    look.stripes(display, at=None if edges else look.CORNER)  # edges leave no room for words
    if edges:
        display.SetRepresentationType("Surface With Edges")
        display.EdgeColor = (0.1, 0.1, 0.1)
    look.lines(simple.Show(simple.OutputPort(field, 1), view), width=3 if edges else 7)
    return view


def zoom(view, center, factor):
    """Closes in on a point; without one, on the middle of the view."""
    if center is not None:
        back = np.subtract(view.CameraPosition, view.CameraFocalPoint)
        view.CameraFocalPoint = center
        view.CameraPosition = center + back
    view.CameraParallelScale /= factor


def save_pair(views, file_name):
    """Writes what two views show, side by side."""
    pictures = []
    for view in views:
        simple.SaveScreenshot(file_name, view, ImageResolution=view.ViewSize)
        pictures.append(small_png.read(file_name))
    small_png.write(np.concatenate(pictures, axis=1), file_name)


def plane(output):
    surface = read(str(HERE / "data" / "plane.vtp"))
    pairs = []
    for name in ("plane-curve.vtp", "plane-zigzag.vtp"):
        print(name)
        pairs.append(refine_plane(surface, read(str(HERE / "data" / name))))
    views = [view_of(field, True, (0, 0, 1), (0, 1, 0)) for field in pairs[0]]
    save_pair(views, output + ".png")


def surface(arguments):
    field = simple.GeodesicDistanceField(Input=read(arguments.surface))
    field.RefinementTolerance = arguments.tolerance
    if arguments.curve:
        field.Source = read(arguments.curve)
    else:
        field.SourceType = "Surface Boundary"
    faces = number_of_faces(field.Input)
    print(f"{faces} faces, {number_of_faces(field)} when refined, certified error {bound(field):.3g}")
    views = [view_of(field, edges, arguments.view_from, arguments.upward) for edges in (False, True)]
    zoom(views[1], arguments.center, arguments.zoom)
    save_pair(views, arguments.output + ".png")


def main():
    usage = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    usage.add_argument("output", metavar="OUTPUT", help="name of the picture, without .png")
    usage.add_argument("--surface", metavar="FILE", help="a surface to show instead of the plane")
    usage.add_argument("--curve", metavar="FILE", help="what distance is measured from")
    usage.add_argument("--tolerance", type=float, default=0.001, help="the RefinementTolerance")
    direction = {"type": float, "nargs": 3, "metavar": ("X", "Y", "Z")}
    view_from = {"dest": "view_from", "default": (0.45, -0.85, 0.75), "help": "where to look from"}
    usage.add_argument("--from", **view_from, **direction)
    usage.add_argument("--upward", default=(0, 0, 1), help="what is up", **direction)
    usage.add_argument("--center", help="the middle of the close-up of the refined mesh", **direction)
    usage.add_argument("--zoom", type=float, default=3.0, help="of the close-up")
    arguments = usage.parse_args()
    if arguments.surface:
        surface(arguments)
    else:
        plane(arguments.output)


if __name__ == "__main__":
    main()
