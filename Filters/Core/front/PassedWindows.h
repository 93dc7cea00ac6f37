// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PassedWindows_h
#define geodesic_PassedWindows_h

#include "window/WindowList.h"
#include "window/WindowPool.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

namespace geodesic
{

/// What has gone through halfedges to which windows come again and again: an upper bound of the
/// distance on their edges. A window that comes later is cut by it before it goes on. MMP
/// (Mitchell, Mount and Papadimitriou 1987) keeps all windows of all halfedges for that; on rough
/// surfaces a few do nearly as much. A forgotten window costs work, not
/// correctness.
class PassedWindows
{
public:
  /// The windows of a halfedge, sorted and without overlaps; none where nothing is remembered.
  WindowRange at(Id halfedge) const
  {
    const auto found = this->lists_.find(halfedge);
    return found == this->lists_.end() ? WindowRange() : found->second.windows.range();
  }

  /// Remembers the windows of a list that goes through its halfedge.
  ///
  /// \param builder is overwritten.
  /// \param isNeeded (Id halfedge) -> whether windows that come to the halfedge can still matter;
  ///        no list is kept for long where they cannot.
  void add(Id halfedge, double length, const WindowRange& passed, WindowListBuilder& builder,
    WindowPool& pool, const std::function<bool(Id)>& isNeeded);

  /// Finds bounds of the distance on a halfedge through which lists went very often: the windows
  /// that are remembered, and between them paths that go on along the edge from their ends.
  ///
  /// \param bounds replaced; sorted and without overlaps.
  /// \returns whether so many went through.
  bool findBounds(Id halfedge, double length, std::vector<Window>& bounds) const;

  /// Cuts windows that come to a halfedge where bounds of it are lower.
  ///
  /// \param builder is overwritten.
  static void cut(HalfedgeList& come, double length, const WindowRange& bounds,
    WindowListBuilder& builder, WindowPool& pool);

  /// Forgets the windows of halfedges where windows that come can no longer matter.
  void letGo(const std::function<bool(Id)>& isNeeded, WindowPool& pool);

  /// Lets others remember the windows instead: of(halfedge).
  template <typename Of>
  void handOver(const Of& of)
  {
    for (const auto& [halfedge, passed] : this->lists_)
    {
      of(halfedge).lists_.emplace(halfedge, passed);
    }
    this->lists_.clear();
  }

private:
  /// So many windows of one halfedge are remembered. With 64 the number of windows that go on is
  /// the same.
  static constexpr std::size_t Most = 8;

  /// So many lists went through very often.
  static constexpr std::uint32_t VeryOften = 8;

  struct Passed
  {
    WindowBlock windows;
    std::uint32_t lists = 1;
  };

  std::unordered_map<Id, Passed> lists_;
  std::size_t sizeToLetGo_ = 0;
};

}

#endif
