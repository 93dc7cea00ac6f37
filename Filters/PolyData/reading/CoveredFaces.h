// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CoveredFaces_h
#define geodesic_CoveredFaces_h

#include "Job.h"
#include "mesh/MeshPartition.h"
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
  /// The source's face that it lies in, by number.
  std::size_t by;
};

/// The faces of a surface that faces of a source consist of.
struct CoveredFaces
{
  /// Those that this rank owns, ascending by face; a face may belong to several sources.
  std::vector<CoveredFace> own;
  /// For each face of the source whether it consists of faces of the surface. The same on all
  /// ranks.
  std::vector<bool> isOnSurface;
};

/// Finds the faces of a surface that a source's face covers. The source's face consists of them
/// within the precision of coordinates: it is one of them, or was cut into them. A source's face
/// that also lies in parts of other faces covers none. All ranks call this together.
///
/// \throws Aborted
CoveredFaces findCoveredFaces(const MeshPartition& surface,
  const std::vector<LocatedPolyline>& faces, double coordinatePrecision, const Job& job);

}

#endif
