// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SegmentEnvelope_h
#define geodesic_SegmentEnvelope_h

#include "field/FaceDistance.h"
#include "window/WindowList.h"

#include <vector>

namespace geodesic
{

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

private:
  double chooseNear(const FaceDistance& face, Vec2 middle, double length);
  bool build(Vec2 p, Vec2 u, double length, bool withBent);

  std::vector<const DistanceCandidate*> near_;
  std::vector<double> inMiddle_;
  std::vector<Window> pieces_;
  WindowListBuilder builder_;
  std::vector<Window> envelope_;
};

/// A place where the distance along a segment passes a value.
struct SegmentCrossing
{
  /// From the segment's begin.
  double at;
  /// Whether it is below the value before, and above behind.
  bool rises;
};

/// Finds the places of a segment where the distance passes a value, in their order (paper, equation
/// 1 and section 4.2.2, solved for the place). They alternate between rising and falling and agree
/// with the arguments about the ends, in spite of roundings.
///
/// \param envelope the distance along the segment, see SegmentEnvelope; may be empty where the
///        segment has hardly any length.
/// \param beginsBelow whether the distance at the begin counts as below the value.
/// \param endsBelow the same at the end.
/// \param result is appended to.
void findCrossings(const std::vector<Window>& envelope, double value, bool beginsBelow,
  bool endsBelow, std::vector<SegmentCrossing>& result);

}

#endif
