// SPDX-License-Identifier: BSD-3-Clause
// The distance in a face as the least of its candidates, and along its segments as windows.
#include "EngineSupport.h"
#include "Seeds.h"
#include "truth/RandomMeshKinds.h"

#include "Errors.h"
#include "field/SegmentEnvelope.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace geodesictest;
using geodesic::FaceDistance;
using geodesic::SegmentEnvelope;
using geodesic::Window;
using geodesic::operator+;
using geodesic::operator-;
using geodesic::operator*;

namespace
{

/// Envelopes may be off by as much as neighbouring windows differ where they meet.
constexpr double SegmentAccuracy = 1e-9;

class SegmentEnvelopes : public ::testing::TestWithParam<MeshKind>
{
};

double at(const std::vector<Window>& envelope, double x)
{
  const auto window =
    std::find_if(envelope.begin(), envelope.end(), [x](const Window& w) { return x <= w.end; });
  return (window == envelope.end() ? envelope.back() : *window).distance(x);
}

/// Ends of a segment in a face: anywhere, or on one edge, which it covers wholly or in part.
std::array<Barycentric, 2> randomSegment(Random& random)
{
  std::array<Barycentric, 2> ends = { randomWeights(random), randomWeights(random) };
  if (random.chance(0.4))
  {
    const Index k = random.below(3);
    for (std::size_t i = 0; i < 2; ++i)
    {
      const double u = random.chance(0.5) ? static_cast<double>(i) : random.uniform();
      ends[i] = { 0.0, 0.0, 0.0 };
      ends[i][k] = 1.0 - u;
      ends[i][(k + 1) % 3] = u;
    }
  }
  return ends;
}

/// A segment in a face, and the engine's envelope along it.
struct Along
{
  Index face;
  std::array<Barycentric, 2> ends;
  double length;
  std::vector<Window> windows;
};

Barycentric between(const Along& along, double t)
{
  Barycentric place;
  for (std::size_t k = 0; k < 3; ++k)
  {
    place[k] = (1.0 - t) * along.ends[0][k] + t * along.ends[1][k];
  }
  return place;
}

void expectGapless(const Along& along)
{
  ASSERT_FALSE(along.windows.empty());
  EXPECT_EQ(along.windows.front().begin, 0.0);
  EXPECT_EQ(along.windows.back().end, along.length);
  for (std::size_t w = 1; w < along.windows.size(); ++w)
  {
    EXPECT_EQ(along.windows[w - 1].end, along.windows[w].begin);
    EXPECT_LT(along.windows[w].begin, along.windows[w].end);
  }
}

/// Compares the envelope with the least of all candidates at many places.
void expectLeastOfCandidates(const Along& along, const FaceDistance& face, double accuracy)
{
  constexpr int samples = 200;
  const geodesic::Vec2 p = face.inPlane(along.ends[0]);
  const geodesic::Vec2 q = face.inPlane(along.ends[1]);
  for (int s = 0; s <= samples; ++s)
  {
    const double t = static_cast<double>(s) / samples;
    double least = geodesic::Infinity;
    for (const geodesic::DistanceCandidate& candidate : face.candidates())
    {
      least = std::min(least, candidate.distance(p + t * (q - p)));
    }
    ASSERT_NEAR(at(along.windows, t * along.length), std::max(least, 0.0), accuracy)
      << "face " << along.face << ", t " << t;
  }
}

constexpr int SamplesOfASegment = 16;

/// Compares the envelopes with brute force, segment by segment.
std::vector<MeshPoint> samplesOf(const std::vector<Along>& all)
{
  std::vector<MeshPoint> places;
  for (const Along& along : all)
  {
    for (int s = 0; s <= SamplesOfASegment; ++s)
    {
      places.push_back({ along.face, between(along, static_cast<double>(s) / SamplesOfASegment) });
    }
  }
  return places;
}

/// Checks where the distance along a segment is below its value at one of the segment's points.
void expectCrossings(SegmentEnvelope& envelope, const FaceDistance& face, geodesic::Vec2 p,
  geodesic::Vec2 q, double place, double accuracy)
{
  const auto distance = [&](double t) { return face.distance(p + t * (q - p)); };
  const double value = distance(place);
  const double length = norm(q - p);
  const bool beginsBelow = distance(0.0) < value;
  const bool endsBelow = distance(1.0) < value;
  std::vector<geodesic::SegmentCrossing> crossings;
  envelope.findCrossings(face, p, q, value, beginsBelow, endsBelow, crossings);
  bool isBelow = beginsBelow;
  double before = 0.0;
  for (const geodesic::SegmentCrossing& crossing : crossings)
  {
    EXPECT_EQ(crossing.rises, isBelow);
    EXPECT_GE(crossing.at, before);
    EXPECT_LE(crossing.at, length);
    EXPECT_NEAR(distance(crossing.at / length), value, accuracy);
    isBelow = !isBelow;
    before = crossing.at;
  }
  EXPECT_EQ(isBelow, endsBelow);
  for (int s = 0; s <= SamplesOfASegment; ++s)
  {
    const double t = static_cast<double>(s) / SamplesOfASegment;
    const auto passed = std::count_if(crossings.begin(), crossings.end(),
      [&](const geodesic::SegmentCrossing& crossing) { return crossing.at < t * length; });
    if (std::abs(distance(t) - value) > accuracy)
    {
      EXPECT_EQ(beginsBelow != (passed % 2 == 1), distance(t) < value) << "at " << t;
    }
  }
}

/// \returns the largest error.
double compare(const std::vector<Along>& all, const std::vector<double>& truth)
{
  double worst = 0.0;
  std::size_t i = 0;
  for (const Along& along : all)
  {
    for (int s = 0; s <= SamplesOfASegment; ++s)
    {
      const double value = at(along.windows, along.length * s / SamplesOfASegment);
      worst = std::max(worst, std::abs(value - truth[i++]));
    }
  }
  return worst;
}

}

