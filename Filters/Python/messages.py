# SPDX-License-Identifier: BSD-3-Clause
"""Errors and warnings of the filters as Python's, in the words of Python's arguments."""

import re
import sys
import warnings

from vtkmodules.vtkCommonCore import vtkObject

# What the filters' messages say, as a pattern, and what is said here. Names of properties come after these.
PHRASES = (
    (r" \((points of )?input port \d\)", ""),
    (r" upstream\b", ""),
    (r", by which BarrierArrayName has barriers", " for barriers"),
    (r" \(BarrierArrayName\)", ""),
    (r", or set Source Type to Surface Boundary", ", or source=None for the boundary"),
    (r" Set Source Type to Source Curve and choose a Source\.", " Give a source."),
    (r"choose a data set with points as Targets", "give targets"),
    (r"[Cc]hoose a Source", "give a source"),
    (r"Choose another Source", "Give another source"),
    (r"No curve is connected as Source", "There is no curve in source"),
    (r"Connect (a curve|at least)", r"Give \1"),
    (r"Connect a surface", "Give a surface"),
    (r"set at least one distance \(.*?\)", "give at least one in distances"),
    (r"give a point of the source in", "give a start in"),
    (r"set Accuracy to Approximate", "set relative_error"),
    (r"switch ([A-Z]\w+) off", r"set \1=False"),
    (r"switch ([A-Z]\w+) on", r"set \1=True"),
)


class GeodesicError(ValueError):
    """An input or an argument with which there is no result."""


def property_name(argument):
    """The name that the filters have for an argument: RefineMesh for refine_mesh."""
    return "".join(word.capitalize() for word in argument.split("_"))


def in_python(text, arguments):
    """A message of a filter in Python's words. arguments: their names by those of the filters' properties."""
    for pattern, words in PHRASES:
        text = re.sub(pattern, words, text)
    return re.sub(r"\b[A-Z]\w+\b", lambda word: arguments.get(word[0], word[0]), text)


def run(filter, arguments):
    """Executes a filter. What it calls an error is raised, what it calls a warning is one of Python's."""
    told = []
    # An observed message is not displayed; GetErrorMessage() has that of the error.
    tags = [filter.AddObserver("ErrorEvent", lambda *_: None), _collect(filter, "WarningEvent", told)]
    display = vtkObject.GetGlobalWarningDisplay()
    vtkObject.GlobalWarningDisplayOn()  # else observers get no warnings
    try:
        filter.Update()
    finally:
        vtkObject.SetGlobalWarningDisplay(display)
        for tag in tags:
            filter.RemoveObserver(tag)
    for text in told:
        warn(in_python(text, arguments))
    if filter.GetErrorMessage():
        raise GeodesicError(in_python(filter.GetErrorMessage(), arguments))


def warn(text):
    """A warning that points to the line outside of this package that has called it."""
    frame, level = sys._getframe(), 1
    while frame.f_back and frame.f_globals.get("__package__") == __package__:
        frame, level = frame.f_back, level + 1
    warnings.warn(text, stacklevel=level)


def _collect(filter, event, texts):
    """Has the texts of a filter's messages added to a list, without where in VTK they come from."""
    def note(_caller, _event, text):
        texts.append(re.sub(r"^.*?\(0x[0-9a-f]+\): ", "", text, flags=re.DOTALL).strip())

    note.CallDataType = "string0"
    return filter.AddObserver(event, note)
