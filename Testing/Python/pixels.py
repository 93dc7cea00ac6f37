# SPDX-License-Identifier: BSD-3-Clause
"""Reads pictures."""

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader


def read_pixels(file_name):
    """The picture's red, green and blue as an array of rows, columns and colors."""
    reader = vtkPNGReader()
    reader.SetFileName(str(file_name))
    reader.Update()
    picture = reader.GetOutput()
    columns, rows, _ = picture.GetDimensions()
    colors = vtk_to_numpy(picture.GetPointData().GetScalars())
    return colors.reshape(rows, columns, -1)[:, :, :3].astype(int)
