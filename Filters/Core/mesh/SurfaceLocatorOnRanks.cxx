// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/SurfaceLocatorOnRanks.h"

#include <utility>

namespace geodesic
{

namespace
{

/// The message about the candidates that this rank owns: for each the number of its point, and the
/// candidate.
Message messageOf(const MeshPartition& surface, const FoundOnRanks& found)
{
  Message message;
  for (std::size_t i = 0; i < found.least.size(); ++i)
  {
    for (FaceCandidate candidate : found.candidates[i])
    {
      if (!candidate.isClosest(found.least[i]) || !surface.isOwn(candidate.face.id))
      {
        continue;
      }
      candidate.corners = surface.globalIds(surface.mesh().triangle(candidate.face.id));
      candidate.face = surface.addressOf(candidate.face.id);
      put(message, i);
      put(message, candidate);
    }
  }
  return message;
}

/// Replaces the candidates of this rank by those of all ranks.
void shareCandidates(const MeshPartition& surface, FoundOnRanks& found)
{
  if (!surface.isDistributed())
  {
    return;
  }
  const Message own = messageOf(surface, found);
  found.candidates.assign(found.least.size(), {});
  readEach(surface.exchange().tellAll(own),
    [&](int, MessageReader& reader)
    {
      const auto point = reader.get<std::size_t>();
      found.candidates[point].push_back(reader.get<FaceCandidate>());
    });
}

} // anonymous namespace

FoundOnRanks searchOnRanks(const MeshPartition& surface, const Box& box, ArrayRange<Vec3> points,
  std::vector<double> limits, double coordinatePrecision,
  const std::function<std::vector<FaceCandidate>(std::size_t)>& search)
{
  FoundOnRanks found;
  found.candidates.resize(points.size());
  found.least = std::move(limits);
  const auto isSearched = [&](std::size_t i, bool isInBox)
  {
    const Vec3& point = points.begin()[i];
    const double distance = box.distanceTo(point);
    const double slack = precisionFor(box, point, coordinatePrecision);
    return isInBox ? distance == 0.0
                   : distance > 0.0 && distance <= found.least[i] + slack && distance < Infinity;
  };
  for (const bool isInBox : { true, false })
  {
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (!isSearched(i, isInBox))
      {
        continue;
      }
      found.candidates[i] = search(i);
      for (const FaceCandidate& candidate : found.candidates[i])
      {
        found.least[i] = std::min(found.least[i], candidate.distance);
      }
    }
    surface.exchange().findLeast(found.least);
  }
  shareCandidates(surface, found);
  return found;
}

}
