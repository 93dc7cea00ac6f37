// SPDX-License-Identifier: BSD-3-Clause
// Under MPI: a surface of which each rank has a piece has one distance field, that of the whole in
// one process.
#include "BarrierTesting.h"
#include "GeodesicTesting.h"
#include "PathFaces.h"
#include "RanksTesting.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicPaths.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

using namespace GeodesicTesting;

namespace
{

/// With points that coincide left apart, global ids join the pieces.
void TestGlobalIds(Check& check, Ranks ranks, vtkPolyData* surface)
{
  const Question question = Questions().front();
  const Whole whole(surface, question);
  const std::vector<vtkIdType> faces = FacesOf(surface, AtRandom(ranks.Count), ranks.Rank);
  // Pieces without points need no ids.
  const std::vector<vtkIdType> some =
    FacesOf(surface, AtRandom(std::max(1, ranks.Count - 1)), ranks.Rank);
  for (const bool hasGlobalIds : { true, false })
  {
    const auto filter = Asked(Part(surface, faces, hasGlobalIds), question);
    filter->MergeCoincidentPointsOff();
    filter->Update();
    if (hasGlobalIds)
    {
      CompareDistances(check, filter->GetOutput(), whole, "joined by global ids");
      filter->SetInputData(Part(surface, some, !some.empty()));
      filter->Update();
      CompareDistances(
        check, filter->GetOutput(), whole, "joined by global ids beside an empty piece");
      continue;
    }
    const double farthest = Distances(filter)->GetRange()[1];
    check.That(ranks.Count == 1 || farthest == std::numeric_limits<double>::infinity(),
      "without global ids and merging the pieces are not connected");
  }
}

/// Two quads on one rank, each with points of its own, touch the third, on another rank, in one
/// corner: by its global id all three are joined there, and paths go on straight.
void TestIdsMetElsewhere(Check& check, Ranks ranks)
{
  if (ranks.Count == 1)
  {
    return; // global ids join ranks
  }
  const auto surface = Mesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 2, 0, 0 },
                              { 2, 1, 0 }, { 1.5, 2, 0 }, { 1, 3, 0 }, { 0.5, 2, 0 } },
    { { 0, 1, 2, 3 }, { 1, 4, 5, 2 }, { 2, 6, 7, 8 } });
  const auto block = [&](int rank, vtkIdType quad)
  {
    return Part(surface,
      ranks.Rank == rank ? std::vector<vtkIdType>{ quad } : std::vector<vtkIdType>(), true);
  };
  const auto third = block(1, 2);
  const auto filter = Asked(Blocks({ block(0, 0), ranks.Rank == 0 ? block(0, 1) : third }),
    { "", PointSources({ { 0, 1, 0 } }) });
  filter->MergeCoincidentPointsOff();
  filter->Update();
  const double diagonal = std::sqrt(2.0);
  const std::map<Point, double> expected = { { { 2, 1, 0 }, 2.0 }, { { 2, 0, 0 }, 1.0 + diagonal },
    { { 1, 3, 0 }, 3.0 }, { { 0, 0, 0 }, 1.0 } };
  double count = 0.0;
  for (const unsigned int index : { 0U, 1U })
  {
    vtkPolyData* output = Block(filter, index);
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const auto found = expected.find(PointAt(output, i));
      if (found != expected.end())
      {
        ++count;
        check.Near(PointValue(output, "GeodesicDistance", i), found->second, 1e-14,
          "points of one rank with a global id of another rank's are one");
      }
    }
  }
  check.Equal(Sum(count), 4.0, "points with a known distance");
}

