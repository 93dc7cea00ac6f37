// SPDX-License-Identifier: BSD-3-Clause
// Under MPI: the refined pieces of all ranks are one surface, bit for bit, with one value of each
// array at each point; ghost cells are refined as the cells whose copies they are. On a plane all
// values are those of the straight line to the nearest source. What is reported is that of the
// whole.
#include "BarrierTesting.h"
#include "GeodesicTesting.h"
#include "RanksTesting.h"

#include "vtkDoubleArray.h"
#include "vtkGeodesicPaths.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"

#include <cmath>
#include <map>
#include <set>

using namespace GeodesicTesting;

namespace
{

const Point SourcePoint = { 0.2, 0.8, 0.0 };
const std::array<Point, 2> SourceLine = { { { 0.15, 0.3, 0.0 }, { 0.85, 0.6, 0.0 } } };

/// A point, which is source 0, and a line across all pieces, which is source 1.
vtkSmartPointer<vtkPolyData> Sources()
{
  auto sources = PointSources({ SourcePoint, SourceLine[0], SourceLine[1] });
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0 });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 1, 2 });
  sources->SetVerts(verts);
  sources->SetLines(lines);
  return sources;
}

/// A point of an output, and all that the filter has computed there. Made of doubles only.
struct Corner
{
  Point Place;
  double Distance;
  double SourceId;
  Point Foot;
  Point Gradient;
  double SignedDistance;
  double ArcLength;
  double Angle;
  std::array<double, 2> Texture;

  static constexpr std::size_t Count = 16;
  using Numbers = std::array<double, Count>;
  Numbers All() const
  {
    return { this->Place[0], this->Place[1], this->Place[2], this->Distance, this->SourceId,
      this->Foot[0], this->Foot[1], this->Foot[2], this->Gradient[0], this->Gradient[1],
      this->Gradient[2], this->SignedDistance, this->ArcLength, this->Angle, this->Texture[0],
      this->Texture[1] };
  }
};

/// What a triangle's corners have.
using Corners = std::array<Corner::Numbers, 3>;

Corner CornerAt(vtkPolyData* output, vtkIdType id)
{
  const auto get = [&](const char* name, double* to)
  {
    if (vtkDataArray* array = output->GetPointData()->GetArray(name))
    {
      array->GetTuple(id, to);
    }
  };
  Corner corner{};
  output->GetPoint(id, corner.Place.data());
  get("GeodesicDistance", &corner.Distance);
  get("SourceId", &corner.SourceId);
  get("ClosestSourcePoint", corner.Foot.data());
  get("DistanceGradient", corner.Gradient.data());
  get("SignedGeodesicDistance", &corner.SignedDistance);
  get("SourceArcLength", &corner.ArcLength);
  get("SourceAngle", &corner.Angle);
  get("SourceTextureCoordinates", corner.Texture.data());
  return corner;
}

/// The triangles of an output that are surface, or those that are copies by ghost arrays.
std::vector<Corners> TrianglesOf(vtkDataObject* output, bool areCopies)
{
  std::vector<Corners> triangles;
  for (vtkPolyData* part : LeavesOf(output))
  {
    vtkDataArray* ghosts = part->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType i = 0; i < part->GetNumberOfPolys(); ++i)
    {
      if ((ghosts && ghosts->GetTuple1(i) != 0.0) == areCopies)
      {
        vtkNew<vtkIdList> ids;
        part->GetPolys()->GetCellAtId(i, ids);
        triangles.push_back({ CornerAt(part, ids->GetId(0)).All(),
          CornerAt(part, ids->GetId(1)).All(), CornerAt(part, ids->GetId(2)).All() });
      }
    }
  }
  return triangles;
}

/// Those of all ranks.
std::vector<Corners> Gathered(const std::vector<Corners>& own)
{
  vtkNew<vtkDoubleArray> sent;
  for (const Corners& corners : own)
  {
    for (const Corner::Numbers& corner : corners)
    {
      for (const double value : corner)
      {
        sent->InsertNextValue(value);
      }
    }
  }
  vtkNew<vtkDoubleArray> received;
  vtkMultiProcessController::GetGlobalController()->AllGatherV(sent, received);
  constexpr std::size_t size = Corner::Count;
  std::vector<Corners> all(static_cast<std::size_t>(received->GetNumberOfValues()) / (3 * size));
  for (std::size_t i = 0; i < all.size() * 3 * size; ++i)
  {
    all[i / (3 * size)][i / size % 3][i % size] = received->GetValue(static_cast<vtkIdType>(i));
  }
  return all;
}

