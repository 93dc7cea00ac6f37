// SPDX-License-Identifier: BSD-3-Clause
// The exact geodesic distance to a curve on a surface, in a VTK application.
//
//   GeodesicDistance SURFACE.vtp CURVE.vtp OUTPUT.vtp   takes a surface and a curve
//   GeodesicDistance                                    makes both, and keeps them beside the
//                                                       result in the current folder

#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkGeodesicDistanceField.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
// A point of a bumpy ring, u the way around it and v across its tube, in turns.
std::array<double, 3> OnRing(double u, double v)
{
  u *= 2.0 * vtkMath::Pi();
  v *= 2.0 * vtkMath::Pi();
  const double tube =
    1.25 + 0.14 * std::sin(7.0 * u) * std::cos(3.0 * v) - 0.25 * std::cos(2.0 * u);
  const double outward = 3.0 + tube * std::cos(v);
  return { outward * std::cos(u), outward * std::sin(u), tube * std::sin(v) };
}

// The ring as a mesh of triangles.
vtkSmartPointer<vtkPolyData> MakeSurface()
{
  const vtkIdType around = 240;
  const vtkIdType across = 120;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> faces;
  for (vtkIdType i = 0; i < around; ++i)
  {
    const vtkIdType here = i * across;
    const vtkIdType next = (i + 1) % around * across;
    for (vtkIdType j = 0; j < across; ++j)
    {
      points->InsertNextPoint(
        OnRing(static_cast<double>(i) / around, static_cast<double>(j) / across).data());
      const vtkIdType k = (j + 1) % across;
      faces->InsertNextCell({ here + j, next + j, next + k });
      faces->InsertNextCell({ here + j, next + k, here + k });
    }
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(faces);
  return surface;
}

// An open curve that winds around the ring. Its points need not lie on the faces: the filter puts
// them there.
vtkSmartPointer<vtkPolyData> MakeCurve()
{
  const vtkIdType count = 400;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double t = static_cast<double>(i) / (count - 1);
    lines->InsertCellPoint(points->InsertNextPoint(OnRing(0.85 * t - 0.23, 1.6 * t + 0.08).data()));
  }
  auto curve = vtkSmartPointer<vtkPolyData>::New();
  curve->SetPoints(points);
  curve->SetLines(lines);
  return curve;
}

vtkSmartPointer<vtkPolyData> Read(const std::string& fileName)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  return reader->GetOutput();
}

bool Write(vtkPolyData* data, const std::string& fileName)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetFileName(fileName.c_str());
  writer->SetDataModeToBinary(); // some libexpat1 cannot read the default, appended
  return writer->Write() == 1;
}
}

int main(int argc, char* argv[])
{
  if (argc != 1 && argc != 4)
  {
    std::cerr << "usage: " << argv[0] << " [SURFACE.vtp CURVE.vtp OUTPUT.vtp]\n";
    return EXIT_FAILURE;
  }
  const bool own = argc == 1;
  const auto surface = own ? MakeSurface() : Read(argv[1]);
  const auto curve = own ? MakeCurve() : Read(argv[2]);
  const std::string output = own ? "distance.vtp" : argv[3];

  vtkNew<vtkGeodesicDistanceField> field;
  field->SetInputData(surface);
  field->SetSourceData(curve);
  field->Update();

  vtkPolyData* result = field->GetOutput();
  vtkDataArray* distance = result->GetPointData()->GetArray(field->GetDistanceArrayName());
  if (!distance)
  {
    return EXIT_FAILURE; // the filter has said why
  }
  std::cout << "faces:                " << result->GetNumberOfCells() << '\n'
            << "largest distance:     " << distance->GetFiniteRange(0)[1] << '\n'
            << "source snap distance: " << field->GetSourceSnapDistance() << '\n'
            << "windows per edge:     " << field->GetWindowsPropagatedPerEdge() << '\n';

  const bool kept = !own || (Write(surface, "surface.vtp") && Write(curve, "curve.vtp"));
  return kept && Write(result, output) ? EXIT_SUCCESS : EXIT_FAILURE;
}
