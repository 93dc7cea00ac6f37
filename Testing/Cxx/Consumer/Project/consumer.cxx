// SPDX-License-Identifier: BSD-3-Clause
// A program outside the project's tree: the distance on a square of two triangles from one corner,
// by the lines in README.
#include <vtkCellArray.h>
#include <vtkGeodesicDistanceField.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTrivialProducer.h>

#include <cmath>
#include <iostream>

int main()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(1, 1, 0);
  points->InsertNextPoint(0, 1, 0);
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 3 });
  triangles->InsertNextCell({ 1, 2, 3 });
  vtkNew<vtkPolyData> square;
  square->SetPoints(points);
  square->SetPolys(triangles);

  vtkNew<vtkPoints> corner;
  corner->InsertNextPoint(0, 0, 0);
  vtkNew<vtkPolyData> source;
  source->SetPoints(corner);

  vtkNew<vtkTrivialProducer> surface;
  surface->SetOutput(square);
  vtkNew<vtkTrivialProducer> curve;
  curve->SetOutput(source);
#include "readme.inc"
  const double opposite = distance ? distance->GetTuple1(2) : 0.0;
  std::cout << "Distance to the opposite corner: " << opposite << "\n";
  return std::abs(opposite - std::sqrt(2.0)) < 1e-12 ? 0 : 1;
}
