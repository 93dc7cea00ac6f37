// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceCurve_h
#define geodesic_SourceCurve_h

#include "mesh/SurfacePoint.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace geodesic
{

/// A polyline on the surface, cut so that each segment lies in one face (paper, section 4.2). A
/// single point is a curve without segments.
struct SourceCurve
{
  /// Consecutive points; a closed curve repeats its first point at the end.
  std::vector<SurfacePoint> points;
  /// The face that contains points i and i + 1; one fewer than points.
  std::vector<Id> faces;
  /// Whether point i only cuts a straight segment at a mesh edge, so that it has no wedge and no
  /// circular windows. One for each point.
  std::vector<std::uint8_t> isCut;
  /// The part of the source to which it belongs, such as a cell's number.
  Id source = 0;
  /// The faces that belong to the source as a whole. The outline of such a region is its curve, or
  /// several, one of which names the faces. A region without an outline is a closed component: one
  /// of its points is its curve.
  std::vector<Id> coveredFaces = {};
  /// False for addBordersWithoutCurves(): it does not count to the length of the source.
  bool isOutline = true;

  bool isClosed() const
  {
    return this->points.size() > 1 &&
      this->points.front().members() == this->points.back().members();
  }
};

/// A source that is a single point.
inline SourceCurve pointCurve(const SurfacePoint& point)
{
  return { { point }, {}, { 0 } };
}

/// Adds the edges between covered faces and others along which no curve of the source runs: edges
/// of three and more faces at which a region branches, and edges that its outline misses by a
/// rounding. Each becomes a curve with the region to its left.
void addBordersWithoutCurves(const TriangleMesh& mesh, std::vector<SourceCurve>& curves);

/// The length of the segment from point i to point i + 1 of a curve.
double lengthOfSegment(const TriangleMesh& mesh, const SourceCurve& curve, std::size_t i);

/// The length of a curve; 0 for a point.
double lengthOf(const TriangleMesh& mesh, const SourceCurve& curve);

/// An end of a curve's segment, which runs from it to another point of the same face.
struct SegmentEnd
{
  SurfacePoint from;
  SurfacePoint to;
  Id face = NoId;
  /// The number of the end among the points of all chains (CurveChains), and whether the chain runs
  /// away from the end.
  Id point = 0;
  bool isBeginning = true;
  /// For a segment without length: the direction in its face in which the curve continues behind
  /// it.
  FaceDirection onward = {};
};

/// The direction of a segment away from its end, in the frame of a halfedge of its face; not
/// normalized.
Vec2 directionIn(const TriangleMesh& mesh, const SegmentEnd& end, Id halfedge);

/// A source inside a face: a segment, a point if both ends are equal, or the whole face.
struct SourceInFace
{
  Id face = NoId;
  Barycentric a = {};
  Barycentric b = {};
  /// The number of its curve's chain (CurveChains), and the parameters of the ends.
  Id curve = 0;
  double parameterOfA = 0.0;
  double parameterOfB = 0.0;
  /// Whether every point of the face is on the source. The ends are then its first corner, and the
  /// parameters those of the first point of the region's curve.
  bool isWholeFace = false;

  bool operator<(const SourceInFace& other) const { return this->face < other.face; }
};

/// Whether one of the sources in a face is the whole face.
inline bool isWholeFaceAmong(const std::vector<SourceInFace>& sources)
{
  return std::any_of(
    sources.begin(), sources.end(), [](const SourceInFace& source) { return source.isWholeFace; });
}

/// Whether a segment from a to b of a face runs along its halfedge k.
inline bool runsAlong(std::size_t k, const Barycentric& a, const Barycentric& b)
{
  return a[(k + 2) % 3] == 0.0 && b[(k + 2) % 3] == 0.0;
}

/// The segments of a curve in their order, each in its face or, if it runs along an edge, in all
/// faces at that edge.
///
/// \param number of the curve.
/// \param parameters those of its points.
std::vector<SourceInFace> segmentsInFaces(const TriangleMesh& mesh, const SourceCurve& curve,
  Id number, const std::vector<double>& parameters);

/// Where along a segment (a at 0, b at 1) the point nearest to a given point of its face is, by
/// straight distance in the face.
double nearestAlongSource(
  const TriangleMesh& mesh, const SourceInFace& source, const Barycentric& point);

/// The nearest point of the source.
Barycentric nearestOnSource(
  const TriangleMesh& mesh, const SourceInFace& source, const Barycentric& point);

/// The distance to the nearest point of the source.
double distanceToSource(
  const TriangleMesh& mesh, const SourceInFace& source, const Barycentric& point);

}

#endif
