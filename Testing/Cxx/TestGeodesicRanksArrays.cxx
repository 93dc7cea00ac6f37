// SPDX-License-Identifier: BSD-3-Clause
// Under MPI: the arrays beside the distance at the points of a refined surface in pieces. Points of
// ghost cells have, bit for bit, what the ranks have there whose cells these are; on a plane all of
// it is that of the straight line to the nearest source.
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

using AllValues = std::array<double, 13>;

/// What an output has at a point.
struct Values
{
  double Distance;
  double SourceId;
  Point Foot;
  Point Gradient;
  double SignedDistance;
  double ArcLength;
  double Angle;
  std::array<double, 2> Texture;

  /// All of them.
  AllValues All() const
  {
    return { this->Distance, this->SourceId, this->Foot[0], this->Foot[1], this->Foot[2],
      this->Gradient[0], this->Gradient[1], this->Gradient[2], this->SignedDistance,
      this->ArcLength, this->Angle, this->Texture[0], this->Texture[1] };
  }
};

struct ValuedPoint
{
  Point Place;
  Values At;
  /// Whether the input does not have it.
  bool IsNew;
  /// Whether it belongs to a cell that is no copy.
  bool IsOwn;
};

/// The points that cells use.
std::vector<ValuedPoint> PointsOf(vtkPolyData* output, vtkIdType numberOfInputPoints)
{
  const auto array = [output](const char* name) { return output->GetPointData()->GetArray(name); };
  vtkDataArray* ghosts = output->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName());
  std::map<vtkIdType, bool> isOwn;
  for (vtkIdType cell = 0; cell < output->GetNumberOfPolys(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    output->GetPolys()->GetCellAtId(cell, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      bool& own = isOwn[ids->GetId(k)];
      own = own || !ghosts || ghosts->GetTuple1(cell) == 0.0;
    }
  }
  std::vector<ValuedPoint> points;
  for (const auto& [id, own] : isOwn)
  {
    ValuedPoint point{};
    output->GetPoint(id, point.Place.data());
    point.IsNew = id >= numberOfInputPoints;
    point.IsOwn = own;
    point.At.Distance = array("GeodesicDistance")->GetTuple1(id);
    point.At.SourceId = array("SourceId")->GetTuple1(id);
    array("ClosestSourcePoint")->GetTuple(id, point.At.Foot.data());
    array("DistanceGradient")->GetTuple(id, point.At.Gradient.data());
    point.At.SignedDistance = array("SignedGeodesicDistance")->GetTuple1(id);
    point.At.ArcLength = array("SourceArcLength")->GetTuple1(id);
    point.At.Angle = array("SourceAngle")->GetTuple1(id);
    output->GetPointData()->GetTCoords()->GetTuple(id, point.At.Texture.data());
    points.push_back(point);
  }
  return points;
}

std::vector<ValuedPoint> PointsOf(vtkDataObject* output, vtkDataObject* input)
{
  if (auto* data = vtkPolyData::SafeDownCast(output))
  {
    return PointsOf(data, vtkPolyData::SafeDownCast(input)->GetNumberOfPoints());
  }
  std::vector<ValuedPoint> points;
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(output);
  for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
  {
    const std::vector<ValuedPoint> more =
      PointsOf(blocks->GetBlock(i), vtkMultiBlockDataSet::SafeDownCast(input)->GetBlock(i));
    points.insert(points.end(), more.begin(), more.end());
  }
  return points;
}

