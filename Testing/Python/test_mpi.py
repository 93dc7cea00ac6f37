# SPDX-License-Identifier: BSD-3-Clause
"""Run by one or several ranks of pvbatch: a surface of which each rank has a piece has the distance
field of the whole in one process."""

import os
import sys
import traceback

import numpy as np
from paraview import simple
from geodesic_testing import data, load_plugin, messages, points
from geodesicdistance import vtkGeodesicContour, vtkGeodesicDistanceField, vtkGeodesicPaths
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJReader
from vtkmodules.vtkParallelCore import vtkMultiProcessController

GeodesicDistanceField = load_plugin()
controller = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
FOLDER = sys.argv[1]
failures = []

# One process has it to the last bits; so should several.
EXACT = 1e-12
# Coordinates that pieces have computed by themselves, in 32 bits.
ROUNDED = 2e-6


def check(holds, what):
    if not holds:
        failures.append(what)
        print(f"FAILED on rank {RANK}: {what}", flush=True)


def whole_field(surface, source=None, **properties):
    """Distances of a vtkPolyData in this process alone, as (points, distances)."""
    alone = vtkGeodesicDistanceField()
    alone.SetController(None)
    alone.SetInputData(surface)
    alone.RefineMeshOff()
    if source is None:
        alone.SetSourceTypeToSurfaceBoundary()
    else:
        alone.SetSourceData(source)
    for name, value in properties.items():
        getattr(alone, "Set" + name)(value)
    alone.Update()
    output = alone.GetOutput()
    return (vtk_to_numpy(output.GetPoints().GetData()).astype(float),
            vtk_to_numpy(output.GetPointData().GetArray("GeodesicDistance")))


def polys(dataset):
    return dataset.GetNumberOfPolys() if dataset else 0


def total(number):
    """The sum over all ranks."""
    from vtkmodules.vtkCommonCore import vtkDoubleArray
    mine, summed = vtkDoubleArray(), vtkDoubleArray()
    mine.InsertNextValue(number)
    summed.SetNumberOfValues(1)
    controller.AllReduce(mine, summed, 2)  # vtkCommunicator.SUM_OP
    return summed.GetValue(0)


def leaves(dataset):
    """The vtkPolyData of which a data set is made."""
    if not dataset.IsA("vtkCompositeDataSet"):
        return [dataset]
    found, at = [], dataset.NewIterator()
    at.InitTraversal()
    while not at.IsDoneWithTraversal():
        found.append(at.GetCurrentDataObject())
        at.GoToNextItem()
    return found


def compare(output, whole, tolerance, what):
    """The distances of a rank's output against those of the whole at the same places."""
    for piece in leaves(output):
        values = piece.GetPointData().GetArray("GeodesicDistance")
        check(values is not None, f"{what}: there is a distance")
        if values is None or piece.GetNumberOfPoints() == 0:
            continue
        places, expected = whole
        if tolerance == EXACT:
            at = {tuple(p): d for p, d in zip(places, expected)}
            there = np.array([at[tuple(p)] for p in points(piece)])
        else:
            there = np.array([expected[np.argmin(((places - p) ** 2).sum(axis=1))]
                              for p in points(piece)])
        both = np.isfinite(there)
        ours = vtk_to_numpy(values)
        check(np.array_equal(both, np.isfinite(ours)), f"{what}: the same points are reached")
        largest = expected[np.isfinite(expected)].max()
        worst = np.abs(ours - there)[both].max(initial=0.0) / largest
        check(worst <= tolerance, f"{what}: wrong by {worst} of the largest distance")


