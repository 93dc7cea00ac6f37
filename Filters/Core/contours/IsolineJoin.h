// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_IsolineJoin_h
#define geodesic_IsolineJoin_h

#include "contours/FaceIsolines.h"
#include "contours/Isolines.h"

#include <vector>

namespace geodesic
{

/// Joins the pieces of isolines where exactly two of them meet, whatever faces they are in.
class IsolineJoin
{
public:
  /// \param levels the values, must outlive this.
  /// \param onEdges the points on edges; their ids are the first ones.
  IsolineJoin(
    const TriangleMesh& mesh, const std::vector<double>& levels, std::vector<SurfacePoint> onEdges)
    : mesh_(mesh)
    , levels_(levels)
    , edgePoints_(static_cast<Id>(onEdges.size()))
    , points_(std::move(onEdges))
  {
  }

  /// Lines end at this point on an edge: there the lines of other ranks continue. Points ascend.
  void endAt(Id edgePoint) { this->ends_.push_back(edgePoint); }

  /// Adds the pieces of some faces, behind those of lower ones.
  void add(const IsolinePieces& pieces);

  /// Returns the lines, without chords of hardly any length.
  Isolines finish();

private:
  /// The first or the last point of a piece: 2 * piece, or 2 * piece + 1.
  using PieceEnd = Id;
  struct Node
  {
    PieceEnd ends[2] = { NoId, NoId };
    Id count = 0;
  };

  std::size_t firstOf(Id piece) const { return piece == 0 ? 0 : this->pieces_[piece - 1].end; }
  Id pointAt(PieceEnd end) const;
  void linkEnds();
  bool isThrough(PieceEnd end) const { return this->nodes_[this->pointAt(end)].count == 2; }
  PieceEnd other(PieceEnd end) const;
  void follow(PieceEnd begin, Isolines& result);
  void addPiece(PieceEnd begin, Isoline& line) const;
  bool shorten(Isoline& line) const;
  bool isShort(const SurfacePoint& a, const SurfacePoint& b, Id face, double level) const;
  bool isSpeck(const Isoline& line) const;
  bool isRoundOnePlace(const Isoline& line, double gap) const;
  void takeUsedPoints(Isolines& result) const;

  const TriangleMesh& mesh_;
  const std::vector<double>& levels_;
  Id edgePoints_;
  std::vector<Id> ends_;
  std::vector<IsolinePieces::Piece> pieces_;
  std::vector<Id> ids_;
  std::vector<SurfacePoint> points_;
  std::size_t partsCrossedStraight_ = 0;
  std::vector<Node> nodes_;
  std::vector<std::uint8_t> isUsed_;
};

}

#endif
