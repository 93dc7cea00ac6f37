// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicAlgorithm.h"

#include "Errors.h"
#include "PolyData/FilterExecution.h"
#include "PolyData/Inputs.h"
#include "PolyData/Memory.h"
#include "PolyData/Notes.h"
#include "PolyData/SurfaceCache.h"
#include "PolyData/ranks/RankExchange.h"

#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <exception>
#include <new>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>

namespace
{

// Below malloc's threshold for memory of its own, so that it is at hand when it is freed.
constexpr std::size_t MemoryForMessages = 1 << 16;

int NumberOfProcesses(vtkMultiProcessController* controller)
{
  return controller ? controller->GetNumberOfProcesses() : 1;
}

/// Whether what is asked of the output port from which the request comes is the one piece that has
/// all that this process has. One process has it in piece 0; of several, each in the first of the
/// pieces that are its share, and where there are no more pieces than processes, always.
bool IsPieceWithData(
  vtkInformation* request, vtkInformationVector* outputVector, vtkMultiProcessController* ranks)
{
  const int port = request->Has(vtkExecutive::FROM_OUTPUT_PORT())
    ? std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()))
    : 0;
  vtkInformation* info = outputVector->GetInformationObject(port);
  const int piece = info ? vtkStreamingDemandDrivenPipeline::GetUpdatePiece(info) : 0;
  const vtkIdType processes = NumberOfProcesses(ranks);
  if (processes == 1)
  {
    return piece <= 0;
  }
  const vtkIdType pieces =
    info ? vtkStreamingDemandDrivenPipeline::GetUpdateNumberOfPieces(info) : 1;
  const vtkIdType rank = ranks->GetLocalProcessId();
  return pieces <= processes || piece == (rank * pieces + processes - 1) / processes;
}

/// \param inputVector of a filter that may have no third port.
geodesic::InputRequest RequestOf(vtkGeodesicAlgorithm* filter, vtkInformationVector** inputVector)
{
  geodesic::InputRequest request{};
  request.surface = vtkDataObject::GetData(inputVector[0]);
  request.source = vtkDataObject::GetData(inputVector[1]);
  request.targets =
    filter->GetNumberOfInputPorts() > 2 ? vtkDataObject::GetData(inputVector[2]) : nullptr;
  request.fromCurves = filter->GetSourceType() != vtkGeodesicAlgorithm::SURFACE_BOUNDARY;
  request.fromBoundary = filter->GetSourceType() != vtkGeodesicAlgorithm::SOURCE_CURVE;
  request.areLinesJoined = filter->GetJoinLines();
  request.merging = { filter->GetMergeCoincidentPoints(), filter->GetMergeTolerance() };
  request.sourceIdArray = filter->GetSourceIdArrayName();
  request.barrierArray = filter->GetBarrierArrayName();
  request.filter = filter->GetClassName();
  return request;
}

/// Leaves nothing in an output but, in a composite one, blocks as those of the surface.
void MakeEmpty(vtkDataObject* surface, vtkDataObject* output)
{
  output->Initialize();
  if (output->IsA("vtkDataObjectTree") && surface && surface->IsA(output->GetClassName()))
  {
    geodesic::makeBlocksLike(surface, output);
  }
}

std::string MemoryNumbers(const geodesic::NotEnoughMemory& error)
{
  constexpr int mega = 20;
  const std::string available = std::to_string(error.available >> mega) + " MB are available";
  return error.needed > 0
    ? " It takes " + std::to_string(error.needed >> mega) + " MB more, and " + available + "."
    : " Only " + available + ".";
}

/// Why an execution has not come to its end.
struct Failure
{
  /// Empty: it was aborted.
  std::string message;
  /// Whether the next execution may use what was read of the surface.
  bool isSurfaceKept = false;
};

