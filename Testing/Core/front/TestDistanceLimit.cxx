// SPDX-License-Identifier: BSD-3-Clause
// The guarantees of a distance limit, compared with the brute-force solver: exactly the faces that
// contain a point within the limit are complete, and vertices without a complete face are at
// +infinity.
#include "EngineSupport.h"
#include "truth/RandomMeshKinds.h"

#include "Errors.h"
#include "front/Front.h"
#include "front/Retention.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace geodesictest;
using geodesic::DistanceField;
using geodesic::Infinity;
using geodesic::TriangleMesh;

namespace
{

constexpr std::size_t PiecesOfAnEdge = 24;
constexpr std::size_t PointsInsideAFace = 6;

/// The true distances at the vertices, and in each face at points of its edges and its inside.
class SampledTruth
{
public:
  SampledTruth(const PlainMesh& mesh, const Sources& sources, Random& random)
    : mesh_(mesh)
    , leastBound_(mesh.triangles.size(), Infinity)
  {
    for (Index f = 0; f < mesh.triangles.size(); ++f)
    {
      this->addPoints(f, random);
    }
    this->truth_ = bruteForceDistances(mesh, sources, this->points_);
    for (Index f = 0; f < mesh.triangles.size(); ++f)
    {
      this->boundLeast(f);
    }
    for (const MeshPoint& p : sources.points)
    {
      this->leastBound_[p.face] = 0.0;
      this->facesOfSources_.push_back(p.face);
    }
    for (const MeshSegment& s : sources.segments)
    {
      this->leastBound_[s.face] = 0.0;
      this->facesOfSources_.push_back(s.face);
    }
  }

  const std::vector<double>& vertices() const { return this->truth_.vertices; }
  double largest() const
  {
    return std::max(largestFinite(this->truth_.vertices), largestFinite(this->truth_.queries));
  }

  /// The smallest sampled distance in the face, and a lower bound for all its points: distance
  /// grows no faster than a point moves, and in a face without a source it is least on an edge.
  double leastSeen(Index face) const
  {
    if (std::find(this->facesOfSources_.begin(), this->facesOfSources_.end(), face) !=
      this->facesOfSources_.end())
    {
      return 0.0;
    }
    const auto first = this->truth_.queries.begin() + this->firstOf(face);
    return *std::min_element(first, first + PointsOfAFace);
  }
  double leastBound(Index face) const { return this->leastBound_[face]; }

  /// Calls visit(point, true distance, whether it is inside the face) for the points of a face.
  template <typename Visit>
  void forEachPoint(Index face, const Visit& visit) const
  {
    for (std::ptrdiff_t i = 0; i < PointsOfAFace; ++i)
    {
      const auto at = static_cast<std::size_t>(this->firstOf(face) + i);
      visit(this->points_[at], this->truth_.queries[at], i >= PointsOfEdges);
    }
  }

private:
  static constexpr std::ptrdiff_t PointsOfEdges = 3 * (PiecesOfAnEdge + 1);
  static constexpr std::ptrdiff_t PointsOfAFace = PointsOfEdges + PointsInsideAFace;

  std::ptrdiff_t firstOf(Index face) const
  {
    return static_cast<std::ptrdiff_t>(face) * PointsOfAFace;
  }

  void addPoints(Index face, Random& random)
  {
    for (Index k = 0; k < 3; ++k)
    {
      for (std::size_t i = 0; i <= PiecesOfAnEdge; ++i)
      {
        Barycentric w{};
        w[(k + 1) % 3] = static_cast<double>(i) / PiecesOfAnEdge;
        w[k] = 1.0 - w[(k + 1) % 3];
        this->points_.push_back({ face, w });
      }
    }
    for (std::size_t i = 0; i < PointsInsideAFace; ++i)
    {
      const double u = random.uniform(0.05, 0.9);
      const double v = random.uniform(0.05, 0.95) * (1.0 - u);
      this->points_.push_back({ face, { 1.0 - u - v, u, v } });
    }
  }