TEST_P(SegmentEnvelopes, AreTheDistanceAlongAnySegmentOfAnyFace)
{
  constexpr std::uint64_t meshes = meshesOfAKind(12);
  constexpr int segments = 80;
  double worst = 0.0;
  for (Random& random : EachSeed(meshes, 500))
  {
    const PlainMesh mesh = GetParam().make(random.between(50, 300), random);
    CurveMaker maker(mesh, random);
    const std::vector<Polyline> curves = maker.anySource();
    const geodesic::TriangleMesh engine = engineMesh(mesh);
    const geodesic::DistanceField field = solveKeepingAll(engine, engineCurves(engine, curves));
    const double largest = largestFinite(field.vertexDistances());
    SegmentEnvelope envelope;
    std::vector<Along> all;
    for (int i = 0; i < segments; ++i)
    {
      const Index id = i < 10 ? curves[0].segments[0].face : random.below(engine.numberOfFaces());
      if (std::isinf(field.vertexDistances()[engine.triangle(id)[0]]))
      {
        continue;
      }
      const FaceDistance face(field, id);
      const std::array<Barycentric, 2> ends = randomSegment(random);
      const geodesic::Vec2 p = face.inPlane(ends[0]);
      const geodesic::Vec2 q = face.inPlane(ends[1]);
      const Along along{ id, ends, norm(q - p), envelope.along(face, p, q) };
      if (!(along.length > 0.0))
      {
        EXPECT_TRUE(along.windows.empty());
        continue;
      }
      expectGapless(along);
      expectLeastOfCandidates(along, face, SegmentAccuracy * largest);
      expectCrossings(envelope, face, p, q, random.uniform(), SegmentAccuracy * largest);
      all.push_back(along);
    }
    const BruteForceResult truth = bruteForceDistances(mesh, toSources(curves), samplesOf(all));
    const double error = compare(all, truth.queries) / largest;
    EXPECT_LE(error, SegmentAccuracy) << describe(curves);
    worst = std::max(worst, error);
  }
  std::cout << "worst relative error on " << GetParam().name << ": " << worst << "\n";
}

