// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowsWithin_h
#define geodesic_WindowsWithin_h

#include "front/FrontContext.h"

#include <algorithm>
#include <vector>

namespace geodesic
{

/// The windows of a front that have still to pass within a distance, perhaps while they wait for a
/// far vertex.
class WindowsWithin
{
public:
  explicit WindowsWithin(FrontContext& front)
    : front_(front)
  {
  }

  /// Whether a vertex has some, or will emit some.
  bool isAny(double distance)
  {
    if (this->recent_ != NoId && this->areAt(this->recent_, distance))
    {
      return true;
    }
    this->recent_ = NoId;
    const auto areHere = [&](Id vertex)
    {
      const bool areWithin = this->areAt(vertex, distance);
      this->recent_ = areWithin ? vertex : this->recent_;
      return areWithin;
    };
    return std::any_of(this->front_.districts.begin(), this->front_.districts.end(),
      [&](const District& district) { return district.schedule.isAnyWaiting(areHere); });
  }

  /// Makes a batch of the vertices for which they wait in a district.
  void takeVertices(double distance, District& district) const
  {
    district.schedule.passAll();
    std::vector<Id>& vertices = district.batch;
    district.lists.forEach(
      [&](const WaitingLists::List& list)
      {
        if (isWithin(list, distance))
        {
          vertices.push_back(this->front_.mesh.opposite(list.halfedge));
        }
      });
    this->front_.districtNumbers.sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  }

private:
  static bool isWithin(const WaitingLists::List& list, double distance)
  {
    return leastDistance(list.windows.range()) <= distance;
  }

  bool areAt(Id vertex, double distance)
  {
    const VertexState& state = this->front_.vertices[vertex];
    return (this->front_.vertices.isShorter(state) && state.distance <= distance) ||
      this->front_.districtOf(vertex).lists.isAny(state.facing,
        [distance](const WaitingLists::List& list) { return isWithin(list, distance); });
  }

  FrontContext& front_;
  /// A vertex that had some when last asked.
  Id recent_ = NoId;
};

}

#endif