  void boundLeast(Index face)
  {
    const auto first = this->firstOf(face);
    for (Index k = 0; k < 3; ++k)
    {
      const Triangle& t = this->mesh_.triangles[face];
      const double step =
        spaceDistance(this->mesh_.points[t[k]], this->mesh_.points[t[(k + 1) % 3]]) /
        PiecesOfAnEdge;
      for (std::size_t i = 0; i < PiecesOfAnEdge; ++i)
      {
        const auto at = static_cast<std::size_t>(first) + k * (PiecesOfAnEdge + 1) + i;
        const double between =
          0.5 * (this->truth_.queries[at] + this->truth_.queries[at + 1] - step);
        this->leastBound_[face] = std::min(this->leastBound_[face], between);
      }
    }
  }

  const PlainMesh& mesh_;
  std::vector<MeshPoint> points_;
  BruteForceResult truth_;
  std::vector<double> leastBound_;
  std::vector<Index> facesOfSources_;
};

/// What the limit guarantees for a face or a vertex.
enum class Promise
{
  Complete,
  /// The nearest point is so close to the limit that samples do not decide.
  CannotTell,
  Nothing
};

std::vector<Promise> promisesOfFaces(
  const PlainMesh& mesh, const SampledTruth& truth, double limit, double slack)
{
  std::vector<Promise> result;
  for (Index f = 0; f < mesh.triangles.size(); ++f)
  {
    result.push_back(truth.leastSeen(f) < limit - slack ? Promise::Complete
        : truth.leastBound(f) > limit + slack           ? Promise::Nothing
                                                        : Promise::CannotTell);
  }
  return result;
}

std::vector<Promise> promisesOfVertices(const PlainMesh& mesh, const std::vector<Promise>& faces)
{
  std::vector<Promise> result(mesh.points.size(), Promise::Nothing);
  for (Index f = 0; f < mesh.triangles.size(); ++f)
  {
    for (const Index v : mesh.triangles[f])
    {
      result[v] = std::min(result[v], faces[f]);
    }
  }
  return result;
}

void expectVertices(const std::vector<double>& computed, const SampledTruth& truth,
  const std::vector<Promise>& promises, double slack, const char* what)
{
  for (Index v = 0; v < computed.size(); ++v)
  {
    if (promises[v] == Promise::Nothing)
    {
      EXPECT_EQ(computed[v], Infinity) << what << ", vertex " << v << " has no complete face";
    }
    else if (promises[v] == Promise::Complete || computed[v] < Infinity)
    {
      EXPECT_NEAR(computed[v], truth.vertices()[v], slack) << what << ", vertex " << v;
    }
  }
}

void expectInside(const DistanceField& field, const SampledTruth& truth,
  const std::vector<Promise>& promises, double slack)
{
  for (Index f = 0; f < promises.size(); ++f)
  {
    if (promises[f] == Promise::CannotTell)
    {
      continue;
    }
    const bool complete = promises[f] == Promise::Complete;
    EXPECT_EQ(field.knowsInside(f), complete) << "face " << f;
    truth.forEachPoint(f,
      [&](const MeshPoint& point, double distance, bool isInside)
      {
        const double computed = field.distance(enginePoint(field.mesh(), point));
        if (complete)
        {
          EXPECT_NEAR(computed, distance, slack) << "face " << f;
        }
        else if (isInside)
        {
          EXPECT_EQ(computed, Infinity) << "face " << f;
        }
      });
  }
}

/// Checks the guarantees of the limit, with windows kept and without. \returns the guarantees of
/// the faces.
std::vector<Promise> expectLimitKept(const PlainMesh& mesh, const std::vector<Polyline>& curves,
  const SampledTruth& truth, double limit, double accuracy)
{
  SCOPED_TRACE(::testing::Message() << "limit " << limit << ", sources:\n" << describe(curves));
  const double slack = accuracy * truth.largest();
  std::vector<Promise> faces = promisesOfFaces(mesh, truth, limit, slack);
  const std::vector<Promise> vertices = promisesOfVertices(mesh, faces);
  const TriangleMesh engine = engineMesh(mesh);
  const DistanceField field = solveKeepingAll(engine, engineCurves(engine, curves), 0.0, limit);
  expectVertices(field.vertexDistances(), truth, vertices, slack, "windows kept");
  expectInside(field, truth, faces, slack);
  geodesic::FrontOptions lean;
  lean.maximumDistance = limit;
  expectVertices(geodesic::solve(engine, engineCurves(engine, curves), lean).vertexDistances(),
    truth, vertices, slack, "without windows");
  return faces;
}

class DistanceLimit : public ::testing::TestWithParam<MeshKind>
{
};

}

