# SPDX-License-Identifier: BSD-3-Clause
"""The forms in which surfaces and points on them are given to geodesicdistance: all mean the same, or are refused.

GEODESIC_TEST_SEEDS=FIRST,COUNT takes other random surfaces.
"""

import collections
import os
import types
import unittest
import warnings

import numpy as np

from geodesicdistance import GeodesicError, contour, curve, distance, field, matrix, paths
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_LINE, VTK_QUAD, VTK_TRIANGLE, vtkCellArray, vtkImageData,
                                           vtkMultiBlockDataSet, vtkPolyData, vtkTable, vtkUnstructuredGrid)

FIRST, COUNT = map(int, os.environ.get("GEODESIC_TEST_SEEDS", "1,10").split(","))
EXACT = 1e-12


def module(name):
    """A package that is not everywhere, or None."""
    try:
        return __import__(name)
    except ImportError:
        return None


meshio, pandas, trimesh = map(module, ("meshio", "pandas", "trimesh"))


def hills(random, mixed=False):
    """A rough piece of a plane of triangles, with some quads where mixed, as points and a list of faces."""
    columns, rows = random.integers(3, 7, 2)
    x, y = np.meshgrid(np.arange(columns), np.arange(rows))
    points = np.column_stack((x.ravel(), y.ravel(), random.uniform(-0.3, 0.3, x.size)))
    faces = []
    for corner in (np.arange((rows - 1) * columns).reshape(-1, columns)[:, :-1]).ravel():
        a, b, c, d = corner, corner + 1, corner + columns + 1, corner + columns
        faces += [[a, b, c, d]] if mixed and random.random() < 0.5 else [[a, b, c], [a, c, d]]
    return points, [list(map(int, face)) for face in random.permutation(np.array(faces, object))]


def poly_data(points, faces):
    data, places, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    places.SetDataTypeToDouble()
    for point in points:
        places.InsertNextPoint(*point)
    for face in faces:
        cells.InsertNextCell(len(face), face)
    data.SetPoints(places)
    data.SetPolys(cells)
    return data


def grid(points, faces):
    """A vtkUnstructuredGrid, with a line between the first two points."""
    data = vtkUnstructuredGrid()
    data.SetPoints(poly_data(points, []).GetPoints())
    data.Allocate(len(faces) + 1)
    for face in faces:
        data.InsertNextCell({3: VTK_TRIANGLE, 4: VTK_QUAD}[len(face)], len(face), face)
    data.InsertNextCell(VTK_LINE, 2, (0, 1))
    return data


def with_counts(faces):
    return [value for face in faces for value in (len(face), *face)]


def tell_counts(faces):
    """Whether the counts before faces would be a second corner at some point if they were corners."""
    return any(len(face) in face for face in faces)


def blocks_by_size(faces):
    """Faces as the blocks of a meshio mesh, with edges and vertices as Gmsh writes them."""
    kinds = {3: "triangle", 4: "quad"}
    blocks = [types.SimpleNamespace(type="vertex", data=np.array([[0]])),
              types.SimpleNamespace(type="line", data=np.array([[0, 1], [1, 2]]))]
    for size in (3, 4):
        rows = [face for face in faces if len(face) == size]
        if rows:
            blocks.append(types.SimpleNamespace(type=kinds[size], data=np.array(rows)))
    return blocks


def sorted_by_size(faces):
    return sorted(faces, key=len)


class AsArray:
    """What numpy can read, and nothing else: as the vectors of open3d."""

    def __init__(self, values):
        self.values = np.array(values)

    def __array__(self, dtype=None, copy=None):
        return self.values if dtype is None else self.values.astype(dtype)


