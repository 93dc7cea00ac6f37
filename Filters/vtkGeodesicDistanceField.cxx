// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicDistanceField.h"

#include "PolyData/FieldSolver.h"
#include "PolyData/FilterExecution.h"
#include "PolyData/Inputs.h"
#include "PolyData/Memory.h"
#include "PolyData/RoundNumbers.h"
#include "PolyData/ranks/SharedResults.h"
#include "PolyData/writing/LineWriter.h"
#include "PolyData/writing/OutputPoints.h"
#include "PolyData/writing/SourceArrays.h"
#include "PolyData/writing/SurfaceWriter.h"
#include "Tolerance.h"
#include "refinement/RefinedOnRanks.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace geodesic;

vtkStandardNewMacro(vtkGeodesicDistanceField);

namespace
{

void addFieldData(vtkDataObject* output, const char* name, double value)
{
  const auto array = makeArray<vtkDoubleArray>(name, 1);
  array->SetValue(0, value);
  output->GetFieldData()->AddArray(array);
}

constexpr const char* AdviceOnSinglePrecision =
  " from their places in single precision. Set OutputPointsPrecision to the default or to double "
  "precision, or raise the tolerance.";
constexpr const char* AdviceOnCoordinates =
  " from their places: they are rounded far from the origin, or joined with others. Raise the "
  "tolerance.";

/// 1, 2 or 5 times a power of ten, the largest that is at most a tenth over a positive length, so
/// that roundings of a round length do not count.
double roundLength(double length)
{
  double largest = 0.0;
  for (const double number : roundNumbersAround(length))
  {
    largest = number <= 1.1 * length ? number : largest;
  }
  return largest;
}

/// What an execution has computed. On ranks that do not work, whether the others have refined, and
/// their frames.
struct FieldResult
{
  std::vector<double> vertexDistances;
  bool isRefined = false;
  /// Whether refinement has added points on any rank.
  bool hasNewPoints = false;
  /// The refined mesh, and the values at its points, by blocks of the surface; nothing for each
  /// unless it is refined.
  std::vector<RefinedBlock> refined;
  /// If arrays beside the distance are asked for, what they hold; what angles are measured in, and
  /// arc lengths along the curves: see SourceArrays.
  std::vector<SourceValues> atVertices;
  SourceFrames frames;
  std::vector<std::vector<double>> arcLengthsOfCurves;
};

}

/// The parts of Compute(): they compute a FieldResult, and write it.
class vtkGeodesicDistanceField::vtkWorker
{
public:
  vtkGeodesicDistanceField* Self;
  const geodesic::Inputs& Inputs;
  FilterExecution& Execution;
  const SourceArrayChoice Choice = ChoiceOf(Self);

  static SourceArrayChoice ChoiceOf(const vtkGeodesicDistanceField* self)
  {
    return { self->GenerateSourceIds, self->GenerateClosestPoints, self->GenerateGradients,
      self->GenerateSignedDistance, self->GenerateSourceArcLength, self->GenerateSourceAngle,
      self->GenerateTextureCoordinates };
  }

  static bool AreBordersRefined(const vtkGeodesicDistanceField* self)
  {
    return self->RefineSourceBorders || self->GenerateTextureCoordinates;
  }

  /// If another rank has done all the work, this one reports the same.
  void Share(FieldResult& result) const
  {
    Exchange& exchange = this->Execution.exchange();
    const bool isWorking = this->Inputs.rank.isWorking();
    shareResults(exchange, isWorking, this->Self->WindowsPropagatedPerEdge,
      this->Self->SourceLength, this->Self->SourceSnapDistance, this->Self->RelativeErrorBound,
      this->Self->InterpolationErrorBound, this->Self->SeamPointsJoined, result.isRefined,
      result.hasNewPoints);
    if (this->Choice.angles)
    {
      shareResults(exchange, isWorking, result.frames.frames);
      shareResults(exchange, isWorking, result.frames.ids);
    }
  }

