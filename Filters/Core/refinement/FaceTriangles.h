// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceTriangles_h
#define geodesic_FaceTriangles_h

#include "mesh/HalfedgeFrame.h"
#include "mesh/SurfacePoint.h"

#include <array>
#include <cstdint>
#include <vector>

namespace geodesic
{

/// The triangulation of one face under refinement. It begins as the face. Points come only by
/// splitting a side of a triangle; besides, two triangles can flip the side between them.
///
/// Points are numbered within the face: its corners are 0, 1, 2. Triangles have the orientation of
/// the face.
class FaceTriangles
{
public:
  struct Point
  {
    Barycentric weights;
    /// In the plane of FaceDistance.
    Vec2 place;
    /// As in the result; and according to this face, which differs in an approximate field.
    double distance;
    double here;
    /// Of a vertex or a point on an edge, see PointOnEdge; NoId inside the face, until the result
    /// is written.
    Id number = NoId;
    /// The points of this face between which it was put, and the fraction of the way: inside only.
    std::array<Id, 2> parents = { NoId, NoId };
    double weight = 0.0;
    /// A bit for each of the face's sides on which it lies.
    std::uint8_t sides = 0;
    /// Whether shapes alone have asked for it.
    bool isForShape = false;
  };

  struct Part
  {
    Triangle corners;
    /// The triangle across the side from corner k to corner k + 1; NoId on a side of the face.
    std::array<Id, 3> across = { NoId, NoId, NoId };
    /// Certified: the difference to the distance is nowhere larger. Infinite until the triangle has
    /// been found to be within the tolerance, or is left as it is, and while it waits for a point
    /// on an edge.
    double bound = Infinity;
    /// How often it has changed.
    Id version = 0;

    bool hasPassed() const { return this->bound < Infinity; }
  };

  /// A side of the face as an edge of the input (CutEdges), which may run the other way.
  struct Side
  {
    Id edge;
    bool isReversed;
  };

  FaceTriangles(
    Id face, const std::array<Point, 3>& corners, const std::array<Side, 3>& sides = {});

  Id face() const { return this->face_; }
  const std::vector<Point>& points() const { return this->points_; }
  Point& point(Id point) { return this->points_[point]; }
  const std::vector<Part>& parts() const { return this->parts_; }
  Part& part(Id part) { return this->parts_[part]; }
  Id numberOfParts() const { return static_cast<Id>(this->parts_.size()); }
  std::array<Vec2, 3> places(const Triangle& corners) const;
  /// Where a point inside the face is on the surface.
  SurfacePoint placeOf(Id point) const
  {
    const Barycentric& weights = this->points_[point].weights;
    return SurfacePoint::inFace(this->face_, weights[1], weights[2]);
  }

  const Side& side(std::size_t side) const { return this->sides_[side]; }
  Id pointsForShapes() const { return this->pointsForShapes_; }
  /// The side of the face on which both points lie; 3 if there is none.
  std::size_t sideWith(Id a, Id b) const;
  /// The fraction of the way along a side at a point on it.
  double wayAlong(std::size_t side, Id point) const
  {
    return this->points_[point].weights[(side + 1) % 3];
  }
  /// Whether the triangle has the face's orientation, by more than rounding. Points of one side of
  /// the face are none, whatever rounding says.
  bool isTriangle(const Triangle& corners) const;

  Id addPoint(const Point& point);
  /// Splits the side from corner k to corner k + 1, and the triangle across. The part keeps the
  /// half that begins at corner k. \returns the new part with the other half, at its side k, too.
  Id split(Id part, std::size_t k, Id point);
  /// The two triangles that a flip of side k would make.
  std::array<Triangle, 2> flipped(Id part, std::size_t k) const;
  void flip(Id part, std::size_t k);
  /// Flips sides of triangles that have changed, and what follows, until each point is outside of
  /// the circles of its neighbours: Delaunay's triangles, whose smallest angle is the largest.
  void flipChanged();
  /// The triangles that have changed since the last call, ascending.
  std::vector<Id> takeChanged();

private:
  void change(Id part);
  std::size_t sideTo(Id part, Id other) const;
  void relink(Id part, Id before, Id now);
  bool isInCircle(Id part, std::size_t k) const;

  Id face_;
  std::vector<Point> points_;
  std::vector<Part> parts_;
  std::array<Side, 3> sides_;
  std::vector<Id> changed_;
  Id pointsForShapes_ = 0;
};

}

#endif