def pieces(whole, ranks=RANKS):
    """This rank's slab of a surface of triangles, which every rank has, with the cells' arrays; the
    last ranks may have none.
    (RedistributeDataSet loses cells where libexpat is newer than VTK's XML readers can bear.)"""
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    triangles = vtk_to_numpy(whole.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    along = points(whole)[triangles].mean(axis=1)[:, 0]
    slabs = np.array_split(np.argsort(along, kind="stable"), ranks)
    slab = slabs[RANK] if RANK < ranks else slabs[0][:0]
    own = triangles[slab]
    used, corners = np.unique(own, return_inverse=True)
    places, cells, piece = vtkPoints(), vtkCellArray(), vtkPolyData()
    places.SetData(numpy_to_vtk(vtk_to_numpy(whole.GetPoints().GetData())[used], deep=1))
    rows = np.insert(corners.reshape(-1, 3), 0, 3, axis=1)
    cells.ImportLegacyFormat(numpy_to_vtkIdTypeArray(rows.ravel().astype(np.int64), deep=1))
    piece.SetPoints(places)
    piece.SetPolys(cells)
    for i in range(whole.GetCellData().GetNumberOfArrays()):
        of_whole = whole.GetCellData().GetArray(i)
        array = numpy_to_vtk(vtk_to_numpy(of_whole)[slab], deep=1)
        array.SetName(of_whole.GetName())
        piece.GetCellData().AddArray(array)
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(piece)
    return producer


def mesh(name):
    """A mesh of GEODESIC_TEST_MESHES as (proxy, vtkPolyData), or None."""
    folder = os.environ.get("GEODESIC_TEST_MESHES", "")
    path = os.path.join(folder, name)
    if not folder or not os.path.exists(path):
        if RANK == 0:
            print(f"Skipped: GEODESIC_TEST_MESHES names no folder with {name}.")
        return None
    reader = vtkOBJReader()
    reader.SetFileName(path)
    reader.Update()
    return simple.WavefrontOBJReader(FileName=path), reader.GetOutput()


def point_cloud(places):
    """Points on every rank, as a source."""
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    cloud = vtkPoints()
    cloud.SetDataTypeToDouble()
    for place in places:
        cloud.InsertNextPoint(place)
    result = vtkPolyData()
    result.SetPoints(cloud)
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(result)
    return producer, result


def distributed(name):
    """A mesh as (pieces, whole), or None where it is not there."""
    found = mesh(name)
    return (pieces(found[1]), found[1]) if found else None


def real_meshes():
    for name in ("fandisk.obj", "beetle-alt.obj"):
        found = distributed(name)
        if not found:
            continue
        spread, whole = found
        cells = polys(data(spread))
        check(RANKS == 1 or cells < whole.GetNumberOfPolys(), f"{name} is spread")
        at = [whole.GetPoint(i * whole.GetNumberOfPoints() // 7) for i in range(7)]
        producer, cloud = point_cloud(at)
        field = GeodesicDistanceField(Input=spread, Source=producer, RefineMesh=0)
        compare(data(field), whole_field(whole, cloud), EXACT, f"{name}, from points")
        field.MaximumDistance = 0.1
        compare(data(field), whole_field(whole, cloud, MaximumDistance=0.1), EXACT,
                f"{name}, from points within a limit")
    found = distributed("beetle-alt.obj")
    if found:
        field = GeodesicDistanceField(Input=found[0], SourceType="Surface Boundary", RefineMesh=0)
        compare(data(field), whole_field(found[1]), EXACT, "beetle-alt.obj, from its boundary")


def curve_across_seams():
    found = distributed("fandisk.obj")
    if not found:
        return
    spread, whole = found
    far = [whole.GetPoint(10), whole.GetPoint(3000), whole.GetPoint(6000)]
    curve = simple.PolyLineSource(Points=[x for p in far for x in p])
    on_rank_0 = data(curve)
    field = GeodesicDistanceField(Input=spread, Source=curve, RefineMesh=0)
    output = data(field)
    # The curve is on rank 0 only; all others know it, too.
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    copy = vtkPolyData()
    copy.DeepCopy(on_rank_0)
    controller.Broadcast(copy, 0)
    compare(output, whole_field(whole, copy), EXACT, "a curve whose points are far apart")
    snap = vtk_to_numpy(output.GetFieldData().GetArray("SourceSnapDistance"))[0]
    check(snap < 1e-6, f"the curve lies on the surface up to {snap}")


def generated_surfaces():
    sphere = simple.Sphere(ThetaResolution=40, PhiResolution=30)
    source = vtkSphereSource()
    source.SetThetaResolution(40)
    source.SetPhiResolution(30)
    source.Update()
    producer, cloud = point_cloud([(0.5, 0, 0), (0, 0, 0.5)])
    field = GeodesicDistanceField(Input=sphere, Source=producer, RefineMesh=0)
    compare(data(field), whole_field(source.GetOutput(), cloud), ROUNDED, "a sphere in pieces")
    joined = vtk_to_numpy(data(field).GetFieldData().GetArray("SeamPointsJoined"))[0]
    check(joined > 0 or RANKS == 1, "a sphere's seams are joined within roundings")
    # A section in pieces of a surface in pieces.
    section = simple.Slice(Input=sphere)
    section.SliceType.Origin = (0, 0, 0.123)
    section.SliceType.Normal = (0, 0, 1)
    field = GeodesicDistanceField(Input=sphere, Source=section, RefineMesh=0)
    from vtkmodules.vtkCommonDataModel import vtkPlane
    from vtkmodules.vtkFiltersCore import vtkCutter
    cutter, plane = vtkCutter(), vtkPlane()
    plane.SetOrigin(0, 0, 0.123)
    plane.SetNormal(0, 0, 1)
    cutter.SetCutFunction(plane)
    cutter.SetInputConnection(source.GetOutputPort())
    cutter.Update()
    compare(data(field), whole_field(source.GetOutput(), cutter.GetOutput()), ROUNDED,
            "from a section in pieces")


def whole_sphere():
    source = vtkSphereSource()
    source.SetThetaResolution(40)
    source.SetPhiResolution(30)
    source.Update()
    return source.GetOutput()


def alone_with(filter_class, surface, source, **properties):
    """The output of a filter in this process alone."""
    alone = filter_class()
    alone.SetController(None)
    alone.SetInputData(surface)
    alone.SetSourceData(source)
    for name, value in properties.items():
        getattr(alone, "Set" + name)(value)
    alone.Update()
    return alone.GetOutput()


def arrays_beside_the_distance():
    """What is nearest to each point, and where, is what one process finds."""
    sphere = simple.Sphere(ThetaResolution=40, PhiResolution=30)
    producer, cloud = point_cloud([(0.5, 0, 0.01), (-0.2, 0.4, 0.2), (0.1, -0.1, -0.5)])
    switches = {"GenerateSourceIds": 1, "GenerateClosestPoints": 1, "GenerateGradients": 1}
    output = data(GeodesicDistanceField(Input=sphere, Source=producer, RefineMesh=0, **switches))
    whole = alone_with(vtkGeodesicDistanceField, whole_sphere(), cloud, RefineMesh=0, **switches)
    if output.GetNumberOfPoints() == 0:
        return
    nearest = [np.argmin(((points(whole) - p) ** 2).sum(axis=1)) for p in points(output)]

    def both(name):
        return (vtk_to_numpy(output.GetPointData().GetArray(name)),
                vtk_to_numpy(whole.GetPointData().GetArray(name))[nearest])
    ids, expected = both("SourceId")
    same = ids == expected
    check(same.mean() > 0.98, f"the same source is nearest, where none ties: {same.mean()}")
    check(set(ids) <= {0, 1, 2}, f"sources are numbered over all ranks: {set(ids)}")
    for name, tolerance in (("ClosestSourcePoint", ROUNDED), ("DistanceGradient", 1e-3)):
        ours, theirs = both(name)
        far = np.linalg.norm(ours - theirs, axis=1)[same] > tolerance
        # Where two ways to a source are equally long either may be told.
        check(far.mean() < 0.02, f"{name} is that of one process but at {far.sum()} points")


def ghost_cells(surface):
    """ParaView 6 has another name for the filter than 5.11."""
    names = [name for name in ("GhostCells", "GhostCellsGenerator") if hasattr(simple, name)]
    return getattr(simple, names[0])(Input=surface)


def arrays_of_refined_ghost_cells():
    """New points of ghost cells have sources, feet and directions, too."""
    whole = whole_sphere()
    at = np.array([whole.GetPoint(i) for i in (100, 500, 900)])
    producer, _ = point_cloud(at)
    spread = pieces(whole)
    with_ghosts = ghost_cells(spread)
    with_ghosts.BuildIfRequired = 0
    field = GeodesicDistanceField(Input=with_ghosts, Source=producer, RefineMesh=1,
                                  RefinementTolerance=0.003, GenerateSourceIds=1,
                                  GenerateClosestPoints=1, GenerateGradients=1)
    with messages() as window:
        field.UpdatePipeline()
    check("ERR" not in window.GetOutput(), f"refined ghost cells: {window.GetOutput()!r}")
    ghosts = 0
    for piece in leaves(data(field)):
        flags = piece.GetCellData().GetArray("vtkGhostType")
        ghosts += np.count_nonzero(vtk_to_numpy(flags)) if flags else 0
        if piece.GetNumberOfPoints() == 0:
            continue
        distances, ids, feet, gradients = (
            vtk_to_numpy(piece.GetPointData().GetArray(name)) for name in
            ("GeodesicDistance", "SourceId", "ClosestSourcePoint", "DistanceGradient"))
        check(ids.min() >= 0, "each point has a source")
        check(np.abs(feet - at[ids]).max() < ROUNDED, "the foot is the point with that number")
        # Points of the source lie on the sphere: no way is shorter than straight.
        straight = np.linalg.norm(points(piece) - feet, axis=1)
        check((distances > straight - ROUNDED).all(), "no distance is shorter than straight")
        lengths = np.linalg.norm(gradients, axis=1)[distances > ROUNDED]
        check(np.abs(lengths - 1).max() < 1e-9, "gradients have length 1")
    before = sum(np.count_nonzero(vtk_to_numpy(piece.GetCellData().GetArray("vtkGhostType")))
                 for piece in leaves(data(with_ghosts)) if polys(piece))
    check(RANKS == 1 or total(ghosts) > total(before), "ghost cells are refined")


def barriers_over_seams():
    """Paths go around a wall through all pieces, which is cut where its rim is refined."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    whole = whole_sphere()
    triangles = vtk_to_numpy(whole.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    centres = points(whole)[triangles].mean(axis=1)
    wall = numpy_to_vtk((np.abs(centres[:, 2] - 0.1) < 0.05).astype(np.int8)
                        * (centres[:, 1] < 0.3), deep=1)
    wall.SetName("wall")
    whole.GetCellData().AddArray(wall)
    source, cloud = point_cloud([whole.GetPoint(900)])
    alone = whole_field(whole, cloud, BarrierArrayName="wall")
    open_field = whole_field(whole, cloud)
    check(not np.array_equal(alone[1], open_field[1]), "the wall is in the way")
    spread = pieces(whole)
    field = GeodesicDistanceField(Input=spread, Source=source, RefineMesh=0,
                                  BarrierArrayName="wall")
    compare(data(field), alone, EXACT, "a wall over the seams")
    refined = GeodesicDistanceField(Input=spread, Source=source, BarrierArrayName="wall",
                                    GenerateSourceIds=1)
    with messages() as window:
        refined.UpdatePipeline()
    check("ERR" not in window.GetOutput(), f"a refined wall: {window.GetOutput()!r}")
    check(total(polys(data(refined))) > whole.GetNumberOfPolys(), "the surface is refined")


def lines_over_seams():
    """Lines of all ranks together are those of one process; they meet at seams."""
    sphere = simple.Sphere(ThetaResolution=40, PhiResolution=30)
    producer, cloud = point_cloud([(0.5, 0, 0.01), (-0.2, 0.4, 0.2)])
    values = [0.1, 0.4, 0.7]
    ours = data(simple.GeodesicContour(Input=sphere, Source=producer, Distances=values))
    alone = vtkGeodesicContour()
    alone.SetController(None)
    alone.SetInputData(whole_sphere())
    alone.SetSourceData(cloud)
    for i, value in enumerate(values):
        alone.SetValue(i, value)
    alone.Update()

    def lengths(lines):
        found = dict.fromkeys(values, 0.0)
        for i in range(lines.GetNumberOfCells()):
            p = vtk_to_numpy(lines.GetCell(i).GetPoints().GetData())
            value = lines.GetCellData().GetArray("GeodesicDistance").GetValue(i)
            found[value] += np.linalg.norm(np.diff(p, axis=0), axis=1).sum()
        return found
    whole = lengths(alone.GetOutput())
    for value, length in lengths(ours).items():
        summed = total(length)
        check(abs(summed - whole[value]) < 1e-5 * whole[value],
              f"lines at {value} measure {summed}, not {whole[value]}")


def paths_over_seams():
    """Every target has its path, of the length that one process finds, on the rank it was on."""
    sphere = simple.Sphere(ThetaResolution=40, PhiResolution=30)
    producer, cloud = point_cloud([(0.5, 0, 0.01)])
    targets, places = point_cloud([(-0.5, 0, 0), (0, 0.5, 0), (0.1, -0.3, 0.4), (0, 0, -0.5)])
    ours = data(simple.GeodesicPaths(Input=sphere, Source=producer, Targets=targets))
    alone = vtkGeodesicPaths()
    alone.SetController(None)
    alone.SetInputData(whole_sphere())
    alone.SetSourceData(cloud)
    alone.SetTargetsData(places)
    alone.Update()
    whole = vtk_to_numpy(alone.GetOutput().GetCellData().GetArray("GeodesicDistance"))
    check(total(ours.GetNumberOfCells()) == 4, "there is a path for each target")
    check(RANK == 0 or ours.GetNumberOfCells() == 0, "targets that all have are of the first rank")
    for i in range(ours.GetNumberOfCells()):
        target = int(ours.GetCellData().GetArray("TargetId").GetValue(i))
        length = ours.GetCellData().GetArray("GeodesicDistance").GetValue(i)
        check(abs(length - whole[target]) < 1e-5, f"path {target} measures {length}")
        p = vtk_to_numpy(ours.GetCell(i).GetPoints().GetData())
        measured = np.linalg.norm(np.diff(p, axis=0), axis=1).sum()
        check(abs(measured - length) < 1e-12, f"path {target} is as long as it says")


def surfaces_that_are_grids():
    """Filters that make unstructured grids of pieces, some of which may be empty."""
    from vtkmodules.vtkCommonDataModel import vtkPlane
    from vtkmodules.vtkFiltersGeneral import vtkTableBasedClipDataSet
    whole = whole_sphere()
    source, cloud = point_cloud([(0.3, 0.4, 0), (0.4, -0.1, 0.2)])
    spread = pieces(whole)

    def field_of(grid, what):
        is_grid = data(grid).IsA("vtkUnstructuredGrid") or what == "RedistributeDataSet"  # not in each version
        check(is_grid, f"{what} gives a grid")
        field = GeodesicDistanceField(Input=grid, Source=source, RefineMesh=0)
        output = data(field)
        check(output.IsA("vtkPolyData"), f"{what}: the output is a vtkPolyData")
        return output

    plane = vtkPlane()
    plane.SetOrigin(0.1, 0.013, 0)
    plane.SetNormal(1, 0.3, 0.2)
    alone = vtkTableBasedClipDataSet()
    alone.SetInputData(whole)
    alone.SetClipFunction(plane)
    alone.Update()
    clip = simple.Clip(Input=spread, ClipType="Plane", Invert=0)
    clip.ClipType.Origin, clip.ClipType.Normal = plane.GetOrigin(), plane.GetNormal()
    clipped = whole_field(alone.GetOutput(), cloud)
    check(len(clipped[0]) < whole.GetNumberOfPoints(), "the sphere is clipped")
    compare(field_of(clip, "Clip"), clipped, ROUNDED, "Clip")

    expected = whole_field(whole, cloud)
    everything = simple.Threshold(Input=simple.Elevation(Input=spread), Scalars=["POINTS", "Elevation"],
                                  LowerThreshold=-1e9, UpperThreshold=1e9)
    compare(field_of(everything, "Threshold"), expected, EXACT, "Threshold")
    appended = simple.AppendDatasets(Input=[spread, simple.Sphere(Center=(5, 0, 0))])
    output = field_of(appended, "AppendDatasets")
    near = points(output)[:, 0] < 2
    values = vtk_to_numpy(output.GetPointData().GetArray("GeodesicDistance"))
    at = {tuple(p): d for p, d in zip(*expected)}
    there = np.array([at[tuple(p)] for p in points(output)[near]])
    check(np.abs(values[near] - there).max(initial=0) < EXACT and np.isinf(values[~near]).all(),
          "AppendDatasets: one of two spheres has the field")
    redistributed = simple.RedistributeDataSet(Input=spread)
    cells = data(redistributed).GetNumberOfCells()
    if total(cells) < whole.GetNumberOfPolys():
        print("Skipped: this machine's RedistributeDataSet loses cells (see pieces()).")
        return
    check(RANKS == 1 or cells < whole.GetNumberOfPolys(), "the sphere is redistributed")
    compare(field_of(redistributed, "RedistributeDataSet"), expected, EXACT, "RedistributeDataSet")
    with_ghosts = ghost_cells(redistributed)
    with_ghosts.BuildIfRequired = 0
    more = data(with_ghosts).GetNumberOfCells() - cells
    check(RANKS == 1 or total(more) > 0, "RedistributeDataSet: there are ghost cells")
    compare(field_of(with_ghosts, "RedistributeDataSet"), expected, EXACT,
            "RedistributeDataSet with ghost cells")


def ghosts_and_empty_ranks():
    found = mesh("spot.obj")
    if not found:
        return
    proxy, whole = found
    producer, cloud = point_cloud([whole.GetPoint(i) for i in (5, 700, 1500, 2900)])
    truth = whole_field(whole, cloud)
    if RANKS > 1:
        few = pieces(whole, RANKS - 1)
        field = GeodesicDistanceField(Input=few, Source=producer, RefineMesh=0)
        compare(data(field), truth, EXACT, "spot on all ranks but one")
    # VTK 9.3 finds no neighbors where coordinates are no 32-bit numbers, and reads this mesh in 64 bits.
    single = vtkPolyData()
    single.DeepCopy(whole)
    single.GetPoints().SetData(numpy_to_vtk(points(whole).astype(np.float32), deep=1))
    spread = pieces(single)
    with_ghosts = ghost_cells(spread)
    with_ghosts.BuildIfRequired = 0
    output = data(GeodesicDistanceField(Input=with_ghosts, Source=producer, RefineMesh=0))
    more = sum(polys(piece) for piece in leaves(output)) - polys(data(spread))
    check(RANKS == 1 or total(more) > 0, "there are ghost cells")
    compare(output, whole_field(single, cloud), EXACT, "spot with ghost cells")
    # Not spread at all: a reader that knows no pieces has all on rank 0.
    field = GeodesicDistanceField(Input=proxy, Source=producer, RefineMesh=1)
    ours = data(field)
    check(polys(ours) >= whole.GetNumberOfPolys() if RANK == 0 else polys(ours) == 0,
          "data on rank 0 only stays there, and is refined")


def written_and_read():
    sphere = simple.Sphere(ThetaResolution=24, PhiResolution=16)
    producer, _ = point_cloud([(0.5, 0, 0)])
    field = GeodesicDistanceField(Input=sphere, Source=producer, RefineMesh=0)
    before = data(field)
    path = os.path.join(FOLDER, f"field{RANKS}.pvtp")
    # Some builds cannot read appended data, and none infinite numbers as text.
    simple.SaveData(path, proxy=field, DataMode="Binary")
    controller.Barrier()
    read = simple.XMLPartitionedPolydataReader(FileName=[path])
    after = data(read)
    check(total(polys(after)) == total(polys(before)), "each cell is written once")
    values = after.GetPointData().GetArray("GeodesicDistance")
    check(values is not None and values.GetRange()[1] < 1.6, "distances are read again")
    again = GeodesicDistanceField(Input=read, Source=producer, RefineMesh=0)
    again.DistanceArrayName = "Again"
    with messages():
        there = data(again)
    ours = vtk_to_numpy(there.GetPointData().GetArray("Again"))
    check(np.allclose(ours, vtk_to_numpy(there.GetPointData().GetArray("GeodesicDistance")),
                      rtol=0, atol=ROUNDED), "a surface that was read in pieces is one")


def errors():
    sphere = simple.Sphere(ThetaResolution=12, PhiResolution=8)
    spoilt = simple.ProgrammableFilter(Input=sphere)
    spoilt.OutputDataSetType = "vtkPolyData"
    spoilt.Script = """
from vtkmodules.vtkParallelCore import vtkMultiProcessController
ranks = vtkMultiProcessController.GetGlobalController()
output.VTKObject.DeepCopy(self.GetInputDataObject(0, 0))
if ranks.GetLocalProcessId() == ranks.GetNumberOfProcesses() - 1:
    output.VTKObject.GetPoints().SetPoint(3, float("nan"), 0, 0)
"""
    producer, _ = point_cloud([(0.5, 0, 0)])
    field = GeodesicDistanceField(Input=spoilt, Source=producer, RefineMesh=0)
    with messages() as window:
        field.UpdatePipeline()
    said = window.GetOutput()
    check("NaN" in said and "at point 3" in said, f"all ranks say what one has: {said!r}")
    output = field.GetClientSideObject().GetOutputDataObject(0)
    check(output.GetNumberOfPoints() == 0, "and none has a field")


def alone():
    """A filter that is told to work alone does so on whichever rank executes it."""
    if RANK == RANKS - 1:
        sphere = vtkSphereSource()
        sphere.SetEndTheta(180)
        field = vtkGeodesicDistanceField()
        field.SetInputConnection(sphere.GetOutputPort())
        field.SetSourceTypeToSurfaceBoundary()
        field.SetController(None)
        field.Update()
        check(field.GetOutput().GetPointData().GetArray("GeodesicDistance") is not None,
              "alone on one rank it gives a distance")


try:
    for case in (real_meshes, curve_across_seams, generated_surfaces, arrays_beside_the_distance,
                 arrays_of_refined_ghost_cells, barriers_over_seams, lines_over_seams,
                 paths_over_seams, surfaces_that_are_grids,
                 ghosts_and_empty_ranks, written_and_read, errors, alone):
        case()
        controller.Barrier()
        if RANK == 0:
            print(f"{case.__name__} done", flush=True)
except BaseException:  # pylint: disable=broad-except
    traceback.print_exc()
    sys.stderr.flush()
    os._exit(1)  # mpirun then ends the others, which may wait for this one
if total(len(failures)):
    sys.stdout.flush()
    os._exit(1)
