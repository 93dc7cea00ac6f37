# SPDX-License-Identifier: BSD-3-Clause
"""VTK's data sets as bytes, for other processes."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_CHAR, vtkCharArray
from vtkmodules.vtkCommonDataModel import vtkDataObjectTypes
from vtkmodules.vtkParallelCore import vtkCommunicator

from .messages import GeodesicError


def bytes_of(data):
    """VTK's number of a data set's class, which subclasses of Python share, and what it holds as bytes."""
    chars = vtkCharArray()
    if not vtkCommunicator.MarshalDataObject(data, chars):
        raise GeodesicError(f"VTK cannot write this {data.GetClassName()} into a pickle. Give points and faces.")
    return data.GetDataObjectType(), vtk_to_numpy(chars).tobytes()


def data_of(kind, content):
    """The data set of bytes_of()."""
    data = vtkDataObjectTypes.NewDataObject(kind)
    chars = numpy_to_vtk(np.frombuffer(content, np.int8), deep=True, array_type=VTK_CHAR)
    if not vtkCommunicator.UnMarshalDataObject(chars, data):
        raise GeodesicError(f"This pickle has no {data.GetClassName()} that VTK can read.")
    return data