/// Seam points that differ by a rounding are one.
void TestRoundings(Check& check, Ranks ranks, vtkPolyData* surface)
{
  const Question question = Questions().front();
  const Whole whole(surface, question);
  const Cut cut = Strips(surface, ranks.Count);
  const auto movedOn = [](const Point& p, int rank)
  {
    const double up = rank % 2 == 1 ? 2.0 : 0.0;
    return Point{ std::nextafter(p[0], up), std::nextafter(p[1], up), p[2] };
  };
  auto piece = PieceOf(surface, cut, ranks.Rank);
  const auto moved = CopyOf(piece);
  MovePoints(moved, [&](const Point& p) { return movedOn(p, ranks.Rank); });
  const auto filter = Asked(moved, question);
  filter->Update();
  for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i)
  {
    check.Near(Distances(filter)->GetTuple1(i), whole.DistanceAt(PointAt(piece, i)), 1e-12,
      "seam points that differ by a rounding are one");
  }
  std::map<Point, std::set<Point>> placesOfPoints;
  for (vtkIdType face = 0; face < surface->GetNumberOfPolys(); ++face)
  {
    for (const vtkIdType id : IdsOf(surface->GetPolys(), face))
    {
      const Point p = PointAt(surface, id);
      placesOfPoints[p].insert(movedOn(p, cut(face)));
    }
  }
  std::size_t joined = 0;
  for (const auto& [point, places] : placesOfPoints)
  {
    joined += places.size() - 1;
  }
  check.Equal(filter->GetSeamPointsJoined(), joined, "and are counted once");
}

/// The point as a grid of a vertex: alone it is a set of points. With a solid, which is no
/// source, ids are those of cells.
vtkSmartPointer<vtkUnstructuredGrid> GridOfVertex(const Point& p, bool hasSolid)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(PointSources({ p, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 } })->GetPoints());
  const vtkIdType ids[] = { 0, 1, 2, 3 };
  if (hasSolid)
  {
    grid->InsertNextCell(VTK_TETRA, 4, ids);
  }
  grid->InsertNextCell(VTK_VERTEX, 1, ids);
  return grid;
}

/// The source in pieces, on one rank, on every rank: distances are the same, and ids follow the
/// ranks.
void TestSourcesOnRanks(Check& check, Ranks ranks, vtkPolyData* surface)
{
  std::vector<Point> all;
  for (int rank = 0; rank < ranks.Count; ++rank)
  {
    all.push_back({ 0.1 + 0.8 * rank / ranks.Count, 0.3, 0.0 });
  }
  const Point own = all[static_cast<std::size_t>(ranks.Rank)];
  const Whole whole(surface, { "points", PointSources(all) });
  struct Source
  {
    std::string Name;
    vtkSmartPointer<vtkDataObject> Data;
    vtkIdType FirstId = 0;
    vtkIdType IdsOfARank = 1;
  };
  const std::vector<Source> sources = {
    { "one on each rank", PointSources({ own }) },
    { "all on each rank", PointSources(all) },
    { "all on rank 0", PointSources(ranks.Rank == 0 ? all : std::vector<Point>()) },
    { "grids of vertices", GridOfVertex(own, false), 0, 4 },
    { "grids with solids", GridOfVertex(own, true), 1, 2 },
  };
  for (const Source& source : sources)
  {
    const auto filter = Asked(PieceAtRandom(surface, ranks), {});
    filter->SetSourceData(source.Data);
    Messages messages(filter);
    messages.ExpectNoError(check, source.Name);
    const std::string told = std::to_string(ranks.Count) + " cell";
    check.That(Contains(messages.Warning(), told) == (source.FirstId == 1 && ranks.Rank == 0),
      source.Name + ": rank 0 tells of all solids: " + messages.Warning());
    CompareDistances(check, filter->GetOutput(), whole, source.Name);
    vtkPolyData* curves = filter->GetOutput(1);
    check.Equal(curves->GetNumberOfCells(), ranks.Rank == 0 ? ranks.Count : 0,
      source.Name + ": rank 0 puts out the source");
    for (vtkIdType i = 0; i < curves->GetNumberOfCells(); ++i)
    {
      check.Equal(CellValue(curves, "SourceId", i), source.FirstId + i * source.IdsOfARank,
        source.Name + ": ids");
    }
  }
}

