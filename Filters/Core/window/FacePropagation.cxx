// SPDX-License-Identifier: BSD-3-Clause
#include "window/FacePropagation.h"

namespace geodesic
{

namespace
{

/// An edge through which windows leave the face, with the known distances at its ends. A pair of
/// numbers belongs to the two ends of a window, which are computed together.
struct ExitEdge
{
  const UnfoldedFace& face;
  bool isLeft;
  /// The apex, seen from the halfedge's end that belongs to this edge.
  TwoDoubles apexAlong;
  TwoDoubles apexUp;
  TwoDoubles length;
  /// Coefficients of the rotation into the frame behind the edge: for x and for depth of a source
  /// relative to the edge's begin.
  TwoDoubles rotatedX;
  TwoDoubles rotatedDepth;
  /// The known distances at the edge's end and begin.
  TwoDoubles distanceAtEnds;
  /// The places of the edge's end and begin: its length and 0.
  TwoDoubles placeOfEnds;
  /// The angle from the halfedge to the edge, and whether windows carry angles.
  double turn;
  bool hasTurn = this->turn != 0.0;
};

ExitEdge leftEdge(const UnfoldedFace& face, const CornerDistances& distances)
{
  return { face, true, TwoDoubles(face.apex.x), TwoDoubles(face.apex.y),
    TwoDoubles(face.leftLength), TwoDoubles(face.leftAxis.x, face.leftAxis.y),
    TwoDoubles(-face.leftAxis.y, face.leftAxis.x), TwoDoubles(distances.apex, distances.origin),
    TwoDoubles(face.leftLength, 0.0), face.leftTurn };
}

ExitEdge rightEdge(const UnfoldedFace& face, const CornerDistances& distances)
{
  return { face, false, TwoDoubles(face.apexFromEnd), TwoDoubles(face.apex.y),
    TwoDoubles(face.rightLength), TwoDoubles(face.rightAxis.x, face.rightAxis.y),
    TwoDoubles(-face.rightAxis.y, face.rightAxis.x),
    TwoDoubles(distances.destination, distances.apex), TwoDoubles(face.rightLength, 0.0),
    face.rightTurn };
}

// Where the rays through the window's two ends meet the left edge, as in UnfoldedFace::meetLeft().
inline TwoDoubles endsOnLeft(const ExitEdge& left, const Window& w)
{
  const TwoDoubles depth(w.sourceDepth);
  const TwoDoubles denominator = depth * left.apexAlong - w.endDirections() * left.apexUp;
  const TwoDoubles t = TwoDoubles::wherePositive(denominator, w.ends() * depth / denominator);
  return TwoDoubles::clampedToUnit(t) * left.length;
}

// Where they meet the right edge, as in UnfoldedFace::meetRight().
inline TwoDoubles endsOnRight(const ExitEdge& right, const Window& w)
{
  const TwoDoubles depth(w.sourceDepth);
  const TwoDoubles denominator = depth * right.apexAlong + w.endDirections() * right.apexUp;
  const TwoDoubles t = TwoDoubles::wherePositive(
    denominator, (TwoDoubles(right.face.length) - w.ends()) * depth / denominator);
  return (TwoDoubles(1.0) - TwoDoubles::clampedToUnit(t)) * right.length;
}

// Whether a path through an end of the edge beats the window everywhere (Xin & Wang 2009,
// "Improving Chen and Han's algorithm on the discrete geodesic problem"). Distances change along
// the edge by no more than the length moved, so a window that loses at its end far from a corner
// loses everywhere. Their third comparison, with the face's third corner, drops hardly any window
// here. `ends` and `source` (x and depth) are those behind the edge. This is isBeaten() for both
// ends at once.
inline bool isUseless(TwoDoubles ends, TwoDoubles source, double sigma, const ExitEdge& exit)
{
  const TwoDoubles ways = exit.placeOfEnds + ends * TwoDoubles(-1.0, 1.0);
  const TwoDoubles remaining =
    (exit.distanceAtEnds + ways) * TwoDoubles(1.0 + tolerance::Tie) - TwoDoubles(sigma);
  const TwoDoubles dx = ends - source.firstTwice();
  const TwoDoubles depth = source.secondTwice();
  return (TwoDoubles::isGreater(TwoDoubles(0.0), remaining) |
           TwoDoubles::isGreater(dx * dx + depth * depth, remaining * remaining)) != 0;
}

// Propagates windows with parallel rays, which are rare.
void leaveLinear(const ExitEdge& exit, const Window& w, TwoDoubles ends, WindowListBuilder& list)
{
  const double begin = ends.first();
  const double end = ends.second();
  const Window child =
    exit.isLeft ? exit.face.throughLeft(w, begin, end) : exit.face.throughRight(w, begin, end);
  const bool useless = isBeaten(child, end, exit.distanceAtEnds.second() + end) ||
    isBeaten(child, begin, exit.distanceAtEnds.first() + (exit.length.first() - begin));
  if (!useless)
  {
    list.append(child);
  }
}

// Sends a window through an edge, on the interval there between the ends.
template <bool IsLeft>
inline void leaveThrough(
  const ExitEdge& exit, const Window& w, TwoDoubles ends, WindowListBuilder& list)
{
  if (!(ends.second() - ends.first() > 0.0))
  {
    return;
  }
  if (w.isLinear())
  {
    leaveLinear(exit, w, ends, list);
    return;
  }
  // moved(), but only what changes
  const Vec2 origin = IsLeft ? Vec2{ 0.0, 0.0 } : Vec2(exit.face.apex);
  const TwoDoubles unfolded = TwoDoubles(w.sourceX - origin.x) * exit.rotatedX +
    TwoDoubles(w.sourceDepth + origin.y) * exit.rotatedDepth;
  // Rounding must not make the depth negative.
  const TwoDoubles source = TwoDoubles::raisedTo(TwoDoubles(-Infinity, 0.0), unfolded);
  if (!isUseless(ends, source, w.sigma, exit))
  {
    list.append(w,
      [&](Window& child)
      {
        child.begin = ends.first();
        child.end = ends.second();
        child.sourceX = source.first();
        child.sourceDepth = source.second();
        child.cross(exit.face.number);
        if (exit.hasTurn)
        {
          child.start = RayStart::atAngle(w.start.angle() + w.origin.aroundPoint(exit.turn));
        }
      });
  }
}

// Sends those windows of a queried list through one edge that continue there. Among the windows
// whose pencils contain the apex, only the one that reaches it first continues through both edges.
// Rays of the others that would cross that window's ray to the apex are beaten there (Qin et al.
// 2016).
template <bool IsLeft>
void leaveThroughEdge(
  const ApexQuery& apex, const ExitEdge& exit, Id maximumFacesCrossed, WindowListBuilder& list)
{
  const std::size_t end = IsLeft ? apex.leftEnd : apex.list.size();
  for (std::size_t i = IsLeft ? 0 : apex.rightBegin; i < end; ++i)
  {
    const Window& w = apex.list.first[i];
    const ApexSide side = apex.sides[i];
    if (!(w.sourceDepth > 0.0) || w.facesCrossed >= maximumFacesCrossed)
    {
      continue; // rays along the edge, covered by its vertices; or no shortest path
    }
    const TwoDoubles ends = IsLeft ? endsOnLeft(exit, w) : endsOnRight(exit, w);
    if (side == (IsLeft ? ApexSide::Left : ApexSide::Right))
    {
      leaveThrough<IsLeft>(exit, w, ends, list);
    }
    else if (side == ApexSide::Both && (IsLeft ? i <= apex.first : i >= apex.first))
    {
      leaveThrough<IsLeft>(exit, w,
        IsLeft ? TwoDoubles(ends.first(), exit.length.first()) : TwoDoubles(0.0, ends.second()),
        list);
    }
  }
}

} // anonymous namespace

ApexQuery fullApexQuery(
  WindowRange list, const PointOverHalfedge& apex, std::vector<ApexSide>& sides)
{
  if (sides.size() < list.size())
  {
    sides.resize(list.size());
  }
  ApexQuery query;
  query.list = list;
  query.sides = sides.data();
  query.rightBegin = list.size();
  const auto consider = [&query](double distance, const Window& w)
  {
    if (distance < query.shortest.distance)
    {
      query.shortest = { distance, &w };
    }
  };
  double straight = Infinity;
  ApexSide previous = ApexSide::Left; // as if a window before the first one passed on the left
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    const Window& w = list.first[i];
    const ApexSide side = w.passesRightOf(w.begin, apex) ? ApexSide::Right
      : w.passesRightOf(w.end, apex)                     ? ApexSide::Both
                                                         : ApexSide::Left;
    sides[i] = side;
    query.leftEnd = side == ApexSide::Right ? query.leftEnd : i + 1;
    query.rightBegin = side == ApexSide::Left ? query.rightBegin : std::min(query.rightBegin, i);
    if (side == ApexSide::Both)
    {
      const double distance = w.straightDistance(apex);
      consider(distance, w);
      if (distance < straight)
      {
        straight = distance;
        query.first = i;
      }
    }
    // Between a window that passes on the left and one that passes on the right, the apex lies in a
    // gap.
    if (side == ApexSide::Right && previous == ApexSide::Left)
    {
      consider(w.bentDistance(apex), w);
      if (i > 0)
      {
        consider(list.first[i - 1].bentDistance(apex), list.first[i - 1]);
      }
    }
    if (side == ApexSide::Left && i + 1 == list.size())
    {
      consider(w.bentDistance(apex), w);
    }
    previous = side;
  }
  return query;
}

