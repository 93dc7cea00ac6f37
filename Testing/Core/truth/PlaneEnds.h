// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_PlaneEnds_h
#define geodesictest_PlaneEnds_h

#include "truth/RandomCurves.h"

#include <utility>
#include <vector>

namespace geodesictest
{

/// The angle 0 of a source that is a point, or the direction of a curve's first segment; what is to
/// the left of it; the normal.
struct PlainFrame
{
  Vec3 x;
  Vec3 y;
  Vec3 normal;
};

Vec3 minus(const Vec3& a, const Vec3& b);
double dotProduct(const Vec3& a, const Vec3& b);
/// The angle of a vector in a frame, in (-pi, pi].
double angleIn(const PlainFrame& frame, const Vec3& v);
/// Between two angles, up to turns.
double gapOfAngles(double a, double b);

/// Where and how a shortest path may end on the source.
struct TrueEnd
{
  Index source = 0;
  double length = 0.0;
  double arcLength = 0.0;
  double angle = 0.0;
  /// By how much the angle may be off in addition.
  double slack = 0.0;
  /// Whether the path leaves a segment between the segment's ends.
  bool isInside = false;
  /// Where it ends; only in a plane.
  Vec3 place = {};
};

/// Where shortest paths on a convex mesh in a plane end: paths are straight.
class PlaneEnds
{
public:
  /// \param bends whether paths may bend at a vertex where they are as long as the straight one up
  ///        to a tie. Then their directions carry the rounding of both places.
  PlaneEnds(const PlainMesh& mesh, const std::vector<Polyline>& sources, bool bends = false);
  /// \param lines a single point is a point.
  explicit PlaneEnds(std::vector<std::vector<Vec3>> lines)
    : lines_(std::move(lines))
  {
  }

  /// All ends that a shortest path from the place may have: several where paths tie.
  ///
  /// \param frames of the sources.
  std::vector<TrueEnd> of(const Vec3& place, const std::vector<PlainFrame>& frames) const;

private:
  using Line = std::vector<Vec3>;

  std::vector<TrueEnd> straight(const Vec3& place, const std::vector<PlainFrame>& frames) const;
  void addStraight(Index source, const Vec3& place, const PlainFrame& frame, double longest,
    std::vector<TrueEnd>& ends) const;

  std::vector<Vec3> vertices_;
  std::vector<double> toVertices_;
  std::vector<Line> lines_;
  double size_ = 0.0;
};

}

#endif
