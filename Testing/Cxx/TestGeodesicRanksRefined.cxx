// SPDX-License-Identifier: BSD-3-Clause
// Under MPI: the refined pieces of all ranks are one surface, bit for bit, and what is reported is
// that of the whole.
#include "BarrierTesting.h"
#include "GeodesicTesting.h"
#include "RanksTesting.h"

#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"

#include <map>
#include <set>

using namespace GeodesicTesting;

namespace
{

/// A point and the distance there.
using Corner = std::array<double, 4>;
using Corners = std::array<Corner, 3>;

/// The triangles of an output that are surface, or those that are copies by ghost arrays.
std::vector<Corners> TrianglesOf(vtkPolyData* output, bool areCopies)
{
  vtkDataArray* distances = output->GetPointData()->GetArray("GeodesicDistance");
  vtkDataArray* ghosts = output->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName());
  std::vector<Corners> triangles;
  for (vtkIdType i = 0; i < output->GetNumberOfPolys(); ++i)
  {
    if ((ghosts && ghosts->GetTuple1(i) != 0.0) != areCopies)
    {
      continue;
    }
    vtkNew<vtkIdList> ids;
    output->GetPolys()->GetCellAtId(i, ids);
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const vtkIdType id = ids->GetId(static_cast<vtkIdType>(k));
      output->GetPoint(id, corners[k].data());
      corners[k][3] = distances->GetTuple1(id);
    }
    triangles.push_back(corners);
  }
  return triangles;
}

std::vector<Corners> TrianglesOf(vtkDataObject* output, bool areCopies)
{
  if (auto* data = vtkPolyData::SafeDownCast(output))
  {
    return TrianglesOf(data, areCopies);
  }
  std::vector<Corners> triangles;
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(output);
  for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
  {
    const std::vector<Corners> own =
      TrianglesOf(vtkPolyData::SafeDownCast(blocks->GetBlock(i)), areCopies);
    triangles.insert(triangles.end(), own.begin(), own.end());
  }
  return triangles;
}

/// Those of all ranks.
std::vector<Corners> Gathered(const std::vector<Corners>& own)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  vtkNew<vtkDoubleArray> sent;
  for (const Corners& corners : own)
  {
    for (const Corner& corner : corners)
    {
      for (const double value : corner)
      {
        sent->InsertNextValue(value);
      }
    }
  }
  vtkNew<vtkDoubleArray> received;
  controller->AllGatherV(sent, received);
  std::vector<Corners> all(static_cast<std::size_t>(received->GetNumberOfValues() / 12));
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    for (std::size_t k = 0; k < 12; ++k)
    {
      all[i][k / 4][k % 4] = received->GetValue(static_cast<vtkIdType>(12 * i + k));
    }
  }
  return all;
}

/// The length of all edges with one triangle, with three, and so on. Those with two are left out:
/// refinement adds such.
std::map<int, double> LengthsOfRims(const std::vector<Corners>& triangles)
{
  std::map<std::pair<Corner, Corner>, int> edges;
  for (const Corners& corners : triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      ++edges[std::minmax(corners[k], corners[(k + 1) % 3])];
    }
  }
  std::map<int, double> lengths;
  for (const auto& [ends, count] : edges)
  {
    double squared = 0.0;
    for (std::size_t x = 0; x < 3; ++x)
    {
      squared += (ends.second[x] - ends.first[x]) * (ends.second[x] - ends.first[x]);
    }
    if (count != 2)
    {
      lengths[count] += std::sqrt(squared);
    }
  }
  return lengths;
}

void CompareLengths(Check& check, const std::map<int, double>& actual,
  const std::map<int, double>& expected, const std::string& what)
{
  check.Equal(static_cast<double>(actual.size()), static_cast<double>(expected.size()),
    what + ": edges have as many triangles as before");
  for (const auto& [count, length] : expected)
  {
    const auto found = actual.find(count);
    check.That(found != actual.end() && std::abs(found->second - length) < 1e-9,
      what + ": edges of " + std::to_string(count) + " triangles are as long as before");
  }
}

/// A surface may have barriers.
void AskForBarriers(vtkGeodesicDistanceField* filter, vtkPolyData* surface)
{
  filter->SetBarrierArrayName(surface->GetCellData()->HasArray("barrier") ? "barrier" : nullptr);
}

/// Those of the surface in one process, which is not refined.
std::map<int, double> LengthsOfWhole(vtkPolyData* surface)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetController(nullptr);
  filter->SetInputData(surface);
  AskForBarriers(filter, surface);
  filter->SetSourceData(PointSources({ { 0.3, 0.4, 0.0 } }));
  filter->RefineMeshOff();
  filter->Update();
  return LengthsOfRims(TrianglesOf(filter->GetOutput(), false));
}

