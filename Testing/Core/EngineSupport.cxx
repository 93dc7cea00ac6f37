// SPDX-License-Identifier: BSD-3-Clause
#include "EngineSupport.h"
#include "CaseWithoutTruth.h"

#include "contours/SolveForIsolines.h"
#include "mesh/FaceShape.h"
#include "mesh/FacesWithoutArea.h"
#include "refinement/SolveForRefinement.h"
#include "source/PolylineLocator.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

namespace geodesictest
{

double accuracyOn(const MeshKind& kind)
{
  const std::string name = kind.name;
  return name == "ThinNeedles" ? 5e-10 : name == "Needles" ? 3e-10 : OrdinaryAccuracy;
}

void locate(const geodesic::TriangleMesh& mesh, std::vector<geodesic::LocatedPolyline>& polylines,
  double coordinatePrecision)
{
  geodesic::PolylineLocator(geodesic::MeshPartition(mesh))
    .locate(polylines, coordinatePrecision)
    .setFaces(geodesic::ReplicatedPatch(mesh), polylines);
}

std::vector<geodesic::SourceCurve> curvesOnto(
  const geodesic::TriangleMesh& mesh, std::vector<geodesic::LocatedPolyline> polylines)
{
  locate(mesh, polylines);
  return geodesic::putOntoSurface(mesh, polylines, DBL_EPSILON, geodesic::joinByShortestPaths(mesh))
    .curves;
}

geodesic::TriangleMesh engineMesh(const PlainMesh& mesh)
{
  return geodesic::TriangleMesh(mesh.points, mesh.triangles);
}

std::size_t facesWithoutArea(const PlainMesh& mesh)
{
  return static_cast<std::size_t>(std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
    [&mesh](const Triangle& t)
    {
      const std::array<Vec3, 3> corners = { mesh.points[t[0]], mesh.points[t[1]],
        mesh.points[t[2]] };
      return geodesic::hasThreeVertices(t) &&
        geodesic::isWithoutArea(geodesic::shapeOf(corners), corners);
    }));
}

CleanedMesh withoutFlatFaces(const PlainMesh& mesh)
{
  CleanedMesh cleaned{ mesh, {}, {} };
  std::vector<std::uint64_t> keys;
  const geodesic::CutTriangles cut = geodesic::removeFacesWithoutArea(cleaned.mesh.points, keys,
    mesh.points.size(), mesh.triangles, {}, geodesic::OneRank::instance());
  cleaned.vertexOf = cut.same;
  cleaned.triangles = cut.triangles;
  if (cut.isEmpty())
  {
    cleaned.vertexOf.resize(mesh.points.size());
    std::iota(cleaned.vertexOf.begin(), cleaned.vertexOf.end(), 0);
    cleaned.triangles.resize(mesh.triangles.size());
    std::iota(cleaned.triangles.begin(), cleaned.triangles.end(), 0);
    return cleaned;
  }
  cleaned.triangles.clear();
  cleaned.mesh.triangles.clear();
  for (std::size_t i = 0; i < cut.parts.size(); ++i)
  {
    if (cut.areFaces[i])
    {
      cleaned.mesh.triangles.push_back(cut.parts[i]);
      cleaned.triangles.push_back(cut.triangles[i]);
    }
  }
  return cleaned;
}

geodesic::TriangleMesh cleanedEngineMesh(const PlainMesh& mesh)
{
  return engineMesh(withoutFlatFaces(mesh).mesh);
}

geodesic::SurfacePoint enginePoint(const geodesic::TriangleMesh& mesh, const MeshPoint& point)
{
  const Barycentric& w = point.weights;
  for (Index k = 0; k < 3; ++k)
  {
    const Index second = (k + 1) % 3;
    const Index third = (k + 2) % 3;
    if (w[second] == 0.0 && w[third] == 0.0)
    {
      return geodesic::SurfacePoint::atVertex(mesh.triangle(point.face)[k]);
    }
    if (w[third] == 0.0 && w[k] != 0.0 && w[second] != 0.0)
    {
      return geodesic::SurfacePoint::onEdge(3 * point.face + k, w[second]);
    }
  }
  return geodesic::SurfacePoint::inFace(point.face, w[1], w[2]);
}

