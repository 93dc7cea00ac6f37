// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RetentionAround_h
#define geodesic_RetentionAround_h

#include "front/Retention.h"
#include "mesh/MeshPartition.h"
#include "mesh/SurfacePoint.h"

#include <vector>

namespace geodesic
{

/// Keeps windows around some targets, and stops the front when all targets are settled. Distances
/// need the windows of the faces around targets that are not vertices.
class RetentionAround : public KeepFaces
{
public:
  /// \param limit targets farther than this need not be settled.
  /// \param sets of each target; consecutive targets of one set are settled when the nearest of
  ///        them is. Empty: each is alone.
  RetentionAround(const TriangleMesh& mesh, std::vector<SurfacePoint> targets,
    double limit = Infinity, std::vector<Id> sets = {});

  /// Keeps the windows of a face besides. To be called before the front begins.
  void keepWindows(Id face) { this->keep(face); }

  /// Keeps what paths (PathTracer) also need: the windows of faces around edges of three and more
  /// faces, and those around targets on edges in the faces of all ranks there. All ranks call this
  /// together before the front begins.
  void keepForPaths(const MeshPartition& part);

  double neededDistance() const override { return this->neededDistance_; }
  void advance(const FrontState& front) override;

private:
  double upperBound(const SurfacePoint& target, const VertexNumbers& distances) const;
  double upperBoundOfSet(std::size_t& target, const VertexNumbers& distances) const;

  std::vector<SurfacePoint> targets_;
  std::vector<Id> sets_;
  /// How many of the targets, from the first on, have a finite bound.
  std::size_t seen_ = 0;
  double limit_;
  double neededDistance_;
  /// The key at which the needed distance is computed again.
  double nextLook_ = 0.0;
};

}

#endif
