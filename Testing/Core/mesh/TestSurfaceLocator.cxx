// SPDX-License-Identifier: BSD-3-Clause
// The locator finds all equally close faces, like a scan of all faces.
#include "EngineSupport.h"
#include "Watched.h"

#include "Errors.h"
#include "Trigonometry.h"
#include "mesh/SurfaceLocator.h"
#include "mesh/SurfaceSnap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace geodesic;
using geodesictest::engineMesh;
using geodesictest::PlainMesh;
using geodesictest::Random;

constexpr double Epsilon = std::numeric_limits<double>::epsilon();
constexpr double FloatEpsilon = std::numeric_limits<float>::epsilon();

/// Finds the closest faces of a mesh.
class Locator
{
public:
  explicit Locator(const TriangleMesh& mesh)
    : locator_(MeshPartition(mesh))
  {
  }

  std::vector<Id> closest(const Vec3& point, double precision, const Job& job = {})
  {
    std::vector<Id> faces;
    const ClosestFaces closest = this->locator_.closest({ point }, { 1 }, precision, job);
    for (const ClosestFace& found : closest.front())
    {
      faces.push_back(found.face.id);
    }
    return faces;
  }

private:
  SurfaceLocator locator_;
};

double distanceOf(const TriangleMesh& mesh, Id face, const Vec3& point)
{
  return snapToFace(mesh, face, point, 0.0).distance;
}

double leastDistance(const TriangleMesh& mesh, const Vec3& point)
{
  double least = Infinity;
  for (Id face = 0; face < mesh.numberOfFaces(); ++face)
  {
    least = std::min(least, distanceOf(mesh, face, point));
  }
  return least;
}

Vec3 placeOf(const TriangleMesh& mesh, Id face, const Vec3& point, double precision)
{
  return position(mesh, snapToFace(mesh, face, point, precision).place);
}

Vec3 randomPoint(Random& random, double size)
{
  return { random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size) };
}

/// Checks that the locator finds all faces that are as close as the closest up to half a rounding
/// (or less than a tenth of their longest edge), except those that put a point beside the surface
/// elsewhere, and none that is farther by more than some roundings.
void expectAllClosest(
  const TriangleMesh& mesh, Locator& locator, const Vec3& point, double precision, double size)
{
  const std::vector<Id> found = locator.closest(point, precision);
  const double least = leastDistance(mesh, point);
  ASSERT_FALSE(found.empty());
  for (Id face = 0; face < mesh.numberOfFaces(); ++face)
  {
    const double over = distanceOf(mesh, face, point) - least;
    const bool isFound = std::find(found.begin(), found.end(), face) != found.end();
    const double surely = std::min(0.5 * Epsilon * size, 0.09 * mesh.shape(face).longest());
    const Vec3 place = placeOf(mesh, face, point, precision);
    const bool isElsewhere = least > surely &&
      std::any_of(found.begin(), found.end(),
        [&](Id other) { return norm(placeOf(mesh, other, point, 0.0) - place) > surely; });
    EXPECT_TRUE(isFound || over > surely || isElsewhere);
    EXPECT_TRUE(!isFound || over <= 8.0 * precision * size);
  }
  EXPECT_EQ(locator.closest(point, precision), found);
}

void expectAllClosest(const TriangleMesh& mesh, double size)
{
  Locator locator(mesh);
  Random random(11);
  for (int i = 0; i < 200; ++i)
  {
    const auto vertex = static_cast<Id>(random.uniform(0.0, 1.0) * mesh.numberOfVertices());
    const Vec3 point = i % 4 == 0 ? mesh.point(vertex) : randomPoint(random, 1.5 * size);
    expectAllClosest(mesh, locator, point, i % 2 == 0 ? Epsilon : FloatEpsilon, 2.0 * size);
  }
}

/// A strip of triangles, each smaller than the previous one by a factor.
TriangleMesh shrinkingStrip(Id count, double factor)
{
  std::vector<Vec3> points;
  double x = 1.0;
  for (Id i = 0; i < count + 2; ++i, x *= factor)
  {
    points.push_back({ x, i % 2 == 0 ? 0.0 : x, 0.5 * x });
  }
  std::vector<Triangle> triangles;
  for (Id i = 0; i < count; ++i)
  {
    triangles.push_back({ i, i + 1, i + 2 });
  }
  return { points, triangles };
}

