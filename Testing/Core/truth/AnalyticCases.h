// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_AnalyticCases_h
#define geodesictest_AnalyticCases_h

#include "truth/BruteForce.h"
#include "truth/TestMeshes.h"

#include <vector>

namespace geodesictest
{

/// A mesh and a source whose distances are known without a mesh (AnalyticDistances).
struct AnalyticCase
{
  PlainMesh mesh;
  Sources sources;
  std::vector<MeshPoint> queries;
  std::vector<double> vertexTruth;
  std::vector<double> queryTruth;
};

AnalyticCase boxCase(Random& random);

/// A random case of one kind of surface.
struct AnalyticConfiguration
{
  const char* name;
  AnalyticCase (*make)(Random& random);
};
/// All kinds.
const std::vector<AnalyticConfiguration>& analyticConfigurations();

}

#endif
