# SPDX-License-Identifier: BSD-3-Clause
"""What is in a wheel: the package and nothing else, which needs nothing of the folder that it was built in.

usage: python3 check_wheel.py WHEEL
"""

import fnmatch
import importlib.metadata
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

wheel = pathlib.Path(sys.argv[1])
source = pathlib.Path(__file__).resolve().parents[2]
version = re.search(r"VERSION\s+([\d.]+)", (source / "CMakeLists.txt").read_text().split("project(")[1]).group(1)
assert wheel.name.startswith(f"geodesicdistance-{version}-"), wheel.name

with zipfile.ZipFile(wheel) as archive:
    files = archive.namelist()
    expected = [f"geodesicdistance/{name}.py"
                for name in ("__init__", "arrays", "functions", "inputs", "messages", "surface")]
    expected += ["geodesicdistance/vtkFiltersGeodesic*.so"]
    expected += [f"geodesicdistance-{version}.dist-info/{name}"
                 for name in ("METADATA", "RECORD", "WHEEL", "licenses/LICENSE")]
    for pattern in expected:
        assert len(fnmatch.filter(files, pattern)) == 1, (pattern, files)
    assert len(files) == len(expected), files

    metadata = archive.read(f"geodesicdistance-{version}.dist-info/METADATA").decode()
    needs = re.findall(r"^Requires-Dist: (.*)$", metadata, re.MULTILINE)
    known = [f"vtk=={vtk.version}" for vtk in importlib.metadata.distributions(name="vtk")]  # to pip
    assert needs == ["numpy", *known[:1]], needs
    assert "Exact geodesic distance" in metadata and "BSD-3-Clause" in metadata and "With PyVista" in metadata

    (module,) = fnmatch.filter(files, "*.so")
    with tempfile.TemporaryDirectory() as folder:
        dynamic = subprocess.check_output(["readelf", "-d", archive.extract(module, folder)], text=True)
(path,) = re.findall(r"R(?:UN)?PATH.*\[(.*)\]", dynamic)
assert path == "$ORIGIN/../vtkmodules", path
assert "libvtkFiltersGeodesic" not in "".join(re.findall(r"NEEDED.*", dynamic)), dynamic

print(f"{wheel.name}: {wheel.stat().st_size} bytes, needs {', '.join(needs)}")