/// Ids are values of an array of the cells, wherever these are; a rank without cells needs none.
void TestNames(Check& check, Ranks ranks, vtkPolyData* sphere)
{
  const auto all = Section(sphere, { 0, 0, 1 }, { 0, 0, 0.013 });
  const auto lines = ranks.Rank == 1 ? vtkSmartPointer<vtkPolyData>::New() : Dealt(all, ranks);
  vtkNew<vtkIdTypeArray> labels;
  labels->SetName("label");
  for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
  {
    labels->InsertNextValue(700 + ranks.Rank);
  }
  if (ranks.Rank != 1)
  {
    lines->GetCellData()->AddArray(labels);
  }
  const auto filter = PlainField(PieceOf(sphere, Strips(sphere, ranks.Count), ranks.Rank), lines);
  filter->SetSourceIdArrayName("label");
  filter->GenerateSourceIdsOn();
  RunWithoutError(check, filter, "names");
  std::set<double> ids;
  vtkDataArray* ofPoints = filter->GetOutput()->GetPointData()->GetArray("SourceId");
  for (vtkIdType i = 0; i < ofPoints->GetNumberOfTuples(); ++i)
  {
    ids.insert(ofPoints->GetTuple1(i));
  }
  check.That(!ids.empty() && *ids.begin() >= 700.0 && *ids.rbegin() < 700.0 + ranks.Count &&
      ids.count(701.0) == 0,
    "the ids of all ranks are values of the array");
}

/// Targets far from the surface, on whichever rank they were and wherever they were put, are told
/// once, in the order of all.
void TestFarTargets(Check& check, Ranks ranks, vtkPolyData* surface)
{
  const auto paths = vtkSmartPointer<vtkGeodesicPaths>::New();
  paths->SetInputData(PieceAtRandom(surface, ranks));
  paths->SetSourceData(PointSources({ { 0.5, 0.5, 0 } }));
  const double x = 0.1 + 0.8 * ranks.Rank / ranks.Count;
  paths->SetTargetsData(PointSources({ { x, 0.2, 0.0 }, { x, 0.8, 8.0 + ranks.Rank } }));
  Messages messages(paths);
  messages.ExpectNoError(check, "far targets");
  const std::string told = "at " + std::to_string(ranks.Count) + " of " +
    std::to_string(2 * ranks.Count) + " points: point 1";
  check.That(ranks.Rank == 0 ? Contains(messages.Warning(), told) : messages.Warning().empty(),
    "far targets of all ranks are told by the first: " + messages.Warning());
  check.Equal(paths->GetOutput()->GetNumberOfLines(), 2.0, "far targets");
}

/// A path by its length and its target's way to the surface, by the target's id.
using PathsById = std::map<vtkIdType, std::pair<double, double>>;

PathsById PathsOf(vtkPolyData* output)
{
  const auto value = [output](const char* name, vtkIdType i) { return CellValue(output, name, i); };
  PathsById paths;
  for (vtkIdType i = 0; i < output->GetNumberOfLines(); ++i)
  {
    paths[static_cast<vtkIdType>(value("TargetId", i))] = { value("GeodesicDistance", i),
      value("TargetSnapDistance", i) };
  }
  return paths;
}

/// Where the surface is: in pieces, on one rank, on every rank.
std::vector<std::pair<std::string, vtkSmartPointer<vtkPolyData>>> PlacesOfSurface(
  Ranks ranks, vtkPolyData* surface)
{
  const auto on = [&](const Cut& cut) { return PieceOf(surface, cut, ranks.Rank); };
  return { { "in pieces", on(AtRandom(ranks.Count)) },
    { "on rank 0", on([](vtkIdType) { return 0; }) },
    { "on the last rank", on([&](vtkIdType) { return ranks.Count - 1; }) },
    { "on every rank", surface } };
}

