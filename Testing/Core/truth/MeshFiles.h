// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_MeshFiles_h
#define geodesictest_MeshFiles_h

#include "truth/TestMeshes.h"

#include <string>

/// Well-known meshes, from the folder that GEODESIC_TEST_MESHES names.
namespace geodesictest
{

/// Empty if GEODESIC_TEST_MESHES is not set.
std::string meshFolder();

/// The message of a test that is skipped because the folder lacks a mesh.
std::string noMeshFolder(const std::string& wanted);

/// The file's name without its extension, as a part of a test's name.
std::string testName(const std::string& file);

/// Vertices and triangles of a file in the folder: OBJ (polygons as fans), or PLY with binary
/// triangle strips. Coincident points become one, and triangles that thereby lose their area are
/// dropped. Empty if the file cannot be read.
PlainMesh readMesh(const std::string& name);

}

#endif
