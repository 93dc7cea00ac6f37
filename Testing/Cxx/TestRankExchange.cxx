// SPDX-License-Identifier: BSD-3-Clause
// Under MPI: whatever ranks send each other arrives, whoever fails ends all with one message, and
// none waits for ever. Messages go at once as MPI has it, and in an order for other controllers.
#include "PolyData/ranks/RankExchange.h"

#include "vtkMPIController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cstdint>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace
{

using geodesic::Message;
using geodesic::RankExchange;

/// A controller as any other that is not MPI's own: all goes through its communicator.
class PlainController : public vtkMultiProcessController
{
public:
  static PlainController* New() { VTK_STANDARD_NEW_BODY(PlainController); }
  vtkTypeMacro(PlainController, vtkMultiProcessController);
  void Initialize(int*, char***, int) override {}
  void Initialize(int*, char***) override {}
  void Finalize() override {}
  void Finalize(int) override {}
  void SingleMethodExecute() override {}
  void MultipleMethodExecute() override {}
  void CreateOutputWindow() override {}
  void Use(vtkCommunicator* communicator)
  {
    this->Communicator = communicator;
    this->RMICommunicator = communicator;
  }
};

class Checks
{
public:
  explicit Checks(int rank)
    : Rank(rank)
  {
  }
  void That(bool holds, const std::string& what)
  {
    if (!holds)
    {
      std::cout << "FAILED on rank " << this->Rank << ": " << what << std::endl;
      ++this->Failures;
    }
  }
  int Failures = 0;

private:
  int Rank;
};

/// What a rank sends another in a step, which both can tell.
Message MessageBetween(int from, int to, int step)
{
  std::mt19937_64 random(static_cast<std::uint64_t>((step * 64 + from) * 64 + to));
  const int kind = static_cast<int>(random() % 4);
  // None, a few bytes, some, and now and then more than goes through the room in reserve.
  const std::size_t most = kind == 0 ? 1 : kind == 1 ? 40 : kind == 2 ? 30000 : 3000000;
  Message message(random() % most);
  for (std::byte& byte : message)
  {
    byte = static_cast<std::byte>(random());
  }
  return message;
}

void SendAtRandom(RankExchange& exchange, Checks& check)
{
  const int rank = exchange.rank();
  const int ranks = exchange.numberOfRanks();
  for (int step = 0; step < 60; ++step)
  {
    std::vector<Message> messages;
    for (int to = 0; to < ranks; ++to)
    {
      messages.push_back(MessageBetween(rank, to, step));
    }
    // More numbers than the header holds every now and then.
    std::vector<double> least;
    for (int i = 0; i < step % 12; ++i)
    {
      least.push_back((i + rank) % ranks + 10.0 * i);
    }
    const std::vector<Message> received = exchange.step(std::move(messages), least);
    for (int from = 0; from < ranks; ++from)
    {
      check.That(received[static_cast<std::size_t>(from)] == MessageBetween(from, rank, step),
        "step " + std::to_string(step) + " brings what rank " + std::to_string(from) + " has sent");
    }
    for (std::size_t i = 0; i < least.size(); ++i)
    {
      check.That(least[i] == 10.0 * static_cast<double>(i), "the least number is found");
    }
  }
}

/// Goes through steps until some rank fails.
void FailInAStep(RankExchange& exchange, Checks& check)
{
  for (int failing = 0; failing < exchange.numberOfRanks(); ++failing)
  {
    exchange.begin();
    const std::string why = "rank " + std::to_string(failing) + " has no more paper";
    std::string told;
    try
    {
      for (int step = 0; step < 5; ++step)
      {
        if (step == 3 && exchange.rank() >= failing)
        {
          told = exchange.fail(
            exchange.rank() == failing ? why : "what a higher rank says does not count");
          break;
        }
        exchange.leastOf(1.0);
      }
    }
    catch (const geodesic::FailedElsewhere& error)
    {
      told = error.what();
    }
    check.That(told == why, "all say \"" + why + "\", not \"" + told + "\"");
    check.That(exchange.fail("later") == why, "a failure that all know of is not told again");
  }
}

void AbortInAStep(RankExchange& exchange, Checks& check)
{
  exchange.begin();
  bool isAborted = false;
  if (exchange.rank() == exchange.numberOfRanks() - 1)
  {
    isAborted = exchange.fail("").empty();
  }
  else
  {
    try
    {
      exchange.leastOf(1.0);
    }
    catch (const geodesic::Aborted&)
    {
      isAborted = true;
    }
  }
  check.That(isAborted, "where one rank is stopped all are");
  exchange.begin();
  check.That(exchange.leastOf(exchange.rank()) == 0.0, "and can begin anew");
}

void DisagreeOnNumbers(RankExchange& exchange, Checks& check)
{
  exchange.begin();
  bool hasThrown = false;
  try
  {
    std::vector<double> numbers(exchange.rank() == 0 ? 1 : 2, 1.0);
    exchange.findLeast(numbers);
  }
  catch (const geodesic::Error&)
  {
    hasThrown = true;
  }
  check.That(hasThrown, "ranks that are at different places of the work notice it");
}

}

int TestRankExchange(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  Checks check(controller->GetLocalProcessId());
  vtkNew<PlainController> plain;
  plain->Use(controller->GetCommunicator());
  for (vtkMultiProcessController* ranks : { static_cast<vtkMultiProcessController*>(controller),
         static_cast<vtkMultiProcessController*>(plain) })
  {
    RankExchange exchange(ranks);
    SendAtRandom(exchange, check);
    FailInAStep(exchange, check);
    AbortInAStep(exchange, check);
    DisagreeOnNumbers(exchange, check);
  }
  plain->Use(nullptr);
  const int failures = check.Failures;
  int all = 0;
  controller->AllReduce(&failures, &all, 1, vtkCommunicator::SUM_OP);
  controller->Finalize();
  return all == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
