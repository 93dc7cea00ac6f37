# SPDX-License-Identifier: BSD-3-Clause
"""geodesicdistance on a seam that is kept: an index means that point, not the place where it is with others."""

import unittest

import numpy as np

from geodesicdistance import Surface, distance, matrix, paths

EXACT = 1e-12
# A square of 2 by 2 with a slit of length 1 from the middle of one side: points 3 and 9 are at one place.
POINTS = np.array([(0, 0, 0), (0, 1, 0), (0, 2, 0), (1, 0, 0), (1, 1, 0), (1, 2, 0), (2, 0, 0), (2, 1, 0), (2, 2, 0),
                   (1, 0, 0)], float)
FACES = [(0, 3, 4), (0, 4, 1), (1, 4, 5), (1, 5, 2), (9, 6, 7), (9, 7, 4), (4, 7, 8), (4, 8, 5)]
KEPT = {"merge_coincident_points": False}


def around_slit(start, end):
    """The distance of two points, one of which is at the mouth of the slit."""
    return np.linalg.norm(start - (1, 1, 0)) + np.linalg.norm(end - (1, 1, 0))


class Seam(unittest.TestCase):
    def test_has_two_sides_from_each_of_which_is_measured(self):
        straight = np.linalg.norm(POINTS - POINTS[3], axis=1)
        around = np.array([around_slit(POINTS[3], point) for point in POINTS])
        left, right = POINTS[:, 0] < 1, POINTS[:, 0] > 1
        for source, own, other in ((3, left, right), (9, right, left)):
            expected = np.where(other, around, straight)
            expected[[3, 9]] = (0, 2) if source == 3 else (2, 0)
            for form in (source, [source], np.arange(10) == source):
                np.testing.assert_allclose(distance((POINTS, FACES), form, **KEPT), expected, atol=EXACT)
            np.testing.assert_allclose(matrix((POINTS, FACES), source, range(10), **KEPT)[:, 0], expected, atol=EXACT)
            np.testing.assert_allclose(matrix((POINTS, FACES), range(10), source, **KEPT)[0], expected, atol=EXACT)
            ways = paths((POINTS, FACES), source, range(10), **KEPT)
            np.testing.assert_allclose(ways["GeodesicDistance"], expected, atol=EXACT)
        np.testing.assert_allclose(distance((POINTS, FACES), [3, 9], **KEPT), straight, atol=EXACT)

    def test_is_as_wide_as_the_way_around_it(self):
        kept = Surface((POINTS, FACES), **KEPT)
        np.testing.assert_allclose(kept.matrix([3, 9]), [[0, 2], [2, 0]], atol=EXACT)
        np.testing.assert_allclose(kept.matrix(pairs=[(3, 9), (9, 3), (9, 9)]), [2, 2, 0], atol=EXACT)
        way = kept.paths(3, 9)
        np.testing.assert_allclose(way["GeodesicDistance"], [2], atol=EXACT)
        np.testing.assert_allclose(way["points"][way["lines"][0]][1], (1, 1, 0), atol=EXACT)
        self.assertEqual(kept.field([3, 9], generate_source_ids=True)["SourceId"][[3, 9, 0, 6]].tolist(), [0, 1, 0, 1])
        half = kept.contour(9, 0.5)
        self.assertTrue((half["points"][:, 0] >= 1 - EXACT).all())

    def test_is_closed_where_points_are_merged(self):
        np.testing.assert_allclose(matrix((POINTS, FACES), [3, 9]), np.zeros((2, 2)), atol=EXACT)
        np.testing.assert_array_equal(distance((POINTS, FACES), 3), distance((POINTS, FACES), 9))


if __name__ == "__main__":
    unittest.main()
