// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceWindows.h"

#include "Tolerance.h"
#include "source/CurvesOnPatch.h"
#include "source/PointWindows.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

namespace
{

// The rays through one halfedge: the strip beside the segment, bounded by the rays at its two ends.
void addThroughHalfedge(const TriangleMesh& mesh, Id halfedge, const SourceInFace& segment,
  std::vector<LeavingWindow>& windows)
{
  Vec2 from = inLeavingFrame(mesh, halfedge, segment.a);
  Vec2 to = inLeavingFrame(mesh, halfedge, segment.b);
  // Rays go up; they leave to the left of a segment that runs from left to right.
  const bool isRight = from.x > to.x;
  if (isRight)
  {
    std::swap(from, to);
  }
  const double length = norm(to - from);
  if (!(length > 0.0))
  {
    return;
  }
  const Vec2 t = (1.0 / length) * (to - from);
  Interval interval{ 0.0, mesh.length(halfedge) };
  const double origin = dot(from, t); // position along the segment of x = 0, negated
  interval.clip(-origin, t.x);
  interval.clip(origin + length, -t.x);
  // If the segment touches the halfedge, rays leave the face only up to there: none if it leads
  // from the end of the halfedge to the other side.
  const double sigma = -cross(t, from);
  interval.clip(sigma, -t.y);
  const double parameter = isRight ? segment.parameterOfB + origin : segment.parameterOfA - origin;
  addLeavingWindow(mesh, halfedge, interval,
    { 0.0, 0.0, -t.y, t.x, sigma, 0.0, Window::Kind::Linear, 0,
      RayOrigin::curveSide(segment.curve, isRight), NoId, RayStart::atParameter(parameter) },
    windows);
}

class SourceWindowsMaker
{
public:
  SourceWindowsMaker(
    const TriangleMesh& mesh, const std::vector<SourceCurve>& curves, const Job& job)
    : mesh_(mesh)
    , given_(curves)
    , curves_(ReplicatedPatch(mesh), curves)
    , job_(job)
  {
  }

  SourceWindows make()
  {
    for (Id chain = 0; chain < this->chains().curves().size(); ++chain)
    {
      this->addSegments(chain);
      this->addPoints(chain);
    }
    this->emitFromVertices();
    if (std::any_of(this->given_.begin(), this->given_.end(),
          [](const SourceCurve& curve) { return !curve.coveredFaces.empty(); }))
    {
      this->addCoveredFaces();
    }
    std::stable_sort(this->result_.inFaces.begin(), this->result_.inFaces.end());
    return std::move(this->result_);
  }

private:
  const CurveChains& chains() const { return this->curves_.chains(); }

  void addSegments(Id chain)
  {
    const std::vector<double>& parameters = this->chains().parameters(chain);
    for (const SourceInFace& segment :
      segmentsInFaces(this->mesh_, this->chains().curves()[chain], chain, parameters))
    {
      this->job_.look();
      this->result_.inFaces.push_back(segment);
      addSegmentWindows(this->mesh_, segment, this->result_.windows);
    }
  }

  void addPoints(Id chain)
  {
    const SourceCurve& curve = this->chains().curves()[chain];
    const std::size_t count = curve.points.size() - (curve.isClosed() ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i)
    {
      const SurfacePoint& p = curve.points[i];
      // Faces at an edge of three and more faces see the curve bend.
      const bool straight =
        curve.isCut[i] && p.kind == SurfacePoint::Kind::Edge && this->mesh_.isInner(p.id);
      const Id point = this->chains().numberOf({ chain, i });
      if (p.kind == SurfacePoint::Kind::Vertex)
      {
        continue; // see emitFromVertices()
      }
      if (straight || this->curves_.vertexAtPlaceOf(point) != nullptr)
      {
        this->job_.look();
      }
      else
      {
        this->emitFromPoint(point, this->curves_.endsAt(point));
      }
    }
  }

  // If several curves meet in one vertex, all their segments bound its wedges together.
  void emitFromVertices()
  {
    for (const VertexOnCurve& v : this->curves_.vertices())
    {
      if (&v == this->curves_.find(v.vertex))
      {
        this->result_.vertices.push_back(v.vertex);
        this->emitFromPoint(v.point, this->curves_.endsAtVertex(v.vertex));
      }
    }
  }

