// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_JoinPoints_h
#define geodesic_JoinPoints_h

#include "front/Front.h"
#include "mesh/TriangleMesh.h"
#include "source/PolylineOnSurface.h"

#include <map>
#include <tuple>
#include <vector>

namespace geodesic
{

/// Makes a function that finds shortest paths between pairs of points of one surface (one of them
/// if there are several): the first point, a point on every edge that the path crosses, the
/// vertices that it passes, the second point. Consecutive points have a common face. Empty if no
/// path joins the points.
///
/// The search looks only at the part of the surface that a shortest path can touch.
///
/// \param mesh must outlive the result.
JoinPoints joinByShortestPaths(const TriangleMesh& mesh);

/// The paths that join far points of a mesh's curves. If one point of a polyline moves, the other
/// segments need not be joined again: the next call looks for their paths here.
class JoinedPaths
{
public:
  /// Makes a function that joins points as `join` does, but each pair only once, and that keeps the
  /// paths here. This object must outlive the function.
  ///
  /// \param earlier paths of the same mesh that need not be found again; must outlive the function.
  JoinPoints joinBy(JoinPoints join, const JoinedPaths& earlier);

private:
  using PointKey = std::tuple<SurfacePoint::Kind, Id, double, double>;
  using Ends = std::pair<PointKey, PointKey>;

  std::map<Ends, std::vector<SurfacePoint>> paths_;
};

}

#endif
