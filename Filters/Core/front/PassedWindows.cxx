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
    pool.assign(known->second, builder.range());
  }
  else if (!builder.windows().empty())
  {
    this->lists_.emplace(halfedge, pool.copyOf(builder.range()));
  }
}

void PassedWindows::cut(
  HalfedgeList& come, double length, WindowListBuilder& builder, WindowPool& pool) const
{
  const WindowRange passed = this->at(come.halfedge);
  if (passed.size() == 0)
  {
    return;
  }
  builder.reset(length);
  for (const Window& window : come.windows.range())
  {
    builder.appendWhereLower(window, passed);
  }
  pool.free(come.windows);
  come.windows = pool.copyOf(builder.range());
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
    pool.free(list->second);
    list = this->lists_.erase(list);
  }
  constexpr std::size_t few = 64;
  this->sizeToLetGo_ = std::max(few, 2 * this->lists_.size());
}

}
