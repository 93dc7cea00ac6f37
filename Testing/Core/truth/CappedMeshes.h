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

/// Which new vertices an edge gets.
enum class Caps
{
  /// One, on one side of it: one face without area.
  One,
  /// Several, on one side or on both, each side with its own. Any triangulation of them closes the
  /// edge.
  Several
};

/// Puts new vertices onto some edges. Of each face at most one edge is chosen.
///
/// \param mesh oriented, without edges of more than two faces.
CappedMesh withCaps(const PlainMesh& mesh, Caps caps, double fraction, Random& random);

/// Adds pockets: faces without area between an edge and new vertices on it, which may meet the edge
/// again. Distances at the other vertices stay as they are.
PlainMesh withPockets(const PlainMesh& mesh, Index pockets, Random& random);

}

#endif
