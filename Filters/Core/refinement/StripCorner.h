// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_StripCorner_h
#define geodesic_StripCorner_h

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace geodesic
{

/// A corner of a thin triangle while one of its two sides is cut into pieces: how long these may
/// be, so that the strip between the sides has no small angles. Ways are lengths from the corner.
///
/// In a corner with the angle b the strip is as wide as b times the way. If one side has points at
/// the ways p and q, and the other one none between them but one at p, too, a triangle of the strip
/// has the angle b p / (q - p), which is b / (growth - 1) for q = growth p. So the way to a point
/// may be the way to the last one on the other side times the growth. If the sides take turns, the
/// ways on each side grow by the square of that.
class StripCorner
{
public:
  /// \param growth more than 1.
  /// \param opposite the ways of the other side's points, ascending.
  StripCorner(double growth, std::vector<double> opposite)
    : growth_(growth)
    , opposite_(std::move(opposite))
  {
  }

  /// Where a piece may end that leads away from the corner.
  ///
  /// \param last where it begins.
  /// \param next where it would end.
  double away(double last, double next) const
  {
    double own = last;
    double other = 0.0;
    for (const double way : this->opposite_)
    {
      if (way >= next)
      {
        break;
      }
      if (way > last && own > 0.0 && way > this->growth_ * own)
      {
        next = way; // which needs a point on this side
        break;
      }
      own = own > 0.0 ? own : way;
      other = way;
    }
    const double most = this->growth_ * (this->growth_ * other > last ? other : last);
    return most > 0.0 ? std::min(next, most) : next;
  }

  /// The same for a piece that leads towards the corner.
  double towards(double last, double next) const
  {
    double other = this->growth_ * last;
    for (auto way = this->opposite_.rbegin(); way != this->opposite_.rend(); ++way)
    {
      if (*way <= next)
      {
        break;
      }
      if (*way * this->growth_ < last)
      {
        next = *way;
        break;
      }
      other = *way;
    }
    const double least = (other < this->growth_ * last ? other : last) / this->growth_;
    return next > 0.0 ? std::max(next, least) : next;
  }

private:
  double growth_;
  std::vector<double> opposite_;
};

/// The corners at the ends of an edge.
using StripCorners = std::array<std::vector<StripCorner>, 2>;

}

#endif
