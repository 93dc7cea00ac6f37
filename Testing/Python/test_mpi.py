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


def ghost_cells(surface):
    """ParaView 6 has another name for the filter than 5.11."""
    names = [name for name in ("GhostCells", "GhostCellsGenerator") if hasattr(simple, name)]
    return getattr(simple, names[0])(Input=surface)


def all_filters_over_seams():
    """The proxies of each filter, with a wall on the surface and ghost cells around the pieces."""
    whole = whole_sphere()
    triangles = vtk_to_numpy(whole.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    centres = points(whole)[triangles].mean(axis=1)
    wall = numpy_to_vtk((np.abs(centres[:, 2] - 0.1) < 0.05).astype(np.int8)
                        * (centres[:, 1] < 0.3), deep=1)
    wall.SetName("wall")
    whole.GetCellData().AddArray(wall)
    source, cloud = point_cloud([whole.GetPoint(900)])
    targets, places = point_cloud([whole.GetPoint(i) for i in (100, 400, 700)])
    expected = whole_field(whole, cloud, BarrierArrayName="wall")
    check(not np.array_equal(expected[1], whole_field(whole, cloud)[1]), "the wall is in the way")
    with_ghosts = ghost_cells(pieces(whole))
    with_ghosts.BuildIfRequired = 0
    with messages() as window:
        field = GeodesicDistanceField(Input=with_ghosts, Source=source, RefineMesh=0,
                                      BarrierArrayName="wall")
        compare(data(field), expected, EXACT, "a wall over the seams")
        refined = GeodesicDistanceField(
            Input=with_ghosts, Source=source, BarrierArrayName="wall", GenerateSourceIds=1,
            GenerateClosestPoints=1, GenerateGradients=1)
        check(total(sum(polys(piece) for piece in leaves(data(refined))))
              > total(sum(polys(piece) for piece in leaves(data(with_ghosts)))), "it is refined")
    check("ERR" not in window.GetOutput(), f"a wall over the seams: {window.GetOutput()!r}")

    def length(lines):
        return sum(np.linalg.norm(np.diff(vtk_to_numpy(line.GetCell(i).GetPoints().GetData()),
                                          axis=0), axis=1).sum()
                   for line in lines for i in range(line.GetNumberOfCells()))
    for proxy, filter_class, ask in (
            (simple.GeodesicContour(Input=with_ghosts, Source=source, Distances=[0.1, 0.4, 0.7]),
             vtkGeodesicContour, lambda f: [f.SetValue(i, 0.1 + 0.3 * i) for i in range(3)]),
            (simple.GeodesicPaths(Input=with_ghosts, Source=source, Targets=targets),
             vtkGeodesicPaths, lambda f: f.SetTargetsData(places))):
        proxy.BarrierArrayName = "wall"
        alone = filter_class()
        alone.SetController(None)
        alone.SetInputData(whole)
        alone.SetSourceData(cloud)
        alone.SetBarrierArrayName("wall")
        ask(alone)
        alone.Update()
        ours, theirs = total(length(leaves(data(proxy)))), length([alone.GetOutput()])
        check(abs(ours - theirs) < 1e-5 * theirs, f"lines measure {ours}, not {theirs}")


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


try:
    for case in (real_meshes, curve_across_seams, generated_surfaces, all_filters_over_seams,
                 surfaces_that_are_grids, ghosts_and_empty_ranks, written_and_read):
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
