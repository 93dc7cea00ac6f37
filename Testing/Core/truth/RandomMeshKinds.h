// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_RandomMeshKinds_h
#define geodesictest_RandomMeshKinds_h

#include "truth/TestMeshes.h"

#include <iosfwd>
#include <vector>

namespace geodesictest
{

/// A kind of random mesh that the sweeps go through.
struct MeshKind
{
  const char* name;
  /// A mesh of about this many faces.
  PlainMesh (*make)(Index faces, Random& random);
};

std::ostream& operator<<(std::ostream& os, const MeshKind& kind);

const std::vector<MeshKind>& meshKinds();

/// Mostly 50 to 500 faces, some up to 2,000.
Index randomSize(Random& random);

}

#endif
