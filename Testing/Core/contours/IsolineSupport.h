// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_IsolineSupport_h
#define geodesictest_IsolineSupport_h

#include "EngineSupport.h"

#include "contours/Isolines.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

/// Shared by the tests of isolines.
namespace geodesictest
{

/// A point of the surface in the tests' own terms. Faces must have kept their numbers.
MeshPoint testPoint(const geodesic::TriangleMesh& mesh, const geodesic::SurfacePoint& point);

/// Solves for the values and draws them.
geodesic::Isolines isolinesOf(const geodesic::TriangleMesh& mesh,
  const std::vector<geodesic::SourceCurve>& curves, const std::vector<double>& values,
  double chordTolerance);

/// Ascending values to draw: one in each of equal parts of the range up to a little over the
/// largest distance, and the distance of a vertex.
std::vector<double> randomValues(const std::vector<double>& distances, double largest,
  const std::vector<double>& leastShares, Random& random);

/// The side of a flat rectangle where a coordinate is zero.
geodesic::SourceCurve sideOf(const geodesic::TriangleMesh& mesh, std::size_t axis);

/// The length of a line, chord by chord.
double lengthOf(
  const geodesic::TriangleMesh& mesh, const geodesic::Isolines& isolines, std::size_t line);

/// Checks that the chords of all lines lie in the faces that they name, and have a length.
void expectChordsInFaces(const geodesic::TriangleMesh& mesh, const geodesic::Isolines& isolines);

/// Checks that the distance grows to the left of every chord: by the field, a short step to the
/// left has a larger distance and one to the right a smaller distance.
void expectGrowthToTheLeft(
  const geodesic::DistanceField& field, const geodesic::Isolines& isolines);

/// The number of lines of one value.
struct LineCount
{
  std::size_t open = 0;
  std::size_t closed = 0;
};
inline bool operator==(const LineCount& a, const LineCount& b)
{
  return a.open == b.open && a.closed == b.closed;
}

LineCount countLines(const geodesic::Isolines& isolines, std::size_t value);

/// The lines of equal distance on a surface, counted by the brute-force solver: in small triangles
/// around them, which are cut in four again and again. Slopes are at most 1, so that the others are
/// certainly below or above the value.
class LevelTruth
{
public:
  LevelTruth(const PlainMesh& mesh, const Sources& sources, double value);

  /// Cuts the triangles that may hold the value in four.
  void refine();

  std::size_t size() const { return this->cells_.size(); }

  /// The lines where triangles tell: each band of them has one region below and one above beside
  /// it, or no corner on one side. Lines around a region that holds no corner are not seen. Lines
  /// end at edges with one face, or more than two. Where lines meet or vanish at a vertex that is
  /// at the value, there is no number.
  std::optional<LineCount> count() const;

private:
  /// A triangle in a face whose edges have `parts_` parts: corners (i, j), (i + 1, j), (i, j + 1),
  /// or those opposite to them in the parallelogram.
  struct Cell
  {
    Index face;
    Index i;
    Index j;
    bool isTurned;
  };
  using Node = std::array<Index, 3>;
  struct CellMesh;

  std::array<std::array<Index, 2>, 3> corners(const Cell& cell) const;
  std::array<Index, 3> steps(Index i, Index j) const { return { this->parts_ - i - j, i, j }; }
  MeshPoint place(const Cell& cell) const;
  double sizeOf(Index face) const;
  CellMesh cellMesh() const;
  Node nameOf(Index face, const std::array<Index, 3>& steps) const;

  const PlainMesh& mesh_;
  const Sources& sources_;
  double value_;
  Index parts_ = 1;
  std::vector<Cell> cells_;
  /// The number of faces at each edge of the mesh.
  std::map<std::pair<Index, Index>, std::size_t> facesAt_;
};

}

#endif
