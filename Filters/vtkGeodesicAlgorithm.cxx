// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicAlgorithm.h"

#include "Errors.h"
#include "PolyData/FilterExecution.h"
#include "PolyData/Notes.h"
#include "PolyData/SurfaceCache.h"

#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <exception>
#include <new>

namespace
{

// Below malloc's threshold for memory of its own, so that it is at hand when it is freed.
constexpr std::size_t MemoryForMessages = 1 << 16;

int NumberOfProcesses(vtkMultiProcessController* controller)
{
  return controller ? controller->GetNumberOfProcesses() : 1;
}

/// The piece that is asked of the output port from which the request comes.
int PieceAskedFor(vtkInformation* request, vtkInformationVector* outputVector)
{
  const int port = request->Has(vtkExecutive::FROM_OUTPUT_PORT())
    ? std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()))
    : 0;
  vtkInformation* info = outputVector->GetInformationObject(port);
  return info ? vtkStreamingDemandDrivenPipeline::GetUpdatePiece(info) : 0;
}

std::string MemoryNumbers(const geodesic::NotEnoughMemory& error)
{
  constexpr int mega = 20;
  const std::string available = std::to_string(error.available() >> mega) + " MB are available";
  return error.needed() > 0
    ? " It takes " + std::to_string(error.needed() >> mega) + " MB more, and " + available + "."
    : " Only " + available + ".";
}

void EmptyOutputs(vtkInformationVector* outputVector)
{
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject::GetData(outputVector, port)->Initialize();
  }
}

/// Where an algorithm fails it has said why; its executive adds a second message, of addresses and
/// information keys. An error of an object that is observed goes to its observers in place of the
/// output window: this one observes an executive until that message or the next request.
class ExecutiveSilencer : public vtkCommand
{
public:
  static ExecutiveSilencer* New() { return new ExecutiveSilencer; }
  ~ExecutiveSilencer() override { this->Stop(); }

  void Start(vtkExecutive* executive)
  {
    this->Stop();
    this->Executive = executive;
    this->Tag = executive->AddObserver(vtkCommand::ErrorEvent, this);
  }
  void Stop()
  {
    if (this->Executive)
    {
      this->Executive->RemoveObserver(this->Tag);
      this->Executive = nullptr;
    }
  }
  void Execute(vtkObject*, unsigned long, void*) override { this->Stop(); }

private:
  vtkWeakPointer<vtkExecutive> Executive;
  unsigned long Tag = 0;
};

}

/// What is kept from one execution to the next.
class vtkGeodesicAlgorithm::vtkInternals
{
public:
  geodesic::SurfaceCache Cache;
  geodesic::GivenNotes Given;
  /// The user's controller; the global one unless one was set.
  vtkSmartPointer<vtkMultiProcessController> Controller;
  bool HasController = false;
  vtkNew<ExecutiveSilencer> Silencer;
};

//------------------------------------------------------------------------------
vtkGeodesicAlgorithm::vtkGeodesicAlgorithm()
  : Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkGeodesicAlgorithm::~vtkGeodesicAlgorithm()
{
  this->SetBarrierArrayName(nullptr);
}

//------------------------------------------------------------------------------
void vtkGeodesicAlgorithm::SetSourceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkGeodesicAlgorithm::SetSourceData(vtkDataObject* source)
{
  this->SetInputDataInternal(1, source);
}

//------------------------------------------------------------------------------
int vtkGeodesicAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
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
std::string vtkGeodesicAlgorithm::AdviceOnMemory() const
{
  return "Decimate the surface or cut it into parts.";
}