TEST_P(DistanceLimit, ExactlyTheFacesWithAPointWithinItAreComplete)
{
  std::array<std::size_t, 3> counts{};
  for (Random& random : EachSeed(12, 9000))
  {
    const PlainMesh mesh = GetParam().make(random.between(20, 150), random);
    CurveMaker maker(mesh, random);
    const std::vector<Polyline> curves = maker.anySource();
    const SampledTruth truth(mesh, toSources(curves), random);
    for (const double part : { 1e-6, random.uniform(0.01, 0.1), random.uniform(0.1, 0.8) })
    {
      const double limit = part * truth.largest();
      for (const Promise p : expectLimitKept(mesh, curves, truth, limit, accuracyOn(GetParam())))
      {
        ++counts[static_cast<std::size_t>(p)];
      }
    }
  }
  // The samples must have decided for most faces.
  EXPECT_LT(counts[1], (counts[0] + counts[1] + counts[2]) / 5);
}

INSTANTIATE_TEST_SUITE_P(Kinds, DistanceLimit, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });

namespace
{

/// Ten rows of two triangles, together 10 wide and .2 high, between two large triangles: a path
/// through the rows passes no vertex.
class Rows
{
public:
  Rows(double topY, double bottomY)
  {
    PlainMesh& mesh = this->mesh_;
    for (Index row = 0; row <= 10; ++row)
    {
      mesh.points.push_back({ 0.0, 0.02 * row, 0.0 });
      mesh.points.push_back({ 10.0, 0.02 * row, 0.0 });
    }
    for (Index row = 0; row < 10; ++row)
    {
      const Index first = 2 * row;
      mesh.triangles.push_back({ first, first + 1, first + 3 });
      mesh.triangles.push_back({ first, first + 3, first + 2 });
    }
    mesh.points.push_back({ 5.0, topY, 0.0 });
    mesh.points.push_back({ 5.0, bottomY, 0.0 });
    mesh.triangles.push_back({ 20, 21, this->top });
    mesh.triangles.push_back({ 1, 0, this->bottom });
  }

  const PlainMesh& mesh() const { return this->mesh_; }

  /// A point of the plane.
  MeshPoint at(double x, double y) const
  {
    for (Index f = 0; f < this->mesh_.triangles.size(); ++f)
    {
      const Triangle& t = this->mesh_.triangles[f];
      const auto area = [&](const Vec3& a, const Vec3& b)
      { return (a[0] - x) * (b[1] - y) - (b[0] - x) * (a[1] - y); };
      Barycentric w{};
      for (std::size_t k = 0; k < 3; ++k)
      {
        w[k] = area(this->mesh_.points[t[(k + 1) % 3]], this->mesh_.points[t[(k + 2) % 3]]);
      }
      const double sum = w[0] + w[1] + w[2];
      w = { w[0] / sum, w[1] / sum, w[2] / sum };
      if (*std::min_element(w.begin(), w.end()) >= 0.0)
      {
        return { f, w };
      }
    }
    ADD_FAILURE() << "no face holds " << x << ", " << y;
    return {};
  }

  const Index top = 22;
  const Index bottom = 23;

private:
  PlainMesh mesh_;
};

Polyline pointAt(const MeshPoint& p)
{
  return { { { p.face, p.weights, p.weights } }, {} };
}

}

