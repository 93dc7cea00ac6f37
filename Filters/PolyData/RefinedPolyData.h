// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinedPolyData_h
#define geodesic_RefinedPolyData_h

#include "refinement/AdaptiveRefinement.h"
#include "PolyData/PolyDataSurface.h"

class vtkPolyData;

namespace geodesic
{

/// The mesh has one of the faces on the same corners, the surface has them all: gives the others
/// the parts of the first, so that they still fit to their neighbours. Where that would make more
/// than maximumFaces triangles (0: no limit) they stay whole.
///
/// After the call RefinedMesh::faces has numbers of the surface's triangles.
void addDuplicateFaces(
  const PolyDataSurface& surface, std::uint64_t maximumFaces, RefinedMesh& refined);

/// Gives the output the refined surface (after addDuplicateFaces): the input's points with their
/// data, the new points with interpolated data, and the triangles with the data of the cells that
/// they are parts of and those cells' numbers as OriginalCellIds.
///
/// Numbers are interpolated linearly in the face. Strings, ids and bits are those of the nearest
/// corner, a point is a ghost in the ways that all corners around it are, and global ids are
/// dropped.
///
/// \param progress called now and then; returning false throws Aborted.
void writeRefined(const PolyDataSurface& surface, const RefinedMesh& refined, vtkPolyData* input,
  vtkPolyData* output, const ProgressCallback& progress);

}

#endif