/// What the ranks have at the places of their own cells' points.
std::map<Point, std::set<AllValues>> GatheredOwn(const std::vector<ValuedPoint>& points)
{
  vtkNew<vtkDoubleArray> sent;
  for (const ValuedPoint& point : points)
  {
    if (point.IsOwn)
    {
      for (const double x : point.Place)
      {
        sent->InsertNextValue(x);
      }
      for (const double value : point.At.All())
      {
        sent->InsertNextValue(value);
      }
    }
  }
  vtkNew<vtkDoubleArray> received;
  vtkMultiProcessController::GetGlobalController()->AllGatherV(sent, received);
  std::map<Point, std::set<AllValues>> all;
  for (vtkIdType i = 0; i < received->GetNumberOfValues(); i += 16)
  {
    const double* first = received->GetPointer(i);
    AllValues values;
    std::copy(first + 3, first + 16, values.begin());
    all[{ first[0], first[1], first[2] }].insert(values);
  }
  return all;
}

double Sum(double own)
{
  double all = 0.0;
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    &own, &all, 1, vtkCommunicator::SUM_OP);
  return all;
}

/// Points on seams are the same on all ranks that have them in cells of their own, and points of
/// ghost cells what they are there.
void CheckRanksAgree(Check& check, const std::vector<ValuedPoint>& points, bool areThereGhosts,
  const std::string& what)
{
  const auto owners = GatheredOwn(points);
  double newGhosts = 0.0;
  for (const ValuedPoint& point : points)
  {
    if (!point.IsOwn)
    {
      const auto found = owners.find(point.Place);
      check.That(found != owners.end() && found->second.count(point.At.All()) > 0,
        what + ": a point of a ghost cell is not as it is on the owner's rank");
      newGhosts += point.IsNew ? 1.0 : 0.0;
    }
  }
  const bool areOne =
    std::all_of(owners.begin(), owners.end(), [](const auto& at) { return at.second.size() == 1; });
  check.That(areOne, what + ": points on seams are the same on all ranks");
  newGhosts = Sum(newGhosts);
  check.That((newGhosts > 0.0) == areThereGhosts,
    what + ": new points of ghost cells: " + std::to_string(newGhosts));
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
void CheckCoordinates(
  Check& check, const ValuedPoint& point, const double* frame, const std::string& what)
{
  const Values& at = point.At;
  if (at.SourceId == 0.0)
  {
    check.Equal(at.ArcLength, 0.0, what + ": arc length at a point");
    for (std::size_t x = 0; x < 3; ++x)
    {
      const double reached =
        SourcePoint[x] + at.Texture[0] * frame[x] + at.Texture[1] * frame[3 + x];
      check.That(std::abs(reached - point.Place[x]) <= std::max(1e-12, 2e-3 * at.Distance),
        what + ": texture coordinates around the point");
      const double direction = at.Distance > 1e-6
        ? std::cos(at.Angle) * frame[x] + std::sin(at.Angle) * frame[3 + x] -
          (point.Place[x] - SourcePoint[x]) /
            DistanceToSegment(point.Place, SourcePoint, SourcePoint)
        : 0.0;
      check.That(std::abs(direction) <= 1e-9, what + ": angle around the point");
    }
    return;
  }
  check.That(
    std::abs(at.ArcLength - DistanceToSegment(at.Foot, SourceLine[0], SourceLine[0])) <= 1e-12,
    what + ": arc length");
  check.That(at.Texture[0] == at.ArcLength && at.Texture[1] == at.SignedDistance,
    what + ": texture coordinates along the line");
  const double side = SideOfLine(point.Place);
  check.That(side == 0.0 || std::abs(at.Angle - std::copysign(std::acos(0.0), side)) <= 1e-9,
    what + ": angle beside the line");
}

/// Whether the gradient at a point is the direction from the nearest point of a segment.
bool PointsAwayFrom(const ValuedPoint& point, const Point& a, const Point& b, double tolerance)
{
  const Point& p = point.Place;
  const double t = FractionNearestTo(p, a, b);
  const double distance = DistanceToSegment(p, a, b);
  bool is = true;
  for (std::size_t x = 0; x < 3; ++x)
  {
    const double direction = (p[x] - a[x] - t * (b[x] - a[x])) / distance;
    is = is && std::abs(point.At.Gradient[x] - direction) <= std::max(1e-9, 100.0 * tolerance);
  }
  return is;
}

/// \param tolerance of the distance and the gradient.
void CheckOnPlane(Check& check, const ValuedPoint& point, double tolerance, const std::string& what)
{
  const Point& p = point.Place;
  const Values& at = point.At;
  const double toPoint = DistanceToSegment(p, SourcePoint, SourcePoint);
  const double toLine = DistanceToSegment(p, SourceLine[0], SourceLine[1]);
  const double truth = std::min(toPoint, toLine);
  check.That(std::abs(at.Distance - truth) <= tolerance, what + ": distance");
  const bool isFromLine = at.SourceId == 1.0;
  check.That(std::abs((isFromLine ? toLine : toPoint) - truth) <= 1e-12, what + ": source");
  const double besideSource = isFromLine ? DistanceToSegment(at.Foot, SourceLine[0], SourceLine[1])
                                         : DistanceToSegment(at.Foot, SourcePoint, SourcePoint);
  const double toFoot = DistanceToSegment(p, at.Foot, at.Foot);
  check.That(besideSource <= 1e-12 && std::abs(toFoot - truth) <= 1e-12, what + ": foot");
  // Where the sources are as far within the error, the gradient may be that of the other one.
  const bool isOfPoint =
    toPoint <= truth + tolerance && PointsAwayFrom(point, SourcePoint, SourcePoint, tolerance);
  const bool isOfLine =
    toLine <= truth + tolerance && PointsAwayFrom(point, SourceLine[0], SourceLine[1], tolerance);
  check.That(truth <= 1e-6 || isOfPoint || isOfLine, what + ": gradient");
  const double side = isFromLine ? SideOfLine(p) : 1.0;
  check.That(side == 0.0 || at.SignedDistance == std::copysign(at.Distance, side), what + ": sign");
}

struct Task
{
  std::string Name;
  vtkSmartPointer<vtkDataObject> Piece;
  bool HasGhosts;
  bool IsFlat;
  double RelativeError = 0.0;
  double MaximumDistance = 0.0;
  bool HasBarriers = false;
  bool AreBordersRefined = false;
};

void Ask(vtkGeodesicDistanceField* filter, const Task& task)
{
  filter->SetInputDataObject(task.Piece);
  filter->SetSourceData(Sources());
  filter->SetRefinementTolerance(task.AreBordersRefined ? 5e-3 : 1e-3);
  filter->SetRefineSourceBorders(task.AreBordersRefined);
  filter->GenerateSourceIdsOn();
  filter->GenerateClosestPointsOn();
  filter->GenerateGradientsOn();
  filter->GenerateSignedDistanceOn();
  filter->GenerateSourceArcLengthOn();
  filter->GenerateSourceAngleOn();
  filter->GenerateTextureCoordinatesOn();
  filter->SetTextureScale(1.0);
  filter->SetAccuracy(task.RelativeError > 0.0 ? vtkGeodesicDistanceField::APPROXIMATE
                                               : vtkGeodesicDistanceField::EXACT);
  filter->SetRelativeError(task.RelativeError);
  filter->SetMaximumDistance(task.MaximumDistance);
  filter->SetBarrierArrayName(task.HasBarriers ? "barrier" : nullptr);
}

void Run(Check& check, const Task& task)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  Ask(filter, task);
  Messages messages(filter);
  messages.Update();
  check.That(messages.Error().empty(), task.Name + ": " + messages.Error());
  const std::vector<ValuedPoint> points = PointsOf(filter->GetOutputDataObject(0), task.Piece);
  CheckRanksAgree(check, points, task.HasGhosts, task.Name);
  vtkDataArray* frames = filter->GetOutputDataObject(0)->GetFieldData()->GetArray("SourceFrame");
  check.That(frames && frames->GetNumberOfTuples() == 2, task.Name + ": frames on every rank");
  std::array<double, 9> frame{};
  if (frames)
  {
    frames->GetTuple(0, frame.data());
  }
  double unreached = 0.0;
  for (const ValuedPoint& point : points)
  {
    if (point.At.SourceId < 0.0)
    {
      unreached += 1.0;
      const bool isSo = std::isinf(point.At.Distance) && point.At.Foot == point.Place &&
        point.At.Gradient == Point{} && std::isinf(point.At.SignedDistance) &&
        std::isinf(point.At.ArcLength) && std::isinf(point.At.Angle) &&
        std::isinf(point.At.Texture[0]) && std::isinf(point.At.Texture[1]);
      check.That(isSo, task.Name + ": a point that is not reached has no source");
    }
    else if (task.IsFlat)
    {
      CheckOnPlane(check, point, std::max(task.RelativeError, 1e-12), task.Name);
      CheckCoordinates(check, point, frame.data(), task.Name);
    }
  }
  check.That((Sum(unreached) > 0.0) == (task.MaximumDistance > 0.0 || task.HasBarriers),
    task.Name + ": points are not reached beyond the limit and in barriers");
}

