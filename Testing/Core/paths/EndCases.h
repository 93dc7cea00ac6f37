// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_EndCases_h
#define geodesictest_EndCases_h

#include "truth/PlaneEnds.h"

#include <functional>
#include <string>
#include <vector>

namespace geodesictest
{

/// A surface, its sources and points, and in closed form where and how the shortest paths from
/// these points end on the source.
struct EndCase
{
  PlainMesh mesh;
  std::vector<Polyline> sources;
  std::vector<MeshPoint> queries;
  /// The ends that the path from a query may have; none where rounding decides.
  ///
  /// \param frames of the sources, by the engine.
  std::function<std::vector<TrueEnd>(const MeshPoint& query, const std::vector<PlainFrame>& frames)>
    endsOf;
  /// In radians; of lengths relative to the longest one.
  double accuracy = 1e-11;
  /// Of a path as it is traced: its last piece has rounded ends.
  double accuracyOfPath = 1e-11;
  /// Of distances.
  double accuracyOfDistance = 2e-11;
  /// The least angle of a path.
  double leastAngle = -3.1415926535897936;
  /// Whether all of it lies in a plane, so that the truth has the places of ends.
  bool isPlane = false;
};

/// A row of the table of cases.
struct EndConfiguration
{
  std::string name;
  EndCase (*make)(Random& random, double variant);
  /// One case for each variant and seed.
  std::vector<double> variants = { 0.0 };
  std::uint64_t seeds = 1;
  bool isOnRanks = false;
};

const std::vector<EndConfiguration>& endConfigurations();

/// A point that is a source, as a polyline.
Polyline pointLine(const MeshPoint& point);
/// A line along mesh edges.
Polyline lineAlong(const PlainMesh& mesh, const std::vector<Index>& vertices);

}

#endif
