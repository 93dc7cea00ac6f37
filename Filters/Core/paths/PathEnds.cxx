// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathEnds.h"

#include "Tolerance.h"
#include "Trigonometry.h"
#include "source/FanAround.h"
#include "source/NearVertex.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace geodesic
{

namespace
{

std::vector<SourceInFace> sourcesByFace(const TriangleMesh& mesh, const CurveChains& chains)
{
  std::vector<SourceInFace> sources;
  for (Id chain = 0; chain < chains.curves().size(); ++chain)
  {
    const SourceCurve& curve = chains.curves()[chain];
    const std::vector<SourceInFace> segments =
      segmentsInFaces(mesh, curve, chain, chains.parameters(chain));
    sources.insert(sources.end(), segments.begin(), segments.end());
    if (curve.points.size() == 1)
    {
      forEachFace(mesh, curve.points.front(),
        [&](Id face)
        {
          const Barycentric point = barycentric(mesh, curve.points.front(), face);
          sources.push_back({ face, point, point, chain });
        });
    }
  }
  std::stable_sort(sources.begin(), sources.end());
  return sources;
}

/// The direction from a point beside a vertex to the place that a path comes from to the vertex. It
/// leads past the vertex on the side of the shorter turn of at most pi, else to the vertex.
///
/// \param corner at the vertex, in the point's face.
/// \param from where the path comes from, in a face of the vertex with this corner.
/// \returns it in the frame of the first corner's first edge.
Vec2 directionAround(const TriangleMesh& mesh, Id corner, const Barycentric& point, Id otherCorner,
  const Barycentric& from)
{
  const SurfacePoint vertex = SurfacePoint::atVertex(mesh.origin(corner));
  const FanAround fan(mesh, { vertex, {} });
  const Vec2 p = fromCorner(mesh, corner, point);
  const Vec2 q = fromCorner(mesh, otherCorner, from);
  const double turn = fan.turn(fan.angleOf(corner, p), fan.angleOf(otherCorner, q));
  if (!(std::abs(turn) < Pi))
  {
    return { -p.x, -p.y };
  }
  const bool isMirrored = fan.isMirrored(TriangleMesh::faceOf(corner));
  return norm(q) * unitVector(polarAngle(p) + (isMirrored ? -turn : turn)) - p;
}

/// directionFromEnd() of a path whose end lies beside a vertex and whose last pieces pass there.
std::optional<Vec2> directionPastVertex(
  const TriangleMesh& mesh, const std::vector<SurfacePoint>& path, Id face)
{
  const Barycentric end = barycentric(mesh, path.back(), face);
  const auto largest =
    static_cast<std::size_t>(std::max_element(end.begin(), end.end()) - end.begin());
  const NearVertex near = nearVertexAt(mesh, TriangleMesh::halfedgeOf(face, largest), end);
  const auto cornerIn = [&](Id other)
  {
    const Triangle& corners = mesh.triangle(other);
    const auto k = std::find(corners.begin(), corners.end(), near.vertex) - corners.begin();
    return k < 3 ? TriangleMesh::halfedgeOf(other, static_cast<std::size_t>(k)) : NoId;
  };
  const bool isBeside = near.hasFan() && near.distance > 0.0;
  for (std::size_t i = path.size() - 1; isBeside && i > 0; --i)
  {
    const Id before = commonFace(mesh, path[i - 1], path[i]);
    const Id corner = cornerIn(before);
    if (corner == NoId)
    {
      break;
    }
    const Barycentric from = barycentric(mesh, path[i - 1], before);
    if (norm(fromCorner(mesh, corner, from)) > tolerance::NearEdge * mesh.shape(before).longest())
    {
      return i + 1 < path.size()
        ? std::optional(turned(mesh, directionAround(mesh, cornerIn(face), end, corner, from),
            cornerIn(face), TriangleMesh::halfedgeOf(face, 0)))
        : std::nullopt;
    }
  }
  return std::nullopt;
}

/// The direction in which a path leaves its end, in the frame of the first halfedge of the face of
/// its last piece. Where the end lies beside an edge that piece may be as short as the rounding of
/// its place: the path comes straight from the piece before, with that piece's face laid out behind
/// the edge.
Vec2 directionFromEnd(const TriangleMesh& mesh, const std::vector<SurfacePoint>& path, Id face)
{
  if (const std::optional<Vec2> past = directionPastVertex(mesh, path, face))
  {
    return *past;
  }
  const Id frame = TriangleMesh::halfedgeOf(face, 0);
  const SurfacePoint& before = path[path.size() - 2];
  const Vec2 last =
    wayInFrame(mesh, frame, barycentric(mesh, path.back(), face), barycentric(mesh, before, face));
  const bool isLong = norm(last) > tolerance::NearEdge * mesh.shape(face).longest();
  if (isLong || before.kind != SurfacePoint::Kind::Edge || path.size() < 3)
  {
    return last;
  }
  const SurfacePoint& third = path[path.size() - 3];
  const Id halfedge = mesh.siblingInFace(before.id, commonFace(mesh, third, before));
  const FaceDirection piece = { halfedge,
    inHalfedgeFrame(mesh, halfedge, third) - inHalfedgeFrame(mesh, halfedge, before) };
  const FaceDirection onward = acrossEdge(mesh, piece, mesh.siblingInFace(before.id, face));
  return last + turned(mesh, onward, frame);
}

double lengthOf(const TriangleMesh& mesh, const std::vector<SurfacePoint>& path)
{
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    length += distanceInSpace(mesh, path[i - 1], path[i]);
  }
  return length;
}

} // anonymous namespace

