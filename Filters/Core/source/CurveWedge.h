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

/// The wedge of directions into which a point of a curve emits: those at a right angle or more to
/// all its segments there, measured around the point across any of the faces (paper, section 4.2).
/// For each face around the point, the directions of the segments that bound the wedge there, as
/// unit vectors. A ray at less than a right angle to one starts at the wrong point, as one from
/// inside the segment is shorter.
using CurveWedge = std::multimap<Id, FaceDirection>;

/// \param point of a curve.
/// \param ends the ends of all segments there; for a vertex, of all curves.
CurveWedge wedgeAround(
  const TriangleMesh& mesh, const SurfacePoint& point, const std::vector<SegmentEnd>& ends);

}

#endif
