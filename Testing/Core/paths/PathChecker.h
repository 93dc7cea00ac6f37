// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_PathChecker_h
#define geodesictest_PathChecker_h

#include "EngineSupport.h"
#include "truth/BruteForce.h"
#include "truth/TestMeshes.h"

#include "mesh/SurfacePoint.h"

#include <set>
#include <vector>

namespace geodesictest
{

/// A point of a path in terms of the plain mesh: its place, and the vertices of the smallest
/// vertex, edge or face that holds it.
struct PathPoint
{
  Vec3 place;
  std::set<Index> support;
};

/// Checks shortest paths for what holds for any shortest path on the plain mesh.
class PathChecker
{
public:
  explicit PathChecker(const PlainMesh& mesh);

  std::vector<PathPoint> plain(const std::vector<geodesic::SurfacePoint>& path) const;
  PathPoint plain(const geodesic::SurfacePoint& p) const;

  /// Checks all properties of a shortest path of this length.
  ///
  /// \param slack by how much the length may be off, and a bend may be longer than the straight
  ///        way. Lengths tell no more: a point that is off the straight way by a fraction of its
  ///        length makes it longer by the square of that.
  void expectShortest(const std::vector<PathPoint>& path, double length, double slack) const;

  /// Checks a path from a point to the nearest of some sources.
  ///
  /// \param distance of the point; if it is infinite, the path must be empty.
  void expectPath(const std::vector<geodesic::SurfacePoint>& path, const MeshPoint& from,
    const Sources& sources, double distance, double slack) const;

  /// The sum of the lengths of the pieces.
  static double length(const std::vector<PathPoint>& path);

  std::vector<Index> commonFaces(const PathPoint& a, const PathPoint& b) const;

private:
  double bend(const PathPoint& before, const PathPoint& p, const PathPoint& after) const;
  double turn(
    Index f, const PathPoint& before, const PathPoint& p, Index g, const PathPoint& after) const;
  std::vector<Index> fanAround(Index vertex) const;
  double leastAngle(Index vertex, const PathPoint& before, const PathPoint& after) const;

  const PlainMesh& mesh_;
  std::vector<std::vector<Index>> facesOfVertex_;
};

/// The path of each target as those that tracing has lost are found.
std::vector<FoundPath> findPathsInStrips(const geodesic::TriangleMesh& mesh,
  const std::vector<geodesic::SourceCurve>& curves,
  const std::vector<geodesic::SurfacePoint>& targets);

/// The distance through space from a place to the nearest source.
double distanceInSpace(const PlainMesh& mesh, const Vec3& place, const Sources& sources);

}

#endif
