// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Mailboxes_h
#define geodesic_Mailboxes_h

#include "front/VertexStates.h"
#include "window/WindowPool.h"

#include <algorithm>
#include <vector>

namespace geodesic
{

/// Lists and distances that are sent together.
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

/// The messages between districts. In the first step of a batch every district's worker writes; in
/// the second, every district reads the messages to it in the order of the senders' numbers. So the
/// order of reading does not depend on which worker was faster. In between, one thread delivers the
/// messages.
///
/// If ranks share the surface, a district reads first what lower ranks have sent, and last what
/// higher ranks have sent. So all ranks read in the same order and choose alike between equal
/// paths.
class Mailboxes
{
public:
  explicit Mailboxes(Id districts)
    : slots_(districts + 2)
    , inboxes_(districts)
  {
    for (Id district = 0; district < districts; ++district)
    {
      this->slots_[district].push_back({ district, {} });
    }
  }

  /// Where a district writes to another, or to itself.
  MailBatch& to(Id sender, Id receiver)
  {
    // Most messages go to the own district.
    return sender == receiver ? this->slots_[sender].front().mail : this->find(sender, receiver);
  }

  /// Where to put what lower or higher ranks have sent to a district.
  MailBatch& fromRanks(bool areHigher, Id receiver)
  {
    return this->find(areHigher ? this->higherRanks() : this->lowerRanks(), receiver);
  }

  /// Delivers all messages.
  ///
  /// \param districts those that may have written something, in ascending order; those that have to
  ///        read something are added.
  void deliver(std::vector<Id>& districts)
  {
    const std::size_t senders = districts.size();
    this->deliverFrom(this->lowerRanks(), districts);
    for (std::size_t i = 0; i < senders; ++i)
    {
      this->deliverFrom(districts[i], districts);
    }
    this->deliverFrom(this->higherRanks(), districts);
    std::sort(districts.begin(), districts.end());
    districts.erase(std::unique(districts.begin(), districts.end()), districts.end());
  }

  /// The messages delivered to a district, which deletes what it has read.
  std::vector<MailBatch*>& inbox(Id receiver) { return this->inboxes_[receiver]; }

  /// Calls visit(const MailBatch&) for the messages of one sender to each district.
  template <typename Visit>
  void forEachOf(Id sender, Visit&& visit) const
  {
    for (const Slot& slot : this->slots_[sender])
    {
      visit(slot.mail);
    }
  }

private:
  struct Slot
  {
    Id receiver;
    MailBatch mail;
  };

  Id lowerRanks() const { return static_cast<Id>(this->inboxes_.size()); }
  Id higherRanks() const { return this->lowerRanks() + 1; }

  MailBatch& find(Id sender, Id receiver)
  {
    std::vector<Slot>& slots = this->slots_[sender];
    const auto slot = std::find_if(slots.begin(), slots.end(),
      [receiver](const Slot& candidate) { return candidate.receiver == receiver; });
    return slot != slots.end() ? slot->mail : slots.emplace_back(Slot{ receiver, {} }).mail;
  }

  void deliverFrom(Id sender, std::vector<Id>& receivers)
  {
    for (Slot& slot : this->slots_[sender])
    {
      if (!slot.mail.isEmpty())
      {
        this->inboxes_[slot.receiver].push_back(&slot.mail);
        receivers.push_back(slot.receiver);
      }
    }
  }

  /// By sender, the districts and then the lower and the higher ranks: a slot for each district
  /// that it has written to, of a district first the one for itself.
  std::vector<std::vector<Slot>> slots_;
  /// By receiver.
  std::vector<std::vector<MailBatch*>> inboxes_;
};

}

#endif
