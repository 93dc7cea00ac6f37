// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BarrierClosure_h
#define geodesic_BarrierClosure_h

#include "PolyData/reading/PolyDataSurface.h"
#include "PolyData/writing/SplitTriangle.h"
#include "PolyData/writing/TrianglePoints.h"
#include "refinement/RefinedMesh.h"

#include <array>
#include <unordered_map>
#include <vector>

namespace geodesic
{

/// How many barriers are at the edges of the mesh, for RefinementOptions::trianglesBeside. Of a
/// piece, which all ranks call together, each barrier of any rank is counted by one rank at each of
/// its edges.
std::unordered_map<Id, Id> barriersAtEdges(const PolyDataSurface& surface);

/// Cuts barriers at the points by which refinement has split their rims, so that they still fit to
/// their neighbours. No other points are added: a barrier has no distances inside.
class BarrierClosure
{
public:
  /// \param points of refined; all must outlive this.
  BarrierClosure(const PolyDataSurface& surface, RefinedMesh& refined, TrianglePoints& points);

  /// How many triangles a barrier becomes.
  ///
  /// \param triangle the input's points at its corners.
  Id count(const Triangle& triangle) const;
  /// Adds what a barrier becomes, in its orientation.
  void close(const Triangle& triangle, std::vector<Triangle>& triangles);

private:
  using Splits = SplitTriangle::Splits;

  const Splits* splitsBetween(Id a, Id b) const;
  Splits splitsAlong(const Triangle& triangle, std::size_t k);
  Vec3 position(Id point) const;

  const PolyDataSurface& surface_;
  const RefinedMesh& refined_;
  TrianglePoints& points_;
  /// The points that split each edge of a rim, by the edge's name, along the halfedge that names
  /// it.
  std::unordered_map<Id, Splits> splits_;
};

}

#endif
