// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Outbox_h
#define geodesic_Outbox_h

#include "window/WindowPool.h"

#include <vector>

namespace geodesic
{

/// A list that is sent to a halfedge.
struct SentList
{
  Id halfedge;
  WindowBlock windows;
};

/// The lists that a batch sends, grouped by the halfedges that get them: groups in the order in
/// which their halfedges were first sent to, the lists of a group in the order in which they were
/// sent. Sorting them by halfedge would cost several times as much.
class Outbox
{
public:
  /// Takes over what was sent, one after another; nothing is grouped until group().
  void clear() { this->sent_.clear(); }
  void take(std::vector<SentList>& sent)
  {
    this->sent_.insert(this->sent_.end(), sent.begin(), sent.end());
    sent.clear();
  }
  void group();

  std::size_t numberOfGroups() const { return this->first_.size(); }
  Id halfedge(std::size_t group) const { return this->sent_[this->first_[group]].halfedge; }
  template <typename Visit>
  void forEach(std::size_t group, Visit&& visit) const
  {
    for (Id i = this->first_[group]; i != NoId; i = this->next_[i])
    {
      visit(this->sent_[i].windows);
    }
  }

private:
  std::vector<SentList> sent_;
  /// The next one to the same halfedge.
  std::vector<Id> next_;
  /// The first one of each group.
  std::vector<Id> first_;
  /// A hash table: the last one to a halfedge so far.
  std::vector<Id> last_;
};

inline void Outbox::group()
{
  unsigned bits = 4;
  while ((std::size_t(1) << bits) < 2 * this->sent_.size())
  {
    ++bits;
  }
  const std::size_t mask = (std::size_t(1) << bits) - 1;
  this->last_.assign(mask + 1, NoId);
  this->next_.assign(this->sent_.size(), NoId);
  this->first_.clear();
  for (Id i = 0; i < this->sent_.size(); ++i)
  {
    constexpr std::uint64_t golden = 0x9e3779b97f4a7c15U; // Fibonacci hashing (Knuth, 6.4)
    const Id halfedge = this->sent_[i].halfedge;
    std::size_t slot = (halfedge * golden) >> (64 - bits);
    while (this->last_[slot] != NoId && this->sent_[this->last_[slot]].halfedge != halfedge)
    {
      slot = (slot + 1) & mask;
    }
    if (this->last_[slot] == NoId)
    {
      this->first_.push_back(i);
    }
    else
    {
      this->next_[this->last_[slot]] = i;
    }
    this->last_[slot] = i;
  }
}

}

#endif
