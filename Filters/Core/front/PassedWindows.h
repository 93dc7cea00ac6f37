// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PassedWindows_h
#define geodesic_PassedWindows_h

#include "front/WaitingLists.h"
#include "window/WindowList.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace geodesic
{

/// What has gone through halfedges to which windows come again and again: an upper bound of the
/// distance on them. A window that comes later is cut by it before it goes on. MMP (Mitchell,
/// Mount and Papadimitriou 1987) keeps all windows of all halfedges for that; on rough surfaces a
/// few do nearly as much. What is not here costs work only.
class PassedWindows
{
public:
  /// The windows of a halfedge, sorted and without overlaps; none where nothing is remembered.
  WindowRange at(Id halfedge) const
  {
    const Id list = this->lists_.find(halfedge);
    return list == NoId ? WindowRange() : this->lists_[list].windows.range();
  }

  /// Remembers the windows of a list that goes through its halfedge.
  ///
  /// \param builder is overwritten.
  /// \param isNeeded (Id halfedge) -> whether windows that come to the halfedge can still matter;
  ///        no list is kept for long where they cannot.
  template <typename IsNeeded>
  void add(Id halfedge, double length, const WindowRange& passed, WindowListBuilder& builder,
    WindowPool& pool, const IsNeeded& isNeeded)
  {
    if (this->lists_.size() >= this->sizeToLetGo_)
    {
      this->letGo(isNeeded, pool);
    }
    const Id list = this->lists_.find(halfedge);
    builder.reset(length);
    builder.appendLists(list == NoId ? WindowRange() : this->lists_[list].windows.range(), passed);
    if (builder.windows().size() > Most)
    {
      builder.dropNarrowerThan(length / static_cast<double>(Most));
    }
    if (list != NoId)
    {
      this->lists_.assign(list, builder.range(), pool);
    }
    else if (!builder.windows().empty())
    {
      this->lists_.add(halfedge, pool.copyOf(builder.range()));
    }
  }

private:
  /// So many windows of one halfedge are remembered. With 64 the number of windows that go on is
  /// the same.
  static constexpr std::size_t Most = 8;

  // Each time that there are twice as many lists as were left the last time.
  template <typename IsNeeded>
  void letGo(const IsNeeded& isNeeded, WindowPool& pool)
  {
    std::vector<Id> behind;
    this->lists_.forEach(
      [&](const WaitingLists::List& list)
      {
        if (!isNeeded(list.halfedge))
        {
          behind.push_back(list.halfedge);
        }
      });
    for (const Id halfedge : behind)
    {
      pool.free(this->lists_.remove(this->lists_.find(halfedge)));
    }
    constexpr std::size_t few = 64;
    this->sizeToLetGo_ = std::max(few, 2 * this->lists_.size());
  }

  WaitingLists lists_;
  std::size_t sizeToLetGo_ = 0;
};

}

#endif
