// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_InterpolationError_h
#define geodesic_InterpolationError_h

#include "field/FaceEnvelope.h"

#include <array>
#include <vector>

namespace geodesic
{

/// A triangle of the plane with a linear function given at its corners.
struct LinearPiece
{
  std::array<Vec2, 3> corners;
  std::array<double, 3> values;
};

/// Bounds over a whole input face: how far the distance is over the linear interpolant of its
/// corners, and how far under it.
struct FaceBounds
{
  double above = Infinity;
  double below = Infinity;
};

/// Such bounds from the windows of the face's halfedges as they are, no source being in the face and
/// `d` being the distances at its corners. Infinite where one would be over the limit, which says
/// nothing.
FaceBounds boundsOfFace(const TriangleMesh& mesh, Id face, const std::array<double, 3>& d,
  const std::array<WindowRuns, 3>& windows, double limit);

/// Whether the distances of a list stay near the linear interpolant along its halfedge.
struct NearLine
{
  /// No window is farther below it.
  bool below = false;
  /// The windows cover the halfedge, and none is farther above it.
  bool above = false;
};

/// \param limit how near. Told without square roots, for windows that are at hand: where it is not
///        told it may be so nevertheless.
NearLine nearLine(
  const WindowRange& windows, double length, double atOrigin, double atDestination, double limit);

/// Bounds for a face no list of which comes from farther below than the limit; `above` tells which
/// of its halfedges have a list that covers them and is not farther above. Infinite where that says
/// nothing.
FaceBounds boundsNearLines(const TriangleMesh& mesh, Id face, const std::array<double, 3>& d,
  const std::array<bool, 3>& above, double limit);

/// How far the distance through windows of one halfedge can be under the interpolant, anywhere in the
/// face.
double belowThroughHalfedge(
  const TriangleMesh& mesh, Id halfedge, const std::array<double, 3>& d, const WindowRuns& windows);

/// Certified bounds of |distance - linear interpolant| on whole triangles, beyond the paper, which
/// looks at edges only. How, and why they hold, is told in the source.
///
/// Bounds are up to the rounding of distances.
class InterpolationError
{
public:
  explicit InterpolationError(const DistanceField& field);

  /// A quick bound for an input face and the distances at its corners, from its windows as they
  /// are; Infinity where it would be over the limit, which says nothing. Not looked for when a face
  /// of this size cannot have more than `known`.
  double ofFace(Id face, double limit, double known) const;

  /// What is known about the inside of a triangle.
  struct Inside
  {
    /// No difference is larger.
    double bound;
    /// Such a difference occurs.
    double sample;
  };

  /// The differences inside a triangle, those on its edges being given.
  ///
  /// \param envelope in the face that holds the triangle.
  /// \param onEdges largest deviations on the edges.
  /// \param limit the search for a bound ends when it is not over the limit, or a sample is.
  /// \param tight go on until the bound is near the sample.
  Inside ofTriangle(const FaceEnvelope& envelope, const LinearPiece& piece,
    const Deviation& onEdges, double limit, bool tight = false);

private:
  struct Node
  {
    LinearPiece piece;
    Id depth;
    /// For each corner, its row in the table of excesses.
    std::array<std::size_t, 3> row;
  };

  double belowAtSources(const FaceEnvelope& envelope, const LinearPiece& piece) const;
  Inside search(const FaceEnvelope& envelope, const LinearPiece& piece, double limit, bool tight);
  void chooseNear(const FaceEnvelope& envelope, const LinearPiece& piece);
  std::size_t addRow(Vec2 p, double value);
  double leastInRow(std::size_t row) const;
  double boundOf(const Node& node, double limit);

  const DistanceField& field_;
  const TriangleMesh& mesh_;
  std::vector<const DistanceCandidate*> near_;
  /// Row by row: how far each candidate is over the interpolant at one point.
  std::vector<double> excess_;
  std::vector<Node> nodes_;
};

}

#endif
