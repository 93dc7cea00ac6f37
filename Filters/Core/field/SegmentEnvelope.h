// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SegmentEnvelope_h
#define geodesic_SegmentEnvelope_h

#include "field/FaceDistance.h"
#include "window/WindowList.h"

#include <vector>

namespace geodesic
{

/// A place where the distance along a segment passes a value.
struct SegmentCrossing
{
  /// From the segment's begin.
  double at;
  /// Whether it is below the value before, and above behind.
  bool rises;
};

/// Builds the exact piecewise distance along any segment of a face: a segment splits a pencil of
/// rays as an edge does, so that no propagation is needed (paper, section 6). One face suffices for
/// its own edges, too.
///
/// Reuses its memory for the next segment.
class SegmentEnvelope
{
public:
  /// The distance along the segment from p to q in the plane of the face: windows that meet without
  /// gaps, from x = 0 at p to x = |q - p|. Their values are not below the distance, but for
  /// rounding. Empty if p is q. Valid until the next call.
  const std::vector<Window>& along(const FaceDistance& face, Vec2 p, Vec2 q);

  /// The least distance along the segment from p to q, if it is below the value. If not, the result
  /// is not below the value either.
  double least(const FaceDistance& face, Vec2 p, Vec2 q, double value = Infinity);

  /// Finds the places of the segment from p to q where the distance passes a value, in their order.
  /// They alternate between rising and falling and agree with the arguments about the ends, in
  /// spite of roundings.
  ///
  /// \param beginsBelow whether the distance at p counts as below the value.
  /// \param endsBelow the same at q.
  /// \param result is appended to.
  void findCrossings(const FaceDistance& face, Vec2 p, Vec2 q, double value, bool beginsBelow,
    bool endsBelow, std::vector<SegmentCrossing>& result);

private:
  /// Where the distance along the segment is below a value.
  struct Sublevel
  {
    double begin;
    double end;
    /// Whether the distance is the value there.
    bool beginsAtValue;
    bool endsAtValue;
  };

  void cutNear(Vec2 p, Vec2 u, double length, bool withBent);
  void buildFrom(std::size_t first, std::size_t last, double length);
  bool build(Vec2 p, Vec2 u, double length, bool withBent);
  bool findSublevels(double length, double value);
  bool isBelow(double x) const;

  NearCandidates near_;
  std::vector<Window> pieces_;
  WindowListBuilder builder_;
  std::vector<Window> envelope_;
  std::vector<Sublevel> inPieces_;
  std::vector<Sublevel> sublevels_;
};

}

#endif
