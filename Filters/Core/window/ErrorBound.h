// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ErrorBound_h
#define geodesic_ErrorBound_h

#include <cstdint>
#include <cstring>

namespace geodesic
{

/// An upper bound of an error, not negative, in 32 bits: the upper half of a double, rounded up. It
/// has all of a double's range, and is too large by at most a millionth.
class ErrorBound
{
public:
  constexpr ErrorBound() = default;
  ErrorBound(double error) // NOLINT(google-explicit-constructor): a bound is a number
  {
    std::uint64_t bits;
    std::memcpy(&bits, &error, sizeof(bits));
    this->bits_ = static_cast<std::uint32_t>((bits + 0xffffffffU) >> 32);
  }
  operator double() const // NOLINT(google-explicit-constructor)
  {
    const std::uint64_t bits = std::uint64_t(this->bits_) << 32;
    double error;
    std::memcpy(&error, &bits, sizeof(error));
    return error;
  }

private:
  std::uint32_t bits_ = 0;
};

}

#endif
