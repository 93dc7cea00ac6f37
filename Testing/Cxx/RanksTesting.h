// SPDX-License-Identifier: BSD-3-Clause
#ifndef RanksTesting_h
#define RanksTesting_h

#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkMPIController.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkUnsignedCharArray.h"

#include <functional>
#include <map>
#include <random>
#include <set>

/// Surfaces cut into pieces for tests under MPI.
namespace GeodesicTesting
{

/// The rank that has a face; the number of ranks: none.
using Cut = std::function<int(vtkIdType face)>;

struct Ranks
{
  int Rank;
  int Count;
};

/// Strips along the first axis of something as large as the unit square.
inline Cut Strips(vtkPolyData* surface, int count)
{
  return [surface, count](vtkIdType face)
  { return std::clamp(static_cast<int>(CentreOf(surface, face)[0] * count), 0, count - 1); };
}

inline Cut AtRandom(int count)
{
  return [count](vtkIdType face)
  {
    std::mt19937_64 random(static_cast<std::uint64_t>(face) + 17);
    return static_cast<int>(random() % static_cast<unsigned>(count));
  };
}

/// All barriers, by the array "barrier", on the last rank, which has nothing else where there are
/// several; the other faces at random.
inline Cut BarriersApart(vtkPolyData* surface, int count)
{
  return [surface, count](vtkIdType face)
  {
    const bool isBarrier = CellValue(surface, "barrier", face) != 0.0;
    return isBarrier ? count - 1 : AtRandom(std::max(1, count - 1))(face);
  };
}

inline std::vector<vtkIdType> FacesOf(vtkPolyData* surface, const Cut& cut, int rank)
{
  std::vector<vtkIdType> faces;
  for (vtkIdType face = 0; face < surface->GetNumberOfPolys(); ++face)
  {
    if (cut(face) == rank)
    {
      faces.push_back(face);
    }
  }
  return faces;
}

/// What a rank has of a surface.
inline vtkSmartPointer<vtkPolyData> PieceOf(
  vtkPolyData* surface, const Cut& cut, int rank, bool hasGlobalIds = false)
{
  return Part(surface, FacesOf(surface, cut, rank), hasGlobalIds);
}

inline vtkSmartPointer<vtkPolyData> PieceAtRandom(
  vtkPolyData* surface, Ranks ranks, bool hasGlobalIds = false)
{
  return PieceOf(surface, AtRandom(ranks.Count), ranks.Rank, hasGlobalIds);
}

/// Some faces of a surface, of which those after the first few are copies of other ranks'; a ghost
/// array marks them.
inline vtkSmartPointer<vtkPolyData> PartWithGhosts(vtkPolyData* surface,
  const std::vector<vtkIdType>& faces, std::size_t own, bool hasGlobalIds = false)
{
  auto part = Part(surface, faces, hasGlobalIds);
  AddArrayOf<vtkUnsignedCharArray>(part->GetCellData(), vtkDataSetAttributes::GhostArrayName(),
    part->GetNumberOfCells(),
    [own](vtkIdType i)
    { return i < static_cast<vtkIdType>(own) ? 0 : vtkDataSetAttributes::DUPLICATECELL; });
  return part;
}

/// A rank's faces, then copies of all others around their points.
inline vtkSmartPointer<vtkPolyData> PartWithGhosts(
  vtkPolyData* surface, const Cut& cut, int rank, bool hasGlobalIds = false)
{
  std::vector<vtkIdType> faces = FacesOf(surface, cut, rank);
  const std::size_t own = faces.size();
  std::set<vtkIdType> ownPoints;
  for (const vtkIdType face : faces)
  {
    const std::vector<vtkIdType> ids = IdsOf(surface->GetPolys(), face);
    ownPoints.insert(ids.begin(), ids.end());
  }
  for (vtkIdType face = 0; face < surface->GetNumberOfPolys(); ++face)
  {
    const std::vector<vtkIdType> ids = IdsOf(surface->GetPolys(), face);
    if (cut(face) != rank &&
      std::any_of(ids.begin(), ids.end(), [&](vtkIdType id) { return ownPoints.count(id) > 0; }))
    {
      faces.push_back(face);
    }
  }
  return PartWithGhosts(surface, faces, own, hasGlobalIds);
}

/// Each face goes to the nearest of some points of the surface, one a rank.
inline Cut InSpace(vtkPolyData* surface, int count)
{
  std::vector<Point> middles;
  for (int i = 0; i < count; ++i)
  {
    middles.push_back(CentreOf(surface, (2 * i + 1) * surface->GetNumberOfPolys() / (2 * count)));
  }
  return [surface, middles](vtkIdType face)
  {
    const Point centre = CentreOf(surface, face);
    const auto squared = [&centre](const Point& p)
    { return Dot(Minus(p, centre), Minus(p, centre)); };
    const auto nearest = std::min_element(middles.begin(), middles.end(),
      [&](const Point& a, const Point& b) { return squared(a) < squared(b); });
    return static_cast<int>(nearest - middles.begin());
  };
}

/// The named ways to cut a surface.
inline std::vector<std::pair<std::string, Cut>> Cuts(
  vtkPolyData* surface, Ranks ranks, const std::vector<std::string>& names)
{
  const int count = ranks.Count;
  const std::map<std::string, Cut> all = {
    { "in strips", Strips(surface, count) },
    { "in space", InSpace(surface, count) },
    { "at random", AtRandom(count) },
    { "with nothing on the last rank", AtRandom(std::max(1, count - 1)) },
    { "with nothing on the first rank",
      [count](vtkIdType face) { return count == 1 ? 0 : 1 + AtRandom(count - 1)(face); } },
    { "all on the last rank", [count](vtkIdType) { return count - 1; } },
    { "barriers on a rank of their own", BarriersApart(surface, count) },
  };
  std::vector<std::pair<std::string, Cut>> cuts;
  for (const std::string& name : names)
  {
    cuts.emplace_back(name, all.at(name));
  }
  return cuts;
}

/// Of all ranks.
inline double Sum(double own)
{
  double all = 0.0;
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    &own, &all, 1, vtkCommunicator::SUM_OP);
  return all;
}

