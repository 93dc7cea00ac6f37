// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SaddleWedge_h
#define geodesic_SaddleWedge_h

#include "front/Arrival.h"
#include "mesh/TriangleMesh.h"

#include <vector>

namespace geodesic
{

/// A part of the halfedge opposite a corner.
struct EmittedInterval
{
  Id corner;
  double begin;
  double end;
};

/// Finds the shadow behind a saddle vertex, into which it emits as a pseudo-source. A shortest path
/// that bends at a vertex leaves an angle of at least pi on both sides of the bend (a boundary
/// counts as more), so it continues between the two straight continuations of the arriving path
/// (paper, section 3; Mitchell, Mount and Papadimitriou 1987, "The discrete geodesic problem").
///
/// \param shadow the parts of the halfedges opposite the vertex's corners that are in the shadow;
///        replaced.
/// \returns false if the faces around the vertex do not form one fan, or the arrival is unknown:
/// then the vertex has to emit everywhere, and `shadow` is meaningless.
bool findSaddleWedge(const TriangleMesh& mesh, Id vertex, const Arrival& arrival,
  std::vector<EmittedInterval>& shadow);

}

#endif