/// What a piece and all others become.
void Compare(Check& check, vtkDataObject* piece, vtkPolyData* surface, double tolerance,
  double relativeError, const std::string& what)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputDataObject(piece);
  AskForBarriers(filter, surface);
  filter->SetSourceData(PointSources({ { 0.3, 0.4, 0.0 } }));
  filter->SetRefinementTolerance(tolerance);
  if (relativeError > 0.0)
  {
    filter->SetAccuracyToApproximate();
    filter->SetRelativeError(relativeError);
  }
  Messages messages(filter);
  messages.Update();
  check.That(messages.Error().empty(), what + ": " + messages.Error());
  const std::vector<Corners> all = Gathered(TrianglesOf(filter->GetOutputDataObject(0), false));
  check.That(all.size() > 2 * static_cast<std::size_t>(surface->GetNumberOfPolys()),
    what + ": the surface is refined");
  CompareLengths(check, LengthsOfRims(all), LengthsOfWhole(surface), what);

  const double bound = filter->GetInterpolationErrorBound();
  const double diagonal = surface->GetLength();
  check.That(bound > 0.0 && bound <= tolerance * diagonal, what + ": the tolerance is met");
  std::array<double, 2> bounds = { bound, -bound };
  std::array<double, 2> largest{};
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    bounds.data(), largest.data(), 2, vtkCommunicator::MAX_OP);
  check.That(largest[0] == -largest[1], what + ": one bound on all ranks");

  std::set<Corners> known(all.begin(), all.end());
  for (const Corners& copy : TrianglesOf(filter->GetOutputDataObject(0), true))
  {
    const bool isKnown = known.count(copy) + known.count({ copy[1], copy[2], copy[0] }) +
        known.count({ copy[2], copy[0], copy[1] }) >
      0;
    check.That(isKnown, what + ": a copy looks like its original");
  }
}

/// The input's points come first, cells are parts of the input's.
void CheckPiece(Check& check, vtkPolyData* piece)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(piece);
  AskForBarriers(filter, piece);
  filter->SetSourceData(PointSources({ { 0.3, 0.4, 0.0 } }));
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  bool areSame = output->GetNumberOfPoints() >= piece->GetNumberOfPoints();
  for (vtkIdType i = 0; areSame && i < piece->GetNumberOfPoints(); ++i)
  {
    Point before;
    Point after;
    piece->GetPoint(i, before.data());
    output->GetPoint(i, after.data());
    areSame = before == after;
  }
  check.That(areSame, "the input's points come first");
  vtkDataArray* ids = output->GetCellData()->GetArray("OriginalCellIds");
  check.That(ids && ids->GetNumberOfTuples() == output->GetNumberOfCells(), "cells have parents");
  std::set<double> parents;
  for (vtkIdType i = 0; ids && i < ids->GetNumberOfTuples(); ++i)
  {
    parents.insert(ids->GetTuple1(i));
  }
  check.Equal(static_cast<double>(parents.size()), static_cast<double>(piece->GetNumberOfCells()),
    "all cells of the piece have parts");
}

void TestCuts(Check& check, Ranks ranks, vtkPolyData* surface)
{
  const std::vector<std::pair<std::string, Cut>> cuts = {
    { "in strips", Strips(surface, ranks.Count) },
    { "at random", AtRandom(ranks.Count) },
    { "with nothing on the last rank", AtRandom(std::max(1, ranks.Count - 1)) },
  };
  for (const auto& [name, cut] : cuts)
  {
    const auto piece = Part(surface, FacesOf(surface, cut, ranks.Rank));
    const auto withGhosts = PartWithGhosts(surface, cut, ranks.Rank);
    for (const double tolerance : { 3e-3, 3e-4 })
    {
      Compare(check, piece, surface, tolerance, 0.0, name);
      Compare(check, piece, surface, tolerance, 1e-3, name + ", approximately");
      Compare(check, withGhosts, surface, tolerance, 0.0, name + ", with ghost cells");
    }
    CheckPiece(check, piece);
    CheckPiece(check, withGhosts);
  }
}

void TestBlocks(Check& check, Ranks ranks, vtkPolyData* surface)
{
  const Cut cut = AtRandom(2 * ranks.Count);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int i = 0; i < 2; ++i)
  {
    blocks->SetBlock(
      static_cast<unsigned int>(i), Part(surface, FacesOf(surface, cut, 2 * ranks.Rank + i)));
  }
  Compare(check, blocks, surface, 3e-4, 0.0, "blocks on each rank");
}

