// SPDX-License-Identifier: BSD-3-Clause
// The chosen places of a polyline are the best of all, compared with trying all of them.
#include "EngineSupport.h"

#include "source/PlaceChoice.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <map>
#include <tuple>

namespace
{

using namespace geodesic;
using geodesictest::engineMesh;
using geodesictest::PlainMesh;
using geodesictest::Random;

/// The costs of a way, the most important first.
using Worth = std::tuple<int, int, int, double, int>;

/// A surface with possible places of some points, and the lengths of all joins.
struct Problem
{
  const TriangleMesh& mesh;
  std::vector<PossiblePlaces> places;
  bool closed;
  std::vector<Id> components;
  std::map<std::array<std::size_t, 3>, double> lengths;

  std::size_t steps() const { return this->places.size() - (this->closed ? 0 : 1); }
  std::size_t next(std::size_t i) const { return (i + 1) % this->places.size(); }
  Id componentOf(const SurfacePoint& p) const
  {
    return this->components[this->mesh.triangle(someFace(this->mesh, p))[0]];
  }
};

Worth worthOf(const Problem& problem, const std::vector<ChosenPlaces>& chosen)
{
  int disconnected = 0;
  int gaps = 0;
  int changes = 0;
  double length = 0.0;
  int dimensions = 0;
  for (std::size_t i = 0; i < problem.steps(); ++i)
  {
    const std::size_t j = problem.next(i);
    const SurfacePoint& from = problem.places[i][chosen[i].departure];
    const SurfacePoint& to = problem.places[j][chosen[j].arrival];
    if (problem.componentOf(from) != problem.componentOf(to))
    {
      ++disconnected;
    }
    else if (commonFace(problem.mesh, from, to) == NoId)
    {
      ++gaps;
      length += problem.lengths.at({ i, chosen[i].departure, chosen[j].arrival });
    }
  }
  for (std::size_t i = 0; i < problem.places.size(); ++i)
  {
    dimensions += static_cast<int>(problem.places[i][chosen[i].arrival].kind);
    if (chosen[i].arrival != chosen[i].departure)
    {
      ++changes;
      dimensions += static_cast<int>(problem.places[i][chosen[i].departure].kind);
    }
  }
  return { disconnected, gaps, changes, length, dimensions };
}

/// Tries all places, from the point `at` on.
Worth leastWorth(const Problem& problem, std::vector<ChosenPlaces>& chosen, std::size_t at = 0)
{
  if (at == chosen.size())
  {
    return worthOf(problem, chosen);
  }
  const bool isEnd = !problem.closed && (at == 0 || at + 1 == chosen.size());
  Worth least{ 1000, 0, 0, 0.0, 0 };
  for (std::size_t a = 0; a < problem.places[at].size(); ++a)
  {
    for (std::size_t b = 0; b < problem.places[at].size(); ++b)
    {
      if (a == b || !isEnd)
      {
        chosen[at] = { a, b };
        least = std::min(least, leastWorth(problem, chosen, at + 1));
      }
    }
  }
  return least;
}

/// Lengths are whole numbers, so that sums are exact and many ways tie.
Problem randomProblem(const PlainMesh& plain, const TriangleMesh& mesh, Random& random)
{
  const auto whole = [&random](int most)
  { return static_cast<std::size_t>(random.uniform(0.0, 1.0) * most); };
  Problem problem{ mesh, {}, whole(2) == 0, mesh.components(), {} };
  problem.places.resize(2 + whole(4));
  for (PossiblePlaces& places : problem.places)
  {
    for (std::size_t k = whole(3) == 0 ? 1 : 1 + whole(3); k > 0; --k)
    {
      places.push_back(enginePoint(mesh, geodesictest::randomPoints(plain, 1, random)[0]));
    }
  }
  for (std::size_t i = 0; i < problem.places.size(); ++i)
  {
    for (std::size_t a = 0; a < problem.places[i].size(); ++a)
    {
      for (std::size_t b = 0; b < problem.places[problem.next(i)].size(); ++b)
      {
        problem.lengths[{ i, a, b }] = 1.0 + static_cast<double>(whole(4));
      }
    }
  }
  return problem;
}

TEST(PlaceChoice, ASinglePointTakesAVertexBeforeAnEdgeBeforeAFace)
{
  const TriangleMesh mesh = engineMesh(geodesictest::regularGrid(2, 2));
  geodesic::MeshComponents components(mesh);
  const SurfacePoint face = SurfacePoint::inFace(0, 0.25, 0.25);
  const SurfacePoint edge = SurfacePoint::onEdge(0, 0.5);
  const SurfacePoint vertex = SurfacePoint::atVertex(0);
  const auto choiceOf = [&](const PossiblePlaces& places)
  { return choosePlaces(mesh, { places }, false, components, {}).front().departure; };
  EXPECT_EQ(choiceOf({ face, edge, vertex, vertex }), 2u);
  EXPECT_EQ(choiceOf({ face, face, edge }), 2u);
  EXPECT_EQ(choiceOf({ face, face }), 0u);
}

TEST(PlaceChoice, IsTheBestOfAll)
{
  Random random(21);
  const PlainMesh square = geodesictest::regularGrid(1, 1);
  const PlainMesh strip = geodesictest::regularGrid(3, 1);
  const std::vector<PlainMesh> surfaces = { square, strip, geodesictest::merged(square, square),
    geodesictest::merged(strip, square), geodesictest::book(3, 2, 1, 0.2, random) };
  int choices = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const PlainMesh& plain = surfaces[static_cast<std::size_t>(i) % surfaces.size()];
    const TriangleMesh mesh = engineMesh(plain);
    const Problem problem = randomProblem(plain, mesh, random);
    geodesic::MeshComponents components(mesh);
    const std::vector<ChosenPlaces> chosen =
      choosePlaces(mesh, problem.places, problem.closed, components,
        [&](std::size_t point, std::size_t from, std::size_t to) {
          return problem.lengths.at({ point, from, to });
        });
    ASSERT_EQ(chosen.size(), problem.places.size());
    if (!problem.closed)
    {
      EXPECT_EQ(chosen.front().arrival, chosen.front().departure);
      EXPECT_EQ(chosen.back().arrival, chosen.back().departure);
    }
    std::vector<ChosenPlaces> tried(problem.places.size());
    EXPECT_EQ(worthOf(problem, chosen), leastWorth(problem, tried)) << "problem " << i;
    choices +=
      worthOf(problem, chosen) < worthOf(problem, std::vector<ChosenPlaces>(problem.places.size()))
      ? 1
      : 0;
  }
  EXPECT_GT(choices, 500); // in which the first places are not the best
}

