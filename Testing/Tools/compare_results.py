# SPDX-License-Identifier: BSD-3-Clause
"""Compares what two builds compute, bit by bit: fields, arrays, refined meshes, contours, paths and
matrices, on random surfaces and on given ones, with 1, 2 and 4 ranks and 1 and 2 threads.

    python3 Testing/Tools/compare_results.py BUILD OTHER_BUILD [--seeds 0 10] [mesh.obj mesh.ply ...]

Needs ParaView's pvbatch and mpirun, and in both builds the target vtkFiltersGeodesicPython.
"""

import argparse
import glob
import json
import os
import subprocess
import sys
import tempfile
import traceback

PIECES = "pieces"


def random_surface(seed):
    """A bumpy sheet of random triangles: ordinary ones, flat ones with a hole, or thin ones."""
    import numpy as np
    random = np.random.default_rng(seed)
    columns, rows = random.integers(6, 22, 2)
    x, y = np.meshgrid(np.arange(columns + 1.0), np.arange(rows + 1.0))
    moved = 0.3 * random.uniform(-1, 1, (2, rows + 1, columns + 1))
    height = (0.0 if seed % 3 == 1 else 1.0) * random.uniform(0, 1, x.shape)
    width = 20.0 if seed % 3 == 2 else 1.0
    places = np.stack([width * (x + moved[0]), y + moved[1], height], axis=-1).reshape(-1, 3)
    corner = (np.arange(rows)[:, None] * (columns + 1) + np.arange(columns)).ravel()
    if seed % 3 == 1:
        corner = np.delete(corner, len(corner) // 2 + columns // 2)
    a, b, c, d = corner, corner + 1, corner + columns + 2, corner + columns + 1
    turned = random.integers(0, 2, len(corner)).astype(bool)
    first = np.where(turned[:, None], np.stack([a, b, d], 1), np.stack([a, b, c], 1))
    second = np.where(turned[:, None], np.stack([b, c, d], 1), np.stack([a, c, d], 1))
    return places, np.concatenate([first, second])


def given_surface(path):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOGeometry import vtkOBJReader
    from vtkmodules.vtkIOPLY import vtkPLYReader
    reader = vtkPLYReader() if path.endswith(".ply") else vtkOBJReader()
    reader.SetFileName(path)
    reader.Update()
    triangles = reader.GetOutput().GetPolys().GetConnectivityArray()
    return (vtk_to_numpy(reader.GetOutput().GetPoints().GetData()).astype(float),
            vtk_to_numpy(triangles).reshape(-1, 3))


def poly_data(places, cells, lines=False):
    import numpy as np
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    points, array, result = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(places), deep=1))
    cells = np.asarray(cells, dtype=np.int64)
    rows = np.insert(cells, 0, cells.shape[1], axis=1)
    array.ImportLegacyFormat(numpy_to_vtkIdTypeArray(rows.ravel(), deep=1))
    result.SetPoints(points)
    result.SetLines(array) if lines else result.SetPolys(array)
    return result


def piece_of(places, triangles, rank, ranks):
    """A rank's slab of a surface."""
    import numpy as np
    along = places[triangles].mean(axis=1)[:, 0]
    own = triangles[np.array_split(np.argsort(along, kind="stable"), ranks)[rank]]
    used, corners = np.unique(own, return_inverse=True)
    return poly_data(places[used], corners.reshape(-1, 3))


def bits(dataset):
    """A hash of everything in a data set."""
    import hashlib
    from vtkmodules.util.numpy_support import vtk_to_numpy
    if dataset is None:
        return None
    if dataset.IsA("vtkCompositeDataSet"):
        at, found = dataset.NewIterator(), []
        at.InitTraversal()
        while not at.IsDoneWithTraversal():
            found.append(bits(at.GetCurrentDataObject()))
            at.GoToNextItem()
        return found
    arrays = []
    if dataset.IsA("vtkPolyData"):
        arrays += [dataset.GetPoints().GetData()] if dataset.GetPoints() else []
        for cells in (dataset.GetVerts(), dataset.GetLines(), dataset.GetPolys()):
            arrays += [cells.GetOffsetsArray(), cells.GetConnectivityArray()]
    for kind in range(8):
        attributes = dataset.GetAttributesAsFieldData(kind)
        for i in range(attributes.GetNumberOfArrays() if attributes else 0):
            arrays.append(attributes.GetAbstractArray(i))
    hashed = {}
    for i, array in enumerate(arrays):
        values = vtk_to_numpy(array) if array.IsA("vtkDataArray") else array
        content = values.tobytes() if array.IsA("vtkDataArray") else str(
            [array.GetVariantValue(k).ToString() for k in range(array.GetNumberOfValues())]).encode()
        hashed[f"{i} {array.GetName()}"] = hashlib.sha256(content).hexdigest()
    return hashed


