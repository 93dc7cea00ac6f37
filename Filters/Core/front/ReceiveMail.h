// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ReceiveMail_h
#define geodesic_ReceiveMail_h

#include "front/FrontContext.h"

namespace geodesic
{

/// The second step of a batch in a district: takes the distances sent to it, merges the lists sent
/// to it into those that wait already, and finds the district's next batch.
void receiveMail(FrontContext& front, FrontWorker& worker, District& district);

/// Accepts the path to a vertex of the district if it is shorter than the known one.
void acceptUpdate(FrontContext& front, District& district, const DistanceUpdate& update);

/// The path to the apex of a face through a list on the opposite halfedge.
DistanceUpdate arrivalThrough(
  const FrontContext& front, Id halfedge, Vec2 apex, const ApexDistance& path);

}

#endif
