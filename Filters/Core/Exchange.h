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

/// What one rank sends to another in one step.
using Message = std::vector<std::byte>;

/// A rank as an index into an array with one element per rank.
inline std::size_t rankIndex(int rank)
{
  return static_cast<std::size_t>(rank);
}

/// Another rank has failed with this message, which this rank reports too.
class FailedElsewhere : public Error
{
public:
  using Error::Error;
};

/// The user has aborted another rank.
class AbortedElsewhere : public Aborted
{
};

/// Communication of the ranks that share one surface. The only way to communicate is a step that
/// all ranks take together (a superstep: Valiant 1990). So no rank can wait for another that does
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
  /// \param messages one for each rank, including this one.
  /// \param least equally many numbers on every rank.
  /// \returns what each rank has sent to this one.
  /// \throws FailedElsewhere, AbortedElsewhere if another rank has called fail() instead.
  virtual std::vector<Message> step(std::vector<Message> messages, std::vector<double>& least) = 0;

  /// Tells all ranks in their next step that this one stops.
  ///
  /// \param why a message for the user; empty if the user has asked to stop.
  /// \returns the message of the lowest rank that fails in that step, which all ranks report.
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
  /// A step in which this rank sends the same message to every rank.
  std::vector<Message> tellAll(const Message& message)
  {
    return this->step(std::vector<Message>(this->noMessages().size(), message));
  }

  std::vector<Message> noMessages() const
  {
    return std::vector<Message>(static_cast<std::size_t>(this->numberOfRanks()));
  }
};

/// The exchange of a process that has the whole surface: it receives what it sends.
class OneRank : public Exchange
{
public:
  /// All such processes share one object, which has no state.
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

/// Appends values to a message as they are in memory: all ranks run the same program on machines of
/// the same kind.
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

/// Appends the number of values and the values; MessageReader::getAll() reads them.
template <typename Value>
void putAll(Message& message, const std::vector<Value>& values)
{
  put(message, values.size());
  put(message, values.data(), values.size());
}

/// Reads values from a message, in the order in which put() appended them.
class MessageReader
{
public:
  explicit MessageReader(const Message& message)
    : next_(message.data())
    , end_(message.data() + message.size())
  {
  }

  bool isAtEnd() const { return this->next_ == this->end_; }

  /// \throws Error if the message ends early.
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

  template <typename Value>
  std::vector<Value> getAll()
  {
    std::vector<Value> values(this->get<std::size_t>());
    this->get(values.data(), values.size());
    return values;
  }

private:
  const std::byte* next_;
  const std::byte* end_;
};

/// Calls visit(int rank, MessageReader&) for each rank's message until it is read to the end.
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

/// A step in which every rank sends some values, or none, to all.
///
/// \returns the values of all ranks, including this one's, in the order of ranks.
template <typename Value>
std::vector<Value> valuesOfRanks(Exchange& exchange, const std::vector<Value>& own)
{
  Message message;
  put(message, own.data(), own.size());
  std::vector<Value> values;
  readEach(exchange.tellAll(message),
    [&](int, MessageReader& reader) { values.push_back(reader.get<Value>()); });
  return values;
}

/// The same with one value of each rank.
template <typename Value>
std::vector<Value> valuesOfRanks(Exchange& exchange, const Value& own)
{
  return valuesOfRanks(exchange, std::vector<Value>{ own });
}

/// The sum of a number over the ranks before this one, and over all ranks.
struct SumsOverRanks
{
  std::uint64_t before = 0;
  std::uint64_t all = 0;
};

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