def results(surface, places, seed):
    """Calls of all filters, by name."""
    import numpy as np
    import geodesicdistance as module
    random = np.random.default_rng(seed + 1000)
    size = np.linalg.norm(places.max(axis=0) - places.min(axis=0))
    chosen = places[random.integers(0, len(places), 12)]
    far = poly_data(chosen[:3], [[0, 1, 2]], lines=True)
    points = poly_data(chosen[3:6], np.zeros((0, 2)), lines=True)
    targets = poly_data(places[random.integers(0, len(places), 40)] + 1e-3 * size *
                        random.uniform(-1, 1, (40, 3)), np.zeros((0, 2)), lines=True)
    arrays = {"GenerateSourceIds": 1, "GenerateClosestPoints": 1, "GenerateGradients": 1}
    field, contour = module.vtkGeodesicDistanceField, module.vtkGeodesicContour
    paths, matrix = module.vtkGeodesicPaths, module.vtkGeodesicDistanceMatrix
    levels = lambda f: f.GenerateValues(5, 0.02 * size, 0.5 * size)
    both = lambda f: f.GenerateValues(6, -0.3 * size, 0.3 * size)
    to_targets = lambda f: f.SetTargetsData(targets)
    cases = {
        "field": (field, far, dict(arrays, RefineMesh=0, GenerateSignedDistance=1), None),
        "limited": (field, points, dict(arrays, RefineMesh=0, MaximumDistance=0.2 * size), None),
        "approximate": (field, points, {"RefineMesh": 0, "Accuracy": 1}, None),
        "refined": (field, far, dict(arrays, RefineMesh=1), None),
        "boundary": (field, None, {"SourceType": 1, "RefineMesh": 1}, None),
        "contours": (contour, points, {}, levels),
        "signed contours": (contour, far, {"SignedDistances": 1}, both),
        "paths": (paths, far, {}, to_targets),
        "paths to points": (paths, points, {}, to_targets),
        "matrix": (matrix, points, {}, to_targets),
    }
    for name, (kind, source, properties, setup) in cases.items():
        algorithm = kind()
        algorithm.SetInputData(surface)
        if source is not None:
            algorithm.SetSourceData(source)
        for key, value in properties.items():
            getattr(algorithm, "Set" + key)(value)
        if setup:
            setup(algorithm)
        algorithm.Update()
        yield name, [bits(algorithm.GetOutputDataObject(port))
                     for port in range(algorithm.GetNumberOfOutputPorts())]


def write(file, seeds, meshes):
    from vtkmodules.vtkCommonCore import vtkObject
    from vtkmodules.vtkParallelCore import vtkMultiProcessController
    vtkObject.GlobalWarningDisplayOff()
    controller = vtkMultiProcessController.GetGlobalController()
    rank = controller.GetLocalProcessId() if controller else 0
    ranks = controller.GetNumberOfProcesses() if controller else 1
    found = {}
    surfaces = [(f"seed {seed}", random_surface(seed), seed) for seed in seeds]
    surfaces += [(os.path.basename(path), given_surface(path), 0) for path in meshes]
    for name, (places, triangles), seed in surfaces:
        surface = piece_of(places, triangles, rank, ranks)
        for what, result in results(surface, places, seed):
            found[f"{name}, {what}"] = result
    with open(f"{file}.{rank}", "w", encoding="utf-8") as out:
        json.dump(found, out)


def run(build, ranks, threads, arguments):
    """What a build computes, for each rank."""
    module = glob.glob(os.path.join(build, "lib", "python*", "dist-packages"))[0]
    environment = dict(os.environ, PYTHONPATH=module, VTK_SMP_BACKEND_IN_USE="STDThread",
                       VTK_SMP_MAX_THREADS=str(threads), OMPI_MCA_rmaps_base_oversubscribe="1")
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, PIECES)
        subprocess.run(["mpirun", "--allow-run-as-root", "--oversubscribe", "-np", str(ranks),
                        "pvbatch", "--sym", os.path.abspath(__file__), "--write", file, *arguments],
                       env=environment, check=True)
        found = []
        for rank in range(ranks):
            with open(f"{file}.{rank}", encoding="utf-8") as text:
                found.append(json.load(text))
        return found


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--write")
    parser.add_argument("--seeds", nargs=2, type=int, default=(0, 10), metavar=("FIRST", "END"))
    parser.add_argument("--ranks", nargs="+", type=int, default=(1, 2, 4))
    parser.add_argument("names", nargs="*", metavar="BUILD OTHER_BUILD [MESH ...]")
    options = parser.parse_args()
    if options.write:
        try:
            write(options.write, range(*options.seeds), options.names)
        except BaseException:  # pylint: disable=broad-except
            traceback.print_exc()
            sys.stderr.flush()
            os._exit(1)  # mpirun then ends the others, which may wait for this one
        return 0
    first, second, *meshes = options.names
    arguments = [*map(os.path.abspath, meshes), "--seeds", *map(str, options.seeds)]
    different = 0
    for ranks in options.ranks:
        expected = run(first, ranks, 1, arguments)
        for build, threads in ((second, 1), (second, 2)):
            found = run(build, ranks, threads, arguments)
            count = 0
            for rank, (a, b) in enumerate(zip(expected, found)):
                for name in sorted(a.keys() | b.keys()):
                    if a.get(name) != b.get(name):
                        count += 1
                        print(f"{ranks} ranks, {threads} threads, rank {rank}: {name} differs")
            print(f"{ranks} ranks, {threads} threads: {count} of "
                  f"{sum(map(len, expected))} results differ", flush=True)
            different += count
    return 1 if different else 0


if __name__ == "__main__":
    status = main()
    if status:  # pvbatch must come to its own end
        sys.exit(status)
