# SPDX-License-Identifier: BSD-3-Clause
"""Pictures as arrays of rows from the top, columns and colors, and as PNG files of few colors."""

import struct
import zlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkImagingColor import vtkImageQuantizeRGBToIndex
from vtkmodules.vtkIOImage import vtkPNGReader


def read(file_name):
    reader = vtkPNGReader()
    reader.SetFileName(str(file_name))
    reader.Update()
    columns, rows, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(rows, columns, -1)[::-1, :, :3]


def write(pixels, file_name, colors=240):
    """Writes a picture with a palette of so many colors."""
    indices, palette = few_colors(pixels, colors)
    rows, columns = indices.shape
    lines = np.insert(indices, 0, 0, axis=1)  # each line begins with its filter, which is none
    with open(file_name, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        file.write(chunk(b"IHDR", struct.pack(">IIBBBBB", columns, rows, 8, 3, 0, 0, 0)))
        file.write(chunk(b"PLTE", palette.tobytes()))
        file.write(chunk(b"IDAT", zlib.compress(lines.tobytes(), 9)))
        file.write(chunk(b"IEND", b""))


def few_colors(pixels, colors):
    """For each pixel the number of a color, and the colors, of which the last is that of the first pixel."""
    rows, columns, _ = pixels.shape
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, 3), deep=1))
    quantize = vtkImageQuantizeRGBToIndex()
    quantize.SetInputData(image)
    quantize.SetNumberOfColors(colors)
    quantize.Update()
    indices = vtk_to_numpy(quantize.GetOutput().GetPointData().GetScalars()).reshape(rows, columns)
    table = quantize.GetLookupTable()
    palette = np.array([table.GetTableValue(i)[:3] for i in range(indices.max() + 1)])
    palette = np.append(np.round(255 * palette).astype(np.uint8), pixels[:1, 0], axis=0)
    background = np.all(pixels == pixels[0, 0], axis=2)
    return np.where(background, len(palette) - 1, indices).astype(np.uint8), palette


def chunk(name, content):
    return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))
