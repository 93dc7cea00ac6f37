// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TwoDoubles_h
#define geodesic_TwoDoubles_h

#include <array>
#include <cmath>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace geodesic
{

/// Two numbers with the same operations, such as the two ends of an interval. SSE2, which every
/// x86-64 processor has, takes one instruction for both. The bits are those of scalar arithmetic.
class TwoDoubles
{
#if defined(__SSE2__)
  using Values = __m128d;
#else
  using Values = std::array<double, 2>;
#endif

public:
  TwoDoubles() = default;
  TwoDoubles(double first, double second)
    : values_{ first, second }
  {
  }
  explicit TwoDoubles(double both)
    : values_{ both, both }
  {
  }

  double first() const
  {
    return this->values_[0];
  }
  double second() const
  {
    return this->values_[1];
  }
  TwoDoubles firstTwice() const
  {
    return TwoDoubles(this->first());
  }
  TwoDoubles secondTwice() const
  {
    return TwoDoubles(this->second());
  }

#if defined(__SSE2__)
  friend TwoDoubles operator+(TwoDoubles a, TwoDoubles b)
  {
    return _mm_add_pd(a.values_, b.values_);
  }
  friend TwoDoubles operator-(TwoDoubles a, TwoDoubles b)
  {
    return _mm_sub_pd(a.values_, b.values_);
  }
  friend TwoDoubles operator*(TwoDoubles a, TwoDoubles b)
  {
    return _mm_mul_pd(a.values_, b.values_);
  }
  friend TwoDoubles operator/(TwoDoubles a, TwoDoubles b)
  {
    return _mm_div_pd(a.values_, b.values_);
  }

  static TwoDoubles roots(TwoDoubles squares)
  {
    return _mm_sqrt_pd(squares.values_);
  }
  /// The value if the condition is positive, else 0.
  static TwoDoubles wherePositive(TwoDoubles condition, TwoDoubles value)
  {
    return _mm_and_pd(_mm_cmplt_pd(_mm_setzero_pd(), condition.values_), value.values_);
  }
  /// The larger of value and bound.
  static TwoDoubles raisedTo(TwoDoubles bound, TwoDoubles value)
  {
    return _mm_max_pd(bound.values_, value.values_);
  }
  static TwoDoubles clampedToUnit(TwoDoubles t)
  {
    return _mm_min_pd(_mm_set1_pd(1.0), _mm_max_pd(_mm_setzero_pd(), t.values_));
  }
  /// The sum of 1 if a > b for the first numbers and 2 if a > b for the second.
  static unsigned isGreater(TwoDoubles a, TwoDoubles b)
  {
    return static_cast<unsigned>(_mm_movemask_pd(_mm_cmpgt_pd(a.values_, b.values_)));
  }

private:
  TwoDoubles(Values values)
    : values_(values)
  {
  }
#else
  friend TwoDoubles operator+(TwoDoubles a, TwoDoubles b)
  {
    return { a.first() + b.first(), a.second() + b.second() };
  }
  friend TwoDoubles operator-(TwoDoubles a, TwoDoubles b)
  {
    return { a.first() - b.first(), a.second() - b.second() };
  }
  friend TwoDoubles operator*(TwoDoubles a, TwoDoubles b)
  {
    return { a.first() * b.first(), a.second() * b.second() };
  }
  friend TwoDoubles operator/(TwoDoubles a, TwoDoubles b)
  {
    return { a.first() / b.first(), a.second() / b.second() };
  }

  static TwoDoubles roots(TwoDoubles squares)
  {
    return { std::sqrt(squares.first()), std::sqrt(squares.second()) };
  }
  static TwoDoubles wherePositive(TwoDoubles condition, TwoDoubles value)
  {
    return { condition.first() > 0.0 ? value.first() : 0.0,
      condition.second() > 0.0 ? value.second() : 0.0 };
  }
  static TwoDoubles raisedTo(TwoDoubles bound, TwoDoubles value)
  {
    return { bound.first() > value.first() ? bound.first() : value.first(),
      bound.second() > value.second() ? bound.second() : value.second() };
  }
  static TwoDoubles clampedToUnit(TwoDoubles t)
  {
    const auto clamped = [](double x)
    {
      const double raised = 0.0 > x ? 0.0 : x;
      return 1.0 < raised ? 1.0 : raised;
    };
    return { clamped(t.first()), clamped(t.second()) };
  }
  static unsigned isGreater(TwoDoubles a, TwoDoubles b)
  {
    return (a.first() > b.first() ? 1U : 0U) | (a.second() > b.second() ? 2U : 0U);
  }

private:
#endif
  Values values_;
};

}

#endif
