// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RegionsOfPoints_h
#define geodesic_RegionsOfPoints_h

#include "refinement/RefinedFaces.h"
#include "refinement/SourceRegions.h"

#include <array>
#include <optional>
#include <unordered_map>
#include <vector>

namespace geodesic
{

/// The regions in which the points of faces under refinement lie; each is found once. Used by one
/// thread.
class RegionsOfPoints
{
public:
  /// All arguments must outlive this.
  ///
  /// \param tolerance edges that are no longer are not split.
  RegionsOfPoints(const RefinedFaces& faces, SourceRegions& regions, double tolerance)
    : faces_(faces)
    , regions_(regions)
    , tolerance_(tolerance)
  {
  }

  /// The longest side of a triangle in an open face that must be split, as there is a border
  /// between its corners; else 0.
  double lengthAtBorder(const FaceTriangles& face, const Triangle& corners);
  /// The same for a face that is not open, or a triangle between points of its edges.
  double lengthAtBorder(Id face, const Triangle& corners);

private:
  struct Corner
  {
    SourceRegion region;
    double distance = 0.0;
    Vec2 place;
  };

  double lengthAtBorder(const std::array<Corner, 3>& corners) const;
  const SourceRegion& of(Id point);
  const SourceRegion& ofInside(const FaceTriangles& face, Id point);

  const RefinedFaces& faces_;
  SourceRegions& regions_;
  double tolerance_;
  /// Of vertices and points on edges; and for each face, of its own points.
  std::vector<std::optional<SourceRegion>> ofPoints_;
  std::unordered_map<Id, std::vector<std::optional<SourceRegion>>> inside_;
};

}

#endif
