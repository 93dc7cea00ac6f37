// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SubMesh_h
#define geodesic_SubMesh_h

#include "Progress.h"
#include "mesh/SurfacePoint.h"
#include "mesh/TriangleMesh.h"

#include <optional>
#include <vector>

namespace geodesic
{

/// The part of a surface that shortest paths between two points can touch. If it is small, it is a
/// mesh of its own, so that a search there does not cost as much as on the whole surface.
///
/// A path along mesh edges bounds the length from above. A path no longer than a bound stays in
/// those faces whose distances in space from the two points add up to no more than the bound.
class SubMesh
{
public:
  /// \param surface must outlive the patch.
  /// \param progress called now and then with 0; returning false throws Aborted.
  /// \throws Aborted
  SubMesh(const TriangleMesh& surface, const SurfacePoint& first, const SurfacePoint& second,
    const ProgressCallback& progress);

  /// An upper bound of the length of a shortest path; infinite if no path joins the points.
  double bound() const { return this->bound_; }

  /// The mesh; the surface itself if the patch is a large part of it.
  const TriangleMesh& mesh() const { return this->mesh_ ? *this->mesh_ : this->surface_; }
  /// A point of one of the two points' faces as a point of the patch.
  SurfacePoint onPatch(const SurfacePoint& point) const;
  /// A point of the patch as a point of the surface.
  SurfacePoint onSurface(const SurfacePoint& point) const;

private:
  const TriangleMesh& surface_;
  double bound_;
  std::optional<TriangleMesh> mesh_;
  /// The surface's numbers of the patch's vertices and faces.
  std::vector<Id> vertices_;
  std::vector<Id> faces_;
};

}

#endif
