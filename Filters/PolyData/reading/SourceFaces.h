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

/// Removes faces without area, unless none has an area, and cuts the others at their points, as
/// those of a surface (removeFacesWithoutArea()).
///
/// \returns for each face that is left its parts: itself unless it is cut.
std::vector<std::vector<LocatedPolyline>> cutAtFacesWithoutArea(
  std::vector<LocatedPolyline>& faces);

/// Makes regions of the faces of a source. Its outline are the edges that one of its faces uses,
/// joined to polylines; each runs in the direction of most of its edges in their faces, so that the
/// region lies to its left. A face that is given twice counts once. A closed region has no outline:
/// its first point stands for it.
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

/// A point inside each face, where it is widest, as a polyline of one point.
std::vector<LocatedPolyline> pointsInside(const std::vector<LocatedPolyline>& faces);

/// A face of a surface that belongs to a source.
struct CoveredFace
{
  Id face;
  /// LocatedPolyline::source of the source's face.
  Id source;
};

/// Finds the faces of a surface that a source's face covers. The source's face consists of them
/// within the precision of coordinates: it is one of them, or was cut into them. A source's face
/// that also lies in parts of other faces covers none.
///
/// \param isPart whether others have more of the surface: faces that lie in a source's face are
/// then
///        found, whether or not it consists of them.
/// \returns ascending by face; a face may belong to several sources.
/// \throws Aborted
std::vector<CoveredFace> findCoveredFaces(const TriangleMesh& surface,
  const std::vector<LocatedPolyline>& faces, double coordinatePrecision, bool isPart,
  const Job& job);

}

#endif
