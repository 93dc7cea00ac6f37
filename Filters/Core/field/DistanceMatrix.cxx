// SPDX-License-Identifier: BSD-3-Clause
#include "field/DistanceMatrix.h"

#include "field/RetentionAround.h"
#include "field/SegmentEnvelope.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace geodesic
{

namespace
{

using Matrix = std::vector<std::vector<double>>;

/// For each face whether it has a point of the source.
std::vector<std::uint8_t> facesAt(const TriangleMesh& mesh, const std::vector<SourceCurve>& source)
{
  std::vector<std::uint8_t> isAt(mesh.numberOfFaces(), 0);
  for (const SourceCurve& curve : source)
  {
    for (const SurfacePoint& point : curve.points)
    {
      forEachFace(mesh, normalized(mesh, point), [&isAt](Id face) { isAt[face] = 1; });
    }
    for (const Id face : curve.coveredFaces)
    {
      isAt[face] = 1;
    }
  }
  return isAt;
}

/// Targets that are sets of points, lines and regions. The distance of a set is the least of its
/// points, along its lines and along the outlines of its regions; 0 if the source has a point in
/// one of its regions.
class TargetSets
{
public:
  /// \param mesh must outlive this.
  TargetSets(const TriangleMesh& mesh, const CurveSets& sets)
    : mesh_(mesh)
    , size_(sets.size())
  {
    for (std::size_t set = 0; set < sets.size(); ++set)
    {
      for (const SourceCurve& curve : sets[set])
      {
        this->addCurve(static_cast<Id>(set), curve);
      }
    }
  }

  std::size_t size() const { return this->size_; }

  /// Solves from a source until the sets are settled.
  ///
  /// \param first the sets before this one are left out.
  /// \returns the distance of each set; infinite if it is empty, left out, beyond the maximum, or
  ///          no path leads to it.
  /// \throws Aborted
  std::vector<double> distancesFrom(
    const std::vector<SourceCurve>& source, Id first, double maximumDistance, const Job& job) const
  {
    if (source.empty())
    {
      return std::vector<double>(this->size_, Infinity);
    }
    std::vector<double> least = this->zeroWhereInside(source);
    const auto isOpen = [&](Id set) { return set >= first && least[set] > 0.0; };
    std::vector<SurfacePoint> points;
    std::vector<Id> sets;
    for (std::size_t i = 0; i < this->points_.size(); ++i)
    {
      if (isOpen(this->setOfPoint_[i]))
      {
        points.push_back(this->points_[i]);
        sets.push_back(this->setOfPoint_[i]);
      }
    }
    RetentionAround retention(this->mesh_, std::move(points), maximumDistance, std::move(sets));
    for (const Segment& segment : this->segments_)
    {
      if (isOpen(segment.curve))
      {
        retention.keepWindows(segment.face);
      }
    }
    FrontOptions options;
    options.job = job;
    FrontResult front = propagate(this->mesh_, source, options, retention);
    const double known = retention.neededDistance();
    const DistanceField field(MeshPartition(this->mesh_), std::move(front), retention.release());
    this->shorten(field, first, known, least);
    for (std::size_t set = 0; set < this->size_; ++set)
    {
      least[set] = set >= first && least[set] <= maximumDistance ? least[set] : Infinity;
    }
    return least;
  }

private:
  /// From a point to the next one, in a face that has both. The number of the curve is that of the
  /// set, the first parameter that of the point.
  struct Segment : SourceInFace
  {
    double length;
  };
  struct CoveredFace
  {
    Id set;
    Id face;
  };

  void addCurve(Id set, const SourceCurve& curve)
  {
    // A segment's parameters tell which of the points it runs from and to.
    std::vector<double> numbers(curve.points.size());
    std::iota(numbers.begin(), numbers.end(), static_cast<double>(this->points_.size()));
    for (const SourceInFace& s : segmentsInFaces(this->mesh_, curve, set, numbers))
    {
      const auto point = static_cast<std::size_t>(s.parameterOfA);
      this->segments_.push_back(
        { s, lengthOfSegment(this->mesh_, curve, point - this->points_.size()) });
    }
    this->points_.insert(this->points_.end(), curve.points.begin(), curve.points.end());
    for (const Id face : curve.coveredFaces)
    {
      this->covered_.push_back({ set, face });
      // Where sheets meet in a vertex paths come to the region through it, not through its outline.
      for (const Id vertex : this->mesh_.triangle(face))
      {
        if (this->mesh_.pseudoSource(vertex) == TriangleMesh::PseudoSource::Irregular)
        {
          this->points_.push_back(SurfacePoint::atVertex(vertex));
        }
      }
    }
    this->setOfPoint_.resize(this->points_.size(), set);
  }

  std::vector<double> zeroWhereInside(const std::vector<SourceCurve>& source) const
  {
    std::vector<double> least(this->size_, Infinity);
    if (!this->covered_.empty())
    {
      const std::vector<std::uint8_t> isAt = facesAt(this->mesh_, source);
      for (const CoveredFace& covered : this->covered_)
      {
        least[covered.set] = isAt[covered.face] ? 0.0 : least[covered.set];
      }
    }
    return least;
  }

  // Between ends at distances a and b nothing is nearer than half of a + b without the segment's
  // length. What the front has not settled is beyond the known distances.
  void shorten(const DistanceField& field, Id first, double known, std::vector<double>& least) const
  {
    std::vector<double> atPoints(this->points_.size(), 0.0);
    for (std::size_t i = 0; i < this->points_.size(); ++i)
    {
      double& ofSet = least[this->setOfPoint_[i]];
      if (this->setOfPoint_[i] >= first && ofSet > 0.0)
      {
        const double distance = field.distance(this->points_[i]);
        atPoints[i] = std::min(known, distance);
        ofSet = std::min(ofSet, distance);
      }
    }
    FaceDistance face(field);
    SegmentEnvelope envelope;
    for (const Segment& s : this->segments_)
    {
      double& ofSet = least[s.curve];
      const auto point = static_cast<std::size_t>(s.parameterOfA);
      const double nearest = 0.5 * (atPoints[point] + atPoints[point + 1] - s.length);
      if (s.curve >= first && ofSet > 0.0 && nearest < ofSet)
      {
        face.enter(s.face);
        ofSet = std::min(ofSet, envelope.least(face, face.inPlane(s.a), face.inPlane(s.b), ofSet));
      }
    }
  }

  const TriangleMesh& mesh_;
  std::size_t size_;
  /// Ascending by set.
  std::vector<SurfacePoint> points_;
  std::vector<Id> setOfPoint_;
  std::vector<Segment> segments_;
  std::vector<CoveredFace> covered_;
};

/// Solves from each source.
Matrix matrixFrom(
  const CurveSets& sources, const TargetSets& targets, double maximumDistance, const Job& job)
{
  Matrix matrix(sources.size());
  job.longTasks(sources.size(),
    [&](std::size_t source, const Job& part)
    { matrix[source] = targets.distancesFrom(sources[source], 0, maximumDistance, part); });
  return matrix;
}

/// Solves from each target: a shortest path has the same length from both its ends.
Matrix matrixFromTargets(const TriangleMesh& mesh, const CurveSets& sources,
  const CurveSets& targets, double maximumDistance, const Job& job)
{
  const Matrix rows = matrixFrom(targets, TargetSets(mesh, sources), maximumDistance, job);
  Matrix matrix(sources.size(), std::vector<double>(targets.size()));
  for (std::size_t source = 0; source < sources.size(); ++source)
  {
    for (std::size_t target = 0; target < targets.size(); ++target)
    {
      matrix[source][target] = rows[target][source];
    }
  }
  return matrix;
}

using Places = std::vector<std::vector<Vec3>>;

/// The largest number of points of a curve for an estimate of where it is.
constexpr std::size_t PointsOfCurve = 16;

Places placesOf(const TriangleMesh& mesh, const CurveSets& sets)
{
  Places places(sets.size());
  for (std::size_t set = 0; set < sets.size(); ++set)
  {
    for (const SourceCurve& curve : sets[set])
    {
      const std::size_t step = 1 + curve.points.size() / PointsOfCurve;
      for (std::size_t i = 0; i < curve.points.size(); i += step)
      {
        places[set].push_back(position(mesh, curve.points[i]));
      }
    }
  }
  return places;
}

/// The least distance in space.
double nearestOf(const std::vector<Vec3>& some, const std::vector<Vec3>& others)
{
  double nearest = Infinity;
  for (const Vec3& a : some)
  {
    for (const Vec3& b : others)
    {
      nearest = std::min(nearest, norm(b - a));
    }
  }
  return nearest;
}

/// An estimate of the work of solving from each of some sets until others are settled: the sum of
/// the areas that the fronts cover, if they go as far as straight lines.
///
/// \param reaches how far the farthest of the others is from each.
double workOf(const std::vector<double>& reaches, double maximumDistance)
{
  double work = 0.0;
  for (double reach : reaches)
  {
    reach = std::min(reach, maximumDistance);
    work += reach * reach;
  }
  return work;
}

/// Whether fewer fronts, with less work in all, go out from the targets than from the sources.
bool isLessFromTargets(const TriangleMesh& mesh, const CurveSets& sources, const CurveSets& targets,
  double maximumDistance, const Job& job)
{
  const auto fronts = [](const CurveSets& sets)
  {
    return std::count_if(
      sets.begin(), sets.end(), [](const std::vector<SourceCurve>& set) { return !set.empty(); });
  };
  if (fronts(targets) == 0 || fronts(targets) >= fronts(sources))
  {
    return false;
  }
  const Places some = placesOf(mesh, targets);
  const Places others = placesOf(mesh, sources);
  std::vector<double> fromTargets(some.size(), 0.0);
  std::vector<double> fromSources(others.size(), 0.0);
  for (std::size_t i = 0; i < some.size(); ++i)
  {
    job.look();
    for (std::size_t j = 0; j < others.size(); ++j)
    {
      const double nearest = nearestOf(some[i], others[j]);
      if (nearest < Infinity)
      {
        fromTargets[i] = std::max(fromTargets[i], nearest);
        fromSources[j] = std::max(fromSources[j], nearest);
      }
    }
  }
  return workOf(fromTargets, maximumDistance) < workOf(fromSources, maximumDistance);
}

/// The sets from outside to the middle, so that those left lie ever closer together.
std::vector<std::size_t> fromOutside(const Places& sets)
{
  std::vector<Vec3> centres;
  Vec3 middle{};
  for (const std::vector<Vec3>& set : sets)
  {
    Vec3 centre{};
    for (const Vec3& place : set)
    {
      centre = centre + (1.0 / static_cast<double>(set.size())) * place;
    }
    middle = middle + (1.0 / static_cast<double>(sets.size())) * centre;
    centres.push_back(centre);
  }
  std::vector<std::size_t> order(sets.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    { return norm(centres[a] - middle) > norm(centres[b] - middle); });
  return order;
}

} // anonymous namespace

CurveSets setsOf(const std::vector<SourceCurve>& curves, std::size_t count)
{
  CurveSets sets(count);
  for (const SourceCurve& curve : curves)
  {
    sets[curve.source].push_back(curve);
  }
  return sets;
}

CurveSets setsOf(const std::vector<SurfacePoint>& points)
{
  CurveSets sets;
  for (const SurfacePoint& point : points)
  {
    sets.push_back({ pointCurve(point) });
  }
  return sets;
}

std::vector<std::vector<double>> distanceMatrix(const TriangleMesh& mesh, const CurveSets& sources,
  const CurveSets& targets, double maximumDistance, const Job& job)
{
  return isLessFromTargets(mesh, sources, targets, maximumDistance, job)
    ? matrixFromTargets(mesh, sources, targets, maximumDistance, job)
    : matrixFrom(sources, TargetSets(mesh, targets), maximumDistance, job);
}

std::vector<std::vector<double>> distancesBetween(
  const TriangleMesh& mesh, const CurveSets& sets, double maximumDistance, const Job& job)
{
  const std::vector<std::size_t> order = fromOutside(placesOf(mesh, sets));
  CurveSets ordered;
  for (const std::size_t set : order)
  {
    ordered.push_back(sets[set]);
  }
  const TargetSets targets(mesh, ordered);
  Matrix matrix(sets.size(), std::vector<double>(sets.size()));
  job.longTasks(sets.size(),
    [&](std::size_t i, const Job& part)
    {
      const std::vector<double> distances =
        targets.distancesFrom(ordered[i], static_cast<Id>(i), maximumDistance, part);
      for (std::size_t j = i; j < sets.size(); ++j)
      {
        matrix[order[i]][order[j]] = distances[j];
        matrix[order[j]][order[i]] = distances[j];
      }
    });
  return matrix;
}

}
