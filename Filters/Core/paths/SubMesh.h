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

/// The part of a surface that the paths between two points can touch, as a mesh of its own where it
/// is small, so that what is done there does not cost as much as the whole surface.
///
/// A path no longer than a bound stays in the faces whose distances in space to both points add up
/// to no more.
class SubMesh
{
public:
  /// Work space for patches of one surface: one entry a vertex or a face, made with the first patch
  /// and always left clean.
  struct WorkSpace
  {
    std::vector<Id> patchVertex;
    std::vector<std::uint8_t> faceSeen;
  };

  /// \param surface must outlive the patch.
  /// \param bound the most that a path can measure.
  /// \throws Aborted
  SubMesh(const TriangleMesh& surface, const SurfacePoint& first, const SurfacePoint& second,
    double bound, WorkSpace& workSpace, const ProgressCallback& progress);

  /// The mesh; the surface itself where the patch is a large part of it.
  const TriangleMesh& mesh() const { return this->mesh_ ? *this->mesh_ : this->surface_; }
  /// The two points on it.
  const SurfacePoint& first() const { return this->first_; }
  const SurfacePoint& second() const { return this->second_; }
  /// A point of it as one of the surface.
  SurfacePoint onSurface(const SurfacePoint& point) const;

private:
  const TriangleMesh& surface_;
  std::unique_ptr<TriangleMesh> mesh_;
  SurfacePoint first_;
  SurfacePoint second_;
  /// The surface's vertex of each vertex of the patch.
  std::vector<Id> vertices_;
};

}

#endif
