// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_BruteForce_h
#define geodesictest_BruteForce_h

#include "truth/TestMeshes.h"

#include <limits>
#include <vector>

namespace geodesictest
{

/// The sources from which distance is measured.
struct Sources
{
  std::vector<MeshPoint> points;
  std::vector<MeshSegment> segments;
};

struct BruteForceOptions
{
  /// Values up to this one are exact, larger ones are upper bounds.
  double maximumDistance = std::numeric_limits<double>::infinity();
  /// Lets every vertex emit, not only those where a geodesic can bend: slower, same result.
  bool everyVertexEmits = false;
};

struct BruteForceResult
{
  /// +infinity if no path exists.
  std::vector<double> vertices;
  /// Distances at the query points.
  std::vector<double> queries;
  /// The number of pencils of rays followed.
  std::size_t pencils = 0;
};

/// Exact geodesic distance by plain unfolding.
///
/// From every source and from every vertex where a geodesic can bend, the faces are unfolded into
/// one plane, strip by strip, and the pencil of rays that gets through a strip is followed. A
/// pencil is dropped only where a path through one end of the edge it crosses, whose length is
/// already known, is shorter for all of its rays. Pencils are never compared with each other. A
/// segment sends a pencil of parallel rays to each side and is otherwise its two end points.
///
/// Faces that name a vertex twice are ignored, and so are all but the first on the same vertices.
/// Sources must not lie inside a face of zero area.
BruteForceResult bruteForceDistances(const PlainMesh& mesh, const Sources& sources,
  const std::vector<MeshPoint>& queries = {}, const BruteForceOptions& options = {});

}

#endif
