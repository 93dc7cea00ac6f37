// SPDX-License-Identifier: BSD-3-Clause
// Under MPI: barriers of a surface of which each rank has a piece are those of the whole, whichever
// rank has them: distances are the brute-force solver's and those of one process, and so are
// contours, paths, boundaries, arrays and errors.
#include "BarrierTesting.h"
#include "RandomBarriers.h"
#include "RanksTesting.h"

#include "vtkGeodesicContour.h"
#include "vtkGeodesicPaths.h"
#include "vtkMultiProcessController.h"

#include <cmath>
#include <limits>

using namespace GeodesicTesting;

namespace
{

double LengthOf(vtkPolyData* data, vtkIdList* line)
{
  double length = 0.0;
  for (vtkIdType i = 1; i < line->GetNumberOfIds(); ++i)
  {
    Point a;
    Point b;
    data->GetPoint(line->GetId(i - 1), a.data());
    data->GetPoint(line->GetId(i), b.data());
    length += std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  }
  return length;
}

/// Of all lines.
double TotalLength(vtkPolyData* data)
{
  double length = 0.0;
  for (vtkIdType i = 0; i < data->GetNumberOfLines(); ++i)
  {
    vtkNew<vtkIdList> ids;
    data->GetLines()->GetCellAtId(i, ids);
    length += LengthOf(data, ids);
  }
  return length;
}

double LargestFiniteOf(vtkDataArray* values)
{
  std::vector<double> all;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    all.push_back(values->GetTuple1(i));
  }
  return LargestFinite(all);
}

/// Each face goes to the nearest of some points of the surface, one a rank.
Cut InSpace(vtkPolyData* surface, int count)
{
  std::vector<Point> middles;
  for (int i = 0; i < count; ++i)
  {
    middles.push_back(Centre(surface, (2 * i + 1) * surface->GetNumberOfPolys() / (2 * count)));
  }
  return [surface, middles](vtkIdType face)
  {
    const Point centre = Centre(surface, face);
    const auto squared = [&centre](const Point& p)
    {
      return (p[0] - centre[0]) * (p[0] - centre[0]) + (p[1] - centre[1]) * (p[1] - centre[1]) +
        (p[2] - centre[2]) * (p[2] - centre[2]);
    };
    const auto nearest = std::min_element(middles.begin(), middles.end(),
      [&](const Point& a, const Point& b) { return squared(a) < squared(b); });
    return static_cast<int>(nearest - middles.begin());
  };
}

std::vector<std::pair<std::string, Cut>> Cuts(Ranks ranks, vtkPolyData* surface)
{
  return {
    { "in space", InSpace(surface, ranks.Count) },
    { "at random", AtRandom(ranks.Count) },
    { "barriers on a rank of their own", BarriersApart(surface, ranks.Count) },
  };
}

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
      for (const auto& [cutName, cut] : Cuts(ranks, whole))
      {
        RandomCase one(kind, seed);
        one.filter->RefineMeshOff();
        one.filter->SetInputData(Part(whole, FacesOf(whole, cut, ranks.Rank), true));
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
        check.Equal(static_cast<double>(one.filter->GetOutput()->GetNumberOfCells()),
          static_cast<double>(FacesOf(whole, cut, ranks.Rank).size()), what + ": cells");
      }
    }
  }
  if (ranks.Rank == 0)
  {
    std::cout << "random meshes: worst difference from one process " << worst << '\n';
  }
}

/// What is asked of the square with a wall.
struct Question
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Source;
  int SourceType = vtkGeodesicDistanceField::SOURCE_CURVE;
};

std::vector<Question> Questions()
{
  return {
    { "a point", PointSources({ { 0.3, 0.2, 0.0 } }) },
    { "a curve around the wall", Polyline({ { 0.2, 0.3, 0 }, { 0.85, 0.35, 0 } }) },
    { "the boundary", nullptr, vtkGeodesicDistanceField::SURFACE_BOUNDARY },
    { "both", PointSources({ { 0.3, 0.2, 0.0 } }), vtkGeodesicDistanceField::CURVE_AND_BOUNDARY },
  };
}

void Ask(vtkGeodesicAlgorithm* filter, const Question& question)
{
  filter->SetBarrierArrayName("barrier");
  filter->SetSourceData(question.Source);
  filter->SetSourceType(question.SourceType);
}

/// All values of an array of the points, by the points' ids in the whole.
std::map<vtkIdType, std::vector<double>> ValuesOf(vtkPolyData* output, const char* name)
{
  std::map<vtkIdType, std::vector<double>> values;
  vtkDataArray* array = output->GetPointData()->GetArray(name);
  vtkDataArray* ids = output->GetPointData()->GetGlobalIds();
  for (vtkIdType i = 0; array && i < output->GetNumberOfPoints(); ++i)
  {
    std::vector<double> tuple(static_cast<std::size_t>(array->GetNumberOfComponents()));
    array->GetTuple(i, tuple.data());
    values[ids ? static_cast<vtkIdType>(ids->GetTuple1(i)) : i] = tuple;
  }
  return values;
}

