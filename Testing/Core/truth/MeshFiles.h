// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_MeshFiles_h
#define geodesictest_MeshFiles_h

#include "truth/TestMeshes.h"

#include <string>

/// Meshes that people use, from the folder that GEODESIC_TEST_MESHES names.
namespace geodesictest
{

/// Empty where GEODESIC_TEST_MESHES is not set.
std::string meshFolder();

/// What a test that needs a mesh of the folder says when there is none.
std::string noMeshFolder(const std::string& wanted);

/// The file's name without its ending, as a part of a test's name.
std::string testName(const std::string& file);

/// Vertices and triangles of a file of the folder: OBJ (polygons as fans), or PLY as binary
/// triangle strips; points at one place become one, and triangles that this leaves without area go.
/// Empty where the file cannot be read.
PlainMesh readMesh(const std::string& name);

}

#endif
