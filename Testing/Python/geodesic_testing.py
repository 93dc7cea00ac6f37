# SPDX-License-Identifier: BSD-3-Clause
"""What the Python tests share: the plugin, surfaces with a known distance, captured messages."""

import contextlib
import os
import pathlib
import subprocess

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

# ParaView's sources have 32-bit coordinates: their rounding, as a fraction of the largest distance.
FLOAT = 1e-6


def load_plugin():
    """The function GeodesicDistanceField, from the plugin that the build has made."""
    simple.LoadPlugin(os.environ["GEODESIC_PLUGIN"], remote=False, ns=vars(simple))
    return simple.GeodesicDistanceField


def run_gui(paraview, folder, events, setup=None, seconds=250):
    """Plays events, from a file beside this one or with a path of its own, in the real GUI, whose scripts write into
    the folder; setup is a script to begin with. What ParaView says."""
    here = pathlib.Path(__file__).resolve().parent
    # Each event that finds no widget, and each check that does not hold, ends ParaView with an error.
    # timeout also ends what the launcher has started.
    run = subprocess.run(
        ["timeout", str(seconds), paraview, "--dr", f"--test-directory={folder}",
         *([f"--script={here / setup}"] if setup else []), f"--test-script={here / events}", "--exit"],
        env={**os.environ, "GEODESIC_GUI_FOLDER": str(folder)}, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    print(run.stdout)
    assert run.returncode == 0, run.returncode
    return run.stdout


@contextlib.contextmanager
def messages():
    """What VTK says inside, errors and warnings alike, as GetOutput() of the target."""
    window = vtkStringOutputWindow()
    before = vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    try:
        yield window
    finally:
        vtkOutputWindow.SetInstance(before)


def plane(resolution=(24, 18), origin=(0, 0, 0)):
    """A sheet of 4 x 3 made of squares, in 64-bit coordinates."""
    x, y, z = origin
    source = simple.Plane(Origin=origin, Point1=(x + 4, y, z), Point2=(x, y + 3, z))
    source.XResolution, source.YResolution = resolution
    return source


def polyline(points, closed=False):
    return simple.PolyLineSource(Points=[x for point in points for x in point], Closed=int(closed))


def view_of(test):
    """A view for one test, which leaves nothing behind."""
    view = simple.CreateView("RenderView")
    view.ViewSize = (900, 700)
    view.OrientationAxesVisibility = 0
    test.addCleanup(simple.ResetSession)
    test.addCleanup(simple.Delete, view)  # first: ParaView does not survive its going last
    return view


def data(proxy, port=0):
    """The proxy's output, up to date."""
    proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(port)


def points(dataset):
    return vtk_to_numpy(dataset.GetPoints().GetData()).astype(float)


def distances(field, array="GeodesicDistance"):
    return vtk_to_numpy(data(field).GetPointData().GetArray(array))


def distance_to_segments(positions, curve):
    """Euclidean distance of each position to the polyline."""
    result = np.full(len(positions), np.inf)
    for a, b in zip(np.asarray(curve, float), np.asarray(curve[1:], float)):
        along = np.clip((positions - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
        result = np.minimum(result, np.linalg.norm(positions - a - along[:, None] * (b - a), axis=1))
    return result


def assert_close(actual, expected, tolerance):
    """Equal within tolerance, a fraction of the largest expected distance that is finite."""
    finite = np.isfinite(expected)
    np.testing.assert_array_equal(np.isfinite(actual), finite)
    largest = np.max(expected[finite])
    np.testing.assert_allclose(actual[finite], expected[finite], rtol=0, atol=tolerance * largest)
