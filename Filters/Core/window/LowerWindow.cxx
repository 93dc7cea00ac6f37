// SPDX-License-Identifier: BSD-3-Clause
#include "window/LowerWindow.h"

#include "Tolerance.h"
#include <cmath>
#include <utility>

namespace geodesic
{

namespace
{

// The roots of a t^2 + 2 b t + c, with t from `origin`. The caller gives the discriminant b^2 - a c
// in a form without cancellation; the textbook formula for the roots would introduce it again.
Crossings quadraticRoots(double a, double b, double c, double discriminant, double origin)
{
  Crossings roots;
  if (!(discriminant >= 0.0))
  {
    return roots;
  }
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  if (q != 0.0)
  {
    roots.at[static_cast<std::size_t>(roots.count++)] = origin + c / q;
  }
  if (a != 0.0)
  {
    roots.at[static_cast<std::size_t>(roots.count++)] = origin + q / a;
  }
  return roots;
}

// The points of equal distance form one branch of a hyperbola, which a line meets up to twice.
// (Section 3.3 has one crossing, which is true only for equal sigma, where the two roots coincide.)
// With t from the source of `a`, whose own distance is r, the other one's is r + beta; the
// difference of their squares says beta r = g - d t, and squared it is a quadratic in t. `a` is the
// window with the smaller depth: where the way from the other source passes it, or nearly so, all
// coefficients are small, and from here none of them is the difference of large numbers.
Crossings circularCircular(const Window& first, const Window& second)
{
  const bool isFirstLess = first.sourceDepth < second.sourceDepth;
  const Window& a = isFirstLess ? first : second;
  const Window& b = isFirstLess ? second : first;
  const double d = b.sourceX - a.sourceX;
  const double h = a.sourceDepth;
  const double beta = a.sigma - b.sigma;
  const double quadratic = (d - beta) * (d + beta);
  const double g = 0.5 * (quadratic + (b.sourceDepth - h) * (b.sourceDepth + h));
  const double height = beta * h;
  return quadraticRoots(quadratic, -d * g, (g - height) * (g + height),
    beta * beta * (g * g + quadratic * h * h), a.sourceX);
}

// Section 4.2.2, but with both sigmas: of the circular window, and of the linear window, whose
// function includes it. From the circular one's source, it says r = n + m t.
Crossings circularLinear(const Window& circular, const Window& linear)
{
  const double h = circular.sourceDepth;
  const double m = linear.sourceX;
  const double n = linear.distance(circular.sourceX) - circular.sigma;
  const double height = h * linear.sourceDepth;
  return quadraticRoots(linear.sourceDepth * linear.sourceDepth, -m * n, (h - n) * (h + n),
    (n - height) * (n + height), circular.sourceX);
}

Crossings linearLinear(const Window& a, const Window& b)
{
  Crossings root;
  const double slope = a.sourceX - b.sourceX;
  root.count = slope != 0.0 ? 1 : 0;
  root.at[0] = slope != 0.0 ? (b.sigma - a.sigma) / slope : 0.0;
  return root;
}

Crossings crossingsOfLines(const Window& a, const Window& b)
{
  if (a.isLinear() && b.isLinear())
  {
    return linearLinear(a, b);
  }
  if (a.isLinear())
  {
    return circularLinear(b, a);
  }
  return b.isLinear() ? circularLinear(a, b) : circularCircular(a, b);
}

// The most frequent overlap. With equal sigma the squares can be compared, and their difference is
// linear.
LowerParts lowerOfSameSigma(const Window& a, const Window& b, double lo, double hi)
{
  const double slope = 2.0 * (b.sourceX - a.sourceX);
  const double middle = 0.5 * (a.sourceX + b.sourceX);
  const double depths = (a.sourceDepth - b.sourceDepth) * (a.sourceDepth + b.sourceDepth);
  const double atLo = slope * (lo - middle) + depths;
  const double atHi = slope * (hi - middle) + depths;
  const bool aAtLo = atLo < 0.0 || (atLo == 0.0 && atHi <= 0.0);
  const bool aAtHi = atHi < 0.0 || (atHi == 0.0 && atLo <= 0.0);
  LowerParts lower;
  lower.firstIsA = aAtLo;
  if (aAtLo != aAtHi)
  {
    const double dx = std::max(std::abs(lo - middle), std::abs(hi - middle));
    const double least = 2.0 * tolerance::Evaluation * (dx * dx + a.sourceDepth * a.sourceDepth);
    if (std::max(std::abs(atLo), std::abs(atHi)) <= least)
    {
      return {}; // equal everywhere
    }
    lower.cuts = 1;
    lower.cut[0] = std::clamp(middle - depths / slope, lo, hi);
  }
  return lower;
}

// Whether the two windows have the same distance everywhere, up to rounding. Such windows would
// seem to cross at any number of places.
bool isTie(const Window& a, const Window& b, TwoDoubles ofA, TwoDoubles ofB, double lo, double hi)
{
  const auto same = [](double first, double second)
  { return std::abs(first - second) <= tolerance::Evaluation * first; };
  const double middle = 0.5 * (lo + hi);
  return same(ofA.first(), ofB.first()) && same(ofA.second(), ofB.second()) &&
    same(a.distance(middle), b.distance(middle));
}

// Between crossings one of the two is smaller everywhere. Their middle decides which, or, if they
// tie in the middle, the ends: one source may lie on the path from the other, and by the rounding
// of its sigma it would win where the two are equal. The older window keeps what is equal.
LowerParts lowerByCrossings(const Window& a, const Window& b, double lo, double hi)
{
  const Crossings cross = crossings(a, b, lo, hi);
  const auto difference = [&](double x) { return a.distance(x) - b.distance(x); };
  LowerParts lower;
  bool currentIsA = true;
  double begin = lo;
  for (int i = 0; i <= cross.count; ++i)
  {
    const double end = i < cross.count ? cross.at[static_cast<std::size_t>(i)] : hi;
    const double middle = 0.5 * (begin + end);
    const double inMiddle = difference(middle);
    const double atEnds = difference(begin) + difference(end);
    const double distance = a.distance(middle);
    const bool tie = std::abs(inMiddle) <= tolerance::Tie * distance &&
      std::abs(atEnds) > tolerance::JointFraction * distance;
    const bool isA = (tie ? atEnds : inMiddle) <= 0.0;
    if (i == 0)
    {
      lower.firstIsA = isA;
    }
    else if (isA != currentIsA)
    {
      lower.cut[static_cast<std::size_t>(lower.cuts++)] = begin;
    }
    currentIsA = isA;
    begin = end;
  }
  return lower;
}

// Whether the higher of two windows stays above the lower one, judged from the ends: `high` and
// `low` are the distances there. Distances are
// convex: the higher one is above its tangent at an end, the lower one below its chord.
bool staysAbove(const Window& above, TwoDoubles high, TwoDoubles low, double lo, double hi)
{
  const double width = hi - lo;
  if (above.isLinear())
  {
    return true; // the tangent is the window
  }
  return (high.first() - above.sigma) * (high.first() - low.second()) +
      (lo - above.sourceX) * width >
    0.0 ||
    (high.second() - above.sigma) * (high.second() - low.first()) - (hi - above.sourceX) * width >
    0.0;
}

} // anonymous namespace

Crossings crossings(const Window& a, const Window& b, double lo, double hi)
{
  const Crossings everywhere = crossingsOfLines(a, b);
  Crossings inside;
  for (int i = 0; i < everywhere.count; ++i)
  {
    const double x = everywhere.at[static_cast<std::size_t>(i)];
    if (x > lo && x < hi)
    {
      inside.at[static_cast<std::size_t>(inside.count++)] = x;
    }
  }
  if (inside.count == 2 && inside.at[0] > inside.at[1])
  {
    std::swap(inside.at[0], inside.at[1]);
  }
  return inside;
}

LowerParts lowerOf(const Window& a, const Window& b, double lo, double hi)
{
  if (a.facesCrossed != b.facesCrossed && isSameSource(a, b))
  {
    // One pencil that has returned on another way. Otherwise rounding would sometimes prefer the
    // longer path, up to the limit of faces crossed.
    return { a.facesCrossed < b.facesCrossed };
  }
  if (a.sigma == b.sigma && !a.isLinear() && !b.isLinear())
  {
    return lowerOfSameSigma(a, b, lo, hi);
  }
  const TwoDoubles ofA = a.distances({ lo, hi });
  const TwoDoubles ofB = b.distances({ lo, hi });
  const double atLo = ofA.first() - ofB.first();
  const double atHi = ofA.second() - ofB.second();
  LowerParts lower;
  lower.firstIsA = atLo < 0.0;
  // A change of sign by more than rounding implies a crossing inside.
  const double least = tolerance::Tie * (ofA.first() + ofA.second());
  if ((atLo < -least && atHi > least) || (atLo > least && atHi < -least))
  {
    const Crossings cross = crossings(a, b, lo, hi);
    for (int i = 0; i < cross.count; ++i) // one may be false, from squaring
    {
      const double x = cross.at[static_cast<std::size_t>(i)];
      if (std::abs(a.distance(x) - b.distance(x)) <= least)
      {
        lower.cuts = 1;
        lower.cut[0] = x;
        return lower;
      }
    }
  }
  const bool isClear = (atLo < 0.0 && atHi < 0.0 && staysAbove(b, ofB, ofA, lo, hi)) ||
    (atLo > 0.0 && atHi > 0.0 && staysAbove(a, ofA, ofB, lo, hi));
  if (isClear)
  {
    return lower;
  }
  return isTie(a, b, ofA, ofB, lo, hi) ? LowerParts() : lowerByCrossings(a, b, lo, hi);
}

}
