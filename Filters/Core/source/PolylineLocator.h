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

/// Finds the faces that the points of polylines are closest to. Polylines along the mesh's own
/// edges need its vertices only; for others a FaceLocator is made, and kept.
class PolylineLocator
{
public:
  /// \param mesh must outlive the locator.
  explicit PolylineLocator(const TriangleMesh& mesh)
    : mesh_(mesh)
  {
  }

  /// Sets the faces of polylines whose points are finite. A place in space is looked for once,
  /// however many points lie there. Not thread-safe.
  ///
  /// \param coordinatePrecision relative precision of the points' coordinates.
  /// \param progress called now and then with a fraction done; returning false throws Aborted.
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