/// A path is on the rank that had its target, on rank 0 where all had the same, wherever the
/// surface is. So large a surface is scaled inside.
void TestPathsAtTargets(Check& check, Ranks ranks, vtkPolyData* unscaled, double scale)
{
  const auto surface = CopyOf(unscaled);
  const auto scaled = ScaledBy(scale);
  MovePoints(surface, scaled);
  std::vector<Point> all;
  for (int i = 0; i < 2 * ranks.Count; ++i)
  {
    all.push_back(scaled({ 0.9 - 0.35 * i / ranks.Count, 0.1 + 0.4 * i / ranks.Count, 0.01 * i }));
  }
  const auto own = all.begin() + 2 * ranks.Rank;
  const auto source = PointSources({ scaled({ 0.2, 0.3, 0.0 }) });
  const auto paths = [&](vtkGeodesicPaths* filter, vtkPolyData* data, const std::vector<Point>& at)
  {
    filter->SetInputData(data);
    filter->SetSourceData(source);
    filter->SetTargetsData(PointSources(at));
    RunWithoutError(check, filter, "paths");
    return PathsOf(filter->GetOutput());
  };
  vtkNew<vtkGeodesicPaths> alone;
  alone->SetController(nullptr);
  const PathsById expected = paths(alone, surface, all);
  const auto last = ranks.Count - 1;
  const std::vector<std::tuple<std::string, std::vector<Point>, std::function<int(vtkIdType)>>>
    targets = {
      { "all targets on each rank", all, [](vtkIdType) { return 0; } },
      { "targets on each rank", { own, own + 2 },
        [](vtkIdType id) { return static_cast<int>(id / 2); } },
      { "all targets on the last rank", ranks.Rank == last ? all : std::vector<Point>(),
        [last](vtkIdType) { return last; } },
    };
  for (const auto& [place, data] : PlacesOfSurface(ranks, surface))
  {
    for (const auto& [name, points, rankOf] : targets)
    {
      const std::string what = "a surface " + place + ", " + name + ": ";
      vtkNew<vtkGeodesicPaths> filter;
      PathsById found = paths(filter, data, points);
      for (const auto& [id, path] : expected)
      {
        const auto at = found.find(id);
        const bool isHere = rankOf(id) == ranks.Rank;
        check.That((at != found.end()) == isHere, what + "a path is where its target was");
        check.That(!isHere || at == found.end() ||
            (std::abs(at->second.first - path.first) <= 1e-12 * path.first &&
              std::abs(at->second.second - path.second) <= 1e-12 * scale),
          what + "a path is that of one process");
      }
      for (vtkIdType i = 1; i < filter->GetOutput()->GetNumberOfLines(); ++i)
      {
        vtkDataArray* ids = filter->GetOutput()->GetCellData()->GetArray("TargetId");
        check.That(ids->GetTuple1(i) > ids->GetTuple1(i - 1), what + "paths follow the targets");
      }
    }
  }
}

/// FaceId numbers the cells of all ranks, one rank after another, ghosts included; those of the one
/// rank that has the surface, or of the surface that all have, as in one process.
void TestFacesOfPaths(Check& check, Ranks ranks, vtkPolyData* surface)
{
  std::vector<Point> targets;
  for (int i = 0; i < 30; ++i)
  {
    targets.push_back({ 0.5 + 0.5 * std::sin(1.7 * i), 0.5 + 0.5 * std::cos(2.9 * i), 0.0 });
  }
  const auto run =
    [&](vtkPolyData* data, const std::vector<vtkIdType>& faceOf, const std::string& place)
  {
    const auto filter = FilterOn<vtkGeodesicPaths>(data, PointSources({ { 0.2, 0.3, 0.0 } }));
    filter->GenerateFaceIdsOn();
    filter->SetTargetsData(PointSources(targets));
    Messages messages(filter);
    messages.Update();
    const std::string name = "faces of paths on a surface " + place;
    check.That(messages.Error().empty(), name + ": " + messages.Error());
    check.Equal(filter->GetOutput()->GetNumberOfLines(),
      ranks.Rank == 0 ? static_cast<double>(targets.size()) : 0.0, name + ": paths");
    const double error = CheckFacesOfPaths(
      check, filter->GetOutput(),
      [&](vtkIdType cell)
      {
        const auto number = static_cast<std::size_t>(cell);
        return cell < 0 || number >= faceOf.size() || faceOf[number] < 0
          ? std::vector<Corners>()
          : TrianglesOfCell(surface, faceOf[number]);
      },
      name);
    check.That(error <= 1e-14, name + ": off by " + std::to_string(error));
  };
  std::vector<vtkIdType> whole(static_cast<std::size_t>(surface->GetNumberOfPolys()));
  std::iota(whole.begin(), whole.end(), vtkIdType(0));
  std::vector<vtkIdType> inPieces;
  std::vector<vtkIdType> withGhosts;
  const Cut cut = AtRandom(ranks.Count);
  for (int rank = 0; rank < ranks.Count; ++rank)
  {
    const std::vector<vtkIdType> own = FacesOf(surface, cut, rank);
    inPieces.insert(inPieces.end(), own.begin(), own.end());
    withGhosts.insert(withGhosts.end(), own.begin(), own.end());
    // That a ghost is not named is part of it: it has no face here.
    withGhosts.resize(withGhosts.size() +
        static_cast<std::size_t>(PartWithGhosts(surface, cut, rank)->GetNumberOfCells()) -
        own.size(),
      -1);
  }
  for (const auto& [place, data] : PlacesOfSurface(ranks, surface))
  {
    run(data, place == "in pieces" ? inPieces : whole, place);
  }
  run(PartWithGhosts(surface, cut, ranks.Rank), withGhosts, "with ghosts");
}

