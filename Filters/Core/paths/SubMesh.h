// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SubMesh_h
#define geodesic_SubMesh_h

#include "Progress.h"
#include "mesh/SurfacePoint.h"
#include "mesh/TriangleMesh.h"

#include <memory>
#include <vector>

namespace geodesic
{

/// The part of a surface that paths between two points can touch. If it is small, it is a mesh of
/// its own, so that a search there does not cost as much as on the whole surface.
///
/// A path no longer than a bound stays in those faces whose distances in space from the two points
/// add up to no more than the bound.
class SubMesh
{
public:
  /// Work space for patches of one surface: one entry a vertex or a face, allocated for the first
  /// patch and always left clean.
  struct WorkSpace
  {
    std::vector<Id> patchVertex;
    std::vector<Id> patchFace;
  };

  /// \param surface must outlive the patch.
  /// \param bound the largest length of a path.
  /// \throws Aborted
  SubMesh(const TriangleMesh& surface, const SurfacePoint& first, const SurfacePoint& second,
    double bound, WorkSpace& workSpace, const ProgressCallback& progress);

  /// The mesh; the surface itself if the patch is a large part of it.
  const TriangleMesh& mesh() const { return this->mesh_ ? *this->mesh_ : this->surface_; }
  /// The two points on it.
  const SurfacePoint& first() const { return this->first_; }
  const SurfacePoint& second() const { return this->second_; }
  /// A point of the patch as a point of the surface.
  SurfacePoint onSurface(const SurfacePoint& point) const;

private:
  const TriangleMesh& surface_;
  std::unique_ptr<TriangleMesh> mesh_;
  SurfacePoint first_;
  SurfacePoint second_;
  /// The surface's numbers of the patch's vertices and faces.
  std::vector<Id> vertices_;
  std::vector<Id> faces_;
};

}

#endif
