// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceFaces_h
#define geodesic_SourceFaces_h

#include "Job.h"
#include "mesh/TriangleMesh.h"
#include "source/PolylineOnSurface.h"

#include "vtkType.h"

#include <vector>

namespace geodesic
{

/// Makes regions of the faces of a source. Its outline are the edges that one of its faces uses,
/// joined to polylines; each runs in the direction of most of its edges in their faces, so that the
/// region lies to its left. A closed region has no outline: its first point stands for it.
///
/// Faces with one value are one region. If faces are joined, so are those with a common edge. Edges
/// are the same if the coordinates of their ends are equal and are one vertex.
///
/// \param faces closed polylines that are not located yet. LocatedPolyline::source
///        becomes that of the region's first face.
/// \param values of each face.
/// \param polylines the outlines follow these.
/// \returns the sources that are gone because faces were joined, ascending.
std::vector<Id> makeRegions(std::vector<LocatedPolyline>& faces,
  const std::vector<vtkIdType>& values, bool areJoined, std::vector<LocatedPolyline>& polylines);

/// A face of a surface that belongs to a source.
struct CoveredFace
{
  Id face;
  /// LocatedPolyline::source of the source's face.
  Id source;
};

/// Finds the faces of a surface that lie in a source's face within the precision of coordinates:
/// those that are the same, or were cut from the same polygon.
///
/// \returns ascending by face; a face may belong to several sources.
/// \throws Aborted
std::vector<CoveredFace> findCoveredFaces(const TriangleMesh& surface,
  const std::vector<LocatedPolyline>& faces, double coordinatePrecision, const Job& job);

}

#endif