  double LengthOfSource() const
  {
    double length = 0.0;
    for (const SourceCurve& curve : this->Inputs.sources.curves)
    {
      length += curve.isOutline ? lengthOf(this->Inputs.patch->mesh(), curve) : 0.0;
    }
    return this->Inputs.surface->scale.toUser(length);
  }

  /// The length of a tile of texture coordinates, in the user's scale.
  double TextureTile() const
  {
    const PolyDataSurface& surface = *this->Inputs.surface;
    return this->Self->TextureScale > 0.0 ? this->Self->TextureScale
      : surface.diagonal > 0.0 ? roundLength(0.1 * surface.scale.toUser(surface.diagonal))
                               : 1.0;
  }

  double Tolerance() const
  {
    return this->Inputs.toleranceOf(this->Self->ToleranceIsAbsolute,
      this->Self->AbsoluteRefinementTolerance, this->Self->RefinementTolerance);
  }

  /// What is left of the tolerance for the interpolant, beside the displacement of points. A part
  /// of at least a half, so that refinement ends; all if the displacement alone is over the
  /// tolerance, which no refinement can meet then.
  double ToleranceOfInterpolant(const Displacements& displaced) const
  {
    const double tolerance = this->Tolerance();
    const double displacement = displaced.largest();
    // The sum of both is rounded, too.
    const double left = (1.0 - 4.0 * tolerance::Rounding) * (tolerance - displacement);
    return displacement < tolerance ? std::max(left, 0.5 * tolerance) : tolerance;
  }

  bool CanRefine() const
  {
    if (!this->Self->RefineMesh || !(this->Tolerance() > 0.0))
    {
      return false; // a surface without extent has nothing to refine
    }
    const vtkIdType most = this->Self->MaximumNumberOfCells;
    const auto count = static_cast<vtkIdType>(this->Inputs.surface->countPartsOfAllRanks());
    if (most > 0 && count > most)
    {
      this->Execution.notes().add(NoteOn::Surface, "over " + std::to_string(most),
        "The surface has " + std::to_string(count) +
          " triangles, more than MaximumNumberOfCells (" + std::to_string(most) +
          "): it is not refined. Raise MaximumNumberOfCells to refine it, or switch RefineMesh "
          "off.");
      return false;
    }
    return true;
  }

  /// \throws Error
  FieldResult ComputeResult() const
  {
    const PolyDataSurface& surface = *this->Inputs.surface;
    if (this->Choice.areSidesNeeded())
    {
      requireSides(surface,
        this->Choice.signedDistances ? "GenerateSignedDistance" : "GenerateTextureCoordinates");
    }
    requireRangeOf(this->Self->OutputPointsPrecision, surface);
    FieldResult result;
    result.isRefined = this->CanRefine();
    Displacements displaced;
    if (result.isRefined)
    {
      displaced = displacementsOfPoints(surface, this->Inputs.surfaceBlocks,
        this->Self->OutputPointsPrecision, this->Execution.job());
    }
    SolvedSurface solved =
      solveField(this->Inputs, this->Request(result.isRefined, displaced), this->Execution);
    this->TakeNumbers(solved);
    if (result.isRefined)
    {
      const RefinedMesh& refined = solved.refined;
      result.hasNewPoints = surface.exchange().isTrueAnywhere(!refined.points.empty());
      this->TakeErrorBound(refined, result.hasNewPoints, displaced);
    }
    result.vertexDistances = solved.field->vertexDistances();
    std::vector<SourceValues> atNewPoints;
    if (this->Choice.isAny())
    {
      atNewPoints = this->FindSources(solved, result);
    }
    result.refined = partsByBlock(surface, std::move(solved.refined), std::move(atNewPoints));
    surface.completeValues(Infinity, result.vertexDistances);
    return result;
  }

