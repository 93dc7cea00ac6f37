// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowsWithin_h
#define geodesic_WindowsWithin_h

#include "front/FrontContext.h"

#include <algorithm>
#include <vector>

namespace geodesic
{

/// Finds windows within a distance that have not passed their faces yet, perhaps because they wait
/// for a far vertex.
class WindowsWithin
{
public:
  explicit WindowsWithin(FrontContext& front)
    : front_(front)
  {
  }

  /// Whether such windows wait, or a vertex within the distance will emit windows.
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

  /// Makes a batch of those vertices of a district for which such windows wait.
  void takeVertices(double distance, District& district) const
  {
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
  /// The vertex that isAny() found last; NoId if there was none.
  Id recent_ = NoId;
};

}

#endif
