// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinedSurface_h
#define geodesic_RefinedSurface_h

#include "PolyData/writing/UnmeshedTriangles.h"
#include "refinement/RefinedMesh.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

/// The surface after refinement, with all its triangles, before it is divided into blocks.
struct RefinedSurface
{
  /// Its faces have numbers of the surface's triangles.
  RefinedMesh mesh;
  /// The points of refinement, of any rank, that the last of the mesh's are copies of: which of
  /// RefinedMesh::points there. The copies have distances, but no places.
  std::vector<RankAddress> copied;

  std::size_t numberOfPointsWithPlaces() const
  {
    return this->mesh.points.size() - this->copied.size();
  }
};

/// Adds the triangles of a surface that are not faces of its mesh.
///
/// The mesh has one of several faces on the same vertices, the surface has all of them: the others
/// get the parts of the first, which any rank may own, so that they still fit to their neighbors.
/// If all ranks together would have more than maximumFaces triangles (0: no limit), they stay
/// whole. Copies by ghost arrays do not count, and always look like their originals.
///
/// Barriers and segments are cut where refinement has split edges of faces there, and are whole
/// elsewhere. No other points are added to them: they have no distances inside.
///
/// All ranks call this together.
///
/// \param cornerPoints those of the refinement.
/// \param vertexDistances of the mesh's vertices, for the surface's cut points.
/// \param refined what refinement made.
RefinedSurface addUnmeshedTriangles(const UnmeshedTriangles& unmeshed, std::uint64_t maximumFaces,
  const std::vector<Triangle>& cornerPoints, const std::vector<double>& vertexDistances,
  RefinedMesh refined);

}

#endif