  FieldRequest Request(bool isRefined, const Displacements& displaced) const
  {
    const vtkGeodesicDistanceField* self = this->Self;
    FieldRequest request;
    request.relativeError = self->Accuracy == APPROXIMATE ? self->RelativeError : 0.0;
    request.maximumDistance = this->Inputs.limitOf(self->MaximumDistance);
    request.arrays = this->Choice;
    request.isRefined = isRefined;
    request.tolerance = this->ToleranceOfInterpolant(displaced);
    request.maximumCells = static_cast<std::uint64_t>(self->MaximumNumberOfCells);
    request.areBordersRefined = AreBordersRefined(self);
    return request;
  }

  void TakeNumbers(const SolvedSurface& solved) const
  {
    const PolyDataSurface& surface = *this->Inputs.surface;
    this->Self->SourceSnapDistance = surface.scale.toUser(this->Inputs.sources.snapDistance);
    this->Self->SourceLength = this->LengthOfSource();
    this->Self->SeamPointsJoined = surface.report.joinedSeamPoints;
    this->Self->WindowsPropagatedPerEdge = static_cast<double>(solved.field->windowsPropagated()) /
      static_cast<double>(surface.report.edges);
    this->Self->RelativeErrorBound = solved.field->relativeErrorBound();
  }

  void TakeErrorBound(
    const RefinedMesh& refined, bool hasNewPoints, const Displacements& displaced) const
  {
    const double bound =
      refined.errorBound + (hasNewPoints ? displaced.largest() : displaced.ofInputPoints);
    this->NoteToleranceNotMet(refined, bound, this->ToleranceOfInterpolant(displaced));
    this->Self->InterpolationErrorBound = this->Inputs.surface->scale.toUser(bound);
  }

  SourceArrays Arrays() const
  {
    return { *this->Inputs.surface, this->Inputs.sources, this->TextureTile(),
      this->Self->TextureRepeats ? 0.0 : 0.5, this->Choice };
  }

  /// \returns the values at the points that refinement has added.
  std::vector<SourceValues> FindSources(const SolvedSurface& solved, FieldResult& result) const
  {
    const Job job = this->Execution.begin(Stage::FindSources);
    const DistanceField& field = *solved.field;
    const DistanceField& exact = solved.exactField();
    NearestSource nearest(
      exact, *this->Inputs.patch, this->Inputs.sources.curves, job.part(0.0, 0.3));
    const SourceArrays arrays = this->Arrays();
    result.atVertices = arrays.atVertices(field, nearest, job.part(0.3, 0.6));
    if (this->Choice.angles)
    {
      result.frames = framesBySource(nearest.curvesOnPatch(), this->Inputs.sources);
    }
    result.arcLengthsOfCurves = arrays.arcLengthsOfCurves(nearest);
    return result.isRefined ? arrays.atNewPoints(solved.refined, result.atVertices, field, exact,
                                nearest, job.part(0.6, 1.0))
                            : std::vector<SourceValues>();
  }

  /// \param requested the tolerance of the interpolant.
  void NoteToleranceNotMet(const RefinedMesh& refined, double bound, double requested) const
  {
    const PowerOfTwoScale& scale = this->Inputs.surface->scale;
    const std::string most = std::to_string(this->Self->MaximumNumberOfCells);
    std::ostringstream text;
    text << " refined surface meets a tolerance of " << scale.toUser(bound) << " instead of "
         << scale.toUser(this->Tolerance());
    const std::string met = text.str();
    if (refined.stoppedAtMaximum)
    {
      this->Execution.notes().add(NoteOn::Surface, "reached " + most,
        "MaximumNumberOfCells (" + most + ") is reached: the" + met +
          ". Raise MaximumNumberOfCells or the tolerance.");
    }
    else if (bound > this->Tolerance() && refined.errorBound > requested)
    {
      this->Execution.notes().add(NoteOn::Surface, "rounding",
        "The" + met + ", which is near the rounding of distances. Raise the tolerance.");
    }
    else if (bound > this->Tolerance())
    {
      const bool isSingle = this->Self->OutputPointsPrecision == SINGLE_PRECISION;
      std::ostringstream displaced;
      displaced << "The" << met << ", as points are up to "
                << scale.toUser(bound - refined.errorBound)
                << (isSingle ? AdviceOnSinglePrecision : AdviceOnCoordinates);
      this->Execution.notes().add(NoteOn::Surface, "displacement", displaced.str());
    }
  }

