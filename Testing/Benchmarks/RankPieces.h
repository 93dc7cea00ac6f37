// SPDX-License-Identifier: BSD-3-Clause
#ifndef RankPieces_h
#define RankPieces_h

#include "Types.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;

/// What one rank has of a mesh.
struct RankPiece
{
  std::vector<geodesic::Vec3> points;
  std::vector<geodesic::Triangle> triangles;
  /// The whole mesh's number of each point.
  std::vector<std::uint64_t> keys;
};

/// A source by the whole mesh's points: its boundary, one of them, or a path along edges.
struct RankSource
{
  bool isBoundary = false;
  std::vector<std::uint64_t> points;
};

/// Cuts a mesh of triangles into pieces of as many faces each, along a space-filling curve (Morton
/// 1966), so that pieces are compact.
std::vector<RankPiece> cutIntoPieces(vtkPolyData* mesh, int numberOfPieces);

/// \name Pieces in files, as PREFIX_0.piece, ..., with the source in each.
/// \throws std::runtime_error with what is wrong.
///@{
void writePiece(
  const std::string& prefix, int number, const RankPiece& piece, const RankSource& source);
void readPiece(const std::string& prefix, int number, RankPiece& piece, RankSource& source);
///@}

#endif