Point PlaceOf(const Corner::Numbers& corner)
{
  return { corner[0], corner[1], corner[2] };
}

/// The length of all edges with one triangle, with three, and so on. Those with two are left out:
/// refinement adds such. Edges whose ends differ in any number are different ones.
std::map<int, double> LengthsOfRims(const std::vector<Corners>& triangles)
{
  std::map<std::pair<Corner::Numbers, Corner::Numbers>, int> edges;
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
    if (count != 2)
    {
      const Point end = PlaceOf(ends.second);
      lengths[count] += DistanceToSegment(PlaceOf(ends.first), end, end);
    }
  }
  return lengths;
}

void CompareLengths(Check& check, const std::map<int, double>& actual,
  const std::map<int, double>& expected, const std::string& what)
{
  check.Equal(actual.size(), expected.size(), what + ": edges have as many triangles as before");
  for (const auto& [count, length] : expected)
  {
    const auto found = actual.find(count);
    check.That(found != actual.end() && std::abs(found->second - length) < 1e-9,
      what + ": edges of " + std::to_string(count) + " triangles are as long as before");
  }
}

/// Points on seams are the same on all ranks that have them in cells of their own, and copies of
/// cells are refined as what they are copies of.
void CheckRanksAgree(Check& check, const std::vector<Corners>& all,
  const std::vector<Corners>& copies, const std::string& what)
{
  std::map<Point, Corner::Numbers> at;
  std::set<Corners> known(all.begin(), all.end());
  bool areOne = true;
  for (const Corners& corners : all)
  {
    for (const Corner::Numbers& corner : corners)
    {
      areOne = areOne && at.emplace(PlaceOf(corner), corner).first->second == corner;
    }
  }
  check.That(areOne, what + ": points on seams are the same on all ranks");
  for (const Corners& copy : copies)
  {
    const bool isKnown = known.count(copy) + known.count({ copy[1], copy[2], copy[0] }) +
        known.count({ copy[2], copy[0], copy[1] }) >
      0;
    check.That(isKnown, what + ": a copy is as its original");
  }
}

/// Whether p is on the left of the line; 0 where its sides part.
double SideOfLine(const Point& p)
{
  const Point& a = SourceLine[0];
  const Point& b = SourceLine[1];
  const Point along = { b[0] - a[0], b[1] - a[1], 0.0 };
  const double at = (p[0] - a[0]) * along[0] + (p[1] - a[1]) * along[1];
  const bool isBeside = at > 1e-9 && at < along[0] * along[0] + along[1] * along[1] - 1e-9;
  const double side = along[0] * (p[1] - a[1]) - along[1] * (p[0] - a[0]);
  return isBeside && std::abs(side) > 1e-9 ? side : 0.0;
}

/// Along and across the line, around the point.
void CheckCoordinates(Check& check, const Corner& at, const double* frame, const std::string& what)
{
  if (at.SourceId == 0.0)
  {
    check.Equal(at.ArcLength, 0.0, what + ": arc length at a point");
    for (std::size_t x = 0; x < 3; ++x)
    {
      const double reached =
        SourcePoint[x] + at.Texture[0] * frame[x] + at.Texture[1] * frame[3 + x];
      check.Near(reached, at.Place[x], std::max(1e-12, 2e-3 * at.Distance),
        what + ": texture coordinates around the point");
      const double direction = at.Distance > 1e-6
        ? std::cos(at.Angle) * frame[x] + std::sin(at.Angle) * frame[3 + x] -
          (at.Place[x] - SourcePoint[x]) / DistanceToSegment(at.Place, SourcePoint, SourcePoint)
        : 0.0;
      check.That(std::abs(direction) <= 1e-9, what + ": angle around the point");
    }
    return;
  }
  check.Near(at.ArcLength, DistanceToSegment(at.Foot, SourceLine[0], SourceLine[0]), 1e-12,
    what + ": arc length");
  check.That(at.Texture[0] == at.ArcLength && at.Texture[1] == at.SignedDistance,
    what + ": texture coordinates along the line");
  const double side = SideOfLine(at.Place);
  check.That(side == 0.0 || std::abs(at.Angle - std::copysign(std::acos(0.0), side)) <= 1e-9,
    what + ": angle beside the line");
}