void TestCuts(Check& check, Ranks ranks, vtkPolyData* surface, bool isFlat)
{
  struct NamedCut
  {
    std::string Name;
    Cut Faces;
    int Pieces;
  };
  const int fewer = std::max(1, ranks.Count - 1);
  const std::vector<NamedCut> cuts = {
    { "in strips", Strips(surface, ranks.Count), ranks.Count },
    { "at random", AtRandom(ranks.Count), ranks.Count },
    { "with nothing on the last rank", AtRandom(fewer), fewer },
  };
  for (const auto& [name, cut, pieces] : cuts)
  {
    const std::string of = name + (isFlat ? ", flat" : "");
    const bool hasGhosts = pieces > 1;
    const auto withGhosts = PartWithGhosts(surface, cut, ranks.Rank);
    Run(check, { of, Part(surface, FacesOf(surface, cut, ranks.Rank)), false, isFlat });
    Run(check, { of + ", with ghosts", withGhosts, hasGhosts, isFlat });
    Run(check, { of + ", with ghosts, approximately", withGhosts, hasGhosts, isFlat, 1e-3 });
    Run(check, { of + ", with ghosts, within a limit", withGhosts, hasGhosts, isFlat, 0.0, 0.3 });
    for (const double error : { 0.0, 1e-3 })
    {
      Run(check,
        { of + ", with ghosts and borders, error " + std::to_string(error), withGhosts, hasGhosts,
          isFlat, error, 0.0, false, true });
    }
  }
}

