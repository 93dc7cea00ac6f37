// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_EngineSupport_h
#define geodesictest_EngineSupport_h

#include "EdgesOfMesh.h"
#include "Seeds.h"
#include "truth/BruteForce.h"
#include "truth/RandomCurves.h"
#include "truth/RandomMeshKinds.h"
#include "truth/TestMeshes.h"

#include "field/DistanceField.h"
#include "field/NearestSource.h"
#include "mesh/SurfacePoint.h"
#include "mesh/TriangleMesh.h"
#include "paths/JoinPoints.h"
#include "paths/PathsToSource.h"
#include "source/PolylineOnSurface.h"
#include "source/SourceCurve.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// Converts the tests' plain data for the engine; helpers that tests of the engine share.
namespace geodesictest
{

/// The engine's accuracy on any mesh, relative to the largest distance.
constexpr double EngineAccuracy = 1e-9;

/// The accuracy if no face is much longer than high. Two paths to a vertex whose lengths differ by
/// 64 roundings of the distance are one to the engine, and the windows that the vertex has already
/// emitted stay; behind it they may miss a gap of an angle of 1e-7. The worst of 130,000 fields
/// around vertices, points and segments was off by 4e-13; most are off by a few roundings.
constexpr double OrdinaryAccuracy = 2e-12;

/// The accuracy on a kind of mesh. On needles a rounding of the long edges is larger relative to
/// the short way across: the worst of 7,000 fields was off by 8e-11, with aspects of 1e4 to 1e5 by
/// 1.4e-10.
double accuracyOn(const MeshKind& kind);

geodesic::TriangleMesh engineMesh(const PlainMesh& mesh);

/// Calls test(mesh, other, how) for a mesh of each kind, and for the same mesh with vertices, faces
/// and corners in another order. On ranks faces are in another order than in one process.
template <typename Test>
void forMeshesInAnotherOrder(const Test& test)
{
  for (const MeshKind& kind : meshKinds())
  {
    SCOPED_TRACE(kind.name);
    Random random(1);
    const PlainMesh mesh = kind.make(randomSize(random), random);
    const Renumbered other = renumbered(mesh, random);
    test(engineMesh(mesh), engineMesh(other.mesh), other);
  }
}

/// The number of faces without area (geodesic::isWithoutArea).
std::size_t facesWithoutArea(const PlainMesh& mesh);

/// A surface without its faces without area, as the engine gets it.
struct CleanedMesh
{
  /// On the surface's points; added ones follow.
  PlainMesh mesh;
  /// The triangle that each one was cut from.
  std::vector<Index> triangles;
  /// The vertex that each point has become.
  std::vector<Index> vertexOf;
};
CleanedMesh withoutFlatFaces(const PlainMesh& mesh);
/// The same on the meshes' own points, which no needle joins.
geodesic::TriangleMesh cleanedEngineMesh(const PlainMesh& mesh);

/// Sets the faces of polylines.
void locate(const geodesic::TriangleMesh& mesh, std::vector<geodesic::LocatedPolyline>& polylines,
  double coordinatePrecision = std::numeric_limits<double>::epsilon());

/// Puts polylines onto the surface, as double precision places them.
std::vector<geodesic::SourceCurve> curvesOnto(
  const geodesic::TriangleMesh& mesh, std::vector<geodesic::LocatedPolyline> polylines);

/// Requires a mesh from which the engine leaves out no face, so that faces keep their numbers.
geodesic::SurfacePoint enginePoint(const geodesic::TriangleMesh& mesh, const MeshPoint& point);
geodesic::SourceCurve engineCurve(const geodesic::TriangleMesh& mesh, const Polyline& curve);
std::vector<geodesic::SourceCurve> engineCurves(
  const geodesic::TriangleMesh& mesh, const std::vector<Polyline>& curves);
std::vector<geodesic::SourceCurve> engineCurves(
  const geodesic::TriangleMesh& mesh, const Sources& sources);

/// The boundary's edges.
Sources boundarySources(const geodesic::TriangleMesh& mesh);

/// Solves with all windows kept.
geodesic::DistanceField solveKeepingAll(const geodesic::TriangleMesh& mesh,
  const std::vector<geodesic::SourceCurve>& curves, double relativeError = 0.0,
  double maximumDistance = geodesic::Infinity, double maximumMerged = geodesic::Infinity);
/// Solve in one process for drawIsolines() and refine(), with few windows kept.
geodesic::DistanceField solveForIsolines(const geodesic::TriangleMesh& mesh,
  const std::vector<geodesic::SourceCurve>& curves, const std::vector<double>& values,
  const geodesic::FrontOptions& options = {});
geodesic::DistanceField solveForRefinement(const geodesic::TriangleMesh& mesh,
  const std::vector<geodesic::SourceCurve>& curves, double tolerance,
  const geodesic::FrontOptions& options = {});
/// The same on one of several ranks.
geodesic::DistanceField solveForRefinement(const geodesic::MeshPartition& part,
  const geodesic::SourceWindows& sources, double tolerance,
  const geodesic::FrontOptions& options = {});

/// Distances computed by the engine, in the brute force's format.
struct EngineResult
{
  std::vector<double> vertices;
  std::vector<double> queries;
};

/// The values of a field with all windows kept, at the vertices and the queries.
EngineResult valuesOf(const geodesic::DistanceField& field, const std::vector<MeshPoint>& queries);

/// Solves with all windows kept, evaluates the queries, and checks that a solve without windows
/// gives the same values at vertices.
EngineResult engineDistances(const PlainMesh& mesh,
  const std::vector<geodesic::SourceCurve>& curves, const geodesic::TriangleMesh& engine,
  const std::vector<MeshPoint>& queries);
EngineResult engineDistances(const PlainMesh& mesh, const std::vector<Polyline>& curves,
  const std::vector<MeshPoint>& queries = {});
EngineResult engineDistances(
  const PlainMesh& mesh, const Sources& sources, const std::vector<MeshPoint>& queries = {});

/// The largest finite value.
double largestFinite(const std::vector<double>& values);

/// The largest error relative to `largest`; infinity if one value is infinite or NaN and the other
/// is not.
double worstError(
  const std::vector<double>& computed, const std::vector<double>& truth, double largest);

/// Checks what an approximate field certifies: it is nowhere above the exact distance, and nowhere
/// below it by more than the field's bound; the allowance for rounding is that of the exact field.
/// \returns the largest relative error among distances for which rounding is negligible.
///
/// \param accuracy of the exact field, relative to the largest distance.
double expectCertified(const geodesic::DistanceField& field, const std::vector<MeshPoint>& queries,
  const EngineResult& exact, double accuracy = OrdinaryAccuracy);

/// Random query points of all kinds.
std::vector<MeshPoint> randomPoints(const PlainMesh& mesh, std::size_t count, Random& random);

/// A random mesh with random sources, and the true distances at the vertices and the queries.
struct RandomCase
{
  PlainMesh mesh;
  std::vector<Polyline> curves;
  std::vector<MeshPoint> queries;
  BruteForceResult truth;
};
/// \param mostFaces makes large meshes smaller.
RandomCase randomCase(const MeshKind& kind, std::uint64_t seed, std::size_t numberOfQueries,
  Index mostFaces = std::numeric_limits<Index>::max());

/// The random numbers of each seed of a test, one seed after the other; failures name the seed.
///
///   for (Random& random : EachSeed(100)) { ... }
class EachSeed
{
public:
  /// \param salt is added to the seeds, so that tests differ.
  explicit EachSeed(std::uint64_t count, std::uint64_t salt = 0)
    : seeds_(seedsOfTest(count))
    , salt_(salt)
  {
  }

