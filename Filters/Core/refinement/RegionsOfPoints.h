// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RegionsOfPoints_h
#define geodesic_RegionsOfPoints_h

#include "refinement/RefinedFaces.h"
#include "refinement/SourceRegions.h"

#include <array>
#include <cstdint>
#include <unordered_map>

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

  /// The longest side of a triangle that must be split, as there is a border between its corners;
  /// else 0.
  ///
  /// \param corners points of the open face; in another face, points on its edges.
  double lengthAtBorder(Id face, const Triangle& corners);

private:
  struct Corner
  {
    SourceRegion region;
    double distance = 0.0;
    Vec2 place;
  };

  SourceRegion regionAt(std::uint64_t key, const SurfacePoint& place);
  Corner cornerOf(Id face, Id point);

  const RefinedFaces& faces_;
  SourceRegions& regions_;
  double tolerance_;
  /// The keys of vertices and points on edges are their numbers; others begin with their faces.
  std::unordered_map<std::uint64_t, SourceRegion> known_;
};

}

#endif