def surfaces_of_triangles(points, faces):
    array = np.array(faces)
    padded = np.insert(array, 0, 3, axis=1)
    yield "arrays", (points, array)
    yield "lists", [points.tolist(), faces]
    yield "tuples", (tuple(map(tuple, points)), tuple(map(tuple, faces)))
    yield "other memory", (np.asfortranarray(points), np.asfortranarray(array.astype(np.uint16)))
    yield "rows of objects", (points.astype(object), np.array(faces, object))
    yield "big-endian", (points.astype(">f8"), array.astype(">i4"))
    yield "VTK's flat list", (points, padded.ravel())
    yield "VTK's flat list, as a list", (points, with_counts(faces))
    yield "VTK's list in rows", (points, padded)
    yield "VTK's list in lists", (points, padded.tolist())
    yield "dataset_adapter", dataset_adapter.WrapDataObject(poly_data(points, faces))
    yield "vtkUnstructuredGrid", grid(points, faces)
    yield "like trimesh", types.SimpleNamespace(vertices=points, faces=array)
    yield "like open3d", types.SimpleNamespace(vertices=AsArray(points), triangles=AsArray(array))
    yield "like vedo", types.SimpleNamespace(vertices=points, cells=faces)
    yield "like meshio", types.SimpleNamespace(points=points, cells=blocks_by_size(faces))
    yield "like nilearn", types.SimpleNamespace(coordinates=points, faces=array, n_vertices=len(points))
    yield "like nilearn's pair", collections.namedtuple("Mesh", "coordinates faces")(points, array)
    yield "a named triple", collections.namedtuple("Mesh", "name faces coordinates")("left", array, points)
    yield "napari's triple", (points, array, np.arange(len(points)))
    yield "napari's triple of two times", [points.tolist(), faces, np.zeros((2, len(points)))]
    if pandas:
        frame = pandas.DataFrame(points, columns=["x", "y", "z"])
        corners = pandas.DataFrame(array, columns=["a", "b", "c"])
        yield "pandas", (frame, corners)
        yield "pandas, columns", (frame[["x", "y", "z"]], corners.astype("Int64"))
        yield "pandas, a column of lists", (frame, pandas.Series(faces))
    if trimesh:
        yield "trimesh", trimesh.Trimesh(points, array, process=False)
    if meshio:
        yield "meshio", meshio.Mesh(points, [("line", [[0, 1]]), ("triangle", array)])


def surfaces_of_mixed_faces(points, faces):
    yield "vtkUnstructuredGrid", grid(points, faces)
    yield "a list of rows", (points, faces)
    yield "tuples of rows", (points, tuple(map(tuple, faces)))
    yield "a list of arrays", (points, list(map(np.array, faces)))
    yield "an array of rows", (points, np.array(faces + [None], object)[:-1])
    yield "VTK's flat list", (points, np.array(with_counts(faces)))
    if tell_counts(faces):
        yield "VTK's list in rows", (points, [[len(face), *face] for face in faces])
    yield "like meshio", types.SimpleNamespace(points=points, cells=blocks_by_size(faces))
    yield "like meshio, polygons", types.SimpleNamespace(
        points=points, cells=[types.SimpleNamespace(type="polygon", data=[face]) for face in faces])
    if meshio:
        yield "meshio", meshio.Mesh(points, [(block.type, block.data) for block in blocks_by_size(faces)])


