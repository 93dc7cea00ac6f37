# SPDX-License-Identifier: BSD-3-Clause
"""Errors and warnings of geodesicdistance: the words of Python's arguments, at the caller's line."""

import inspect
import os
import pathlib
import re
import subprocess
import sys
import textwrap
import unittest
import warnings

import numpy as np

import geodesicdistance
from geodesicdistance import GeodesicError, Surface, contour, distance, field, matrix, messages, paths, surface
from test_functions import as_poly_data, octahedron, sheet
from vtkmodules.vtkCommonCore import vtkObject

FILTERS = pathlib.Path(__file__).resolve().parents[2] / "Filters"
KINDS = (geodesicdistance.vtkGeodesicDistanceField, geodesicdistance.vtkGeodesicContour,
         geodesicdistance.vtkGeodesicPaths, geodesicdistance.vtkGeodesicDistanceMatrix,
         geodesicdistance.vtkGeodesicFarthestPoints)
# What the drawn curve's proxy says, and what cannot happen here.
NOT_HERE = ("vtkGeodesicDistanceFieldFromDrawnCurve.cxx",)
FAR = [(0.5, 0.5, 0.5)]


def texts_of_sources():
    """The sentences in the strings of the filters' sources, each with its file."""
    for file in sorted(FILTERS.rglob("*.cxx")) + sorted(FILTERS.rglob("*.h")):
        if file.name not in NOT_HERE:
            code = re.sub(r"^\s*(//|\*|/\*).*$", "", file.read_text(), flags=re.MULTILINE)
            code = re.sub(r"(?<!\\)\"\s*\"", "", code)  # strings side by side are one
            for text in re.findall(r'"((?:[^"\\\n]|\\.)*)"', code):
                if re.search(r"[a-z)] [a-z(]", text):
                    yield file.name, text


def property_names():
    setters = {name[3:] for kind in KINDS for name in dir(kind) if name.startswith("Set")}
    of_vtk = {name[3:] for name in dir(KINDS[0].__mro__[2]) if name.startswith("Set")}
    return {name for name in setters - of_vtk if re.fullmatch(r"(?:[A-Z][a-z]+){2,}", name)}


class Words(unittest.TestCase):
    def test_are_pythons_in_all_messages_of_the_filters(self):
        names = property_names()
        self.assertGreater(len(names), 30)
        not_python = re.compile(r"\b(" + "|".join(names) + r")\b|input port|Source Type|upstream|Connect\b|connected")
        texts = list(texts_of_sources())
        self.assertGreater(len(texts), 100)
        self.assertGreater(sum(bool(not_python.search(text)) for _, text in texts), 30)
        for file, text in texts:
            said = messages.in_python(text, surface.ARGUMENTS)
            if not re.match(r".*(rank|component|observer)", said):
                self.assertIsNone(not_python.search(said), f"{file}: {said}")

    def test_of_errors_are_ours_alone(self):
        for call, message in (
                (lambda: distance(octahedron(), None), "The surface is closed: it has no boundary to measure from. "
                                                       "Give a source."),
                (lambda: contour(sheet(), 0, []),
                 "There is no value to draw lines at: give at least one in distances."),
                (lambda: contour(sheet(), 0, [-1]),
                 "Value 0 is -1: set distances that are finite numbers of at least 0, or set signed_distances=True."),
                (lambda: contour(sheet(), 0, 1, chord_tolerance=0), "chord_tolerance is not a positive number: .*"),
                (lambda: field(sheet(), 0, refine_mesh=True, refinement_tolerance=0),
                 "refinement_tolerance is not a positive number: .*, or set refine_mesh=False."),
                (lambda: distance(sheet(), 0, barriers=[1]),
                 "The cell array barriers of the surface has 1 values for 128 cells. Give each cell a value."),
                (lambda: distance(sheet(), 0, barriers=np.ones(128)), "All faces of the surface are barriers: .*"),
                (lambda: matrix(sheet(), None), "There are no targets: give targets."),
                (lambda: distance(sheet(), as_poly_data((np.empty((0, 3)), []))),
                 "The source is empty: .* Give a curve with at least one point, or source=None for the boundary.")):
            with self.subTest(message=message):
                with self.assertRaises(GeodesicError) as caught:
                    call()
                self.assertRegex(str(caught.exception), f"^{message}$")
                self.assertNotRegex(str(caught.exception), r"\n|0x|vtk[A-Z]|[a-z][A-Z]|\bport\b")

    def test_of_warnings_are_ours(self):
        for call, message in (
                (lambda: distance(sheet(), FAR), "The source is up to 0.5 away"),
                (lambda: paths(sheet(), 0, FAR), "The targets are up to 0.5 away"),
                (lambda: field(sheet(), 0, refine_mesh=True, maximum_number_of_cells=10),
                 "more than maximum_number_of_cells .* set refine_mesh=False"),
                (lambda: distance(octahedron(), 0, boundary=True), "^The surface is closed, without boundary")):
            with self.assertWarnsRegex(UserWarning, message):
                call()

    def test_are_not_displayed_by_vtk_as_well(self):
        script = textwrap.dedent("""
            from test_messages import *
            warnings.simplefilter("ignore")
            distance(sheet(), FAR)
            try:
                distance(octahedron(), None)
            except GeodesicError:
                print("raised")
            """)
        done = subprocess.run([sys.executable, "-c", script], cwd=os.path.dirname(os.path.abspath(__file__)),
                              capture_output=True, text=True, check=True)
        self.assertEqual((done.stdout, done.stderr), ("raised\n", ""))


