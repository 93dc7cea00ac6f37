// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PseudoSource_h
#define geodesic_PseudoSource_h

#include "front/SaddleWedge.h"
#include "mesh/TriangleMesh.h"
#include "window/Window.h"

#include <vector>

namespace geodesic
{

/// Where a vertex emits windows when the front reaches it (paper, section 3: pseudo-sources).
enum class Emission : std::uint8_t
{
  Nothing,
  /// Into the shadow behind it, between the straight continuations of its shortest path.
  Shadow,
  Everywhere
};

Emission emissionOf(TriangleMesh::PseudoSource kind);

/// Finds the intervals of the halfedges opposite a vertex through which it emits windows.
///
/// \param arrival how the shortest path arrives at the vertex.
/// \param intervals replaced.
void findEmittedIntervals(const TriangleMesh& mesh, Id vertex, Emission emission,
  const Arrival& arrival, std::vector<EmittedInterval>& intervals);

/// The window of rays that leave a vertex through an interval of the halfedge opposite one of its
/// corners, in the frame behind that halfedge, whose x axis runs against it.
///
/// \param sigma the vertex's own distance.
Window emittedWindow(const TriangleMesh& mesh, const EmittedInterval& interval, double sigma);

}

#endif