/// Whether the gradient at a point is the direction from the nearest point of a segment.
bool PointsAwayFrom(const Corner& at, const Point& a, const Point& b, double tolerance)
{
  const Point& p = at.Place;
  const double t = FractionNearestTo(p, a, b);
  const double distance = DistanceToSegment(p, a, b);
  bool is = true;
  for (std::size_t x = 0; x < 3; ++x)
  {
    const double direction = (p[x] - a[x] - t * (b[x] - a[x])) / distance;
    is = is && std::abs(at.Gradient[x] - direction) <= std::max(1e-9, 100.0 * tolerance);
  }
  return is;
}

/// \param tolerance of the distance and the gradient.
void CheckOnPlane(Check& check, const Corner& at, double tolerance, const std::string& what)
{
  const Point& p = at.Place;
  const double toPoint = DistanceToSegment(p, SourcePoint, SourcePoint);
  const double toLine = DistanceToSegment(p, SourceLine[0], SourceLine[1]);
  const double truth = std::min(toPoint, toLine);
  check.Near(at.Distance, truth, tolerance, what + ": distance");
  const bool isFromLine = at.SourceId == 1.0;
  check.Near((isFromLine ? toLine : toPoint), truth, 1e-12, what + ": source");
  const double besideSource = isFromLine ? DistanceToSegment(at.Foot, SourceLine[0], SourceLine[1])
                                         : DistanceToSegment(at.Foot, SourcePoint, SourcePoint);
  const double toFoot = DistanceToSegment(p, at.Foot, at.Foot);
  check.That(besideSource <= 1e-12 && std::abs(toFoot - truth) <= 1e-12, what + ": foot");
  // Where the sources are as far within the error, the gradient may be that of the other one.
  const bool isOfPoint =
    toPoint <= truth + tolerance && PointsAwayFrom(at, SourcePoint, SourcePoint, tolerance);
  const bool isOfLine =
    toLine <= truth + tolerance && PointsAwayFrom(at, SourceLine[0], SourceLine[1], tolerance);
  check.That(truth <= 1e-6 || isOfPoint || isOfLine, what + ": gradient");
  const double side = isFromLine ? SideOfLine(p) : 1.0;
  check.That(side == 0.0 || at.SignedDistance == std::copysign(at.Distance, side), what + ": sign");
}

struct Task
{
  std::string Name;
  vtkSmartPointer<vtkDataObject> Piece;
  /// In one process.
  vtkSmartPointer<vtkPolyData> Surface;
  bool IsFlat = false;
  double Tolerance = 1e-3;
  double RelativeError = 0.0;
  double MaximumDistance = 0.0;
  bool AreBordersRefined = false;

  bool HasBarriers() const { return this->Surface->GetCellData()->HasArray("barrier"); }
};

void Ask(vtkGeodesicDistanceField* filter, const Task& task)
{
  filter->SetInputDataObject(task.Piece);
  filter->SetSourceData(Sources());
  filter->SetRefinementTolerance(task.Tolerance);
  filter->SetRefineSourceBorders(task.AreBordersRefined);
  AskForAllArrays(filter);
  filter->SetTextureScale(1.0);
  filter->SetAccuracy(task.RelativeError > 0.0 ? vtkGeodesicDistanceField::APPROXIMATE
                                               : vtkGeodesicDistanceField::EXACT);
  filter->SetRelativeError(task.RelativeError);
  filter->SetMaximumDistance(task.MaximumDistance);
  filter->SetBarrierArrayName(task.HasBarriers() ? "barrier" : nullptr);
}

