// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SharedResults_h
#define geodesic_SharedResults_h

#include "Exchange.h"

#include <algorithm>
#include <vector>

namespace geodesic
{

/// The message of the first rank that works. All ranks call this together.
inline Message messageOfWorkingRank(Exchange& exchange, bool isWorking, const Message& own)
{
  const std::vector<Message> told = exchange.tellAll(isWorking ? own : Message());
  return *std::find_if(told.begin(), told.end(), [](const Message& m) { return !m.empty(); });
}

/// Gives ranks that do not work what the first one that works has found. All ranks call this
/// together.
template <typename... Values>
void shareResults(Exchange& exchange, bool isWorking, Values&... values)
{
  Message message;
  (put(message, values), ...);
  message = messageOfWorkingRank(exchange, isWorking, message);
  MessageReader reader(message);
  ((values = reader.get<Values>()), ...);
}
template <typename Value>
void shareResults(Exchange& exchange, bool isWorking, std::vector<Value>& values)
{
  Message message;
  putAll(message, values);
  message = messageOfWorkingRank(exchange, isWorking, message);
  values = MessageReader(message).getAll<Value>();
}

}

#endif