/// Explains the exception that is being handled.
///
/// \param stage what was being done.
/// \param adviceOnMemory what the user can do where memory has run out.
Failure ExplainException(const std::string& stage, const std::string& adviceOnMemory)
{
  const auto noMemory = [&](const std::string& numbers)
  {
    return Failure{ "There is not enough memory for this surface: it ran out while " + stage + "." +
        numbers + " Nothing of this is kept. " + adviceOnMemory,
      false };
  };
  const auto unforeseen = [](const std::string& reason)
  {
    return Failure{ "The distance could not be computed, for a reason that was not foreseen" +
        reason +
        ". Please report this with the surface and the source, unless an observer of this filter "
        "has thrown it.",
      false };
  };
  try
  {
    throw;
  }
  catch (const geodesic::Aborted&)
  {
    return { {}, true };
  }
  catch (const geodesic::Error& error)
  {
    return { error.what(), true };
  }
  catch (const geodesic::NotEnoughMemory& error)
  {
    return noMemory(MemoryNumbers(error));
  }
  catch (const std::bad_alloc&)
  {
    return noMemory("");
  }
  catch (const std::system_error& error)
  {
    // A thread of VTK's that cannot start: its stack takes memory.
    return error.code() == std::errc::resource_unavailable_try_again
      ? noMemory(" No thread could be started.")
      : unforeseen(std::string(": ") + error.what());
  }
  catch (const std::exception& error)
  {
    return unforeseen(std::string(": ") + error.what());
  }
  catch (...)
  {
    return unforeseen(" and has no description");
  }
}

}

/// What is kept from one execution to the next.
class vtkGeodesicAlgorithm::vtkInternals
{
public:
  geodesic::SurfaceCache Cache;
  /// With the other processes of the controller; null for one process.
  std::unique_ptr<geodesic::RankExchange> Exchange;
  geodesic::GivenNotes Given;
  /// The user's controller; the global one unless one was set.
  std::optional<vtkSmartPointer<vtkMultiProcessController>> Controller;

  /// Makes the exchange fit to the processes of a controller, for one execution.
  geodesic::Exchange& BeginExchange(vtkMultiProcessController* controller)
  {
    const bool isWanted = NumberOfProcesses(controller) > 1;
    if (this->Exchange && !(isWanted && this->Exchange->isWith(controller)))
    {
      this->Cache.release(); // which may hold it
      this->Exchange.reset();
    }
    if (isWanted && !this->Exchange)
    {
      this->Exchange = std::make_unique<geodesic::RankExchange>(controller);
    }
    if (!this->Exchange)
    {
      return geodesic::OneRank::instance();
    }
    this->Exchange->begin();
    return *this->Exchange;
  }
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
  this->SetSourceIdArrayName(nullptr);
}

//------------------------------------------------------------------------------
int vtkGeodesicAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  if (port > 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // so that errors can say what to do
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkGeodesicAlgorithm::SetController(vtkMultiProcessController* controller)
{
  if (!this->Internals->Controller || *this->Internals->Controller != controller)
  {
    this->Internals->Controller = controller;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkGeodesicAlgorithm::GetController()
{
  return this->Internals->Controller ? this->Internals->Controller->Get()
                                     : vtkMultiProcessController::GetGlobalController();
}

//------------------------------------------------------------------------------
vtkTypeBool vtkGeodesicAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
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
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkMultiProcessController* controller = this->GetController();
  const int processes = NumberOfProcesses(controller);
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < inputVector[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* info = inputVector[port]->GetInformationObject(i);
      info->Set(
        Pipeline::UPDATE_PIECE_NUMBER(), processes > 1 ? controller->GetLocalProcessId() : 0);
      info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), processes);
      if (processes == 1 || port > 0) // ghost cells of a piece get their values, too
      {
        info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
      }
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkGeodesicAlgorithm::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!IsPieceWithData(request, outputVector, this->GetController()))
  {
    // One piece has everything; the others have the same blocks.
    MakeEmpty(vtkDataObject::GetData(inputVector[0]), vtkDataObject::GetData(outputVector, 0));
    return 1;
  }
  this->ResetResults();
  this->SetError({});
  this->Execute(inputVector, outputVector);
  return 1; // also after an error: views and filters downstream are to see that there is nothing
}

