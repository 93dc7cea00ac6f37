# SPDX-License-Identifier: BSD-3-Clause
"""Run inside the ParaView GUI before the events: a square sheet of two halves that share no points,
with a cell array that marks a strip of its right half, a line along its seam and a ring in its left
half. Writes down what the filter does."""

import itertools
import json
import os
import pathlib
import pickle

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

FOLDER = pathlib.Path(os.environ["GEODESIC_GUI_FOLDER"])
RING = [(-0.25 + 0.15 * np.cos(angle), 0.15 * np.sin(angle), 0)
        for angle in np.linspace(0, 2 * np.pi, 60, endpoint=False)]


def flat(points):
    return [x for point in points for x in point]


def half(left):
    """A sheet of squares between two lines of x."""
    return simple.Plane(Origin=(left, -0.5, 0), Point1=(left + 0.5, -0.5, 0),
                        Point2=(left, 0.5, 0), XResolution=10, YResolution=20)


def properties_of(field):
    """The values that the proxy has now; an input as the name of its source."""
    names = {proxy.SMProxy: name for (name, _), proxy in simple.GetSources().items()}
    values = {}
    for name in field.ListProperties():
        value = field.SMProxy.GetProperty(name)
        if value.IsA("vtkSMInputProperty"):
            values[name] = names.get(value.GetProxy(0))
        elif not value.GetInformationOnly():
            values[name] = value.GetElement(0)
    return values


def write_down(field, algorithm, number):
    """What an execution of the filter was asked for, and its output."""
    output = algorithm.GetOutputDataObject(0)
    point_data, field_data = output.GetPointData(), output.GetFieldData()
    arrays = [point_data.GetArray(i) for i in range(point_data.GetNumberOfArrays())]
    said = [field_data.GetArray(i) for i in range(field_data.GetNumberOfArrays())]
    record = {
        "properties": properties_of(field),
        "points": vtk_to_numpy(output.GetPoints().GetData()).astype(float),
        "triangles": vtk_to_numpy(output.GetPolys().GetConnectivityArray()).reshape(-1, 3).copy(),
        "arrays": {array.GetName(): vtk_to_numpy(array).copy() for array in arrays},
        "field data": {array.GetName(): array.GetComponent(0, 0) for array in said},
    }
    with open(FOLDER / f"geodesic-gui-{number}.pickle", "wb") as file:
        pickle.dump(record, file)


def write_answer_down(proxy, algorithm):
    """What another filter was asked for, and its lines or its table."""
    output = algorithm.GetOutputDataObject(0)
    if output.IsA("vtkTable"):
        data, points = output.GetRowData(), None
    else:
        data, points = output.GetCellData(), vtk_to_numpy(output.GetPoints().GetData()).astype(float)
    arrays = [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
    record = {
        "properties": properties_of(proxy),
        "points": points,
        "arrays": {array.GetName(): vtk_to_numpy(array).copy() for array in arrays},
    }
    with open(FOLDER / f"geodesic-gui-{proxy.GetXMLName()}.pickle", "wb") as file:
        pickle.dump(record, file)


def watch(proxy):
    """Each execution of the field is written down, of the other filters the last one."""
    algorithm = proxy.GetClientSideObject()
    kept.append(algorithm)
    if proxy.GetXMLName() == "GeodesicDistanceField":
        numbers = itertools.count()
        algorithm.AddObserver("EndEvent", lambda *_: write_down(proxy, algorithm, next(numbers)))
    else:
        algorithm.AddObserver("EndEvent", lambda *_: write_answer_down(proxy, algorithm))


def look_around(*_):
    """Watches new filters, and writes down which views there are, which data are visible, and what
    their colors show."""
    for proxy in simple.GetSources().values():
        if proxy.GetXMLName().startswith("Geodesic") and proxy.SMProxy not in watched:
            watched.append(proxy.SMProxy)
            watch(proxy)
    shown = {"views": sorted(view.GetXMLName() for view in simple.GetViews()),
             "visible": {}, "colors": {}}
    for proxy in simple.GetSources().values():
        display = servermanager.GetRepresentation(proxy, view)
        if display:
            shown["visible"][proxy.GetXMLName()] = bool(display.Visibility)
            shown["colors"][proxy.GetXMLName()] = list(display.ColorArrayName)
    (FOLDER / "geodesic-gui-shown.json").write_text(json.dumps(shown))


watched = []
kept = []  # an observer refers to its algorithm: without this the garbage collector takes both
view = simple.GetActiveViewOrCreate("RenderView")
manager = servermanager.ProxyManager().SMProxyManager
manager.AddObserver("RegisterEvent", look_around)

left, right = half(-0.5), half(0)
simple.PolyLineSource(registrationName="Curve", Points=flat([(0, -0.5, 0), (0, 0.5, 0)]))
simple.PolyLineSource(registrationName="Ring", Points=flat(RING), Closed=1)
halves = simple.AppendGeometry(registrationName="Halves", Input=[left, right])
# Marked where x is 0.25, and as cells around that.
marked = simple.Calculator(registrationName="Marked", Input=halves, ResultArrayName="Wall",
                           Function="if(abs(coordsX - 0.25) < 0.01, 1, 0)")
sheet = simple.PointDatatoCellData(registrationName="Sheet", Input=marked)
simple.Show(sheet, view)
simple.ResetCamera(view)
simple.SetActiveSource(sheet)
