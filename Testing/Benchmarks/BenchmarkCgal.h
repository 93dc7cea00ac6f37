// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchmarkCgal_h
#define BenchmarkCgal_h

#include "vtkType.h"

#include <vector>

class vtkPolyData;

/// Seconds of CGAL's Surface_mesh_shortest_path for the distances of all vertices from one vertex,
/// without the time to hand the mesh over. Throws std::runtime_error where CGAL cannot have the
/// mesh.
double secondsOfCgal(vtkPolyData* mesh, vtkIdType vertex, std::vector<double>& distances);

#endif
