// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SaddleWedge_h
#define geodesic_SaddleWedge_h

#include "mesh/TriangleMesh.h"

#include <vector>

namespace geodesic
{

/// Where a path comes from to a vertex: its last straight piece runs through the face of
/// `halfedge`, which lies opposite the vertex, from the point at x on that halfedge (0 and the
/// halfedge's length: along an edge).
struct Arrival
{
  /// NoId where it is not known, and where the piece comes from a source in a face at the vertex.
  Id halfedge = NoId;
  /// What the piece comes from, which may be some faces farther: Window::origin.
  Id origin = NoId;
  double x = 0.0;
  /// The direction of the piece, in the halfedge's frame, of any length: where the vertex is close
  /// to the halfedge the two places do not tell it well. Zero along an edge.
  Vec2 direction = {};
  /// Where along a curve it comes from: Window::place.
  double place = 0.0;

  /// Whether anything is known; without a halfedge the piece comes from a source in a face at the
  /// vertex.
  bool isKnown() const { return this->halfedge != NoId || this->origin != NoId; }
  /// Whether the piece came through a window, not along an edge or from a source in a face.
  bool isThroughWindow() const
  {
    return this->halfedge != NoId && (this->direction.x != 0.0 || this->direction.y != 0.0);
  }
};

/// A part of the halfedge opposite a corner.
struct EmittedInterval
{
  Id corner;
  double begin;
  double end;
};

/// The shadow behind a saddle vertex, into which it emits as a pseudo-source: a shortest path that
/// bends at a vertex leaves an angle of at least pi on both sides of the bend (a boundary counts as
/// more than that), so that it goes on between the two straight continuations of the path that came
/// (paper, section 3; Mitchell, Mount and Papadimitriou 1987, "The discrete geodesic problem").
///
/// \param shadow the parts of the halfedges opposite the vertex's corners that are in the shadow;
///        replaced.
/// \returns false where the faces around the vertex do not form one fan, have no area, or the
///          arrival is not known: then the vertex has to emit everywhere, and `shadow` means
///          nothing.
bool findSaddleWedge(const TriangleMesh& mesh, Id vertex, const Arrival& arrival,
  std::vector<EmittedInterval>& shadow);

}

#endif
