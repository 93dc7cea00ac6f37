// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_CappedMeshes_h
#define geodesictest_CappedMeshes_h

#include "truth/TestMeshes.h"

namespace geodesictest
{

/// A surface with faces without area, and the same surface without them.
struct CappedMesh
{
  /// With vertices on edges of other faces. Faces without area close the gaps.
  PlainMesh mesh;
  /// The same points; faces are cut at the vertices on their edges, and there are no other ones.
  PlainMesh conforming;
};

/// Puts new vertices onto some edges, on one side of the edge or on both, each side with its own.
/// Any triangulation of them closes the edge. Of each face at most one edge is chosen.
///
/// \param mesh oriented, without edges of more than two faces.
CappedMesh withCaps(const PlainMesh& mesh, double fraction, Random& random);

/// Adds pockets: faces without area between an edge and new vertices on it, which may meet the edge
/// again. Distances at the other vertices stay as they are.
PlainMesh withPockets(const PlainMesh& mesh, Index pockets, Random& random);

}

#endif
