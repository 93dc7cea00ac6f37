// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RoundNumbers_h
#define geodesic_RoundNumbers_h

#include <array>
#include <locale>
#include <sstream>
#include <string>

namespace geodesic
{

/// 1, 2, 5 and 10 times the power of ten that a positive, finite length begins with. Digits are
/// read as text, so that the numbers are those that one would type, on every system.
inline std::array<double, 4> roundNumbersAround(double length)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::scientific << length;
  const std::string power = text.str().substr(text.str().find('e'));
  const auto times = [&power](const char* digits) { return std::stod(digits + power); };
  return { times("1"), times("2"), times("5"), times("10") };
}

}

#endif