  void WriteSurface(const FieldResult& result, vtkDataObject* output, const Job& job) const
  {
    const std::vector<PolyDataBlock>& inputs = this->Inputs.surfaceBlocks;
    const std::vector<SurfaceBlock>& blocks = this->Inputs.surface->blocks;
    const std::vector<vtkPolyData*> outputs = makeBlocksLike(this->Inputs.surfaceInput, output);
    const auto count = static_cast<double>(blocks.size());
    for (std::size_t i = 0; i < blocks.size(); ++i)
    {
      const auto before = static_cast<double>(i);
      const Job ofBlock = job.part(before / count, (before + 1.0) / count);
      const BlockToWrite to = { blocks[i], inputs[i].data, outputs[i],
        this->TypeOfPoints(result, i) };
      if (result.isRefined)
      {
        writeRefined(to, result.refined[i].mesh, this->Inputs.surface->scale, ofBlock);
      }
      else
      {
        writeWhole(to, ofBlock);
      }
      this->WriteDistances(result, i, outputs[i]);
      if (this->Self->RemoveUnusedPoints)
      {
        removeUnusedPoints(outputs[i]);
      }
      outputs[i]->GetFieldData()->PassData(inputs[i].data->GetFieldData());
      this->WriteFieldData(result.frames, outputs[i]);
    }
    this->WriteFieldData(result.frames, output);
  }

  /// One type on all ranks, whose pieces are one data set: files of pieces need that.
  int TypeOfPoints(const FieldResult& result, std::size_t block) const
  {
    return typeOfPoints(this->Inputs.surfaceBlocks[block].data->GetPoints(),
      this->Self->OutputPointsPrecision,
      this->Inputs.rank.isInPieces() || !this->Inputs.rank.isWorking()
        ? result.hasNewPoints
        : !result.refined[block].mesh.points.empty());
  }

  void WriteDistances(const FieldResult& result, std::size_t index, vtkPolyData* output) const
  {
    const PolyDataSurface& surface = *this->Inputs.surface;
    const SurfaceBlock& block = surface.blocks[index];
    const auto distances =
      makeArray<vtkDoubleArray>(this->Self->DistanceArrayName, output->GetNumberOfPoints());
    vtkIdType next = 0;
    const auto add = [&](double distance)
    { distances->SetValue(next++, surface.scale.distanceToUser(distance)); };
    for (Id i = 0; i < block.numberOfPoints; ++i)
    {
      add(result.vertexDistances[surface.vertexOf(block.firstPoint + i)]);
    }
    for (const RefinedPoint& point : result.refined[index].mesh.points)
    {
      add(point.distance);
    }
    const int unreachedMode = this->Self->UnreachedValue;
    const double unreached = unreachedMode == UNREACHED_NAN
      ? std::numeric_limits<double>::quiet_NaN()
      : unreachedMode == UNREACHED_CUSTOM ? this->Self->CustomUnreachedValue
                                          : Infinity;
    if (this->Choice.isAny())
    {
      this->Arrays().write(block, result.atVertices, result.refined[index].values,
        distances->GetPointer(0), unreached, output);
    }
    double* first = distances->GetPointer(0);
    this->TakeFarthest(first, output);
    std::replace(first, first + distances->GetNumberOfTuples(), Infinity, unreached);
    output->GetPointData()->AddArray(distances);
    output->GetPointData()->SetActiveScalars(this->Self->DistanceArrayName);
  }

