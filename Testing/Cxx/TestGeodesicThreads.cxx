// SPDX-License-Identifier: BSD-3-Clause
// The output does not depend on threads, bit by bit.
#include "GeodesicTesting.h"

#include "vtkGeodesicContour.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicPaths.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"

#include <map>

using namespace GeodesicTesting;

namespace
{

/// All filters, on a rough surface.
std::map<std::string, vtkSmartPointer<vtkGeodesicAlgorithm>> Filters()
{
  std::map<std::string, vtkSmartPointer<vtkGeodesicAlgorithm>> filters;
  for (const bool approximate : { false, true })
  {
    for (const bool refine : { false, true })
    {
      vtkNew<vtkGeodesicDistanceField> field;
      field->SetAccuracy(approximate ? 1 : 0);
      field->SetRefineMesh(refine);
      field->GenerateSourceAngleOn();
      field->GenerateTextureCoordinatesOn();
      filters[std::string(approximate ? "approximate" : "exact") + (refine ? ", refined" : "")] =
        field;
    }
  }
  vtkNew<vtkGeodesicContour> contour;
  contour->GenerateValues(3, 0.1, 0.5);
  filters["lines"] = contour;
  std::vector<Point> targets;
  for (int i = 0; i < 400; ++i)
  {
    targets.push_back({ std::sin(1.7 * i), std::cos(2.9 * i), std::sin(0.3 * i + 1.0) });
  }
  vtkNew<vtkGeodesicPaths> paths;
  paths->SetTargetsData(PointSources(targets));
  filters["paths"] = paths;
  vtkNew<vtkGeodesicDistanceMatrix> matrix;
  matrix->SetTargetsData(PointSources({ { 0.0, 0.0, 0.85 }, { 0.1, 0.1, 0.8 } }));
  filters["a table"] = matrix;
  for (auto& [name, filter] : filters)
  {
    filter->SetInputDataObject(0, WavySphere(150, 100));
    filter->SetSourceData(Polyline({ { 0.4, 0.1, 0.2 }, { 0.1, 0.3, 0.3 }, { -0.3, 0.2, 0.1 } }));
  }
  return filters;
}

/// The outputs of all filters, with the structure of the surface made anew.
std::map<std::string, vtkSmartPointer<vtkDataObject>> Outputs()
{
  std::map<std::string, vtkSmartPointer<vtkDataObject>> outputs;
  for (const auto& [name, filter] : Filters())
  {
    filter->Update();
    outputs[name] = filter->GetOutputDataObject(0);
  }
  return outputs;
}

bool Same(vtkFieldData* a, vtkFieldData* b)
{
  bool same = a->GetNumberOfArrays() == b->GetNumberOfArrays();
  for (int i = 0; same && i < a->GetNumberOfArrays(); ++i)
  {
    same = AreSame(a->GetArray(i), b->GetArray(a->GetArrayName(i)));
  }
  return same;
}

bool Same(vtkDataObject* a, vtkDataObject* b)
{
  if (auto* table = vtkTable::SafeDownCast(a))
  {
    return table->GetNumberOfRows() > 0 &&
      Same(table->GetRowData(), vtkTable::SafeDownCast(b)->GetRowData());
  }
  auto* one = vtkPolyData::SafeDownCast(a);
  auto* other = vtkPolyData::SafeDownCast(b);
  return one->GetNumberOfCells() > 0 &&
    AreSame(one->GetPoints()->GetData(), other->GetPoints()->GetData()) &&
    CellsOf(one->GetLines()) == CellsOf(other->GetLines()) &&
    CellsOf(one->GetPolys()) == CellsOf(other->GetPolys()) &&
    Same(one->GetPointData(), other->GetPointData()) &&
    Same(one->GetCellData(), other->GetCellData()) &&
    Same(one->GetFieldData(), other->GetFieldData());
}

}

int TestGeodesicThreads(int, char*[])
{
  Check check;
  vtkSMPTools::SetBackend("Sequential");
  const auto alone = Outputs();
  int backends = 0;
  for (const char* backend : { "STDThread", "TBB", "OpenMP" })
  {
    if (!vtkSMPTools::SetBackend(backend))
    {
      continue;
    }
    vtkSMPTools::Initialize(3);
    check.That(vtkSMPTools::GetEstimatedNumberOfThreads() > 1, "several threads");
    ++backends;
    for (const auto& [name, output] : Outputs())
    {
      check.That(Same(alone.at(name), output), name + " on several threads, " + backend);
    }
  }
  check.That(backends > 0, "there are threads to test with");
  return check.Result();
}
