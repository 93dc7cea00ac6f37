// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FrontExchange_h
#define geodesic_FrontExchange_h

#include "front/CompleteFaces.h"
#include "front/Mailboxes.h"
#include "front/VertexStates.h"
#include "mesh/MeshPartition.h"

#include <vector>

namespace geodesic
{

/// What the fronts of several ranks tell each other. Each processes the batch's vertices that it
/// has, in the faces that it owns: windows that leave through a seam go to the owners of the faces
/// there, distances found at vertices of several ranks to all of these. Without other ranks there
/// is nothing to tell.
class FrontExchange
{
public:
  explicit FrontExchange(const MeshPartition& surface);

  /// Takes a list along that goes to another rank.
  void take(const SentList& list, WindowPool& pool);
  /// Tells the other ranks that have the vertex.
  void tell(const DistanceUpdate& update);

  /// What has come in a step: lists in the order of the ranks, their blocks from the pool, and
  /// distances, first those of the lower ranks.
  struct Received
  {
    std::vector<SentList> lists;
    std::vector<DistanceUpdate> fromLower;
    std::vector<DistanceUpdate> fromHigher;
  };
  /// Sends what was taken and told, gets what others have sent, and finds the least of each number
  /// over all ranks.
  Received step(std::vector<double>& least, WindowPool& pool);

  /// Faces that have to be complete here are so for their owners.
  void shareNeeded(CompleteFaces& faces);
  /// Distances at vertices that only the halo has, from the owners of its faces.
  void completeHalo(std::vector<double>& distances);
  /// A vertex that is marked here is marked on all ranks that have it.
  void shareMarks(std::vector<std::uint8_t>& marks);

private:
  DistanceUpdate translated(int sender, DistanceUpdate update) const;

  const MeshPartition& surface_;
  /// What is to be sent to each rank.
  std::vector<std::vector<DistanceUpdate>> updates_;
  std::vector<Message> lists_;
};

}

#endif
