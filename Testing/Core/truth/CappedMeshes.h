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
  /// The same points; faces are divided at the vertices on their edges, so there are no faces
  /// without area.
  PlainMesh conforming;
};

/// The new vertices of an edge.
enum class Caps
{
  /// One, on one side of it: one face without area.
  One,
  /// Several, on one side or on both sides, different ones on each. A random triangulation of them
  /// closes the edge.
  Several
};

/// Puts new vertices onto some edges, at most one edge per face.
///
/// \param mesh oriented, without edges of more than two faces.
CappedMesh withCaps(const PlainMesh& mesh, Caps caps, double fraction, Random& random);

/// Adds pockets: faces without area between an edge and new vertices on it, which may return to the
/// edge. Distances at the other vertices do not change.
PlainMesh withPockets(const PlainMesh& mesh, Index pockets, Random& random);

}

#endif
