// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchmarkMesh_h
#define BenchmarkMesh_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

// All throw std::runtime_error with what is wrong.

/// Reads an obj, ply, stl or vtp file.
vtkSmartPointer<vtkPolyData> readMesh(const std::string& file);

/// Triangles on points of which no two coincide, without any data.
vtkSmartPointer<vtkPolyData> plainTriangles(vtkPolyData* mesh);

/// Loop subdivision, each level four times as many faces.
vtkSmartPointer<vtkPolyData> subdivide(vtkPolyData* mesh, int levels);

/// Moves every point at random by up to a fraction of the mean edge length in each direction,
/// always alike.
vtkSmartPointer<vtkPolyData> addNoise(vtkPolyData* mesh, double fraction);

/// Writes an obj, ply, stl or vtp file.
void writeMesh(vtkPolyData* mesh, const std::string& file);

#endif
