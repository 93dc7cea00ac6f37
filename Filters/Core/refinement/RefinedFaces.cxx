// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RefinedFaces.h"

#include "Tolerance.h"
#include "refinement/TriangleShape.h"

#include <algorithm>

namespace geodesic
{

RefinedFaces::RefinedFaces(const DistanceField& refined, const Job& job)
  : field(refined)
  , edges(refined.mesh())
  , ofFace_(refined.mesh().numberOfFaces(), NoId)
  , isFrozen_(refined.mesh().numberOfFaces())
{
  job.part(0.0, 0.0).loop(this->isFrozen_.size(),
    [&](std::size_t i)
    {
      const Id face = static_cast<Id>(i);
      const Triangle& corners = refined.mesh().triangle(face);
      const bool isRefined = refined.surface().isOwn(face) && refined.knowsInside(face) &&
        !refined.isCovered(face) &&
        std::all_of(corners.begin(), corners.end(),
          [&](Id corner) { return refined.vertexDistances()[corner] < Infinity; });
      this->isFrozen_[face] = isRefined ? 0 : 1;
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

void RefinedFaces::takePoints(FaceTriangles& face, const FaceDistance& distance) const
{
  for (std::size_t side = 0; side < 3; ++side)
  {
    this->takePoints(face, side, distance);
  }
}

// From one corner of the side to the next. A part keeps the half that begins first, so the rest of
// the side is in the part that was added.
void RefinedFaces::takePoints(
  FaceTriangles& face, std::size_t side, const FaceDistance& distance) const
{
  std::vector<Id> numbers = this->edges[face.side(side).edge].points;
  if (face.pointsOn(side) == numbers.size())
  {
    return;
  }
  if (face.side(side).isReversed)
  {
    std::reverse(numbers.begin(), numbers.end());
  }
  struct Piece
  {
    Id from; // the number of the point where it begins
    Id part;
    std::size_t k;
    bool operator<(const Piece& other) const { return this->from < other.from; }
  };
  std::vector<Piece> pieces;
  for (Id part = 0; part < face.numberOfParts(); ++part)
  {
    const FaceTriangles::Part& p = face.parts()[part];
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (p.across[k] == NoId && face.sideWith(p.corners[k], p.corners[(k + 1) % 3]) == side)
      {
        pieces.push_back({ face.points()[p.corners[k]].number, part, k });
      }
    }
  }
  std::sort(pieces.begin(), pieces.end());
  const auto find = [&pieces](Id number) {
    return std::lower_bound(pieces.begin(), pieces.end(), Piece{ number, 0, 0 });
  };
  Piece last = *find(face.points()[side].number);
  for (const Id number : numbers)
  {
    const auto found = find(number);
    if (found != pieces.end() && found->from == number)
    {
      last = *found;
      continue;
    }
    const Id point = face.addPoint(this->pointOnEdge(side, number, distance));
    last.part = face.split(last.part, last.k, point);
  }
}

double RefinedFaces::lengthAtBorder(
  Id face, const Triangle& corners, SourceRegions& regions, double tolerance) const
{
  const TriangleMesh& mesh = this->field.mesh();
  std::array<SourceRegion, 3> region;
  std::array<double, 3> distance;
  std::array<Vec2, 3> place;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id number =
      this->isOpen(face) ? this->triangles(face).points()[corners[k]].number : corners[k];
    const SurfacePoint on =
      number == NoId ? this->triangles(face).placeOf(corners[k]) : this->edges.placeOf(number);
    region[k] = regions.at(on);
    distance[k] = number == NoId ? this->triangles(face).points()[corners[k]].distance
                                 : this->edges.distanceOf(number, this->field.vertexDistances());
    place[k] = inHalfedgeFrame(mesh, longestHalfedge(mesh, face), on);
  }
  const auto isBorder = [&](std::size_t a, std::size_t b)
  {
    // Where a straight line crosses the curve between its sides, there is no border. Both ends are
    // then nearer to the crossing than to each other.
    return region[a].source != region[b].source ||
      (region[a].isRight != region[b].isRight &&
        distance[a] + distance[b] > (1.0 + tolerance::Tie) * norm(place[b] - place[a]));
  };
  const double longest = longestEdge(place);
  return longest > tolerance && (isBorder(0, 1) || isBorder(1, 2) || isBorder(2, 0)) ? longest
                                                                                     : 0.0;
}

}
