// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PowerOfTwoScale_h
#define geodesic_PowerOfTwoScale_h

#include "Errors.h"
#include "Types.h"

#include <cmath>

namespace geodesic
{

/// The power of two by which lengths are multiplied on their way to the engine, and divided on
/// their way back. The engine forms fourth powers of lengths (squares of areas), which leave the
/// range of doubles where coordinates are around 1e-80 or 1e80: such surfaces are brought to a size
/// of about 1. A power of two changes no digit.
class PowerOfTwoScale
{
public:
  PowerOfTwoScale() = default;
  /// 1 for ordinary sizes.
  ///
  /// \param largest the largest absolute coordinate of the surface.
  explicit PowerOfTwoScale(double largest)
  {
    // Sixth powers of this and of its inverse are in range, with room for edges that are shorter.
    constexpr double ordinary = 0x1p100;
    if (largest > 0.0 && (largest > ordinary || largest < 1.0 / ordinary))
    {
      this->exponent_ = -std::ilogb(largest);
    }
  }

  double toEngine(double length) const { return std::ldexp(length, this->exponent_); }
  double toUser(double length) const { return std::ldexp(length, -this->exponent_); }
  Vec3 toEngine(const Vec3& p) const
  {
    return { this->toEngine(p[0]), this->toEngine(p[1]), this->toEngine(p[2]) };
  }
  Vec3 toUser(const Vec3& p) const
  {
    return { this->toUser(p[0]), this->toUser(p[1]), this->toUser(p[2]) };
  }
  /// The same for a distance, which may be infinite.
  ///
  /// \throws MeshError where a finite one becomes infinite.
  double distanceToUser(double length) const
  {
    const double result = this->toUser(length);
    if (length < Infinity && !(result < Infinity))
    {
      throw MeshError(
        "Distances on the surface (input port 0) are larger than numbers can be. Scale "
        "all inputs upstream.");
    }
    return result;
  }
  bool isOne() const { return this->exponent_ == 0; }

private:
  int exponent_ = 0;
};

}

#endif
