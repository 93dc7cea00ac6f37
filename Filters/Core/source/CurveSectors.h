// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CurveSectors_h
#define geodesic_CurveSectors_h

#include "source/SourceCurve.h"

#include <map>
#include <vector>

namespace geodesic
{

/// One side of a curve, at a parameter (CurveChains::parameters()).
struct SideOfCurve
{
  Id curve = NoId;
  bool isRight = false;
  double parameter = 0.0;

  bool operator==(const SideOfCurve& other) const
  {
    return this->curve == other.curve && this->isRight == other.isRight &&
      this->parameter == other.parameter;
  }
  bool operator!=(const SideOfCurve& other) const { return !(*this == other); }
};

/// The curve and the side of it to which each direction around a source's point belongs: those of
/// the segment that is nearest by angle, measured around the point. At an open end a border in the
/// middle behind the segment separates the sides; where curves branch, a border in the middle
/// between them.
///
/// If faces can be reached around the point only across an edge with other than two faces, or with
/// faces of opposite orientation, all their directions belong to the first curve's left side.
class CurveSectors
{
public:
  explicit CurveSectors(const TriangleMesh& mesh)
    : mesh_(mesh)
  {
  }

  /// Moves to another point.
  ///
  /// \param ends the ends of all segments at its place: CurvesOnPatch::endsAround().
  /// \param curve whose left side, at the parameter, all directions belong to if there is no
  /// segment.
  void assign(
    const SurfacePoint& point, const std::vector<SegmentEnd>& ends, Id curve, double parameter);

  /// Whether the face is one of those around the point.
  bool haveFace(Id face) const { return this->frameOf(face) != nullptr; }

  /// The side that a direction, in the frame of a halfedge, belongs to.
  SideOfCurve of(Id halfedge, Vec2 direction) const;

  /// The directions in a face at which the side changes, in the frame of one of its halfedges.
  std::vector<Vec2> changesIn(Id halfedge) const;

private:
  /// A fan of faces around the point, by number, and an angle within it. In a closed fan, angles
  /// run from 0 to its total angle.
  struct FanAngle
  {
    std::size_t fan;
    double angle;
    bool operator<(const FanAngle& other) const
    {
      return this->fan != other.fan ? this->fan < other.fan : this->angle < other.angle;
    }
  };
  /// A face around the point: the angle of the x axis of one of its halfedges in the fan, and the
  /// angle of the face from there.
  struct Frame
  {
    Id halfedge;
    FanAngle axis;
    double width;
  };
  /// Both sides of a segment, counterclockwise and clockwise from it.
  struct End
  {
    FanAngle at;
    SideOfCurve after;
    SideOfCurve before;
    bool operator<(const End& other) const { return this->at < other.at; }
  };

  void addFan(const SurfacePoint& point, Id face);
  void addEnd(const SegmentEnd& end);
  void findChanges();
  const Frame* frameOf(Id face) const;
  FanAngle angleIn(const Frame& frame, Vec2 direction) const;

  const TriangleMesh& mesh_;
  SideOfCurve whole_;
  /// The frame of each face, as the first turn has entered it.
  std::map<Id, Frame> frames_;
  /// The total angle of each closed fan; infinite for the others.
  std::vector<double> totals_;
  std::vector<End> ends_;
  std::vector<FanAngle> changes_;
};

}

#endif