/// The whole surface on each rank, of which all but the rank's own cells are ghosts.
void TestFarGhosts(Check& check, Ranks ranks, vtkPolyData* surface, const std::string& name)
{
  const Cut cut = AtRandom(ranks.Count);
  std::vector<vtkIdType> faces = FacesOf(surface, cut, ranks.Rank);
  const std::size_t own = faces.size();
  for (vtkIdType face = 0; face < surface->GetNumberOfPolys(); ++face)
  {
    if (cut(face) != ranks.Rank)
    {
      faces.push_back(face);
    }
  }
  Run(check, { name, PartWithGhosts(surface, faces, own), ranks.Count > 1, true });
}

void TestBlocks(Check& check, Ranks ranks, vtkPolyData* surface)
{
  const Cut cut = AtRandom(2 * ranks.Count);
  for (const bool hasGhosts : { false, true })
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    for (int i = 0; i < 2; ++i)
    {
      const int number = 2 * ranks.Rank + i;
      blocks->SetBlock(static_cast<unsigned int>(i),
        hasGhosts ? PartWithGhosts(surface, cut, number)
                  : Part(surface, FacesOf(surface, cut, number)));
    }
    const std::string name = hasGhosts ? "blocks with ghosts" : "blocks";
    Run(check, { name, vtkDataObject::SafeDownCast(blocks), hasGhosts, true });
  }
}