PathEnds::PathEnds(const ReplicatedPatch& patch, const std::vector<SourceCurve>& curves)
  : curves_(curves)
  , onPatch_(patch, curves)
  , inFaces_(sourcesByFace(patch.mesh(), this->onPatch_.chains()))
{
}

// The end of a traced path is rounded, the more the longer the path is: near the end of a segment
// it is the curve's point.
PathEnd PathEnds::of(const TriangleMesh& mesh, const std::vector<SurfacePoint>& path,
  const std::function<RankAddress(Id)>& addressOf) const
{
  const Id onMesh = commonFace(mesh, path[path.size() - 2], path.back());
  const Id face = this->onPatch_.patch().faceAt(addressOf(onMesh));
  if (face == NoId)
  {
    return {};
  }
  const Barycentric end = barycentric(mesh, path.back(), onMesh);
  const LastPiece piece = { normalized(this->mesh(), fromBarycentric(this->mesh(), face, end)),
    face, directionFromEnd(mesh, path, onMesh) };
  const double rounding = tolerance::PlaceRounding * this->mesh().shape(face).longest();
  const SourceInFace* segment = this->nearest(piece.end, face, rounding);
  if (segment == nullptr)
  {
    return {};
  }
  const double length = segment->parameterOfB - segment->parameterOfA;
  const double along = length *
    nearestAlongSource(this->mesh(), *segment, barycentric(this->mesh(), piece.end, segment->face));
  const double beside = rounding + tolerance::TracedLength * lengthOf(mesh, path);
  if (along > beside && along < length - beside)
  {
    return this->onSegment(piece, *segment, segment->parameterOfA + along);
  }
  const double parameter = along > beside ? segment->parameterOfB : segment->parameterOfA;
  return this->atPoint(piece, this->onPatch_.chains().pointAt(segment->curve, parameter));
}

// The segment, or source that is a point, nearest to a point in the faces around it. Null if these
// faces contain none. Those in the preferred face are taken before those of other faces that are as
// near but for rounding.
const SourceInFace* PathEnds::nearest(
  const SurfacePoint& point, Id preferred, double rounding) const
{
  double least = Infinity;
  const SourceInFace* nearest = nullptr;
  forEachFace(this->mesh(), point,
    [&](Id face)
    {
      const Barycentric weights = barycentric(this->mesh(), point, face);
      const auto pieces =
        std::equal_range(this->inFaces_.begin(), this->inFaces_.end(), SourceInFace{ face });
      for (auto piece = pieces.first; piece != pieces.second; ++piece)
      {
        const double distance =
          distanceToSource(this->mesh(), *piece, weights) + (face == preferred ? 0.0 : rounding);
        if (distance < least)
        {
          least = distance;
          nearest = &*piece;
        }
      }
    });
  return nearest;
}

PathEnd PathEnds::onSegment(
  const LastPiece& piece, const SourceInFace& segment, double parameter) const
{
  const Id frame = TriangleMesh::halfedgeOf(piece.face, 0);
  double side = 0.0;
  if (segment.face == piece.face)
  {
    side = cross(inHalfedgeFrame(this->mesh(), frame, segment.b) -
        inHalfedgeFrame(this->mesh(), frame, segment.a),
      piece.direction);
  }
  return this->endAt(
    segment.curve, parameter, side > 0.0 ? RightAngle : (side < 0.0 ? -RightAngle : 0.0));
}

// If several curves meet in the point, the direction tells which one the end belongs to.
PathEnd PathEnds::atPoint(const LastPiece& piece, Id number) const
{
  const CurveChains::Point at = this->onPatch_.chains().pointWith(number);
  const PointOfSource place = this->onPatch_.placeOf(at);
  const double parameter = this->onPatch_.chains().parameters(at.chain)[at.i];
  if (!(dot(piece.direction, piece.direction) > 0.0) ||
    !contains(this->mesh(), piece.face, place.point))
  {
    return this->endAt(at.chain, parameter, 0.0);
  }
  const FanAround fan(this->mesh(), place);
  const Id frame = TriangleMesh::halfedgeOf(piece.face, 0);
  const SideOfCurve end = fan.sideOf(frame, piece.direction);
  return this->endAt(
    end.curve, end.parameter, fan.angleFromCurve(fan.angleOf(frame, piece.direction)));
}

// 0 is the angle of a path without a direction.
PathEnd PathEnds::endAt(Id chain, double parameter, double angle) const
{
  const CurveChains& chains = this->onPatch_.chains();
  const Id curve = chains.curveAt(chain, parameter);
  return { this->curves_[curve].source, chains.arcLength(curve, parameter),
    angle != 0.0 ? chains.angleFrom(curve, angle) : 0.0 };
}

}
