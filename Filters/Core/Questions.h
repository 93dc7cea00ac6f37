// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Questions_h
#define geodesic_Questions_h

#include "Exchange.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace geodesic
{

/// Questions that all ranks ask each other, and their answers. Each question is about one item of
/// the rank that asks. Answers come back in the order of the questions, so that the items' numbers
/// stay at home.
class Questions
{
public:
  explicit Questions(Exchange& exchange)
    : exchange_(exchange)
    , messages_(exchange.noMessages())
    , items_(messages_.size())
  {
  }

  /// Asks a rank, which may be this one.
  ///
  /// \param item what the answer is about.
  /// \param question as `answer` reads it.
  template <typename... Values>
  void ask(int rank, std::size_t item, const Values&... question)
  {
    (put(this->messages_[rankIndex(rank)], question), ...);
    this->items_[rankIndex(rank)].push_back(item);
  }

  /// All ranks call this together, once.
  ///
  /// \param answer (MessageReader& question, Message& answer): reads one question that has come,
  ///        and puts its answer, which must not be empty.
  /// \param take (item, MessageReader& answer): reads the answer about one item.
  template <typename Answer, typename Take>
  void exchangeAnswers(Answer&& answer, Take&& take)
  {
    this->replyTo(this->exchange_.step(std::move(this->messages_)), answer, take);
  }

  /// The same where a rank must hear all questions before it answers the first: where it looks
  /// after keys that several ranks have (a rendezvous).
  ///
  /// \param hear (rank, MessageReader& question): reads one question, by the order of the ranks.
  template <typename Hear, typename Answer, typename Take>
  void exchangeAnswers(Hear&& hear, Answer&& answer, Take&& take)
  {
    const std::vector<Message> received = this->exchange_.step(std::move(this->messages_));
    readEach(received, hear);
    this->replyTo(received, answer, take);
  }

private:
  template <typename Answer, typename Take>
  void replyTo(const std::vector<Message>& received, Answer& answer, Take& take)
  {
    std::vector<Message> answers = this->exchange_.noMessages();
    readEach(received,
      [&](int rank, MessageReader& question) { answer(question, answers[rankIndex(rank)]); });
    std::vector<std::size_t> next(this->items_.size(), 0);
    readEach(this->exchange_.step(std::move(answers)),
      [&](int rank, MessageReader& reader)
      { take(this->items_[rankIndex(rank)][next[rankIndex(rank)]++], reader); });
  }

  Exchange& exchange_;
  std::vector<Message> messages_;
  /// The items that each rank is asked about.
  std::vector<std::vector<std::size_t>> items_;
};

}

#endif