//------------------------------------------------------------------------------
void vtkGeodesicAlgorithm::SetError(std::string message)
{
  // Not by SetErrorCode(), which would modify the filter.
  this->ErrorCode = message.empty() ? vtkErrorCode::NoError : vtkErrorCode::UserError;
  this->ErrorMessage = std::move(message);
}

//------------------------------------------------------------------------------
void vtkGeodesicAlgorithm::Execute(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  geodesic::Exchange* exchange = nullptr; // as long as other ranks may wait for this one
  std::optional<geodesic::FilterExecution> execution;
  std::unique_ptr<char[]> reserve; // for what telling that memory has run out takes itself
  try
  {
    exchange = &this->Internals->BeginExchange(this->GetController());
    reserve = std::make_unique<char[]>(MemoryForMessages);
    const std::string wrong = this->FindWrongProperty();
    if (!wrong.empty())
    {
      throw geodesic::InputError(wrong);
    }
    const geodesic::ExecutionPlan plan = this->Plan();
    execution.emplace(this, plan.allStages(), *exchange);
    const geodesic::Inputs inputs =
      geodesic::readInputs(RequestOf(this, inputVector), plan, this->Internals->Cache, *execution);
    this->Compute(inputs, *execution, outputVector);
    const std::string said = this->Internals->Given.take(execution->notes(), this);
    exchange->step(exchange->noMessages()); // until all ranks have come to their end
    exchange = nullptr;
    if (!said.empty() && inputs.rank.showsNotes())
    {
      vtkWarningMacro(<< said);
    }
    if (this->GetReleaseDataFlag() || vtkDataObject::GetGlobalReleaseDataFlag())
    {
      this->Internals->Cache.release();
    }
  }
  catch (...)
  {
    reserve.reset();
    const geodesic::Stage stage = execution ? execution->stage() : geodesic::Stage::ReadSurface;
    const Failure failure = ExplainException(geodesic::rowOf(stage).doing, this->AdviceOnMemory());
    this->Fail(failure.message, failure.isSurfaceKept, exchange, inputVector, outputVector);
  }
}

//------------------------------------------------------------------------------
void vtkGeodesicAlgorithm::Fail(const std::string& message, bool isSurfaceKept,
  geodesic::Exchange* exchange, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject::GetData(outputVector, port)->Initialize(); // frees what there is of it
  }
  this->ResetResults();
  if (!isSurfaceKept || (exchange && exchange->numberOfRanks() > 1))
  {
    this->Internals->Cache.release();
  }
  this->SetError(exchange ? exchange->fail(message) : message);
  if (!this->ErrorMessage.empty())
  {
    vtkErrorMacro(<< this->ErrorMessage);
  }
  MakeEmpty(vtkDataObject::GetData(inputVector[0]), vtkDataObject::GetData(outputVector, 0));
}

//------------------------------------------------------------------------------
std::string vtkGeodesicAlgorithm::FindWrongProperty() const
{
  if (this->MergeTolerance >= 0.0 && this->MergeTolerance < geodesic::Infinity)
  {
    return {};
  }
  std::ostringstream message;
  message << "MergeTolerance is " << this->MergeTolerance
          << ": set a length, or 0 to join points that differ by roundings only.";
  return message.str();
}

//------------------------------------------------------------------------------
void vtkGeodesicAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SourceType: " << this->SourceType << "\n";
  os << indent << "JoinLines: " << (this->JoinLines ? "On" : "Off") << "\n";
  os << indent
     << "SourceIdArrayName: " << (this->SourceIdArrayName ? this->SourceIdArrayName : "(none)")
     << "\n";
  os << indent << "MergeCoincidentPoints: " << (this->MergeCoincidentPoints ? "On" : "Off") << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent
     << "BarrierArrayName: " << (this->BarrierArrayName ? this->BarrierArrayName : "(none)")
     << "\n";
  const auto& controller = this->Internals->Controller;
  os << indent << "Controller: " << (controller ? "" : "(global) ")
     << (controller ? controller->Get() : nullptr) << "\n";
}
