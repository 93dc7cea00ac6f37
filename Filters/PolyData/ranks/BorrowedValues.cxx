// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/ranks/BorrowedValues.h"

#include <utility>

namespace geodesic
{

BorrowedValues::BorrowedValues(const std::vector<RankAddress>& from, Exchange& exchange)
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

}
