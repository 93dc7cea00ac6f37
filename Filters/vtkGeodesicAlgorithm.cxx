// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicAlgorithm.h"

#include "Errors.h"
#include "PolyData/FilterExecution.h"
#include "PolyData/SurfaceCache.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"

#include <new>

namespace
{

// Below malloc's threshold for memory of its own, so that it is at hand when it is freed.
constexpr std::size_t MemoryForMessages = 1 << 16;

void EmptyOutputs(vtkInformationVector* outputVector)
{
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject::GetData(outputVector, port)->Initialize();
  }
}

}

/// What is kept from one execution to the next.
class vtkGeodesicAlgorithm::vtkInternals
{
public:
  geodesic::SurfaceCache Cache;
};

//------------------------------------------------------------------------------
vtkGeodesicAlgorithm::vtkGeodesicAlgorithm()
  : Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkGeodesicAlgorithm::~vtkGeodesicAlgorithm() = default;

//------------------------------------------------------------------------------
void vtkGeodesicAlgorithm::SetSourceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkGeodesicAlgorithm::SetSourceData(vtkPolyData* source)
{
  this->SetInputData(1, source);
}

//------------------------------------------------------------------------------
int vtkGeodesicAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkGeodesicAlgorithm::FindWrongProperty() const
{
  return {};
}

//------------------------------------------------------------------------------
int vtkGeodesicAlgorithm::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->ResetResults();
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    vtkErrorMacro("The surface may be distributed over "
      << controller->GetNumberOfProcesses()
      << " MPI ranks, but distances are computed in one process only and would be wrong. Run with "
         "one "
         "rank.");
    return 0;
  }
  const std::string wrong = this->FindWrongProperty();
  if (!wrong.empty())
  {
    vtkErrorMacro(<< wrong);
    return 0;
  }

  std::unique_ptr<char[]> reserve; // for what telling that memory has run out takes itself
  try
  {
    reserve = std::make_unique<char[]>(MemoryForMessages);
    geodesic::FilterExecution execution(this, this->Internals->Cache,
      vtkDataObject::GetData(inputVector[0]), vtkDataObject::GetData(inputVector[1]));
    this->Compute(execution, outputVector);
    execution.giveNotes();
    return 1;
  }
  catch (const geodesic::Aborted&)
  {
    EmptyOutputs(outputVector);
    return 1;
  }
  catch (const geodesic::Error& error)
  {
    EmptyOutputs(outputVector);
    vtkErrorMacro(<< error.what());
  }
  catch (const std::bad_alloc&)
  {
    EmptyOutputs(outputVector);
    this->Internals->Cache.release();
    reserve.reset();
    vtkErrorMacro(
      "There is not enough memory for this surface. Decimate it, cut it into parts, set "
      "MaximumDistance, switch RefineMesh off or set Accuracy to Approximate.");
  }
  return 0;
}

//------------------------------------------------------------------------------
void vtkGeodesicAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SourceType: " << this->SourceType << "\n";
  os << indent << "MergeCoincidentPoints: " << (this->MergeCoincidentPoints ? "On" : "Off") << "\n";
}
