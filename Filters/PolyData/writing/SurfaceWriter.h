// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfaceWriter_h
#define geodesic_SurfaceWriter_h

#include "PolyData/reading/PolyDataSurface.h"
#include "PolyData/writing/SourceArrays.h"
#include "refinement/RefinedMesh.h"

#include <vector>

class vtkPolyData;

namespace geodesic
{

/// What of a refined mesh belongs to one block of the surface, in numbers of the block: points, and
/// triangles as RefinedMesh::faces has them.
struct RefinedBlock
{
  RefinedMesh mesh;
  /// At its new points.
  std::vector<SourceValues> values;
};

/// Divides a refined mesh (after addUnmeshedTriangles()), and the values at its new points, among
/// the blocks of the surface. Each edge of the surface is an edge between points of one block, so
/// that every new point belongs to one, too.
std::vector<RefinedBlock> partsByBlock(
  const PolyDataSurface& surface, RefinedMesh refined, std::vector<SourceValues> values);

/// A block of the surface, the input that it was made from and the output that it goes to.
struct BlockToWrite
{
  const SurfaceBlock& block;
  vtkPolyData* input;
  vtkPolyData* output;
  /// VTK's type of the output's points: typeOfPoints().
  int pointType;
};

/// Gives the output the points of the input with their data, the block's triangles, and for each
/// the data of the cell that it came from.
void writeWhole(const BlockToWrite& to, const Job& job);

/// Gives the output a refined block: the input's points with their data, the new points with
/// interpolated data, and the triangles with the data of the cells that they are parts of and those
/// cells' numbers as OriginalCellIds.
///
/// \param refined in numbers of the block, see partsByBlock().
/// \param scale of the refined mesh.
void writeRefined(
  const BlockToWrite& to, const RefinedMesh& refined, const PowerOfTwoScale& scale, const Job& job);

/// Leaves out of a data set of triangles the points that none of them uses; the others keep their
/// order and their data. Arrays are replaced, not changed: other data sets may have them, too.
///
/// \throws NotEnoughMemory
void removeUnusedPoints(vtkPolyData* data);

}

#endif
