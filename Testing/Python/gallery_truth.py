# SPDX-License-Identifier: BSD-3-Clause
"""What must hold for each script of the gallery: a function a script, which takes its variables.

Most surfaces of the gallery unroll into the plane without stretching, where distances are those of
points and segments: these are computed here, from nothing of the filters' but the points.
"""

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonExecutionModel import vtkExtentTranslator
from vtkmodules.vtkFiltersModeling import vtkDijkstraGraphGeodesicPath

from geodesic_testing import FLOAT, assert_close, data, distances, points

# A fraction of the largest distance.
EXACT = 1e-12


# ---------------------------------------------------------------------------------------- helpers
def lines(output):
    """The points of each line."""
    offsets = vtk_to_numpy(output.GetLines().GetOffsetsArray())
    ids = vtk_to_numpy(output.GetLines().GetConnectivityArray())
    return [points(output)[ids[a:b]] for a, b in zip(offsets, offsets[1:])]


def segments(output):
    """The two ends of each segment of all lines, as an array of segments, ends and coordinates."""
    return np.concatenate([np.stack((line[:-1], line[1:]), axis=1) for line in lines(output)])


def cell_array(output, name):
    return vtk_to_numpy(output.GetCellData().GetArray(name))


def point_array(output, name):
    return vtk_to_numpy(output.GetPointData().GetArray(name))


def to_segments(positions, ends):
    """Euclidean distance of each position to the nearest of some segments."""
    nearest = np.full(len(positions), np.inf)
    for a, b in ends:
        along = b - a
        t = np.clip((positions - a) @ along / max(along @ along, 1e-300), 0, 1)
        nearest = np.minimum(nearest, np.linalg.norm(positions - a - t[:, None] * along, axis=1))
    return nearest


def lengths_along(corners):
    """How far along a polyline each of its corners is."""
    return np.append(0, np.cumsum(np.linalg.norm(np.diff(corners, axis=0), axis=1)))


class Outline:
    """A closed polygon around the origin of a plane, which sees all of it, and lengths along it."""

    def __init__(self, corners):
        angle = np.arctan2(corners[:, 1], corners[:, 0]) % (2 * np.pi)
        _, first = np.unique(np.round(angle, 5), return_index=True)
        self.angles, self.corners = angle[first], corners[first]
        self.along = lengths_along(np.concatenate((self.corners, self.corners[:1])))
        self.length = self.along[-1]

    def place(self, positions):
        """How far along the polygon positions on it are."""
        angle = np.arctan2(positions[..., 1], positions[..., 0]) % (2 * np.pi)
        # A corner belongs to the segment after it, also where its angle is rounded down.
        segment = np.searchsorted(self.angles, angle + 1e-5) - 1
        return self.along[segment] + np.linalg.norm(positions - self.corners[segment], axis=-1)


class Bent:
    """A sheet that is bent along x and z only, given by points that begin with a row along these."""

    def __init__(self, sheet):
        positions = points(data(sheet))
        row = positions[positions[:, 1] == positions[0, 1]][:, [0, 2]]
        self.starts, self.steps = row[:-1], np.diff(row, axis=0)
        self.along = lengths_along(row)

    def unrolled(self, positions):
        """How far along the closest place of the row is, and y."""
        nearest = np.full(positions.shape[:-1], np.inf)
        along = np.zeros(positions.shape[:-1])
        for start, step, before in zip(self.starts, self.steps, self.along):
            from_start = positions[..., [0, 2]] - start
            t = np.clip(from_start @ step / (step @ step), 0, 1)
            away = np.linalg.norm(from_start - t[..., None] * step, axis=-1)
            along = np.where(away < nearest, before + t * np.linalg.norm(step), along)
            nearest = np.minimum(nearest, away)
        return np.stack((along, positions[..., 1]), axis=-1)


