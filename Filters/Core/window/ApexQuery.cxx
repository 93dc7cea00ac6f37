// SPDX-License-Identifier: BSD-3-Clause
#include "window/ApexQuery.h"

namespace geodesic
{

namespace
{

inline void describe(const Window* nearest, double crossing, ApexDistance& shortest)
{
  if (nearest != nullptr)
  {
    shortest.crossing = crossing;
    shortest.error = nearest->error;
    shortest.origin = nearest->origin;
    shortest.place = nearest->placeOf({ shortest.crossing, 0.0 });
    shortest.direction = nearest->direction(shortest.crossing);
  }
}

} // anonymous namespace

ApexQuery fullApexQuery(
  const WindowRange& list, const PointOverHalfedge& apex, std::vector<ApexSide>& sides)
{
  if (sides.size() < list.size())
  {
    sides.resize(list.size());
  }
  ApexQuery query;
  query.list = list;
  query.sides = sides.data();
  const Window* nearest = nullptr;
  const auto consider = [&query, &nearest](double distance, const Window& w)
  {
    if (distance < query.shortest.distance)
    {
      query.shortest.distance = distance;
      nearest = &w;
    }
  };
  double straight = Infinity;
  ApexSide previous = ApexSide::Left; // as if a window before the first one passed on the left
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    const Window& w = list.first[i];
    const ApexSide side = w.passesRightOf(w.begin, apex) ? ApexSide::Right
      : w.passesRightOf(w.end, apex)                     ? ApexSide::Both
                                                         : ApexSide::Left;
    sides[i] = side;
    if (side == ApexSide::Both)
    {
      const double distance = w.straightDistance(apex);
      consider(distance, w);
      if (distance < straight)
      {
        straight = distance;
        query.first = i;
      }
    }
    // Between a window that passes on the left and one that passes on the right, the apex lies in a
    // gap.
    if (side == ApexSide::Right && previous == ApexSide::Left)
    {
      consider(w.bentDistance(apex), w);
      if (i > 0)
      {
        consider(list.first[i - 1].bentDistance(apex), list.first[i - 1]);
      }
    }
    if (side == ApexSide::Left && i + 1 == list.size())
    {
      consider(w.bentDistance(apex), w);
    }
    previous = side;
  }
  describe(nearest, nearest != nullptr ? nearest->crossing(apex) : 0.0, query.shortest);
  return query;
}

// A binary search finds the first window that passes on the right.
ApexDistance quickApexQuery(const WindowRange& list, Vec2 apex)
{
  ApexDistance shortest;
  const Window* nearest = nullptr;
  double crossing = 0.0;
  const auto consider = [&](const Window& w)
  {
    const double x = w.crossing(apex);
    const double distance = w.bentDistance(apex, x);
    if (distance < shortest.distance)
    {
      shortest.distance = distance;
      nearest = &w;
      crossing = x;
    }
  };
  if (list.size() == 1)
  {
    consider(*list.begin());
    describe(nearest, crossing, shortest);
    return shortest;
  }
  const Window* first = list.begin();
  for (std::size_t count = list.size(); count > 0;)
  {
    const std::size_t half = count / 2;
    const bool isBefore = !first[half].passesRightOf(first[half].begin, apex);
    first = isBefore ? first + half + 1 : first;
    count = isBefore ? count - half - 1 : half;
  }
  if (first != list.end())
  {
    consider(*first);
  }
  // back over the windows that contain the apex, to one that passes on the left
  for (bool holds = true; holds && first != list.begin();)
  {
    --first;
    consider(*first);
    holds = first->passesRightOf(first->end, apex);
  }
  describe(nearest, crossing, shortest);
  return shortest;
}

}
