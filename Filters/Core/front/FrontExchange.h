// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FrontExchange_h
#define geodesic_FrontExchange_h

#include "front/CompleteFaces.h"
#include "front/Mailboxes.h"
#include "front/VertexStates.h"
#include "mesh/MeshPartition.h"

#include <array>
#include <vector>

namespace geodesic
{

/// The messages between the fronts of several ranks. Each rank processes the batch's vertices in
/// the faces that it owns. Windows that leave through a seam go to the owners of the faces behind
/// it; distances found at vertices of several ranks go to all of these.
class FrontExchange
{
public:
  explicit FrontExchange(const MeshPartition& surface)
    : surface_(surface)
    , messages_(surface.exchange().noMessages())
  {
  }

  /// Adds a list for another rank to the next step's messages.
  void addList(const SentList& list, WindowPool& pool);
  /// Adds a distance for the other ranks that have the vertex.
  void addUpdate(const DistanceUpdate& update);

  /// What a step has received: lists in the order of the ranks, in blocks of the pool, and
  /// distances of the lower and of the higher ranks.
  struct Received
  {
    std::vector<SentList> lists;
    std::array<std::vector<DistanceUpdate>, 2> updates;
  };
  /// Sends all added lists and distances, receives those of other ranks, and finds the least of
  /// each number over all ranks.
  Received step(std::vector<double>& least, WindowPool& pool);

  /// Marks faces that must be complete on this rank as needed on their owners.
  void shareNeeded(CompleteFaces& faces);
  /// Gets the distances at vertices that only the halo has from the owners of its faces.
  void completeHalo(std::vector<double>& distances);
  /// Marks each marked vertex on all ranks that have it.
  void shareMarks(std::vector<std::uint8_t>& marks);

private:
  const MeshPartition& surface_;
  /// For each rank, what the next step sends to it: lists, each a halfedge and its windows, and
  /// distances, each behind NoId.
  std::vector<Message> messages_;
};

}

#endif