/// Those of the surface in one process, which is not refined.
std::map<int, double> LengthsOfWhole(const Task& task)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetController(nullptr);
  Ask(filter, task);
  filter->SetInputData(task.Surface);
  filter->RefineMeshOff();
  filter->Update();
  return LengthsOfRims(TrianglesOf(filter->GetOutput(), false));
}

void CheckBound(Check& check, vtkGeodesicDistanceField* filter, const Task& task)
{
  const double bound = filter->GetInterpolationErrorBound();
  check.That(bound > 0.0 && bound <= task.Tolerance * task.Surface->GetLength(),
    task.Name + ": the tolerance is met");
  check.That(Sum(bound) == bound * Sum(1.0), task.Name + ": one bound on all ranks");
}

/// The input's points come first, cells are parts of the input's.
void CheckPiece(Check& check, vtkPolyData* output, vtkPolyData* piece, const std::string& what)
{
  const std::vector<Point> before = PlacesOf(piece);
  const std::vector<Point> after = PlacesOf(output);
  const bool areSame =
    after.size() >= before.size() && std::equal(before.begin(), before.end(), after.begin());
  check.That(areSame, what + ": the input's points come first");
  vtkDataArray* ids = output->GetCellData()->GetArray("OriginalCellIds");
  check.That(
    ids && ids->GetNumberOfTuples() == output->GetNumberOfCells(), what + ": cells have parents");
  std::set<double> parents;
  for (vtkIdType i = 0; ids && i < ids->GetNumberOfTuples(); ++i)
  {
    parents.insert(ids->GetTuple1(i));
  }
  check.Equal(
    parents.size(), piece->GetNumberOfCells(), what + ": all cells of the piece have parts");
}

/// Checks the values at the points of this rank's cells.
void CheckValues(Check& check, vtkDataObject* output, const Task& task)
{
  vtkDataArray* frames = output->GetFieldData()->GetArray("SourceFrame");
  check.That(frames && frames->GetNumberOfTuples() == 2, task.Name + ": frames on every rank");
  std::array<double, 9> frame{};
  if (frames)
  {
    frames->GetTuple(0, frame.data());
  }
  double unreached = 0.0;
  for (vtkPolyData* part : LeavesOf(output))
  {
    vtkNew<vtkIdList> used;
    part->BuildLinks();
    for (vtkIdType id = 0; id < part->GetNumberOfPoints(); ++id)
    {
      part->GetPointCells(id, used);
      const Corner at = CornerAt(part, id);
      if (used->GetNumberOfIds() > 0 && at.SourceId < 0.0)
      {
        unreached += 1.0;
        const bool isSo = std::isinf(at.Distance) && at.Foot == at.Place &&
          at.Gradient == Point{} && std::isinf(at.SignedDistance) && std::isinf(at.ArcLength) &&
          std::isinf(at.Angle) && std::isinf(at.Texture[0]) && std::isinf(at.Texture[1]);
        check.That(isSo, task.Name + ": a point that is not reached has no source");
      }
      else if (used->GetNumberOfIds() > 0 && task.IsFlat)
      {
        CheckOnPlane(check, at, std::max(task.RelativeError, 1e-12), task.Name);
        CheckCoordinates(check, at, frame.data(), task.Name);
      }
    }
  }
  check.That((Sum(unreached) > 0.0) == (task.MaximumDistance > 0.0 || task.HasBarriers()),
    task.Name + ": points are not reached beyond the limit and in barriers");
}

/// Runs a task on all ranks, and checks all that holds for any.
void Run(Check& check, const Task& task)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  Ask(filter, task);
  RunWithoutError(check, filter, task.Name);
  vtkDataObject* output = filter->GetOutputDataObject(0);
  const std::vector<Corners> all = Gathered(TrianglesOf(output, false));
  const std::vector<Corners> copies = TrianglesOf(output, true);
  CheckRanksAgree(check, all, copies, task.Name);
  const auto ghosts = static_cast<double>(TrianglesOf(task.Piece, true).size());
  check.That((Sum(static_cast<double>(copies.size()) - ghosts) > 0.0) == (Sum(ghosts) > 0.0),
    task.Name + ": copies are refined where there are any");
  CompareLengths(check, LengthsOfRims(all), LengthsOfWhole(task), task.Name);
  check.That(task.MaximumDistance > 0.0 ||
      all.size() > 2 * static_cast<std::size_t>(task.Surface->GetNumberOfPolys()),
    task.Name + ": the surface is refined");
  CheckBound(check, filter, task);
  if (auto* piece = vtkPolyData::SafeDownCast(task.Piece))
  {
    CheckPiece(check, filter->GetOutput(), piece, task.Name);
  }
  CheckValues(check, output, task);
}

