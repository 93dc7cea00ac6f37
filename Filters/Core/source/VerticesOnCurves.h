// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_VerticesOnCurves_h
#define geodesic_VerticesOnCurves_h

#include "source/CurveChains.h"
#include "source/SegmentEnd.h"

#include <vector>

namespace geodesic
{

/// A mesh vertex on a curve, with the chain's number and the place along the chain.
struct VertexOnCurve
{
  Id vertex;
  Id curve = 0;
  double place = 0.0;
  bool operator<(const VertexOnCurve& other) const { return this->vertex < other.vertex; }
};

/// The mesh vertices on curves, and the segments that meet there. Several curves may meet in one
/// vertex.
class VerticesOnCurves
{
public:
  VerticesOnCurves(const TriangleMesh& mesh, const CurveChains& chains);

  /// Ascending, each once, with its first curve.
  const std::vector<VertexOnCurve>& vertices() const { return this->vertices_; }
  /// Null if no curve contains the vertex.
  const VertexOnCurve* find(Id vertex) const;
  /// The ends of the segments of all curves at a vertex.
  std::vector<SegmentEnd> endsAt(Id vertex) const;

private:
  std::vector<VertexOnCurve> vertices_;
  /// By vertex.
  std::vector<SegmentEnd> ends_;
};

}

#endif