/// Ghost cells far from the rank's own, whose points no own face has.
void TestFarGhosts(Check& check, Ranks ranks, vtkPolyData* surface)
{
  const Cut cut = Strips(surface, ranks.Count);
  std::vector<vtkIdType> faces = FacesOf(surface, cut, ranks.Rank);
  const std::size_t own = faces.size();
  for (vtkIdType face = 0; face < surface->GetNumberOfPolys(); ++face)
  {
    if (cut(face) != ranks.Rank)
    {
      faces.push_back(face);
    }
  }
  const auto piece = PartWithGhosts(surface, faces, own);
  Compare(check, piece, surface, 3e-4, 0.0, "the whole on each rank, mostly ghosts");
}

/// Faces on the same vertices on two ranks are one, and look the same.
void TestDuplicates(Check& check, Ranks ranks, vtkPolyData* surface)
{
  std::vector<vtkIdType> faces = FacesOf(surface, Strips(surface, ranks.Count), ranks.Rank);
  const vtkIdType shared = 7;
  if (std::find(faces.begin(), faces.end(), shared) == faces.end())
  {
    faces.push_back(shared);
  }
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(Part(surface, faces));
  AskForBarriers(filter, surface);
  filter->SetSourceData(PointSources({ { 0.3, 0.4, 0.0 } }));
  filter->SetRefinementTolerance(3e-4);
  filter->Update();
  std::map<Corners, int> count;
  for (const Corners& corners : Gathered(TrianglesOf(filter->GetOutput(), false)))
  {
    ++count[corners];
  }
  const auto several = std::count_if(
    count.begin(), count.end(), [&](const auto& one) { return one.second == ranks.Count; });
  check.That(ranks.Count == 1 || several > 1, "the same faces on all ranks have the same parts");
  check.That(std::all_of(count.begin(), count.end(),
               [&](const auto& one) { return one.second == 1 || one.second == ranks.Count; }),
    "and no others are there several times");
}

/// The maximum counts all ranks' cells.
void TestMaximum(Check& check, Ranks ranks, vtkPolyData* surface)
{
  const auto piece = Part(surface, FacesOf(surface, AtRandom(ranks.Count), ranks.Rank));
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(piece);
  AskForBarriers(filter, surface);
  filter->SetSourceData(PointSources({ { 0.3, 0.4, 0.0 } }));
  filter->SetRefinementTolerance(1e-6);
  const vtkIdType most = 3 * surface->GetNumberOfPolys();
  filter->SetMaximumNumberOfCells(most);
  Messages messages(filter);
  messages.Update();
  const std::vector<Corners> all = Gathered(TrianglesOf(filter->GetOutput(), false));
  check.That(static_cast<vtkIdType>(all.size()) <= most &&
      static_cast<vtkIdType>(all.size()) > surface->GetNumberOfPolys(),
    "the maximum holds for all ranks together: " + std::to_string(all.size()));
  CompareLengths(check, LengthsOfRims(all), LengthsOfWhole(surface), "at the maximum");
  check.That(ranks.Rank > 0 || Contains(messages.Warning(), "MaximumNumberOfCells"),
    "and is told, on the first rank");
  filter->SetMaximumNumberOfCells(surface->GetNumberOfPolys() - 1);
  messages.Update();
  check.Equal(static_cast<double>(filter->GetOutput()->GetNumberOfCells()),
    static_cast<double>(piece->GetNumberOfCells()),
    "a surface with more faces than the maximum is not refined");
}