TEST(SurfaceLocator, FindsAllClosestFacesOfACrowdedStrip)
{
  expectAllClosest(shrinkingStrip(300, 0.9), 1.0);
  expectAllClosest(shrinkingStrip(300, 0.5), 1.0);
}

TEST(SurfaceLocator, FindsAllClosestFacesOfASphereAndOfSheetsThatCross)
{
  expectAllClosest(engineMesh(geodesictest::octasphere(6)), 1.0);
  Random random(12);
  PlainMesh sheets = geodesictest::bumpySheet(8, 8, 0, 0.4, random);
  sheets = geodesictest::merged(sheets, geodesictest::moved(sheets, random));
  sheets = geodesictest::merged(sheets, sheets);
  expectAllClosest(engineMesh(sheets), 8.0);
}

TEST(SurfaceLocator, AtAVertexItsFacesAreFoundInOrder)
{
  const TriangleMesh mesh = engineMesh(geodesictest::regularGrid(4, 4));
  Locator locator(mesh);
  std::vector<Id> around;
  for (const Id corner : mesh.cornersAt(12))
  {
    around.push_back(TriangleMesh::faceOf(corner));
  }
  std::sort(around.begin(), around.end());
  EXPECT_EQ(locator.closest(mesh.point(12), Epsilon), around);
}

TEST(SurfaceLocator, FacesWithoutAreaCountWhereThereAreNoOthers)
{
  // The second triangle lies in the first one's edge, the third is separate.
  const TriangleMesh mesh({ { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 0 }, { 1, 0, 0 },
                            { 2, 0, 0 }, { 0, 5, 0 }, { 1, 5, 0 }, { 0, 5, 0 } },
    { { 0, 1, 2 }, { 3, 4, 5 }, { 6, 7, 8 } });
  Locator locator(mesh);
  EXPECT_EQ(locator.closest({ 0.7, 0.0, 0.0 }, Epsilon), (std::vector<Id>{ 0 }));
  EXPECT_EQ(locator.closest({ 0.7, -0.2, 0.1 }, Epsilon), (std::vector<Id>{ 0 }));
  EXPECT_EQ(locator.closest({ 0.7, 0.3, 0.0 }, Epsilon), (std::vector<Id>{ 0 }));
  EXPECT_EQ(locator.closest({ 0.5, 5.1, 0.0 }, Epsilon), (std::vector<Id>{ 2 }));
}

// From so far, and so nearly from above, each of three faces has its closest point on an edge that
// it shares with the next one, although by more than rounding none is closer than the others.
TEST(SurfaceLocator, FacesThatEachLoseToAnotherByRoundingAreAllFound)
{
  int eachLoses = 0;
  for (Random& random : geodesictest::EachSeed(2000))
  {
    const double far = std::pow(10.0, random.uniform(8.0, 9.0));
    const double slope = std::pow(10.0, random.uniform(-9.0, -7.0));
    std::vector<Vec3> points = { { 0, 0, 0 } };
    for (int i = 0; i < 3; ++i)
    {
      const double angle = (2.0 * i + random.uniform(-0.5, 0.5)) / 3.0 * Pi;
      const double length = random.uniform(0.5, 2.0);
      points.push_back(
        { length * std::cos(angle), length * std::sin(angle), random.uniform(-slope, slope) });
    }
    const TriangleMesh mesh(points, { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 } });
    const double aside = 0.5 * slope * far;
    const Vec3 point = { random.uniform(-aside, aside), random.uniform(-aside, aside), far };
    const auto support = [&](Id face)
    { return barycentric(mesh, snapToFace(mesh, face, point, 0.0).place, face); };
    const std::array<Barycentric, 3> at = { support(0), support(1), support(2) };
    // Face k has the vertices 0, 1 + k and 1 + (k + 1) % 3.
    const auto isAlong = [&](std::size_t corner, std::size_t other)
    {
      return std::all_of(at.begin(), at.end(),
        [&](const Barycentric& b) { return b[0] > 0.0 && b[corner] > 0.0 && b[other] == 0.0; });
    };
    if (isAlong(1, 2) || isAlong(2, 1))
    {
      ++eachLoses;
      EXPECT_EQ(Locator(mesh).closest(point, Epsilon), (std::vector<Id>{ 0, 1, 2 }));
    }
  }
  EXPECT_GT(eachLoses, 0);
}

