// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FacePropagation_h
#define geodesic_FacePropagation_h

#include "Tolerance.h"
#include "mesh/HalfedgeFrame.h"
#include "mesh/TriangleMesh.h"
#include "window/Window.h"
#include "window/WindowList.h"

#include <vector>

namespace geodesic
{

/// The halfedge's face laid into the plane above the halfedge. The halfedge must have a length.
UnfoldedFace unfold(const TriangleMesh& mesh, Id halfedge);

/// Whether the window's distance at x is beyond a bound by more than a tie, told without a square
/// root.
inline bool isBeaten(const Window& w, double x, double bound)
{
  const double reach = bound * (1.0 + tolerance::Tie) - w.sigma;
  const double dx = x - w.sourceX;
  return w.isLinear() ? w.sourceX * x > reach
                      : reach < 0.0 || dx * dx + w.sourceDepth * w.sourceDepth > reach * reach;
}

/// What is known of the distances at the corners of a face, seen from the halfedge that is entered.
struct CornerDistances
{
  double origin;
  double destination;
  double apex;
};

/// The apex as seen through a list of windows.
struct ApexDistance
{
  /// Least length of a path through the list to the apex, bent ones included, where it crosses the
  /// halfedge, and the error of the window that gives it.
  double distance = Infinity;
  double crossing = 0.0;
  double error = 0.0;
  /// The origin of that window, and the direction of its ray there.
  Id origin = NoId;
  Vec2 direction = {};
};

/// The apex as seen at a quickApexDistance through a sorted list: where rays of several windows
/// cross below it, a shorter path may be overlooked. Enough to tell when the front comes to the
/// apex; then the whole list is looked at.
ApexDistance quickApexDistance(const WindowRange& list, Vec2 apex);

/// How a list of windows goes through a face (paper, sections 3.2 and 4.2.1; as a list after Qin et
/// al. 2016, "Fast and exact discrete geodesic computation based on triangle-oriented wavefront
/// propagation"). One is reused for many faces.
class FacePropagation
{
public:
  /// Looks at the apex through every window of a sorted list.
  ApexDistance view(const WindowRange& list, Vec2 apex);

  /// Sends the list that was viewed last through the face. Windows that a path through a corner
  /// beats are dropped.
  ///
  /// \param maximumFacesCrossed windows that have crossed so many faces are dropped: a shortest
  /// path crosses
  ///        none twice.
  void pass(const WindowRange& list, const UnfoldedFace& face, const CornerDistances& distances,
    bool toLeft, bool toRight, Id maximumFacesCrossed);

  /// The windows that left through the edge from the halfedge's origin to the apex, and through the
  /// one from the apex to the halfedge's destination, in the leaving frames.
  WindowRange left() const { return this->left_.range(); }
  WindowRange right() const { return this->right_.range(); }

private:
  /// Where the rays of a window pass the apex.
  enum class Pass : std::uint8_t
  {
    Left,
    Right,
    Both
  };

  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  std::vector<Pass> passes_;
  /// The window that holds the apex in its pencil at the least distance.
  std::size_t best_ = None;
  WindowListBuilder left_;
  WindowListBuilder right_;
};

}

#endif
