# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of a real head and its brain, in millimeters: right is +x, ahead is +y, up is +z.

Colin Holmes was scanned 27 times in the magnetic resonance tomograph of the Montreal Neurological
Institute; the volume is the average (C. J. Holmes et al., Enhancement of MR Images Using Registration for
Signal Averaging, 1998). It comes with MRIcron, in Debian's package mricron-data, under the BSD license.
"""

import pathlib
import sys

from paraview.simple import ProgrammableSource

FOLDER = pathlib.Path("/usr/share/mricron/templates")
MISSING = f"there are no scans in {FOLDER} (Debian: mricron-data)."

# In blocks of voxels, smoothed, the surface where the brightness has a value; its largest part. It is closed
# where the head leaves the volume, at the neck.
SCRIPT = """from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkFlyingEdges3D, vtkPolyDataConnectivityFilter
from vtkmodules.vtkImagingCore import vtkImageConstantPad, vtkImageShrink3D
from vtkmodules.vtkImagingGeneral import vtkImageGaussianSmooth
from vtkmodules.vtkIOImage import vtkNIFTIImageReader

reader = vtkNIFTIImageReader()
reader.SetFileName("{file_name}")
reader.Update()
columns, rows, layers = reader.GetDataExtent()[1::2]
closed = vtkImageConstantPad()
closed.SetOutputWholeExtent(-9, columns + 9, -9, rows + 9, -9, layers + 9)
coarse = vtkImageShrink3D()
coarse.SetShrinkFactors({block}, {block}, {block})
smooth = vtkImageGaussianSmooth()
smooth.SetStandardDeviation(0.75)
surface = vtkFlyingEdges3D()
surface.SetValue(0, {brightness})
surface.ComputeScalarsOff()
largest = vtkPolyDataConnectivityFilter()
largest.SetExtractionModeToLargestRegion()
without_rest = vtkCleanPolyData()
without_rest.PointMergingOff()
previous = reader
for step in closed, coarse, smooth, surface, largest, without_rest:
    step.SetInputConnection(previous.GetOutputPort())
    previous = step
without_rest.Update()
self.GetPolyDataOutput().ShallowCopy(without_rest.GetOutput())
"""


def surface(name, brightness, block):
    """The surface in a volume where it is as bright as that, in blocks of so many voxels."""
    if not FOLDER.exists():
        sys.exit(f"The gallery cannot make this surface: {MISSING}")
    script = SCRIPT.format(file_name=FOLDER / f"{name}.nii.gz", brightness=brightness, block=block)
    return ProgrammableSource(OutputDataSetType="vtkPolyData", Script=script)


def brain():
    return surface("ch2better", 45.5, block=2)


def head():
    return surface("ch2", 25.5, block=3)
