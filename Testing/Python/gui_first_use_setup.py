# SPDX-License-Identifier: BSD-3-Clause
"""Run inside the ParaView GUI before the events: a sheet with another one apart, which no path
reaches, and a line 0.02 above the middle of the first. Writes down what the filter does."""

import itertools
import os
import pathlib
import pickle

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

FOLDER = pathlib.Path(os.environ["GEODESIC_GUI_FOLDER"])


def write_down(field, algorithm, number):
    point_data = algorithm.GetOutputDataObject(0).GetPointData()
    array = point_data.GetArray("GeodesicDistance")
    record = {
        "asked": {name: field.SMProxy.GetProperty(name).GetElement(0)
                  for name in ("SourceType", "UnreachedValue", "CustomUnreachedValue",
                               "RemoveUnusedPoints")},
        "distances": np.array([]) if array is None else vtk_to_numpy(array).copy(),
    }
    with open(FOLDER / f"geodesic-first-{number}.pickle", "wb") as file:
        pickle.dump(record, file)


def watch(field):
    """Each execution is written down."""
    algorithm, numbers = field.GetClientSideObject(), itertools.count()
    algorithm.AddObserver("EndEvent", lambda *_: write_down(field, algorithm, next(numbers)))


def look_around(*_):
    """Watches the field when it is made."""
    for proxy in simple.GetSources().values():
        if proxy.GetXMLName() == "GeodesicDistanceField" and proxy.SMProxy not in watched:
            watched.append(proxy.SMProxy)
            watch(proxy)


watched = []
view = simple.GetActiveViewOrCreate("RenderView")
servermanager.ProxyManager().SMProxyManager.AddObserver("RegisterEvent", look_around)
simple.PolyLineSource(registrationName="Curve", Points=[0, -0.5, 0.02, 0, 0.5, 0.02])
simple.PolyLineSource(registrationName="Points", Points=[0.25, 0, 0, -0.25, 0, 0])
sheets = [simple.Plane(XResolution=10, YResolution=10),
          simple.Plane(Origin=(-0.1, 0.6, 0), Point1=(0.1, 0.6, 0), Point2=(-0.1, 0.7, 0))]
sheet = simple.AppendDatasets(registrationName="Sheet", Input=sheets)  # an unstructured grid
simple.Show(sheet, view)
simple.ResetCamera(view)
simple.SetActiveSource(sheet)