/// Cells that cannot be read on one rank, of the surface or the source, are an error on all.
void TestUnreadableCells(Check& check, Ranks ranks, vtkPolyData* surface)
{
  const auto broken = [&](vtkPolyData* data)
  {
    auto copy = vtkSmartPointer<vtkPolyData>::New();
    copy->DeepCopy(data);
    if (ranks.Rank == ranks.Count - 1)
    {
      copy->GetPolys()->GetOffsetsArray()->SetTuple1(1, 1e6);
    }
    return copy;
  };
  const auto piece = PieceAtRandom(surface, ranks);
  for (const int port : { 0, 1 })
  {
    const auto filter = RefinedField(
      port == 0 ? broken(piece) : piece, port == 1 ? broken(piece) : PointSources({ { 0, 0, 0 } }));
    Messages(filter).ExpectError(check, { "Cell 0 of the s", "port " + std::to_string(port) },
      "all ranks name the cell of one that cannot be read");
    CheckOutputsEmpty(check, filter, "a cell that cannot be read on one rank");
  }
}

/// The array of barriers may be on some ranks only, and on none; errors are the same on all of
/// them.
void TestErrorsOfBarriers(Check& check, Ranks ranks, vtkPolyData* surface)
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

/// An error or an abort on one rank is one on all.
void TestFailures(Check& check, Ranks ranks, vtkPolyData* surface)
{
  auto piece = PieceAtRandom(surface, ranks);
  const Question question = Questions().front();
  const auto bad = CopyOf(piece);
  if (ranks.Rank == ranks.Count - 1)
  {
    bad->GetPoints()->SetPoint(5, std::nan(""), 0.0, 0.0);
  }
  vtkNew<vtkGeodesicDistanceField> filter;
  Ask(filter, question);
  Messages messages(filter);
  filter->SetInputData(bad);
  messages.ExpectError(check, { "at point 5" }, "all ranks say what is wrong on one");
  check.That(Contains(filter->GetErrorMessage(), "at point 5") && filter->GetErrorCode() != 0,
    "scripts on all ranks get it: " + filter->GetErrorMessage());
  CheckOutputsEmpty(check, filter, "an error on one rank");

  filter->SetInputData(piece);
  {
    const bool isStopped = ranks.Rank == ranks.Count - 1;
    Listener listener(filter, vtkCommand::ProgressEvent,
      [&]()
      {
        if (isStopped && filter->GetProgress() > 0.25)
        {
          filter->SetAbortExecute(1);
        }
      });
    messages.Update();
    check.That(
      messages.Error().empty() && filter->GetErrorMessage().empty() && filter->GetErrorCode() == 0,
      "an abort is no error: " + messages.Error());
    CheckOutputsEmpty(check, filter, "an abort on one rank");
    filter->RemoveObservers(vtkCommand::ProgressEvent);
  }
  filter->SetAbortExecute(0);
  filter->Modified();
  messages.Update();
  CompareDistances(check, filter->GetOutput(), Whole(surface, question), "after an abort");

  filter->SetSourceData(PointSources({}));
  messages.ExpectError(check, { "is empty" }, "no source anywhere");
  vtkNew<vtkPolyData> nothing;
  filter->SetInputData(nothing);
  filter->SetSourceData(question.Source);
  messages.ExpectError(check, { "no faces" }, "no surface anywhere");
}