TEST(SurfaceLocator, HalfwayBetweenSheetsBothAreFound)
{
  PlainMesh sheet = geodesictest::regularGrid(3, 3);
  PlainMesh above = sheet;
  for (Vec3& p : above.points)
  {
    p[2] = 1.0;
  }
  const TriangleMesh mesh = engineMesh(geodesictest::merged(sheet, above));
  Locator locator(mesh);
  EXPECT_EQ(locator.closest({ 0.6, 0.2, 0.5 }, Epsilon), (std::vector<Id>{ 0, 18 }));
  EXPECT_EQ(locator.closest({ 0.6, 0.2, 0.4 }, Epsilon), (std::vector<Id>{ 0 }));
}

TEST(SurfaceLocator, BesideTheSurfaceAFaceThatIsAlmostAsCloseIsNotChosen)
{
  // Over the first of two faces, which are bent by slightly less than the precision.
  const TriangleMesh mesh(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1, 0 }, { 0.5, -1, -0.1 } }, { { 0, 2, 1 }, { 0, 1, 3 } });
  Locator locator(mesh);
  for (const double away : { 1e-4, 1e-9 })
  {
    const double precision = away > 1e-6 ? FloatEpsilon : Epsilon;
    const std::vector<Id> beside = { 0 };
    EXPECT_EQ(locator.closest({ 0.5, away, 0.5 }, precision), beside);
    // On the edge, as seen from both faces.
    EXPECT_EQ(locator.closest({ 0.5, 0, 0.5 }, precision), (std::vector<Id>{ 0, 1 }));
    // On the surface within the precision.
    EXPECT_EQ(locator.closest({ 0.5, 0.5 * precision, 0 }, precision), (std::vector<Id>{ 0, 1 }));
  }
}

TEST(SurfaceLocator, ThePrecisionOfThePointDecidesWhichFacesAreEquallyClose)
{
  for (const double scale : { 0x1p-60, 1.0, 0x1p60 })
  {
    PlainMesh sheet = geodesictest::regularGrid(3, 3);
    PlainMesh above = sheet;
    for (Vec3& p : above.points)
    {
      p[2] = 1e-9;
    }
    const TriangleMesh mesh =
      engineMesh(geodesictest::scaled(geodesictest::merged(above, sheet), scale));
    Locator locator(mesh);
    const Vec3 point{ 0.6 * scale, 0.2 * scale, 0.0 };
    EXPECT_EQ(locator.closest(point, Epsilon), (std::vector<Id>{ 18 }));
    // The closer one comes first.
    EXPECT_EQ(locator.closest(point, FloatEpsilon), (std::vector<Id>{ 18, 0 }));
  }
}

TEST(SurfaceLocator, FarFromTheOriginTheClosestFaceComesFirstAndFarOnesAreNoChoice)
{
  PlainMesh plain = geodesictest::regularGrid(6, 6);
  for (Vec3& p : plain.points)
  {
    p = p + Vec3{ 3e6, -5e6, 1e6 };
  }
  const TriangleMesh mesh = engineMesh(plain);
  Locator locator(mesh);
  // Roundings of 32 bits exceed an edge's length there.
  const Vec3 point = mesh.point(0) + Vec3{ 2.6, 3.3, 0.0 };
  const std::vector<Id> found = locator.closest(point, FloatEpsilon);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(distanceOf(mesh, found.front(), point), 0.0);
  for (const Id face : found)
  {
    EXPECT_LE(distanceOf(mesh, face, point), 0.1 * std::sqrt(2.0));
  }
}

TEST(SurfaceLocator, ItsWatcherSeesNoFallAndStopsTheSearch)
{
  const TriangleMesh mesh = shrinkingStrip(2000, 0.99);
  const Vec3 point{ 0.3, 0.2, 0.1 };
  geodesictest::expectWatched(
    4, [&](const Job& job) { Locator(mesh).closest(point, Epsilon, job); });
  Locator locator(mesh);
  EXPECT_THROW(locator.closest(point, Epsilon, Job([](double) { return false; })), Aborted);
  expectAllClosest(mesh, locator, point, Epsilon, 1.0);
}

}
