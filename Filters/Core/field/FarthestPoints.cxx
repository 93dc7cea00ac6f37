// SPDX-License-Identifier: BSD-3-Clause
#include "field/FarthestPoints.h"

#include "Tolerance.h"
#include "front/Front.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// Keeps no windows, but the distances, side by side: they are searched for each point.
class KnownDistances : public KeepNone
{
public:
  explicit KnownDistances(Id vertices)
    : known_(vertices, NotReached)
  {
  }

  void advance(const FrontState& front) override
  {
    this->exact_ = front.distances;
    for (const Id vertex : front.settled)
    {
      this->known_[vertex] = front.distances(vertex);
    }
  }

  FarthestPoint farthest() const
  {
    const double largest = *std::max_element(this->known_.begin(), this->known_.end());
    const auto first = std::find_if(this->known_.begin(), this->known_.end(),
      [least = largest * (1.0 - tolerance::Tie)](double distance) { return distance >= least; });
    const auto vertex = static_cast<Id>(first - this->known_.begin());
    return { vertex, *first > 0.0 ? this->exact_(vertex) : 0.0 };
  }

private:
  /// Below any distance.
  static constexpr double NotReached = -1.0;

  /// Of vertices that were settled, as they were then: up to a tie.
  std::vector<double> known_;
  VertexNumbers exact_ = {};
};

} // anonymous namespace

FarthestPoints farthestPoints(const TriangleMesh& mesh, const std::vector<SourceCurve>& source,
  std::size_t count, const Job& job)
{
  FarthestPoints result;
  KnownDistances known(mesh.numberOfVertices());
  FrontOptions options;
  options.job = job.part(0.0, 0.0);
  options.laterSources = [&]
  {
    const FarthestPoint next = known.farthest();
    if (result.points.size() == count || !(next.distance > 0.0))
    {
      return SourceWindows();
    }
    job.look(static_cast<double>(result.points.size()) / static_cast<double>(count));
    result.points.push_back(next);
    return startingWindows(mesh, { pointCurve(SurfacePoint::atVertex(next.vertex)) }, options.job);
  };
  result.vertexDistances = propagate(mesh, source, options, known).vertexDistances;
  return result;
}

}
