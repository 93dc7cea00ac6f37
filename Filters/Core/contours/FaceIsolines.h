// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceIsolines_h
#define geodesic_FaceIsolines_h

#include "contours/LevelArrangement.h"

#include <vector>

namespace geodesic
{

/// A point where an isoline crosses the outline of a face.
struct OutlinePoint
{
  Vec2 at;
  Id id;
  /// Whether the line leaves there, run through so that the distance grows to its left.
  bool leaves;
};

/// The pieces of isolines in some faces. Points have ids: the caller gives those of the outlines,
/// from 0 on, and drawInFace() gives higher ones to new points.
struct IsolinePieces
{
  struct Piece
  {
    Id face;
    /// Which of the values.
    Id value;
    /// The end of its points in `ids`, which begin where the piece before ends. A closed piece has
    /// its first point again at the end.
    std::size_t end;
  };

  std::vector<Piece> pieces;
  std::vector<Id> ids;
  std::vector<SurfacePoint> points;
};

/// What the drawing of several faces shares.
struct IsolineTask
{
  const TriangleMesh& mesh;
  /// The id of the first point inside a face.
  Id firstNewId;
  /// The largest distance of a chord from its arc.
  double chordTolerance;
  /// Looked at often, as faces may have very many windows.
  const Job& job;
  LevelArrangement arrangement;
  IsolinePieces result;
};

/// Draws the isoline of one value in a face: the remainders of its level curves (LevelArrangement),
/// joined where one ends and another begins, and to the points of the face's outline. If some ends
/// do not meet, rounding has decided something; should they meet in no way, the lines go straight
/// through the face.
///
/// \param level the value, see tolerance::BelowValue.
/// \param valueId goes into the pieces.
/// \param outline the points of the isoline on the face's edges, with the face to the left from
///        corner 0 on; entries and exits alternate.
/// \param below whether corner 0 is below the level.
/// \throws Aborted
void drawInFace(const FaceDistance& face, double level, Id valueId,
  const std::vector<OutlinePoint>& outline, bool below, IsolineTask& task);

}

#endif