/// Points that no face uses may be NaN or infinite on any rank, and as many as it likes.
void TestPointsThatAreNotFinite(Check& check, Ranks ranks, vtkPolyData* surface)
{
  const Question question = Questions().front();
  const auto piece = PieceAtRandom(surface, ranks);
  const auto solved = [&](vtkPolyData* input)
  {
    const auto filter = Asked(input, question);
    RunWithoutError(check, filter, "unused points are no error");
    vtkSmartPointer<vtkDataArray> distances = Distances(filter);
    return distances;
  };
  const auto expected = solved(piece);
  const auto more = CopyOf(piece);
  const vtkIdType count = piece->GetNumberOfPoints();
  for (int i = 0; i < 3 * ranks.Rank + 1; ++i)
  {
    more->GetPoints()->InsertNextPoint(i % 2 == 0 ? std::nan("") : HUGE_VAL, 0.0, 0.0);
  }
  const auto distances = solved(more);
  bool areSame = distances && distances->GetNumberOfTuples() == more->GetNumberOfPoints();
  for (vtkIdType i = 0; areSame && i < more->GetNumberOfPoints(); ++i)
  {
    areSame = distances->GetTuple1(i) == (i < count ? expected->GetTuple1(i) : HUGE_VAL);
  }
  check.That(areSame, "beside unused points that are not finite the distance is the same");
}

/// Executing again, with what has changed on one rank only.
void TestAgain(Check& check, Ranks ranks, vtkPolyData* surface)
{
  const auto piece = PieceOf(surface, Strips(surface, ranks.Count), ranks.Rank);
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(piece);
  for (const Question& question : Questions())
  {
    Question exact = question;
    exact.IsApproximate = false;
    Ask(filter, exact);
    filter->Update();
    CompareDistances(
      check, filter->GetOutput(), Whole(surface, exact), "again, with " + question.Name);
  }
  const auto changed = CopyOf(surface);
  const auto change = [](const Point& p) {
    return p[0] < 0.1 ? Point{ p[0] - 0.3, p[1], p[2] } : p;
  };
  MovePoints(changed, change);
  MovePoints(piece, change);
  piece->Modified();
  filter->Modified();
  const Question question = Questions().front();
  Ask(filter, question);
  filter->Update();
  CompareDistances(check, filter->GetOutput(), Whole(changed, question),
    "again, where points of one rank have moved");
}

/// Whatever piece is asked for, a rank has its own; of more pieces than ranks one has it.
void TestPieces(Check& check, Ranks ranks, vtkPolyData* surface)
{
  const auto piece = PieceAtRandom(surface, ranks);
  const Question question = Questions().front();
  const auto filter = Asked(piece, question);
  const int pieces = 3 * ranks.Count;
  vtkIdType cells = 0;
  for (int i = 3 * ranks.Rank; i < 3 * ranks.Rank + 3; ++i)
  {
    filter->UpdatePiece(i, pieces, 0);
    cells += filter->GetOutput()->GetNumberOfCells();
  }
  check.Equal(cells, piece->GetNumberOfCells(), "of three pieces a rank each cell is in one");
  const auto alone = Asked(surface, question);
  alone->SetController(nullptr);
  alone->Update();
  const double windows = filter->GetWindowsPropagatedPerEdge();
  check.That(std::abs(windows / alone->GetWindowsPropagatedPerEdge() - 1.0) < 0.1,
    "edges count once: " + std::to_string(windows) + " windows an edge");
  // A source that makes pieces itself is asked for the rank's.
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(15);
  vtkNew<vtkGeodesicDistanceField> onSphere;
  onSphere->SetInputConnection(sphere->GetOutputPort());
  onSphere->SetSourceData(PointSources({ { 0.0, 0.0, 0.5 } }));
  onSphere->RefineMeshOff();
  onSphere->Update();
  const double* range = Distances(onSphere)->GetRange();
  check.That(range[0] == 0.0 && range[1] > 1.4 && range[1] < 1.58,
    "a sphere in pieces is one, pole to pole " + std::to_string(range[1]));
  check.That(ranks.Count == 1 || onSphere->GetOutput()->GetNumberOfCells() < 24 * 26,
    "and each rank has a part of it");
}

