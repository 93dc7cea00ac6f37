// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PolylineLocator_h
#define geodesic_PolylineLocator_h

#include "Progress.h"
#include "mesh/FaceLocator.h"
#include "mesh/TriangleMesh.h"
#include "source/PolylineOnSurface.h"

#include <memory>
#include <vector>

namespace geodesic
{

/// Finds the faces closest to the points of polylines. Polylines along the mesh's own edges need
/// only its vertices; others need a FaceLocator, which is built once.
class PolylineLocator
{
public:
  /// \param mesh must outlive the locator.
  explicit PolylineLocator(const TriangleMesh& mesh)
    : mesh_(mesh)
  {
  }

  /// Fills in the faces of polylines whose points are finite. Points at the same place in space are
  /// located once. Not thread-safe.
  ///
  /// \param coordinatePrecision relative precision of the points' coordinates.
  /// \param progress called now and then with the fraction done; returning false throws Aborted.
  void locate(std::vector<LocatedPolyline>& polylines, double coordinatePrecision,
    const ProgressCallback& progress = {});

private:
  std::vector<std::vector<Id>> verticesAt(const std::vector<Vec3>& sortedPlaces) const;
  std::vector<std::vector<Id>> findFaces(const std::vector<Vec3>& places,
    const std::vector<std::vector<Id>>& vertices, const std::vector<std::uint8_t>& isSearched,
    double coordinatePrecision, const ProgressCallback& progress);

  const TriangleMesh& mesh_;
  std::unique_ptr<FaceLocator> faceLocator_;
};

}

#endif
