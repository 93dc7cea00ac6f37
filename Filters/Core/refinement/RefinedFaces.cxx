// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RefinedFaces.h"

#include "Tolerance.h"
#include "refinement/TriangleShape.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

RefinedFaces::RefinedFaces(const DistanceField& refined, const Job& job)
  : field(refined)
  , edges(refined.mesh(), refined.surface().numberOfOwnVertices())
  , ofFace_(refined.mesh().numberOfFaces(), NoId)
  , isRefined_(refined.mesh().numberOfFaces(), 1)
{
  const MeshPartition& surface = refined.surface();
  const Id first = surface.firstOwnFace();
  const Id end = surface.endOfOwnFaces();
  job.part(0.0, 0.0).loop(end - first,
    [&](std::size_t i)
    {
      const Id face = first + static_cast<Id>(i);
      const Triangle& corners = refined.mesh().triangle(face);
      const bool isRefined = refined.knowsInside(face) && !refined.isCovered(face) &&
        std::all_of(corners.begin(), corners.end(),
          [&](Id corner) { return refined.vertexDistances()[corner] < Infinity; });
      this->isRefined_[face] = isRefined ? 1 : 0;
    });
  // Ranks that have a copy of a face have one of its vertices.
  std::vector<Message> messages = surface.exchange().noMessages();
  for (Id face = first; face < end; ++face)
  {
    for (std::size_t k = 0; k < 3 && !this->isRefined(face); ++k)
    {
      for (const RankAddress& other : surface.othersWith(surface.mesh().triangle(face)[k]))
      {
        put(messages[rankIndex(other.rank)], face);
      }
    }
  }
  readEach(surface.exchange().step(std::move(messages)),
    [&](int rank, MessageReader& reader) {
      this->isRefined_[surface.copyOf({ rank, reader.get<Id>() })] = 0;
    });
}

void RefinedFaces::open(Id face)
{
  const TriangleMesh& mesh = this->field.mesh();
  const Id longest = longestHalfedge(mesh, face); // the plane of FaceDistance
  std::array<FaceTriangles::Point, 3> corners;
  std::array<FaceTriangles::Side, 3> sides;
  for (std::size_t k = 0; k < 3; ++k)
  {
    corners[k].weights = cornerWeights(k);
    corners[k].place = inHalfedgeFrame(mesh, longest, corners[k].weights);
    corners[k].number = mesh.triangle(face)[k];
    corners[k].distance = this->field.vertexDistances()[corners[k].number];
    corners[k].here = corners[k].distance; // a corner is among its faces' candidates
    sides[k].edge = this->edges.ensure(TriangleMesh::halfedgeOf(face, k));
    sides[k].isReversed = mesh.origin(this->edges[sides[k].edge].halfedge) != corners[k].number;
  }
  this->ofFace_[face] = static_cast<Id>(this->open_.size());
  this->open_.emplace_back(face, corners, sides);
}

FaceTriangles::Point RefinedFaces::pointOnEdge(
  std::size_t side, Id number, const FaceDistance& distance) const
{
  const PointOnEdge& on = this->edges.point(number);
  FaceTriangles::Point point;
  point.weights = barycentric(this->field.mesh(), this->edges.placeOf(number), distance.face());
  point.place = distance.inPlane(point.weights);
  point.distance = on.distance;
  point.here = distance.isExact() ? on.distance : distance.distance(point.place);
  point.number = number;
  point.sides = static_cast<std::uint8_t>(1U << side);
  point.isForShape = on.isForShape;
  return point;
}

// From one corner of the side to the next. A part keeps the half that begins first, so the rest of
// the side is in the part that was added.
void RefinedFaces::takePoints(
  FaceTriangles& face, std::size_t side, const FaceDistance& distance) const
{
  struct Piece
  {
    Id part;
    std::size_t k;
    Id begin;
  };
  std::vector<Piece> pieces;
  for (Id part = 0; part < face.numberOfParts(); ++part)
  {
    const FaceTriangles::Part& p = face.parts()[part];
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (p.across[k] == NoId && face.sideWith(p.corners[k], p.corners[(k + 1) % 3]) == side)
      {
        pieces.push_back({ part, k, p.corners[k] });
      }
    }
  }
  const std::vector<Id> numbers =
    this->edges.pointsAlong(TriangleMesh::halfedgeOf(face.face(), side));
  if (pieces.size() == numbers.size() + 1)
  {
    return;
  }
  std::sort(pieces.begin(), pieces.end(),
    [&](const Piece& a, const Piece& b)
    { return face.wayAlong(side, a.begin) < face.wayAlong(side, b.begin); });
  auto piece = pieces.begin();
  Id rest = piece->part;
  for (const Id number : numbers)
  {
    const auto next = piece + 1;
    if (next != pieces.end() && face.points()[next->begin].number == number)
    {
      piece = next;
      rest = piece->part;
      continue;
    }
    rest = face.split(rest, piece->k, face.addPoint(this->pointOnEdge(side, number, distance)));
  }
}

double RefinedFaces::lengthAtBorder(
  Id face, const Triangle& corners, SourceRegions& regions, double tolerance) const
{
  struct Corner
  {
    SourceRegion region;
    double distance;
    Vec2 place;
  };
  const auto cornerOf = [&](Id point) -> Corner
  {
    if (this->isOpen(face))
    {
      const FaceTriangles& open = this->triangles(face);
      const FaceTriangles::Point& p = open.points()[point];
      const SurfacePoint on =
        p.number == NoId ? open.placeOf(point) : this->edges.placeOf(p.number);
      return { regions.at(on), p.distance, p.place };
    }
    const SurfacePoint on = this->edges.placeOf(point);
    return { regions.at(on), this->edges.distanceOf(point, this->field.vertexDistances()),
      inHalfedgeFrame(this->field.mesh(), longestHalfedge(this->field.mesh(), face), on) };
  };
  const std::array<Corner, 3> c = { cornerOf(corners[0]), cornerOf(corners[1]),
    cornerOf(corners[2]) };
  const auto isBorder = [](const Corner& a, const Corner& b)
  {
    // Where a straight line crosses the curve between its sides, there is no border. Both ends are
    // then nearer to the crossing than to each other.
    return a.region.source != b.region.source ||
      (a.region.isRight != b.region.isRight &&
        a.distance + b.distance > (1.0 + tolerance::Tie) * norm(b.place - a.place));
  };
  const double longest = longestEdge({ c[0].place, c[1].place, c[2].place });
  const bool isSplit =
    longest > tolerance && (isBorder(c[0], c[1]) || isBorder(c[1], c[2]) || isBorder(c[2], c[0]));
  return isSplit ? longest : 0.0;
}

}