class Surfaces(unittest.TestCase):
    def test_in_all_forms_are_the_same(self):
        for seed in range(FIRST, FIRST + COUNT):
            points, faces = hills(np.random.default_rng(seed))
            expected = distance(poly_data(points, faces), 5)
            for name, surface in surfaces_of_triangles(points, faces):
                with self.subTest(form=name, seed=seed):
                    np.testing.assert_array_equal(distance(surface, 5), expected)

    def test_of_mixed_faces_are_the_same_in_all_forms(self):
        for seed in range(FIRST, FIRST + COUNT):
            points, faces = hills(np.random.default_rng(seed), mixed=True)
            faces = sorted_by_size(faces)
            expected = field(poly_data(points, faces), 5)
            for name, surface in surfaces_of_mixed_faces(points, faces):
                with self.subTest(form=name, seed=seed):
                    result = field(surface, 5)
                    np.testing.assert_array_equal(result["faces"], expected["faces"])
                    np.testing.assert_array_equal(result["GeodesicDistance"], expected["GeodesicDistance"])

    def test_of_meshio_are_the_cells_that_are_faces(self):
        random = np.random.default_rng(FIRST)
        points, faces = hills(random, mixed=True)
        faces = sorted_by_size(faces)
        expected = field((points, faces), 5)
        cells = blocks_by_size(faces)
        for name, number in (("tetra", 4), ("hexahedron", 8), ("tetra10", 10)):
            cells.insert(0, types.SimpleNamespace(type=name, data=random.integers(0, len(points), (3, number))))
        cells.append(types.SimpleNamespace(type="wedge", data=np.empty((0, 6), int)))
        cells.append(types.SimpleNamespace(type="line3", data=[[0, 1, 2]]))
        mesh = types.SimpleNamespace(points=points, cells=cells)
        with self.assertWarnsRegex(UserWarning, "3 of type tetra10 and 3 of type hexahedron and 3 of type tetra are "
                                   f"left out: the surface has its {len(faces)} faces alone") as caught:
            result = field(mesh, 5)
        self.assertEqual(caught.filename, __file__)
        np.testing.assert_array_equal(result["faces"], expected["faces"])
        np.testing.assert_array_equal(result["GeodesicDistance"], expected["GeodesicDistance"])
        cubic = types.SimpleNamespace(type="triangle10", data=[[0] * 10])
        for cells, message in ((cells[:3], "cells of type tetra10. A surface has cells of the types triangle, quad"),
                               ([*cells, cubic], "type triangle10")):
            with self.assertRaisesRegex(GeodesicError, message), warnings.catch_warnings():
                distance(types.SimpleNamespace(points=points, cells=cells), 5)

    def test_of_meshio_may_be_curved(self):
        """A cell of six points is four triangles through them."""
        points, faces = hills(np.random.default_rng(FIRST))
        corners = np.array(faces)
        ends = np.sort(np.stack((corners, np.roll(corners, -1, axis=1)), axis=2).reshape(-1, 2), axis=1)
        edges, middles = np.unique(ends, axis=0, return_inverse=True)
        more = np.concatenate((points, points[edges].mean(axis=1) + (0, 0, 0.1)))
        ab, bc, ca = (len(points) + middles.reshape(-1, 3)).T
        a, b, c = corners.T
        parts = (a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)
        split = np.concatenate([np.column_stack(part) for part in parts])
        cells = [types.SimpleNamespace(type="triangle6", data=np.column_stack((corners, ab, bc, ca)))]
        mesh = types.SimpleNamespace(points=more, cells=cells)
        np.testing.assert_allclose(distance(mesh, 5), distance((more, split), 5), atol=EXACT)
        cells[0].data, rest = cells[0].data[1:], cells[0].data[:1, :3]
        cells.append(types.SimpleNamespace(type="triangle", data=rest))
        flat = np.concatenate((split[np.arange(len(split)) % len(corners) != 0], rest))
        np.testing.assert_allclose(distance(mesh, 5)[:len(points)], distance((more, flat), 5)[:len(points)], atol=EXACT)
        walls = np.arange(len(corners)) % 3 == 1
        four = np.concatenate([np.roll(walls, -1)[:-1]] * 4 + [walls[:1]])
        order = np.concatenate((split.reshape(4, -1, 3)[:, 1:].reshape(-1, 3), rest))
        np.testing.assert_allclose(distance(mesh, 5, barriers=np.roll(walls, -1))[:len(points)],
                                   distance((more, order), 5, barriers=four)[:len(points)], atol=EXACT)

    def test_of_triangles_in_columns_are_refused(self):
        for seed in range(FIRST, FIRST + 10 * COUNT):
            points, faces = hills(np.random.default_rng(seed))
            array, in_order = np.array(faces), np.array(sorted(faces))  # which has neighbors behind one another
            for count in (1, 2, 4, 5, 6, len(faces)):
                for rows in (in_order[:count], np.roll(in_order, seed, axis=1)[::-1][:count], array):
                    with self.subTest(seed=seed, count=count), \
                            self.assertRaisesRegex(GeodesicError, r"row for each, faces\.T"):
                        distance((points, rows.T), int(rows[0, 0]))
        for rows in ([[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 5]], [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]):
            with self.assertRaisesRegex(GeodesicError, r"faces\.tolist\(\)"):
                distance((points, np.array(rows).T), 0)

    def test_of_three_polygons_are_taken(self):
        """In a row, around a corner, as a list also where nothing tells, and with counts."""
        x, y = np.meshgrid(np.arange(4.0), np.arange(3.0))
        points = np.column_stack((x.ravel(), y.ravel(), np.zeros(12)))
        row, corner = [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6]], [[0, 1, 5, 4], [1, 2, 6, 5], [4, 5, 9, 8]]
        for faces in (row, corner):
            expected = distance(poly_data(points, faces), 0)
            for form in (faces, np.array(faces), np.insert(faces, 0, 4, axis=1)):
                np.testing.assert_allclose(distance((points, form), 0), expected, atol=EXACT)
        apart = [[0, 1, 5, 4], [2, 3, 7, 6], [8, 9, 10, 11]]
        with self.assertRaisesRegex(GeodesicError, r"Three faces of 4 corners are .* list of rows: faces\.tolist"):
            distance((points, np.array(apart)), 0)
        self.assertAlmostEqual(distance((points, apart), 0)[5], 2 ** 0.5, delta=EXACT)
        cells = [types.SimpleNamespace(type="quad", data=np.array(apart))]
        self.assertAlmostEqual(distance(types.SimpleNamespace(points=points, cells=cells), 0)[5], 2 ** 0.5, delta=EXACT)

    def test_with_counts_that_could_be_corners_are_refused(self):
        refused = 0
        for seed in range(FIRST, FIRST + 10 * COUNT):
            points, faces = hills(np.random.default_rng(seed), mixed=True)
            if not tell_counts(faces):
                refused += 1
                with self.assertRaisesRegex(GeodesicError, "counts"):
                    distance((points, [[len(face), *face] for face in faces]), 5)
        print(f"{refused} of {10 * COUNT} surfaces with counts were refused")

    def test_of_blocks_have_the_points_of_all_blocks(self):
        points, faces = hills(np.random.default_rng(FIRST))
        left = [face for face in faces if points[face, 0].mean() < 1]
        right = [face for face in faces if face not in left]
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, poly_data(points, left))
        blocks.SetBlock(2, poly_data(points, right))
        whole = distance((points, faces), 5)
        n = len(points)
        result = field(blocks, n + 5)
        np.testing.assert_array_equal(result["points"], np.concatenate((points, points)))
        self.assertEqual(sorted(map(sorted, result["faces"].tolist())),
                         sorted(sorted(face) for face in left + (np.array(right) + n).tolist()))
        of_block = np.concatenate((np.isin(np.arange(n), left), np.isin(np.arange(n), right)))
        np.testing.assert_allclose(result["GeodesicDistance"][of_block], np.concatenate((whole, whole))[of_block],
                                   atol=EXACT)

    def test_of_grids_have_the_points_that_their_faces_use(self):
        points, faces = hills(np.random.default_rng(FIRST))
        stray = np.concatenate((points, [(0, 0, 9.0)]))
        data = grid(stray, faces)
        data.InsertNextCell(VTK_LINE, 2, (0, len(points)))
        with self.assertRaisesRegex(GeodesicError, f"Point {len(points)} of the source belongs to no face"), \
                warnings.catch_warnings():
            distance(data, len(points))
        with self.assertWarnsRegex(UserWarning, "1 of 2 targets not reached"):
            table = matrix(data, 0, [len(points), 1])
        np.testing.assert_array_equal(table[:, 0], distance((stray, faces), 0)[[len(points), 1]])

    def test_with_counts_before_quads_are_taken_for_quads(self):
        points, _ = hills(np.random.default_rng(FIRST))
        columns = int(points[:, 0].max()) + 1
        corners = np.arange(len(points)).reshape(-1, columns)[:-1, :-1].ravel()
        quads = corners[:, None] + [0, 1, columns + 1, columns]
        counted = np.insert(quads, 0, 4, axis=1)
        expected = distance((points, quads), 5)
        for given in (counted, counted.ravel(), counted.tolist(), np.roll(quads, 1, axis=1)):
            np.testing.assert_allclose(distance((points, given), 5), expected, atol=EXACT)

    def test_where_counts_and_corners_cannot_be_told_apart_are_refused(self):
        square = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], float)
        for faces in ([[3, 0, 1, 2]], np.array([[3, 0, 1, 2]])):
            with self.assertRaisesRegex(GeodesicError, r"faces\[:, 1:\] where they are counts, numpy.roll"):
                distance((square, faces), 0)
        self.assertEqual(distance((square, np.array([[3, 0, 1, 2]])[:, 1:]), 0)[3], np.inf)
        self.assertEqual(distance((square, np.roll([[3, 0, 1, 2]], 1, axis=1)), 0)[3], 1)
        # Here there is but one meaning: there is no point 3, or a face would have it twice.
        np.testing.assert_allclose(distance((square[:3], [[3, 0, 1, 2]]), 0), [0, 1, 2 ** 0.5], atol=EXACT)
        np.testing.assert_allclose(
            distance((square, [[3, 0, 1, 2], [3, 0, 2, 3]]), 0), [0, 1, 2 ** 0.5, 1], atol=EXACT)
        # Rows of three are faces, whatever they begin with; blocks of meshio say what they are.
        self.assertEqual(distance((square, [[2, 0, 1], [2, 3, 0]]), 0)[3], 1)
        quad = types.SimpleNamespace(points=square, cells=[types.SimpleNamespace(type="quad", data=[[3, 0, 1, 2]])])
        self.assertEqual(distance(quad, 0)[3], 1)

    def test_that_are_wrong_are_refused_with_what_is_right(self):
        points, faces = hills(np.random.default_rng(FIRST))
        n = len(points)
        cells = [types.SimpleNamespace(type="tetra", data=[[0, 1, 2, 3]])]
        tetrahedra = types.SimpleNamespace(points=points, cells=cells)
        bad = points.copy()
        bad[1] = np.nan
        for surface, message in (
                ((points, np.array(faces, float)), "float64: indices are integers"),
                ((points, [[0, 1, 1.5]]), "float64: indices are integers"),
                ((points, [[True, False, True]]), "bool: indices are integers"),
                ((points, [["0", "1", "2"]]), "indices are integers"),
                ((points, {(0, 1, 2)}), "given as a set"),
                ((points, [(0, 1, n)]), f"to {n}, but there are {n} points"),
                ((points, [(0, 1, 2), (0, 1, 2, n)]), f"to {n}, but there are {n} points"),
                ((points, [(0, 1, -1)]), "from -1 to 1"),
                (poly_data(points, [(0, 1, n)]), f"names point {n}, but there are only"),
                ((points, [(0, 1), (1, 2)]), "Face 0 has 2 corners"),
                ((points, [(0, 1, 2), (1, 2)]), "Face 1 has 2 corners"),
                ((points, [0, 1, 2, 1, 2, 3]), r"faces.reshape\(-1, 3\)"),
                ((points, [3, 0, 1, 2, 3, 0, 1]), r"faces.reshape\(-1, 3\)"),
                ((points, np.zeros((2, 2, 3), int)), r"\(number, corners\)"),
                ((points, []), f"has {n} points and no faces"),
                ((np.empty((0, 3)), []), "has 0 points"),
                ((points[:, :2], faces), r"\(number, 3\)"),
                ((points.T, faces), r"\(number, 3\).*\.T"),
                ((points.astype(complex), faces), "complex128 are given where numbers are needed"),
                ((points.astype(str), faces), "numbers are needed"),
                (([[0, 0, 0], [1, 0]], faces), "rows differ in length"),
                ((bad, faces), "NaN or infinite, at point 1"),
                (tetrahedra, "type tetra.*triangle, quad.*vtkDataSetSurfaceFilter"),
                (types.SimpleNamespace(parts={"left": 0, "right": 1}), r"Give one of its parts: \.parts\['left'\]"),
                ((points, faces, [1, 2]), "A tuple is no surface"),
                ((points, faces, faces), "A tuple is no surface"),
                ([(0, 0, 0), (1, 0, 0), (0, 1, 0)], "A list is no surface"),
                ((points, faces, [[1, 2], [3]]), "A tuple is no surface"),
                (types.SimpleNamespace(points=points), "pair, as in geodesicdistance.distance"),
                (points, "pair, as in geodesicdistance.distance"),
                ("mesh.stl", "A str is no surface"),
                (vtkImageData(), "A vtkImageData is no surface: vtkDataSetSurfaceFilter"),
                (None, "A NoneType is no surface")):
            with self.subTest(message=message), self.assertRaisesRegex(GeodesicError, message):
                distance(surface, 0)

    def test_given_as_two_arguments_are_refused_with_the_right_form(self):
        points, faces = hills(np.random.default_rng(FIRST))
        for call in (lambda: distance(points, faces, 0), lambda: distance(points.tolist(), faces, 0),
                     lambda: distance(points, faces, source=0), lambda: contour(points, faces, 0, [1]),
                     lambda: matrix(points, faces, [0, 1])):
            with self.assertRaisesRegex(GeodesicError, r"distance\(\(points, faces\), source\)"):
                call()