const char* const Arrays[] = { "GeodesicDistance", "SourceId", "ClosestSourcePoint",
  "DistanceGradient", "SignedGeodesicDistance", "SourceArcLength", "SourceTextureCoordinates" };

void AskForArrays(vtkGeodesicDistanceField* filter)
{
  filter->RefineMeshOff();
  filter->GenerateSourceIdsOn();
  filter->GenerateClosestPointsOn();
  filter->GenerateGradientsOn();
  filter->GenerateSignedDistanceOn();
  filter->GenerateSourceArcLengthOn();
  filter->GenerateTextureCoordinatesOn();
}

/// The distance and all arrays, and the source as it lies on the surface.
void TestFields(Check& check, Ranks ranks, vtkPolyData* surface)
{
  for (const Question& question : Questions())
  {
    vtkNew<vtkGeodesicDistanceField> alone;
    alone->SetController(nullptr);
    alone->SetInputData(surface);
    Ask(alone, question);
    AskForArrays(alone);
    alone->Update();
    const double largest = LargestFiniteOf(Distances(alone));
    for (const auto& [cutName, cut] : Cuts(ranks, surface))
    {
      const std::string what = question.Name + ", " + cutName;
      vtkNew<vtkGeodesicDistanceField> filter;
      filter->SetInputData(Part(surface, FacesOf(surface, cut, ranks.Rank), true));
      Ask(filter, question);
      AskForArrays(filter);
      Messages messages(filter);
      messages.Update();
      check.That(messages.Error().empty() && messages.Warning().empty(),
        what + ": " + messages.Error() + messages.Warning());
      for (const char* name : Arrays)
      {
        auto whole = ValuesOf(alone->GetOutput(), name);
        double worst = 0.0;
        for (const auto& [point, values] : ValuesOf(filter->GetOutput(), name))
        {
          for (std::size_t k = 0; k < values.size(); ++k)
          {
            worst = std::max(worst, ErrorOf(values[k], whole[point][k]));
          }
        }
        // Directions are known to the roots of roundings of distances at best.
        const double accuracy = name == std::string("DistanceGradient") ? 1e-6 : 1e-12;
        check.That(worst <= accuracy * std::max(1.0, largest),
          what + ": " + name + " is off by " + std::to_string(worst));
      }
      const auto lengthOf = [](vtkGeodesicDistanceField* f)
      { return TotalLength(vtkPolyData::SafeDownCast(f->GetOutputDataObject(1))); };
      check.That(std::abs(lengthOf(filter) - (ranks.Rank == 0 ? lengthOf(alone) : 0.0)) < 1e-12,
        what + ": the source on the surface is as long as in one process");
    }
  }
}

/// Over all ranks.
double SumOver(double own)
{
  double sum = 0.0;
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    &own, &sum, 1, vtkCommunicator::SUM_OP);
  return sum;
}

void TestLines(Check& check, Ranks ranks, vtkPolyData* surface)
{
  const Question question = Questions().front();
  const auto contour = [&](vtkGeodesicContour* filter)
  {
    Ask(filter, question);
    filter->GenerateValues(5, 0.15, 0.95);
    filter->Update();
    return TotalLength(filter->GetOutput());
  };
  // The third one lies inside the wall.
  const std::vector<Point> places = { { 0.9, 0.1, 0 }, { 0.1, 0.9, 0 },
    { 0.5 * (WallBegin + WallEnd), 0.3, 0 }, { 0.7, 0.3, 0 } };
  const auto paths = [&](vtkGeodesicPaths* filter)
  {
    Ask(filter, question);
    Messages messages(filter);
    messages.Update();
    check.That(messages.Error().empty(), "paths: " + messages.Error());
    return TotalLength(filter->GetOutput());
  };
  vtkNew<vtkGeodesicContour> contourAlone;
  contourAlone->SetController(nullptr);
  contourAlone->SetInputData(surface);
  const double lengthOfContour = contour(contourAlone);
  vtkNew<vtkGeodesicPaths> pathsAlone;
  pathsAlone->SetController(nullptr);
  pathsAlone->SetInputData(surface);
  pathsAlone->SetTargetsData(PointSources(places));
  const double lengthOfPaths = paths(pathsAlone);
  check.Equal(static_cast<double>(pathsAlone->GetOutput()->GetNumberOfLines()), 3.0,
    "a target in the wall has no path");
  for (const auto& [cutName, cut] : Cuts(ranks, surface))
  {
    const auto piece = Part(surface, FacesOf(surface, cut, ranks.Rank));
    vtkNew<vtkGeodesicContour> ownContour;
    ownContour->SetInputData(piece);
    check.That(std::abs(SumOver(contour(ownContour)) - lengthOfContour) < 1e-9 * lengthOfContour,
      cutName + ": contours are as long as in one process");
    vtkNew<vtkGeodesicPaths> ownPaths;
    ownPaths->SetInputData(piece);
    ownPaths->SetTargetsData(PointSources(ranks.Rank == 0 ? places : std::vector<Point>()));
    check.That(std::abs(SumOver(paths(ownPaths)) - lengthOfPaths) < 1e-11,
      cutName + ": paths are as long as in one process");
    check.Equal(SumOver(static_cast<double>(ownPaths->GetOutput()->GetNumberOfLines())), 3.0,
      cutName + ": a target in the wall has no path");
  }
}

