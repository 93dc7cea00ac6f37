// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceDistance_h
#define geodesic_FaceDistance_h

#include "field/DistanceField.h"
#include "mesh/HalfedgeFrame.h"

#include <array>
#include <optional>
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

  /// Length of the shortest path to a point of the face: straight if the point lies in the pencil,
  /// otherwise bent at an end of the window.
  double distance(Vec2 p) const;
};

/// The distance in one face, as the least of its candidates.
///
/// Coordinates are those of one plane that holds the face, the frame of its longest halfedge.
class FaceDistance
{
public:
  /// \param field with windows kept; must outlive this.
  /// \param face one whose corners have finite distances.
  /// \param memory for the candidates: that of another face, see releaseMemory().
  /// \throws Error if no windows were kept.
  FaceDistance(const DistanceField& field, Id face, std::vector<DistanceCandidate> memory = {});

  Id face() const { return this->face_; }

  /// Whether the field is exact. In an approximate field the faces around a point may have
  /// different distances there.
  bool isExact() const { return this->exact_; }

  /// A point of the face in the plane.
  Vec2 inPlane(const Barycentric& point) const
  {
    return inHalfedgeFrame(*this->mesh_, this->frame_, point);
  }
  /// The coordinates in the face of a point of the plane.
  Barycentric fromPlane(Vec2 p) const { return fromHalfedgeFrame(*this->mesh_, this->frame_, p); }

  const std::vector<DistanceCandidate>& candidates() const { return this->candidates_; }
  /// Whether a candidate is a corner at which no shortest path bends. Then others are as short
  /// everywhere, but for rounding. Not close to sources: paths from a point beside a vertex
  /// (NearVertex) come to the faces around it by the vertex alone.
  bool isRegularCorner(std::size_t candidate) const
  {
    const std::size_t k = candidate - this->firstCorner_;
    return k < 3 &&
      this->candidates_[candidate].sigma > this->mesh_->shape(this->face_).longest() &&
      this->mesh_->pseudoSource(this->mesh_->triangle(this->face_)[k]) ==
      TriangleMesh::PseudoSource::None;
  }
  std::vector<DistanceCandidate> releaseMemory() { return std::move(this->candidates_); }

  /// The distance at a point of the face.
  double distance(Vec2 p) const;

private:
  void addHalfedge(const DistanceField& field, Id halfedge);

  const TriangleMesh* mesh_;
  bool exact_;
  Id face_;
  Id frame_;
  std::vector<DistanceCandidate> candidates_;
  std::size_t firstCorner_;
};

/// Goes from one face to the next, in the same memory; the distance in the last face stays.
///
/// \param distance that in the last face, always of this field.
const FaceDistance& enterFace(
  std::optional<FaceDistance>& distance, const DistanceField& field, Id face);

}

#endif
