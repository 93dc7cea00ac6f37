// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_AnglesAroundVertex_h
#define geodesic_AnglesAroundVertex_h

#include "mesh/TriangleMesh.h"

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
/// faces a way continues into all of them, yet the work is linear in the number of faces.
///
/// Reuses its memory in the next call.
class AnglesAroundVertex
{
public:
  /// A way enters each face at most once across each of its two edges at the vertex.
  ///
  /// \param leaving where ways begin: the faces that they leave, and their angles to the edge.
  /// \param limit ways end at this angle.
  /// \returns the entered faces with the angles at their edges; valid until the next call.
  const std::vector<EdgeAngle>& find(
    const TriangleMesh& mesh, Id vertex, const std::vector<EdgeAngle>& leaving, double limit);

private:
  void push(const EdgeAngle& leaving);
  EdgeAngle pop();
  void cross(const TriangleMesh& mesh, Id vertex, const EdgeAngle& leaving);
  void enter(const TriangleMesh& mesh, Id vertex, const EdgeAngle& entering);

  /// State of a halfedge at the vertex.
  struct State
  {
    /// The first of its siblings (or itself) whose face a way left across it.
    Id firstLeft = NoId;
    /// Whether a way entered its face across it.
    bool isEntered = false;
  };
  State& state(const TriangleMesh& mesh, Id vertex, Id halfedge);

  std::vector<EdgeAngle> entered_;
  /// A heap of the edges that are yet to be crossed.
  std::vector<EdgeAngle> queue_;
  /// Two for each corner at the vertex: of its outgoing and of its incoming halfedge.
  std::vector<State> states_;
};

}

#endif
