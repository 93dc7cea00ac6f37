// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FanAround_h
#define geodesic_FanAround_h

#include "source/SourceCurve.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

namespace geodesic
{

/// One side of a curve at one of its points, by its number (CurveChains).
struct SideOfCurve
{
  Id point = NoId;
  bool isRight = false;

  bool operator==(const SideOfCurve& other) const
  {
    return this->point == other.point && this->isRight == other.isRight;
  }
  bool operator!=(const SideOfCurve& other) const { return !(*this == other); }
};

/// A point of the source, and the ends of all segments at its place.
struct PointOfSource
{
  SurfacePoint place;
  std::vector<SegmentEnd> ends;
  /// The number of a curve's point there (CurveChains).
  Id point = NoId;
};

/// The faces around a point of the source, laid out in fans: each face of a fan follows the one
/// before it across an edge of two faces. All faces at an edge continue its first one. Tells the
/// angle of each direction, and the curve and the side of it that the direction belongs to.
///
/// A fan has the orientation of its first face in the order of the mesh. Angles grow
/// counterclockwise in it, so clockwise in the faces of opposite orientation.
///
/// A direction belongs to a side of the segment that is nearest by angle. Between two segments, or
/// behind the open end of a curve, the side changes in the middle. Sides do not reach into faces of
/// opposite orientation, nor across edges of three and more faces: directions there belong to the
/// left side of the point's own curve, unless there are segments, too.
class FanAround
{
public:
  FanAround(const TriangleMesh& mesh, const PointOfSource& at);

  bool hasFace(Id face) const { return this->sectors_.count(face) > 0; }
  /// Whether angles grow clockwise in a face around the point.
  bool isMirrored(Id face) const { return this->sectors_.at(face).isMirrored; }

  /// The angle of a direction, in the frame of a halfedge of a face around the point. It is not
  /// scaled, and every direction has its own angle.
  double angleOf(Id halfedge, Vec2 direction) const;
  /// The turn from one angle to another of the same fan; in a closed fan the shorter one.
  double turn(double from, double to) const;

  /// FootFinder::angleOf(), for the direction of a curve's chain.
  ///
  /// \param angle from angleOf(); in a closed fan plus any multiple of the fan's total.
  double angleFromCurve(double angle) const;

  /// Angle 0 of a point without segments: along this halfedge, or against it.
  struct Axis
  {
    Id halfedge = NoId;
    bool isAgainst = false;
  };
  Axis axis() const { return this->axis_; }

  /// The side that a direction belongs to. All directions of other faces, and a vector of length 0,
  /// belong to the left side of the point's own curve.
  SideOfCurve sideOf(Id halfedge, Vec2 direction) const;
  /// The directions in a face at which the side changes, in the frame of one of its halfedges.
  std::vector<Vec2> sideChangesIn(Id halfedge) const;

private:
  /// A face of a fan. The halfedge begins at the vertex or contains the point; if the point is
  /// inside the face, it is the longest one, which surely has a direction.
  struct Sector
  {
    Id halfedge;
    /// The angle of the halfedge's direction.
    double axis;
    double width;
    bool isMirrored;
    std::size_t fan;
    /// A fan consists of parts, one after another, each with faces of one orientation.
    std::size_t part;

    double angleAt(double turn) const { return this->axis + (this->isMirrored ? -turn : turn); }
  };
  struct Fan
  {
    double begin;
    double total;
    bool isClosed;
    bool hasWalls;

    /// An angle in the fan, of a closed one in the first turn.
    double at(double angle) const
    {
      const double turn = angle - this->begin;
      return this->begin +
        (this->isClosed ? turn - this->total * std::floor(turn / this->total)
                        : std::clamp(turn, 0.0, this->total));
    }
  };
  /// The end of a segment, to measure angles from.
  struct End
  {
    double at = 0.0;
    Id point = NoId;
    bool isForward = true;

    bool operator<(const End& other) const { return this->at < other.at; }
    /// The angle of the segment itself, as seen from its clockwise or its counterclockwise side.
    double angle(bool isClockwise) const { return this->isForward ? 0.0 : isClockwise ? Pi : -Pi; }
    bool isContinuedBy(const End& other) const
    {
      return this->point == other.point && this->isForward != other.isForward;
    }
  };
  /// An angle in a part of a fan.
  struct FanAngle
  {
    std::size_t fan;
    std::size_t part;
    double angle;

    bool operator<(const FanAngle& other) const
    {
      return std::tie(this->fan, this->part, this->angle) <
        std::tie(other.fan, other.part, other.angle);
    }
  };
  /// A segment with its sides at smaller and at larger angles; or a wall, where a part begins that
  /// does not continue another. The angle of a wall is -Infinity, and no segment's side goes on
  /// behind it.
  struct Border : FanAngle
  {
    SideOfCurve before;
    SideOfCurve behind;

    bool isWall() const { return this->angle == -Infinity; }
  };
  /// A corner of a fan that a walk has come to.
  struct Stop
  {
    Id corner = NoId;
    bool isMirrored = false;
  };

  void addFan(const SurfacePoint& point, Id face);
  void addFanOfEdge(Id halfedge);
  void addFanOfVertex(Id corner);
  void closeFan(double total, bool isClosed);
  void addWall();
  void addSector(Id halfedge, double axis, double width, bool isMirrored);
  Stop beside(Id vertex, const Stop& stop, bool isClockwise) const;
  void addEnd(const SegmentEnd& end);
  void findChanges();
  double sideAngle(const Sector& sector, Vec2 direction) const;
  const Fan& fanOf(double angle) const;
  double withoutSegments(const Fan& fan, double at) const;
  double betweenSegments(const Fan& fan, double at, const End* first, const End* last) const;

  const TriangleMesh& mesh_;
  SurfacePoint::Kind kind_;
  SideOfCurve own_;
  /// By the numbers of the faces.
  std::map<Id, Sector> sectors_;
  std::vector<Fan> fans_;
  /// Where the next fan begins, and the number of its next part.
  double begin_ = 0.0;
  std::size_t part_ = 0;
  /// In the order of their angles.
  std::vector<End> ends_;
  /// In their order.
  std::vector<Border> borders_;
  std::vector<FanAngle> changes_;
  Axis axis_;
  /// If the point is on an edge: the angle there from the first face's first edge to the fan's
  /// beginning.
  double toAxis_ = 0.0;
};

}

#endif
