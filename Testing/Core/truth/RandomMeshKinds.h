// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_RandomMeshKinds_h
#define geodesictest_RandomMeshKinds_h

#include "truth/TestMeshes.h"

#include <cstdint>
#include <iosfwd>
#include <vector>

namespace geodesictest
{

/// A kind of random mesh.
struct MeshKind
{
  const char* name;
  /// Makes a mesh of about this many faces.
  PlainMesh (*make)(Index faces, Random& random);
};

std::ostream& operator<<(std::ostream& os, const MeshKind& kind);

/// All kinds; under ThreadSanitizer every third one, as races do not depend on the shape.
const std::vector<MeshKind>& meshKinds();

/// The number of random meshes of a kind in a test: `full`, but at most two under sanitizers, whose
/// findings depend on the paths through the code and hardly on the numbers.
constexpr std::uint64_t meshesOfAKind(std::uint64_t full)
{
#ifdef GEODESIC_FEW_MESHES
  return full < 2 ? full : 2;
#else
  return full;
#endif
}

/// Mostly 50 to 500 faces, some up to 2,000.
Index randomSize(Random& random);

}

#endif