class Sources(unittest.TestCase):
    def test_in_all_forms_are_the_same(self):
        for seed in range(FIRST, FIRST + COUNT):
            random = np.random.default_rng(seed)
            points, faces = hills(random)
            ids = np.sort(random.choice(len(points), 3, replace=False))
            mask = np.isin(np.arange(len(points)), ids)
            expected = distance((points, faces), poly_data(points[ids], []))
            forms = [ids, ids.tolist(), tuple(ids), ids.astype(np.uint8), ids.astype(">i2"), AsArray(ids), mask,
                     mask.tolist(), points[ids], points[ids].tolist(), points[ids].astype(object)]
            if pandas:
                forms += [pandas.Series(ids), pandas.Series(ids, dtype="Int64"), pandas.Series(mask),
                          pandas.DataFrame(points[ids]), pandas.DataFrame({"id": ids})["id"]]
            for form in forms:
                with self.subTest(form=repr(form), seed=seed):
                    np.testing.assert_array_equal(distance((points, faces), form), expected)
                    np.testing.assert_array_equal(matrix((points, faces), 0, form), matrix((points, faces), 0, ids))
            one = distance((points, faces), poly_data(points[[4]], []))
            wrapped = dataset_adapter.WrapDataObject(poly_data(points[[4]], []))
            for form in (wrapped, 4, np.int32(4), np.array(4), [4], range(4, 5), points[4], points[4].tolist(),
                         tuple(points[4]), curve(points[[4]])):
                with self.subTest(form=repr(form), seed=seed):
                    np.testing.assert_array_equal(distance((points, faces), form), one)

    def test_that_are_wrong_are_refused_with_what_is_right(self):
        points, faces = hills(np.random.default_rng(FIRST))
        n = len(points)
        for source, message in (
                ({1, 2}, "source is given as a set.*index of a point"),
                (frozenset([1]), "source is given as a frozenset"),
                ({0: 1}, "source is given as a dict"),
                ("0", "source is given as a str"),
                (b"0", "source is given as a bytes"),
                (["0", "1"], "numbers are needed"),
                (0.0, "Indices are integers"),
                (np.float64(3), "Indices are integers"),
                ([0.0, 8.0], "Indices are integers"),
                (np.arange(4.0), "Indices are integers"),
                ([[0, 1]], r"\(number, 3\)"),
                ([[0, 1, 2], [3, 4]], "rows differ in length"),
                ([0, None], "not an array of numbers"),
                (np.ma.masked_equal([0, 1], 1), "values are masked"),
                (object(), "not an array of numbers"),
                (iter([0, 1]), "not an array of numbers"),
                ([curve([(0, 0, 0)])], "not an array of numbers"),
                ([True, False], f"shape \\(2,\\), but the surface has {n} points"),
                (True, "shape \\(\\), but the surface"),
                (np.arange(n) % 2, f"has a 0 or 1 for each of the {n} points.*mask.astype\\(bool\\)"),
                ((np.arange(n) % 2).tolist(), "mask.astype"),
                (np.zeros(n, np.uint8), "mask.astype"),
                ([], "source is empty"),
                (np.zeros(n, bool), "source is empty"),
                (np.empty((0, 3)), "source is empty"),
                (-1, "there is no -1"),
                ([0, n], f"there is no {n}"),
                (np.uint64(2 ** 64 - 1), "there is no 18446744073709551615"),
                ((np.nan, 0, 0), "NaN or infinite, at point 0"),
                (curve([(np.nan, 0, 0)]), "NaN or infinite, at point 0"),
                (vtkTable(), "vtkTable")):
            with self.subTest(source=repr(source)), self.assertRaisesRegex(GeodesicError, message):
                distance((points, faces), source)
        for targets, message in (({1}, "targets is given as a set"), (-1, "there is no -1"), ([], "targets is empty"),
                                 (1.5, "Indices are integers"),
                                 (np.arange(n) % 2, "set of targets has a 0 or 1 for each")):
            for ask in (paths, matrix):
                with self.subTest(targets=repr(targets)), self.assertRaisesRegex(GeodesicError, message):
                    ask((points, faces), 0, targets)
        for positions, message in (([], r"curve"), ([(0, 0)], r"\(number, 3\)"), ("ab", "given as a str")):
            with self.assertRaisesRegex(GeodesicError, message):
                curve(positions)

    def test_of_indices_0_and_1_are_no_masks_where_they_are_not_as_many_as_the_points(self):
        points, faces = hills(np.random.default_rng(FIRST))
        np.testing.assert_array_equal(distance((points, faces), [0, 1, 0]), distance((points, faces), [0, 1]))
        mask = np.arange(len(points)) % 2
        np.testing.assert_array_equal(distance((points, faces), mask.astype(bool)),
                                      distance((points, faces), np.flatnonzero(mask)))
        np.testing.assert_array_equal(matrix((points, faces), 0, mask + 1)[:, 0],
                                      distance((points, faces), 0)[mask + 1])

    def test_that_no_face_uses_are_refused_unless_they_are_at_a_place_of_the_surface(self):
        points, faces = hills(np.random.default_rng(FIRST))
        n = len(points)
        more = np.concatenate((points, points[[0]] + (0, 0, 0.001), points[[3]]))
        for ask in (lambda source: distance((more, faces), source), lambda source: matrix((more, faces), source, [0]),
                    lambda source: contour((more, faces), source, 1), lambda source: paths((more, faces), source, 0)):
            with self.assertRaisesRegex(GeodesicError, "belongs to (no|a) face"):
                ask(n)
        np.testing.assert_array_equal(distance((more, faces), n + 1), distance((more, faces), 3))
        for source in (n + 1, [0, n + 1], np.arange(n + 2) == n + 1):
            with self.assertRaisesRegex(GeodesicError, f"Point {n + 1} of the source belongs to no face"):
                distance((more, faces), source, merge_coincident_points=False)


