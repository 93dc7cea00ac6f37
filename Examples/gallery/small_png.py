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
    palette = np.append(palette_of(pixels, colors), pixels[:1, 0], axis=0)
    numbers = pixels.astype(np.int32) @ (1 << 16, 1 << 8, 1)
    different, first, indices = np.unique(numbers, return_index=True, return_inverse=True)
    # The quantizer's own numbers may be those of other colors: a few triangles would stand out.
    nearest = [np.abs(palette.astype(int) - color).sum(axis=1).argmin()
               for color in pixels.reshape(-1, 3)[first].astype(int)]
    return np.array(nearest, np.uint8)[indices].reshape(numbers.shape), palette


def palette_of(pixels, colors):
    """So many colors of a picture, or fewer."""
    rows, columns, _ = pixels.shape
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, 3), deep=1))
    quantize = vtkImageQuantizeRGBToIndex()
    quantize.SetInputData(image)
    quantize.SetNumberOfColors(colors)
    quantize.Update()
    table = quantize.GetLookupTable()
    palette = [table.GetTableValue(i)[:3] for i in range(table.GetNumberOfTableValues())]
    return np.round(255 * np.array(palette)).astype(np.uint8)


def chunk(name, content):
    return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))
