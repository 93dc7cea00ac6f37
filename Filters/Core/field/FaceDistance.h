// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceDistance_h
#define geodesic_FaceDistance_h

#include "field/DistanceField.h"
#include "mesh/HalfedgeFrame.h"

#include <vector>

namespace geodesic
{

/// One way in which paths come to the points of a face: through a window of one of its halfedges,
/// from a corner, or from a source in the face. Coordinates are those of FaceDistance.
///
/// The length of the path is a convex function of the point, with a slope of at most 1. It is
/// nowhere below the distance: the distance is the least of all candidates.
struct DistanceCandidate
{
  enum class Kind : std::uint32_t
  {
    /// A circular window; `source` is the unfolded source.
    Circular,
    /// A linear window; `source` is the unit direction of its rays, `sigma` the distance at the
    /// origin.
    Linear,
    /// A corner or a source's point at `source`.
    Cone,
    /// A source's segment from `begin` to `end`.
    Segment
  };

  static DistanceCandidate cone(Vec2 apex, double distance)
  {
    return { Kind::Cone, distance, apex, {}, {}, 0.0, 0.0 };
  }

  Kind kind;
  double sigma;
  Vec2 source;
  /// The ends of the window on its halfedge, the face to the left of the way from begin to end, and
  /// the distances there.
  Vec2 begin;
  Vec2 end;
  double atBegin;
  double atEnd;

  /// Whether its straight paths reach only the points between the rays at the ends of a window.
  bool hasPencil() const { return this->kind == Kind::Circular || this->kind == Kind::Linear; }

  /// The directions of a pencil's rays at both ends of the window, of any length.
  Vec2 rayAtBegin() const
  {
    return this->kind == Kind::Linear ? this->source : this->begin - this->source;
  }
  Vec2 rayAtEnd() const
  {
    return this->kind == Kind::Linear ? this->source : this->end - this->source;
  }

  /// Length of the shortest path to a point of the face: straight if the point lies in the pencil,
  /// otherwise bent at an end of the window.
  double distance(Vec2 p) const;
};

/// The distance in one face, as the least of its candidates. Goes from face to face in the same
/// memory.
///
/// Coordinates are in the face's plane, in the frame of the face's longest halfedge.
class FaceDistance
{
public:
  /// In no face yet.
  ///
  /// \param field with windows kept; must outlive this.
  explicit FaceDistance(const DistanceField& field);
  FaceDistance(const DistanceField& field, Id face)
    : FaceDistance(field)
  {
    this->enter(face);
  }

  /// Goes to a face whose corners have finite distances; nothing to do if it is there already.
  ///
  /// \throws Error if no windows were kept.
  void enter(Id face);
  Id face() const { return this->face_; }

  /// Whether the field is exact. In an approximate field the faces around a point may have
  /// different distances there.
  bool isExact() const { return this->field_.relativeErrorBound() == 0.0; }

  /// A point of the face in the plane.
  Vec2 inPlane(const Barycentric& point) const
  {
    return inHalfedgeFrame(this->mesh_, this->frame_, point);
  }
  /// The coordinates in the face of a point of the plane.
  Barycentric fromPlane(Vec2 p) const { return fromHalfedgeFrame(this->mesh_, this->frame_, p); }

  const std::vector<DistanceCandidate>& candidates() const { return this->candidates_; }
  /// Whether a candidate is a corner at which no shortest path bends. Then others are as short
  /// everywhere, but for rounding. Not close to sources: paths from a point beside a vertex
  /// (NearVertex) come to the faces around it by the vertex alone.
  bool isRegularCorner(std::size_t candidate) const
  {
    const std::size_t k = candidate - this->firstCorner_;
    return k < 3 && this->candidates_[candidate].sigma > this->mesh_.shape(this->face_).longest() &&
      this->mesh_.pseudoSource(this->mesh_.triangle(this->face_)[k]) ==
      TriangleMesh::PseudoSource::None;
  }

  /// The distance at a point of the face.
  double distance(Vec2 p) const;

private:
  void addHalfedge(Id halfedge);

  const DistanceField& field_;
  const TriangleMesh& mesh_;
  Id face_ = NoId;
  Id frame_ = NoId;
  std::vector<DistanceCandidate> candidates_;
  std::size_t firstCorner_ = 0;
};

/// The candidates that may be the least near a point. Slopes are at most 1: a candidate that is
/// longer than the distance there by more than twice the radius is longer within the radius.
class NearCandidates
{
public:
  /// \param value only places where the distance is below the value matter.
  /// \returns the distance in the middle.
  double choose(const FaceDistance& face, Vec2 middle, double radius, double value = Infinity);

  /// The distance at a point within the radius.
  double distance(Vec2 p) const;

  std::size_t size() const { return this->near_.size(); }
  auto begin() const { return this->near_.begin(); }
  auto end() const { return this->near_.end(); }

private:
  std::vector<const DistanceCandidate*> near_;
  std::vector<double> inMiddle_;
};

}

#endif
