// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PassedWindows_h
#define geodesic_PassedWindows_h

#include "window/WindowList.h"
#include "window/WindowPool.h"

#include <cstddef>
#include <functional>
#include <unordered_map>

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
    const auto found = this->lists_.find(halfedge);
    return found == this->lists_.end() ? WindowRange() : found->second.range();
  }

  /// Remembers the windows of a list that goes through its halfedge.
  ///
  /// \param builder is overwritten.
  /// \param isNeeded (Id halfedge) -> whether windows that come to the halfedge can still matter;
  ///        no list is kept for long where they cannot.
  void add(Id halfedge, double length, const WindowRange& passed, WindowListBuilder& builder,
    WindowPool& pool, const std::function<bool(Id)>& isNeeded);

  /// Cuts windows that come to a halfedge by those that have passed there.
  ///
  /// \param builder is overwritten.
  void cut(HalfedgeList& come, double length, WindowListBuilder& builder, WindowPool& pool) const;

  /// Lets others remember the windows instead: of(halfedge).
  template <typename Of>
  void handOver(const Of& of)
  {
    for (const auto& [halfedge, windows] : this->lists_)
    {
      of(halfedge).lists_.emplace(halfedge, windows);
    }
    this->lists_.clear();
  }

private:
  /// So many windows of one halfedge are remembered. With 64 the number of windows that go on is
  /// the same.
  static constexpr std::size_t Most = 8;

  void letGo(const std::function<bool(Id)>& isNeeded, WindowPool& pool);

  std::unordered_map<Id, WindowBlock> lists_;
  std::size_t sizeToLetGo_ = 0;
};

}

#endif
