// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BatchTasks_h
#define geodesic_BatchTasks_h

#include "front/CompleteFaces.h"
#include "front/District.h"
#include "front/Districts.h"
#include "front/Front.h"
#include "front/FrontWorker.h"
#include "front/Mailboxes.h"
#include "front/VertexStates.h"

namespace geodesic
{

/// What the tasks of a batch do (paper, section 3.1; as lists after Qin et al. 2016): (1) each
/// vertex sends the lists that face it through their faces, (2) each halfedge merges the lists that
/// were sent to it into its own. In both a task reads the mesh and the distances that (1) found
/// unchanged, and writes what is its district's and its worker's; so tasks of several districts may
/// run at the same time.
class BatchTasks
{
public:
  BatchTasks(const MeshPartition& surface, const FrontOptions& options, const Districts& districts,
    VertexStates& vertices, const CompleteFaces& complete, Mailboxes& post, Retention& retention)
    : surface_(surface)
    , mesh_(surface.mesh())
    , options_(options)
    , districts_(districts)
    , vertices_(vertices)
    , complete_(complete)
    , post_(post)
    , retention_(retention)
    , mostFaces_(surface.numberOfGlobalFaces())
  {
  }

  /// Step (1) for the vertices of a district that are in the batch, on from where it paused.
  void process(FrontWorker& worker, District& district, Id batch);
  /// Step (2) for the mail of a district: distances first, which may make lists needless.
  void receiveUpdates(District& district);
  /// Lists, on from where it paused.
  void receiveLists(FrontWorker& worker, District& district);

  /// Takes a path over where it is shorter than the one known.
  void shorten(District& district, const DistanceUpdate& update);
  /// Sends windows that leave a face through a halfedge to its siblings.
  void send(FrontWorker& worker, District& sender, Id halfedge, const WindowRange& windows);
  /// Hands a list that was taken from its halfedge over to the retention.
  void retire(FrontWorker& worker, District& district, const PassedList& list, Id batch) const;

private:
  /// Whether no path that is looked for passes the vertex, by the distance known.
  bool isOutsideCorridor(Id vertex) const
  {
    const Corridor* corridor = this->options_.corridor;
    return corridor != nullptr &&
      this->vertices_.distance(vertex) + corridor->lowerBounds[vertex] > corridor->length;
  }

  bool isOutsideCorridor(Id halfedge, const WindowRange& windows) const;
  /// Whether the face is worked on here, not on another rank.
  bool isOwn(Id face) const { return this->surface_.isOwn(face); }
  bool process(FrontWorker& worker, District& district, Id vertex, Id batch);
  void tell(District& sender, const DistanceUpdate& update);
  void relaxEdges(District& district, Id vertex);
  bool isOutgoingBeyond(Id halfedge, Id vertex) const;
  void emit(FrontWorker& worker, District& district, Id vertex);
  void emit(FrontWorker& worker, District& district, Id vertex, const EmittedInterval& interval);
  void propagate(FrontWorker& worker, District& district, Id list, Id batch);
  void mergeNeighboursOf(FrontWorker& worker, Id halfedge, WindowBlock& block) const;
  void receive(FrontWorker& worker, District& district, const SentList& sent);
  std::size_t receiveLists(
    FrontWorker& worker, District& district, const std::vector<SentList>& lists, std::size_t first);
  void mergeInto(FrontWorker& worker, District& district, Id list, const WindowBlock& block) const;
  /// Fetch what the steps will need.
  void prefetchFacing(const District& district, Id vertex) const;

  const MeshPartition& surface_;
  const TriangleMesh& mesh_;
  const FrontOptions& options_;
  const Districts& districts_;
  VertexStates& vertices_;
  const CompleteFaces& complete_;
  Mailboxes& post_;
  Retention& retention_;
  /// How many faces a shortest path can cross.
  Id mostFaces_;
};

}

#endif
