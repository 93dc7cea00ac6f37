# SPDX-License-Identifier: BSD-3-Clause
"""Pairs of points, and the places that they are of."""

import numpy as np

from .arrays import points_of
from .inputs import array_of, checked, indexed_points, point_set
from .messages import GeodesicError


def index_pairs(pairs, counts):
    """Pairs of indices of points. counts: for the first index and for the second one whose they are, and how many."""
    pairs = array_of(pairs, "pairs")
    if pairs.size == 0:
        return np.empty((0, 2), np.int64)
    if pairs.ndim != 2 or pairs.shape[1] != 2 or not np.issubdtype(pairs.dtype, np.integer):
        raise GeodesicError(f"pairs has the shape {pairs.shape} and holds {pairs.dtype}: it has rows of two indices of "
                            "points.")
    return np.column_stack([checked(column, count, "pairs", owner) for column, (owner, count) in zip(pairs.T, counts)])


def few_sources(pairs):
    """The ends of pairs of which there are fewer, and the other ends: one column, or of each pair the busier end."""
    count = np.bincount(pairs.ravel())
    ways = np.zeros(len(pairs), int), np.ones(len(pairs), int), (count[pairs[:, 1]] > count[pairs[:, 0]]).astype(int)
    rows = np.arange(len(pairs))
    column = min(ways, key=lambda way: len(np.unique(pairs[rows, way])))
    return pairs[rows, column], pairs[rows, 1 - column]


class Places:
    """Single points, each given by its index in the surface or by its position.

    ids: the index of each point, -1 where it is given by its position. positions: of all, 0 where they have an index.
    """

    def __init__(self, ids, positions):
        self.ids, self.positions = ids, positions

    @classmethod
    def of_indices(cls, ids):
        return cls(ids, np.zeros((len(ids), 3)))

    @classmethod
    def of_positions(cls, positions, name):
        positions = points_of(point_set(positions, name))
        return cls(np.full(len(positions), -1), positions)

    @classmethod
    def each_once(cls, *several):
        """All places of several, each once, and a column for each of the several with the numbers of its places."""
        rows = [np.column_stack((places.ids, places.positions)) for places in several]
        rows, numbers = np.unique(np.concatenate(rows), axis=0, return_inverse=True)
        return cls(rows[:, 0].astype(np.int64), rows[:, 1:]), numbers.reshape(len(several), -1).T

    def __len__(self):
        return len(self.ids)

    def __getitem__(self, numbers):
        return Places(self.ids[numbers], self.positions[numbers])

    def data_set(self, data):
        """The places, of which all or none have an index, as points of a data set. data: the surface's."""
        if self.ids[0] < 0:
            return point_set(self.positions, "pairs")
        return indexed_points(self.ids, data)
