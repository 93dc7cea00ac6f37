// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_IsolineSupport_h
#define geodesictest_IsolineSupport_h

#include "EngineSupport.h"

#include "contours/Isolines.h"

#include <array>
#include <cstddef>
#include <map>
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

/// Distances at the points of a grid in every face, from the brute-force solver, and the topology
/// of the sublevel sets of their linear interpolant.
class GridTruth
{
public:
  /// \param cells the number of parts of each edge.
  GridTruth(const PlainMesh& mesh, const Sources& sources, Index cells);

  /// The longest edge of the grid.
  double spacing() const { return this->spacing_; }

  /// The lines of equal interpolated distance. They end at edges with one grid face, or more than
  /// two.
  LineCount countLines(double value) const;

private:
  Index nodeAt(Index face, Index i, Index j);

  const PlainMesh& mesh_;
  Index cells_;
  double spacing_ = 0.0;
  std::vector<Triangle> triangles_;
  std::vector<MeshPoint> places_;
  std::vector<double> distances_;
  std::map<std::array<Index, 3>, Index> nodes_;
};

}

#endif
