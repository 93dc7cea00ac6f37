# SPDX-License-Identifier: BSD-3-Clause
"""A source that leaves the surface in one frame of an animation: for pvpython and for the GUI."""

import numpy as np
from paraview import simple

FRAMES = 10
OFF_THE_SURFACE = 2.0
TIMES = np.linspace(0, 1, FRAMES)


def field(**inputs):
    return simple.GeodesicDistanceField(RefineMesh=0, **inputs)


def contour(**inputs):
    return simple.GeodesicContour(Distances=[0.05, 0.1, 0.15], **inputs)


def pipeline(kind, place):
    """A filter on a ball, and the slice that is its source."""
    ball = simple.Sphere(ThetaResolution=24, PhiResolution=16, Radius=0.5)
    section = simple.Slice(Input=ball)
    section.SliceType.Normal = (1, 0, 0)
    section.SliceType.Origin = (place, 0, 0)
    return kind(Input=ball, Source=section), section


def delete(made):
    """The filter and what it is made from."""
    for proxy in (made, made.Source, made.Input):
        simple.Delete(proxy)


def show(what, view):
    """In colors and from a place that are the same whatever is shown first."""
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = (1, -1, 2), (0, 0, 0), (0, 1, 0)
    display = simple.Show(what, view)
    simple.ColorBy(display, ("POINTS", "GeodesicDistance"))
    display.LookupTable.AutomaticRescaleRangeMode = "Never"
    display.LookupTable.RescaleTransferFunction(0, 0.8)
    view.Update()


def animate(section, failing):
    """Moves the slice across the ball, in the failing frame beside it; the scene."""
    places = np.linspace(-0.4, 0.42, FRAMES)
    places[failing] = OFF_THE_SURFACE
    scene = simple.GetAnimationScene()
    scene.PlayMode, scene.NumberOfFrames = "Sequence", FRAMES
    track = simple.GetAnimationTrack("Origin", 0, section.SliceType)
    track.KeyFrames = [simple.CompositeKeyFrame(KeyTime=time, KeyValues=[place])
                       for time, place in zip(TIMES, places)]
    return scene


def check(frames, failing, fresh_picture, allowed=0):
    """Frames of one animation, played again and again: each looks as that of a pipeline which has never
    seen another place; the failing one shows nothing.

    frames: the places of the slice and the pictures.
    fresh_picture: gives the picture of such a pipeline at a place.
    allowed: the fraction of pixels that may differ. One frame from the next it is a seventh or more.
    """
    assert len({place for place, _ in frames}) == FRAMES and len(frames) % FRAMES == 0, frames
    for number, (place, colors) in enumerate(frames):
        is_there = np.any(colors != colors[0, 0], axis=2)
        assert (place > 1) == (number % FRAMES == failing), (number, place)
        if place > 1:
            assert not np.any(is_there), f"picture {number} is not empty"
        else:
            assert np.mean(is_there) > 0.005, f"picture {number} is empty"
            differ = np.mean(np.any(colors != fresh_picture(place), axis=2))
            assert differ <= allowed, f"picture {number}: {differ:.2%} of its pixels differ"
