// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CurveSectors_h
#define geodesic_CurveSectors_h

#include "mesh/HalfedgeFrame.h"
#include "source/SegmentEnd.h"
#include "window/Window.h"

#include <vector>

namespace geodesic
{

/// What a path that ends in a source's point has reached: Window::origin and Window::place.
struct CurveOrigin
{
  Id origin = NoId;
  double place = 0.0;

  /// A place of a curve, on its left-hand side.
  static CurveOrigin onLeft(const TriangleMesh& mesh, Id curve, double place)
  {
    return { CurveSide{ curve, false }.origin(mesh.numberOfVertices()), place };
  }

  bool operator==(const CurveOrigin& other) const
  {
    return this->origin == other.origin && this->place == other.place;
  }
  bool operator!=(const CurveOrigin& other) const { return !(*this == other); }
};

/// Which curve, and which side of it, each direction around a source's point belongs to: those of
/// the segment that is nearest by angle, measured around the point. At an open end that parts the
/// directions in the middle behind the segment; where curves branch, in the middle between them.
///
/// In faces that cannot be reached around the point without crossing an edge of other than two
/// faces, or faces of opposite orientation, all directions belong to the first curve's left-hand
/// side.
class CurveSectors
{
public:
  explicit CurveSectors(const TriangleMesh& mesh)
    : mesh_(mesh)
  {
  }

  /// Goes to a point.
  ///
  /// \param ends the ends of all segments there.
  /// \param whole what all directions belong to where there is no segment.
  void assign(
    const SurfacePoint& point, const std::vector<SegmentEnd>& ends, const CurveOrigin& whole);

  /// What a direction in the frame of a halfedge belongs to.
  CurveOrigin of(Id halfedge, Vec2 direction) const;

  /// The directions in a face, in the frame of a halfedge of it, where what they belong to changes.
  std::vector<Vec2> changesIn(Id halfedge) const;

private:
  /// Faces that follow one another around the point, by number, and an angle around it. Where they
  /// close it is from 0 to their total angle.
  struct FanAngle
  {
    std::size_t fan;
    double angle;
    bool operator<(const FanAngle& other) const
    {
      return this->fan != other.fan ? this->fan < other.fan : this->angle < other.angle;
    }
  };
  /// A face around the point: the direction of the x axis of one of the face's halfedges, and the
  /// angle of the face from there on.
  struct Frame
  {
    Id halfedge;
    FanAngle axis;
    double width;
  };
  /// The directions on both sides of a segment, counterclockwise and clockwise from it.
  struct End
  {
    FanAngle at;
    CurveOrigin after;
    CurveOrigin before;
    bool operator<(const End& other) const { return this->at < other.at; }
  };

  void addFan(const SurfacePoint& point, Id face);
  void addFanAroundEdge(Id halfedge);
  void addFanAroundVertex(Id corner);
  void addEnd(const SegmentEnd& end);
  void findChanges();
  const Frame* frameOf(Id face) const;
  double total(std::size_t fan) const { return this->totals_[fan]; }
  FanAngle angleIn(const Frame& frame, Vec2 direction) const;

  const TriangleMesh& mesh_;
  CurveOrigin whole_;
  /// In the order of the faces.
  std::vector<Frame> frames_;
  /// The total angle of each fan that closes; infinite elsewhere.
  std::vector<double> totals_;
  std::vector<End> ends_;
  std::vector<FanAngle> changes_;
};

}

#endif
