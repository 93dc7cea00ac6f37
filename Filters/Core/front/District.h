// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_District_h
#define geodesic_District_h

#include "front/Mailboxes.h"
#include "front/PassedWindows.h"
#include "front/VertexSchedule.h"
#include "front/WaitingLists.h"

#include <vector>

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

}

#endif
