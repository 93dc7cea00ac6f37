// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Exchange_h
#define geodesic_Exchange_h

#include "Errors.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace geodesic
{

/// What one rank tells another in one step.
using Message = std::vector<std::byte>;

/// A rank's place in what there is one of for each rank, such as messages.
inline std::size_t rankIndex(int rank)
{
  return static_cast<std::size_t>(rank);
}

/// Another rank has failed, with this message; this one can only say the same.
class FailedElsewhere : public Error
{
public:
  using Error::Error;
};

/// The user has stopped another rank.
class AbortedElsewhere : public Aborted
{
};

/// How ranks that have one surface together talk to each other. There is one way only, a step that
/// all ranks take together (a superstep: Valiant 1990), so that none can wait for another that does
/// something else: a rank that fails takes the next step as a failed one.
class Exchange
{
public:
  virtual ~Exchange() = default;

  virtual int rank() const = 0;
  virtual int numberOfRanks() const = 0;

  /// Takes a step: sends a message to each rank (an empty one costs nothing), and finds the least
  /// of each number over all ranks.
  ///
  /// \param messages one a rank, also to oneself.
  /// \param least as many numbers on every rank.
  /// \returns what each rank has sent to this one.
  /// \throws FailedElsewhere, AbortedElsewhere where a rank has called fail() in place of this.
  virtual std::vector<Message> step(std::vector<Message> messages, std::vector<double>& least) = 0;

  /// Tells all ranks in their next step that this one ends here.
  ///
  /// \param why a message for the user; empty: the user has asked to stop.
  /// \returns the message of the lowest rank that fails in that step, which all ranks give.
  virtual std::string fail(const std::string& why) = 0;

  /// A step with messages only.
  std::vector<Message> step(std::vector<Message> messages)
  {
    std::vector<double> nothing;
    return this->step(std::move(messages), nothing);
  }
  /// A step with numbers only.
  void findLeast(std::vector<double>& numbers) { this->step(this->noMessages(), numbers); }
  double leastOf(double number)
  {
    std::vector<double> numbers = { number };
    this->findLeast(numbers);
    return numbers.front();
  }
  double largestOf(double number) { return -this->leastOf(-number); }
  bool isTrueAnywhere(bool condition) { return this->leastOf(condition ? 0.0 : 1.0) == 0.0; }
  /// A step in which every rank gets the same message from this one.
  std::vector<Message> tellAll(const Message& message)
  {
    return this->step(std::vector<Message>(this->noMessages().size(), message));
  }

  std::vector<Message> noMessages() const
  {
    return std::vector<Message>(static_cast<std::size_t>(this->numberOfRanks()));
  }
};

/// The exchange of a process that has the whole surface: all that it sends comes back to it.
class OneRank : public Exchange
{
public:
  /// The one that all such processes share; it has no state.
  static Exchange& instance()
  {
    static OneRank one;
    return one;
  }

  int rank() const override { return 0; }
  int numberOfRanks() const override { return 1; }
  using Exchange::step;
  std::vector<Message> step(std::vector<Message> messages, std::vector<double>&) override
  {
    return messages;
  }
  std::string fail(const std::string& why) override { return why; }
};

/// Puts values into a message, as they are in memory: ranks are processes of one program on
/// machines of one kind.
template <typename Value>
void put(Message& message, const Value* values, std::size_t count)
{
  static_assert(std::is_trivially_copyable_v<Value>);
  if (count > 0)
  {
    const std::size_t size = message.size();
    message.resize(size + count * sizeof(Value));
    std::memcpy(message.data() + size, values, count * sizeof(Value));
  }
}

template <typename Value>
void put(Message& message, const Value& value)
{
  put(message, &value, 1);
}

/// Takes values out of a message, in the order in which they were put there.
class MessageReader
{
public:
  explicit MessageReader(const Message& message)
    : next_(message.data())
    , end_(message.data() + message.size())
  {
  }

  bool isAtEnd() const { return this->next_ == this->end_; }

  /// \throws Error where the message ends before.
  template <typename Value>
  void get(Value* values, std::size_t count)
  {
    static_assert(std::is_trivially_copyable_v<Value>);
    const std::size_t size = count * sizeof(Value);
    if (static_cast<std::size_t>(this->end_ - this->next_) < size)
    {
      throw Error("A message between ranks ends too early. Run the same build on all ranks.");
    }
    if (size > 0)
    {
      std::memcpy(values, this->next_, size);
      this->next_ += size;
    }
  }

  template <typename Value>
  Value get()
  {
    Value value;
    this->get(&value, 1);
    return value;
  }

private:
  const std::byte* next_;
  const std::byte* end_;
};

/// Calls visit(int rank, MessageReader&) for what each rank has sent, while there is something left
/// to read.
template <typename Visit>
void readEach(const std::vector<Message>& messages, Visit&& visit)
{
  for (std::size_t rank = 0; rank < messages.size(); ++rank)
  {
    MessageReader reader(messages[rank]);
    while (!reader.isAtEnd())
    {
      visit(static_cast<int>(rank), reader);
    }
  }
}

/// A step in which every rank tells all others one value.
///
/// \returns the values of all ranks, also this one's, in their order.
template <typename Value>
std::vector<Value> valuesOfRanks(Exchange& exchange, const Value& own)
{
  Message message;
  put(message, own);
  std::vector<Value> values;
  values.reserve(rankIndex(exchange.numberOfRanks()));
  readEach(exchange.tellAll(message),
    [&](int, MessageReader& reader) { values.push_back(reader.get<Value>()); });
  return values;
}

/// How much the ranks before this one have of something, and how much all have.
struct SumsOverRanks
{
  std::uint64_t before = 0;
  std::uint64_t all = 0;
};

/// A step that sums up a number that every rank has.
inline SumsOverRanks sumOverRanks(Exchange& exchange, std::uint64_t own)
{
  const std::vector<std::uint64_t> numbers = valuesOfRanks(exchange, own);
  SumsOverRanks sums;
  for (std::size_t rank = 0; rank < numbers.size(); ++rank)
  {
    sums.before += rank < rankIndex(exchange.rank()) ? numbers[rank] : 0;
    sums.all += numbers[rank];
  }
  return sums;
}

}

#endif