def assert_between_bounds(surface, start, vertices, found):
    """Distances from a place at a vertex are at least those through space, and at most those along edges."""
    places = points(surface)
    first = np.argmin(np.linalg.norm(places - start, axis=1))
    near = 0.01
    assert np.linalg.norm(places[first] - start) < near
    assert np.all(found >= np.linalg.norm(places[vertices] - start, axis=1) - near)
    along_edges = vtkDijkstraGraphGeodesicPath()
    along_edges.SetInputData(surface)
    along_edges.SetStartVertex(first)
    along_edges.StopWhenEndReachedOff()
    along_edges.Update()
    lengths = vtkDoubleArray()
    along_edges.GetCumulativeWeights(lengths)
    lengths = vtk_to_numpy(lengths)[vertices]
    assert np.all(found <= lengths + near), (found - lengths).max()
    # On a mesh as regular as that of a volume's voxels edges are no more than this longer.
    far = lengths > 10
    assert np.all(found[far] > 0.75 * lengths[far]), (found[far] / lengths[far]).min()


def assert_no_step_is_too_long(positions, triangles, found):
    """Along an edge a distance grows by no more than the edge is long."""
    edges = triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    lengths = np.linalg.norm(positions[edges[:, 0]] - positions[edges[:, 1]], axis=1)
    steps = np.abs(found[edges[:, 0]] - found[edges[:, 1]])
    assert np.all(steps <= lengths + FLOAT * found.max()), (steps - lengths).max()


# ---------------------------------------------------------------------------- a function a script
def section(names):
    """Around the column and along it, in the unrolled plane, which repeats."""
    column = Outline(points(data(names["fluted"]))[:, [0, 2]])

    def unrolled(positions):
        return np.stack((column.place(positions[..., [0, 2]]), positions[..., 1]), axis=-1)

    cut = unrolled(segments(data(names["section"])))
    # Of a segment that ends where lengths begin again, both ends on one side.
    wraps = np.abs(cut[:, 0, 0] - cut[:, 1, 0]) > column.length / 2
    cut[wraps, :, 0] += column.length * (cut[wraps, :, 0] < column.length / 2)
    output = data(names["field"])
    positions = unrolled(points(output))
    expected = np.min([to_segments(positions, cut + (shift * column.length, 0)) for shift in (-1, 0, 1)], axis=0)
    assert_close(distances(names["field"]), expected, 3 * FLOAT)


def feature_edges(names):
    """In the plane on top and bottom; on the walls up, down or around."""
    positions, found = points(data(names["field"])), distances(names["field"])
    ends = segments(data(names["edges"]))
    top = 0.5
    expected = np.minimum(positions[:, 2], top - positions[:, 2])
    for height in (0, top):
        level = np.abs(positions[:, 2] - height) < FLOAT
        rims = ends[np.all(np.abs(ends[:, :, 2] - height) < FLOAT, axis=1)]
        expected[level] = to_segments(positions[level], rims)

    # The walls of the teeth have upright edges, too.
    on_top = ends[:, 0][np.abs(ends[:, 0, 2] - top) < FLOAT, :2]
    rim = Outline(on_top[np.linalg.norm(on_top, axis=1) > 0.5])
    upright = ends[np.abs(ends[:, 0, 2] - ends[:, 1, 2]) > FLOAT]
    assert len(upright) == 4 * 12
    outer = np.linalg.norm(positions[:, :2], axis=1) > 0.5
    outer &= (positions[:, 2] > FLOAT) & (positions[:, 2] < top - FLOAT)
    apart = np.abs(rim.place(positions[outer, :2])[:, None] - rim.place(upright[:, 0, :2]))
    around = np.min(np.minimum(apart, rim.length - apart), axis=1)
    expected[outer] = np.minimum(expected[outer], around)
    assert_close(found, expected, 3 * FLOAT)


def boundary(names):
    """In the unrolled plane."""
    sheet = Bent(names["bent"])
    rim = sheet.unrolled(segments(data(names["field"], 1)))
    some = slice(None, None, 5)
    expected = to_segments(sheet.unrolled(points(data(names["field"]))[some]), rim)
    assert_close(distances(names["field"])[some], expected, 3 * FLOAT)


