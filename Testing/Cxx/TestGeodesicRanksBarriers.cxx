// SPDX-License-Identifier: BSD-3-Clause
// Under MPI: barriers of a surface of which each rank has a piece are those of the whole, whichever
// rank has them: distances are the brute-force solver's and those of one process, and so are loops
// of the boundary and errors.
#include "BarrierTesting.h"
#include "RandomBarriers.h"
#include "RanksTesting.h"

#include "vtkMultiProcessController.h"

#include <cmath>
#include <limits>

using namespace GeodesicTesting;

namespace
{

const std::vector<std::string> CutNames = { "in space", "at random",
  "barriers on a rank of their own" };

/// Random meshes, random barriers, random sources and cuts.
void TestRandomMeshes(Check& check, Ranks ranks)
{
  double worst = 0.0;
  for (const geodesictest::MeshKind& kind : geodesictest::meshKinds())
  {
    for (std::uint64_t seed = 0; seed < 8; ++seed)
    {
      RandomCase alone(kind, seed);
      alone.filter->RefineMeshOff();
      alone.filter->SetController(nullptr);
      if (!alone.CanRun(check))
      {
        continue;
      }
      if (alone.IsSourceOpen())
      {
        std::cout << alone.name << " is at its source above itself: left out\n";
        continue;
      }
      const std::vector<double> truth =
        geodesictest::bruteForceDistances(alone.made.open, alone.sources).vertices;
      const double largest = LargestFinite(truth);
      const auto whole = vtkPolyData::SafeDownCast(alone.filter->GetInputDataObject(0, 0));
      for (const auto& [cutName, cut] : Cuts(whole, ranks, CutNames))
      {
        RandomCase one(kind, seed);
        one.filter->RefineMeshOff();
        one.filter->SetInputData(PieceOf(whole, cut, ranks.Rank, true));
        const std::string what = one.name + ", " + cutName;
        if (!one.CanRun(check))
        {
          continue;
        }
        vtkDataArray* ids = one.filter->GetOutput()->GetPointData()->GetGlobalIds();
        double error = 0.0;
        double difference = 0.0;
        for (vtkIdType i = 0; i < one.filter->GetOutput()->GetNumberOfPoints(); ++i)
        {
          const auto point = static_cast<std::size_t>(ids->GetTuple1(i));
          const double distance = one.DistanceAt(static_cast<std::size_t>(i));
          error = std::max(error, ErrorOf(distance, truth[point]));
          difference = std::max(difference, ErrorOf(distance, alone.DistanceAt(point)));
        }
        check.That(error <= one.accuracy * largest, what + ": wrong by " + std::to_string(error));
        check.That(difference <= 1e-12 * largest,
          what + ": differs from one process by " + std::to_string(difference));
        worst = std::max(worst, largest > 0.0 ? difference / largest : 0.0);
        check.Equal(one.filter->GetOutput()->GetNumberOfCells(),
          FacesOf(whole, cut, ranks.Rank).size(), what + ": cells");
      }
    }
  }
  if (ranks.Rank == 0)
  {
    std::cout << "random meshes: worst difference from one process " << worst << '\n';
  }
}

/// The array may be on some ranks only, and on none; errors are the same on all of them.
void TestErrors(Check& check, Ranks ranks, vtkPolyData* surface)
{
  const Cut cut = BarriersApart(surface, ranks.Count);
  const auto piece = [&]() { return PieceOf(surface, cut, ranks.Rank); };
  const auto expect = [&](vtkPolyData* data, const Question& question,
                        const std::vector<std::string>& words, const std::string& what)
  {
    const auto filter = Asked(data, question, true);
    Messages messages(filter);
    messages.ExpectError(check, words, what);
    check.That(!words.empty() || messages.Error().empty(), what + ": " + messages.Error());
    check.Equal(filter->GetOutput()->GetNumberOfCells(),
      words.empty() ? static_cast<double>(data->GetNumberOfCells()) : 0.0, what + ": cells");
  };
  const Question point = Questions().front();
  auto some = piece();
  if (ranks.Count > 1 && ranks.Rank != ranks.Count - 1)
  {
    some->GetCellData()->RemoveArray("barrier");
  }
  expect(some, point, {}, "the array on one rank");
  auto none = piece();
  none->GetCellData()->RemoveArray("barrier");
  expect(none, point, { "no cell array named barrier" }, "the array on no rank");
  auto all = piece();
  all->GetCellData()->GetArray("barrier")->Fill(1.0);
  expect(all, point, { "All faces of the surface" }, "barriers everywhere");
  Question inside{ "inside", PointSources({ { 0.1, 0.1, 0 }, { 0.5625, 0.31, 0 } }) };
  expect(piece(), inside,
    { "Point 1 of the source", "lies in a barrier", "cell ",
      "of the surface (input port 0)" +
        (ranks.Count > 1 ? " on rank " + std::to_string(ranks.Count - 1) : std::string()) },
    "a source in a barrier");
  auto frame = WithBarriers(Square(8),
    [](const Point& p) { return p[0] < 0.125 || p[0] > 0.875 || p[1] < 0.125 || p[1] > 0.875; });
  const Question boundary = Questions()[4];
  expect(PieceAtRandom(frame, ranks), boundary, { "The whole boundary", "barriers" },
    "a boundary that barriers have");
}

/// The rim of a barrier is no boundary, and a loop that barriers have in part keeps its number.
void TestLoops(Check& check, Ranks ranks)
{
  // The square has a hole in its middle; barriers are left of it and all around a corner.
  const auto square = Square(16);
  std::vector<vtkIdType> faces;
  for (vtkIdType face = 0; face < square->GetNumberOfPolys(); ++face)
  {
    const Point p = CentreOf(square, face);
    if (std::max(std::abs(p[0] - 0.5), std::abs(p[1] - 0.5)) > 0.125)
    {
      faces.push_back(face);
    }
  }
  const auto surface = WithBarriers(Part(square, faces),
    [](const Point& p)
    { return (p[0] < 0.375 && p[0] > 0.25 && p[1] > 0.375) || (p[0] < 0.125 && p[1] < 0.125); });
  const Question question = Questions()[4];
  const auto lengthsOf = [](vtkGeodesicDistanceField* filter)
  {
    vtkPolyData* curves = filter->GetOutput(1);
    std::map<double, double> lengths; // of each loop
    for (vtkIdType i = 0; i < curves->GetNumberOfLines(); ++i)
    {
      const double id = CellValue(curves, "SourceId", curves->GetNumberOfVerts() + i);
      lengths[id] += LengthOf(curves, i);
    }
    // Loops are numbered in the order of the whole's faces, which is by ranks.
    std::vector<double> sorted;
    for (const auto& loop : lengths)
    {
      sorted.push_back(loop.second);
    }
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  };
  const Whole whole(surface, question);
  const std::vector<double> expected = lengthsOf(whole.Filter);
  for (const auto& [cutName, cut] : Cuts(surface, ranks, CutNames))
  {
    vtkNew<vtkGeodesicDistanceField> filter;
    filter->SetInputData(PieceOf(surface, cut, ranks.Rank, true));
    Ask(filter, question, true);
    filter->Update();
    CompareDistances(check, filter->GetOutput(), whole, cutName + ", distances from loops");
    const std::vector<double> found = lengthsOf(filter);
    check.That(ranks.Rank > 0 ||
        (found.size() == 2 && expected.size() == 2 && std::abs(found[0] - expected[0]) < 1e-12 &&
          std::abs(found[1] - expected[1]) < 1e-12),
      cutName + ": what is left of two loops is as long as in one process");
  }
}

}

int TestGeodesicRanksBarriers(int argc, char* argv[])
{
  return RunOnRanks(argc, argv,
    [](Check& check, Ranks ranks)
    {
      const auto surface = WithBarriers(NoisySquare(16), IsInWall);
      TestRandomMeshes(check, ranks);
      TestErrors(check, ranks, surface);
      TestLoops(check, ranks);
    });
}