  /// Looks at the points of triangles, where those that are not reached are infinitely far.
  void TakeFarthest(const double* distances, vtkPolyData* output) const
  {
    vtkGeodesicDistanceField* self = this->Self;
    forEachCell(output->GetPolys(),
      [&](vtkIdType size, const vtkIdType* ids)
      {
        for (vtkIdType i = 0; i < size; ++i)
        {
          const double distance = distances[ids[i]];
          if (distance == Infinity)
          {
            self->HasUnreachedPoints = true;
          }
          else if (distance > self->LargestDistance)
          {
            self->LargestDistance = distance;
            output->GetPoint(ids[i], self->FarthestPoint);
          }
        }
      });
  }

  /// All ranks call this, each with what it has of the output.
  void ShareFarthest() const
  {
    vtkGeodesicDistanceField* self = this->Self;
    struct Farthest
    {
      double distance;
      std::array<double, 3> place;
      bool hasUnreached;
    };
    Farthest own = { self->LargestDistance, {}, self->HasUnreachedPoints };
    std::copy_n(self->FarthestPoint, 3, own.place.begin());
    for (const Farthest& other : valuesOfRanks(this->Execution.exchange(), own))
    {
      self->HasUnreachedPoints = self->HasUnreachedPoints || other.hasUnreached;
      if (other.distance > own.distance)
      {
        own = other;
      }
    }
    self->LargestDistance = own.distance;
    std::copy_n(own.place.begin(), 3, self->FarthestPoint);
  }

  void WriteFieldData(const SourceFrames& frames, vtkDataObject* output) const
  {
    addFieldData(output, "WindowsPropagatedPerEdge", this->Self->WindowsPropagatedPerEdge);
    addFieldData(output, "SourceLength", this->Self->SourceLength);
    addFieldData(output, "SourceSnapDistance", this->Self->SourceSnapDistance);
    addFieldData(output, "RelativeErrorBound", this->Self->RelativeErrorBound);
    addFieldData(output, "InterpolationErrorBound", this->Self->InterpolationErrorBound);
    addFieldData(output, "SeamPointsJoined", static_cast<double>(this->Self->SeamPointsJoined));
    if (this->Choice.angles)
    {
      addSourceFrames(frames, output);
    }
  }

  void NoteReplacedArrays(bool isRefined) const
  {
    const auto noteOn = [this](const char* kind, int type, const char* name, const char* advice)
    {
      const std::vector<PolyDataBlock>& blocks = this->Inputs.surfaceBlocks;
      if (std::any_of(blocks.begin(), blocks.end(),
            [&](const PolyDataBlock& block)
            { return block.data->GetAttributesAsFieldData(type)->HasArray(name) != 0; }))
      {
        this->Execution.notes().add(NoteOn::Surface, std::string("replaced: ") + name,
          std::string("The surface already has a ") + kind + " array named " + name +
            "; the output has " + advice);
      }
    };
    if (isRefined)
    {
      noteOn("cell", vtkDataObject::CELL, "OriginalCellIds", "the input's cells in its place.");
    }
    noteOn("point", vtkDataObject::POINT, this->Self->DistanceArrayName,
      "the distance in its place. Change DistanceArrayName to keep both.");
    for (const char* added : namesOf(this->Choice))
    {
      noteOn("point", vtkDataObject::POINT, added,
        "the filter's in its place. Rename it upstream to keep both.");
    }
  }
};

//------------------------------------------------------------------------------
vtkGeodesicDistanceField::vtkGeodesicDistanceField()
{
  this->SetNumberOfOutputPorts(2);
  this->SetDistanceArrayName("GeodesicDistance");
}

//------------------------------------------------------------------------------
vtkGeodesicDistanceField::~vtkGeodesicDistanceField()
{
  this->SetDistanceArrayName(nullptr);
}

