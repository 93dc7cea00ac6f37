// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RegionsOfPoints_h
#define geodesic_RegionsOfPoints_h

#include "refinement/DistancesInFaces.h"
#include "refinement/RedGreenMesh.h"
#include "refinement/SourceRegions.h"

#include <optional>
#include <vector>

namespace geodesic
{

/// The regions in which the points of a mesh under refinement lie; each is found once.
class RegionsOfPoints
{
public:
  /// All arguments must outlive this.
  ///
  /// \param regionOf, tolerance of RefinementOptions.
  RegionsOfPoints(const RedGreenMesh& triangles, const DistancesInFaces& distances,
    const RegionOf& regionOf, double tolerance)
    : triangles_(triangles)
    , distances_(distances)
    , regionOf_(regionOf)
    , tolerance_(tolerance)
  {
  }

  /// The longest edge of a triangle in a face that must be split, as there is a border between its
  /// corners; else 0. The two sides of one curve have no border where a straight line between them
  /// may cross the curve.
  double lengthAtBorder(Id face, const Triangle& corners);
  /// Forgets the points that no longer exist.
  void forgetNewPoints();

private:
  SourceRegion of(Id point);
  bool isBorderBetween(Id face, Id a, Id b);
  std::size_t numberOfPoints() const
  {
    return this->triangles_.numberOfInputPoints() + this->triangles_.points().size();
  }

  const RedGreenMesh& triangles_;
  const DistancesInFaces& distances_;
  const RegionOf& regionOf_;
  double tolerance_;
  std::vector<std::optional<SourceRegion>> regions_;
};

}

#endif
