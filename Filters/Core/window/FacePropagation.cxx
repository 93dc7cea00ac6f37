// SPDX-License-Identifier: BSD-3-Clause
#include "window/FacePropagation.h"

namespace geodesic
{

namespace
{

/// An edge that windows leave through, with what is known at its ends.
struct ExitEdge
{
  /// The edge's direction in the face, where it begins, and its length.
  Vec2 axis;
  Vec2 origin;
  double length;
  /// The distances known where the edge begins and where it ends.
  double atBegin;
  double atEnd;
};

// Whether a path through an end of the edge beats the window everywhere (Xin & Wang 2009,
// "Improving Chen and Han's algorithm on the discrete geodesic problem"). Distances along the edge
// change by no more than the way, so a window that is longer at its end far from a corner is longer
// throughout. Their third comparison, with the face's third corner, drops next to nothing here.
inline bool isUseless(const Window& w, const ExitEdge& exit)
{
  return isBeaten(w, w.end, exit.atBegin + w.end) ||
    isBeaten(w, w.begin, exit.atEnd + (exit.length - w.begin));
}

inline void leaveThrough(
  const ExitEdge& exit, const Window& w, double begin, double end, WindowListBuilder& list)
{
  if (end - begin > 0.0)
  {
    Window child = moved(w, exit.origin, exit.axis);
    child.begin = begin;
    child.end = end;
    if (!isUseless(child, exit))
    {
      list.append(child);
    }
  }
}

} // anonymous namespace

// Of the windows whose pencils hold the apex only the one that reaches it first goes to both edges:
// rays of the others that would cross its ray to the apex are beaten there (Qin et al. 2016).
void propagateThroughFace(const ApexQuery& apex, const UnfoldedFace& face,
  const CornerDistances& distances, OpenEdges open, Id maximumFacesCrossed, LeavingWindows& leaving)
{
  const ExitEdge left = { face.leftAxis, { 0.0, 0.0 }, face.leftLength, distances.origin,
    distances.apex };
  const ExitEdge right = { face.rightAxis, face.apex, face.rightLength, distances.apex,
    distances.destination };
  leaving.left.reset(face.leftLength);
  leaving.right.reset(face.rightLength);
  for (std::size_t i = 0; i < apex.list.size(); ++i)
  {
    const Window& w = apex.list.first[i];
    if (!(w.sourceDepth > 0.0) || w.facesCrossed >= maximumFacesCrossed)
    {
      continue; // rays along the edge, which its vertices stand for; or no shortest path
    }
    const ApexSide side = apex.sides[i];
    if (open.left && (side == ApexSide::Left || (side == ApexSide::Both && i <= apex.first)))
    {
      const double end = side == ApexSide::Left ? face.meetLeft(w, w.end) : face.leftLength;
      leaveThrough(left, w, face.meetLeft(w, w.begin), end, leaving.left);
    }
    if (open.right && (side == ApexSide::Right || (side == ApexSide::Both && i >= apex.first)))
    {
      const double begin = side == ApexSide::Right ? face.meetRight(w, w.begin) : 0.0;
      leaveThrough(right, w, begin, face.meetRight(w, w.end), leaving.right);
    }
  }
}

}