class Silence(unittest.TestCase):
    """With VTK's own display switched off Python still learns of everything."""

    def setUp(self):
        self.before = vtkObject.GetGlobalWarningDisplay()
        vtkObject.GlobalWarningDisplayOff()

    def tearDown(self):
        self.assertEqual(vtkObject.GetGlobalWarningDisplay(), 0)
        vtkObject.SetGlobalWarningDisplay(self.before)

    def test_of_vtk_hides_no_error(self):
        kept = Surface(octahedron())
        for ask in (lambda: distance(octahedron(), None), lambda: kept.distance(None),
                    lambda: contour(octahedron(), None, 1), lambda: paths(octahedron(), None, 1),
                    lambda: matrix(octahedron(), None, 1)):
            with self.assertRaisesRegex(GeodesicError, "^The surface is closed"):
                ask()
        self.assertEqual(kept.distance(0)[0], 0)

    def test_of_vtk_hides_no_warning(self):
        with self.assertWarnsRegex(UserWarning, "^The source is up to 0.5 away"):
            distance(sheet(), FAR)


class Place(unittest.TestCase):
    def test_of_a_warning_is_the_callers_line(self):
        kept = Surface(sheet())

        def nested():
            return distance(sheet(), FAR)

        for call in (lambda: distance(sheet(), FAR), lambda: field(sheet(), FAR), lambda: contour(sheet(), FAR, 1),
                     lambda: paths(sheet(), 0, FAR), lambda: matrix(sheet(), FAR), nested,
                     lambda: kept.distance(FAR), lambda: kept.field(FAR), lambda: kept.matrix(0, FAR),
                     lambda: list(map(kept.distance, [FAR])), lambda: matrix(sheet(), 0, self.unused())):
            with warnings.catch_warnings(record=True) as told:
                warnings.simplefilter("always")
                call()
            self.assertEqual([warning.filename for warning in told], [__file__], inspect.getsource(call))
            lines, first = inspect.getsourcelines(call)
            self.assertIn(told[0].lineno, range(first, first + len(lines)))

    def unused(self):
        return as_poly_data((np.array(FAR), []))


if __name__ == "__main__":
    unittest.main()