//------------------------------------------------------------------------------
void vtkGeodesicAlgorithm::SetController(vtkMultiProcessController* controller)
{
  if (!this->Internals->HasController || this->Internals->Controller != controller)
  {
    this->Internals->HasController = true;
    this->Internals->Controller = controller;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkGeodesicAlgorithm::GetController()
{
  return this->Internals->HasController ? this->Internals->Controller.Get()
                                        : vtkMultiProcessController::GetGlobalController();
}

//------------------------------------------------------------------------------
vtkTypeBool vtkGeodesicAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Internals->Silencer->Stop();
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->RequestDataObject(request, inputVector, outputVector);
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkGeodesicAlgorithm::RequestDataObject(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  const char* type = this->GetOutputPortInformation(0)->Get(vtkDataObject::DATA_TYPE_NAME());
  if (!info || std::string(type) != "vtkDataObject")
  {
    return 1; // the executive makes what is always of one kind
  }
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  const bool isComposite = input && input->IsA("vtkCompositeDataSet");
  const std::string wanted = isComposite ? input->GetClassName() : "vtkPolyData";
  if (!output || output->GetClassName() != wanted)
  {
    const auto made =
      vtk::TakeSmartPointer<vtkDataObject>(isComposite ? input->NewInstance() : vtkPolyData::New());
    info->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkGeodesicAlgorithm::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    outputVector->GetInformationObject(port)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkGeodesicAlgorithm::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* vtkNotUsed(outputVector))
{
  if (NumberOfProcesses(this->GetController()) > 1)
  {
    return 1;
  }
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < inputVector[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* info = inputVector[port]->GetInformationObject(i);
      info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
      info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
      info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkGeodesicAlgorithm::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->ExecuteOrExplain(request, inputVector, outputVector))
  {
    return 1;
  }
  this->Internals->Silencer->Start(this->GetExecutive());
  return 0;
}

//------------------------------------------------------------------------------
bool vtkGeodesicAlgorithm::ExecuteOrExplain(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int processes = NumberOfProcesses(this->GetController());
  if (processes > 1)
  {
    this->ResetResults();
    vtkErrorMacro("The surface may be distributed over "
      << processes
      << " MPI ranks, but distances are computed in one process only and would be wrong. Run with "
         "one rank, or, where every rank that executes has the whole surface, call "
         "SetController(nullptr).");
    return false;
  }
  if (PieceAskedFor(request, outputVector) > 0)
  {
    // Piece 0 has everything; the others have the same blocks.
    vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
    if (output->IsA("vtkCompositeDataSet"))
    {
      geodesic::makeBlocksLike(vtkDataObject::GetData(inputVector[0]), output);
    }
    return true;
  }
  this->ResetResults();
  const std::string wrong = this->FindWrongProperty();
  if (!wrong.empty())
  {
    vtkErrorMacro(<< wrong);
    return false;
  }
  return this->ComputeOrExplain(inputVector, outputVector);
}

//------------------------------------------------------------------------------
bool vtkGeodesicAlgorithm::ComputeOrExplain(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  geodesic::Stage stage = geodesic::Stage::ReadingSurface;
  const auto explainMemory = [&](const std::string& numbers)
  {
    vtkErrorMacro("There is not enough memory for this surface: it ran out while "
      << geodesic::describe(stage) << "." << numbers << " Nothing of this is kept. "
      << this->AdviceOnMemory());
  };
  std::unique_ptr<char[]> reserve; // for what telling that memory has run out takes itself
  try
  {
    reserve = std::make_unique<char[]>(MemoryForMessages);
    const bool hasTargets = this->GetNumberOfInputPorts() > 2;
    geodesic::FilterExecution execution(this, this->Internals->Cache, stage,
      vtkDataObject::GetData(inputVector[0]), vtkDataObject::GetData(inputVector[1]),
      hasTargets ? vtkDataObject::GetData(inputVector[2]) : nullptr);
    this->Compute(execution, outputVector);
    const std::string said = this->Internals->Given.take(execution.notes(), this);
    if (!said.empty())
    {
      vtkWarningMacro(<< said);
    }
    if (this->GetReleaseDataFlag() || vtkDataObject::GetGlobalReleaseDataFlag())
    {
      this->Internals->Cache.release();
    }
    return true;
  }
  catch (const geodesic::Aborted&)
  {
    EmptyOutputs(outputVector);
    return true;
  }
  catch (const geodesic::Error& error)
  {
    EmptyOutputs(outputVector);
    vtkErrorMacro(<< error.what());
  }
  catch (const geodesic::NotEnoughMemory& error)
  {
    EmptyOutputs(outputVector);
    this->Internals->Cache.release();
    explainMemory(MemoryNumbers(error));
  }
  catch (const std::bad_alloc&)
  {
    EmptyOutputs(outputVector);
    this->Internals->Cache.release();
    reserve.reset();
    explainMemory("");
  }
  catch (const std::exception& error)
  {
    EmptyOutputs(outputVector);
    this->Internals->Cache.release();
    vtkErrorMacro("The distance could not be computed, for a reason that was not foreseen: "
      << error.what()
      << ". Please report this with the surface and the source, unless an observer of this filter "
         "has thrown it.");
  }
  catch (...)
  {
    EmptyOutputs(outputVector);
    this->Internals->Cache.release();
    vtkErrorMacro(
      "The distance could not be computed, for a reason that was not foreseen and has no "
      "description. Please report this with the surface and the source, unless an "
      "observer of this filter has thrown it.");
  }
  return false;
}

//------------------------------------------------------------------------------
void vtkGeodesicAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SourceType: " << this->SourceType << "\n";
  os << indent << "MergeCoincidentPoints: " << (this->MergeCoincidentPoints ? "On" : "Off") << "\n";
  os << indent
     << "BarrierArrayName: " << (this->BarrierArrayName ? this->BarrierArrayName : "(none)")
     << "\n";
  os << indent << "Controller: " << (this->Internals->HasController ? "" : "(global) ")
     << this->Internals->Controller.Get() << "\n";
}
