// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_AnalyticCases_h
#define geodesictest_AnalyticCases_h

#include "truth/BruteForce.h"
#include "truth/TestMeshes.h"

#include <vector>

namespace geodesictest
{

/// A mesh, a source and the distances that are known without a mesh (AnalyticDistances).
struct AnalyticCase
{
  PlainMesh mesh;
  Sources sources;
  std::vector<MeshPoint> queries;
  std::vector<double> vertexTruth;
  std::vector<double> queryTruth;
};

/// A random triangulation of a rectangle, turned in space: Euclidean distance.
AnalyticCase planeCase(Random& random);
/// The same stretched to needles of aspect 1e3 to 1e5.
AnalyticCase stretchedPlaneCase(Random& random);
/// A regular grid, where everything ties.
AnalyticCase regularGridCase(Random& random);
AnalyticCase boxCase(Random& random);
AnalyticCase cylinderCase(Random& random);
/// A cone of random angle under 2 pi.
AnalyticCase coneCase(Random& random);
/// Around one saddle vertex of random angle over 2 pi.
AnalyticCase saddleFanCase(Random& random);
AnalyticCase tetrahedronCase(Random& random);
/// A planar domain with holes: visibility graph.
AnalyticCase holesCase(Random& random);
AnalyticCase lShapeCase(Random& random);
/// Flat pages on one spine: any two pages unfold into one rectangle.
AnalyticCase bookCase(Random& random);
/// Two rectangles with one vertex in common.
AnalyticCase bowTieCase(Random& random);

}

#endif
