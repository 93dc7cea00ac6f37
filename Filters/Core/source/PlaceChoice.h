// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PlaceChoice_h
#define geodesic_PlaceChoice_h

#include "mesh/SurfacePoint.h"
#include "mesh/TriangleMesh.h"

#include <functional>
#include <vector>

namespace geodesic
{

/// The places where a point of a polyline may lie, the first of equally good ones first. There is
/// more than one where the surface touches or overlaps itself.
using PossiblePlaces = std::vector<SurfacePoint>;

/// Which of its places a point of a polyline takes: the one where the way from the point before
/// ends and the one where the way to the next begins. They are the same but where no face of the
/// one sheet goes on to the next point and one of another sheet does.
struct ChosenPlaces
{
  std::size_t arrival = 0;
  std::size_t departure = 0;
};

/// The connected component of places, computed when first asked for.
class PlaceComponents
{
public:
  /// The mesh must outlive this.
  explicit PlaceComponents(const TriangleMesh& mesh)
    : mesh_(mesh)
  {
  }

  Id of(const SurfacePoint& place);

private:
  const TriangleMesh& mesh_;
  std::vector<Id> componentOfVertex_;
};

/// The length of the shortest path on the surface from place `from` of a point of the polyline to
/// place `to` of the next point.
using LengthBetween = std::function<double(std::size_t point, std::size_t from, std::size_t to)>;

/// Chooses the places of a whole polyline, so that a section of a surface comes out as it went in:
/// with as few consecutive points as possible that no path joins, then that share no face, then as
/// few changes from one place of a point to another; of these the shortest joins of points without
/// a common face, then places on vertices rather than edges rather than inside faces (a section's
/// points lie on edges), and last the first places. So a single point takes a vertex before an edge
/// before a face, and the first of these.
///
/// \param places of each point, one at least.
/// \param closed whether the last point joins the first.
/// \param lengthBetween asked for connected places without a common face, on ways with the fewest
///        breaks only.
std::vector<ChosenPlaces> choosePlaces(const TriangleMesh& mesh,
  const std::vector<PossiblePlaces>& places, bool closed, PlaceComponents& components,
  const LengthBetween& lengthBetween);

}

#endif