geodesic::SourceCurve engineCurve(const geodesic::TriangleMesh& mesh, const Polyline& curve)
{
  geodesic::SourceCurve result;
  const auto add = [&](Index face, const Barycentric& weights, bool isCut)
  {
    result.points.push_back(enginePoint(mesh, { face, weights }));
    result.isCut.push_back(isCut ? 1 : 0);
  };
  add(curve.segments[0].face, curve.segments[0].from, false);
  if (curve.isPoint())
  {
    return result;
  }
  for (std::size_t i = 0; i < curve.segments.size(); ++i)
  {
    const MeshSegment& segment = curve.segments[i];
    result.faces.push_back(segment.face);
    add(segment.face, segment.to, curve.isCut(i));
  }
  return result;
}

std::vector<geodesic::SourceCurve> engineCurves(
  const geodesic::TriangleMesh& mesh, const std::vector<Polyline>& curves)
{
  std::vector<geodesic::SourceCurve> result;
  for (const Polyline& curve : curves)
  {
    result.push_back(engineCurve(mesh, curve));
  }
  return result;
}

std::vector<geodesic::SourceCurve> engineCurves(
  const geodesic::TriangleMesh& mesh, const Sources& sources)
{
  std::vector<Polyline> curves;
  for (const MeshPoint& point : sources.points)
  {
    curves.push_back({ { { point.face, point.weights, point.weights } }, {} });
  }
  for (const MeshSegment& segment : sources.segments)
  {
    curves.push_back({ { segment }, {} });
  }
  return engineCurves(mesh, curves);
}

