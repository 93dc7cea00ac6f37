// SPDX-License-Identifier: BSD-3-Clause
// Under MPI, for every cut of a surface into the ranks' pieces: the result is the one process's, at
// each point, of surfaces and sources of all kinds. That one process is right other tests show.
#include "BarrierTesting.h"
#include "GeodesicTesting.h"
#include "LineTesting.h"
#include "RandomBarriers.h"
#include "RanksTesting.h"

#include "vtkGeodesicContour.h"
#include "vtkGeodesicPaths.h"

#include <cmath>

using namespace GeodesicTesting;

namespace
{

const std::vector<std::string> CutsWithBarriers = { "in space", "at random",
  "barriers on a rank of their own" };

/// Contours and paths are as long as in one process. A target in a wall has no path.
void CompareLines(Check& check, vtkPolyData* piece, vtkPolyData* surface, const std::string& name)
{
  const bool isFirst = vtkMultiProcessController::GetGlobalController()->GetLocalProcessId() == 0;
  const auto targets =
    PointSources({ { 0.9, 0.1, 0 }, { 0.1, 0.9, 0 }, { 0.5625, 0.3, 0 }, { 0.7, 0.3, 0 } });
  const auto compare = [&](auto* alone, auto* filter)
  {
    alone->SetController(nullptr);
    alone->SetInputData(surface);
    filter->SetInputData(piece);
    for (auto* one : { alone, filter })
    {
      one->SetBarrierArrayName(HasBarriers(surface) ? "barrier" : nullptr);
      one->SetSourceData(Questions().front().Source);
      RunWithoutError(check, one, name + ", lines");
    }
    const double expected = TotalLength(alone->GetOutput());
    check.Near(Sum(TotalLength(filter->GetOutput())), expected, 1e-9 * expected,
      name + ": contours or paths are as long as in one process");
  };
  vtkNew<vtkGeodesicContour> contourAlone;
  vtkNew<vtkGeodesicContour> contour;
  contourAlone->GenerateValues(5, 0.15, 0.95);
  contour->GenerateValues(5, 0.15, 0.95);
  compare(contourAlone.Get(), contour.Get());
  vtkNew<vtkGeodesicPaths> pathsAlone;
  vtkNew<vtkGeodesicPaths> paths;
  pathsAlone->SetTargetsData(targets);
  paths->SetTargetsData(isFirst ? targets : PointSources({}));
  compare(pathsAlone.Get(), paths.Get());
  for (const double lines : { Sum(static_cast<double>(paths->GetOutput()->GetNumberOfLines())),
         static_cast<double>(pathsAlone->GetOutput()->GetNumberOfLines()) })
  {
    check.Equal(lines, HasBarriers(surface) ? 3.0 : 4.0, name + ": a target in a wall has no path");
  }
}

/// Every way to cut a surface.
void TestCuts(Check& check, Ranks ranks, vtkPolyData* surface)
{
  std::vector<std::string> names = { "in strips", "in space", "at random",
    "with nothing on the last rank", "with nothing on the first rank", "all on the last rank" };
  if (HasBarriers(surface))
  {
    names.emplace_back("barriers on a rank of their own");
  }
  std::vector<std::pair<std::string, vtkSmartPointer<vtkDataObject>>> pieces = {
    { "a copy on every rank", surface },
    { "ghosts in strips", PartWithGhosts(surface, Strips(surface, ranks.Count), ranks.Rank) },
    { "ghosts at random", PartWithGhosts(surface, AtRandom(ranks.Count), ranks.Rank) },
  };
  for (const auto& [name, cut] : Cuts(surface, ranks, names))
  {
    const auto piece = PieceOf(surface, cut, ranks.Rank);
    pieces.emplace_back(name, piece);
    CompareLines(check, piece, surface, name);
  }
  // A rank has two blocks, which are joined as all others are.
  const Cut halves = AtRandom(2 * ranks.Count);
  pieces.emplace_back("blocks on each rank",
    Blocks(
      { PieceOf(surface, halves, 2 * ranks.Rank), PieceOf(surface, halves, 2 * ranks.Rank + 1) }));
  for (const Question& question : Questions())
  {
    const Whole whole(surface, question);
    for (const auto& [name, piece] : pieces)
    {
      Compare(check, piece, whole, name);
    }
  }
}

/// Half planes that meet in one edge, each on one rank or cut; fans that meet in one vertex.
void TestBranches(Check& check, Ranks ranks)
{
  auto surface = Mesh({}, {});
  constexpr int sheets = 5;
  constexpr double pi = 3.14159265358979323846;
  for (int sheet = 0; sheet < sheets; ++sheet)
  {
    const double angle = 2.0 * pi * sheet / sheets;
    Append(surface,
      Moved(Square(4),
        [angle](const Point& p) {
          return Point{ 0.4 * p[0] * std::cos(angle), 0.4 * p[0] * std::sin(angle), 0.4 * p[1] };
        }));
  }
  // A second fan at the end of the common edge.
  Append(
    surface, Mesh({ { 0.0, 0.0, 0.4 }, { -0.1, 0.0, 0.6 }, { 0.1, 0.02, 0.6 } }, { { 0, 1, 2 } }));
  Question point{ "a point on one sheet", PointSources({ { 0.25, 0.0, 0.05 } }) };
  Question boundary{ "the boundary", nullptr, vtkGeodesicDistanceField::SURFACE_BOUNDARY };
  const Cut bySheets = [&](vtkIdType face) { return static_cast<int>(face / 32) % ranks.Count; };
  point.HasSides = false;
  boundary.HasSides = false;
  for (const Cut& cut : { bySheets, AtRandom(ranks.Count) })
  {
    const auto piece = PieceOf(surface, cut, ranks.Rank);
    Compare(check, piece, Whole(surface, point), "sheets that meet in an edge");
    Compare(check, piece, Whole(surface, boundary), "sheets that meet in an edge");
  }
}

/// Random meshes, random barriers, random sources and cuts.
void TestRandomMeshes(Check& check, Ranks ranks)
{
  for (const geodesictest::MeshKind& kind : geodesictest::meshKinds())
  {
    for (std::uint64_t seed = 0; seed < 8; ++seed)
    {
      RandomCase one(kind, seed);
      one.filter->RefineMeshOff();
      one.filter->SetController(nullptr);
      if (!one.CanRun(check))
      {
        continue;
      }
      if (one.IsSourceOpen())
      {
        std::cout << one.name << " is at its source above itself: left out\n";
        continue;
      }
      Question question{ one.name, vtkPolyData::SafeDownCast(one.filter->GetInputDataObject(1, 0)),
        one.filter->GetSourceType() };
      question.HasSides = false;
      question.HasManyWindows = false;
      question.Settings = [](vtkGeodesicDistanceField* filter)
      { filter->MergeCoincidentPointsOff(); };
      const auto surface = vtkPolyData::SafeDownCast(one.filter->GetInputDataObject(0, 0));
      const Whole whole(surface, question);
      for (const auto& [cutName, cut] : Cuts(surface, ranks, CutsWithBarriers))
      {
        Compare(check, PieceOf(surface, cut, ranks.Rank, true), whole, cutName);
      }
    }
  }
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
  const auto lengthsOf = [](vtkGeodesicDistanceField* filter)
  {
    vtkPolyData* curves = filter->GetOutput(1);
    std::map<double, double> lengths; // of each loop
    for (vtkIdType i = 0; i < curves->GetNumberOfLines(); ++i)
    {
      lengths[CellValue(curves, "SourceId", curves->GetNumberOfVerts() + i)] += LengthOf(curves, i);
    }
    // Loops are numbered in the order of the whole's faces, which is by ranks.
    std::vector<double> sorted;
    std::transform(lengths.begin(), lengths.end(), std::back_inserter(sorted),
      [](const auto& loop) { return loop.second; });
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  };
  Question question = Questions()[4];
  question.HasSides = false;
  const Whole whole(surface, question);
  const std::vector<double> expected = lengthsOf(whole.Filter);
  check.Equal(expected.size(), 2, "loops");
  for (const auto& [cutName, cut] : Cuts(surface, ranks, CutsWithBarriers))
  {
    const auto filter =
      Compare(check, PieceOf(surface, cut, ranks.Rank, true), whole, cutName + ", loops");
    const std::vector<double> found = lengthsOf(filter);
    check.That(ranks.Rank > 0 ||
        std::equal(found.begin(), found.end(), expected.begin(), expected.end(),
          [](double a, double b) { return std::abs(a - b) < 1e-12; }),
      cutName + ": what is left of two loops is as long as in one process");
  }
}

/// The curve is one, has all its length, and arc lengths go along all of it; signs are those along
/// it.
void TestSections(Check& check, Ranks ranks, vtkPolyData* sphere)
{
  const auto sectionOf = [](vtkPolyData* data) {
    return Section(data, { 0, 0, 1 }, { 0, 0, 0.013 });
  };
  Question question{ "a section", sectionOf(sphere) };
  question.HasSides = false;
  question.Settings = [](vtkGeodesicDistanceField* filter) { filter->GenerateSignedDistanceOn(); };
  question.Tolerances = { { "SourceId", 0.0 }, { "SignedGeodesicDistance", 1e-12 } };
  Whole whole(sphere, question);
  check.That(whole.Filter->GetOutput(1)->GetNumberOfLines() == 1 &&
      std::abs(whole.Filter->GetSourceLength() - TotalLength(question.Source)) <= 1e-12,
    "the section is one curve");
  for (const auto& [name, cut] : Cuts(sphere, ranks, { "in strips", "at random" }))
  {
    const auto piece = PieceOf(sphere, cut, ranks.Rank);
    for (const bool areDealt : { true, false })
    {
      whole.Asked.OwnSource = areDealt ? Dealt(question.Source, ranks) : sectionOf(piece);
      const auto filter =
        Compare(check, piece, whole, name + (areDealt ? ", lines dealt out" : ", own lines"));
      vtkPolyData* curves = filter->GetOutput(1);
      check.That(ranks.Rank > 0 ||
          curves->GetPointData()->GetArray("SourceArcLength")->GetRange()[1] >
            0.9 * TotalLength(question.Source),
        name + ": arc lengths along all of it");
    }
  }
}

}

int TestGeodesicRanksScenes(int argc, char* argv[])
{
  return RunOnRanks(argc, argv,
    [](Check& check, Ranks ranks)
    {
      TestCuts(check, ranks, NoisySquare(12));
      TestCuts(check, ranks, WithBarriers(NoisySquare(16), IsInWall));
      TestBranches(check, ranks);
      TestRandomMeshes(check, ranks);
      TestLoops(check, ranks);
      TestSections(check, ranks, SphereOfRanks());
    });
}