  /// \param ends of the segments that bound the point's wedge.
  void emitFromPoint(Id point, const std::vector<SegmentEnd>& ends)
  {
    this->job_.look();
    const PointOfSource from = this->curves_.placeOf(point);
    const CurveWedge wedge = wedgeAround(this->mesh_, from.place, ends);
    const FanAround fan(this->mesh_, from);
    const CurveChains::Point at = this->chains().pointWith(from.point);
    const double parameter = this->chains().parameters(at.chain)[at.i];
    forEachFace(this->mesh_, from.place,
      [&](Id face)
      {
        this->job_.look();
        const Barycentric b = barycentric(this->mesh_, from.place, face);
        const SourceInFace source = { face, b, b, at.chain, parameter, parameter };
        if (from.place.kind != SurfacePoint::Kind::Vertex)
        {
          this->result_.inFaces.push_back(source);
        }
        addPointWindows(this->mesh_, source, wedge, fan, this->result_);
      });
  }

  // Paths from a covered face begin at its edges, so no window leaves it.
  void addCoveredFaces()
  {
    std::vector<std::uint8_t> isCovered(this->mesh_.numberOfFaces(), 0);
    for (std::size_t c = 0; c < this->given_.size(); ++c)
    {
      const CurveChains::CurveInChain& at = this->chains().inChain(static_cast<Id>(c));
      const double parameter = this->chains().parameters(at.chain)[at.begin];
      for (const Id face : this->given_[c].coveredFaces)
      {
        this->job_.look();
        isCovered[face] = 1;
        this->result_.inFaces.push_back(
          { face, cornerWeights(0), cornerWeights(0), at.chain, parameter, parameter, true });
      }
    }
    this->addVerticesInside(isCovered);
    std::vector<LeavingWindow>& windows = this->result_.windows;
    windows.erase(std::remove_if(windows.begin(), windows.end(),
                    [&](const LeavingWindow& leaving)
                    { return isCovered[TriangleMesh::faceOf(leaving.halfedge)] != 0; }),
      windows.end());
  }

