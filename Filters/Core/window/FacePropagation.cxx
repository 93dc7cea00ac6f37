// SPDX-License-Identifier: BSD-3-Clause
#include "window/FacePropagation.h"

#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

UnfoldedFace unfold(const TriangleMesh& mesh, Id halfedge)
{
  const FaceShape& shape = mesh.shape(TriangleMesh::faceOf(halfedge));
  const std::size_t k = halfedge % 3;
  const std::size_t next = (k + 1) % 3;
  UnfoldedFace face;
  face.length = shape.length[k];
  face.rightLength = shape.length[next];
  face.leftLength = shape.length[(k + 2) % 3];
  face.apex = { shape.cornerDot[k] / face.length, shape.area2 / face.length };
  face.apexFromEnd = shape.cornerDot[next] / face.length;
  // An edge without length carries no window; any axis will do.
  face.leftAxis = face.leftLength > 0.0 ? (1.0 / face.leftLength) * face.apex : Vec2{ 1.0, 0.0 };
  face.rightAxis = face.rightLength > 0.0
    ? (1.0 / face.rightLength) * Vec2{ face.apexFromEnd, -face.apex.y }
    : Vec2{ 1.0, 0.0 };
  return face;
}

ApexDistance FacePropagation::view(const WindowRange& list, Vec2 apex)
{
  this->passes_.resize(list.size());
  this->best_ = None;
  ApexDistance view;
  const Window* nearest = nullptr;
  const auto take = [&view, &nearest](double distance, const Window& w)
  {
    if (distance < view.distance)
    {
      view.distance = distance;
      nearest = &w;
    }
  };
  double straight = Infinity;
  Pass previous = Pass::Left; // as if a window before the first one passed on the left
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    const Window& w = list.first[i];
    const Pass pass = w.passesRightOf(w.begin, apex) ? Pass::Right
      : w.passesRightOf(w.end, apex)                 ? Pass::Both
                                                     : Pass::Left;
    this->passes_[i] = pass;
    if (pass == Pass::Both)
    {
      const double distance = w.straightDistance(apex);
      take(distance, w);
      if (distance < straight)
      {
        straight = distance;
        this->best_ = i;
      }
    }
    // Between a window that passes on the left and one on the right, the apex is in a gap.
    if (pass == Pass::Right && previous == Pass::Left)
    {
      take(w.bentDistance(apex), w);
      if (i > 0)
      {
        take(list.first[i - 1].bentDistance(apex), list.first[i - 1]);
      }
    }
    if (pass == Pass::Left && i + 1 == list.size())
    {
      take(w.bentDistance(apex), w);
    }
    previous = pass;
  }
  if (nearest != nullptr)
  {
    view.crossing = nearest->crossing(apex);
    view.error = nearest->error;
    view.origin = nearest->origin;
    view.direction = nearest->direction(view.crossing);
  }
  return view;
}

// The first window that passes on the right is looked for by halving.
ApexDistance quickApexDistance(const WindowRange& list, Vec2 apex)
{
  const Window* first = list.begin();
  for (std::size_t count = list.size(); count > 0;)
  {
    const std::size_t half = count / 2;
    const bool isBefore = !first[half].passesRightOf(first[half].begin, apex);
    first = isBefore ? first + half + 1 : first;
    count = isBefore ? count - half - 1 : half;
  }
  ApexDistance view;
  const auto take = [&view, apex](const Window& w)
  {
    const double distance = w.bentDistance(apex);
    if (distance < view.distance)
    {
      const double x = w.crossing(apex);
      view = { distance, x, w.error, w.origin, w.direction(x) };
    }
  };
  if (first != list.end())
  {
    take(*first);
  }
  // back over those that hold the apex, to one that passes on the left
  for (bool holds = true; holds && first != list.begin();)
  {
    --first;
    take(*first);
    holds = first->passesRightOf(first->end, apex);
  }
  return view;
}

namespace
{

/// An edge that windows leave through, with what is known at its ends.
struct Exit
{
  /// The edge's direction in the face, where it begins, and its length.
  Vec2 axis;
  Vec2 origin;
  double length;
  /// Distances at the begin and the end of the leaving frame.
  double atBegin;
  double atEnd;
};

// Whether a path through an end of the edge beats the window everywhere (Xin & Wang 2009,
// "Improving Chen and Han's algorithm on the discrete geodesic problem"). Distances along the edge
// change by no more than the way, so a window that is longer at its end far from a corner is longer
// throughout. Their third comparison, with the face's third corner, drops next to nothing here.
inline bool isUseless(const Window& w, const Exit& exit)
{
  return isBeaten(w, w.end, exit.atBegin + w.end) ||
    isBeaten(w, w.begin, exit.atEnd + (exit.length - w.begin));
}

inline void leave(
  const Window& w, double begin, double end, const Exit& exit, WindowListBuilder& list)
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

// Of the windows that hold the apex only the one that reaches it first goes to both edges: rays of
// the others that would cross its ray to the apex are beaten there (Qin et al. 2016).
void FacePropagation::pass(const WindowRange& list, const UnfoldedFace& face,
  const CornerDistances& distances, bool toLeft, bool toRight, Id maximumFacesCrossed)
{
  const Exit left = { face.leftAxis, { 0.0, 0.0 }, face.leftLength, distances.origin,
    distances.apex };
  const Exit right = { face.rightAxis, face.apex, face.rightLength, distances.apex,
    distances.destination };
  this->left_.reset(face.leftLength);
  this->right_.reset(face.rightLength);
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    const Window& w = list.first[i];
    if (!(w.sourceDepth > 0.0) || w.depth >= maximumFacesCrossed)
    {
      continue; // rays along the edge, which its vertices stand for; or no shortest path
    }
    const Pass pass = this->passes_[i];
    if (toLeft && (pass == Pass::Left || (pass == Pass::Both && i <= this->best_)))
    {
      const double end = pass == Pass::Left ? face.meetLeft(w, w.end) : face.leftLength;
      leave(w, face.meetLeft(w, w.begin), end, left, this->left_);
    }
    if (toRight && (pass == Pass::Right || (pass == Pass::Both && i >= this->best_)))
    {
      const double begin = pass == Pass::Right ? face.meetRight(w, w.begin) : 0.0;
      leave(w, begin, face.meetRight(w, w.end), right, this->right_);
    }
  }
}

}
