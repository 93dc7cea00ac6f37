// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CurveWedge_h
#define geodesic_CurveWedge_h

#include "source/SourceCurve.h"

#include <map>
#include <vector>

namespace geodesic
{

/// An edge at a vertex, and the angle there between the edge and a direction. `halfedge` is the
/// edge's halfedge in the face that is left or entered across the edge.
struct EdgeAngle
{
  Id halfedge;
  double angle;
};

/// The least angles at which ways that turn around a vertex, beginning at given directions, enter
/// the faces there: Dijkstra's algorithm over the edges at the vertex. At an edge of three and more
/// faces a way continues into all of them. A way enters each face at most once across each of its
/// two edges at the vertex.
///
/// \param leaving where ways begin: the faces that they leave, and their angles to the edge.
/// \param limit ways end at this angle.
/// \returns the entered faces with the angles at their edges.
std::vector<EdgeAngle> leastAnglesAround(
  const TriangleMesh& mesh, Id vertex, std::vector<EdgeAngle> leaving, double limit);

/// The direction of a segment that ends at a point, in a face around the point: a unit vector in
/// the frame of a halfedge of the face. A ray at less than a right angle to it starts at the wrong
/// point, as one from inside the segment is shorter.
struct WedgeBound
{
  Id halfedge;
  Vec2 direction;
};

/// The wedge of directions into which a point of a curve emits: those at a right angle or more to
/// all its segments there, measured around the point across any of the faces (paper, section 4.2).
/// Given by the segments that bound it in each face around the point.
using CurveWedge = std::multimap<Id, WedgeBound>;

/// \param point of a curve.
/// \param ends the ends of all segments there; for a vertex, of all curves.
CurveWedge wedgeAround(
  const TriangleMesh& mesh, const SurfacePoint& point, const std::vector<SegmentEnd>& ends);

}

#endif