class Barriers(unittest.TestCase):
    def test_in_all_forms_are_the_same(self):
        points, faces = hills(np.random.default_rng(FIRST))
        walls = np.arange(len(faces)) % 5 == 4
        expected = distance((points, faces), 0, barriers=walls)
        self.assertFalse(np.array_equal(expected, distance((points, faces), 0)))
        data = poly_data(points, faces)
        array = numpy_to_vtk(walls.astype(np.int8), deep=True)
        array.SetName("walls")
        data.GetCellData().AddArray(array)
        forms = [((points, faces), walls.tolist()), ((points, faces), walls.astype(float)), (data, walls),
                 (data, "walls")]
        if pandas:
            forms.append(((points, faces), pandas.Series(walls)))
        for surface, barriers in forms:
            np.testing.assert_array_equal(distance(surface, 0, barriers=barriers), expected)

    def test_that_are_wrong_are_refused(self):
        surface = hills(np.random.default_rng(FIRST))
        for barriers, message in (([1, 0], "2 values for"), ("walls", "no cell array named walls"),
                                  (["a"], "numbers are needed"), ([[0, 1]] * len(surface[1]), "components")):
            with self.assertRaisesRegex(GeodesicError, message):
                distance(surface, 0, barriers=barriers)
        with self.assertRaisesRegex(GeodesicError, "Barriers: blocks have no array in common"):
            distance(vtkMultiBlockDataSet(), [(0, 0, 0)], barriers=[1])


class Packages(unittest.TestCase):
    """Says which forms could not be tried with the real packages."""

    def test_are_there(self):
        missing = [name for name in ("meshio", "pandas", "trimesh") if not globals()[name]]
        if missing:
            self.skipTest(f"only stand-ins were tried: this Python has no {', '.join(missing)}")


if __name__ == "__main__":
    unittest.main()
