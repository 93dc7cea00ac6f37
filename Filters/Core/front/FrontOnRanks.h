// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FrontOnRanks_h
#define geodesic_FrontOnRanks_h

#include "front/FrontContext.h"
#include "mesh/MeshPartition.h"

#include <vector>

namespace geodesic
{

/// What the fronts of several ranks send each other. In one process all of this does nothing.
///
/// Each rank processes the batch's vertices in the faces that it owns. Windows that leave through a
/// seam go to the owners of the faces behind it; distances found at vertices of several ranks go to
/// all of these. A batch is a superstep with two exchanges, one after each of its steps. All
/// ranks have the same first and last key of a batch.
///
/// All ranks make each call together, except addUpdate().
class FrontOnRanks
{
public:
  /// All that is given must outlive this.
  ///
  /// \param pool for lists that come from other ranks.
  FrontOnRanks(FrontContext& front, WindowPool& pool)
    : front_(front)
    , surface_(front.surface)
    , pool_(pool)
    , messages_(front.surface.exchange().noMessages())
  {
  }

  /// Sends a distance with the next exchange, to the other ranks that have the vertex.
  void addUpdate(const DistanceUpdate& update);
  /// After step (1): sends the lists that leave this rank and the distances found, and puts those
  /// of other ranks into the mailboxes.
  void exchangeLists();
  /// After step (2): sends the distances found there, and finds the next batch of all ranks.
  ///
  /// \param next that of this rank. A vertex whose distance another rank sends here waits on that
  ///        rank with the same key, so the distances received change nothing.
  /// \returns the distances of other ranks.
  std::vector<DistanceUpdate> exchangeArrivals(VertexSchedule::Outlook& next);
  /// The largest distance that the ranks' retentions need: if there are several, as it was at the
  /// last exchangeArrivals().
  double neededDistance() const;

  /// Marks faces that must be complete on this rank as needed on their owners.
  void shareNeeded(CompleteFaces& faces);
  /// Marks each marked vertex on all ranks that have it.
  void shareMarks(std::vector<std::uint8_t>& marks);
  /// Gets the distances at vertices that only the halo has from the owners of its faces.
  void completeHalo(std::vector<double>& distances);

private:
  void addList(const HalfedgeList& list);
  /// Exchanges the messages, and calls accept(const DistanceUpdate&, bool isOfHigherRank) for the
  /// distances of other ranks, in the order of the ranks. Lists go to the mailboxes.
  template <typename Accept>
  void step(std::vector<double>& least, const Accept& accept);

  FrontContext& front_;
  const MeshPartition& surface_;
  WindowPool& pool_;
  /// For each rank, what the next step sends to it: lists, each a halfedge and its windows, and
  /// distances, each behind NoId.
  std::vector<Message> messages_;
  double neededDistance_ = Infinity;
};

}

#endif