void TestMatrix(Check& check, Ranks ranks, vtkPolyData* surface)
{
  const auto points = PointSources({ { 0.1, 0.1, 0 }, { 0.9, 0.2, 0 }, { 0.5, 0.9, 0 } });
  vtkNew<vtkStringArray> names;
  names->SetName("names");
  for (const char* name : { "left", "right hand", "left" })
  {
    names->InsertNextValue(name);
  }
  points->GetPointData()->AddArray(names);
  const auto alone = FilterOn<vtkGeodesicDistanceMatrix>(surface, points);
  alone->SetController(nullptr);
  alone->SetSourceNameArrayName("names");
  alone->SetTargetNameArrayName("names");
  alone->Update();
  const auto compare = [&](vtkPolyData* piece, const std::string& what)
  {
    const auto matrix = FilterOn<vtkGeodesicDistanceMatrix>(piece, points);
    matrix->SetSourceNameArrayName("names");
    matrix->SetTargetNameArrayName("names");
    matrix->Update();
    vtkTable* table = matrix->GetOutput();
    check.Equal(table->GetNumberOfRows(), ranks.Rank == 0 ? 3 : 0, what + ": rank 0 has the rows");
    check.Equal(
      table->GetNumberOfColumns(), ranks.Rank == 0 ? 5 : 0, what + ": rank 0 has the columns");
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column)
      {
        check.That(
          table->GetColumnName(column) == std::string(alone->GetOutput()->GetColumnName(column)),
          what + ": the names of columns");
        if (column == 1)
        {
          check.That(table->GetValue(row, column).ToString() == names->GetValue(row),
            what + ": the names of rows");
          continue;
        }
        check.Equal(table->GetValue(row, column).ToDouble(),
          alone->GetOutput()->GetValue(row, column).ToDouble(), what + ": the matrix");
      }
    }
  };
  compare(surface, "the surface on every rank");
  vtkNew<vtkPolyData> nothing;
  compare(ranks.Rank == ranks.Count - 1 ? surface : nothing.Get(), "the surface on one rank");

  if (ranks.Count > 1)
  {
    const auto matrix = FilterOn<vtkGeodesicDistanceMatrix>(PieceAtRandom(surface, ranks), points);
    Messages(matrix).ExpectError(
      check, { "distributed over several ranks" }, "a matrix of a surface in pieces is refused");
  }
}

}

int TestGeodesicRanks(int argc, char* argv[])
{
  return RunOnRanks(argc, argv,
    [](Check& check, Ranks ranks)
    {
      const auto surface = NoisySquare(12);
      TestGlobalIds(check, ranks, surface);
      TestIdsMetElsewhere(check, ranks);
      TestRoundings(check, ranks, surface);
      TestSourcesOnRanks(check, ranks, surface);
      TestNames(check, ranks, SphereOfRanks());
      TestFarTargets(check, ranks, surface);
      TestPathsAtTargets(check, ranks, surface, 1.0);
      TestPathsAtTargets(check, ranks, surface, 1e40);
      TestFacesOfPaths(check, ranks, surface);
      TestUnreadableCells(check, ranks, surface);
      TestErrorsOfBarriers(check, ranks, WithBarriers(NoisySquare(16), IsInWall));
      TestFailures(check, ranks, surface);
      TestPointsThatAreNotFinite(check, ranks, surface);
      TestAgain(check, ranks, surface);
      TestPieces(check, ranks, surface);
      TestMatrix(check, ranks, surface);
    });
}
