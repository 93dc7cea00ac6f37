# SPDX-License-Identifier: BSD-3-Clause
"""Used from the Python shell of the ParaView GUI: prepares animations with a frame that fails, keeps what
the view shows while they are played, and then what pipelines of their own show in the same view."""

import os
import pathlib
import pickle

from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

import failed_frame

FOLDER = pathlib.Path(os.environ["GEODESIC_GUI_FOLDER"])
view = simple.GetActiveViewOrCreate("RenderView")


def pixels():
    """What has been drawn last, as it is."""
    grab = vtkWindowToImageFilter()
    grab.SetInput(view.GetRenderWindow())
    grab.ShouldRerenderOff()
    grab.ReadFrontBufferOff()
    grab.Update()
    picture = grab.GetOutput()
    columns, rows, _ = picture.GetDimensions()
    return vtk_to_numpy(picture.GetPointData().GetScalars()).reshape(rows, columns, -1).astype(int)


class Animation:
    """A filter whose source moves and in one frame fails; keeps each frame that is played."""

    def __init__(self, kind, failing):
        self.name, self.kind, self.failing = f"{kind}-{failing}", getattr(failed_frame, kind), failing
        self.frames = []
        self.made, self.section = failed_frame.pipeline(self.kind, 0.0)
        failed_frame.show(self.made, view)
        scene = failed_frame.animate(self.section, failing)
        # The scene ticks, and then the view is drawn.
        self.observers = [(sender, sender.AddObserver(event, call)) for sender, event, call in (
            (scene.SMProxy.GetClientSideObject(), "AnimationCueTickEvent", self.begin_frame),
            (view.GetRenderWindow(), "EndEvent", self.keep_picture))]

    def begin_frame(self, *_):
        self.frames.append((self.section.SliceType.Origin[0], None))

    def keep_picture(self, *_):
        if self.frames:
            self.frames[-1] = (self.frames[-1][0], pixels())

    def end(self):
        """Draws the pipelines to compare with, and writes all pictures down."""
        for sender, observer in self.observers:
            sender.RemoveObserver(observer)
        fresh = {}
        for place, _ in self.frames[:failed_frame.FRAMES]:
            simple.HideAll(view)
            made, _ = failed_frame.pipeline(self.kind, place)
            if place < failed_frame.OFF_THE_SURFACE:
                failed_frame.show(made, view)
                view.StillRender()
                fresh[place] = pixels()
            failed_frame.delete(made)
        failed_frame.delete(self.made)
        with open(FOLDER / f"geodesic-failed-{self.name}.pickle", "wb") as file:
            pickle.dump({"failing": self.failing, "frames": self.frames, "fresh": fresh}, file)


def begin():
    view.OrientationAxesVisibility = 0
    layout = simple.GetLayout(view)
    layout.PreviewMode = [300, 250]
