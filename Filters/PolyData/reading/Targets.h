// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Targets_h
#define geodesic_Targets_h

#include "PolyData/PolyDataBlocks.h"
#include "mesh/SurfacePoint.h"
#include "source/PolylineLocator.h"

#include <vector>

namespace geodesic
{

struct PolyDataSurface;

/// Points of an input, put onto the surface. They are numbered over all blocks in their order.
struct Targets
{
  /// How many there are.
  std::size_t count = 0;
  /// The numbers of those that paths may reach and whose faces this rank owns. Points that lie in a
  /// barrier are left out.
  std::vector<std::size_t> numbers;
  /// Where these points are on the surface.
  std::vector<SurfacePoint> places;
  /// From each of these in space to its place, on the mesh's scale.
  std::vector<double> snapDistances;
};

/// Puts every point of all blocks onto the closest point of the surface, and onto a vertex or an
/// edge if one is within the precision of the coordinates: the same place as for a source that is
/// one point. All ranks call this together, with the same points; each target goes to one rank.
///
/// \param name as messages call the input: "the set of targets (input port 2)".
/// \throws InputError if there is no point, or one is not finite or too far away; Aborted.
Targets readTargets(const std::vector<PolyDataBlock>& blocks, const PartName& name,
  const PolyDataSurface& surface, PolylineLocator& locator, const Job& job);

}

#endif