Sources boundarySources(const geodesic::TriangleMesh& mesh)
{
  Sources result;
  for (geodesic::Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
  {
    if (mesh.isBoundary(halfedge))
    {
      MeshSegment edge{ mesh.inputFace(halfedge / 3), { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } };
      edge.from[halfedge % 3] = 1.0;
      edge.to[(halfedge + 1) % 3] = 1.0;
      result.segments.push_back(edge);
    }
  }
  return result;
}

geodesic::DistanceField solveKeepingAll(const geodesic::TriangleMesh& mesh,
  const std::vector<geodesic::SourceCurve>& curves, double relativeError, double maximumDistance,
  double maximumMerged)
{
  geodesic::FrontOptions options;
  options.relativeError = relativeError;
  options.maximumDistance = maximumDistance;
  options.maximumMerged = maximumMerged;
  return geodesic::solve(mesh, curves, options, geodesic::KeepWindows::All);
}

geodesic::DistanceField solveForIsolines(const geodesic::TriangleMesh& mesh,
  const std::vector<geodesic::SourceCurve>& curves, const std::vector<double>& values,
  const geodesic::FrontOptions& options)
{
  return solveForIsolines(geodesic::MeshPartition(mesh),
    geodesic::makeSourceWindows(mesh, curves, options.job), values, options);
}

geodesic::DistanceField solveForRefinement(const geodesic::TriangleMesh& mesh,
  const std::vector<geodesic::SourceCurve>& curves, double tolerance,
  const geodesic::FrontOptions& options)
{
  return solveForRefinement(geodesic::MeshPartition(mesh),
    geodesic::makeSourceWindows(mesh, curves, options.job), tolerance, options);
}

geodesic::DistanceField solveForRefinement(const geodesic::MeshPartition& part,
  const geodesic::SourceWindows& sources, double tolerance, const geodesic::FrontOptions& options)
{
  geodesic::PinnedFaces pinned(part.mesh().numberOfFaces(), 0);
  return solveForRefinement(part, sources, tolerance, options, pinned);
}

EngineResult valuesOf(const geodesic::DistanceField& field, const std::vector<MeshPoint>& queries)
{
  EngineResult result;
  result.vertices = field.vertexDistances();
  for (const MeshPoint& query : queries)
  {
    result.queries.push_back(field.distance(enginePoint(field.mesh(), query)));
  }
  return result;
}

EngineResult engineDistances(const PlainMesh& mesh,
  const std::vector<geodesic::SourceCurve>& curves, const geodesic::TriangleMesh& engine,
  const std::vector<MeshPoint>& queries)
{
  const EngineResult result = valuesOf(solveKeepingAll(engine, curves), queries);
  EXPECT_EQ(result.vertices.size(), mesh.points.size());
  const geodesic::DistanceField lean = geodesic::solve(engine, curves);
  EXPECT_FALSE(lean.hasWindows());
  EXPECT_LE(
    worstError(lean.vertexDistances(), result.vertices, largestFinite(result.vertices)), 1e-14)
    << "without windows kept";
  return result;
}

EngineResult engineDistances(
  const PlainMesh& mesh, const std::vector<Polyline>& curves, const std::vector<MeshPoint>& queries)
{
  const geodesic::TriangleMesh engine = engineMesh(mesh);
  return engineDistances(mesh, engineCurves(engine, curves), engine, queries);
}

EngineResult engineDistances(
  const PlainMesh& mesh, const Sources& sources, const std::vector<MeshPoint>& queries)
{
  const geodesic::TriangleMesh engine = engineMesh(mesh);
  return engineDistances(mesh, engineCurves(engine, sources), engine, queries);
}

double largestFinite(const std::vector<double>& values)
{
  double largest = 0.0;
  for (double value : values)
  {
    if (std::isfinite(value))
    {
      largest = std::max(largest, value);
    }
  }
  return largest;
}

double worstError(
  const std::vector<double>& computed, const std::vector<double>& truth, double largest)
{
  EXPECT_EQ(computed.size(), truth.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < std::min(computed.size(), truth.size()); ++i)
  {
    if (computed[i] == truth[i])
    {
      continue;
    }
    if (!std::isfinite(computed[i]) || !std::isfinite(truth[i]))
    {
      return std::numeric_limits<double>::infinity();
    }
    worst = std::max(worst, std::abs(computed[i] - truth[i]) / largest);
  }
  return worst;
}

double expectCertified(const geodesic::DistanceField& field, const std::vector<MeshPoint>& queries,
  const EngineResult& exact, double accuracy)
{
  const EngineResult computed = valuesOf(field, queries);
  const double largest = largestFinite(exact.vertices);
  const double rounding = accuracy * largest;
  double measured = 0.0;
  const auto compare = [&](const std::vector<double>& approximate, const std::vector<double>& truth)
  {
    ASSERT_EQ(approximate.size(), truth.size());
    for (std::size_t i = 0; i < truth.size(); ++i)
    {
      if (std::isinf(truth[i]))
      {
        EXPECT_TRUE(std::isinf(approximate[i])) << i;
        continue;
      }
      EXPECT_LE(approximate[i], truth[i] + rounding) << i;
      EXPECT_GE(approximate[i], truth[i] * (1.0 - field.relativeErrorBound()) - rounding) << i;
      if (truth[i] > std::sqrt(accuracy) * largest)
      {
        measured = std::max(measured, (truth[i] - approximate[i]) / truth[i]);
      }
    }
  };
  compare(computed.vertices, exact.vertices);
  compare(computed.queries, exact.queries);
  return measured;
}

std::vector<MeshPoint> randomPoints(const PlainMesh& mesh, std::size_t count, Random& random)
{
  std::vector<MeshPoint> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    points.push_back(randomPoint(mesh, random));
  }
  return points;
}

RandomCase randomCase(
  const MeshKind& kind, std::uint64_t seed, std::size_t numberOfQueries, Index mostFaces)
{
  RandomCase result = caseWithoutTruth(kind, seed, numberOfQueries, mostFaces);
  result.truth = bruteForceDistances(result.mesh, toSources(result.curves), result.queries);
  return result;
}