/// What is asked of the filter.
struct Question
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Source;
  int SourceType = vtkGeodesicDistanceField::SOURCE_CURVE;
  double MaximumDistance = 0.0;
  bool IsApproximate = false;
  /// Whether the surface has them, so that there is a signed distance.
  bool HasSides = true;
};

/// Sources of all kinds in the unit square, beside IsInWall().
inline std::vector<Question> Questions()
{
  Question point{ "a point", PointSources({ { 0.3, 0.4, 0.0 } }) };
  Question points{ "points", PointSources({ { 0.1, 0.1, 0 }, { 0.9, 0.2, 0 }, { 0.5, 0.9, 0 } }) };
  Question curve{ "a curve through all", Polyline({ { 0.05, 0.3, 0 }, { 0.95, 0.6, 0 } }) };
  Question loop{ "a loop", Polyline({ { 0.3, 0.3, 0 }, { 0.7, 0.35, 0 }, { 0.5, 0.8, 0 } }, true) };
  Question boundary{ "the boundary", nullptr, vtkGeodesicDistanceField::SURFACE_BOUNDARY };
  Question both = point;
  both.Name = "a point and the boundary";
  both.SourceType = vtkGeodesicDistanceField::CURVE_AND_BOUNDARY;
  Question limited = point;
  limited.Name = "a point within a limit";
  limited.MaximumDistance = 0.3;
  Question approximate = curve;
  approximate.Name = "a curve, approximately";
  approximate.IsApproximate = true;
  return { point, points, curve, loop, boundary, both, limited, approximate };
}

inline bool HasBarriers(vtkPolyData* surface)
{
  return surface->GetCellData()->HasArray("barrier") != 0;
}

