// SPDX-License-Identifier: BSD-3-Clause
// The output does not depend on threads, bit by bit.
#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkSMPTools.h"

#include <cstring>

using namespace GeodesicTesting;

namespace
{

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

bool Same(vtkPolyData* a, vtkPolyData* b)
{
  bool same = AreSame(a->GetPoints()->GetData(), b->GetPoints()->GetData()) &&
    AreSame(a->GetPolys()->GetConnectivityArray(), b->GetPolys()->GetConnectivityArray()) &&
    AreSame(a->GetPointData()->GetScalars(), b->GetPointData()->GetScalars()) &&
    AreSame(a->GetPointData()->GetTCoords(), b->GetPointData()->GetTCoords()) &&
    AreSame(a->GetPointData()->GetArray("SourceAngle"), b->GetPointData()->GetArray("SourceAngle"));
  for (const char* name : { "WindowsPropagatedPerEdge", "SourceLength", "SourceSnapDistance",
         "RelativeErrorBound", "InterpolationErrorBound" })
  {
    same = same && AreSame(a->GetFieldData()->GetArray(name), b->GetFieldData()->GetArray(name));
  }
  return same;
}

}

int TestGeodesicThreads(int, char*[])
{
  Check check;
  const auto surface = WavySphere(150, 100);
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
