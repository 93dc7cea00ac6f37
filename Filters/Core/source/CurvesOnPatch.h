// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CurvesOnPatch_h
#define geodesic_CurvesOnPatch_h

#include "mesh/ReplicatedPatch.h"
#include "source/CurveChains.h"
#include "source/VerticesOnCurves.h"

namespace geodesic
{

/// The tangent plane at a source, as unit vectors in space: the direction of angle 0, the one at a
/// right angle to its left, and the normal of the face there.
struct SourceFrame
{
  Vec3 x = {};
  Vec3 y = {};
  Vec3 normal = {};
};

/// A point of a curve and the ends of the segments around it.
struct PointWithEnds
{
  SurfacePoint point;
  std::vector<SegmentEnd> ends;
};

/// The curves of a source on their patch, joined to chains.
class CurvesOnPatch
{
public:
  CurvesOnPatch(const ReplicatedPatch& patch, const std::vector<SourceCurve>& curves)
    : patch_(patch)
    , chains_(patch.mesh(), curves)
    , vertices_(patch.mesh(), this->chains_)
  {
  }

  const ReplicatedPatch& patch() const { return this->patch_; }
  const TriangleMesh& mesh() const { return this->patch_.mesh(); }
  const CurveChains& chains() const { return this->chains_; }
  const VerticesOnCurves& vertices() const { return this->vertices_; }

  /// A point of a chain (CurveChains::pointAt()), at the vertex at its place if there is one, and
  /// the ends around it: of all curves at a vertex, else of this chain.
  PointWithEnds around(Id point) const;

  /// The frame of a single point, or of a curve at its first segment: NearestSource::frameOf().
  SourceFrame frameOf(Id curve) const;

private:
  ReplicatedPatch patch_;
  CurveChains chains_;
  VerticesOnCurves vertices_;
};

}

#endif
