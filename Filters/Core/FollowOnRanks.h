// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FollowOnRanks_h
#define geodesic_FollowOnRanks_h

#include "Job.h"
#include "Questions.h"

#include <limits>
#include <vector>

namespace geodesic
{

/// Follows what leads from rank to rank, such as paths. The states stay with the ranks that want to
/// know where they end. In each round a rank asks, for each open state, the rank whose turn it is,
/// which takes the state as far as it can and answers with the new one. All ranks call this
/// together, until no rank has an open state.
///
/// \param ask (Questions&) -> bool: asks with one State for each item that is open, and tells
///        whether there is one.
/// \param step (const State&): what the asked rank finds. Called on the job's threads.
/// \param tell (what was found, Message&): puts the answer.
/// \param take (item, MessageReader&): reads the answer about one item.
/// \param mostRounds after which states stay open.
template <typename State, typename Ask, typename Step, typename Tell, typename Take>
void followOnRanks(Exchange& exchange, const Job& job, Ask&& ask, Step&& step, Tell&& tell,
  Take&& take, int mostRounds = std::numeric_limits<int>::max())
{
  for (int round = 0; round < mostRounds; ++round)
  {
    Questions questions(exchange);
    if (!exchange.isTrueAnywhere(ask(questions)))
    {
      return;
    }
    std::vector<State> asked;
    std::vector<decltype(step(asked.front()))> found;
    std::size_t next = 0;
    questions.exchangeAnswers([&](int, MessageReader& question)
      { asked.push_back(question.get<State>()); },
      [&](MessageReader& question, Message& answer)
      {
        question.get<State>();
        if (next == 0)
        {
          found.resize(asked.size());
          job.tasks(asked.size(), [&](std::size_t i) { found[i] = step(asked[i]); });
        }
        tell(found[next++], answer);
      },
      take);
  }
}

}

#endif
