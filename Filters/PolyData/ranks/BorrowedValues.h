// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BorrowedValues_h
#define geodesic_BorrowedValues_h

#include "Exchange.h"
#include "mesh/MeshPartition.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace geodesic
{

/// The values of other ranks of which this rank has copies, such as values at points that several
/// ranks have. Ranks tell each other once which values these are; then any number of arrays can be
/// copied.
class BorrowedValues
{
public:
  /// None, on all ranks.
  BorrowedValues() = default;
  /// All ranks make theirs together.
  ///
  /// \param from for each copy the rank, which may be this one, and the value's number there; NoId
  ///        where no rank has it.
  BorrowedValues(const std::vector<RankAddress>& from, Exchange& exchange)
    : count_(from.size())
  {
    std::vector<Message> orders = exchange.noMessages();
    this->lent_.resize(orders.size());
    this->borrowed_.resize(orders.size());
    for (std::size_t i = 0; i < from.size(); ++i)
    {
      if (from[i].id != NoId)
      {
        const auto rank = rankIndex(from[i].rank);
        put(orders[rank], from[i].id);
        this->borrowed_[rank].push_back(i);
      }
    }
    readEach(exchange.step(std::move(orders)),
      [this](int rank, MessageReader& reader)
      { this->lent_[rankIndex(rank)].push_back(reader.get<Id>()); });
  }

  /// The copies, in the order of the constructor's. All ranks call this together.
  ///
  /// \param none the value where no rank has it.
  /// \param valueAt the rank's own value of a number: (Id) -> Value.
  template <typename Value, typename ValueAt>
  std::vector<Value> copies(const Value& none, Exchange& exchange, const ValueAt& valueAt) const
  {
    std::vector<Message> messages = exchange.noMessages();
    for (std::size_t rank = 0; rank < this->lent_.size(); ++rank)
    {
      for (const Id id : this->lent_[rank])
      {
        put(messages[rank], Value(valueAt(id)));
      }
    }
    std::vector<Value> values(this->count_, none);
    std::vector<std::size_t> next(messages.size(), 0);
    readEach(exchange.step(std::move(messages)),
      [&](int rank, MessageReader& reader)
      {
        const auto from = rankIndex(rank);
        values[this->borrowed_[from][next[from]++]] = reader.get<Value>();
      });
    return values;
  }

  /// Appends the copies to a rank's own values. All ranks call this together.
  template <typename Value>
  void append(const Value& none, std::vector<Value>& values, Exchange& exchange) const
  {
    const std::vector<Value> copies =
      this->copies(none, exchange, [&values](Id id) { return values[id]; });
    values.insert(values.end(), copies.begin(), copies.end());
  }

private:
  std::size_t count_ = 0;
  /// For each other rank, the values of this rank that it borrows, and the copies of its values
  /// that this rank has; both in the order in which they are sent.
  std::vector<std::vector<Id>> lent_;
  std::vector<std::vector<std::size_t>> borrowed_;
};

}

#endif
