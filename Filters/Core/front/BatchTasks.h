// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BatchTasks_h
#define geodesic_BatchTasks_h

#include "front/CompleteFaces.h"
#include "front/Districts.h"
#include "front/Front.h"
#include "front/FrontWorker.h"
#include "front/Mailboxes.h"
#include "front/PassedWindows.h"
#include "front/VertexSchedule.h"
#include "front/VertexStates.h"
#include "front/WaitingLists.h"

namespace geodesic
{

/// The state of the front in one district: the schedule of its vertices and the lists that wait for
/// them. Only one task at a time works on it.
struct District
{
  District(Id itsNumber, VertexStates& states)
    : number(itsNumber)
    , schedule(states)
  {
  }

  Id number;
  VertexSchedule schedule;
  /// The lists on the halfedges opposite its vertices. VertexState::facing is the number of one of
  /// them.
  WaitingLists lists;
  /// What is remembered of lists that went through these halfedges.
  PassedWindows passed;
  /// Its vertices in the current batch, and how many of them were never processed before.
  std::vector<Id> batch;
  std::size_t settled = 0;
  /// How many vertices of the batch, or lists in its mailbox, the current step has done, and
  /// whether that is all.
  std::size_t done = 0;
  bool isDone = true;
  /// Processed vertices that have got a smaller distance since.
  std::vector<Id> shortened;
  /// With a distance limit: halfedges with windows within it.
  std::vector<Id> withinLimit;

  /// If ranks share the surface: lists for faces of other ranks; what other ranks have sent, to be
  /// taken before and after this rank's own mail; paths found last, to be sent to other ranks.
  std::vector<SentList> leaving;
  MailBatch fromLower;
  MailBatch fromHigher;
  std::vector<DistanceUpdate> arrivals;
};

/// The tasks of a batch (paper, section 3.1; as lists after Qin et al. 2016): (1) each vertex sends
/// the lists that face it through their faces, (2) each halfedge merges the lists sent to it into
/// its own. In both steps a task reads the mesh and the distances that step (1) found unchanged,
/// and writes only to its district and its worker. So tasks of several districts may run at the
/// same time.
class BatchTasks
{
public:
  BatchTasks(const MeshPartition& surface, const FrontOptions& options, const Districts& districts,
    VertexStates& vertices, const CompleteFaces& complete, Mailboxes& mailboxes,
    Retention& retention)
    : surface_(surface)
    , mesh_(surface.mesh())
    , options_(options)
    , districts_(districts)
    , vertices_(vertices)
    , complete_(complete)
    , mailboxes_(mailboxes)
    , retention_(retention)
    , mostFaces_(surface.numberOfGlobalFaces())
    , longestPath_(options.corridor != nullptr ? options.corridor->length : Infinity)
  {
  }

  /// Step (1) for the district's vertices in the batch; continues where it paused.
  void processBatch(FrontWorker& worker, District& district, Id batch);
  /// Between batches: narrows the corridor.
  void limitPaths(double longest) { this->longestPath_ = std::min(this->longestPath_, longest); }
  /// Step (2), first part: takes the distances sent to the district, which may make lists needless.
  void receiveUpdates(District& district);
  /// Step (2), second part: takes the lists sent to the district; continues where it paused.
  void receiveLists(FrontWorker& worker, District& district);

  /// Accepts a path if it is shorter than the known one.
  void shorten(District& district, const DistanceUpdate& update);
  /// Sends windows that leave a face through a halfedge to its siblings.
  void send(FrontWorker& worker, District& sender, Id halfedge, const WindowRange& windows);
  /// Hands a list that was removed from its halfedge to the retention.
  void retire(FrontWorker& worker, District& district, const PassedList& list, Id batch) const;

private:
  /// Whether the known distance shows that no path in the corridor passes the vertex.
  bool isOutsideCorridor(Id vertex) const
  {
    const Corridor* corridor = this->options_.corridor;
    return corridor != nullptr &&
      this->vertices_.distance(vertex) + corridor->lowerBounds[vertex] > this->longestPath_;
  }

  bool isOutsideCorridor(Id halfedge, const WindowRange& windows) const;
  /// Whether this rank owns the face.
  bool isOwn(Id face) const { return this->surface_.isOwn(face); }
  bool processVertex(FrontWorker& worker, District& district, Id vertex, Id batch);
  void settle(FrontWorker& worker, District& district, Id vertex);
  void sendUpdate(District& sender, const DistanceUpdate& update);
  void relaxEdges(District& district, Id vertex);
  bool isOutgoingBeyond(Id halfedge, Id vertex) const;
  void emitWindows(FrontWorker& worker, District& district, Id vertex);
  void emitThrough(
    FrontWorker& worker, District& district, Id vertex, const EmittedInterval& interval);
  void propagate(FrontWorker& worker, District& district, Id list, Id batch);
  void mergeNeighboursOf(FrontWorker& worker, Id halfedge, WindowBlock& block) const;
  void remember(
    FrontWorker& worker, District& district, Id halfedge, const WindowRange& passed) const;
  bool isNeededOn(const District& district, Id halfedge) const;
  void receiveList(FrontWorker& worker, District& district, SentList sent);
  void cutByPassed(FrontWorker& worker, const District& district, SentList& sent) const;
  std::size_t receiveFrom(
    FrontWorker& worker, District& district, const std::vector<SentList>& lists, std::size_t first);
  /// Whether a halfedge's face is thin.
  bool isThin(Id halfedge) const
  {
    return this->mesh_.shape(TriangleMesh::faceOf(halfedge)).isThin();
  }
  void mergeInto(FrontWorker& worker, District& district, Id list, const WindowBlock& block) const;
  /// Prefetch the memory that a step will use.
  void prefetchFacing(const District& district, Id vertex) const;

  const MeshPartition& surface_;
  const TriangleMesh& mesh_;
  const FrontOptions& options_;
  const Districts& districts_;
  VertexStates& vertices_;
  const CompleteFaces& complete_;
  Mailboxes& mailboxes_;
  Retention& retention_;
  /// The largest number of faces that a shortest path can cross.
  Id mostFaces_;
  /// Of those looked for in the corridor.
  double longestPath_;
};

}

#endif
