// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RefinementSupport.h"

#include "field/FaceDistance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace geodesictest
{

using geodesic::DistanceField;
using geodesic::Id;
using geodesic::NoId;
using geodesic::RefinedMesh;
using geodesic::RefinementOptions;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

RefinedMesh refineTo(const DistanceField& field, double tolerance, std::uint64_t maximumFaces)
{
  RefinementOptions options;
  options.tolerance = tolerance;
  options.maximumFaces = maximumFaces;
  return geodesic::refine(field, options);
}

namespace
{

/// The halfedge of the face that both points lie on; NoId where there is none.
Id commonHalfedge(const Points& points, Id face, Id a, Id b)
{
  const Barycentric first = points.weights(a, face);
  const Barycentric second = points.weights(b, face);
  for (Id k = 0; k < 3; ++k)
  {
    if (first[k] == 0.0 && second[k] == 0.0)
    {
      return 3 * face + (k + 1) % 3;
    }
  }
  return NoId;
}

/// New points have earlier parents, lie between them and on the surface, and carry the distance
/// there; none is at the place of another.
void expectPointsRight(const DistanceField& field, const RefinedMesh& refined, const Points& points)
{
  const TriangleMesh& mesh = field.mesh();
  ASSERT_EQ(refined.numberOfInputPoints, mesh.numberOfVertices());
  double largest = largestFinite(field.vertexDistances());
  for (const geodesic::RefinedPoint& p : refined.points)
  {
    largest = std::max(largest, p.distance);
  }
  std::set<std::tuple<SurfacePoint::Kind, Id, double, double>> places;
  for (std::size_t i = 0; i < refined.points.size(); ++i)
  {
    const geodesic::RefinedPoint& p = refined.points[i];
    const Id id = refined.numberOfInputPoints + static_cast<Id>(i);
    ASSERT_LT(p.parents[0], id);
    ASSERT_LT(p.parents[1], id);
    EXPECT_GE(p.weight, 0.03);
    EXPECT_LE(p.weight, 0.97);
    EXPECT_NE(p.place.kind, SurfacePoint::Kind::Vertex);
    EXPECT_TRUE(places.emplace(p.place.kind, p.place.id, p.place.u, p.place.v).second)
      << "two points at one place";
    const Vec3 a = points.position(p.parents[0]);
    const Vec3 b = points.position(p.parents[1]);
    Vec3 between;
    double size = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      between[axis] = a[axis] + p.weight * (b[axis] - a[axis]);
      size = std::max({ size, std::abs(a[axis]), std::abs(b[axis]) });
    }
    EXPECT_LE(spaceDistance(p.position, between), 1e-13 * size);
    EXPECT_EQ(p.position, position(mesh, p.place));
    if (field.relativeErrorBound() == 0.0)
    {
      EXPECT_NEAR(p.distance, field.distance(p.place), EngineAccuracy * largest);
    }
  }
}

}

Samples sample(
  const DistanceField& field, const RefinedMesh& refined, std::size_t count, Random& random)
{
  const Points points(field, refined);
  Samples samples;
  while (samples.places.size() < count)
  {
    const Index triangle = random.below(refined.triangles.size());
    const Id face = refined.faces[triangle];
    const Barycentric w = randomWeights(random);
    MeshPoint place{ face, { 0.0, 0.0, 0.0 } };
    double value = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id corner = refined.triangles[triangle][k];
      const Barycentric b = points.weights(corner, face);
      for (std::size_t j = 0; j < 3; ++j)
      {
        place.weights[j] += w[k] * b[j];
      }
      value += w[k] == 0.0 ? 0.0 : w[k] * points.distance(corner);
    }
    samples.places.push_back(place);
    samples.interpolant.push_back(value);
  }
  return samples;
}

void expectRefinedPointsRight(const TriangleMesh& engine, const RefinedMesh& refined,
  const PlainMesh& mesh, const Sources& sources, double accuracy)
{
  std::vector<MeshPoint> places;
  for (const geodesic::RefinedPoint& p : refined.points)
  {
    const bool onEdge = p.place.kind == SurfacePoint::Kind::Edge;
    const Id face = onEdge ? TriangleMesh::faceOf(p.place.id) : p.place.id;
    places.push_back({ face, barycentric(engine, p.place, face) });
  }
  const BruteForceResult truth = bruteForceDistances(mesh, sources, places);
  double worst = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    worst = std::max(worst, std::abs(refined.points[i].distance - truth.queries[i]));
  }
  EXPECT_LE(worst, accuracy);
}

Samples samplesIn(const Samples& samples, const std::vector<bool>& faces)
{
  Samples result;
  for (std::size_t i = 0; i < samples.places.size(); ++i)
  {
    if (faces[samples.places[i].face])
    {
      result.places.push_back(samples.places[i]);
      result.interpolant.push_back(samples.interpolant[i]);
    }
  }
  return result;
}

std::vector<bool> completeFaces(const DistanceField& field)
{
  std::vector<bool> complete;
  for (Id face = 0; face < field.mesh().numberOfFaces(); ++face)
  {
    const auto inside = geodesic::SurfacePoint::inFace(face, 0.3, 0.3);
    complete.push_back(std::isfinite(field.distance(inside)));
  }
  return complete;
}

