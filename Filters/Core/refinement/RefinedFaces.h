// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinedFaces_h
#define geodesic_RefinedFaces_h

#include "field/FaceDistance.h"
#include "refinement/CutEdges.h"
#include "refinement/FaceTriangles.h"
#include "refinement/SourceRegions.h"

#include <array>
#include <cstdint>
#include <vector>

namespace geodesic
{

/// A piece of an edge that is a piece of a side of a face.
struct PieceOfEdge
{
  Id edge = NoId;
  Id piece = NoId;
  /// Whether the edge runs against the face's orientation.
  bool isReversed = false;
};

/// The faces of this rank under refinement. Each is triangulated by itself between the points on
/// its edges, which it shares with the faces around them.
class RefinedFaces
{
public:
  /// All ranks construct this together.
  ///
  /// \param refined must outlive this.
  explicit RefinedFaces(const DistanceField& refined, const Job& job = {});

  const DistanceField& field;
  CutEdges edges;

  /// Whether the owner of a face refines it: it is not covered, and the field knows all of it.
  bool isRefined(Id face) const { return this->isRefined_[face] != 0; }
  /// Whether this rank does not refine a face.
  bool isFrozen(Id face) const
  {
    return !this->isRefined(face) || !this->field.surface().isOwn(face);
  }
  /// Begins the triangulation of a face; its edges get numbers.
  void open(Id face);
  bool isOpen(Id face) const { return this->ofFace_[face] != NoId; }
  FaceTriangles& triangles(Id face) { return this->open_[this->ofFace_[face]]; }
  const FaceTriangles& triangles(Id face) const { return this->open_[this->ofFace_[face]]; }
  std::vector<FaceTriangles>& openFaces() { return this->open_; }

  /// Puts the points that are new on the edge at a face's side into the face.
  void takePoints(FaceTriangles& face, std::size_t side, const FaceDistance& distance) const;
  /// The piece at a fraction of the way along a side of a face.
  PieceOfEdge pieceAt(const FaceTriangles& face, std::size_t side, double way) const
  {
    const auto [edge, isReversed] = face.side(side);
    return { edge, this->edges.pieceAt(edge, isReversed ? 1.0 - way : way), isReversed };
  }
  /// The piece between two neighbouring points of one side of a face.
  PieceOfEdge pieceBetween(const FaceTriangles& face, Id a, Id b) const
  {
    const std::size_t side = face.sideWith(a, b);
    return this->pieceAt(face, side, 0.5 * (face.wayAlong(side, a) + face.wayAlong(side, b)));
  }

  /// The longest side of a triangle that must be split, as there is a border of regions between its
  /// corners; else 0.
  ///
  /// \param corners points of the open face; in another face, points on its edges.
  /// \param tolerance triangles without longer sides are not split.
  double lengthAtBorder(
    Id face, const Triangle& corners, SourceRegions& regions, double tolerance) const;

private:
  FaceTriangles::Point pointOnEdge(std::size_t side, Id number, const FaceDistance& distance) const;

  /// For each face its number among the open ones; NoId where none is needed.
  std::vector<Id> ofFace_;
  std::vector<std::uint8_t> isRefined_;
  std::vector<FaceTriangles> open_;
};

}

#endif
