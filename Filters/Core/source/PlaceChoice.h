// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PlaceChoice_h
#define geodesic_PlaceChoice_h

#include "mesh/SurfacePoint.h"

#include <functional>
#include <vector>

namespace geodesic
{

/// The connected components of a mesh, found when they are first asked for.
class MeshComponents
{
public:
  explicit MeshComponents(const TriangleMesh& mesh)
    : mesh_(mesh)
  {
  }

  /// The number of the component that contains a point.
  Id of(const SurfacePoint& point);

private:
  const TriangleMesh& mesh_;
  std::vector<Id> ofVertices_;
};

/// The possible places of a polyline's point, in order of preference. There are several where the
/// surface touches or overlaps itself.
using PossiblePlaces = std::vector<SurfacePoint>;

/// The places that a point of a polyline takes: where the line from the previous point ends, and
/// where the line to the next point begins. They differ only if no face of the first sheet
/// continues to the next point and a face of another sheet does.
struct ChosenPlaces
{
  std::size_t arrival = 0;
  std::size_t departure = 0;
};

/// The length of the shortest path on the surface from place `from` of a point of the polyline to
/// place `to` of the next point.
using LengthBetween = std::function<double(std::size_t point, std::size_t from, std::size_t to)>;

/// Chooses the places of a whole polyline so that a section of a surface stays on the sheets that
/// it was cut from. In order of priority, it minimises: consecutive points that no path joins;
/// consecutive points that share no face; changes from one place of a point to another; the length
/// of the joins between points without a common face; the dimensions of the elements (a section's
/// points lie on edges, so a vertex goes before an edge before a face); and last the places'
/// positions in their lists. A single point so takes the first vertex, else the first edge, else
/// the first face.
///
/// \param places at least one for each point.
/// \param closed whether the last point joins the first.
/// \param lengthBetween called only for connected places without a common face, on ways with the
///        fewest breaks.
std::vector<ChosenPlaces> choosePlaces(const TriangleMesh& mesh,
  const std::vector<PossiblePlaces>& places, bool closed, MeshComponents& components,
  const LengthBetween& lengthBetween);

}

#endif
