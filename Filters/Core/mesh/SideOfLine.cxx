// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/SideOfLine.h"

#include "Tolerance.h"

#include <array>
#include <cmath>
#include <utility>

namespace geodesic
{

namespace
{

/// A sum of doubles without rounding: its terms do not overlap, and the last one that is not zero
/// has its sign.
class ExactSum
{
public:
  /// Adds a * b.
  void addProduct(double a, double b)
  {
    const double product = a * b;
    const auto [aHigh, aLow] = halves(a);
    const auto [bHigh, bLow] = halves(b);
    this->add(aLow * bLow - (((product - aHigh * bHigh) - aLow * bHigh) - aHigh * bLow));
    this->add(product);
  }

  int sign() const
  {
    for (std::size_t i = this->size_; i-- > 0;)
    {
      if (this->terms_[i] != 0.0)
      {
        return this->terms_[i] > 0.0 ? 1 : -1;
      }
    }
    return 0;
  }

private:
  /// Two numbers of half as many digits.
  static std::pair<double, double> halves(double a)
  {
    const double shifted = 0x1.0000002p27 * a;
    const double high = shifted - (shifted - a);
    return { high, a - high };
  }

  void add(double term)
  {
    for (std::size_t i = 0; i < this->size_; ++i)
    {
      const double other = this->terms_[i];
      const double sum = term + other;
      const double ofOther = sum - term;
      this->terms_[i] = (term - (sum - ofOther)) + (other - ofOther);
      term = sum;
    }
    this->terms_[this->size_++] = term;
  }

  std::array<double, 12> terms_{};
  std::size_t size_ = 0;
};

} // anonymous namespace

int sideOfLine(const Vec2& a, const Vec2& b, const Vec2& c)
{
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double difference = left - right;
  // Three subtractions and a product, each with half a rounding.
  if (std::abs(difference) > 2.0 * tolerance::Rounding * (std::abs(left) + std::abs(right)))
  {
    return difference > 0.0 ? 1 : -1;
  }
  ExactSum sum;
  sum.addProduct(a.x, b.y);
  sum.addProduct(-a.y, b.x);
  sum.addProduct(b.x, c.y);
  sum.addProduct(-b.y, c.x);
  sum.addProduct(c.x, a.y);
  sum.addProduct(-c.y, a.x);
  return sum.sign();
}

}
