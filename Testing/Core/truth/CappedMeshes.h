// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_CappedMeshes_h
#define geodesictest_CappedMeshes_h

#include "truth/TestMeshes.h"

namespace geodesictest
{

/// A surface with faces without area, and the same surface without them.
struct CappedMesh
{
  /// With vertices on edges of other faces; faces without area close the gaps.
  PlainMesh mesh;
  /// The faces are divided at the vertices on their edges, so there are no faces without area. It
  /// has all points; those of needles are on no face.
  PlainMesh conforming;
  /// For each vertex of the mesh the vertex of the conforming one at its place.
  std::vector<Index> vertexOf;
  /// For each face of the mesh the faces of the surface before: the one that it is a part of, or
  /// those at the edge that it lies on.
  std::vector<std::vector<Index>> facesBefore;
  /// For each conforming face the one that it is a part of.
  std::vector<Index> faceBefore;
};

/// The new vertices of an edge.
enum class Caps
{
  /// One, on one side of an edge of two faces: one face without area. At most one edge a face.
  One,
  /// Several, on one side or on both sides, different ones on each. A random triangulation of them
  /// closes the edge. At most one edge a face.
  Several,
  /// Edges of any number of faces, several a face: different vertices for each of them, and pockets
  /// beside them that return to the edge.
  Any,
  /// Also loose faces without area on any three of the same vertices.
  AnyAndLoose
};

/// Puts new vertices onto some edges.
///
/// \param fraction of the edges.
/// \param offset the new vertices are moved off their edges by up to this length along each axis.
CappedMesh withCaps(
  const PlainMesh& mesh, Caps caps, double fraction, Random& random, double offset = 0.0);

/// Opens vertices: each becomes two, at one place up to the offset. One face takes the second one,
/// and needles at both of its edges join it to the others again.
void addNeedles(CappedMesh& both, double fraction, Random& random, double offset = 0.0);

}

#endif