/// Asks for the distance and all arrays beside it. A surface may have barriers.
inline void Ask(
  vtkGeodesicDistanceField* filter, const Question& question, bool hasBarriers = false)
{
  filter->RefineMeshOff();
  filter->SetBarrierArrayName(hasBarriers ? "barrier" : nullptr);
  filter->SetSourceData(question.Source);
  filter->SetSourceType(question.SourceType);
  filter->SetMaximumDistance(question.MaximumDistance);
  filter->SetAccuracy(question.IsApproximate ? vtkGeodesicDistanceField::APPROXIMATE
                                             : vtkGeodesicDistanceField::EXACT);
  filter->SetRelativeError(0.01);
  filter->GenerateSourceIdsOn();
  filter->GenerateClosestPointsOn();
  filter->GenerateGradientsOn();
  filter->GenerateSourceArcLengthOn();
  filter->SetGenerateSignedDistance(question.HasSides);
  filter->SetGenerateTextureCoordinates(question.HasSides);
}

/// A filter with a rank's piece.
inline vtkSmartPointer<vtkGeodesicDistanceField> Asked(
  vtkDataObject* piece, const Question& question, bool hasBarriers = false)
{
  auto filter = vtkSmartPointer<vtkGeodesicDistanceField>::New();
  filter->SetInputDataObject(0, piece);
  Ask(filter, question, hasBarriers);
  return filter;
}

/// What one process finds on a surface, by place.
class Whole
{
public:
  Whole(vtkPolyData* surface, const Question& question)
  {
    this->Filter->SetController(nullptr);
    this->Filter->SetInputData(surface);
    Ask(this->Filter, question, HasBarriers(surface));
    Messages messages(this->Filter);
    messages.Update();
    this->Warning = messages.Warning();
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      const Point p = PointAt(surface, i);
      this->NumberAt[p] = i;
      const double distance = this->DistanceAt(p);
      this->Largest = std::isfinite(distance) ? std::max(this->Largest, distance) : this->Largest;
    }
  }

  double DistanceAt(const Point& p) const
  {
    return Distances(this->Filter)->GetTuple1(this->NumberAt.at(p));
  }

  vtkNew<vtkGeodesicDistanceField> Filter;
  std::map<Point, vtkIdType> NumberAt;
  double Largest = 0.0;
  std::string Warning;
};

/// Compares arrays at the points of a rank's output.
inline void CompareArrays(Check& check, vtkPolyData* output, const Whole& whole,
  const std::vector<std::pair<std::string, double>>& arraysAndTolerances, const std::string& what)
{
  for (const auto& [name, tolerance] : arraysAndTolerances)
  {
    vtkDataArray* actual = output->GetPointData()->GetArray(name.c_str());
    vtkDataArray* expected = whole.Filter->GetOutput()->GetPointData()->GetArray(name.c_str());
    if (!actual || !expected || actual->GetNumberOfTuples() != output->GetNumberOfPoints())
    {
      check.That(false, what + ": no " + name + " at every point");
      continue;
    }
    double worst = 0.0;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const Point p = PointAt(output, i);
      const auto at = whole.NumberAt.find(p);
      check.That(at != whole.NumberAt.end(), what + ": a point that the surface does not have");
      for (int k = 0; at != whole.NumberAt.end() && k < actual->GetNumberOfComponents(); ++k)
      {
        const double a = actual->GetComponent(i, k);
        const double b = expected->GetComponent(at->second, k);
        const double error = a == b ? 0.0 : std::abs(a - b);
        worst = std::isnan(worst) || error <= worst ? worst : error;
      }
    }
    check.That(worst <= tolerance * std::max(1.0, whole.Largest),
      what + ": " + name + " is wrong by " + std::to_string(worst));
  }
}

inline void CompareDistances(
  Check& check, vtkPolyData* output, const Whole& whole, const std::string& what)
{
  CompareArrays(check, output, whole, { { "GeodesicDistance", 1e-12 } }, what);
}

