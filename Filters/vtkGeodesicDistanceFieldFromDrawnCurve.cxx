// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicDistanceFieldFromDrawnCurve.h"

#include "PolyData/Inputs.h"

#include "vtkCellArray.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkGeodesicDistanceFieldFromDrawnCurve);

//------------------------------------------------------------------------------
vtkGeodesicDistanceFieldFromDrawnCurve::vtkGeodesicDistanceFieldFromDrawnCurve()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  this->Curve->SetPoints(points);
  this->SetSourceData(this->Curve);
}

//------------------------------------------------------------------------------
vtkGeodesicDistanceFieldFromDrawnCurve::~vtkGeodesicDistanceFieldFromDrawnCurve() = default;

//------------------------------------------------------------------------------
void vtkGeodesicDistanceFieldFromDrawnCurve::SetNumberOfCurvePoints(vtkIdType number)
{
  vtkPoints* points = this->Curve->GetPoints();
  const vtkIdType before = points->GetNumberOfPoints();
  number = std::max<vtkIdType>(number, 0);
  if (number == before)
  {
    return;
  }
  points->Resize(number);
  points->SetNumberOfPoints(number);
  for (vtkIdType i = before; i < number; ++i)
  {
    points->SetPoint(i, 0.0, 0.0, 0.0);
  }
  this->JoinCurvePoints();
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceFieldFromDrawnCurve::GetNumberOfCurvePoints()
{
  return this->Curve->GetNumberOfPoints();
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceFieldFromDrawnCurve::SetCurvePoint(
  vtkIdType index, double x, double y, double z)
{
  if (index < 0)
  {
    vtkErrorMacro("There is no point " << index << " of a curve: points are numbered from 0 on.");
    return;
  }
  if (index >= this->GetNumberOfCurvePoints())
  {
    this->SetNumberOfCurvePoints(index + 1);
  }
  vtkPoints* points = this->Curve->GetPoints();
  const double* before = points->GetPoint(index);
  if (before[0] != x || before[1] != y || before[2] != z)
  {
    points->SetPoint(index, x, y, z);
    points->Modified();
    this->Curve->Modified();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceFieldFromDrawnCurve::GetCurvePoint(vtkIdType index, double point[3])
{
  if (index < 0 || index >= this->GetNumberOfCurvePoints())
  {
    vtkErrorMacro("There is no point " << index << " of the curve: it has "
                                       << this->GetNumberOfCurvePoints() << ".");
    std::fill_n(point, 3, 0.0);
    return;
  }
  this->Curve->GetPoint(index, point);
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceFieldFromDrawnCurve::SetCurveClosed(bool closed)
{
  if (this->CurveClosed != closed)
  {
    this->CurveClosed = closed;
    this->JoinCurvePoints();
  }
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceFieldFromDrawnCurve::SetPointsOnly(bool pointsOnly)
{
  if (this->PointsOnly != pointsOnly)
  {
    this->PointsOnly = pointsOnly;
    this->JoinCurvePoints();
  }
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceFieldFromDrawnCurve::JoinCurvePoints()
{
  const vtkIdType number = this->GetNumberOfCurvePoints();
  vtkNew<vtkCellArray> lines;
  if (number > 0 && !this->PointsOnly)
  {
    const vtkIdType size = this->CurveClosed && number > 2 ? number + 1 : number;
    lines->InsertNextCell(static_cast<int>(size));
    for (vtkIdType i = 0; i < size; ++i)
    {
      lines->InsertCellPoint(i % number);
    }
  }
  this->Curve->SetLines(lines);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceFieldFromDrawnCurve::SetExecutive(vtkExecutive* executive)
{
  this->Superclass::SetExecutive(executive);
  if (executive)
  {
    this->SetSourceData(this->Curve);
  }
}

//------------------------------------------------------------------------------
std::string vtkGeodesicDistanceFieldFromDrawnCurve::FindWrongProperty() const
{
  const std::string wrong = this->Superclass::FindWrongProperty();
  const bool isCurveMissing =
    this->SourceType == SOURCE_CURVE && this->Curve->GetNumberOfPoints() == 0;
  return wrong.empty() && isCurveMissing
    ? "The curve has no points: give it one or more, or set Source Type to Surface Boundary."
    : wrong;
}

//------------------------------------------------------------------------------
geodesic::ExecutionPlan vtkGeodesicDistanceFieldFromDrawnCurve::Plan() const
{
  geodesic::ExecutionPlan plan = this->Superclass::Plan();
  // Handles that are dragged beside the surface are meant: they go onto it without a word.
  plan.noteSourceBeyond = 0.5;
  return plan;
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceFieldFromDrawnCurve::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfCurvePoints: " << this->GetNumberOfCurvePoints() << "\n";
  os << indent << "CurveClosed: " << (this->CurveClosed ? "On" : "Off") << "\n";
  os << indent << "PointsOnly: " << (this->PointsOnly ? "On" : "Off") << "\n";
}
