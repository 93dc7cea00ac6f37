// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RankExchange_h
#define geodesic_RankExchange_h

#include "Exchange.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkMPIController;
class vtkMultiProcessController;

namespace geodesic
{

/// The exchange between the processes of a controller.
///
/// In each step all ranks first gather a header from each: whether it fails, the numbers of which
/// the least is wanted, and how much it sends to whom. So every rank knows of every failure, and of
/// the messages that will come, before it waits for any. A controller of MPI then sends all
/// messages at once. With other controllers ranks send in an order in which no two wait for each
/// other.
class RankExchange : public Exchange
{
public:
  /// \param controller of two or more processes, all of which make such an exchange.
  explicit RankExchange(vtkMultiProcessController* controller);

  int rank() const override { return this->rank_; }
  int numberOfRanks() const override { return this->numberOfRanks_; }
  /// Whether this is still the exchange between the processes of a controller, which may have
  /// changed.
  bool isWith(vtkMultiProcessController* controller) const;

  using Exchange::step;
  std::vector<Message> step(std::vector<Message> messages, std::vector<double>& least) override;

  /// Sends nothing if this rank knows already that another rank has failed.
  std::string fail(const std::string& why) override;

  /// Forgets a failure, for the next execution.
  void begin();

private:
  const double* headerOf(int rank) const;
  void gatherHeaders(const std::string* failure);
  void throwIfFailed() const;
  void takeLeast(std::vector<double>& least);
  std::vector<Message> makeRoom();
  void transferInOrder(
    const std::vector<Message>& messages, const std::vector<unsigned char*>& received);
  void transferAtOnce(const std::vector<Message>& messages,
    const std::vector<unsigned char*>& received, vtkMPIController& controller);
  std::size_t sizeBetween(int sender, int receiver) const;

  vtkSmartPointer<vtkMultiProcessController> controller_;
  int rank_;
  int numberOfRanks_;
  /// This rank's header, and those of all ranks one after another.
  std::vector<double> header_;
  std::vector<double> headers_;
  /// Room for small messages, in reserve.
  std::vector<std::byte> room_;
  bool hasFailed_ = false;
  /// Why; empty if the user has asked to stop.
  std::string failure_;
};

}

#endif
