// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfaceLocator_h
#define geodesic_SurfaceLocator_h

#include "PolyData/FaceLocator.h"
#include "Progress.h"
#include "mesh/TriangleMesh.h"

#include <memory>
#include <vector>

namespace geodesic
{

/// Finds faces by points in space. What makes that quick is built when it is needed, and kept.
class SurfaceLocator
{
public:
  /// \param mesh must outlive the locator.
  explicit SurfaceLocator(const TriangleMesh& mesh)
    : mesh_(mesh)
  {
  }

  /// For each of some points a face that has a corner exactly there, or NoId. Needs no build().
  std::vector<Id> facesWithCornersAt(const std::vector<Vec3>& points) const;

  /// Makes closestFace() quick; takes as long as a third of a solve.
  ///
  /// \param progress called now and then; returning false throws Aborted.
  void build(const ProgressCallback& progress);
  /// The face with the closest point of the surface. Not thread-safe, and needs build().
  Id closestFace(const Vec3& point) { return this->faces_->closest(point); }

private:
  const TriangleMesh& mesh_;
  std::unique_ptr<FaceLocator> faces_;
};

}

#endif
