// SPDX-License-Identifier: BSD-3-Clause
// Under MPI: cracks are closed, and reported, as in one process, wherever ranks cut the surface.
#include "CrackTesting.h"
#include "GeodesicTesting.h"
#include "RanksTesting.h"

#include <cmath>
#include <string>

using namespace GeodesicTesting;

namespace
{

/// Slices of the surface's faces in their order, which are pieces of any shape, or faces at random.
Cut SomeCut(vtkPolyData* surface, int count, bool isRandom)
{
  const vtkIdType faces = surface->GetNumberOfPolys();
  return isRandom
    ? AtRandom(count)
    : Cut([faces, count](vtkIdType face) { return static_cast<int>(face * count / faces); });
}

void TestRandom(Check& check, Ranks ranks)
{
  const geodesictest::Seeds seeds = geodesictest::seedsOfTest(20);
  double worst = 0.0;
  for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
  {
    const Cracked cracked = MakeCracked(seed);
    const std::string what = "seed " + std::to_string(seed) + ", " + cracked.Name;
    const Cut cut = SomeCut(cracked.Surface, ranks.Count, seed % 2 == 0);
    const auto piece = Part(cracked.Surface, FacesOf(cracked.Surface, cut, ranks.Rank));
    worst = std::max(worst, CheckClosed(check, cracked, piece, what));
  }
  std::cout << "cracks over ranks: worst error " << worst << " of what roundings explain\n";
}

/// Two halves of a square with a gap between them, as wide as a millionth of an edge.
vtkSmartPointer<vtkPolyData> WithGap(int n)
{
  auto whole = Soup(Square(n));
  for (vtkIdType face = 0; face < whole->GetNumberOfPolys(); ++face)
  {
    const bool isMoved = CentreOf(whole, face)[0] > .5;
    for (vtkIdType i = 3 * face; isMoved && i < 3 * face + 3; ++i)
    {
      const Point p = PointAt(whole, i);
      whole->GetPoints()->SetPoint(i, p[0] + 1e-7, p[1], p[2]);
    }
  }
  return whole;
}

void TestGap(Check& check, Ranks ranks)
{
  constexpr int n = 8;
  const auto surface = WithGap(n);
  for (const bool isRandom : { false, true })
  {
    const Cut cut = isRandom ? AtRandom(ranks.Count) : Strips(surface, ranks.Count);
    const auto filter =
      PlainField(PieceOf(surface, cut, ranks.Rank), PointSources({ { 0, 0, 0 } }));
    Messages messages(filter);
    messages.Update();
    const std::string edges = std::to_string(2 * n) + " boundary edges";
    check.That(ranks.Rank > 0 || Contains(messages.Warning(), edges),
      "an open gap is reported by the first rank: " + messages.Warning());
    filter->SetMergeTolerance(2e-7);
    messages.ExpectNoWarning(check, "no gap is left");
    check.Equal(filter->GetSeamPointsJoined(), n + 1.0, "points at the gap");
    if (filter->GetOutput()->GetNumberOfPoints() > 0)
    {
      CheckDistances(
        check, filter, [](const Point& p) { return std::hypot(p[0], p[1]); }, "a closed gap", 1e-6);
    }
  }
}

}

int TestGeodesicRanksCracks(int argc, char* argv[])
{
  return RunOnRanks(argc, argv,
    [](Check& check, Ranks ranks)
    {
      TestRandom(check, ranks);
      TestGap(check, ranks);
    });
}