std::string describe(const std::vector<Polyline>& curves)
{
  std::ostringstream text;
  text.precision(17);
  const auto write = [&text](const Barycentric& w)
  { text << "{ " << w[0] << ", " << w[1] << ", " << w[2] << " }"; };
  for (const Polyline& curve : curves)
  {
    text << (curve.isPoint() ? "point" : curve.isCut(0) ? "straight" : "polyline") << " {";
    for (const MeshSegment& s : curve.segments)
    {
      text << " { " << s.face << ", ";
      write(s.from);
      text << ", ";
      write(s.to);
      text << " }";
    }
    text << " }\n";
  }
  return text.str();
}

geodesic::FrontOptions FieldWithFeet::withAngles(bool keepAngles)
{
  geodesic::FrontOptions options;
  options.keepArrivals = true;
  options.keepAngles = keepAngles;
  return options;
}

FieldWithFeet::FieldWithFeet(const PlainMesh& plain, const std::vector<Polyline>& polylines,
  const geodesic::FrontOptions& options)
  : mesh(engineMesh(plain))
  , curves(engineCurves(mesh, polylines))
  , field(geodesic::solve(mesh, curves, options, geodesic::KeepWindows::All))
  , nearest(field, geodesic::ReplicatedPatch(mesh), curves)
{
  for (std::size_t i = 0; i < this->curves.size(); ++i)
  {
    this->curves[i].source = static_cast<geodesic::Id>(i);
  }
}

geodesic::Foot FieldWithFeet::footOf(const geodesic::SurfacePoint& point)
{
  return point.kind == geodesic::SurfacePoint::Kind::Vertex
    ? this->nearest.atVertex(point.id)
    : this->nearest.of(geodesic::incomingSegmentTo(this->field, point));
}

std::vector<geodesic::SurfacePoint> verticesAnd(
  const geodesic::TriangleMesh& mesh, const std::vector<MeshPoint>& queries)
{
  std::vector<geodesic::SurfacePoint> points;
  for (geodesic::Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    points.push_back(geodesic::SurfacePoint::atVertex(vertex));
  }
  for (const MeshPoint& query : queries)
  {
    points.push_back(geodesic::normalized(mesh, enginePoint(mesh, query)));
  }
  return points;
}

void FoundPath::take(const geodesic::PathToSource& path)
{
  EXPECT_TRUE(this->points.empty()) << "a path was handed over twice";
  this->points = path.points;
  for (std::size_t i = 0; i < path.points.size(); ++i)
  {
    this->places.push_back(geodesic::position(path.mesh(), path.points[i]));
    EXPECT_TRUE(i == 0 ||
      geodesic::commonFace(path.mesh(), path.points[i - 1], path.points[i]) != geodesic::NoId)
      << "points " << i - 1 << " and " << i << " of a path have no face in common";
  }
  static_cast<geodesic::PathEnd&>(*this) = path.end;
  this->wasLost = path.wasLost;
}

std::vector<FoundPath> findPaths(const geodesic::MeshPartition& part,
  const geodesic::ReplicatedPatch& patch, const std::vector<geodesic::SourceCurve>& curves,
  const std::vector<geodesic::SurfacePoint>& targets, const geodesic::Job& job)
{
  std::vector<FoundPath> paths(targets.size());
  geodesic::pathsToSource(part, patch, curves, targets, job,
    [&](const geodesic::PathToSource& path) { paths[path.target].take(path); });
  return paths;
}

std::vector<FoundPath> findPaths(const geodesic::TriangleMesh& mesh,
  const std::vector<geodesic::SourceCurve>& curves,
  const std::vector<geodesic::SurfacePoint>& targets, const geodesic::Job& job)
{
  return findPaths(
    geodesic::MeshPartition(mesh), geodesic::ReplicatedPatch(mesh), curves, targets, job);
}

}
