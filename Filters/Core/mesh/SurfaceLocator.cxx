// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/SurfaceLocator.h"

#include "Tolerance.h"

#include <algorithm>
#include <iterator>

namespace geodesic
{

namespace
{

/// A candidate of one rank, as it is sent to all.
struct CandidateMessage
{
  std::size_t point;
  /// With global ids of the vertices.
  FaceLocator::Candidate candidate;
};

/// Ranks exchange the candidates of so many points at a time, which bounds the size of messages.
constexpr std::size_t PointsPerExchange = 4096;

/// Points between two calls of the progress callback.
constexpr std::size_t PointsPerReport = 256;

/// Searching the first point builds most of the tree, which takes this share of the progress.
constexpr double FirstPoint = 0.5;

/// Chooses among the candidates of all ranks, for each point.
ClosestFaces chooseFaces(const std::vector<Message>& told, const std::vector<double>& least)
{
  std::vector<std::vector<FaceLocator::Candidate>> candidates(least.size());
  readEach(told,
    [&](int, MessageReader& reader)
    {
      const auto message = reader.get<CandidateMessage>();
      candidates[message.point].push_back(message.candidate);
    });
  ClosestFaces result(least.size());
  for (std::size_t i = 0; i < least.size(); ++i)
  {
    for (const FaceLocator::Candidate& chosen : FaceLocator::chosen(candidates[i]))
    {
      result[i].push_back({ chosen.face, chosen.isClosestUpToRounding(least[i]) });
    }
    std::sort(result[i].begin(), result[i].end());
  }
  return result;
}

} // anonymous namespace

/// Whether this rank searches for a point: first those in the box of its own faces, then those that
/// are not, unless another rank has found a face closer than the box.
bool SurfaceLocator::isSearched(
  const Vec3& point, bool isInBox, double least, double coordinatePrecision) const
{
  const double distance = this->box_.distanceTo(point);
  const double slack = tolerance::SnapRoundings * coordinatePrecision *
    std::max(largestCoordinate(point), this->box_.largestCoordinate());
  return isInBox ? distance == 0.0
                 : distance > 0.0 && distance <= least + slack && distance < Infinity;
}

/// What all ranks are told of the candidates that this rank owns.
Message SurfaceLocator::messageOf(
  const std::vector<Candidates>& candidates, const std::vector<double>& least) const
{
  Message message;
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    for (FaceLocator::Candidate candidate : candidates[i])
    {
      if (!candidate.isClosest(least[i]) || !this->surface_.isOwn(candidate.face.id))
      {
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k)
      {
        candidate.corners[k] = this->surface_.globalId(candidate.corners[k]);
        candidate.support[k] = candidate.support[k] == NoId ? NoId : candidate.corners[k];
      }
      candidate.face = this->surface_.addressOf(candidate.face.id);
      put(message, CandidateMessage{ i, candidate });
    }
  }
  return message;
}

ClosestFaces SurfaceLocator::closest(
  const std::vector<Vec3>& points, double coordinatePrecision, const ProgressCallback& callback)
{
  if (!points.empty() && !this->locator_)
  {
    const TriangleMesh& mesh = this->surface_.mesh();
    this->locator_ = std::make_unique<FaceLocator>(mesh);
    for (Id face = this->surface_.firstOwnFace(); face < this->surface_.endOfOwnFaces(); ++face)
    {
      for (const Id vertex : mesh.triangle(face))
      {
        this->box_.add(mesh.point(vertex));
      }
    }
  }
  Exchange& exchange = this->surface_.exchange();
  const ProgressCallback rising = ascending(callback);
  const ProgressCallback growing = progressBetween(rising, 0.0, FirstPoint);
  std::size_t searched = 0;
  ClosestFaces result;
  result.reserve(points.size());
  while (result.size() < points.size())
  {
    const Vec3* some = points.data() + result.size();
    std::vector<double> least(std::min(PointsPerExchange, points.size() - result.size()), Infinity);
    std::vector<Candidates> candidates(least.size());
    for (const bool isInBox : { true, false })
    {
      for (std::size_t i = 0; i < least.size(); ++i)
      {
        if (this->isSearched(some[i], isInBox, least[i], coordinatePrecision))
        {
          if (searched % PointsPerReport == 0)
          {
            const double done = static_cast<double>(searched) / static_cast<double>(points.size());
            reportProgress(rising, searched == 0 ? 0.0 : FirstPoint + (1.0 - FirstPoint) * done);
          }
          ++searched;
          candidates[i] = this->locator_->candidates(some[i], coordinatePrecision, growing);
          for (const FaceLocator::Candidate& candidate : candidates[i])
          {
            least[i] = std::min(least[i], candidate.distance);
          }
        }
      }
      exchange.findLeast(least);
    }
    ClosestFaces chosen = chooseFaces(exchange.tellAll(this->messageOf(candidates, least)), least);
    std::move(chosen.begin(), chosen.end(), std::back_inserter(result));
  }
  return result;
}

}
