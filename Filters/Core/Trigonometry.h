// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Trigonometry_h
#define geodesic_Trigonometry_h

#include "Types.h"

#include <algorithm>
#include <cmath>

/// Angles by sums, products, quotients and roots alone, whose bits are the same everywhere. The
/// last bits of std::atan2, std::sin and so on depend on the system and on the processor: the GNU C
/// library has a second version of each for processors with fused multiply-add.
namespace geodesic
{

/// The angle of a vector in [-pi, pi], as std::atan2(v.y, v.x), within two units in the last place.
inline double polarAngle(Vec2 v)
{
  // The angles of the vectors (4, 0), (4, 1) ... (4, 4), (3, 4) ... (0, 4).
  constexpr double Angles[] = { 0.0, 0.24497866312686414, 0.46364760900080609, 0.64350110879328437,
    0.78539816339744828, 0.92729521800161219, 1.1071487177940904, 1.3258176636680326, RightAngle };

  const double x = std::abs(v.x);
  const double y = std::abs(v.y);
  const bool isSteep = y > x;
  const double high = std::max(x, y);
  const double low = std::min(x, y);
  // The tangent of the angle to the nearest of the vectors is at most 1/8.
  const int nearest = (8.0 * low > high ? 1 : 0) + (8.0 * low > 3.0 * high ? 1 : 0) +
    (8.0 * low > 5.0 * high ? 1 : 0) + (8.0 * low > 7.0 * high ? 1 : 0);
  const double t = high > 0.0 ? (4.0 * low - nearest * high) / (4.0 * high + nearest * low) : 0.0;
  const double q = t * t;
  // Its series t - t^3 / 3 + t^5 / 5 - ... to t^17.
  double series = 1.0 / 17;
  for (int k = 15; k > 1; k -= 2)
  {
    series = 1.0 / k - q * series;
  }
  const double rest = t - t * q * series;
  const double inQuadrant = isSteep ? Angles[8 - nearest] - rest : Angles[nearest] + rest;
  return std::copysign(std::signbit(v.x) ? Pi - inQuadrant : inQuadrant, v.y);
}

/// The cosine and the sine of an angle of a few turns at most, within two units in the last place,
/// or within 1e-24, which is more near their zeros.
inline Vec2 unitVector(double angle)
{
  // A right angle in two parts. The first has 33 binary digits: its multiples are exact.
  constexpr double Upper = 1.5707963267341256;
  constexpr double Lower = 6.077100506506192e-11;

  const double quarters = std::floor(angle / RightAngle + 0.5);
  const double rest = angle - quarters * Upper - quarters * Lower;
  const double q = rest * rest;
  // Taylor's series, by the quotients of consecutive terms.
  Vec2 v = { 1.0, 1.0 };
  for (int k = 17; k > 0; k -= 2)
  {
    v.x = 1.0 - q * (1.0 / (k * (k + 1))) * v.x;
    v.y = 1.0 - q * (1.0 / ((k + 1) * (k + 2))) * v.y;
  }
  v.y *= rest;
  switch (static_cast<int>(quarters) & 3)
  {
    case 0:
      return v;
    case 1:
      return { -v.y, v.x };
    case 2:
      return { -v.x, -v.y };
    default:
      return { v.y, -v.x };
  }
}

inline double tangent(double angle)
{
  const Vec2 v = unitVector(angle);
  return v.y / v.x;
}

/// The angle in [-pi / 2, pi / 2] with a sine in [-1, 1].
inline double arcSine(double sine)
{
  return polarAngle({ std::sqrt((1.0 - sine) * (1.0 + sine)), sine });
}

}

#endif
