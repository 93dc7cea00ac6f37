// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Post_h
#define geodesic_Post_h

#include "front/Districts.h"
#include "front/VertexStates.h"
#include "window/WindowPool.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

namespace geodesic
{

/// A list that is sent to a halfedge.
struct SentList
{
  Id halfedge;
  WindowBlock windows;
};

/// What one district sends to another in a batch, or to itself.
struct Mail
{
  std::vector<SentList> lists;
  std::vector<DistanceUpdate> updates;

  bool isEmpty() const { return this->lists.empty() && this->updates.empty(); }
  void clear()
  {
    this->lists.clear();
    this->updates.clear();
  }
};

/// The mail between districts. First all write, each district's worker for itself; then all read,
/// the mail of the senders in the order of their numbers. So the order in which mail is read does
/// not depend on who was faster.
class Post
{
public:
  explicit Post(Id districts)
    : letters_(districts)
    , senders_(districts)
  {
    for (Id district = 0; district < districts; ++district)
    {
      this->letters_[district].push_back({ district, {} });
      this->senders_[district].add(district); // by far most goes to itself
    }
  }

  /// Where a district writes for another.
  Mail& to(Id sender, Id receiver)
  {
    if (sender == receiver)
    {
      return this->letters_[sender].front().mail;
    }
    Mail& mail = this->find(sender, receiver);
    if (mail.isEmpty())
    {
      this->senders_[receiver].add(sender);
      this->receivers_.add(receiver);
    }
    return mail;
  }

  /// Lets the district read mail: it has written for itself, or has something else to take over.
  void call(Id district) { this->receivers_.add(district); }
  /// Replaces the numbers by those of the districts that have something to read.
  void takeReceivers(std::vector<Id>& districts)
  {
    districts.clear();
    this->receivers_.forEach([&districts](Id district) { districts.push_back(district); });
    this->receivers_.clear();
  }

  /// Calls visit(Mail&) for what each sender has written.
  template <typename Visit>
  void forEach(Id receiver, Visit&& visit)
  {
    this->senders_[receiver].forEach([&](Id sender) { visit(this->find(sender, receiver)); });
  }

  /// Calls visit(const Mail&) for what one sender has written for each district.
  template <typename Visit>
  void forEachOf(Id sender, Visit&& visit) const
  {
    for (const Letter& letter : this->letters_[sender])
    {
      visit(letter.mail);
    }
  }

  /// Throws away what was written for a district.
  void clear(Id receiver)
  {
    this->forEach(receiver, [](Mail& mail) { mail.clear(); });
    this->senders_[receiver].clear();
    this->senders_[receiver].add(receiver);
  }

private:
  /// Some districts; several tasks may add at the same time.
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
    /// Ascending.
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

  struct Letter
  {
    Id receiver;
    Mail mail;
  };

  Mail& find(Id sender, Id receiver)
  {
    std::vector<Letter>& letters = this->letters_[sender];
    std::size_t i = 0;
    while (i < letters.size() && letters[i].receiver != receiver)
    {
      ++i;
    }
    if (i == letters.size())
    {
      letters.push_back({ receiver, {} });
    }
    return letters[i].mail;
  }

  /// By sender: the first for itself, then one a neighbouring district.
  std::vector<std::vector<Letter>> letters_;
  /// By receiver.
  std::vector<Set> senders_;
  /// Who has something to read.
  Set receivers_;
};

}

#endif
