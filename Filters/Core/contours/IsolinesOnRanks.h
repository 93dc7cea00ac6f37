// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_IsolinesOnRanks_h
#define geodesic_IsolinesOnRanks_h

#include "contours/Isolines.h"

#include <vector>

namespace geodesic
{

/// A point of an isoline on an edge. Its number in the list of these points is its id.
struct EdgePoint
{
  /// The one that names the edge (TriangleMesh::edgeOf); its face computes the points.
  Id halfedge;
  Id value;
  double fraction;
  /// Whether the distance passes the value upwards along the halfedge.
  bool rises;
};

/// Adds the points on edges of seams that other ranks have computed. Faces have one order on all
/// ranks, so that all agree about the halfedge that names an edge. The owner of its face sends the
/// edge's points to the other ranks at the edge. All ranks call this together; in one process it
/// does nothing.
///
/// \param points ascending by halfedge and value, before and after.
void exchangeEdgePoints(const MeshPartition& part, std::vector<EdgePoint>& points);

/// The ids of the points where lines of other ranks continue; none in one process.
std::vector<Id> pointsAtSeams(const MeshPartition& part, const std::vector<EdgePoint>& points);

/// Counts lines that end at a seam between faces of opposite orientation: the lines that continue
/// them run the other way. In one process, lines end between two faces only where several meet.
void countTurnsAtSeams(const TriangleMesh& mesh, Isolines& isolines);

}

#endif
