// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/DistanceAlongEdge.h"

#include <algorithm>
#include <cmath>

namespace geodesic
{

namespace
{

// An edge that needs more cuts is halved again and again: there may be no room for so many.
constexpr std::size_t MostCuts = 300;

double distanceAt(const std::vector<Window>& envelope, double x)
{
  const auto window = std::partition_point(
    envelope.begin(), envelope.end() - 1, [x](const Window& w) { return w.end < x; });
  return window->distance(x);
}

} // anonymous namespace

void DistanceAlongEdge::add(const std::vector<Window>& envelope, double atBegin)
{
  this->ofFaces_.push_back(envelope);
  if (envelope.empty())
  {
    this->ofFaces_.back().push_back({ 0.0, 0.0, 0.0, 1.0, atBegin, 0.0, Window::Kind::Linear, 0 });
  }
}

Deviation DistanceAlongEdge::deviation(
  double from, double to, const std::array<double, 2>* ends) const
{
  Deviation largest;
  for (const std::vector<Window>& envelope : this->ofFaces_)
  {
    largest.widen(
      largestDeviation(envelope, from, to, ends ? (*ends)[0] : distanceAt(envelope, from),
        ends ? (*ends)[1] : distanceAt(envelope, to)));
  }
  return largest;
}

// How far a piece within the tolerance can go from one place towards another, in either direction.
// Deviations grow about with the square of the length; where they do not, bisection goes on.
double DistanceAlongEdge::furthest(double from, double to, double guess, double tolerance) const
{
  constexpr int steps = 20;
  constexpr double near = 0.97;
  constexpr double aim = 0.985;
  double within = from;
  double beyond = to;
  bool isBeyond = false; // until then, all of the way may be within the tolerance
  double x = std::abs(guess) < std::abs(to - from) ? from + guess : to;
  for (int i = 0; i < steps; ++i)
  {
    const double deviation =
      this->deviation(std::min(from, x), std::max(from, x), nullptr).largest();
    if (deviation <= tolerance)
    {
      within = x;
      if (x == to || deviation >= near * tolerance)
      {
        break;
      }
    }
    else
    {
      beyond = x;
      isBeyond = true;
    }
    const double growth = std::sqrt(aim * tolerance / std::max(deviation, 0.1 * tolerance));
    const double aimed = from + growth * (x - from);
    if (aimed > std::min(within, beyond) && aimed < std::max(within, beyond))
    {
      x = aimed;
    }
    else
    {
      x = isBeyond ? 0.5 * (within + beyond) : to;
    }
  }
  return within;
}

// Stops when there are more than the most.
std::vector<double> DistanceAlongEdge::stepsWithin(
  double from, double to, double tolerance, std::size_t most) const
{
  std::vector<double> places;
  double guess = to - from;
  for (double last = from;;)
  {
    const double next = this->furthest(last, to, guess, tolerance);
    if (next == to || next == last || places.size() > most)
    {
      return places;
    }
    places.push_back(next);
    guess = next - last;
    last = next;
  }
}

// If the k-th of n cuts is put between the furthest from the one end and the furthest from the
// other, at k / (n + 1) of the way, pieces are equal where the curvature is. The furthest from the
// one end if that does not suffice.
std::vector<double> DistanceAlongEdge::evenCuts(
  double from, double to, double tolerance, const std::vector<double>& forward) const
{
  const std::vector<double> backward = this->stepsWithin(to, from, tolerance, forward.size());
  const std::size_t count = forward.size();
  if (backward.size() != count)
  {
    return forward;
  }
  std::vector<double> even;
  double last = from;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double weight = static_cast<double>(i + 1) / static_cast<double>(count + 1);
    even.push_back(forward[i] + weight * (backward[count - 1 - i] - forward[i]));
    if (!this->isWithin(last, even.back(), tolerance))
    {
      return forward;
    }
    last = even.back();
  }
  return this->isWithin(last, to, tolerance) ? even : forward;
}

std::vector<double> DistanceAlongEdge::cuts(double from, double to, double tolerance) const
{
  const std::vector<double> forward = this->stepsWithin(from, to, tolerance, MostCuts);
  const std::size_t count = forward.size();
  if (count > MostCuts)
  {
    return {};
  }
  if (count == 1)
  {
    const double worst = from + this->deviation(from, to, nullptr).at() * (to - from);
    if (this->isWithin(from, worst, tolerance) && this->isWithin(worst, to, tolerance))
    {
      return { worst };
    }
  }
  return this->evenCuts(from, to, tolerance, forward);
}

}
