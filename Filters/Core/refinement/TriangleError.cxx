// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/TriangleError.h"

#include <algorithm>

namespace geodesic
{

ErrorInside TriangleError::of(const FaceDistance& face, const LinearPiece& piece,
  const Deviation& onEdges, double limit, bool tight)
{
  const double below = std::max(onEdges.below, this->belowAtSources(face, piece));
  if (below > limit && !tight)
  {
    return { Infinity, below };
  }
  const ErrorInside above = this->above(face, piece, onEdges.above, limit, tight);
  return { std::max(above.bound, below), std::max(above.sample, below) };
}

ErrorInside TriangleError::above(
  const FaceDistance& face, const LinearPiece& piece, double onEdges, double limit, bool tight)
{
  const Vec2 e1 = piece.corners[1] - piece.corners[0];
  const Vec2 e2 = piece.corners[2] - piece.corners[0];
  const Vec2 e3 = e2 - e1;
  const double area2 = cross(e1, e2);
  // In a triangle without area each inner point is also a point of an edge.
  if (!(area2 > 0.0))
  {
    return { onEdges, onEdges };
  }
  const double longest = std::sqrt(std::max({ dot(e1, e1), dot(e2, e2), dot(e3, e3) }));
  const Gradient g = gradientOf(dot(e1, e1), dot(e1, e2), dot(e2, e2), area2,
    piece.values[1] - piece.values[0], piece.values[2] - piece.values[0], longest);
  // The distance changes by no more than the length moved to a corner, or to an edge.
  const double byWay = std::min(longest, onEdges + std::max(0.0, 1.0 - g.length) * g.chord);
  if (byWay <= limit)
  {
    return { byWay, onEdges };
  }
  const ErrorInside searched = this->search_.run(face, piece, limit, tight);
  return { std::min(byWay, searched.bound), std::max(onEdges, searched.sample) };
}

double TriangleError::belowAtSources(const FaceDistance& face, const LinearPiece& piece) const
{
  double below = 0.0;
  const Vec2 origin = piece.corners[0];
  const Vec2 e1 = piece.corners[1] - origin;
  const Vec2 e2 = piece.corners[2] - origin;
  const double area2 = cross(e1, e2);
  const auto look = [&](Vec2 p)
  {
    const double u = cross(p - origin, e2);
    const double v = cross(e1, p - origin);
    if (u >= 0.0 && v >= 0.0 && u + v <= area2 && area2 > 0.0)
    {
      below = std::max(below,
        ((area2 - u - v) * piece.values[0] + u * piece.values[1] + v * piece.values[2]) / area2);
    }
  };
  for (const SourceInFace& source : this->field_.sourcesIn(face.face()))
  {
    look(face.inPlane(source.a));
    look(face.inPlane(source.b));
  }
  return below;
}

}