// A binary search finds the first window that passes on the right.
ApexDistance quickApexQuery(WindowRange list, Vec2 apex)
{
  ApexDistance shortest;
  const auto consider = [&](const Window& w)
  {
    const double distance = w.bentDistance(apex);
    if (distance < shortest.distance)
    {
      shortest = { distance, &w };
    }
  };
  if (list.size() == 1)
  {
    consider(*list.begin());
    return shortest;
  }
  const Window* first = list.begin();
  for (std::size_t count = list.size(); count > 0;)
  {
    const std::size_t half = count / 2;
    const bool isBefore = !first[half].passesRightOf(first[half].begin, apex);
    first = isBefore ? first + half + 1 : first;
    count = isBefore ? count - half - 1 : half;
  }
  if (first != list.end())
  {
    consider(*first);
  }
  // back over the windows that contain the apex, to one that passes on the left
  for (bool holds = true; holds && first != list.begin();)
  {
    --first;
    consider(*first);
    holds = first->passesRightOf(first->end, apex);
  }
  return shortest;
}

void propagateThroughFace(const ApexQuery& apex, const UnfoldedFace& face,
  const CornerDistances& distances, Id maximumFacesCrossed, LeavingWindows& leaving)
{
  leaving.left.reset(face.leftLength);
  leaving.right.reset(face.rightLength);
  if (apex.leftEnd > 0)
  {
    leaveThroughEdge<true>(apex, leftEdge(face, distances), maximumFacesCrossed, leaving.left);
  }
  if (apex.rightBegin < apex.list.size())
  {
    leaveThroughEdge<false>(apex, rightEdge(face, distances), maximumFacesCrossed, leaving.right);
  }
}

}
