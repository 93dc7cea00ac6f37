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

/// A random triangulation of a rectangle, rotated in space: Euclidean distance.
AnalyticCase planeCase(Random& random);
/// The same, stretched to needles of aspect 1e3 to 1e5.
AnalyticCase stretchedPlaneCase(Random& random);
/// A regular grid, where everything ties.
AnalyticCase regularGridCase(Random& random);
AnalyticCase boxCase(Random& random);
AnalyticCase cylinderCase(Random& random);
/// A cone whose random total angle is under 2 pi.
AnalyticCase coneCase(Random& random);
/// Around one saddle vertex whose random total angle is over 2 pi.
AnalyticCase saddleFanCase(Random& random);
AnalyticCase tetrahedronCase(Random& random);
/// A planar domain with holes: visibility graph.
AnalyticCase holesCase(Random& random);
AnalyticCase lShapeCase(Random& random);
/// Flat pages on one spine: any two pages unfold into a rectangle.
AnalyticCase bookCase(Random& random);
/// Two rectangles with one common vertex.
AnalyticCase bowTieCase(Random& random);

/// All of these.
struct AnalyticConfiguration
{
  const char* name;
  AnalyticCase (*make)(Random& random);
};
const std::vector<AnalyticConfiguration>& analyticConfigurations();

}

#endif
