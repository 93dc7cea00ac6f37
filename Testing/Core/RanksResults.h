// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_RanksResults_h
#define geodesictest_RanksResults_h

#include "RanksSupport.h"

#include "refinement/RefinedMesh.h"

#include <vector>

namespace geodesictest
{

/// A surface with sources, and what is asked about it.
struct Scene
{
  PlainMesh mesh;
  std::vector<Polyline> curves;
  /// Points whose nearest source and whose path are asked for.
  std::vector<MeshPoint> queries;
  /// Of the front.
  double maximumDistance = geodesic::Infinity;
  double relativeError = 0.0;
  /// Of isolines, ascending.
  std::vector<double> values;
  double chordTolerance = 0.0;
  bool keepsAllWindows = false;
  /// Of the refinement.
  double tolerance = 0.0;
  std::uint64_t maximumFaces = 0;
  /// In which order ranks arrive at a step, as in MemoryRanks, and whether each has threads.
  std::uint64_t disorder = 0;
  bool hasThreads = false;
};

/// The nearest source of a point.
struct Nearest
{
  bool isKnown = false;
  Index curve = 0;
  bool isRight = false;
  /// Of the foot, in the whole mesh and in space.
  MeshPoint foot;
  Vec3 place = {};
  geodesic::Vec3 gradient = {};
};

/// A line of equal distance.
struct PlainLine
{
  std::size_t value;
  std::vector<Vec3> places;
  /// The places as points of the whole mesh.
  std::vector<MeshPoint> points;
};

/// The refined parts of all ranks, put together. Points of two ranks are one if they are on the
/// same edge and have the same place along it, the same coordinates and the same distance, to the
/// last bit: where any of these differ, the surface comes apart.
struct Joined
{
  std::vector<double> vertexDistances;
  geodesic::RefinedMesh refined;
  double relativeErrorBound = 0.0;
  /// The faces that ranks were told of by their owners, and the points that several ranks share.
  std::size_t toldFaces = 0;
  std::size_t sharedPoints = 0;
};

/// \name What the ranks find together
/// In the whole mesh's numbers. Where several ranks answer, their answers are checked to be the
/// same to the last bit. On a mesh that is not cut, this is what one process finds.
///@{
/// The distances at the vertices, infinite at those that no face has.
struct FieldOnRanks
{
  std::vector<double> distances;
  double relativeErrorBound = 0.0;
  std::uint64_t windowsPropagated = 0;
};
FieldOnRanks fieldOnRanks(const CutMesh& cut, const Scene& scene);
/// For the vertices, then for the queries. At vertices a field without windows is asked, too.
std::vector<Nearest> nearestOnRanks(const CutMesh& cut, const Scene& scene);
std::vector<FoundPath> pathsOnRanks(const CutMesh& cut, const Scene& scene);
/// Searches the paths as those that tracing has lost; each is found by its target's rank only.
///
/// \param distances of the queries.
std::vector<FoundPath> pathsInStrips(
  const CutMesh& cut, const Scene& scene, const std::vector<double>& distances);
/// \param leftOnly draws the parts on the left-hand side of the curves only.
std::vector<PlainLine> linesOnRanks(const CutMesh& cut, const Scene& scene, bool leftOnly);
Joined refineOnRanks(const CutMesh& cut, const Scene& scene);
///@}

/// Checks that the parts are one surface, which is the input's.
void expectFitTogether(const geodesic::TriangleMesh& whole, const Joined& joined);

/// Some values of the interpolant.
struct Samples samplesOf(
  const geodesic::TriangleMesh& whole, const Joined& joined, std::size_t count, Random& random);

}

#endif