/// Far from the origin, where coordinates are rounded in single precision, seams fit in every
/// precision, all ranks have the same, and the bound holds for the points as they are stored.
void TestPrecisions(Check& check, Ranks ranks)
{
  constexpr double size = 8192.0;
  const Point corner = { 654000.0, 5412000.0, 100.0 };
  const auto surface = Square(8, Cells::Triangles, VTK_FLOAT);
  const Cut strips = Strips(surface, ranks.Count);
  std::vector<int> rankOf;
  for (vtkIdType face = 0; face < surface->GetNumberOfPolys(); ++face)
  {
    rankOf.push_back(strips(face));
  }
  MovePoints(surface,
    [&](const Point& p) {
      return Point{ corner[0] + size * p[0], corner[1] + size * p[1], corner[2] };
    });
  const Cut cut = [&rankOf](vtkIdType face) { return rankOf[static_cast<std::size_t>(face)]; };
  const auto piece = Part(surface, FacesOf(surface, cut, ranks.Rank));
  const Point source = { corner[0] + 700.0, corner[1] + 3100.0, corner[2] };
  for (const int precision : { vtkAlgorithm::DEFAULT_PRECISION, vtkAlgorithm::SINGLE_PRECISION,
         vtkAlgorithm::DOUBLE_PRECISION })
  {
    const std::string what = "far from the origin, precision " + std::to_string(precision);
    vtkNew<vtkGeodesicDistanceField> filter;
    filter->SetInputData(piece);
    filter->SetSourceData(PointSources({ source }));
    filter->SetRefinementTolerance(1e-4);
    filter->SetOutputPointsPrecision(precision);
    filter->Update();
    const std::vector<Corners> all = Gathered(TrianglesOf(filter->GetOutput(), false));
    const std::map<int, double> rims = LengthsOfRims(all);
    check.That(rims.size() == 1 && std::abs(rims.at(1) - 4.0 * size) < 1e-3,
      what + ": no gap between the pieces");
    double measured = 0.0;
    for (const Corners& corners : all)
    {
      for (const Corner& at : corners)
      {
        measured = std::max(
          measured, std::abs(at[3] - DistanceToSegment({ at[0], at[1], at[2] }, source, source)));
      }
    }
    const double bound = filter->GetInterpolationErrorBound();
    check.That(measured <= bound && bound <= 1e-4 * std::sqrt(2.0) * size,
      what + ": measured " + std::to_string(measured) + ", reported " + std::to_string(bound));

    // A limit leaves the last piece as it is, but all are one data set, of one type.
    filter->SetMaximumDistance(100.0);
    filter->Update();
    check.That(ranks.Rank == 0 || ranks.Rank + 1 < ranks.Count ||
        filter->GetOutput()->GetNumberOfPoints() == piece->GetNumberOfPoints(),
      what + ": the last piece is not refined");
    check.Equal(filter->GetOutput()->GetPoints()->GetDataType(),
      precision == vtkAlgorithm::SINGLE_PRECISION ? VTK_FLOAT : VTK_DOUBLE,
      what + ": type of the points of every piece");
  }
}

/// Pieces are one data set, also those of ranks that have nothing of the surface: readers of files
/// of pieces rely on one type of points.
void TestTypesOfEmptyPieces(Check& check, Ranks ranks, vtkPolyData* surface)
{
  for (const int withPieces : { 1, ranks.Count - 1 })
  {
    const Cut cut = [&](vtkIdType face) { return ranks.Count - 1 - AtRandom(withPieces)(face); };
    const std::vector<vtkIdType> faces = FacesOf(surface, cut, ranks.Rank);
    vtkNew<vtkGeodesicDistanceField> filter;
    filter->SetInputData(
      faces.empty() ? vtkSmartPointer<vtkPolyData>::New() : Part(surface, faces));
    filter->SetSourceData(PointSources({ { 0.3, 0.4, 0.0 } }));
    filter->Update();
    vtkPoints* points = filter->GetOutput()->GetPoints();
    check.That(points && points->GetDataType() == VTK_DOUBLE,
      std::to_string(withPieces) + " ranks with pieces: points of every piece are double");
  }
}

/// Barriers are cut where their rims are split, on whichever rank.
void TestBarriers(Check& check, Ranks ranks)
{
  const auto surface = WithBarriers(NoisySquare(8), IsInWall);
  const std::vector<std::pair<std::string, Cut>> cuts = {
    { "barriers in strips", Strips(surface, ranks.Count) },
    { "barriers at random", AtRandom(ranks.Count) },
    { "barriers on a rank of their own", BarriersApart(surface, ranks.Count) },
  };
  for (const auto& [name, cut] : cuts)
  {
    const auto piece = Part(surface, FacesOf(surface, cut, ranks.Rank));
    Compare(check, piece, surface, 3e-4, 0.0, name);
    Compare(
      check, PartWithGhosts(surface, cut, ranks.Rank), surface, 3e-4, 0.0, name + ", with ghosts");
    CheckPiece(check, piece);
  }
  TestBlocks(check, ranks, surface);
  TestFarGhosts(check, ranks, surface);
  TestDuplicates(check, ranks, surface);
  TestMaximum(check, ranks, surface);
}

}

int TestGeodesicRanksRefined(int argc, char* argv[])
{
  return RunOnRanks(argc, argv,
    [](Check& check, Ranks ranks)
    {
      const auto surface = NoisySquare(8);
      TestCuts(check, ranks, surface);
      TestBlocks(check, ranks, surface);
      TestFarGhosts(check, ranks, surface);
      TestDuplicates(check, ranks, surface);
      TestMaximum(check, ranks, surface);
      TestBarriers(check, ranks);
      TestPrecisions(check, ranks);
      TestTypesOfEmptyPieces(check, ranks, Square(8, Cells::Triangles, VTK_FLOAT));
    });
}
