// SPDX-License-Identifier: BSD-3-Clause
#include "truth/RandomMeshKinds.h"

#include <algorithm>
#include <cmath>
#include <ostream>

namespace geodesictest
{

namespace
{

/// Cells along one side of a roughly square sheet.
Index side(double faces, Random& random)
{
  return static_cast<Index>(
    std::max(3.0, std::round(std::sqrt(0.5 * faces) * random.uniform(0.8, 1.2))));
}

/// Both sides of a sheet. The arguments of a call would draw their random numbers in an order that
/// each compiler chooses.
struct Sides
{
  Index y;
  Index x;
  Sides(double faces, Random& random)
    : y(side(faces, random))
    , x(side(faces, random))
  {
  }
};

PlainMesh anySheet(Index faces, double amplitude, Random& random)
{
  const Sides n(faces, random);
  return bumpySheet(n.x, n.y, 0, amplitude, random);
}

PlainMesh needles(Index faces, double exponent, Random& random)
{
  const double aspect = std::pow(10.0, exponent + random.uniform());
  const Sides n(faces, random);
  return needleSheet(n.x, n.y, aspect, 0.3, random);
}

const std::vector<MeshKind> Kinds = {
  { "RegularGrid",
    [](Index faces, Random& random)
    {
      const Sides n(faces, random);
      return regularGrid(n.x, n.y);
    } },
  { "RandomPlanar",
    [](Index faces, Random& random)
    {
      const Sides n(faces, random);
      return moved(randomPlanar(n.x, n.y, random), random);
    } },
  { "PlanarWithHoles",
    [](Index faces, Random& random)
    {
      const Index holes = random.between(1, 6);
      const Sides n(faces, random);
      return planarWithHoles(n.x, n.y, holes, random);
    } },
  { "LShape",
    [](Index faces, Random& random)
    {
      const Sides n(faces / 3.0, random);
      return lShape(2 * n.x, 2 * n.y);
    } },
  { "Octasphere",
    [](Index faces, Random&)
    { return octasphere(static_cast<Index>(std::max(2.0, std::sqrt(faces / 8.0)))); } },
  { "BumpySheet", [](Index faces, Random& random) { return anySheet(faces, 0.5, random); } },
  { "BumpySheetWithHoles",
    [](Index faces, Random& random)
    {
      const double amplitude = random.uniform(0.2, 1.0);
      const Index holes = random.between(1, 5);
      const Sides n(faces, random);
      return bumpySheet(n.x, n.y, holes, amplitude, random);
    } },
  { "WildSheet", [](Index faces, Random& random) { return anySheet(faces, 3.0, random); } },
  { "NearlyFlatSheet",
    [](Index faces, Random& random)
    { return anySheet(faces, std::pow(10.0, -random.uniform(2.0, 9.0)), random); } },
  { "Needles", [](Index faces, Random& random) { return needles(faces, 3.0, random); } },
  { "ThinNeedles", [](Index faces, Random& random) { return needles(faces, 4.0, random); } },
  { "Book",
    [](Index faces, Random& random)
    {
      const Index pages = random.between(3, 5);
      const Sides n(faces / pages, random);
      return book(pages, n.x, n.y, 0.4, random);
    } },
  { "FlatBook",
    [](Index faces, Random& random)
    {
      const Index pages = random.between(3, 5);
      const Sides n(faces / pages, random);
      return book(pages, n.x, n.y, 0.0, random);
    } },
  { "MoebiusStrip",
    [](Index faces, Random& random)
    {
      const Index width = random.between(2, 6);
      return moebius(std::max<Index>(faces / (2 * width), 3 * width), width);
    } },
  { "BowTie",
    [](Index faces, Random& random)
    {
      const PlainMesh a = anySheet(faces / 2, 0.5, random);
      const PlainMesh b = anySheet(faces / 2, 0.5, random);
      const Index ofB = random.below(b.points.size());
      return joinedAtVertex(a, random.below(a.points.size()), b, ofB);
    } },
  { "Box",
    [](Index faces, Random& random)
    {
      const double n = std::sqrt(faces / 12.0);
      std::array<Index, 3> cells{};
      Vec3 size{};
      for (Index k = 0; k < 3; ++k)
      {
        cells[k] = static_cast<Index>(std::max(1.0, n * random.uniform(0.7, 1.3)));
        size[k] = random.chance(0.5) ? cells[k] : random.uniform(0.5, 5.0);
      }
      return box(size, cells);
    } },
  { "OpenCylinder",
    [](Index faces, Random& random)
    {
      const Index sides = std::max<Index>(3, side(faces, random));
      const double height = random.uniform(0.5, 2.0) * sides;
      return openCylinder(sides, side(faces, random), height);
    } },
  { "Tetrahedron",
    [](Index faces, Random&) { return tetrahedron(static_cast<Index>(std::sqrt(faces / 4.0))); } },
  { "SaddleFans",
    [](Index faces, Random& random)
    {
      const Index sectors = 2 * random.between(4, 7);
      const double angle = random.uniform(1.01, 1.9) * 6.28318530717958648 / sectors;
      const Index n = static_cast<Index>(std::max(2.0, std::sqrt(0.5 * faces / sectors)));
      const PlainMesh a = fan(sectors, angle, n);
      const PlainMesh b = fan(sectors, angle, n);
      const Index ofB = random.below(b.points.size());
      return joinedAtVertex(a, random.below(a.points.size()), b, ofB);
    } },
  { "SplitAndMixedComponents",
    [](Index faces, Random& random)
    {
      const PlainMesh a = withSplitEdges(anySheet(faces / 4, 0.5, random), 0.4, random);
      const PlainMesh b = withSplitFaces(octasphere(3), 0.5, random);
      return withFlippedFaces(renumbered(merged(a, b), random).mesh, random);
    } },
};

#ifdef GEODESIC_FEW_KINDS
std::vector<MeshKind> everyThird(const std::vector<MeshKind>& kinds)
{
  std::vector<MeshKind> some;
  for (std::size_t i = 0; i < kinds.size(); i += 3)
  {
    some.push_back(kinds[i]);
  }
  return some;
}
#endif

} // anonymous namespace

std::ostream& operator<<(std::ostream& os, const MeshKind& kind)
{
  return os << kind.name;
}

const std::vector<MeshKind>& meshKinds()
{
#ifdef GEODESIC_FEW_KINDS
  static const std::vector<MeshKind> few = everyThird(Kinds);
  return few;
#else
  return Kinds;
#endif
}

Index randomSize(Random& random)
{
  return random.chance(0.9) ? random.between(50, 500) : random.between(500, 1900);
}

}
