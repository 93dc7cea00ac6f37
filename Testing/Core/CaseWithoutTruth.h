// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_CaseWithoutTruth_h
#define geodesictest_CaseWithoutTruth_h

#include "EngineSupport.h"

#include <algorithm>
#include <limits>

namespace geodesictest
{

/// As randomCase(), without brute force, which takes longer than all else.
inline RandomCase caseWithoutTruth(const MeshKind& kind, std::uint64_t seed,
  std::size_t numberOfQueries, Index mostFaces = std::numeric_limits<Index>::max())
{
  Random random(seed);
  RandomCase result;
  result.mesh = kind.make(std::min(randomSize(random), mostFaces), random);
  result.curves = CurveMaker(result.mesh, random).anySource();
  result.queries = randomPoints(result.mesh, numberOfQueries, random);
  return result;
}

}

#endif
