// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinedMesh_h
#define geodesic_RefinedMesh_h

#include "mesh/MeshPartition.h"
#include "mesh/SurfacePoint.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace geodesic
{

/// A point that refinement has added.
struct RefinedPoint
{
  /// The points between which it lies, and the fraction of the way from the first to the second.
  /// Values at points can be interpolated in the order of the points.
  std::array<Id, 2> parents;
  double weight;
  /// The place on the input mesh: on an edge or in a face.
  SurfacePoint place;
  Vec3 position;
  double distance;

  /// False if the point is at a vertex that this rank's mesh does not have.
  bool hasPlace() const { return this->place.id != NoId; }
};

/// A refined surface, a part of it, or one refined face of any rank.
struct RefinedMesh
{
  /// The points below this number are the caller's, unchanged.
  Id numberOfInputPoints = 0;
  /// The added points.
  std::vector<RefinedPoint> points;
  std::vector<Triangle> triangles;
  /// The face of the mesh that contains each triangle; ascending.
  std::vector<Id> faces;
  /// Certified: on all faces that could be refined, the difference between distance and interpolant
  /// is at most this. It is at most the tolerance, unless more faces would have been needed, or an
  /// approximate field was not solved for this tolerance.
  double errorBound = 0.0;
  /// Whether more faces would have been needed.
  bool stoppedAtMaximum = false;
  /// With regions: faces that a border passes, but in which the field knows no distances. A solve
  /// that keeps their windows (solveForRefinement) may allow to split them.
  std::vector<Id> unknownAtBorders;
  /// The last points may be copies of points of any rank, without places: where the originals are
  /// among the points of their rank's mesh.
  std::vector<RankAddress> copied;

  const RefinedPoint& pointAt(Id number) const
  {
    return this->points[number - this->numberOfInputPoints];
  }
  std::size_t numberOfPointsWithPlaces() const { return this->points.size() - this->copied.size(); }
};

/// The number that a point has elsewhere, where an added point comes after its parents.
///
/// \param numbers those known, at first those of the input's points; this adds to them.
/// \param pointAt (number): the added point.
/// \param add (point with parents elsewhere, number): adds it there, and returns its number.
template <typename PointAt, typename Add>
Id numberElsewhere(
  Id number, std::unordered_map<Id, Id>& numbers, const PointAt& pointAt, const Add& add)
{
  const auto known = numbers.find(number);
  if (known != numbers.end())
  {
    return known->second;
  }
  RefinedPoint point = pointAt(number);
  for (Id& parent : point.parents)
  {
    parent = numberElsewhere(parent, numbers, pointAt, add);
  }
  return numbers[number] = add(point, number);
}

/// Numbers the points that split edges of a refined mesh, one for each pair of parents: a split
/// seam has several points at one place.
class SplitPointNumbering
{
public:
  /// \param mesh to which this adds points; it may already have some. No one else may add points to
  ///        it.
  explicit SplitPointNumbering(RefinedMesh& mesh)
    : mesh_(mesh)
  {
    Id number = mesh.numberOfInputPoints;
    for (const RefinedPoint& known : mesh.points)
    {
      this->numbers_.emplace(keyOf(known), number++);
    }
  }

  /// The number of the point with these parents, which is added if necessary.
  Id numberOf(const RefinedPoint& point)
  {
    const Id next = this->mesh_.numberOfInputPoints + static_cast<Id>(this->mesh_.points.size());
    const auto [found, isNew] = this->numbers_.emplace(keyOf(point), next);
    if (isNew)
    {
      this->mesh_.points.push_back(point);
    }
    return found->second;
  }

private:
  static std::uint64_t keyOf(const RefinedPoint& point)
  {
    return (static_cast<std::uint64_t>(point.parents[0]) << 32) | point.parents[1];
  }

  RefinedMesh& mesh_;
  std::unordered_map<std::uint64_t, Id> numbers_;
};

}

#endif
