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
/// vertex. A vertex at the place of a curve's corner or end, behind faces without area, is on the
/// curve.
class VerticesOnCurves
{
public:
  VerticesOnCurves(const TriangleMesh& mesh, const CurveChains& chains);

  /// Ascending, each once, with its first curve.
  const std::vector<VertexOnCurve>& vertices() const { return this->vertices_; }
  /// Null if no curve contains the vertex.
  const VertexOnCurve* find(Id vertex) const;
  /// The ends at a vertex of the segments that leave it: segmentEndsAt().
  std::vector<SegmentEnd> endsAt(Id vertex) const { return of(vertex, this->ends_); }
  /// The same of all points at its place: segmentEndsAround().
  std::vector<SegmentEnd> endsAround(Id vertex) const { return of(vertex, this->endsAround_); }

private:
  struct EndAtVertex
  {
    Id vertex;
    SegmentEnd end;
  };
  using Ends = std::vector<EndAtVertex>;

  void add(const TriangleMesh& mesh, const CurveChains& chains, Id number, std::size_t i);
  static void sort(Ends& ends);
  static std::vector<SegmentEnd> of(Id vertex, const Ends& ends);

  std::vector<VertexOnCurve> vertices_;
  /// By vertex.
  Ends ends_;
  Ends endsAround_;
};

}

#endif