  // Vertices all around which faces are covered emit nothing.
  void addVerticesInside(const std::vector<std::uint8_t>& isCovered)
  {
    std::vector<Id>& vertices = this->result_.vertices;
    for (const SourceInFace& source : this->result_.inFaces)
    {
      for (const Id vertex : this->mesh_.triangle(source.face))
      {
        const auto corners = this->mesh_.cornersAt(vertex);
        if (std::all_of(corners.begin(), corners.end(),
              [&](Id corner) { return isCovered[TriangleMesh::faceOf(corner)] != 0; }))
        {
          vertices.push_back(vertex);
        }
      }
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  }

  const TriangleMesh& mesh_;
  const std::vector<SourceCurve>& given_;
  const CurvesOnPatch curves_;
  const Job& job_;
  SourceWindows result_;
};

/// A halfedge of a patch in a rank's part; NoId if the part does not have its face.
Id halfedgeOfPart(const MeshPartition& part, const ReplicatedPatch& patch, Id halfedge)
{
  const Id face = part.faceAt(patch.ownerOf(TriangleMesh::faceOf(halfedge)));
  return face != NoId ? TriangleMesh::inCopy(halfedge, face) : NoId;
}

/// A vertex of a patch in a rank's part; NoId if it is none of the rank's own points.
Id vertexOfPart(const MeshPartition& part, const ReplicatedPatch& patch, Id vertex)
{
  for (const Id corner : patch.mesh().cornersAt(vertex))
  {
    const Id there = halfedgeOfPart(part, patch, corner);
    if (there != NoId && part.mesh().origin(there) < part.numberOfOwnVertices())
    {
      return part.mesh().origin(there);
    }
  }
  return NoId;
}

/// Those windows whose halfedges a rank needs, with its numbers.
///
/// \param isNeeded (Id halfedge) -> bool, with the rank's number.
template <typename IsNeeded>
std::vector<LeavingWindow> windowsOfPart(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<LeavingWindow>& windows, const IsNeeded& isNeeded)
{
  std::vector<LeavingWindow> result;
  for (const LeavingWindow& leaving : windows)
  {
    const Id halfedge = halfedgeOfPart(part, patch, leaving.halfedge);
    if (halfedge != NoId && isNeeded(halfedge))
    {
      result.push_back({ halfedge, leaving.window });
      RayOrigin& origin = result.back().window.origin;
      origin = origin.isVertex()
        ? RayOrigin::vertex(patch.globalId(static_cast<Id>(origin.vertex())))
        : origin;
    }
  }
  return result;
}

/// Where a rank does not have the halfedge's face, nor its halo, it has no face at the vertex.
std::vector<NearVertex> nearVerticesOfPart(
  const MeshPartition& part, const ReplicatedPatch& patch, const std::vector<NearVertex>& vertices)
{
  std::vector<NearVertex> result;
  for (NearVertex near : vertices)
  {
    near.vertex = vertexOfPart(part, patch, near.vertex);
    if (near.vertex == NoId)
    {
      continue;
    }
    near.halfedge = near.hasFan() ? halfedgeOfPart(part, patch, near.halfedge) : NoId;
    result.push_back(near);
  }
  return result;
}

std::vector<Id> verticesOfPart(
  const MeshPartition& part, const ReplicatedPatch& patch, const std::vector<Id>& vertices)
{
  std::vector<Id> result;
  for (const Id vertex : vertices)
  {
    const Id there = vertexOfPart(part, patch, vertex);
    if (there != NoId)
    {
      result.push_back(there);
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // anonymous namespace

SourceWindows makeSourceWindows(
  const TriangleMesh& mesh, const std::vector<SourceCurve>& curves, const Job& job)
{
  return SourceWindowsMaker(mesh, curves, job).make();
}

SourceWindows makeSourceWindows(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<SourceCurve>& curves, const Job& job)
{
  const SourceWindows onPatch = makeSourceWindows(patch.mesh(), curves, job);
  SourceWindows result;
  result.windows = windowsOfPart(part, patch, onPatch.windows,
    [&](Id halfedge) { return part.isOwn(TriangleMesh::faceOf(halfedge)); });
  // Each rank learns all ways to a vertex itself, so that all choose among them alike.
  result.toVertices = windowsOfPart(part, patch, onPatch.toVertices,
    [&](Id halfedge) { return part.mesh().opposite(halfedge) < part.numberOfOwnVertices(); });
  for (const SourceInFace& source : onPatch.inFaces)
  {
    const Id face = part.faceAt(patch.ownerOf(source.face));
    if (face != NoId)
    {
      std::vector<SourceInFace>& sources = part.isOwn(face) ? result.inFaces : result.inHalo;
      sources.push_back(source);
      sources.back().face = face;
    }
  }
  result.vertices = verticesOfPart(part, patch, onPatch.vertices);
  result.nearVertices = nearVerticesOfPart(part, patch, onPatch.nearVertices);
  return result;
}

Vec2 inLeavingFrame(const TriangleMesh& mesh, Id halfedge, const Barycentric& point)
{
  const Vec2 p = inHalfedgeFrame(mesh, halfedge, point);
  return { mesh.length(halfedge) - p.x, -p.y };
}

void addLeavingWindow(const TriangleMesh& mesh, Id halfedge, const Interval& interval,
  const Window& window, std::vector<LeavingWindow>& windows)
{
  const double length = mesh.length(halfedge);
  const double begin = std::max(interval.begin, 0.0);
  const double end = std::min(interval.end, length);
  if (end - begin > tolerance::LeastWidth * length && window.sourceDepth > 0.0)
  {
    LeavingWindow& leaving = windows.emplace_back(LeavingWindow{ halfedge, window });
    leaving.window.begin = begin;
    leaving.window.end = end;
  }
}

void addSegmentWindows(
  const TriangleMesh& mesh, const SourceInFace& segment, std::vector<LeavingWindow>& windows)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id halfedge = TriangleMesh::halfedgeOf(segment.face, k);
    if (!runsAlong(k, segment.a, segment.b) && !mesh.isBoundary(halfedge) &&
      mesh.length(halfedge) > 0.0)
    {
      addThroughHalfedge(mesh, halfedge, segment, windows);
    }
  }
}

LeavingWindow vertexWindow(const TriangleMesh& mesh, Id corner, double sigma)
{
  const Id halfedge = TriangleMesh::nextInFace(corner);
  const double length = mesh.length(halfedge);
  const Vec2 p = inLeavingFrame(mesh, halfedge, cornerWeights(TriangleMesh::indexInFace(corner)));
  const double depth = std::max(-p.y, tolerance::SourceDepth * length);
  return { halfedge, { 0.0, length, p.x, depth, sigma, 0.0, Window::Kind::Circular, 0 } };
}

}
