// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CurvesOnPatch_h
#define geodesic_CurvesOnPatch_h

#include "mesh/ReplicatedPatch.h"
#include "source/CurveChains.h"
#include "source/FanAround.h"

#include <vector>

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

/// A mesh vertex that is a point of a chain, and the number of this point (CurveChains).
struct VertexOnCurve
{
  Id vertex;
  Id point = NoId;

  bool operator<(const VertexOnCurve& other) const { return this->vertex < other.vertex; }
};

/// The curves of a source on their patch, joined to chains, and the mesh vertices on them. Several
/// curves may meet in one vertex. Points of chains go by their numbers (CurveChains).
class CurvesOnPatch
{
public:
  CurvesOnPatch(const ReplicatedPatch& patch, const std::vector<SourceCurve>& curves);

  const ReplicatedPatch& patch() const { return this->patch_; }
  const TriangleMesh& mesh() const { return this->patch_.mesh(); }
  const CurveChains& chains() const { return this->chains_; }

  /// Ascending; a vertex at several points of curves is there several times, in their order.
  const std::vector<VertexOnCurve>& vertices() const { return this->vertices_; }
  /// The first with this vertex; null if no curve contains it.
  const VertexOnCurve* find(Id vertex) const;

  /// The ends of the segments that meet in a point of a chain: two inside the chain, one at its
  /// ends, none if the chain is a point. A segment without length, between points that differ by
  /// rounding, counts only if the chain continues from it across edges.
  std::vector<SegmentEnd> endsAt(Id point) const;
  /// The ends of all segments that meet in a vertex, of all curves.
  std::vector<SegmentEnd> endsAtVertex(Id vertex) const;

  /// The vertex at the place of a chain's point: the point itself, or a vertex to which segments
  /// without length lead along the chain. Null if there is none. Such points emit as one, from the
  /// vertex.
  const VertexOnCurve* vertexAtPlaceOf(Id point) const;
  /// A chain's point, or the vertex at its place, with the ends of all segments there: of all
  /// curves at a vertex, else of this chain.
  PointOfSource placeOf(Id point) const;

  /// The frame of a single point, or of a curve at its first segment: NearestSource::frameOf().
  SourceFrame frameOf(Id curve) const;

private:
  std::vector<SegmentEnd> endsAtPlaceOf(Id point) const;
  using EndsAtPoint = std::vector<SegmentEnd> (CurvesOnPatch::*)(Id point) const;
  std::vector<SegmentEnd> ofAllCurvesAt(Id vertex, EndsAtPoint endsOfPoint) const;

  ReplicatedPatch patch_;
  CurveChains chains_;
  std::vector<VertexOnCurve> vertices_;
};

}

#endif