  class Iterator
  {
  public:
    Iterator(std::uint64_t seed, const EachSeed& range)
      : seed_(seed)
      , range_(range)
    {
    }
    Random& operator*()
    {
      this->trace_.emplace(__FILE__, __LINE__, "seed " + std::to_string(this->seed_));
      this->random_ = Random(this->seed_ + this->range_.salt_);
      return this->random_;
    }
    void operator++()
    {
      this->trace_.reset();
      ++this->seed_;
    }
    bool operator!=(const Iterator& other) const { return this->seed_ != other.seed_; }

  private:
    std::uint64_t seed_;
    const EachSeed& range_;
    Random random_{ 0 };
    std::optional<testing::ScopedTrace> trace_;
  };

  Iterator begin() const { return { this->seeds_.first, *this }; }
  Iterator end() const { return { this->seeds_.end(), *this }; }

private:
  Seeds seeds_;
  std::uint64_t salt_;
};

/// A field with all windows, and the feet of its paths.
struct FieldWithFeet
{
  geodesic::TriangleMesh mesh;
  std::vector<geodesic::SourceCurve> curves;
  geodesic::DistanceField field;
  geodesic::NearestSource nearest;

  static geodesic::FrontOptions withAngles(bool keepAngles = true);

  /// The source of each curve is its index.
  FieldWithFeet(const PlainMesh& plain, const std::vector<Polyline>& polylines,
    const geodesic::FrontOptions& options = withAngles());

  geodesic::Foot footOf(const geodesic::SurfacePoint& point);
};

/// The vertices, and other points behind them.
std::vector<geodesic::SurfacePoint> verticesAnd(
  const geodesic::TriangleMesh& mesh, const std::vector<MeshPoint>& queries);

/// What was found of a target; the end is not known where the target is not reached.
struct FoundPath : geodesic::PathEnd
{
  /// On the mesh that geodesic::pathsToSource() has told, and in space.
  std::vector<geodesic::SurfacePoint> points;
  std::vector<geodesic::Vec3> places;
  bool wasLost = false;

  void take(const geodesic::PathToSource& path);
};

/// The path of each target.
std::vector<FoundPath> findPaths(const geodesic::MeshPartition& part,
  const geodesic::ReplicatedPatch& patch, const std::vector<geodesic::SourceCurve>& curves,
  const std::vector<geodesic::SurfacePoint>& targets, const geodesic::Job& job = {});
/// The same in one process.
std::vector<FoundPath> findPaths(const geodesic::TriangleMesh& mesh,
  const std::vector<geodesic::SourceCurve>& curves,
  const std::vector<geodesic::SurfacePoint>& targets, const geodesic::Job& job = {});

/// The sources in a form that can be pasted into a test.
std::string describe(const std::vector<Polyline>& curves);

}

#endif
