// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Mailboxes_h
#define geodesic_Mailboxes_h

#include "front/Districts.h"
#include "front/VertexStates.h"
#include "mesh/MeshPartition.h"
#include "window/WindowPool.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

namespace geodesic
{

/// What one district sends to another district, or to itself, in a batch.
struct MailBatch
{
  std::vector<HalfedgeList> lists;
  std::vector<DistanceUpdate> updates;

  bool isEmpty() const { return this->lists.empty() && this->updates.empty(); }
  void clear()
  {
    this->lists.clear();
    this->updates.clear();
  }
};

/// What a district sends to other ranks, by way of FrontOnRanks; nothing in one process.
struct MailToRanks
{
  explicit MailToRanks(const MeshPartition& surface)
    : areThereOthers(surface.isDistributed())
  {
  }

  bool areThereOthers;
  /// Lists for faces that other ranks own.
  std::vector<HalfedgeList> lists;
  /// Distances found in the second step of a batch.
  std::vector<DistanceUpdate> arrivals;

  void addArrival(const DistanceUpdate& arrival)
  {
    if (this->areThereOthers)
    {
      this->arrivals.push_back(arrival);
    }
  }
};

/// The messages between districts. In the first step every district's worker writes; in the second,
/// every district reads the messages of its senders in the order of their numbers. So the order of
/// reading does not depend on which worker was faster.
///
/// If ranks share the surface, what lower ranks have sent is read first, and what higher ranks have
/// sent last. So all ranks read in the same order and choose alike between equal paths.
class Mailboxes
{
public:
  explicit Mailboxes(Id districts)
    : slots_(districts)
    , senders_(districts)
    , fromRanks_(districts)
  {
    for (Id district = 0; district < districts; ++district)
    {
      this->slots_[district].push_back({ district, {} });
      this->senders_[district].add(district); // most messages go to the own district
    }
  }

  /// Where a district writes to another.
  MailBatch& to(Id sender, Id receiver)
  {
    if (sender == receiver)
    {
      return this->slots_[sender].front().mail;
    }
    MailBatch& mail = this->find(sender, receiver);
    if (mail.isEmpty())
    {
      this->senders_[receiver].add(sender);
      this->receivers_.add(receiver);
    }
    return mail;
  }

  /// Where to put what lower or higher ranks have sent to a district.
  MailBatch& fromRanks(bool areHigher, Id receiver)
  {
    this->receivers_.add(receiver);
    return this->fromRanks_[receiver][areHigher ? 1 : 0];
  }

  /// Makes the district read in the next step: it has written to itself, or has received something
  /// from elsewhere.
  void notify(Id district) { this->receivers_.add(district); }
  /// Replaces `districts` by those that have something to read.
  void takeReceivers(std::vector<Id>& districts)
  {
    districts.clear();
    this->receivers_.forEach([&districts](Id district) { districts.push_back(district); });
    this->receivers_.clear();
  }

  /// Calls visit(MailBatch&) for the messages of each sender.
  template <typename Visit>
  void forEach(Id receiver, Visit&& visit)
  {
    visit(this->fromRanks_[receiver][0]);
    this->senders_[receiver].forEach([&](Id sender) { visit(this->find(sender, receiver)); });
    visit(this->fromRanks_[receiver][1]);
  }

  /// Calls visit(const MailBatch&) for the messages of one sender to each district.
  template <typename Visit>
  void forEachOf(Id sender, Visit&& visit) const
  {
    for (const Slot& slot : this->slots_[sender])
    {
      visit(slot.mail);
    }
  }

  /// Deletes the messages to a district.
  void clear(Id receiver)
  {
    this->forEach(receiver, [](MailBatch& mail) { mail.clear(); });
    this->senders_[receiver].clear();
    this->senders_[receiver].add(receiver);
  }

private:
  /// A set of districts; several tasks may add at the same time.
  class Set
  {
  public:
    void add(Id district)
    {
      this->words_[district / 64].fetch_or(
        std::uint64_t(1) << district % 64, std::memory_order_relaxed);
    }
    void clear()
    {
      for (std::atomic<std::uint64_t>& word : this->words_)
      {
        word.store(0, std::memory_order_relaxed);
      }
    }
    /// Visits in ascending order.
    template <typename Visit>
    void forEach(Visit&& visit) const
    {
      for (Id i = 0; i < this->words_.size(); ++i)
      {
        std::uint64_t left = this->words_[i].load(std::memory_order_relaxed);
        for (Id district = 64 * i; left != 0; ++district, left >>= 1)
        {
          for (; (left & 0xffU) == 0; left >>= 8)
          {
            district += 8;
          }
          if ((left & 1U) != 0)
          {
            visit(district);
          }
        }
      }
    }

  private:
    std::array<std::atomic<std::uint64_t>, Districts::Most / 64> words_ = {};
  };

  struct Slot
  {
    Id receiver;
    MailBatch mail;
  };

  MailBatch& find(Id sender, Id receiver)
  {
    std::vector<Slot>& slots = this->slots_[sender];
    std::size_t i = 0;
    while (i < slots.size() && slots[i].receiver != receiver)
    {
      ++i;
    }
    if (i == slots.size())
    {
      slots.push_back({ receiver, {} });
    }
    return slots[i].mail;
  }

  /// By sender: first the slot for itself, then one slot for each neighbouring district it has
  /// written to.
  std::vector<std::vector<Slot>> slots_;
  /// By receiver.
  std::vector<Set> senders_;
  /// By receiver: of lower and of higher ranks.
  std::vector<std::array<MailBatch, 2>> fromRanks_;
  /// The districts that have something to read.
  Set receivers_;
};

}

#endif
