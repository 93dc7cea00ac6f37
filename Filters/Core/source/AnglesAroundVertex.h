// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_AnglesAroundVertex_h
#define geodesic_AnglesAroundVertex_h

#include "mesh/TriangleMesh.h"

#include <functional>
#include <vector>

namespace geodesic
{

/// An edge at a vertex, and the angle there between it and a direction. `halfedge` is the edge's in
/// the face that a way around the vertex leaves, or enters, across the edge.
struct EdgeAngle
{
  Id halfedge;
  double angle;
};

/// The least angles at which the faces around a vertex are entered on ways that turn about it, from
/// given directions: Dijkstra's algorithm over the edges at the vertex. Where an edge has three and
/// more faces, ways go on in all of them; the work grows with the number of faces all the same.
///
/// Keeps its memory from one call to the next.
class AnglesAroundVertex
{
public:
  /// Each face around the vertex is entered at most once across each of its two edges there.
  ///
  /// \param leaving where ways begin: faces that are left, and the angles to go to the edge.
  /// \param limit ways end at this angle.
  /// \param step called before each edge; may throw.
  /// \returns the faces that are entered and the angles at their edges; valid until the next call.
  const std::vector<EdgeAngle>& find(const TriangleMesh& mesh, Id vertex,
    const std::vector<EdgeAngle>& leaving, double limit, const std::function<void()>& step);

private:
  void push(const EdgeAngle& leaving);
  EdgeAngle pop();
  void cross(const TriangleMesh& mesh, Id vertex, const EdgeAngle& leaving);
  void enter(const TriangleMesh& mesh, Id vertex, const EdgeAngle& entering);

  /// What is known of a halfedge at the vertex.
  struct State
  {
    /// The first of its siblings (itself included) across which a way left its face.
    Id firstLeft = NoId;
    /// Whether its face has been entered across it.
    bool isEntered = false;
  };
  State& state(const TriangleMesh& mesh, Id vertex, Id halfedge);

  std::vector<EdgeAngle> entered_;
  /// A heap: the edges still to be crossed.
  std::vector<EdgeAngle> queue_;
  /// Two a corner at the vertex: of the halfedge that begins there and of the one that ends there.
  std::vector<State> states_;
};

}

#endif
