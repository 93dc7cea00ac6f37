# SPDX-License-Identifier: BSD-3-Clause
"""Used from the Python shell of the ParaView GUI: what a new user begins with, a ball with two lines and
another ball apart, and what is seen of the filters later."""

import ctypes
import json
import os
import pathlib

from paraview import servermanager, simple

FOLDER = pathlib.Path(os.environ["GEODESIC_GUI_FOLDER"])
RADIUS = 0.5


def put_cursor(x, y):
    """ParaView from 5.13 on picks nothing while the screen's cursor, which events do not move, is outside the view."""
    x11 = ctypes.CDLL("libX11.so.6")
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XDefaultRootWindow.restype = ctypes.c_ulong
    display = ctypes.c_void_p(x11.XOpenDisplay(None))
    root = ctypes.c_ulong(x11.XDefaultRootWindow(display))
    x11.XWarpPointer(display, ctypes.c_ulong(0), root, 0, 0, 0, 0, x, y)
    x11.XCloseDisplay(display)  # which sends what waits


def begin():
    put_cursor(700, 300)
    view = simple.GetActiveViewOrCreate("RenderView")
    ball = simple.Sphere(registrationName="Ball", Radius=RADIUS, ThetaResolution=60, PhiResolution=60)
    simple.Show(ball, view)
    simple.PolyLineSource(registrationName="Front", Points=[-0.1, 0, 0.5, 0.1, 0, 0.5])
    left, right = (simple.Slice(Input=ball) for _ in "lr")
    left.SliceType.Origin, right.SliceType.Origin = (-0.3, 0, 0), (0.3, 0, 0)
    simple.AppendGeometry(registrationName="Sides", Input=[left, right])
    far = simple.Sphere(Radius=0.1, Center=(0, 0.8, 0))
    simple.AppendGeometry(registrationName="Balls", Input=[ball, far])
    beside = simple.PointSource(NumberOfPoints=5, Center=(2, 0, 0))
    simple.AppendGeometry(registrationName="Unused points", Input=[ball, beside])
    simple.SetActiveSource(ball)
    # A tenth of the view's height is 0.2.
    view.CameraParallelProjection, view.CameraParallelScale = 1, 1
    view.CameraFocalPoint, view.CameraPosition, view.CameraViewUp = (0, 0, 0), (0, 0, 5), (0, 1, 0)


def note(step, **seen):
    (FOLDER / f"geodesic-new-user-{step}.json").write_text(json.dumps(seen))


def picture(step):
    simple.SaveScreenshot(str(FOLDER / f"geodesic-new-user-{step}.png"), ImageResolution=(600, 500))


def select(name):
    simple.SetActiveSource(simple.FindSource(name))


def note_curve(step):
    curve = simple.FindSource("GeodesicDistanceFieldFromDrawnCurve1").SMProxy.GetProperty("Points")
    note(step, points=[curve.GetUncheckedElement(i) for i in range(curve.GetNumberOfUncheckedElements())])


def note_shown(step):
    """What is selected, and what the view shows."""
    view = simple.GetActiveView()
    names = {proxy.SMProxy: name for (name, _), proxy in simple.GetSources().items()}
    inputs = [display.SMProxy.GetProperty("Input") for display in view.Representations
              if display.SMProxy.GetProperty("Input") and display.Visibility]
    shown = [f"{names[shown.GetProxy(0)]}:{shown.GetOutputPortForConnection(0)}" for shown in inputs]
    note(f"{step}-shown", selected=names[simple.GetActiveSource().SMProxy], shown=sorted(shown))


def note_label(step):
    """The words in the view, and the results of what is selected."""
    field = simple.GetActiveSource()
    hidden = simple.GetActiveView().SMProxy.GetProperty("HiddenRepresentations")
    shown = [hidden.GetProxy(i) for i in range(hidden.GetNumberOfProxies())]
    words = [label.GetProperty("Input").GetProxy(0).GetProperty("Text").GetElement(0) for label in shown
             if label.GetXMLName() == "TextSourceRepresentation" and label.GetProperty("Visibility").GetElement(0)]
    note(step, words=words, length=field.SourceLength, largest=field.LargestDistance, place=list(field.FarthestPoint))
    picture(step)


def note_panel(step):
    """What is at the top of the panel of what is selected: a group stands where its first property does."""
    proxy = simple.GetActiveSource().SMProxy
    properties = servermanager.vtkSMOrderedPropertyIterator()
    properties.SetProxy(proxy)
    properties.Begin()
    groups = [proxy.GetPropertyGroup(i) for i in range(proxy.GetNumberOfPropertyGroups())]
    members = {group.GetXMLLabel(): [group.GetProperty(i).GetXMLName() for i in range(group.GetNumberOfProperties())]
               for group in groups}
    note(step, first=properties.GetKey(), groups=members)


def note_texture(step, file):
    """A texture as one picture, or none."""
    field = simple.GetActiveSource()
    field.GenerateTextureCoordinates, field.TextureRepeats = 1, 0
    display = simple.GetDisplayProperties(field)
    display.Texture = simple.CreateTexture(str(FOLDER / file)) if file else None
    simple.Render()
    note(step, array=display.ColorArrayName[1], repeats=display.RepeatTextures)


def show_source(visible):
    simple.GetDisplayProperties(simple.OutputPort(simple.GetActiveSource(), 1)).Visibility = visible


def show_array(name):
    display = simple.GetDisplayProperties(simple.GetActiveSource())
    simple.ColorBy(display, ("POINTS", name))
    display.SetScalarBarVisibility(simple.GetActiveView(), True)
    simple.Render()


def note_colors(step):
    """The color map and the bar of what is selected."""
    view = simple.GetActiveView()
    display = simple.GetDisplayProperties(simple.GetActiveSource())
    table = display.LookupTable
    bar = simple.GetScalarBar(table, view)
    note(step, array=display.ColorArrayName[1], categories=table.InterpretValuesAsCategories,
         annotations=list(table.Annotations), colors=list(table.IndexedColors), nodes=list(table.RGBPoints),
         has_gray=table.UseAboveRangeColor, has_word=bar.DrawNanAnnotation, word=bar.NanAnnotation)
    picture(step)


def animate():
    """The maximum distance grows."""
    scene = simple.GetAnimationScene()
    scene.PlayMode = "Sequence"
    scene.NumberOfFrames = 3
    track = simple.GetAnimationTrack("MaximumDistance", 0, simple.GetActiveSource())
    track.KeyFrames = [simple.CompositeKeyFrame(KeyTime=time, KeyValues=[value])
                       for time, value in ((0, 0.4), (1, 1.2))]
