// SPDX-License-Identifier: BSD-3-Clause
// Under MPI: each rank has the lines that cut its piece of a surface. The curves that they are go
// over all pieces, as in one process.
#include "GeodesicTesting.h"
#include "LineTesting.h"
#include "RanksTesting.h"

using namespace GeodesicTesting;

namespace
{

/// The lines of this rank: those of its piece, or one of many that were dealt out.
vtkSmartPointer<vtkPolyData> Dealt(vtkPolyData* lines, Ranks ranks)
{
  std::vector<Segment> own;
  const std::vector<Point> places = PlacesOf(lines);
  vtkIdType number = 0;
  for (const std::vector<vtkIdType>& ids : CellsOf(lines->GetLines()))
  {
    if (AtRandom(ranks.Count)(number++) == ranks.Rank)
    {
      own.push_back(
        { places[static_cast<std::size_t>(ids[0])], places[static_cast<std::size_t>(ids[1])] });
    }
  }
  return LinesOf(own);
}

/// The curve is one, has all its length, and arc lengths and signs are those along it.
void CheckLoop(Check& check, Ranks ranks, vtkPolyData* sphere, const Cut& cut, bool areDealt,
  const std::string& name)
{
  const double height = 0.013;
  const auto whole = Section(sphere, { 0, 0, 1 }, { 0, 0, height });
  const auto piece = PieceOf(sphere, cut, ranks.Rank);
  const auto filter = PlainField(
    piece, areDealt ? Dealt(whole, ranks) : Section(piece, { 0, 0, 1 }, { 0, 0, height }));
  filter->GenerateSourceIdsOn();
  filter->GenerateSourceArcLengthOn();
  filter->GenerateSignedDistanceOn();
  RunWithoutError(check, filter, name);
  if (ranks.Rank == 0)
  {
    vtkPolyData* curves = OutputOf(filter, 1);
    check.Equal(curves->GetNumberOfLines(), 1.0, name + ": curves");
    check.Equal(curves->GetNumberOfVerts(), 0.0, name + ": points");
    check.Near(TotalLength(curves), TotalLength(whole), 1e-12, name + ": its length");
    check.Equal(CellValue(curves, "SourceId", 0), 0.0, name + ": its id");
    check.That(
      curves->GetPointData()->GetArray("SourceArcLength")->GetRange()[1] > 0.9 * TotalLength(whole),
      name + ": arc lengths along all of it");
  }
  vtkPointData* values = filter->GetOutput()->GetPointData();
  double side = 0.0;
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    check.Equal(values->GetArray("SourceId")->GetTuple1(i), 0.0, name + ": ids");
    const double distance = values->GetArray("SignedGeodesicDistance")->GetTuple1(i) *
      (filter->GetOutput()->GetPoint(i)[2] - height);
    side = side == 0.0 ? distance : side;
    check.That(side * distance >= 0.0, name + ": the sign says on which side a point is");
  }
}

/// Ids are values of an array of the cells, wherever these are; a rank without cells needs none.
void CheckNames(Check& check, Ranks ranks, vtkPolyData* sphere)
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

}

int TestGeodesicRanksLines(int argc, char* argv[])
{
  return RunOnRanks(argc, argv,
    [](Check& check, Ranks ranks)
    {
      const auto sphere = ChangedSphere(19, 14,
        [](const Point& p) {
          return Point{ p[0] + 0.5, p[1] + 0.01 * p[0], p[2] };
        });
      for (const auto& [name, cut] : Cuts(sphere, ranks, { "in strips", "at random" }))
      {
        CheckLoop(check, ranks, sphere, cut, true, name + ", lines dealt out");
        CheckLoop(check, ranks, sphere, cut, false, name + ", lines of the piece");
      }
      CheckNames(check, ranks, sphere);
    });
}
