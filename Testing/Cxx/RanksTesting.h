// SPDX-License-Identifier: BSD-3-Clause
#ifndef RanksTesting_h
#define RanksTesting_h

#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkMPIController.h"
#include "vtkMultiProcessController.h"
#include "vtkUnsignedCharArray.h"

#include <functional>
#include <map>
#include <random>

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

inline Point Centre(vtkPolyData* surface, vtkIdType face)
{
  vtkNew<vtkIdList> ids;
  surface->GetPolys()->GetCellAtId(face, ids);
  Point sum{};
  for (vtkIdType k = 0; k < 3; ++k)
  {
    Point p;
    surface->GetPoint(ids->GetId(k), p.data());
    for (std::size_t x = 0; x < 3; ++x)
    {
      sum[x] += p[x] / 3.0;
    }
  }
  return sum;
}

/// Strips along the first axis of something as large as the unit square.
inline Cut Strips(vtkPolyData* surface, int count)
{
  return [surface, count](vtkIdType face)
  { return std::clamp(static_cast<int>(Centre(surface, face)[0] * count), 0, count - 1); };
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
    const bool isBarrier = surface->GetCellData()->GetArray("barrier")->GetTuple1(face) != 0.0;
    return isBarrier ? count - 1 : AtRandom(std::max(1, count - 1))(face);
  };
}

/// Some faces of a surface with their arrays and the points that they use, which have global ids if
/// that is asked for.
inline vtkSmartPointer<vtkPolyData> Part(
  vtkPolyData* surface, const std::vector<vtkIdType>& faces, bool hasGlobalIds = false)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(surface->GetPoints()->GetDataType());
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkIdTypeArray> globalIds;
  globalIds->SetName("GlobalPointIds");
  std::map<vtkIdType, vtkIdType> numbers;
  for (const vtkIdType face : faces)
  {
    vtkNew<vtkIdList> ids;
    surface->GetPolys()->GetCellAtId(face, ids);
    polys->InsertNextCell(3);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      const auto [at, isNew] = numbers.emplace(ids->GetId(k), points->GetNumberOfPoints());
      if (isNew)
      {
        points->InsertNextPoint(surface->GetPoint(ids->GetId(k)));
        globalIds->InsertNextValue(ids->GetId(k));
      }
      polys->InsertCellPoint(at->second);
    }
  }
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->SetPoints(points);
  part->SetPolys(polys);
  part->GetCellData()->CopyAllocate(surface->GetCellData());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    part->GetCellData()->CopyData(surface->GetCellData(), faces[i], static_cast<vtkIdType>(i));
  }
  if (hasGlobalIds)
  {
    part->GetPointData()->SetGlobalIds(globalIds);
  }
  return part;
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

/// Some faces of a surface, of which those after the first few are copies of other ranks'; a ghost
/// array marks them.
inline vtkSmartPointer<vtkPolyData> PartWithGhosts(vtkPolyData* surface,
  const std::vector<vtkIdType>& faces, std::size_t own, bool hasGlobalIds = false)
{
  auto part = Part(surface, faces, hasGlobalIds);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    ghosts->InsertNextValue(i < own ? 0 : vtkDataSetAttributes::DUPLICATECELL);
  }
  part->GetCellData()->AddArray(ghosts);
  return part;
}

/// A rank's faces, then copies of all others around their points.
inline vtkSmartPointer<vtkPolyData> PartWithGhosts(
  vtkPolyData* surface, const Cut& cut, int rank, bool hasGlobalIds = false)
{
  std::vector<vtkIdType> faces = FacesOf(surface, cut, rank);
  const std::size_t own = faces.size();
  std::vector<char> isOwnPoint(static_cast<std::size_t>(surface->GetNumberOfPoints()), 0);
  const auto corners = [&](vtkIdType face)
  {
    vtkNew<vtkIdList> ids;
    surface->GetPolys()->GetCellAtId(face, ids);
    return std::array<std::size_t, 3>{ static_cast<std::size_t>(ids->GetId(0)),
      static_cast<std::size_t>(ids->GetId(1)), static_cast<std::size_t>(ids->GetId(2)) };
  };
  for (const vtkIdType face : faces)
  {
    for (const std::size_t point : corners(face))
    {
      isOwnPoint[point] = 1;
    }
  }
  for (vtkIdType face = 0; face < surface->GetNumberOfPolys(); ++face)
  {
    const auto ids = corners(face);
    if (cut(face) != rank &&
      std::any_of(ids.begin(), ids.end(), [&](std::size_t id) { return isOwnPoint[id] != 0; }))
    {
      faces.push_back(face);
    }
  }
  return PartWithGhosts(surface, faces, own, hasGlobalIds);
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
