// SPDX-License-Identifier: BSD-3-Clause
#include "source/OpposedCurves.h"

#include "Tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

namespace geodesic
{

namespace
{

/// A segment in the plane of its face, or along its edge.
struct FlatSegment
{
  /// The edge, or the face behind all edges.
  std::uint64_t group;
  Vec2 from;
  Vec2 to;
  SegmentOfCurve at;
  /// What differs by less is one place.
  double tolerance;

  double low() const { return std::min(this->from.x, this->to.x); }
  double high() const { return std::max(this->from.x, this->to.x); }
  bool operator<(const FlatSegment& other) const
  {
    return std::make_tuple(this->group, this->low(), this->at.curve, this->at.segment) <
      std::make_tuple(other.group, other.low(), other.at.curve, other.at.segment);
  }
};

/// Along an edge the axis runs from the lower vertex to the higher, so that it is the same in all
/// faces there.
FlatSegment flattened(const TriangleMesh& mesh, const SourceCurve& curve, const SegmentOfCurve& at)
{
  const Id face = curve.faces[at.segment];
  const double tolerance = tolerance::OnEachOther * mesh.shape(face).longest();
  const SurfacePoint& a = curve.points[at.segment];
  const SurfacePoint& b = curve.points[at.segment + 1];
  const Barycentric first = barycentric(mesh, a, face);
  const Barycentric second = barycentric(mesh, b, face);
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (runsAlong(k, first, second))
    {
      const Id halfedge = TriangleMesh::halfedgeOf(face, k);
      const bool isUp = mesh.origin(halfedge) < mesh.destination(halfedge);
      const std::size_t high = isUp ? (k + 1) % 3 : k;
      const double length = mesh.shape(face).length[k];
      return { mesh.edgeOf(halfedge), { length * first[high], 0.0 }, { length * second[high], 0.0 },
        at, tolerance };
    }
  }
  const Id frame = longestHalfedge(mesh, face);
  return { std::uint64_t{ 3 } * mesh.numberOfFaces() + face, inHalfedgeFrame(mesh, frame, a),
    inHalfedgeFrame(mesh, frame, b), at, tolerance };
}

/// Whether two segments of one group lie on each other, over more than the tolerance, in opposite
/// directions.
bool areOpposed(const FlatSegment& a, const FlatSegment& b)
{
  const Vec2 alongA = a.to - a.from;
  const Vec2 alongB = b.to - b.from;
  const bool isALonger = norm(alongA) >= norm(alongB);
  const FlatSegment& longer = isALonger ? a : b;
  const FlatSegment& shorter = isALonger ? b : a;
  const double length = std::max(norm(alongA), norm(alongB));
  const double tolerance = std::max(a.tolerance, b.tolerance);
  if (!(dot(alongA, alongB) < 0.0) || !(length > tolerance))
  {
    return false;
  }
  const Vec2 direction = (1.0 / length) * (longer.to - longer.from);
  const Vec2 first = shorter.from - longer.from;
  const Vec2 last = shorter.to - longer.from;
  const double begin = std::max(0.0, dot(direction, last));
  const double end = std::min(length, dot(direction, first));
  return end - begin > tolerance && std::abs(cross(direction, first)) <= tolerance &&
    std::abs(cross(direction, last)) <= tolerance;
}

/// Whether a segment comes before another of its group that may touch it.
bool reaches(const FlatSegment& before, const FlatSegment& next)
{
  return before.group == next.group && before.high() + before.tolerance >= next.low();
}

} // anonymous namespace

std::vector<SegmentOfCurve> opposedSegments(
  const TriangleMesh& mesh, const std::vector<SourceCurve>& curves)
{
  std::vector<FlatSegment> segments;
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    for (std::size_t i = 0; i < curves[c].faces.size(); ++i)
    {
      segments.push_back(flattened(mesh, curves[c], { c, i }));
    }
  }
  std::sort(segments.begin(), segments.end());
  std::vector<SegmentOfCurve> opposed;
  std::vector<const FlatSegment*> open; // those before that reach the current one
  for (const FlatSegment& next : segments)
  {
    const auto isBehind = [&next](const FlatSegment* before) { return !reaches(*before, next); };
    open.erase(std::remove_if(open.begin(), open.end(), isBehind), open.end());
    for (const FlatSegment* before : open)
    {
      if (areOpposed(*before, next))
      {
        opposed.push_back(std::max(before->at, next.at));
      }
    }
    open.push_back(&next);
  }
  std::sort(opposed.begin(), opposed.end());
  const auto isSame = [](const SegmentOfCurve& a, const SegmentOfCurve& b)
  { return !(a < b) && !(b < a); };
  opposed.erase(std::unique(opposed.begin(), opposed.end(), isSame), opposed.end());
  return opposed;
}

}
