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

#include <algorithm>

namespace geodesic
{

/// The state of the front in one district: the schedule of its vertices and the lists that wait for
/// them. Only one task at a time works on it.
struct District
{
  District(Id itsNumber, VertexStates& states, const MeshPartition& surface)
    : number(itsNumber)
    , schedule(states)
    , toRanks(surface)
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

  MailToRanks toRanks;
};

/// What the tasks of a batch share. Between batches Front changes the numbers at the end.
struct FrontContext
{
  const MeshPartition& surface;
  const TriangleMesh& mesh;
  const FrontOptions& options;
  const Districts& districts;
  VertexStates& vertices;
  const CompleteFaces& complete;
  Mailboxes& mailboxes;
  Retention& retention;
  /// The next batch of each district.
  std::vector<VertexSchedule::Outlook>& outlooks;
  /// The largest number of faces that a shortest path can cross.
  Id mostFaces = std::min(this->surface.numberOfGlobalFaces(), MaximumFacesCrossed);
  /// The number of the current batch.
  Id batch = 0;
  /// The longest path that is looked for in the corridor.
  double longestPath =
    this->options.corridor != nullptr ? this->options.corridor->length : Infinity;
};

// The tasks of a batch (paper, section 3.1; as lists after Qin et al. 2016): (1) each vertex sends
// the lists that face it through their faces, (2) each halfedge merges the lists sent to it into
// its own. In both steps a task reads the mesh and the distances that step (1) found unchanged,
// and writes only to its district and its worker. So tasks of several districts may run at the
// same time.

/// Works on a district until it is done (District::isDone) or the worker has to pause. The next
/// call continues there.
using BatchTask = void(const FrontContext& front, FrontWorker& worker, District& district);

/// Step (1): the district's vertices in the batch send their lists.
void processBatch(const FrontContext& front, FrontWorker& worker, District& district);
/// Step (2), first part: takes the distances sent to the district, which may make lists needless.
void receiveUpdates(const FrontContext& front, District& district);
/// Step (2), second part: takes the lists sent to the district, and finds its next batch.
void receiveLists(const FrontContext& front, FrontWorker& worker, District& district);

/// Accepts the path to a vertex of the district if it is shorter than the known one.
void acceptUpdate(const FrontContext& front, District& district, const DistanceUpdate& update);
/// Sends windows, at least one, that leave a face through a halfedge to its siblings.
void sendWindows(const FrontContext& front, FrontWorker& worker, District& sender, Id halfedge,
  WindowRange windows);

}

#endif
