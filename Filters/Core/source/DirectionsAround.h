// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DirectionsAround_h
#define geodesic_DirectionsAround_h

#include "source/SourceCurve.h"

#include <vector>

namespace geodesic
{

/// The angles of directions around a source's point. The faces around the point, laid out one after
/// another, form fans, whatever their orientation: a fan has that of its first face in the order of
/// the mesh. Angles grow counterclockwise in it.
class DirectionsAround
{
public:
  explicit DirectionsAround(const TriangleMesh& mesh)
    : mesh_(mesh)
  {
  }

  /// Moves to another point.
  ///
  /// \param ends the ends of all segments at its place: CurvesOnPatch::endsAround().
  void assign(const SurfacePoint& point, const std::vector<SegmentEnd>& ends);

  /// The angle of a direction in the frame of a halfedge of a face around the point: in its fan,
  /// not scaled. Every direction has its own angle.
  double around(Id halfedge, Vec2 direction) const;
  /// Whether these angles grow clockwise in a face around the point.
  bool isMirrored(Id face) const { return this->frameOf(face).isMirrored; }

  /// NearestSource::angleOf(), for the direction of a curve's chain.
  ///
  /// \param around a direction's angle, in a closed fan plus any multiple of the fan's total.
  double angleOf(double around) const;

  /// Angle 0 of a point without segments: along this halfedge, or against it.
  struct Axis
  {
    Id halfedge;
    bool isAgainst;
  };
  Axis axis() const;

private:
  /// A face around the point: the angle of the x axis of one of its halfedges, and the number of
  /// its fan.
  struct Frame
  {
    Id halfedge;
    double axis;
    bool isMirrored;
    std::size_t fan;
  };
  struct Fan
  {
    double begin;
    double total;
    bool isClosed;

    /// An angle in the fan, of a closed one in the first turn.
    double at(double around) const
    {
      const double turn = around - this->begin;
      return this->begin +
        (this->isClosed ? turn - this->total * std::floor(turn / this->total)
                        : std::clamp(turn, 0.0, this->total));
    }
  };
  /// The end of a segment.
  struct End
  {
    double at = 0.0;
    Id curve = NoId;
    double parameter = 0.0;
    bool isForward = true;

    bool operator<(const End& other) const { return this->at < other.at; }
    /// The angle of the segment itself, as seen from its clockwise or its counterclockwise side.
    double angle(bool isClockwise) const { return this->isForward ? 0.0 : isClockwise ? Pi : -Pi; }
    bool isContinuedBy(const End& other) const
    {
      return this->curve == other.curve && this->parameter == other.parameter &&
        this->isForward != other.isForward;
    }
  };
  /// A corner that a turn around the vertex has come to.
  struct Stop
  {
    Id corner = NoId;
    bool isMirrored = false;
  };

  void addFanOfEdge(Id halfedge);
  void addFanOfVertex(Id corner);
  Stop beside(const Stop& stop, bool isClockwise) const;
  std::size_t indexOf(Id face) const;
  const Frame& frameOf(Id face) const { return this->frames_[this->indexOf(face)]; }
  const Fan& fanOf(double around) const;
  double withoutSegments(const Fan& fan, double at) const;
  double betweenSegments(const Fan& fan, double at, const End* first, const End* last) const;

  const TriangleMesh& mesh_;
  SurfacePoint point_;
  /// In the order of the faces.
  std::vector<Frame> frames_;
  std::vector<Fan> fans_;
  /// In the order of their angles.
  std::vector<End> ends_;
  /// The angle from the first face's first edge to the x axis of that face's frame, if the point is
  /// not a vertex.
  double toAxis_ = 0.0;
};

}

#endif