/// Barriers are cut where other ranks have split their rims, and have the values of these there.
void TestBarriers(Check& check, Ranks ranks)
{
  // Wider than a cell, so that some of its points are inside.
  const auto surface = WithBarriers(
    NoisySquare(8), [](const Point& p) { return p[0] > 0.5 && p[0] < 0.75 && p[1] < 0.75; });
  const std::vector<std::pair<std::string, Cut>> cuts = {
    { "barriers in strips", Strips(surface, ranks.Count) },
    { "barriers at random", AtRandom(ranks.Count) },
    { "barriers on a rank of their own", BarriersApart(surface, ranks.Count) },
  };
  for (const auto& [name, cut] : cuts)
  {
    const bool hasGhosts = ranks.Count > 1;
    Run(check,
      { name, Part(surface, FacesOf(surface, cut, ranks.Rank)), false, false, 0.0, 0.0, true });
    Run(check,
      { name + ", with ghosts", PartWithGhosts(surface, cut, ranks.Rank), hasGhosts, false, 0.0,
        0.0, true });
  }
}

/// Where paths over all pieces end, and in which direction they leave from there.
void TestEndsOfPaths(Check& check, Ranks ranks, vtkPolyData* plane)
{
  for (const auto& [name, cut] :
    std::vector<std::pair<std::string, Cut>>{ { "paths in strips", Strips(plane, ranks.Count) },
      { "paths at random", AtRandom(ranks.Count) } })
  {
    vtkNew<vtkGeodesicPaths> filter;
    filter->SetInputData(Part(plane, FacesOf(plane, cut, ranks.Rank)));
    filter->SetSourceData(Sources());
    filter->SetTargetsData(plane);
    filter->GenerateSourceArcLengthOn();
    filter->GenerateSourceAngleOn();
    Messages messages(filter);
    messages.Update();
    check.That(messages.Error().empty(), name + ": " + messages.Error());
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
      ValuedPoint point{};
      output->GetPoint(ids->GetId(0), point.Place.data());
      output->GetPoint(ids->GetId(ids->GetNumberOfIds() - 1), point.At.Foot.data());
      point.At.SourceId = valueOf("SourceId", line);
      point.At.Distance = valueOf("GeodesicDistance", line);
      point.At.ArcLength = valueOf("SourceArcLength", line);
      point.At.Angle = valueOf("SourceAngle", line);
      point.At.SignedDistance = point.At.Distance;
      point.At.Texture = point.At.SourceId == 0.0
        ? std::array<double, 2>{ point.At.Distance * std::cos(point.At.Angle),
            point.At.Distance * std::sin(point.At.Angle) }
        : std::array<double, 2>{ point.At.ArcLength, point.At.SignedDistance };
      CheckCoordinates(check, point, frame.data(), name);
    }
  }
}

/// One rank is stopped while the arrays are computed: none waits for it.
void TestAbort(Check& check, Ranks ranks, vtkPolyData* surface)
{
  const auto piece = PartWithGhosts(surface, Strips(surface, ranks.Count), ranks.Rank);
  const Task task = { "after an abort", piece, ranks.Count > 1, true };
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
  Messages messages(filter);
  messages.Update();
  check.That(messages.Error().empty(), "an abort is no error: " + messages.Error());
  CheckOutputsEmpty(check, filter, "an abort on one rank");
  Run(check, task);
}

}

int TestGeodesicRanksArrays(int argc, char* argv[])
{
  return RunOnRanks(argc, argv,
    [](Check& check, Ranks ranks)
    {
      const auto plane = Square(8);
      TestCuts(check, ranks, plane, true);
      TestCuts(check, ranks, NoisySquare(8), false);
      TestFarGhosts(check, ranks, plane, "mostly ghosts");
      TestFarGhosts(check, ranks, Soup(plane), "mostly ghosts, no points in common");
      TestBlocks(check, ranks, plane);
      TestBarriers(check, ranks);
      TestEndsOfPaths(check, ranks, plane);
      TestAbort(check, ranks, plane);
    });
}
