# SPDX-License-Identifier: BSD-3-Clause
"""Run inside the ParaView GUI, at first as a script and then, between events, as a module from its
Python shell: makes a sheet, a point and the field from that, starts a Python trace, and writes down
what the filters' properties and outputs are at each step of a session."""

import os
import pathlib
import pickle

from paraview import servermanager, simple, smtrace
from vtkmodules.util.numpy_support import vtk_to_numpy

FOLDER = pathlib.Path(os.environ["GEODESIC_GUI_FOLDER"])
FRAMES = 5


def begin():
    smtrace.start_trace()
    view = simple.GetActiveViewOrCreate("RenderView")
    sheet = simple.Triangulate(registrationName="Sheet",
                               Input=simple.Plane(XResolution=10, YResolution=10))
    mark = simple.PointSource(registrationName="Mark", NumberOfPoints=1, Radius=0,
                              Center=(0.1, 0.2, 0))
    field = simple.GeodesicDistanceField(registrationName="FromMark", Input=sheet, Source=mark)
    simple.Show(field, view)
    simple.SetActiveSource(sheet)
    # The end of the curve that is there at first is in the middle of the view, which is 1.6 high.
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 0.8
    view.CameraFocalPoint = (0.5, 0, 0)
    view.CameraPosition = (0.5, 0, 5)
    view.CameraViewUp = (0, 1, 0)


def filters():
    """The geodesic filters, each with the name that the pipeline browser shows."""
    return [(name, proxy) for (name, _), proxy in simple.GetSources().items()
            if proxy.GetXMLName().startswith("Geodesic")]


def named(name):
    return next(proxy for found, proxy in filters() if found == name)


def properties_of(proxy):
    """All that can be set, an input as the name of its source."""
    names = {source.SMProxy: name for (name, _), source in simple.GetSources().items()}
    values = {}
    for name in proxy.ListProperties():
        value = proxy.SMProxy.GetProperty(name)
        if value.GetIsInternal() or value.GetInformationOnly():
            continue
        if value.IsA("vtkSMInputProperty"):
            values[name] = names.get(value.GetProxy(0))
        else:
            values[name] = [value.GetElement(i) for i in range(value.GetNumberOfElements())]
    return values


def output_of(proxy):
    """Points and arrays, as they are: nothing is brought up to date."""
    output = proxy.GetClientSideObject().GetOutputDataObject(0)
    if not output.GetNumberOfPoints():
        return {}
    data = output.GetPointData()
    arrays = [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
    return {"points": vtk_to_numpy(output.GetPoints().GetData()).astype(float),
            **{array.GetName(): vtk_to_numpy(array).copy() for array in arrays}}


def write(name, what):
    with open(FOLDER / f"geodesic-session-{name}.pickle", "wb") as file:
        pickle.dump(what, file)


def note(step):
    """Writes down what there is."""
    write(step, [{"name": name, "properties": properties_of(proxy), "output": output_of(proxy)}
                 for name, proxy in filters()])


def select(name):
    simple.SetActiveSource(simple.FindSource(name))


def link():
    """Ties a property of both drawn fields together, as Link with... on the panel does. What later fields of the sheet
    have hidden is shown again, as it would not execute."""
    first, second = (proxy for _, proxy in filters() if proxy.GetXMLName().endswith("DrawnCurve"))
    for proxy in (first, second):
        simple.Show(proxy, simple.GetActiveView())
    tie = servermanager.vtkSMPropertyLink()
    for proxy in (first, second):
        tie.AddLinkedProperty(proxy.SMProxy, "RefinementTolerance", 1)
        tie.AddLinkedProperty(proxy.SMProxy, "RefinementTolerance", 2)
    servermanager.ProxyManager().RegisterLink("Tolerances", tie)


def end_trace():
    (FOLDER / "geodesic-session-trace.py").write_text(smtrace.stop_trace())


def watch(name, what):
    """Writes down all executions of a filter from now on."""
    proxy, executions = named(name), []

    def note_execution(*_):
        executions.append({"properties": properties_of(proxy), "output": output_of(proxy),
                           "source": list(simple.FindSource("Mark").Center)})
        write(what, executions)

    proxy.GetClientSideObject().AddObserver("EndEvent", note_execution)


def prepare_animation():
    """Moves the point across the sheet, in five frames. Later fields of the sheet have hidden that of the point."""
    simple.Show(simple.FindSource("FromMark"), simple.GetActiveView())
    scene = simple.GetAnimationScene()
    scene.PlayMode = "Sequence"
    scene.NumberOfFrames = FRAMES
    track = simple.GetAnimationTrack("Center", 0, simple.FindSource("Mark"))
    track.KeyFrames = [simple.CompositeKeyFrame(KeyTime=time, KeyValues=[value])
                       for time, value in ((0, -0.4), (1, 0.4))]
    watch("FromMark", "frames")


if __name__ == "__main__":
    begin()
