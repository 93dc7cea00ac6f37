// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathStrip_h
#define geodesic_PathStrip_h

#include "mesh/MeshPartition.h"
#include "mesh/SurfacePoint.h"

#include <vector>

namespace geodesic
{

/// A point of a path with a face that holds it and the point before, as ranks tell it each other.
struct PointInFace
{
  RankAddress face;
  /// The vertices' numbers in the whole, and where they lie.
  Triangle vertices;
  std::array<Vec3, 3> corners;
  /// With the corner or the halfedge of the face in place of SurfacePoint::id.
  SurfacePoint point;
};

/// \param face of the part that holds the point, and of a point on an edge its halfedge.
PointInFace pointInFace(const MeshPartition& part, Id face, const SurfacePoint& point);

/// The same point on this rank; its face must be one of the part.
SurfacePoint pointOfPart(const MeshPartition& part, const RankAddress& face, SurfacePoint point);

/// The places of a path that was traced through faces of several ranks, cleaned by cleanedPath() on
/// the strip of these faces; of a single point twice that.
std::vector<Vec3> cleanedPlaces(const std::vector<PointInFace>& path, double length);

}

#endif
