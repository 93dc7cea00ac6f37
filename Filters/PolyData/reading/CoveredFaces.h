// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CoveredFaces_h
#define geodesic_CoveredFaces_h

#include "Job.h"
#include "mesh/TriangleMesh.h"
#include "source/PolylineOnSurface.h"

#include <vector>

namespace geodesic
{

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
///        then found, whether or not it consists of them.
/// \returns ascending by face; a face may belong to several sources.
/// \throws Aborted
std::vector<CoveredFace> findCoveredFaces(const TriangleMesh& surface,
  const std::vector<LocatedPolyline>& faces, double coordinatePrecision, bool isPart,
  const Job& job);

}

#endif