/// The array may be on some ranks only, and on none; errors are the same on all of them.
void TestErrors(Check& check, Ranks ranks, vtkPolyData* surface)
{
  const Cut cut = BarriersApart(surface, ranks.Count);
  const auto piece = [&]() { return Part(surface, FacesOf(surface, cut, ranks.Rank)); };
  const auto expect = [&](vtkPolyData* data, const Question& question,
                        const std::vector<std::string>& words, const std::string& what)
  {
    vtkNew<vtkGeodesicDistanceField> filter;
    filter->RefineMeshOff();
    filter->SetInputData(data);
    Ask(filter, question);
    Messages messages(filter);
    messages.Update();
    for (const std::string& word : words)
    {
      check.That(Contains(messages.Error(), word), what + ": " + messages.Error());
    }
    check.That(!words.empty() || messages.Error().empty(), what + ": " + messages.Error());
    check.Equal(static_cast<double>(filter->GetOutput()->GetNumberOfCells()),
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
  const Question boundary = Questions()[2];
  expect(Part(frame, FacesOf(frame, AtRandom(ranks.Count), ranks.Rank)), boundary,
    { "The whole boundary", "barriers" }, "a boundary that barriers have");
}

/// The rim of a barrier is no boundary, and a loop that barriers have in part keeps its number.
void TestLoops(Check& check, Ranks ranks)
{
  // The square has a hole in its middle; barriers are left of it and all around a corner.
  const auto square = Square(16);
  std::vector<vtkIdType> faces;
  for (vtkIdType face = 0; face < square->GetNumberOfPolys(); ++face)
  {
    const Point p = Centre(square, face);
    if (std::max(std::abs(p[0] - 0.5), std::abs(p[1] - 0.5)) > 0.125)
    {
      faces.push_back(face);
    }
  }
  const auto surface = WithBarriers(Part(square, faces),
    [](const Point& p)
    { return (p[0] < 0.375 && p[0] > 0.25 && p[1] > 0.375) || (p[0] < 0.125 && p[1] < 0.125); });
  const Question question = Questions()[2];
  vtkNew<vtkGeodesicDistanceField> alone;
  alone->SetController(nullptr);
  alone->SetInputData(surface);
  Ask(alone, question);
  AskForArrays(alone);
  alone->Update();
  const auto lengthsOf = [](vtkGeodesicDistanceField* filter)
  {
    auto* curves = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
    std::map<double, double> lengths; // of each loop
    for (vtkIdType i = 0; i < curves->GetNumberOfLines(); ++i)
    {
      vtkNew<vtkIdList> ids;
      curves->GetLines()->GetCellAtId(i, ids);
      const double id =
        curves->GetCellData()->GetArray("SourceId")->GetTuple1(curves->GetNumberOfVerts() + i);
      lengths[id] += LengthOf(curves, ids);
    }
    return lengths;
  };
  for (const auto& [cutName, cut] : Cuts(ranks, surface))
  {
    vtkNew<vtkGeodesicDistanceField> filter;
    filter->SetInputData(Part(surface, FacesOf(surface, cut, ranks.Rank), true));
    Ask(filter, question);
    AskForArrays(filter);
    filter->Update();
    auto whole = ValuesOf(alone->GetOutput(), "GeodesicDistance");
    double worst = 0.0;
    for (const auto& [point, values] : ValuesOf(filter->GetOutput(), "GeodesicDistance"))
    {
      worst = std::max(worst, ErrorOf(values[0], whole[point][0]));
    }
    check.That(
      worst <= 1e-12, cutName + ": distances from loops are off by " + std::to_string(worst));
    if (ranks.Rank == 0)
    {
      std::vector<double> expected;
      std::vector<double> found;
      for (const auto& loop : lengthsOf(alone))
      {
        expected.push_back(loop.second);
      }
      for (const auto& loop : lengthsOf(filter))
      {
        found.push_back(loop.second);
      }
      // Loops are numbered in the order of the whole's faces, which is by ranks.
      std::sort(expected.begin(), expected.end());
      std::sort(found.begin(), found.end());
      check.That(found.size() == 2 && expected.size() == 2, cutName + ": two loops");
      for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i)
      {
        check.That(std::abs(found[i] - expected[i]) < 1e-12,
          cutName + ": what is left of a loop is as long as in one process");
      }
    }
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
      TestFields(check, ranks, surface);
      TestLines(check, ranks, surface);
      TestErrors(check, ranks, surface);
      TestLoops(check, ranks);
    });
}
