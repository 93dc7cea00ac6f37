// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FacePropagation_h
#define geodesic_FacePropagation_h

#include "Tolerance.h"
#include "window/UnfoldedFace.h"
#include "window/Window.h"
#include "window/WindowList.h"

#include <vector>

namespace geodesic
{

/// Whether the window's distance at x exceeds a bound by more than a tie, without a square root.
inline bool isBeaten(const Window& w, double x, double bound)
{
  const double remaining = bound * (1.0 + tolerance::Tie) - w.sigma;
  const double dx = x - w.sourceX;
  return w.isLinear()
    ? w.sourceX * x > remaining
    : remaining < 0.0 || dx * dx + w.sourceDepth * w.sourceDepth > remaining * remaining;
}

/// The shortest path to the apex of a face through a list of windows on the opposite halfedge. The
/// path bends if no window's pencil contains the apex.
struct ApexDistance
{
  /// Its length; infinite where the list is empty.
  double distance = Infinity;
  /// The window of the list that gives the path; null where the list is empty.
  const Window* nearest = nullptr;
};

/// On which side of the apex the rays of a window pass.
enum class ApexSide : std::uint8_t
{
  Left,
  Right,
  /// The pencil contains the apex.
  Both
};

struct ApexQuery
{
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  ApexDistance shortest;
  /// The queried list, and the side of each of its windows.
  WindowRange list;
  const ApexSide* sides = nullptr;
  /// The window that reaches the apex first among those whose pencils contain it; None if there is
  /// none.
  std::size_t first = None;
  /// Before this window rays pass on the left, from the other one on rays pass on the right.
  std::size_t leftEnd = 0;
  std::size_t rightBegin = 0;
};

/// The full query of the apex: checks every window of a sorted list.
///
/// \param sides the sides of the windows, to which the result refers; replaced, and never made
///        shorter.
ApexQuery fullApexQuery(
  WindowRange list, const PointOverHalfedge& apex, std::vector<ApexSide>& sides);

/// The quick query of the apex: checks only the windows near it, in logarithmic time. Where rays of
/// several windows cross below the apex, it may miss a shorter path. It suffices to decide when the
/// front comes to the apex, where the full query follows.
ApexDistance quickApexQuery(WindowRange list, Vec2 apex);

/// The known distances at the corners of a face: at the ends of the entered halfedge and at the
/// apex.
struct CornerDistances
{
  double origin;
  double destination;
  double apex;
};

/// The windows that have left a face through its left and right edges, in the frames of
/// UnfoldedFace::throughLeft() and throughRight(). One object serves many faces.
struct LeavingWindows
{
  WindowListBuilder left;
  WindowListBuilder right;
};

/// Sends a sorted list of windows through a face (paper, sections 3.2 and 4.2.1; as a list after
/// Qin et al. 2016, "Fast and exact discrete geodesic computation based on triangle-oriented
/// wavefront propagation"). Drops windows that a path through a corner beats.
///
/// \param apex the result of the full query for the list; it refers to the list.
/// \param distances at most what the list itself gives: along the halfedge at its ends, and by the
///        query at the apex.
/// \param maximumFacesCrossed windows that have crossed this many faces are dropped: a shortest
///        path crosses no face twice.
/// \param leaving the windows behind both edges, also where no face is; replaced.
void propagateThroughFace(const ApexQuery& apex, const UnfoldedFace& face,
  const CornerDistances& distances, Id maximumFacesCrossed, LeavingWindows& leaving);

}

#endif
