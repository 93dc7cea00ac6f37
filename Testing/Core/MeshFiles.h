// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_MeshFiles_h
#define geodesictest_MeshFiles_h

#include "TestMeshes.h"

#include <string>

/// Meshes that people use, from the folder that GEODESIC_TEST_MESHES names.
namespace geodesictest
{

/// Empty where GEODESIC_TEST_MESHES is not set.
std::string meshFolder();

/// What a test that needs a mesh of the folder says when there is none.
std::string noMeshFolder(const std::string& wanted);

/// Vertices and triangles of an OBJ file of the folder (polygons as fans); points at one place
/// become one. Empty where the file cannot be read.
PlainMesh readMesh(const std::string& name);

}

#endif
