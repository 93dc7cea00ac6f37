// SPDX-License-Identifier: BSD-3-Clause
#include "source/SegmentEnd.h"

#include "Tolerance.h"
#include "source/TurnAroundPoint.h"

namespace geodesic
{

namespace
{

constexpr std::size_t None = static_cast<std::size_t>(-1);

/// A step from a point of a curve to the next or the previous one. Segment i runs from point i to
/// point i + 1.
struct Step
{
  std::size_t segment = None;
  std::size_t to = None;
};

/// Its segment is None behind the end of an open curve.
Step stepFrom(const SourceCurve& curve, std::size_t i, bool isForward)
{
  const std::size_t last = curve.points.size() - 1;
  if (isForward)
  {
    return i < last ? Step{ i, i + 1 } : curve.isClosed() ? Step{ 0, 1 } : Step{};
  }
  return i > 0 ? Step{ i - 1, i - 1 } : curve.isClosed() ? Step{ last - 1, last - 1 } : Step{};
}

/// Whether the segment is longer than the rounding of its ends, or than a larger fraction of its
/// face.
bool hasLength(const TriangleMesh& mesh, const SourceCurve& curve, std::size_t segment,
  double fraction = tolerance::PlaceRounding)
{
  const Id face = curve.faces[segment];
  return distanceInFace(mesh, face, barycentric(mesh, curve.points[segment], face),
           barycentric(mesh, curve.points[segment + 1], face)) >
    fraction * mesh.shape(face).longest();
}

/// Whether the ends of a segment are at one place: across a face without area a joined path may run
/// along it as far as it misses its end.
bool isAtOnePlace(const TriangleMesh& mesh, const SourceCurve& curve, std::size_t segment)
{
  return !hasLength(mesh, curve, segment,
    mesh.shape(curve.faces[segment]).hasZeroArea() ? tolerance::NearEdge
                                                   : tolerance::PlaceRounding);
}

/// Whether the ends of a segment determine its direction. Where the curve is merely cut, the next
/// segment determines the direction better than a short one.
bool tellsDirection(const TriangleMesh& mesh, const SourceCurve& curve, const Step& step)
{
  return curve.isCut[step.to] ? hasLength(mesh, curve, step.segment, tolerance::NearEdge)
                              : !isAtOnePlace(mesh, curve, step.segment);
}

/// Calls visit(std::size_t) for point i and for those at its place that follow it in one direction.
template <typename Visit>
void forEachAtOnePlace(
  const TriangleMesh& mesh, const SourceCurve& curve, std::size_t i, bool isForward, Visit&& visit)
{
  visit(i);
  Step step = stepFrom(curve, i, isForward);
  for (std::size_t n = 0;
       n < curve.faces.size() && step.segment != None && isAtOnePlace(mesh, curve, step.segment);
       ++n)
  {
    visit(step.to);
    step = stepFrom(curve, step.to, isForward);
  }
}

/// The steps from a given one, across edges, to the first that determines a direction. If the curve
/// ends or reaches a vertex before, the given step alone, or nothing if it determines no direction.
std::vector<Step> stepsOnward(
  const TriangleMesh& mesh, const SourceCurve& curve, const Step& first, bool isForward)
{
  std::vector<Step> steps = { first };
  while (!tellsDirection(mesh, curve, steps.back()))
  {
    const SurfacePoint& p = curve.points[steps.back().to];
    const Step next = stepFrom(curve, steps.back().to, isForward);
    if (next.segment == None || p.kind != SurfacePoint::Kind::Edge || !mesh.isInner(p.id) ||
      steps.size() == curve.faces.size())
    {
      const bool isAlong = !isAtOnePlace(mesh, curve, first.segment);
      return isAlong ? std::vector<Step>{ first } : std::vector<Step>();
    }
    steps.push_back(next);
  }
  return steps;
}

// Transforms the direction back from face to face over the edges, seen from both sides.
void setOnward(const TriangleMesh& mesh, const SourceCurve& curve, const std::vector<Step>& steps,
  SegmentEnd& end)
{
  const Id face = curve.faces[steps.back().segment];
  const SurfacePoint& from = curve.points[steps[steps.size() - 2].to];
  end.frame = longestHalfedge(mesh, face);
  end.onward =
    inHalfedgeFrame(mesh, end.frame, barycentric(mesh, curve.points[steps.back().to], face)) -
    inHalfedgeFrame(mesh, end.frame, barycentric(mesh, from, face));
  for (std::size_t n = steps.size() - 1; n-- > 0;)
  {
    const SurfacePoint& p = curve.points[steps[n].to];
    const Id own = mesh.siblingInFace(p.id, curve.faces[steps[n].segment]);
    const Id other = mesh.siblingInFace(p.id, curve.faces[steps[n + 1].segment]);
    const Vec2 d = turned(mesh, end.onward, end.frame, other);
    const bool isOpposed = mesh.origin(own) == mesh.destination(other);
    end.frame = own;
    end.onward = own == other ? d : Vec2{ isOpposed ? -d.x : d.x, -d.y };
  }
}

/// Adds the end at a point of the segment towards the next or the previous one.
void addEnd(const TriangleMesh& mesh, const CurveChains& chains, const CurveChains::Point& at,
  bool isForward, std::vector<SegmentEnd>& ends)
{
  const SourceCurve& curve = chains.curves()[at.chain];
  const Step step = stepFrom(curve, at.i, isForward);
  const std::vector<Step> steps =
    step.segment != None ? stepsOnward(mesh, curve, step, isForward) : std::vector<Step>();
  if (!steps.empty())
  {
    ends.push_back({ curve.points[at.i], curve.points[step.to], curve.faces[step.segment], at.chain,
      chains.places(at.chain)[at.i], isForward });
    if (steps.size() > 1)
    {
      setOnward(mesh, curve, steps, ends.back());
    }
  }
}

} // anonymous namespace

std::vector<SegmentEnd> segmentEndsAt(
  const TriangleMesh& mesh, const CurveChains& chains, const CurveChains::Point& at)
{
  std::vector<SegmentEnd> ends;
  addEnd(mesh, chains, at, true, ends);
  addEnd(mesh, chains, at, false, ends);
  return ends;
}

std::vector<SegmentEnd> segmentEndsAround(
  const TriangleMesh& mesh, const CurveChains& chains, const CurveChains::Point& at)
{
  std::vector<SegmentEnd> ends;
  for (const bool isForward : { true, false })
  {
    CurveChains::Point last = at;
    forEachAtOnePlace(
      mesh, chains.curves()[at.chain], at.i, isForward, [&last](std::size_t i) { last.i = i; });
    addEnd(mesh, chains, last, isForward, ends);
  }
  return ends;
}

Id vertexAtPlaceOf(const TriangleMesh& mesh, const SourceCurve& curve, std::size_t i)
{
  Id vertex = NoId;
  for (const bool isForward : { true, false })
  {
    forEachAtOnePlace(mesh, curve, i, isForward,
      [&](std::size_t point)
      {
        const SurfacePoint& p = curve.points[point];
        const std::vector<Id> others = verticesAtCornerOf(mesh, curve, point);
        const Id found = p.kind == SurfacePoint::Kind::Vertex ? p.id
          : others.empty()                                    ? NoId
                                                              : others.front();
        vertex = std::min(vertex, found);
      });
  }
  return vertex;
}

std::vector<Id> verticesAtCornerOf(
  const TriangleMesh& mesh, const SourceCurve& curve, std::size_t i)
{
  const bool isCorner =
    curve.points.size() > 1 && !curve.isCut[i] && curve.points[i].kind != SurfacePoint::Kind::Face;
  return isCorner ? verticesAtPlaceOf(mesh, curve.points[i]) : std::vector<Id>();
}

bool isAtVertexBeside(const TriangleMesh& mesh, const SourceCurve& curve, std::size_t i)
{
  const auto leadsToVertex = [&](const Step& step)
  {
    return step.segment != None && curve.points[step.to].kind == SurfacePoint::Kind::Vertex &&
      !hasLength(mesh, curve, step.segment);
  };
  return leadsToVertex(stepFrom(curve, i, true)) || leadsToVertex(stepFrom(curve, i, false));
}

Vec2 directionIn(const TriangleMesh& mesh, const SegmentEnd& end, Id halfedge)
{
  if (end.frame != NoId)
  {
    return turned(mesh, end.onward, end.frame, halfedge);
  }
  return inHalfedgeFrame(mesh, halfedge, barycentric(mesh, end.to, end.face)) -
    inHalfedgeFrame(mesh, halfedge, barycentric(mesh, end.from, end.face));
}

}