std::size_t expectLeftAsTheyAre(
  const TriangleMesh& mesh, const RefinedMesh& refined, const std::vector<bool>& complete)
{
  std::vector<bool> mayBeCut = complete;
  for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
  {
    for (Id s = mesh.nextSibling(halfedge); s != halfedge; s = mesh.nextSibling(s))
    {
      const Id face = TriangleMesh::faceOf(halfedge);
      mayBeCut[face] = mayBeCut[face] || complete[TriangleMesh::faceOf(s)];
    }
  }
  std::vector<Id> parts(mesh.numberOfFaces(), 0);
  for (const Id face : refined.faces)
  {
    ++parts[face];
  }
  std::size_t left = 0;
  for (Id face = 0; face < mesh.numberOfFaces(); ++face)
  {
    if (!mayBeCut[face])
    {
      EXPECT_EQ(parts[face], 1u) << "face " << face;
      ++left;
    }
  }
  return left;
}

double largestDifference(const Samples& samples, const std::vector<double>& truth)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    const double value = samples.interpolant[i];
    largest = std::isinf(truth[i]) && std::isinf(value)
      ? largest
      : std::max(largest, std::abs(value - truth[i]));
  }
  return largest;
}

double largestDifferenceInside(
  const DistanceField& field, const RefinedMesh& refined, int inEachTriangle, Random& random)
{
  const Points points(field, refined);
  double largest = 0.0;
  for (std::size_t i = 0; i < refined.triangles.size(); ++i)
  {
    const geodesic::FaceDistance face(field, refined.faces[i]);
    for (int sample = 0; sample < inEachTriangle; ++sample)
    {
      const Barycentric w = randomWeights(random);
      Barycentric place{};
      double value = 0.0;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Id corner = refined.triangles[i][k];
        const Barycentric b = points.weights(corner, face.face());
        for (std::size_t j = 0; j < 3; ++j)
        {
          place[j] += w[k] * b[j];
        }
        value += w[k] * points.distance(corner);
      }
      largest = std::max(largest, std::abs(face.distance(face.inPlane(place)) - value));
    }
  }
  return largest;
}

double determinant(const Barycentric& a, const Barycentric& b, const Barycentric& c)
{
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
    a[2] * (b[0] * c[1] - b[1] * c[0]);
}

void expectFacesPartitioned(
  const TriangleMesh& mesh, const RefinedMesh& refined, const Points& points)
{
  ASSERT_EQ(refined.faces.size(), refined.triangles.size());
  EXPECT_TRUE(std::is_sorted(refined.faces.begin(), refined.faces.end()));
  std::vector<double> covered(mesh.numberOfFaces(), 0.0);
  for (std::size_t t = 0; t < refined.triangles.size(); ++t)
  {
    const Id face = refined.faces[t];
    const geodesic::Triangle& c = refined.triangles[t];
    for (const Id corner : c)
    {
      ASSERT_TRUE(contains(mesh, face, points.place(corner)));
    }
    const double part = determinant(
      points.weights(c[0], face), points.weights(c[1], face), points.weights(c[2], face));
    EXPECT_GT(part, 0.0) << "triangle " << t << " is turned over or empty";
    covered[face] += part;
  }
  for (Id face = 0; face < mesh.numberOfFaces(); ++face)
  {
    EXPECT_NEAR(covered[face], 1.0, 1e-12) << "face " << face;
  }
}

void expectWatertight(const TriangleMesh& mesh, const RefinedMesh& refined, const Points& points)
{
  struct Around
  {
    Id triangles = 0;
    Id expected = 2;
  };
  std::map<std::pair<Id, Id>, Around> edges;
  for (std::size_t t = 0; t < refined.triangles.size(); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id a = refined.triangles[t][k];
      const Id b = refined.triangles[t][(k + 1) % 3];
      Around& around = edges[std::minmax(a, b)];
      ++around.triangles;
      const Id halfedge = commonHalfedge(points, refined.faces[t], a, b);
      if (halfedge != NoId)
      {
        around.expected = 1;
        for (Id s = mesh.nextSibling(halfedge); s != halfedge; s = mesh.nextSibling(s))
        {
          ++around.expected;
        }
      }
    }
  }
  double boundary = 0.0;
  for (const auto& [ends, around] : edges)
  {
    EXPECT_EQ(around.triangles, around.expected) << "edge " << ends.first << ", " << ends.second;
    if (around.triangles == 1)
    {
      boundary += spaceDistance(points.position(ends.first), points.position(ends.second));
    }
  }
  double boundaryBefore = 0.0;
  for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
  {
    boundaryBefore += mesh.isBoundary(halfedge) ? mesh.length(halfedge) : 0.0;
  }
  EXPECT_NEAR(boundary, boundaryBefore, 1e-12 * (1.0 + boundaryBefore));
}

void expectSameSurface(const DistanceField& field, const RefinedMesh& refined)
{
  const Points points(field, refined);
  expectFacesPartitioned(field.mesh(), refined, points);
  expectWatertight(field.mesh(), refined, points);
  expectPointsRight(field, refined, points);
}

}
