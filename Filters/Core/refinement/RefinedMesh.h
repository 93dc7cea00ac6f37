// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinedMesh_h
#define geodesic_RefinedMesh_h

#include "Types.h"
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
  /// The points on whose connection it lies, and the fraction of the way from the first to the
  /// second: what is known at points can be interpolated in the order of the points.
  std::array<Id, 2> parents;
  double weight;
  /// The place on the input mesh: on an edge or in a face.
  SurfacePoint place;
  Vec3 position;
  double distance;
};

struct RefinedMesh
{
  /// Points up to here are the caller's, unchanged.
  Id numberOfInputPoints = 0;
  /// The others.
  std::vector<RefinedPoint> points;
  std::vector<Triangle> triangles;
  /// The face of the mesh that each triangle is a part of; ascending.
  std::vector<Id> faces;
  /// Certified: nowhere on a face that could be refined is the difference between distance and
  /// interpolant larger. At most the tolerance, unless more faces would have been needed, or an
  /// approximate field was not solved for this tolerance.
  double errorBound = 0.0;
  /// Whether more faces would have been needed.
  bool stoppedAtMaximum = false;
};

/// Numbers the points that split edges of a refined mesh, one for each pair of parents: where
/// several of the caller's points are one vertex, as along a seam, a split edge has a point for
/// each pair of them.
class SplitPointNumbering
{
public:
  /// \param mesh to which points are added; it may have some. Nothing else may add points to it.
  explicit SplitPointNumbering(RefinedMesh& mesh)
    : mesh_(mesh)
  {
  }

  /// The number of the point with these parents, which is added where there is none yet.
  Id numberOf(const RefinedPoint& point);

private:
  Id numberOfNext() const
  {
    return this->mesh_.numberOfInputPoints + static_cast<Id>(this->mesh_.points.size());
  }

  RefinedMesh& mesh_;
  std::unordered_map<std::uint64_t, Id> numbers_;
};

}

#endif
