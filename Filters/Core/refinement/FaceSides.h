// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceSides_h
#define geodesic_FaceSides_h

#include "field/FaceDistance.h"
#include "refinement/RefinedFaces.h"

#include <array>

namespace geodesic
{

/// A piece of an edge that is a piece of a side of a face.
struct PieceOfEdge
{
  Id edge = NoId;
  Id piece = NoId;
  /// Whether the edge runs against the face's orientation, or from the second of two points to the
  /// first.
  bool isReversed = false;
};

/// The sides of a face under refinement as edges, whose points the face shares with others. One
/// object serves one face after another.
class FaceSides
{
public:
  /// \param faces must outlive this.
  explicit FaceSides(const RefinedFaces& faces)
    : mesh_(faces.field.mesh())
    , edges_(faces.edges)
  {
  }

  void enter(FaceTriangles& face);
  /// Puts the points that are new on the edges into the face.
  ///
  /// \param distance that of the face.
  void takePoints(const FaceDistance& distance);

  /// The piece between two neighbouring points of one side.
  PieceOfEdge pieceBetween(Id a, Id b) const;
  const Deviation& deviationOf(const PieceOfEdge& piece) const
  {
    return this->edges_[piece.edge].pieces[piece.piece];
  }
  /// The piece of a side that is closest to a place.
  PieceOfEdge pieceAt(std::size_t side, Vec2 place) const;

private:
  void takePoints(std::size_t side, const FaceDistance& distance);
  FaceTriangles::Point pointOnEdge(std::size_t side, Id number, const FaceDistance& distance) const;
  double alongEdge(std::size_t side, Id point) const;
  bool isReversed(std::size_t side) const;

  const TriangleMesh& mesh_;
  const CutEdges& edges_;
  FaceTriangles* face_ = nullptr;
  std::array<Id, 3> edgeOfSide_{};
};

}

#endif
