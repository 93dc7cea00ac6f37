// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_District_h
#define geodesic_District_h

#include "front/Mailboxes.h"
#include "front/VertexSchedule.h"
#include "front/WaitingLists.h"

#include <vector>

namespace geodesic
{

/// What the front has in one district: its vertices' turns and the lists that wait for them. Only
/// one task at a time works on it.
struct District
{
  District(Id itsNumber, VertexStates& states)
    : number(itsNumber)
    , schedule(states)
  {
  }

  Id number;
  VertexSchedule schedule;
  /// Those on the halfedges opposite its vertices; VertexState::facing is the number of one.
  WaitingLists lists;
  /// Its vertices in the batch at hand, and how many of them had never been processed.
  std::vector<Id> batch;
  std::size_t settled = 0;
  /// How many vertices of the batch, or lists of its mail, the step at hand has done, and whether
  /// that is all.
  std::size_t done = 0;
  bool isDone = true;
  /// Vertices that were processed and have got a smaller distance since.
  std::vector<Id> shortened;
  /// With a distance limit: halfedges with windows within it.
  std::vector<Id> withinLimit;

  /// Where ranks have the surface together: lists for faces of others; what others have sent, to be
  /// taken over before and after what comes from here; paths found last, to be told to others.
  std::vector<SentList> leaving;
  MailBatch fromLower;
  MailBatch fromHigher;
  std::vector<DistanceUpdate> arrivals;
};

}

#endif
