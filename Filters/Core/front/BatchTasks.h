// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BatchTasks_h
#define geodesic_BatchTasks_h

#include "front/CompleteFaces.h"
#include "front/Front.h"
#include "front/FrontWorker.h"
#include "front/Outbox.h"
#include "front/VertexStates.h"
#include "front/WaitingLists.h"

namespace geodesic
{

/// What the tasks of a batch do (paper, section 3.1; as lists after Qin et al. 2016): (1) each
/// vertex sends the lists that face it through their faces, (2) each halfedge merges the lists that
/// were sent to it into its own. Tasks read the distances and write only what is theirs: the lists
/// of the halfedges at hand and their worker. So they may run at the same time.
class BatchTasks
{
public:
  BatchTasks(const TriangleMesh& mesh, const FrontOptions& options, const VertexStates& vertices,
    const CompleteFaces& complete, WaitingLists& waiting, Retention& retention)
    : mesh_(mesh)
    , options_(options)
    , vertices_(vertices)
    , complete_(complete)
    , waiting_(waiting)
    , retention_(retention)
    , mostFaces_(options.part ? options.part->numberOfFacesOfWhole() : mesh.numberOfFaces())
  {
  }

  /// Step (1) for a vertex.
  void process(FrontWorker& worker, Id vertex, Id batch);
  /// Step (2) for a group of the outbox.
  void receive(FrontWorker& worker, const Outbox& outbox, std::size_t group);

  /// Whether no path that is looked for passes the vertex, by the distance known.
  bool isOutsideCorridor(Id vertex) const
  {
    const Corridor* corridor = this->options_.corridor;
    return corridor != nullptr &&
      this->vertices_.distance(vertex) + corridor->lowerBounds[vertex] > corridor->length;
  }

  /// Sends windows that leave a face through a halfedge to its siblings.
  void send(FrontWorker& worker, Id halfedge, const WindowRange& windows) const;
  /// Hands the list of a halfedge over to the retention.
  ///
  /// \param ends the distances at the halfedge's ends.
  void retire(FrontWorker& worker, Id halfedge, const std::array<double, 2>& ends, Id batch) const;

  /// Fetch what step (1) and step (2) will need.
  void prefetchFacing(Id vertex) const;
  void prefetchReceiver(Id halfedge) const;

private:
  bool isOutsideCorridor(Id halfedge, const WindowRange& windows) const;
  /// Whether the face is worked on here, not on another rank.
  bool isOwn(Id face) const
  {
    return this->options_.part == nullptr || this->options_.part->isOwn(face);
  }
  Id numberInWhole(Id vertex) const
  {
    return this->options_.part == nullptr ? vertex : this->options_.part->numberInWhole(vertex);
  }
  void relaxEdges(FrontWorker& worker, Id vertex) const;
  void emit(FrontWorker& worker, Id vertex) const;
  void emit(FrontWorker& worker, Id vertex, const EmittedInterval& interval) const;
  void propagate(FrontWorker& worker, Id halfedge, Id batch) const;
  void mergeNeighboursOf(FrontWorker& worker, Id halfedge) const;
  void mergeInto(FrontWorker& worker, Id halfedge, const WindowBlock& block) const;

  const TriangleMesh& mesh_;
  const FrontOptions& options_;
  const VertexStates& vertices_;
  const CompleteFaces& complete_;
  WaitingLists& waiting_;
  Retention& retention_;
  /// How many faces a shortest path can cross.
  Id mostFaces_;
};

}

#endif