//------------------------------------------------------------------------------
int vtkGeodesicDistanceField::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkDataObject" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkGeodesicDistanceField::FindWrongProperty() const
{
  if (!this->DistanceArrayName || !*this->DistanceArrayName)
  {
    return "DistanceArrayName is empty: set a name for the distance array.";
  }
  for (const char* name : namesOf(vtkWorker::ChoiceOf(this)))
  {
    if (std::string(name) == this->DistanceArrayName)
    {
      return std::string("DistanceArrayName is ") + name +
        ", which is the name of another array that is asked for: set another name.";
    }
  }
  const std::pair<bool, const char*> checks[] = {
    { this->Accuracy == APPROXIMATE &&
        !(this->RelativeError >= 0.0 && this->RelativeError < Infinity),
      "RelativeError is not a finite number of at least 0: set the largest relative error that is "
      "allowed in approximate mode, such as 0.001, or 0 for the exact distance." },
    { this->RefineMesh && !this->ToleranceIsAbsolute && !isPositive(this->RefinementTolerance),
      "RefinementTolerance is not a positive number: set the largest difference that is allowed, "
      "as a fraction of the surface's bounding box diagonal, such as 0.001, or switch RefineMesh "
      "off." },
    { this->RefineMesh && this->ToleranceIsAbsolute &&
        !isPositive(this->AbsoluteRefinementTolerance),
      "AbsoluteRefinementTolerance is not a positive number: set the largest difference that is "
      "allowed, in the units of the surface, or switch RefineMesh off." },
    { this->RefineMesh && this->MaximumNumberOfCells < 0,
      "MaximumNumberOfCells is negative: set the largest number of triangles that the refined "
      "surface may have, or 0 for no limit." },
    { !(this->MaximumDistance >= 0.0), WrongMaximumDistance },
    { this->GenerateTextureCoordinates &&
        !(this->TextureScale >= 0.0 && this->TextureScale < Infinity),
      "TextureScale is not a finite number of at least 0: set the length of a texture's tile, "
      "in the units of the surface, or 0 for a round one." }
  };
  for (const auto& [isWrong, message] : checks)
  {
    if (isWrong)
    {
      return message;
    }
  }
  return this->Superclass::FindWrongProperty();
}

