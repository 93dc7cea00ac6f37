// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceEnvelope_h
#define geodesic_FaceEnvelope_h

#include "field/DistanceField.h"
#include "window/WindowList.h"

#include <array>
#include <vector>

namespace geodesic
{

/// One way in which the distance comes to the points of a face: through a window of one of its
/// halfedges, from a corner, or from a source in the face. Coordinates are those of FaceEnvelope.
///
/// As a function of the point its length is convex and changes by no more than the way, and it is
/// nowhere below the distance: the distance is the least of them.
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

  /// Length of the shortest path to a point of the face: straight where the pencil holds it, bent
  /// at an end of the window elsewhere.
  double distance(Vec2 p) const;
};

/// The largest differences between a distance along a segment and its linear interpolant.
struct Deviation
{
  /// Distance over interpolant, >= 0, and where, as a fraction of the length.
  double above = 0.0;
  double aboveAt = 0.5;
  /// Interpolant over distance, >= 0, and where.
  double below = 0.0;
  double belowAt = 0.5;

  double largest() const { return std::max(this->above, this->below); }
  /// The place of the largest.
  double at() const { return this->above >= this->below ? this->aboveAt : this->belowAt; }
};

/// The largest deviations of a distance, given as windows that cover [0, length], from the line
/// between two values at the ends (paper, section 6.2, with the extremum corrected: a^2 <= 1).
Deviation largestDeviation(
  const std::vector<Window>& envelope, double length, double atBegin, double atEnd);

/// Where an edge is split whose largest deviation is at the fraction t: the table of section 6.2.
double splitPosition(double t);

/// The exact piecewise distance along any segment of a face, from the windows of the face's
/// halfedges, its corners and the sources in it: a segment splits a pencil of rays like an edge
/// does, so that no propagation is needed (paper, section 6). One face suffices for its own edges,
/// too.
///
/// Keeps the data of one face at a time.
class FaceEnvelope
{
public:
  /// \param field with windows kept; must outlive the envelope.
  explicit FaceEnvelope(const DistanceField& field);

  /// Goes to a face whose corners have finite distances.
  void enter(Id face);
  Id face() const { return this->face_; }

  /// A point of the face in the plane that all coordinates here are in: the frame of the face's
  /// longest halfedge.
  Vec2 inPlane(const std::array<double, 3>& barycentricCoordinates) const;

  const std::vector<DistanceCandidate>& candidates() const { return this->candidates_; }

  /// The distance at a point of the face.
  double distance(Vec2 p) const;

  /// The distance along the segment from p to q: windows from x = 0 at p to x = |q - p| that meet,
  /// without gaps, no value below the distance but for rounding. Valid until the next call.
  const std::vector<Window>& along(Vec2 p, Vec2 q);

private:
  void addHalfedge(Id halfedge);
  void addSource(const SourceInFace& source);
  double leastNear(Vec2 p) const;
  bool reaches(double x, double distance) const;
  bool buildAlong(Vec2 p, Vec2 u, double length, bool withBent);
  void addPieces(const DistanceCandidate& c, Vec2 p, Vec2 u, double length, bool withBent);
  void addWindow(const DistanceCandidate& c, Vec2 p, Vec2 u, double length, bool withBent);
  void addSegment(const DistanceCandidate& c, Vec2 p, Vec2 u, double length);
  void addCone(Vec2 apex, double sigma, Vec2 p, Vec2 u, double begin, double end);

  const DistanceField& field_;
  const TriangleMesh& mesh_;
  bool exact_;
  Id face_ = NoId;
  Id frame_ = NoId;
  std::vector<DistanceCandidate> candidates_;
  /// Scratch of along().
  std::vector<const DistanceCandidate*> near_;
  std::vector<double> middle_;
  std::vector<Window> pieces_;
  WindowListBuilder builder_;
  std::vector<Window> envelope_;
};

}

#endif