// Each corner of the upper triangle is near a source, but its inside is not.
TEST(DistanceLimit, APromisedFaceIsCompleteFarFromItsCorners)
{
  const Rows rows(8.0, -10.0);
  const MeshPoint far = rows.at(5.0, -2.5);
  std::vector<Polyline> curves = { pointAt(far) };
  for (const Index face : { 20U, 21U })
  {
    const Triangle& t = rows.mesh().triangles[face];
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vec3& corner = rows.mesh().points[t[k]];
      const Vec3 centre = position(rows.mesh(), { face, { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 } });
      const double part = 0.3 / spaceDistance(corner, centre);
      Barycentric w{ part / 3.0, part / 3.0, part / 3.0 };
      w[k] += 1.0 - part;
      curves.push_back(pointAt({ face, w }));
    }
  }
  const TriangleMesh engine = engineMesh(rows.mesh());
  const DistanceField field = solveKeepingAll(engine, engineCurves(engine, curves), 0.0, 0.1);
  EXPECT_NEAR(field.distance(enginePoint(engine, rows.at(5.0, 0.3))), 2.8, 1e-14);
  Random random(1);
  const SampledTruth truth(rows.mesh(), toSources(curves), random);
  expectLimitKept(rows.mesh(), curves, truth, 0.1, 1e-12);
}

// The window that leads there begins far beyond the limit, and only its middle is within it.
TEST(DistanceLimit, AWindowWithinItAtItsMiddleGoesOn)
{
  const Rows rows(0.3, -2.6);
  const std::vector<Polyline> curves = { pointAt(rows.at(5.0, -2.5)) };
  const TriangleMesh engine = engineMesh(rows.mesh());
  const DistanceField field = solveKeepingAll(engine, engineCurves(engine, curves), 0.0, 2.9);
  EXPECT_NEAR(field.vertexDistances()[rows.top], 2.8, 1e-14);
  Random random(1);
  const SampledTruth truth(rows.mesh(), toSources(curves), random);
  expectLimitKept(rows.mesh(), curves, truth, 2.9, 1e-12);
}

TEST(DistanceLimit, TheFaceOfASourceIsCompleteWhereItsCornersAreBeyond)
{
  PlainMesh mesh;
  mesh.points = { { 0.0, 0.0, 0.0 }, { 3.0, 0.0, 0.0 }, { 0.0, 4.0, 0.0 }, { 9.0, 9.0, 0.0 } };
  mesh.triangles = { { 0, 1, 2 }, { 2, 1, 3 } };
  const TriangleMesh engine = engineMesh(mesh);
  const std::vector<Polyline> curves = { pointAt({ 0, { 0.5, 0.25, 0.25 } }) }; // (.75, 1)
  for (const auto keep : { geodesic::KeepWindows::None, geodesic::KeepWindows::All })
  {
    geodesic::FrontOptions options;
    options.maximumDistance = 0.1;
    const std::vector<double> d =
      geodesic::solve(engine, engineCurves(engine, curves), options, keep).vertexDistances();
    EXPECT_NEAR(d[0], 1.25, 1e-14);
    EXPECT_NEAR(d[1], std::hypot(2.25, 1.0), 1e-14);
    EXPECT_NEAR(d[2], std::hypot(0.75, 3.0), 1e-14);
    EXPECT_EQ(d[3], Infinity);
  }
  Random random(1);
  const SampledTruth truth(mesh, toSources(curves), random);
  expectLimitKept(mesh, curves, truth, 0.1, 1e-14);
}