/// The faces of this rank, then those of all others as ghosts.
vtkSmartPointer<vtkPolyData> WithFarGhosts(vtkPolyData* surface, const Cut& cut, int rank)
{
  std::vector<vtkIdType> faces = FacesOf(surface, cut, rank);
  const std::size_t own = faces.size();
  for (vtkIdType face = 0; face < surface->GetNumberOfPolys(); ++face)
  {
    if (cut(face) != rank)
    {
      faces.push_back(face);
    }
  }
  return PartWithGhosts(surface, faces, own);
}

/// Two blocks on each rank, which are empty behind the first ranks.
vtkSmartPointer<vtkMultiBlockDataSet> InBlocks(
  vtkPolyData* surface, Ranks first, bool hasGhosts = false)
{
  const Cut cut = AtRandom(2 * first.Count);
  const auto block = [&](int number)
  { return hasGhosts ? PartWithGhosts(surface, cut, number) : PieceOf(surface, cut, number); };
  return Blocks({ block(2 * first.Rank), block(2 * first.Rank + 1) });
}

/// Every way in which ranks have a surface.
void TestCuts(Check& check, Ranks ranks, vtkPolyData* surface, const std::string& name, bool isFlat)
{
  const auto cuts = Cuts(surface, ranks,
    { "in strips", "at random",
      HasBarriers(surface) ? "barriers on a rank of their own" : "with nothing on the last rank" });
  Task task;
  task.Surface = surface;
  task.IsFlat = isFlat;
  const auto run = [&](const std::string& how, vtkDataObject* piece)
  {
    task.Name = name + " " + how;
    task.Piece = piece;
    Run(check, task);
  };
  for (const auto& [how, cut] : cuts)
  {
    const auto withGhosts = PartWithGhosts(surface, cut, ranks.Rank);
    run(how, PieceOf(surface, cut, ranks.Rank));
    task.Tolerance = 3e-4;
    run(how + ", with ghosts", withGhosts);
    task.Tolerance = 1e-3;
    if (task.HasBarriers())
    {
      continue;
    }
    task.MaximumDistance = 0.3;
    run(how + ", with ghosts, within a limit", withGhosts);
    task.MaximumDistance = 0.0;
    for (const double error : { 0.0, 1e-3 })
    {
      task.RelativeError = error;
      task.AreBordersRefined = true;
      task.Tolerance = 5e-3;
      run(how + ", with ghosts and borders, error " + std::to_string(error), withGhosts);
      task.AreBordersRefined = false;
      task.Tolerance = 1e-3;
    }
    run(how + ", with ghosts, approximately", withGhosts);
    task.RelativeError = 0.0;
  }
  run("mostly ghosts", WithFarGhosts(surface, AtRandom(ranks.Count), ranks.Rank));
  run("in blocks", InBlocks(surface, ranks));
  run("in blocks that are empty on the last rank",
    InBlocks(surface, { ranks.Rank, std::max(1, ranks.Count - 1) }));
  run("in blocks with ghosts", InBlocks(surface, ranks, true));
}