TEST(PlaceChoice, OfEquallyGoodPlacesTheFirstAreTaken)
{
  const PlainMesh sheet = geodesictest::regularGrid(2, 2);
  const TriangleMesh mesh = engineMesh(geodesictest::merged(sheet, sheet));
  geodesic::MeshComponents components(mesh);
  const PossiblePlaces both = { SurfacePoint::inFace(0, 0.3, 0.3),
    SurfacePoint::inFace(8, 0.3, 0.3) };
  const PossiblePlaces turned = { both[1], both[0] };
  const auto never = [](std::size_t, std::size_t, std::size_t) { return 0.0; };
  for (const bool closed : { false, true })
  {
    for (const ChosenPlaces& c :
      choosePlaces(mesh, { both, both, both, both }, closed, components, never))
    {
      EXPECT_EQ(c.arrival, 0u);
      EXPECT_EQ(c.departure, 0u);
    }
    const auto chosen = choosePlaces(mesh, { both, turned, both }, closed, components, never);
    EXPECT_EQ(chosen[0].departure, chosen[2].arrival);
    EXPECT_NE(chosen[0].departure, chosen[1].arrival);
  }
}

// On the first sheet the points lie in a face, at a vertex and on an edge; on the second at a
// vertex and in a face twice.
TEST(PlaceChoice, AClosedPolylineCountsTheDimensionOfItsFirstPlaceOnce)
{
  const PlainMesh sheet = geodesictest::regularGrid(1, 1);
  const TriangleMesh mesh = engineMesh(geodesictest::merged(sheet, sheet));
  geodesic::MeshComponents components(mesh);
  const SurfacePoint inside = SurfacePoint::inFace(2, 0.3, 0.3);
  const std::vector<PossiblePlaces> places = { { SurfacePoint::inFace(0, 0.3, 0.3),
                                                 SurfacePoint::atVertex(mesh.triangle(2)[0]) },
    { SurfacePoint::atVertex(mesh.triangle(0)[0]), inside },
    { SurfacePoint::onEdge(0, 0.5), inside } };
  for (const ChosenPlaces& c : choosePlaces(mesh, places, true, components, {}))
  {
    EXPECT_EQ(c.arrival, 0u);
    EXPECT_EQ(c.departure, 0u);
  }
}

// Of two sheets with the same way to the last point, one has a vertex where the other has none.
TEST(PlaceChoice, LengthsThatDifferByRoundingTie)
{
  const TriangleMesh mesh = engineMesh(geodesictest::regularGrid(6, 1));
  geodesic::MeshComponents components(mesh);
  const PossiblePlaces first = { SurfacePoint::inFace(0, 0.3, 0.3) };
  const PossiblePlaces last = { SurfacePoint::inFace(11, 0.3, 0.3),
    SurfacePoint::atVertex(mesh.triangle(11)[1]) };
  const auto placeFor = [&](double relativeDifference)
  {
    return choosePlaces(mesh, { first, last }, false, components,
      [&](std::size_t, std::size_t, std::size_t to)
      { return to == 0 ? 1.0 : 1.0 + relativeDifference; })[1]
      .arrival;
  };
  EXPECT_EQ(placeFor(-1e-9), 1u);
  EXPECT_EQ(placeFor(0.0), 1u);
  EXPECT_EQ(placeFor(DBL_EPSILON), 1u) << "a vertex, but for rounding as near";
  EXPECT_EQ(placeFor(1e-9), 0u) << "longer";
}

TEST(PlaceChoice, LengthsAreAskedForOnlyOnWaysWithTheFewestBreaks)
{
  const PlainMesh sheet = geodesictest::regularGrid(6, 1);
  const TriangleMesh mesh = engineMesh(geodesictest::merged(sheet, sheet));
  geodesic::MeshComponents components(mesh);
  std::vector<std::array<std::size_t, 3>> asked;
  const auto length = [&asked](std::size_t point, std::size_t from, std::size_t to)
  {
    asked.push_back({ point, from, to });
    return 1.0;
  };
  const PossiblePlaces first = { SurfacePoint::inFace(0, 0.3, 0.3),
    SurfacePoint::inFace(12, 0.3, 0.3) };
  const PossiblePlaces last = { SurfacePoint::inFace(23, 0.3, 0.3) };
  // All in one face, or in another.
  EXPECT_EQ(choosePlaces(mesh, { first, first }, false, components, length)[1].arrival, 0u);
  EXPECT_TRUE(asked.empty());
  // Far from each other, but on the second sheet alone.
  EXPECT_EQ(choosePlaces(mesh, { first, last }, false, components, length)[0].departure, 1u);
  EXPECT_EQ(asked, (std::vector<std::array<std::size_t, 3>>{ { 0, 1, 0 } }));
}

}