namespace
{

/// Compares the envelopes along all edges of a mesh of a kind with the distance in the faces.
void expectDistanceAlongAllEdges(const MeshKind& kind, std::uint64_t seed)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const PlainMesh mesh = kind.make(randomSize(random), random);
  CurveMaker maker(mesh, random);
  const geodesic::TriangleMesh engine = engineMesh(mesh);
  const geodesic::DistanceField field =
    solveKeepingAll(engine, engineCurves(engine, maker.anySource()));
  const double largest = largestFinite(field.vertexDistances());
  SegmentEnvelope envelope;
  for (geodesic::Id id = 0; id < engine.numberOfFaces(); ++id)
  {
    if (std::isinf(field.vertexDistances()[engine.triangle(id)[0]]))
    {
      continue;
    }
    const FaceDistance face(field, id);
    for (std::size_t k = 0; k < 3; ++k)
    {
      std::array<Barycentric, 2> ends{};
      ends[0][k] = 1.0;
      ends[1][(k + 1) % 3] = 1.0;
      const geodesic::Vec2 p = face.inPlane(ends[0]);
      const geodesic::Vec2 q = face.inPlane(ends[1]);
      const Along along{ id, ends, norm(q - p), envelope.along(face, p, q) };
      if (along.length > 0.0)
      {
        expectLeastOfCandidates(along, face, SegmentAccuracy * largest);
      }
    }
  }
}

}

TEST_P(SegmentEnvelopes, AreTheDistanceAlongAllEdges)
{
  const Seeds seeds = seedsOfTest(meshesOfAKind(12));
  for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
  {
    expectDistanceAlongAllEdges(GetParam(), seed);
  }
  // A point of a curve on an edge sends rays into the whole face, from an end of its window:
  // rounding would give the ray there any direction.
  const std::string name = GetParam().name;
  if (name == "Octasphere" || name == "Tetrahedron")
  {
    expectDistanceAlongAllEdges(GetParam(), 1002);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, SegmentEnvelopes, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });

TEST(FaceDistance, IsRefusedWithoutWindows)
{
  const PlainMesh mesh = regularGrid(2, 2);
  const geodesic::TriangleMesh engine = engineMesh(mesh);
  const Sources corner{ { vertexPoint(mesh, 0) }, {} };
  const geodesic::DistanceField field = geodesic::solve(engine, engineCurves(engine, corner));
  EXPECT_THROW(FaceDistance(field, 0), geodesic::Error);
}

TEST(FaceDistance, IsTheSameAfterOtherFaces)
{
  const PlainMesh mesh = regularGrid(4, 4);
  const geodesic::TriangleMesh engine = engineMesh(mesh);
  const Sources source{ { { 7, { 0.2, 0.3, 0.5 } } }, {} };
  const geodesic::DistanceField field = solveKeepingAll(engine, engineCurves(engine, source));
  FaceDistance again(field, 7);
  again.enter(20);
  const FaceDistance fresh(field, 20);
  ASSERT_EQ(again.candidates().size(), fresh.candidates().size());
  const Barycentric place = { 0.2, 0.5, 0.3 };
  EXPECT_EQ(again.distance(again.inPlane(place)), fresh.distance(fresh.inPlane(place)));
}

namespace
{

/// The length of the way through a window to a point over its halfedge.
double throughWindow(const Window& w, double x, double height)
{
  const double crossing = w.sourceX + (x - w.sourceX) * w.sourceDepth / (w.sourceDepth + height);
  const double at = std::clamp(crossing, w.begin, w.end);
  return std::hypot(at - w.sourceX, w.sourceDepth) + std::hypot(x - at, height);
}

/// A face with one window on a halfedge.
geodesic::DistanceField fieldOf(
  const geodesic::TriangleMesh& mesh, geodesic::Id halfedge, const Window& w, double atCorners)
{
  geodesic::FrontResult front;
  front.vertexDistances.assign(3, atCorners);
  geodesic::KeptWindows kept;
  kept.windows.add(halfedge, { &w, &w + 1 });
  kept.windows.index(mesh.numberOfHalfedges());
  return { geodesic::MeshPartition(mesh), std::move(front), std::move(kept) };
}

}