//------------------------------------------------------------------------------
std::string vtkGeodesicDistanceField::AdviceOnMemory() const
{
  return "Decimate the surface, cut it into parts, set MaximumDistance, switch RefineMesh off or "
         "set Accuracy to Approximate.";
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceField::ResetResults()
{
  this->WindowsPropagatedPerEdge = 0.0;
  this->SourceLength = 0.0;
  this->SourceSnapDistance = 0.0;
  this->RelativeErrorBound = 0.0;
  this->InterpolationErrorBound = Infinity;
  this->SeamPointsJoined = 0;
  this->LargestDistance = 0.0;
  std::fill_n(this->FarthestPoint, 3, 0.0);
  this->HasUnreachedPoints = false;
}

//------------------------------------------------------------------------------
ExecutionPlan vtkGeodesicDistanceField::Plan() const
{
  const SourceArrayChoice choice = vtkWorker::ChoiceOf(this);
  ExecutionPlan plan;
  plan.needsSides = choice.areSidesNeeded();
  const auto add = [&plan](Stage stage, bool isThere)
  { plan.stages.insert(plan.stages.end(), isThere ? 1 : 0, stage); };
  const bool isApproximate = this->Accuracy == APPROXIMATE && this->RelativeError > 0.0;
  add(Stage::FindBorders, this->RefineMesh && vtkWorker::AreBordersRefined(this) && !isApproximate);
  add(Stage::Solve, true);
  add(Stage::Refine, this->RefineMesh);
  add(Stage::SolveExactly, isApproximate && choice.areFeetNeeded());
  add(Stage::FindSources, choice.isAny());
  add(Stage::Write, true);
  return plan;
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceField::Compute(
  const Inputs& inputs, FilterExecution& execution, vtkInformationVector* outputVector)
{
  const vtkWorker worker{ this, inputs, execution };
  FieldResult result;
  if (inputs.rank.isWorking())
  {
    result = worker.ComputeResult();
  }
  worker.Share(result);
  const Job writing = execution.begin(Stage::Write);
  if (inputs.rank.isWorking())
  {
    worker.NoteReplacedArrays(result.isRefined);
  }
  result.refined.resize(inputs.surface->blocks.size());
  worker.WriteSurface(result, vtkDataObject::GetData(outputVector, 0), writing);
  worker.ShareFarthest();
  if (inputs.rank.isWorking() && inputs.rank.writesSource())
  {
    writeCurves(inputs.patch->mesh(), inputs.surface->scale, inputs.sources,
      result.arcLengthsOfCurves, vtkPolyData::GetData(outputVector, 1));
  }
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Accuracy: " << (this->Accuracy == EXACT ? "Exact" : "Approximate") << "\n";
  os << indent << "RelativeError: " << this->RelativeError << "\n";
  os << indent << "RefineMesh: " << (this->RefineMesh ? "On" : "Off") << "\n";
  os << indent << "RefinementTolerance: " << this->RefinementTolerance << "\n";
  os << indent << "RefineSourceBorders: " << (this->RefineSourceBorders ? "On" : "Off") << "\n";
  os << indent << "ToleranceIsAbsolute: " << (this->ToleranceIsAbsolute ? "On" : "Off") << "\n";
  os << indent << "AbsoluteRefinementTolerance: " << this->AbsoluteRefinementTolerance << "\n";
  os << indent << "MaximumNumberOfCells: " << this->MaximumNumberOfCells << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
  constexpr const char* unreachedValues[] = { "Infinity", "NaN", "Custom" };
  os << indent << "UnreachedValue: " << unreachedValues[this->UnreachedValue] << "\n";
  os << indent << "CustomUnreachedValue: " << this->CustomUnreachedValue << "\n";
  os << indent << "RemoveUnusedPoints: " << (this->RemoveUnusedPoints ? "On" : "Off") << "\n";
  os << indent
     << "DistanceArrayName: " << (this->DistanceArrayName ? this->DistanceArrayName : "(none)")
     << "\n";
  const auto onOff = [](bool value) { return value ? "On" : "Off"; };
  os << indent << "GenerateSourceIds: " << onOff(this->GenerateSourceIds) << "\n";
  os << indent << "GenerateClosestPoints: " << onOff(this->GenerateClosestPoints) << "\n";
  os << indent << "GenerateGradients: " << onOff(this->GenerateGradients) << "\n";
  os << indent << "GenerateSignedDistance: " << onOff(this->GenerateSignedDistance) << "\n";
  os << indent << "GenerateSourceArcLength: " << onOff(this->GenerateSourceArcLength) << "\n";
  os << indent << "GenerateSourceAngle: " << onOff(this->GenerateSourceAngle) << "\n";
  os << indent << "GenerateTextureCoordinates: " << onOff(this->GenerateTextureCoordinates) << "\n";
  os << indent << "TextureScale: " << this->TextureScale << "\n";
  os << indent << "TextureRepeats: " << onOff(this->TextureRepeats) << "\n";
  os << indent << "WindowsPropagatedPerEdge: " << this->WindowsPropagatedPerEdge << "\n";
  os << indent << "SourceLength: " << this->SourceLength << "\n";
  os << indent << "SourceSnapDistance: " << this->SourceSnapDistance << "\n";
  os << indent << "RelativeErrorBound: " << this->RelativeErrorBound << "\n";
  os << indent << "InterpolationErrorBound: " << this->InterpolationErrorBound << "\n";
  os << indent << "SeamPointsJoined: " << this->SeamPointsJoined << "\n";
  os << indent << "LargestDistance: " << this->LargestDistance << "\n";
  os << indent << "FarthestPoint: " << this->FarthestPoint[0] << " " << this->FarthestPoint[1]
     << " " << this->FarthestPoint[2] << "\n";
  os << indent << "HasUnreachedPoints: " << onOff(this->HasUnreachedPoints) << "\n";
}
