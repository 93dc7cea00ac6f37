// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_DirectionAngles_h
#define geodesictest_DirectionAngles_h

#include "truth/TestMeshes.h"

#include <vector>

namespace geodesictest
{

/// A direction at a point of a mesh: a vector in the plane of a face that contains the point.
struct Direction
{
  Index face;
  Vec3 along;
};

/// The end of a curve's segment at a point, with the direction away from it.
struct SegmentAt
{
  Direction direction;
  std::size_t curve;
  /// Numbers the ways of curves through the point: the segments before and behind it have the same.
  std::size_t pass;
  /// Whether the curve runs away from the point.
  bool isForward;
};

/// The angles of directions around a point of a mesh, measured in space.
class DirectionAngles
{
public:
  DirectionAngles(const PlainMesh& mesh, const MeshPoint& point);

  /// The angle of a path that leaves a source which is this point.
  double ofPoint(const Direction& direction) const;
  /// The angles that a path may have which leaves a curve at this point: several where segments
  /// leave it by the same direction.
  ///
  /// \param segments all that end at the point; at least one.
  /// \param curve that the angle is to be measured from.
  std::vector<double> ofCurve(
    const Direction& direction, const std::vector<SegmentAt>& segments, std::size_t curve) const;

  /// Whether a face contains the point.
  bool hasFace(Index face) const;

private:
  struct Face
  {
    Index face;
    double begin;
    double width;
    bool isMirrored;
    /// Unit vectors along the two edges at a vertex, in the order of the turn.
    Vec3 first;
    Vec3 second;
  };
  struct Fan
  {
    std::vector<Face> faces;
    double total = 0.0;
    bool isClosed = false;
  };
  struct At
  {
    std::size_t fan;
    double angle;
  };

  void addFans(Index vertex);
  At find(const Direction& direction) const;
  double inFirstFace(const Direction& direction) const;

  const PlainMesh& mesh_;
  MeshPoint point_;
  bool isVertex_ = false;
  /// For a point on an edge: a unit vector along it.
  Vec3 edge_ = {};
  bool isOnEdge_ = false;
  /// The angle of a direction into the face of an edge on the boundary.
  double middle_ = 0.0;
  std::vector<Index> facesOfEdge_;
  Index firstFace_ = 0;
  std::vector<Fan> fans_;
};

}

#endif
