// SPDX-License-Identifier: BSD-3-Clause
// The output does not depend on threads, bit by bit.
#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkSMPTools.h"

#include <cstring>

using namespace GeodesicTesting;

namespace
{

vtkSmartPointer<vtkPolyData> Ellipsoid()
{
  return WavySphere(150, 100);
}

vtkSmartPointer<vtkPolyData> Run(vtkPolyData* surface, bool approximate, bool refine)
{
  const auto filter =
    RefinedField(surface, Polyline({ { 0.4, 0.1, 0.2 }, { 0.1, 0.3, 0.3 }, { -0.3, 0.2, 0.1 } }));
  filter->SetAccuracy(approximate ? 1 : 0);
  filter->SetRefineMesh(refine);
  filter->GenerateSourceAngleOn();
  filter->GenerateTextureCoordinatesOn();
  filter->Update();
  return filter->GetOutput();
}

bool SameBits(vtkDataArray* a, vtkDataArray* b)
{
  const auto bytes = static_cast<std::size_t>(a->GetNumberOfValues()) *
    static_cast<std::size_t>(a->GetDataTypeSize());
  return a->GetDataType() == b->GetDataType() && a->GetNumberOfValues() == b->GetNumberOfValues() &&
    std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), bytes) == 0;
}

bool Same(vtkPolyData* a, vtkPolyData* b)
{
  bool same = SameBits(a->GetPoints()->GetData(), b->GetPoints()->GetData()) &&
    SameBits(a->GetPolys()->GetConnectivityArray(), b->GetPolys()->GetConnectivityArray()) &&
    SameBits(a->GetPointData()->GetScalars(), b->GetPointData()->GetScalars()) &&
    SameBits(a->GetPointData()->GetTCoords(), b->GetPointData()->GetTCoords()) &&
    SameBits(
      a->GetPointData()->GetArray("SourceAngle"), b->GetPointData()->GetArray("SourceAngle"));
  for (const char* name : { "WindowsPropagatedPerEdge", "SourceLength", "SourceSnapDistance",
         "RelativeErrorBound", "InterpolationErrorBound" })
  {
    same = same && SameBits(a->GetFieldData()->GetArray(name), b->GetFieldData()->GetArray(name));
  }
  return same;
}

}

int TestGeodesicThreads(int, char*[])
{
  Check check;
  auto surface = Ellipsoid();
  int backends = 0;
  for (const bool approximate : { false, true })
  {
    for (const bool refine : { false, true })
    {
      vtkSMPTools::SetBackend("Sequential");
      const auto alone = Run(surface, approximate, refine);
      check.That(alone->GetPointData()->GetScalars() != nullptr, "there is a distance");
      for (const char* backend : { "STDThread", "TBB", "OpenMP" })
      {
        if (!vtkSMPTools::SetBackend(backend))
        {
          continue;
        }
        vtkSMPTools::Initialize(2);
        check.Equal(vtkSMPTools::GetEstimatedNumberOfThreads(), 2, "threads");
        ++backends;
        check.That(Same(alone, Run(surface, approximate, refine)),
          std::string("the output of two threads, ") + backend +
            (approximate ? ", approximate" : "") + (refine ? ", refined" : ""));
      }
    }
  }
  check.That(backends >= 4, "there are threads to test with");
  return check.Result();
}
