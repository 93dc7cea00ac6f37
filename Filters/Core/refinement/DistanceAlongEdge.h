// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DistanceAlongEdge_h
#define geodesic_DistanceAlongEdge_h

#include "refinement/Deviation.h"

#include <array>
#include <vector>

namespace geodesic
{

/// The distance along an edge of a mesh under refinement, which all parts of the edge share: the
/// windows of a part are those within the part's ends. Places are lengths from the edge's begin.
///
/// In an approximate field the faces around an edge may have different distances on it.
class DistanceAlongEdge
{
public:
  /// \param envelope the distance according to one more face, as SegmentEnvelope finds it.
  /// \param atBegin the distance there, for an edge without length.
  void add(const std::vector<Window>& envelope, double atBegin);

  /// The largest deviations of any face from the line between two places, with their places as
  /// fractions of the way.
  ///
  /// \param ends the values at both places; each face has its own if this is null.
  Deviation deviation(double from, double to, const std::array<double, 2>* ends) const;
  /// Places that cut a part into the fewest pieces within the tolerance, ascending; none if there
  /// would be hundreds. If one cut suffices at the largest deviation, such as a kink, it is there;
  /// else deviations of the pieces are about equal.
  std::vector<double> cuts(double from, double to, double tolerance) const;

private:
  double furthest(double from, double to, double guess, double tolerance) const;
  std::vector<double> stepsWithin(double from, double to, double tolerance, std::size_t most) const;
  bool isWithin(double from, double to, double tolerance) const
  {
    return this->deviation(from, to, nullptr).largest() <= tolerance;
  }
  std::vector<double> evenCuts(
    double from, double to, double tolerance, const std::vector<double>& forward) const;

  std::vector<std::vector<Window>> ofFaces_;
};

}

#endif