// Two squares share one vertex, which is at the limit. No window enters the second square, of which
// only this vertex is within the limit.
TEST(DistanceLimit, AFaceThatItTouchesInAVertexAloneIsComplete)
{
  const PlainMesh square = regularGrid(1, 1);
  const PlainMesh mesh = joinedAtVertex(square, 0, square, 3);
  const TriangleMesh engine = engineMesh(mesh);
  const std::vector<Polyline> curves = { pointAt(vertexPoint(mesh, 1)) };
  for (const bool isWithin : { true, false })
  {
    const DistanceField field =
      solveKeepingAll(engine, engineCurves(engine, curves), 0.0, isWithin ? 1.0 : 1.0 - 1e-12);
    ASSERT_EQ(field.vertexDistances()[0], 1.0);
    for (const Index f : { 2U, 3U })
    {
      EXPECT_EQ(field.knowsInside(f), isWithin) << "face " << f;
      EXPECT_EQ(field.distance(enginePoint(engine, { f, { 0.2, 0.3, 0.5 } })) < Infinity, isWithin);
    }
  }
}

// An edge between a face within the limit, whose windows were not kept, and one beyond it.
TEST(DistanceLimit, AnEdgeOfAFaceWhoseWindowsWereNotKeptHasNoKnownDistance)
{
  const PlainMesh plain = regularGrid(6, 1);
  const TriangleMesh mesh = engineMesh(plain);
  geodesic::FrontOptions options;
  options.maximumDistance = 2.5;
  geodesic::KeepFaces none(mesh, std::vector<std::uint8_t>(mesh.numberOfFaces(), 0));
  const std::vector<Polyline> source = { pointAt(vertexPoint(plain, 0)) };
  geodesic::FrontResult front = propagate(mesh, engineCurves(mesh, source), options, none);
  const DistanceField field(geodesic::MeshPartition(mesh), std::move(front), none.release());
  int edges = 0;
  for (geodesic::Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
  {
    int within = 0;
    int faces = 0;
    const auto middle = geodesic::SurfacePoint::onEdge(halfedge, 0.5);
    forEachFace(mesh, middle,
      [&](geodesic::Id face)
      {
        ++faces;
        within += field.isDropped(face) ? 1 : 0;
      });
    if (within > 0)
    {
      EXPECT_THROW(field.distance(middle), geodesic::Error) << "halfedge " << halfedge;
      edges += within < faces ? 1 : 0;
    }
    else
    {
      EXPECT_EQ(field.distance(middle), Infinity) << "halfedge " << halfedge;
    }
  }
  EXPECT_EQ(edges, 2) << "seen from both faces";
}

namespace
{

class KeepNoneWithin : public geodesic::KeepNone
{
public:
  explicit KeepNoneWithin(double reach)
    : reach_(reach)
  {
  }
  double neededDistance() const override { return this->reach_; }

private:
  double reach_;
};

} // anonymous namespace

// The straight way to vertex 4 waits for vertex 3, far beyond the reach. Behind vertex 4 faces meet
// in vertices only: no windows go there, the ways along edges alone.
TEST(RetentionWithAReach, VerticesShortenedBehindTheFrontPassTheirDistancesOn)
{
  const TriangleMesh mesh(
    { { 0, -2, 0 }, { 1, 0, 0 }, { 0, 0, 0 }, { 0.5, 6, 0 }, { 1.2, 1, 0 }, { 1.7, 1, 0 },
      { 1.5, 1.2, 0 }, { 2.1, 1, 0 }, { 1.9, 1.2, 0 }, { 2.5, 1, 0 }, { 2.3, 1.2, 0 } },
    { { 0, 1, 2 }, { 2, 1, 3 }, { 3, 1, 4 }, { 4, 5, 6 }, { 5, 7, 8 }, { 7, 9, 10 } });
  KeepNoneWithin retention(5.0);
  const geodesic::FrontResult front =
    propagate(mesh, { geodesic::pointCurve(geodesic::SurfacePoint::atVertex(0)) }, {}, retention);
  const double toBranch = std::hypot(1.2, 3.0);
  EXPECT_NEAR(front.vertexDistances[4], toBranch, 1e-14);
  EXPECT_NEAR(front.vertexDistances[5], toBranch + 0.5, 1e-14);
  EXPECT_NEAR(front.vertexDistances[7], toBranch + 0.9, 1e-14);
  EXPECT_NEAR(front.vertexDistances[9], toBranch + 1.3, 1e-14);
}