// Beside one end of the halfedge or the other, or below it: its points and those of the face have
// the distance through the window, however shallow its rays are.
TEST(FaceDistance, IsThatThroughAWindowWhoseSourceIsHardlyBelowTheHalfedge)
{
  int onHalfedge = 0;
  for (Random& random : EachSeed(4000))
  {
    const PlainMesh plain = { { { 0, 0, 0 }, { 1, 0, 0 },
                                { random.uniform(-0.5, 1.5), random.uniform(0.1, 1.5), 0 } },
      { { 0, 1, 2 } } };
    const geodesic::TriangleMesh mesh = engineMesh(plain);
    const auto k = static_cast<geodesic::Id>(random.below(3));
    const double length = mesh.length(k);
    Window w{};
    w.kind = Window::Kind::Circular;
    w.begin = random.chance(0.5) ? 0.0 : random.uniform(0.0, 0.4) * length;
    w.end = random.chance(0.5) ? length : random.uniform(0.6, 1.0) * length;
    w.sourceX = random.chance(0.3) ? (random.chance(0.5) ? w.end : w.begin) +
        random.uniform(-1.0, 1.0) * std::pow(10.0, random.uniform(-6.0, 0.0))
                                   : random.uniform(-1.0, 2.0);
    w.sourceDepth = std::pow(10.0, random.uniform(-16.0, -1.0));
    const geodesic::DistanceField field = fieldOf(mesh, k, w, 100.0);
    const FaceDistance face(field, 0);
    for (int i = 0; i < 20; ++i)
    {
      Barycentric place = randomWeights(random);
      if (i % 2 == 0)
      {
        place = {};
        place[(k + 1) % 3] = random.uniform();
        place[k] = 1.0 - place[(k + 1) % 3];
        ++onHalfedge;
      }
      const double x = place[(k + 1) % 3] * length +
        place[(k + 2) % 3] * mesh.length((k + 2) % 3) * std::cos(mesh.cornerAngle(k));
      const double height =
        place[(k + 2) % 3] * mesh.length((k + 2) % 3) * std::sin(mesh.cornerAngle(k));
      EXPECT_NEAR(face.distance(face.inPlane(place)), throughWindow(w, x, height), 1e-8)
        << "at " << x << ", " << height << ", from " << w.sourceX << ", -" << w.sourceDepth
        << " through " << w.begin << " to " << w.end;
    }
  }
  EXPECT_GT(onHalfedge, 0);
}

// The distance then passes the value at the one point.
TEST(SegmentCrossings, OnASegmentWithoutLengthAgreeWithTheEnds)
{
  const geodesic::TriangleMesh mesh =
    engineMesh({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } });
  Window w{};
  w.end = mesh.length(0);
  w.sourceX = 0.5;
  w.sourceDepth = 1.0;
  const geodesic::DistanceField field = fieldOf(mesh, 0, w, 100.0);
  const FaceDistance face(field, 0);
  const geodesic::Vec2 point = face.inPlane({ 0.5, 0.5, 0.0 });
  for (const bool beginsBelow : { false, true })
  {
    for (const bool endsBelow : { false, true })
    {
      SegmentEnvelope envelope;
      std::vector<geodesic::SegmentCrossing> found;
      envelope.findCrossings(face, point, point, w.sourceDepth, beginsBelow, endsBelow, found);
      ASSERT_EQ(found.size(), beginsBelow != endsBelow ? 1U : 0U);
      for (const geodesic::SegmentCrossing& crossing : found)
      {
        EXPECT_EQ(crossing.at, 0.0);
        EXPECT_EQ(crossing.rises, beginsBelow);
      }
    }
  }
}
