// SPDX-License-Identifier: BSD-3-Clause
#include "front/PassedWindows.h"

#include <algorithm>

namespace geodesic
{

void PassedWindows::add(Id halfedge, double length, const WindowRange& passed,
  WindowListBuilder& builder, WindowPool& pool, const std::function<bool(Id)>& isNeeded)
{
  if (this->lists_.size() >= this->sizeToLetGo_)
  {
    this->letGo(isNeeded, pool);
  }
  builder.reset(length);
  builder.appendLists(this->at(halfedge), passed);
  if (builder.windows().size() > Most)
  {
    builder.dropNarrowerThan(length / static_cast<double>(Most));
  }
  const auto known = this->lists_.find(halfedge);
  if (known != this->lists_.end())
  {
    pool.assign(known->second.windows, builder.range());
    ++known->second.lists;
  }
  else if (!builder.windows().empty())
  {
    this->lists_.emplace(halfedge, Passed{ pool.copyOf(builder.range()) });
  }
}

void PassedWindows::cut(HalfedgeList& come, double length, const WindowRange& bounds,
  WindowListBuilder& builder, WindowPool& pool)
{
  if (bounds.size() == 0)
  {
    return;
  }
  builder.reset(length);
  for (const Window& window : come.windows.range())
  {
    builder.appendWhereLower(window, bounds);
  }
  pool.free(come.windows);
  come.windows = pool.copyOf(builder.range());
}

namespace
{

// Paths that go on along the edge, from a point whose distance is known.
Window alongEdge(double from, double distance, double begin, double end)
{
  Window w = {};
  w.begin = begin;
  w.end = end;
  w.sourceX = from;
  w.sigma = distance;
  return w;
}

// Between two points of an edge, paths along it from either, where they are shorter. A point beyond
// an end of the edge has an infinite distance.
void appendAlongEdge(
  double from, double fromDistance, double to, double toDistance, std::vector<Window>& bounds)
{
  double middle = fromDistance < Infinity ? to : from;
  if (fromDistance < Infinity && toDistance < Infinity)
  {
    middle = std::clamp(0.5 * (from + to + toDistance - fromDistance), from, to);
  }
  if (from < middle)
  {
    bounds.push_back(alongEdge(from, fromDistance, from, middle));
  }
  if (middle < to && toDistance < Infinity)
  {
    bounds.push_back(alongEdge(to, toDistance, middle, to));
  }
}

} // anonymous namespace

bool PassedWindows::findBounds(Id halfedge, double length, std::vector<Window>& bounds) const
{
  const auto found = this->lists_.find(halfedge);
  if (found == this->lists_.end() || found->second.lists < VeryOften)
  {
    return false;
  }
  bounds.clear();
  double from = 0.0;
  double distance = Infinity;
  for (const Window& w : found->second.windows.range())
  {
    appendAlongEdge(from, distance, w.begin, w.distance(w.begin), bounds);
    bounds.push_back(w);
    from = w.end;
    distance = w.distance(w.end);
  }
  appendAlongEdge(from, distance, length, Infinity, bounds);
  return true;
}

// Each time that there are twice as many lists as were left the last time.
void PassedWindows::letGo(const std::function<bool(Id)>& isNeeded, WindowPool& pool)
{
  for (auto list = this->lists_.begin(); list != this->lists_.end();)
  {
    if (isNeeded(list->first))
    {
      ++list;
      continue;
    }
    pool.free(list->second.windows);
    list = this->lists_.erase(list);
  }
  constexpr std::size_t few = 64;
  this->sizeToLetGo_ = std::max(few, 2 * this->lists_.size());
}

}