def drawn_curve(names):
    """In the unrolled plane, from the points that were drawn, joined by straight lines."""
    roll = Bent(names["roll"])
    ends = roll.unrolled(segments(data(names["field"], 1)))
    expected = to_segments(roll.unrolled(points(data(names["field"]))), ends)
    assert_close(distances(names["field"]), expected, 3 * FLOAT)

    drawn = np.reshape(list(names["field"].Points), (-1, 3))
    length = np.sum(np.linalg.norm(np.diff(roll.unrolled(drawn), axis=0), axis=1))
    found = np.sum(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1))
    assert abs(found - length) < 3 * FLOAT * length


def stripes(names):
    """The source is where the distance is zero, and distances are those of a surface; colors change at equal
    steps, and reach the largest distance."""
    output, found = data(names["field"]), distances(names["field"])
    triangles = vtk_to_numpy(output.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    assert_no_step_is_too_long(points(output), triangles, found)
    brain, start = data(names["brain"]), np.array(list(names["start"].Center))
    count = brain.GetNumberOfPoints()
    np.testing.assert_array_equal(points(output)[:count], points(brain))
    assert_between_bounds(brain, start, np.arange(count), found[:count])

    from_source = distances(simple.GeodesicPaths(
        Input=names["field"].Input, Source=names["field"].Source, Targets=simple.OutputPort(names["field"], 1)))
    assert from_source.max() < FLOAT * found.max()
    ends = np.reshape(simple.GetColorTransferFunction("GeodesicDistance").RGBPoints, (-1, 4))[:, 0]
    np.testing.assert_allclose(ends, 10 * np.arange(len(ends)), atol=1e-9)
    assert ends[-2] < found.max() <= ends[-1]


def offset_curves(names):
    """Closed, and in the unrolled plane at equal steps from the rim."""
    sheet = Bent(names["bent"])
    rim = sheet.unrolled(segments(data(names["rim"])))
    output = data(names["offsets"])
    values = cell_array(output, "GeodesicDistance")
    assert len(set(values)) > 10
    np.testing.assert_allclose(sorted(set(values)), names["STEP"] * np.arange(1, len(set(values)) + 1))
    for line in lines(output):
        np.testing.assert_array_equal(line[0], line[-1])
    expected = to_segments(sheet.unrolled(points(output)), rim)
    assert_close(point_array(output, "GeodesicDistance"), expected, 3 * FLOAT)


def nearest_curve(names):
    """As near as the nearest line alone, which is that of the region."""
    output = data(names["field"])
    count = data(names["hills"]).GetNumberOfPoints()
    together = distances(names["field"])[:count]
    nearest = point_array(output, "SourceId")[:count]
    alone = np.array([
        distances(simple.GeodesicDistanceField(
            Input=names["hills"], Source=names["on_hills"](line), RefineMesh=0))
        for line in names["lines"]])
    assert set(nearest) == set(range(6))
    assert_close(together, alone.min(axis=0), EXACT)
    assert_close(alone[nearest, np.arange(count)], together, EXACT)


def shortest_paths(names):
    """Lines from the targets to the start, as long as they say and as the field at the targets."""
    output, brain = data(names["paths"]), data(names["brain"])
    found = cell_array(output, "GeodesicDistance")
    start, targets = np.array(list(names["start"].Center)), points(data(names["targets"]))
    assert output.GetNumberOfLines() == len(found) == len(targets) > 100
    vertices = [np.argmin(np.linalg.norm(points(brain) - target, axis=1)) for target in targets]
    np.testing.assert_array_equal(points(brain)[vertices], targets)
    assert_between_bounds(brain, start, vertices, found)
    field = simple.GeodesicDistanceField(Input=names["brain"], Source=names["start"], RefineMesh=0)
    assert_close(found, distances(field)[vertices], FLOAT)
    for line, target, length in zip(lines(output), targets[cell_array(output, "TargetId")], found):
        np.testing.assert_allclose(line[[0, -1]], (target, start), rtol=0, atol=0.01)
        assert abs(length - lengths_along(line)[-1]) < 4 * FLOAT * len(line) * length


def signed_side(names):
    """Of one sign where the seam winds around, projected from a pole that it does not wind around."""
    output = data(names["field"])
    signed = point_array(output, "SignedGeodesicDistance")
    np.testing.assert_array_equal(np.abs(signed), distances(names["field"]))
    t = 2 * np.pi * np.arange(120) / 120
    seam = np.array([names["seam"](at) for at in t])
    height = points(output)[:, 2] / np.linalg.norm(points(output), axis=1)
    far = (np.abs(signed) > 0.05) & (height < 0.999)
    assert far.mean() > 0.8

    def projected(positions):
        """From (0, 0, 1) to the plane of complex numbers."""
        x, y, z = (positions / np.linalg.norm(positions, axis=1)[:, None]).T
        return (x + 1j * y) / (1 - z)

    corners = projected(np.concatenate((seam, seam[:1])))
    around = corners - projected(points(output)[far])[:, None]
    turns = np.round(np.sum(np.angle(around[:, 1:] / around[:, :-1]), axis=1) / (2 * np.pi))
    inside = np.abs(turns) == 1
    assert 0.2 < inside.mean() < 0.8
    # From above the plane is seen as the ball is from inside: what is on the left is on the right.
    np.testing.assert_array_equal(signed[far] > 0, inside == (turns[inside][0] < 0))


def cut(names):
    """The halves of a tennis ball's cover have one area, and only the seam in common."""
    areas = []
    for half, sign in ((names["left"], 1), (names["right"], -1)):
        assert (sign * point_array(data(half), "SignedGeodesicDistance") > -FLOAT).all()
        area = simple.IntegrateVariables(Input=half)
        areas.append(cell_array(data(area), "Area")[0])
        simple.Delete(area)
    assert abs(areas[0] - areas[1]) < 0.002 * areas[0]
    whole = simple.IntegrateVariables(Input=names["ball"])
    assert abs(sum(areas) - cell_array(data(whole), "Area")[0]) < 1e-6
    simple.Delete(whole)


def along_a_curve(names):
    """In the unrolled plane the curve at the arc length is as far as the distance says."""
    sheet = Bent(names["waves"])
    (line,) = lines(data(names["field"], 1))
    corners = sheet.unrolled(line)
    along = lengths_along(corners)
    output = data(names["field"])
    lengths = point_array(output, "SourceArcLength")
    assert lengths.min() == 0 and abs(lengths.max() - along[-1]) < FLOAT * along[-1]
    feet = np.stack([np.interp(lengths, along, corners[:, axis]) for axis in (0, 1)], axis=1)
    apart = np.linalg.norm(sheet.unrolled(points(output)) - feet, axis=1)
    assert_close(distances(names["field"]), apart, 3 * FLOAT)


def decal(names):
    """As far as the distance, in the direction of the last piece of a path, seen from its end."""
    output = data(names["field"])
    found = distances(names["field"])
    # Refinement puts points where two shortest paths are equally long: only points of the head.
    found = found[: data(names["head"]).GetNumberOfPoints()]
    near = np.flatnonzero(np.isfinite(found) & (found > 1))[::100]
    plane = point_array(output, "SourceTextureCoordinates")[near][:, :2] - 0.5
    assert_close(90 * np.linalg.norm(plane, axis=1), found[near], FLOAT)
    targets = simple.PolyLineSource(Points=points(output)[near].ravel())
    paths = data(simple.GeodesicPaths(Input=names["head"], Source=names["start"], Targets=targets))
    frame = vtk_to_numpy(output.GetFieldData().GetArray("SourceFrame")).reshape(3, 3)
    away = np.array([line[-2] - line[-1] for line in lines(paths)]) @ frame.T
    assert len(away) == len(near) > 50
    turned = np.angle((plane[:, 0] + 1j * plane[:, 1]) / (away[:, 0] + 1j * away[:, 1]))
    assert np.max(np.abs(turned)) < 1e-4


def unrolled(names):
    """Paths end on the line at the arc length, and are as long as the distance."""
    output = data(names["field"])
    some = slice(None, None, 100)
    targets = simple.PolyLineSource(Points=points(output)[some].ravel())
    paths = data(simple.GeodesicPaths(Input=names["vessel"], Source=names["line"], Targets=targets,
                                      MergeCoincidentPoints=0))
    (line,) = lines(data(names["field"], 1))
    lengths = point_array(output, "SourceArcLength")[some]
    feet = np.stack([np.interp(lengths, lengths_along(line), line[:, axis]) for axis in range(3)], axis=1)
    ends = np.array([path[-1] for path in lines(paths)])
    assert len(ends) == len(feet)
    assert np.mean(np.linalg.norm(ends - feet, axis=1) < 1e-4) > 0.98  # but for ties
    signed = point_array(output, "SignedGeodesicDistance")[some]
    assert_close(np.abs(signed), cell_array(paths, "GeodesicDistance"), 10 * FLOAT)
    assert signed.min() < -1 and signed.max() > 1


def barriers(names):
    """Along straight lines from corner to corner of the walls."""
    wall = cell_array(data(names["plan"]), "Wall").reshape(80, 120) > 0
    plan = WallPlan(wall, 0.1)
    door = np.array([(0, 3.6), (0, 4.4)])
    found = distances(names["field"])
    reached = np.isfinite(found)
    some = np.flatnonzero(reached)[::5]
    expected = plan.ways_to(points(data(names["field"]))[some, :2], door)
    assert_close(found[some], expected, 3 * FLOAT)

    rows, columns = np.indices(wall.shape)
    corners = np.zeros((81, 121), int)
    for i in (0, 1):
        for j in (0, 1):
            np.add.at(corners, (rows + i, columns + j), ~wall)
    np.testing.assert_array_equal(reached[:corners.size], corners.ravel() > 0)
    from_people = plan.ways_to(points(data(names["people"]))[:, :2], door)
    assert_close(cell_array(data(names["paths"]), "GeodesicDistance"), from_people, 3 * FLOAT)


class WallPlan:
    """Walls as rectangles of cells on a floor, and their corners."""

    def __init__(self, wall, size):
        rectangles = self.runs(wall) + [(y, x) for x, y in self.runs(wall.T)]
        self.rectangles = size * np.array(rectangles, float)  # of each the range of x, then of y
        # Between a wall at the floor's edge and that edge is no way.
        edge = size * np.array(wall.shape[::-1])[:, None]
        self.rectangles = np.where(self.rectangles == 0, -1, self.rectangles)
        self.rectangles = np.where(self.rectangles == edge, edge + 1, self.rectangles)
        around = np.pad(wall, 1).astype(int)
        count = around[1:, 1:] + around[:-1, 1:] + around[1:, :-1] + around[:-1, :-1]
        rows, columns = np.nonzero(count == 1)
        within = (rows > 0) & (rows < wall.shape[0]) & (columns > 0) & (columns < wall.shape[1])
        self.corners = size * np.stack((columns[within], rows[within]), axis=1).astype(float)

    @staticmethod
    def runs(wall):
        """The ranges of columns and of rows of rectangles whose rows are alike."""
        rows = [np.flatnonzero(np.diff(np.pad(row.astype(int), 1))).reshape(-1, 2) for row in wall]
        found, open_runs = [], {}
        for number, row in enumerate([*rows, []]):
            now = {tuple(run) for run in row}
            found += [(run, (start, number)) for run, start in open_runs.items() if run not in now]
            open_runs = {run: open_runs.get(run, number) for run in now}
        return found

    def sees(self, a, b):
        """Whether no wall is between a and b, for arrays of both."""
        free = np.ones(np.broadcast(a[..., 0], b[..., 0]).shape, bool)
        for rectangle in self.rectangles:
            enter, leave = np.zeros(free.shape), np.ones(free.shape)
            for axis, (low, high) in enumerate(rectangle):
                start, along = a[..., axis], b[..., axis] - a[..., axis]
                with np.errstate(divide="ignore", invalid="ignore"):
                    ends = np.sort([(low + 1e-4 - start) / along, (high - 1e-4 - start) / along], axis=0)
                inside = (start > low + 1e-4) & (start < high - 1e-4)
                still = np.broadcast_to(np.abs(along) < 1e-9, free.shape)
                enter = np.maximum(enter, np.where(still, np.where(inside, 0, 2), ends[0]))
                leave = np.minimum(leave, np.where(still, np.where(inside, 1, -1), ends[1]))
            free &= enter >= leave
        return free

    def straight_to(self, positions, segment):
        """The length of the shortest straight line to a segment that meets no wall."""
        a, b = segment
        t = np.clip((positions - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
        nearest = np.full(len(positions), np.inf)
        for at in (t, 0 * t, 0 * t + 1):
            ends = a + at[:, None] * (b - a)
            length = np.linalg.norm(positions - ends, axis=1)
            nearest = np.minimum(nearest, np.where(self.sees(positions, ends), length, np.inf))
        return nearest

    def ways_to(self, positions, segment):
        """The length of the shortest way to a segment around the walls."""
        lengths, shorter = None, self.straight_to(self.corners, segment)
        while not np.array_equal(lengths, shorter):
            lengths, shorter = shorter, np.minimum(shorter, self.by_corners(self.corners, shorter))
        return np.minimum(self.straight_to(positions, segment), self.by_corners(positions, lengths))

    def by_corners(self, positions, lengths):
        way = np.linalg.norm(positions[:, None] - self.corners, axis=2)
        seen = self.sees(positions[:, None], self.corners[None])
        return np.min(np.where(seen, way + lengths, np.inf), axis=1)


def distance_matrix(names):
    """Columns, each measured from another electrode, agree: what is far from one is as far from the other, and
    no detour is shorter."""
    head, table = data(names["head"]), names["distances"]
    assert (table.shape, table.dtype) == ((37, 37), float)
    np.testing.assert_array_equal(np.diag(table), 0)
    assert_close(table.ravel(), table.T.ravel(), 3 * FLOAT)
    detours = np.min(table[:, :, None] + table[None], axis=1)
    assert np.all(table <= detours + 3 * FLOAT * table.max())
    places = np.array(names["places"])
    vertices = [np.argmin(np.linalg.norm(points(head) - place, axis=1)) for place in places]
    for place, column in zip(places, table.T):
        assert_between_bounds(head, place, vertices, column)
    np.testing.assert_array_equal(cell_array(data(names["picture"]), "Distance"), table.ravel())


def moving_source(names):
    """At each time in the unrolled plane, from where the point has come to."""
    sheet = Bent(names["sheet"])
    places = []
    for time in (0, 0.3, 1):
        names["scene"].AnimationTime = time
        source = points(data(names["field"], 1))
        places.append(source[0, 0])
        away = sheet.unrolled(points(data(names["field"]))) - sheet.unrolled(source)
        assert_close(distances(names["field"]), np.linalg.norm(away, axis=1), 3 * FLOAT)
    names["scene"].AnimationTime = 0
    assert places[0] < -1 and places[0] < places[1] < places[2] and places[2] > 1


def assembly(names):
    """Up the walls, and up the roof or over its edge from a gable."""
    output = data(names["field"])
    blocks = [output.GetBlock(i) for i in range(output.GetNumberOfBlocks())]
    assert len(blocks) == 6
    slope = np.hypot(1, 0.8)
    sine, cosine = 0.8 / slope, 1 / slope
    for number, block in enumerate(blocks):
        x, y, z = points(block).T
        expected = z
        if number in (2, 3):
            along = (1 - np.abs(y)) * slope
            over_gables = [along * sine + from_gable * cosine for from_gable in (x, 3 - x)]
            expected = 1 + np.min([along, *over_gables], axis=0)
        assert_close(point_array(block, "GeodesicDistance"), expected, 3 * FLOAT)


def several_ranks(names):
    """In the unrolled sheet, from the curve as it lies there, whose points are joined straight; the quarters of the
    picture are the pieces of four ranks."""
    pieces = vtkExtentTranslator()
    pieces.SetWholeExtent(*names["grid"].WholeExtent)
    pieces.SetNumberOfPieces(4)
    for rank, sides in enumerate(names["QUARTERS"]):
        pieces.SetPiece(rank)
        pieces.PieceToExtent()
        ends = np.reshape(pieces.GetExtent(), (3, 2))[:2] * np.reshape(sides, (2, 1))
        assert ends.min() == 0 and np.all(ends.max(axis=1) == (45, 30)), (rank, ends)
    sheet = Bent(names["bent"])
    ends = sheet.unrolled(segments(data(names["field"], 1)))
    expected = to_segments(sheet.unrolled(points(data(names["field"]))), ends)
    assert_close(distances(names["field"]), expected, 3 * FLOAT)
