// SPDX-License-Identifier: BSD-3-Clause
#include "field/TargetSets.h"

#include "field/RetentionAround.h"
#include "field/SegmentEnvelope.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace geodesic
{

namespace
{

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

} // anonymous namespace

TargetSets::TargetSets(const TriangleMesh& mesh, const CurveSets& sets)
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

void TargetSets::addCurve(Id set, const SourceCurve& curve)
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

std::vector<double> TargetSets::zeroWhereInside(const std::vector<SourceCurve>& source) const
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

std::vector<double> TargetSets::distancesFrom(
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

// Between ends at distances a and b nothing is nearer than half of a + b without the segment's
// length. What the front has not settled is beyond the known distances.
void TargetSets::shorten(
  const DistanceField& field, Id first, double known, std::vector<double>& least) const
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

}
