# SPDX-License-Identifier: BSD-3-Clause
"""The example's application and script agree, and the picture shows stripes.

usage: pvpython test_example.py APPLICATION EXAMPLES
"""

import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

application, examples = sys.argv[1:]
sys.path.insert(0, examples)
import geodesic_distance  # noqa: E402
from pixels import read_pixels  # noqa: E402


def distances(file_name):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(file_name))
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetArray("GeodesicDistance"))


with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    subprocess.run([application], cwd=folder, check=True)
    output = folder / "field"
    geodesic_distance.main(str(folder / "surface.vtp"), str(folder / "curve.vtp"), str(output))

    np.testing.assert_array_equal(
        distances(folder / "distance.vtp"), distances(output.with_suffix(".vtp")))

    colors = read_pixels(output.with_suffix(".png"))
    red, blue = colors[:, :, 0], colors[:, :, 2]
    drawn = np.any(colors != 255, axis=2)
    assert drawn.mean() > 0.2, f"only {drawn.mean():.0%} of the picture are drawn"
    # From yellow at the curve to blue far from it.
    for name, share in (("near", (red > blue + 60)[drawn].mean()), ("far", (blue > red)[drawn].mean())):
        assert share > 0.05, f"{share:.1%} of the surface have the colors {name} the curve"
    # Stripes: down each column the red goes up and down again and again.
    steps = np.abs(np.diff(red, axis=0)) > 30
    edges = steps.sum(axis=0)[drawn.any(axis=0)]
    assert np.median(edges) > 20, f"{np.median(edges)} edges of stripes in a column"
