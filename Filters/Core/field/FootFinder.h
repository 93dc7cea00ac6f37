// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FootFinder_h
#define geodesic_FootFinder_h

#include "field/IncomingSegment.h"
#include "source/CurvesOnPatch.h"
#include "source/FanAround.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace geodesic
{

/// Where on the source a shortest path ends, and from which side of the curve it comes.
struct Foot
{
  /// Number of the curve among those of the field; NoId where a point was not reached.
  Id curve = NoId;
  /// Whether the path comes from the curve's right-hand side, seen along the curve with the face's
  /// normal towards the viewer. Behind an open end, a border in the middle separates the sides. A
  /// source that is a point has a left-hand side only. For points on the curve the side is
  /// arbitrary.
  bool isRight = false;
  /// The chain that contains the curve, and the parameter there: the length from its beginning.
  Id chain = NoId;
  double parameter = 0.0;
  /// How the path leaves the curve.
  enum class Direction : std::uint8_t
  {
    /// The path has no length, or the field no angles.
    None,
    /// At a right angle to a segment.
    AcrossSegment,
    /// From a point of the curve, at the angle `angleInFan`.
    AroundPoint
  };
  Direction direction = Direction::None;
  /// Around the point, not scaled (FanAround::angleOf()).
  double angleInFan = 0.0;

  bool isKnown() const { return this->curve != NoId; }
};

/// Where on the source a path begins: on a side of a curve, or at a curve's point, where the start
/// is the path's own angle (Foot::angleInFan). While ranks ask each other, the origin may also be a
/// vertex that another rank counts, and is open.
struct PathOrigin
{
  RayOrigin origin = {};
  /// Whether the path's direction at a curve's point is known.
  bool hasAngle = false;
  RayStart start = {};
};

/// Finds the foot of a path from the path's straight piece that begins on the source.
class FootFinder
{
public:
  /// \param field on the surface of the pieces; must outlive this.
  /// \param patch that the curves lie on; in one process the field's mesh.
  /// \param curves those that the field was solved for.
  FootFinder(const DistanceField& field, const ReplicatedPatch& patch,
    const std::vector<SourceCurve>& curves);

  /// The mesh that curves and feet lie on: that of the patch.
  const TriangleMesh& meshOfCurves() const { return this->curves_.mesh(); }
  const CurvesOnPatch& curvesOnPatch() const { return this->curves_; }

  /// The foot of a path that ends on the source. Not thread-safe.
  ///
  /// \param face that holds the last point and the point before.
  /// \param ray the straight piece that has led to the end. Its window knows the foot best. But
  ///        among sources at one distance it may come from another one than the path has reached;
  ///        then the last two points tell the foot.
  /// \param length of the path.
  Foot footAt(const SurfacePoint& last, const SurfacePoint& before, Id face,
    const IncomingSegment& ray, double length);

  /// A foot's place on the surface, a point of meshOfCurves().
  SurfacePoint pointOf(const Foot& foot) const;

  /// The length along the foot's curve from the curve's first point to pointOf(); 0 for a point.
  double arcLengthOf(const Foot& foot) const
  {
    return this->curves_.chains().arcLength(foot.curve, foot.parameter);
  }
  /// The arc length of each point of a curve, bit by bit that of a foot there. The last point of a
  /// closed curve has the whole length.
  std::vector<double> arcLengthsOf(Id curve) const;

  /// The direction in which the shortest path leaves the source, as an angle in radians.
  ///
  /// From a source that is a single point, as seen with the face's normal towards the viewer:
  /// - inside a face: counterclockwise from the face's first edge (corner 0 to 1), in (-pi, pi];
  /// - on an edge: the same in the first of the edge's faces in the order of the input, continued
  ///   over the edge by unfolding;
  /// - at a vertex whose faces form one closed fan: the angle around it, scaled so that the total
  ///   is 2 pi, from the edge that leaves the vertex in the first of its faces in the order of the
  ///   input, in (-pi, pi];
  /// - at any other vertex: from the edge where the fan begins, from 0 to the fan's total, not
  ///   scaled; several fans follow one another in the order of their first faces.
  ///
  /// From a curve, counterclockwise from its direction: pi / 2 on the left-hand side and -pi / 2 on
  /// the right-hand side of a segment. Around a point of the curve, the forward segment has the
  /// angle 0, the backward one -pi and pi, and each sector between them is scaled to pi; at an end
  /// of the curve the whole angle is scaled to 2 pi. On the boundary, and between different curves
  /// that meet in the point, angles are not scaled, but measured from the nearer segment. A fan
  /// without a segment has the angles of a single point.
  ///
  /// Behind a pseudo-source it is the angle of the path to the pseudo-source. On the source itself
  /// it has no meaning.
  ///
  /// Not thread-safe.
  ///
  /// \throws Error if the field's windows carry no angles (FrontOptions::keepAngles).
  double angleOf(const Foot& foot);
  /// The x axis of a single point's frame has the angle 0 in angleOf(). A curve's frame is that of
  /// its first segment: x along the segment, y to the left.
  SourceFrame frameOf(Id curve) const { return this->curves_.frameOf(curve); }

protected:
  const DistanceField& field() const { return this->field_; }
  /// Where on the source a piece begins; the vertex, open, if the piece begins at a pseudo-source.
  /// Not thread-safe.
  PathOrigin originOf(const IncomingSegment& piece);
  /// The foot of a path with this origin; not known if the origin is open.
  Foot footOf(const PathOrigin& path) const;
  const VertexOnCurve* onCurveAt(GlobalId id) const;

private:
  PathOrigin originAt(const SurfacePoint& last, const SurfacePoint& before, Id face);
  Id faceOfCurves(Id face) const;
  PathOrigin atSource(const IncomingSegment& piece);
  PathOrigin inFanAt(Id point, const IncomingSegment& piece);
  const FanAround& fanAt(Id point);

  const DistanceField& field_;
  /// The origins of windows have the numbers of these curves' chains.
  CurvesOnPatch curves_;
  /// Around the curve's point that was asked for last, and its number among the chains' points.
  std::optional<FanAround> fan_;
  Id fanPoint_ = NoId;
};

}

#endif