/// Runs the filter with this rank's piece and compares with the surface in one process.
inline void Compare(Check& check, vtkDataObject* piece, vtkPolyData* surface,
  const Question& question, const std::string& name)
{
  const std::string what = name + ", " + question.Name;
  const Whole whole(surface, question);
  const auto filter = Asked(piece, question, HasBarriers(surface));
  Messages messages(filter);
  messages.Update();
  check.That(messages.Error().empty() && (messages.Warning().empty() || !whole.Warning.empty()),
    what + ": " + messages.Error() + messages.Warning());
  std::vector<std::pair<std::string, double>> arrays = { { "GeodesicDistance",
    question.IsApproximate ? 0.02 : 1e-12 } };
  if (!question.IsApproximate && question.HasSides)
  {
    // Directions are known to the roots of roundings of distances at best.
    arrays.insert(arrays.end(),
      { { "SourceId", 0.0 }, { "ClosestSourcePoint", 1e-12 }, { "DistanceGradient", 1e-6 },
        { "SignedGeodesicDistance", 1e-12 } });
    // Where a loop of the boundary begins depends on the order of the faces.
    if (question.SourceType == vtkGeodesicDistanceField::SOURCE_CURVE)
    {
      arrays.insert(
        arrays.end(), { { "SourceArcLength", 1e-12 }, { "SourceTextureCoordinates", 1e-11 } });
    }
  }
  for (vtkPolyData* output : LeavesOf(filter->GetOutputDataObject(0)))
  {
    CompareArrays(check, output, whole, arrays, what);
  }
  if (auto* input = vtkPolyData::SafeDownCast(piece))
  {
    check.That(filter->GetOutput()->GetNumberOfPoints() == input->GetNumberOfPoints() &&
        filter->GetOutput()->GetNumberOfPolys() == input->GetNumberOfPolys(),
      what + ": the output is the rank's own piece");
  }
  const auto near = [&](double actual, double expected, double tolerance, const std::string& of)
  { check.Near(actual, expected, tolerance, what + ": " + of); };
  near(filter->GetSourceSnapDistance(), whole.Filter->GetSourceSnapDistance(), 1e-12,
    "the source's distance from the surface");
  near(filter->GetSourceLength(), whole.Filter->GetSourceLength(), 1e-12 * whole.Largest,
    "the source's length");
  // Each distance is shorter than the exact one by the bound at most; refined points may differ.
  const double apart =
    1e-3 + std::max(filter->GetRelativeErrorBound(), whole.Filter->GetRelativeErrorBound());
  near(filter->GetLargestDistance(), whole.Filter->GetLargestDistance(), apart * whole.Largest,
    "the largest distance");
  check.That(filter->GetHasUnreachedPoints() == whole.Filter->GetHasUnreachedPoints(),
    what + ": whether there are points that are not reached");
  // A rank that works for others puts it out, too.
  const double length = TotalLength(filter->GetOutput(1));
  double longest = 0.0;
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    &length, &longest, 1, vtkCommunicator::MAX_OP);
  near(longest, TotalLength(whole.Filter->GetOutput(1)), 1e-12, "the source on the surface");
  near(length, length > 0.0 ? longest : 0.0, 1e-12, "the source on the surface");
  const double windows = whole.Filter->GetWindowsPropagatedPerEdge();
  near(filter->GetWindowsPropagatedPerEdge(), windows,
    question.IsApproximate ? windows : 0.05 * windows, "the number of windows an edge");
}

/// Runs a test under MPI: tests(Check&, Ranks) on every rank. It fails on all where it does on one.
template <typename Tests>
int RunOnRanks(int argc, char* argv[], Tests&& tests)
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  Check check;
  tests(check, Ranks{ controller->GetLocalProcessId(), controller->GetNumberOfProcesses() });
  const int failures = check.Result() == EXIT_SUCCESS ? 0 : 1;
  int all = 0;
  controller->AllReduce(&failures, &all, 1, vtkCommunicator::SUM_OP);
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return all == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}

#endif
