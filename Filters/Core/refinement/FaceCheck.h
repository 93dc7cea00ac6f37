// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceCheck_h
#define geodesic_FaceCheck_h

#include "field/FaceDistance.h"
#include "field/SegmentEnvelope.h"
#include "refinement/RefinedFaces.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace geodesic
{

/// Compares the triangles of a face under refinement with the distance, and certifies a bound of
/// the difference on the whole triangle; the paper considers edges only. Bounds.md explains why the
/// bounds hold. One object serves one face after another and reuses its memory.
class FaceCheck
{
public:
  struct Result
  {
    /// No difference is larger; infinite if the triangle is over the limit.
    double bound;
    /// A difference that does occur.
    double sample;
  };

  /// \param faces must outlive this.
  FaceCheck(const RefinedFaces& faces, double tolerance)
    : faces_(faces)
    , tolerance_(tolerance)
    , distance_(faces.field)
  {
  }

  void enter(const FaceTriangles& face);
  const FaceDistance& distance() const { return this->distance_; }
  /// The deviation along a side between two points of the face.
  Deviation deviationOf(Id a, Id b);
  Result of(const Triangle& corners);
  /// The limit for differences within the face.
  double limitOf(const Triangle& corners) const;
  /// A bound that also triangles over the tolerance have.
  double boundBySize(const Triangle& corners) const;

private:
  /// A triangle of the face's plane with a linear function, given by its values at the corners.
  struct LinearPiece
  {
    std::array<Vec2, 3> corners;
    std::array<double, 3> values;
  };
  /// A part of the triangle that is searched.
  struct Node
  {
    LinearPiece piece;
    Id depth;
    /// For each corner, its row in the table of excesses.
    std::array<std::size_t, 3> row;
  };

  /// By how much the values at the corners of a triangle differ from the distance in the face
  /// there, and the rounding of the largest one.
  struct Difference
  {
    double difference;
    double rounding;
  };

  Difference differenceAt(const Triangle& corners) const;
  double limitFor(const Difference& at) const;
  double belowAtSources(const LinearPiece& piece) const;
  Result above(const LinearPiece& piece, double onEdges, double limit);
  Result search(const LinearPiece& piece, double onEdges, double limit);
  std::size_t addRow(Vec2 p, double value);
  double leastInRow(std::size_t row) const;
  double halve(const Node& node);
  double boundOf(const Node& node, double limit) const;

  const RefinedFaces& faces_;
  double tolerance_;
  FaceDistance distance_;
  const FaceTriangles* face_ = nullptr;
  SegmentEnvelope envelope_;
  /// The deviations along sides inside the face, from the lower point to the higher one.
  std::unordered_map<std::uint64_t, Deviation> inside_;

  // The search in one triangle.
  NearCandidates near_;
  /// Row by row: the excess of each candidate over the function at one point.
  std::vector<double> excess_;
  /// Parts that are yet to be examined.
  std::vector<Node> nodes_;
};

}

#endif
