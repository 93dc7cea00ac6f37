// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/ranks/RankExchange.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#if VTK_MODULE_ENABLE_VTK_ParallelMPI
#include "vtkMPIController.h"
#endif

#include <algorithm>
#include <new>
#include <utility>

namespace geodesic
{

namespace
{

// A header: these, then numbers of which the least is wanted, then the size of the message to each
// rank. Sizes are exact in a double up to 2^53.
constexpr std::size_t Fails = 0;
constexpr std::size_t LengthOfFailure = 1;
constexpr std::size_t CountOfNumbers = 2;
constexpr std::size_t FirstNumber = 3;
/// More numbers take a reduction of their own.
constexpr std::size_t NumbersInHeader = 8;
constexpr std::size_t FirstSize = FirstNumber + NumbersInHeader;

/// Messages that come to no more than this together go through memory that every rank has in
/// reserve. For more, all ranks agree that they have it.
constexpr std::size_t SmallMessages = std::size_t(1) << 20;

/// Longer messages go in pieces: MPI counts by int.
constexpr std::size_t LargestPiece = std::size_t(1) << 30;

constexpr int Tag = 20070;

/// Calls with the beginning and the length of each piece of a message.
template <typename Visit>
void forEachPiece(std::size_t size, Visit&& visit)
{
  for (std::size_t begin = 0; begin < size; begin += LargestPiece)
  {
    visit(begin, static_cast<int>(std::min(LargestPiece, size - begin)));
  }
}

const unsigned char* bytesOf(const std::byte* data)
{
  return reinterpret_cast<const unsigned char*>(data);
}

}

RankExchange::RankExchange(vtkMultiProcessController* controller)
  : controller_(controller)
  , rank_(controller->GetLocalProcessId())
  , numberOfRanks_(controller->GetNumberOfProcesses())
  , header_(FirstSize + static_cast<std::size_t>(this->numberOfRanks_))
  , headers_(this->header_.size() * static_cast<std::size_t>(this->numberOfRanks_))
  , room_(SmallMessages)
{
}

bool RankExchange::isWith(vtkMultiProcessController* controller) const
{
  return this->controller_ == controller && this->rank_ == controller->GetLocalProcessId() &&
    this->numberOfRanks_ == controller->GetNumberOfProcesses();
}

void RankExchange::begin()
{
  this->hasFailed_ = false;
  this->failure_.clear();
}

std::vector<Message> RankExchange::step(std::vector<Message> messages, std::vector<double>& least)
{
  this->throwIfFailed();
  const auto self = rankIndex(this->rank_);
  this->header_[CountOfNumbers] = static_cast<double>(least.size());
  std::copy_n(
    least.begin(), std::min(least.size(), NumbersInHeader), this->header_.begin() + FirstNumber);
  for (std::size_t i = 0; i < messages.size(); ++i)
  {
    const std::size_t size = i == self ? 0 : messages[i].size();
    this->header_[FirstSize + i] = static_cast<double>(size);
  }
  this->gatherHeaders(nullptr);
  this->throwIfFailed();
  this->takeLeast(least);

  std::vector<Message> received = this->makeRoom();
  std::vector<unsigned char*> buffers;
  std::byte* next = this->room_.data();
  for (std::size_t i = 0; i < received.size(); ++i)
  {
    const std::size_t size = this->sizeBetween(static_cast<int>(i), this->rank_);
    std::byte* buffer = received[i].empty() ? next : received[i].data();
    buffers.push_back(reinterpret_cast<unsigned char*>(buffer));
    next += received[i].empty() ? size : 0;
  }
#if VTK_MODULE_ENABLE_VTK_ParallelMPI
  if (auto* controller = vtkMPIController::SafeDownCast(this->controller_))
  {
    this->transferAtOnce(messages, buffers, *controller);
  }
  else
#endif
  {
    this->transferInOrder(messages, buffers);
  }
  for (std::size_t i = 0; i < received.size(); ++i)
  {
    const std::size_t size = this->sizeBetween(static_cast<int>(i), this->rank_);
    if (received[i].empty() && size > 0)
    {
      const auto* bytes = reinterpret_cast<const std::byte*>(buffers[i]);
      received[i].assign(bytes, bytes + size);
    }
  }
  received[self] = std::move(messages[self]);
  return received;
}

std::string RankExchange::fail(const std::string& why)
{
  if (!this->hasFailed_)
  {
    this->gatherHeaders(&why);
  }
  return this->failure_;
}

const double* RankExchange::headerOf(int rank) const
{
  return this->headers_.data() + rankIndex(rank) * this->header_.size();
}

/// Gathers the headers of all ranks and takes over why the first of those that fail does.
///
/// \param failure why this rank fails; null if it does not.
void RankExchange::gatherHeaders(const std::string* failure)
{
  this->header_[Fails] = failure ? 1.0 : 0.0;
  this->header_[LengthOfFailure] = failure ? static_cast<double>(failure->size()) : 0.0;
  this->controller_->AllGather(
    this->header_.data(), this->headers_.data(), static_cast<vtkIdType>(this->header_.size()));
  int failed = 0;
  while (failed < this->numberOfRanks_ && this->headerOf(failed)[Fails] == 0.0)
  {
    ++failed;
  }
  if (failed == this->numberOfRanks_)
  {
    return;
  }
  this->hasFailed_ = true;
  this->failure_ = failed == this->rank_ ? *failure : std::string();
  this->failure_.resize(static_cast<std::size_t>(this->headerOf(failed)[LengthOfFailure]));
  if (!this->failure_.empty())
  {
    this->controller_->Broadcast(
      &this->failure_[0], static_cast<vtkIdType>(this->failure_.size()), failed);
  }
}

void RankExchange::throwIfFailed() const
{
  if (this->hasFailed_ && this->failure_.empty())
  {
    throw AbortedElsewhere();
  }
  if (this->hasFailed_)
  {
    throw FailedElsewhere(this->failure_);
  }
}

void RankExchange::takeLeast(std::vector<double>& least)
{
  const auto count = static_cast<double>(least.size());
  for (int rank = 0; rank < this->numberOfRanks_; ++rank)
  {
    const double* header = this->headerOf(rank);
    if (header[CountOfNumbers] != count)
    {
      throw Error("Ranks are at different places of the work. Give the filter the same properties "
                  "on all ranks.");
    }
    for (std::size_t i = 0; i < std::min(least.size(), NumbersInHeader); ++i)
    {
      least[i] = std::min(least[i], header[FirstNumber + i]);
    }
  }
  if (least.size() > NumbersInHeader)
  {
    const std::vector<double> own(
      least.begin() + static_cast<std::ptrdiff_t>(NumbersInHeader), least.end());
    this->controller_->AllReduce(own.data(), least.data() + NumbersInHeader,
      static_cast<vtkIdType>(own.size()), vtkCommunicator::MIN_OP);
  }
}

std::size_t RankExchange::sizeBetween(int sender, int receiver) const
{
  return static_cast<std::size_t>(this->headerOf(sender)[FirstSize + rankIndex(receiver)]);
}

/// Makes room for what will come, where that is much for any rank. A rank that has no memory for it
/// fails before any message is sent.
///
/// \returns one message a rank, all empty where the room in reserve will do.
std::vector<Message> RankExchange::makeRoom()
{
  std::vector<Message> received = this->noMessages();
  std::size_t most = 0;
  for (int rank = 0; rank < this->numberOfRanks_; ++rank)
  {
    std::size_t size = 0;
    for (int sender = 0; sender < this->numberOfRanks_; ++sender)
    {
      size += this->sizeBetween(sender, rank);
    }
    most = std::max(most, size);
  }
  if (most <= SmallMessages)
  {
    return received;
  }
  double hasRoom = 1.0;
  try
  {
    for (int sender = 0; sender < this->numberOfRanks_; ++sender)
    {
      received[rankIndex(sender)].resize(this->sizeBetween(sender, this->rank_));
    }
  }
  catch (const std::bad_alloc&)
  {
    hasRoom = 0.0;
  }
  double haveRoom = 0.0;
  this->controller_->AllReduce(&hasRoom, &haveRoom, 1, vtkCommunicator::MIN_OP);
  if (haveRoom == 0.0)
  {
    received.clear();
    if (hasRoom == 0.0)
    {
      throw std::bad_alloc(); // which ends in fail()
    }
    this->gatherHeaders(nullptr); // in which that rank fails
    this->throwIfFailed();
  }
  return received;
}

/// One rank after another sends to all others, by their order. Of what remains to be sent, the
/// first is what its sender and its receiver have come to, so that these go on.
void RankExchange::transferInOrder(
  const std::vector<Message>& messages, const std::vector<unsigned char*>& received)
{
  for (int sender = 0; sender < this->numberOfRanks_; ++sender)
  {
    for (int receiver = 0; receiver < this->numberOfRanks_; ++receiver)
    {
      const auto size = static_cast<vtkIdType>(this->sizeBetween(sender, receiver));
      if (size > 0 && sender == this->rank_)
      {
        this->controller_->Send(bytesOf(messages[rankIndex(receiver)].data()), size, receiver, Tag);
      }
      if (size > 0 && receiver == this->rank_)
      {
        this->controller_->Receive(received[rankIndex(sender)], size, sender, Tag);
      }
    }
  }
}

#if VTK_MODULE_ENABLE_VTK_ParallelMPI
/// Sends without waiting.
void RankExchange::transferAtOnce(const std::vector<Message>& messages,
  const std::vector<unsigned char*>& received, vtkMPIController& controller)
{
  std::vector<vtkMPICommunicator::Request> requests;
  for (int rank = 0; rank < this->numberOfRanks_; ++rank)
  {
    // Nothing goes to this rank itself.
    forEachPiece(this->sizeBetween(rank, this->rank_),
      [&](std::size_t begin, int length)
      {
        controller.NoBlockReceive(
          received[rankIndex(rank)] + begin, length, rank, Tag, requests.emplace_back());
      });
  }
  for (int rank = 0; rank < this->numberOfRanks_; ++rank)
  {
    forEachPiece(this->sizeBetween(this->rank_, rank),
      [&](std::size_t begin, int length)
      {
        controller.NoBlockSend(bytesOf(messages[rankIndex(rank)].data() + begin), length, rank, Tag,
          requests.emplace_back());
      });
  }
  for (vtkMPICommunicator::Request& request : requests)
  {
    request.Wait();
  }
}
#endif

}