/// Ghosts that have no points in common with the cells around them.
void TestSoup(Check& check, Ranks ranks)
{
  const auto soup = Soup(Square(8));
  Run(check,
    { "a soup, mostly ghosts", WithFarGhosts(soup, AtRandom(ranks.Count), ranks.Rank), soup,
      true });
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
  const auto filter = RefinedField(Part(surface, faces), PointSources({ { 0.3, 0.4, 0.0 } }));
  filter->SetBarrierArrayName(HasBarriers(surface) ? "barrier" : nullptr);
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
  const auto piece = PieceAtRandom(surface, ranks);
  const auto filter = RefinedField(piece, PointSources({ { 0.3, 0.4, 0.0 } }));
  filter->SetBarrierArrayName(HasBarriers(surface) ? "barrier" : nullptr);
  filter->SetRefinementTolerance(1e-6);
  const vtkIdType most = 3 * surface->GetNumberOfPolys();
  filter->SetMaximumNumberOfCells(most);
  Messages messages(filter);
  messages.Update();
  const std::vector<Corners> all = Gathered(TrianglesOf(filter->GetOutput(), false));
  check.That(static_cast<vtkIdType>(all.size()) <= most &&
      static_cast<vtkIdType>(all.size()) > surface->GetNumberOfPolys(),
    "the maximum holds for all ranks together: " + std::to_string(all.size()));
  Task task;
  task.Surface = surface;
  CompareLengths(check, LengthsOfRims(all), LengthsOfWhole(task), "at the maximum");
  check.That(ranks.Rank > 0 || Contains(messages.Warning(), "MaximumNumberOfCells"),
    "and is told, on the first rank");
  filter->SetMaximumNumberOfCells(surface->GetNumberOfPolys() - 1);
  messages.Update();
  check.Equal(filter->GetOutput()->GetNumberOfCells(), piece->GetNumberOfCells(),
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
  const auto piece = PieceOf(surface, cut, ranks.Rank);
  const Point source = { corner[0] + 700.0, corner[1] + 3100.0, corner[2] };
  for (const int precision : { vtkAlgorithm::DEFAULT_PRECISION, vtkAlgorithm::SINGLE_PRECISION,
         vtkAlgorithm::DOUBLE_PRECISION })
  {
    const std::string what = "far from the origin, precision " + std::to_string(precision);
    const auto filter = RefinedField(piece, PointSources({ source }));
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
      for (const Corner::Numbers& at : corners)
      {
        measured =
          std::max(measured, std::abs(at[3] - DistanceToSegment(PlaceOf(at), source, source)));
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
    const auto filter =
      RefinedField(faces.empty() ? vtkSmartPointer<vtkPolyData>::New() : Part(surface, faces),
        PointSources({ { 0.3, 0.4, 0.0 } }));
    filter->Update();
    vtkPoints* points = filter->GetOutput()->GetPoints();
    check.That(points && points->GetDataType() == VTK_DOUBLE,
      std::to_string(withPieces) + " ranks with pieces: points of every piece are double");
  }
}

/// Where paths over all pieces end, and in which direction they leave from there.
void TestEndsOfPaths(Check& check, Ranks ranks, vtkPolyData* plane)
{
  for (const auto& [name, cut] : Cuts(plane, ranks, { "in strips", "at random" }))
  {
    const auto filter = FilterOn<vtkGeodesicPaths>(PieceOf(plane, cut, ranks.Rank), Sources());
    filter->SetTargetsData(plane);
    filter->GenerateSourceArcLengthOn();
    filter->GenerateSourceAngleOn();
    RunWithoutError(check, filter, name);
    vtkPolyData* output = filter->GetOutput();
    vtkDataArray* frames = output->GetFieldData()->GetArray("SourceFrame");
    check.That(frames && frames->GetNumberOfTuples() == 2, name + ": frames on every rank");
    check.That(Sum(static_cast<double>(output->GetNumberOfLines())) ==
        static_cast<double>(plane->GetNumberOfPoints()),
      name + ": a path from each point");
    std::array<double, 9> frame{};
    frames->GetTuple(0, frame.data());
    const auto valueOf = [output](const char* array, vtkIdType line)
    { return output->GetCellData()->GetArray(array)->GetTuple1(line); };
    for (vtkIdType line = 0; line < output->GetNumberOfLines(); ++line)
    {
      vtkNew<vtkIdList> ids;
      output->GetLines()->GetCellAtId(line, ids);
      Corner at{};
      output->GetPoint(ids->GetId(0), at.Place.data());
      output->GetPoint(ids->GetId(ids->GetNumberOfIds() - 1), at.Foot.data());
      at.SourceId = valueOf("SourceId", line);
      at.Distance = valueOf("GeodesicDistance", line);
      at.ArcLength = valueOf("SourceArcLength", line);
      at.Angle = valueOf("SourceAngle", line);
      at.SignedDistance = at.Distance;
      at.Texture = at.SourceId == 0.0 ? std::array<double, 2>{ at.Distance * std::cos(at.Angle),
        at.Distance * std::sin(at.Angle) }
                                      : std::array<double, 2>{ at.ArcLength, at.SignedDistance };
      CheckCoordinates(check, at, frame.data(), name);
    }
  }
}

/// A barrier is cut at the middle corner of a face without area at its edge, wherever that is.
void TestBarrierBesideCap(Check& check, Ranks ranks)
{
  const auto surface = Mesh({ { 0, 0, 0 }, { 2, 0, 0 }, { 1, 0, 0 }, { 1, -1, 0 }, { 1, 1, 0 } },
    { { 0, 3, 2 }, { 2, 3, 1 }, { 0, 2, 1 }, { 0, 1, 4 } });
  AddArray<vtkIntArray>(surface->GetCellData(), "barrier", { 0, 0, 0, 1 });
  const int last = ranks.Count - 1;
  const Cut cut = [last](vtkIdType face) { return face < 3 ? 0 : last; };
  const Point source = { 1, -1, 0 };
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(PieceOf(surface, cut, ranks.Rank));
  filter->SetBarrierArrayName("barrier");
  filter->SetSourceData(PointSources({ source }));
  filter->GenerateClosestPointsOn();
  RunWithoutError(check, filter, "a barrier beside a cap");
  vtkPolyData* output = filter->GetOutput();
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints() && ranks.Rank == last; ++i)
  {
    const Point p = PointAt(output, i);
    if (p[1] == 0.0)
    {
      Point closest;
      output->GetPointData()->GetArray("ClosestSourcePoint")->GetTuple(i, closest.data());
      check.Near(PointValue(output, "GeodesicDistance", i), std::hypot(p[0] - 1.0, 1.0), 1e-12,
        "on the rim of the barrier");
      check.That(closest == source, "all of the rim is nearest to the source");
      ++count;
    }
    check.That(p[1] == 0.0 || p == Point{ 1, 1, 0 } || last == 0,
      "points of the barrier are on its edge at the other faces, or its third corner");
  }
  check.That(ranks.Rank != last || count > 3, "the edge is cut and refined");
}

/// One rank is stopped while the arrays are computed: none waits for it.
void TestAbort(Check& check, Ranks ranks, vtkPolyData* surface)
{
  const auto piece = PartWithGhosts(surface, Strips(surface, ranks.Count), ranks.Rank);
  const Task task = { "after an abort", piece, surface, true };
  vtkNew<vtkGeodesicDistanceField> filter;
  Ask(filter, task);
  const Listener listener(filter, vtkCommand::ProgressEvent,
    [&]()
    {
      if (ranks.Rank == ranks.Count - 1 && filter->GetProgress() > 0.92)
      {
        filter->SetAbortExecute(1);
      }
    });
  RunWithoutError(check, filter, "an abort is no error");
  CheckOutputsEmpty(check, filter, "an abort on one rank");
  Run(check, task);
}

}

int TestGeodesicRanksRefined(int argc, char* argv[])
{
  return RunOnRanks(argc, argv,
    [](Check& check, Ranks ranks)
    {
      const auto plane = Square(8);
      const auto noisy = NoisySquare(8);
      // Wider than a cell, so that some of its points are inside.
      const auto walled = WithBarriers(
        NoisySquare(8), [](const Point& p) { return p[0] > 0.5 && p[0] < 0.75 && p[1] < 0.75; });
      TestCuts(check, ranks, plane, "a plane", true);
      TestCuts(check, ranks, noisy, "a surface", false);
      TestCuts(check, ranks, walled, "a surface with a wall", false);
      TestSoup(check, ranks);
      for (const auto& surface : { noisy, walled })
      {
        TestDuplicates(check, ranks, surface);
        TestMaximum(check, ranks, surface);
      }
      TestPrecisions(check, ranks);
      TestTypesOfEmptyPieces(check, ranks, Square(8, Cells::Triangles, VTK_FLOAT));
      TestEndsOfPaths(check, ranks, plane);
      TestBarrierBesideCap(check, ranks);
      TestAbort(check, ranks, plane);
    });
}
