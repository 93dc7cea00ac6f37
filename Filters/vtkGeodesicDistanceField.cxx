// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicDistanceField.h"

#include "refinement/AdaptiveRefinement.h"
#include "refinement/SolveForRefinement.h"
#include "source/BoundaryCurves.h"
#include "PolyData/ArrayMemory.h"
#include "Errors.h"
#include "PolyData/ParallelFor.h"
#include "PolyData/PolyDataSource.h"
#include "PolyData/PolyDataSurface.h"
#include "field/JoinPoints.h"
#include "field/Solve.h"
#include "PolyData/RefinedPolyData.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVersionMacros.h"

#include <new>
#include <sstream>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkGeodesicDistanceField);

namespace
{

using geodesic::SourceError;

// Where the stages of an execution end, as fractions of the whole.
constexpr double SurfaceDone = 0.15;
constexpr double SourceLocated = 0.2;
constexpr double SourceDone = 0.25;
constexpr double FieldDoneBeforeRefinement = 0.55;
constexpr double FieldDone = 0.9;
constexpr double SurfaceWritten = 0.98;

// Below malloc's threshold for memory of its own, so that it is at hand when it is freed.
constexpr std::size_t MemoryForMessages = 1 << 16;

// A source farther from the surface than this fraction of its bounding box's diagonal was hardly
// meant for it: the user is told.
constexpr double FarSourceFraction = 0.01;

/// Collects what the user should know into one warning.
class Notes
{
public:
  template <typename Count>
  void add(Count count, const char* one, const char* many, const char* what)
  {
    if (count > 0)
    {
      this->text_ << "\n  " << count << ' ' << (count == 1 ? one : many) << ' ' << what;
    }
  }
  void add(const std::string& sentence) { this->text_ << "\n  " << sentence; }
  std::string text() const { return this->text_.str(); }

private:
  std::ostringstream text_;
};

void noteSurface(const geodesic::PolyDataSurface& surface, Notes& notes)
{
  const auto& read = surface.report();
  const auto& mesh = surface.mesh().report();
  notes.add(read.polygons, "polygon", "polygons", "of the surface triangulated.");
  notes.add(read.strips, "triangle strip", "triangle strips", "of the surface triangulated.");
  notes.add(read.droppedLineCells, "line", "lines", "among the surface's cells dropped.");
  notes.add(
    read.droppedVertexCells, "vertex cell", "vertex cells", "among the surface's cells dropped.");
  notes.add(
    read.facesWithRepeatedPoint, "face", "faces", "with two corners at one point left out.");
  notes.add(mesh.duplicateFaces, "duplicate face", "duplicate faces",
    "(on the points of another face), without effect on the distance.");
  notes.add(mesh.zeroAreaFaces, "face", "faces", "without area, kept.");
  notes.add(
    mesh.isolatedVertices, "point", "points", "of the surface used by no face: infinitely far.");
}

void noteSource(
  const geodesic::PolyDataSurface& surface, const geodesic::SourceCurves& source, Notes& notes)
{
  notes.add(source.repeatedPoints, "point", "points",
    "of the source at the place of the one before, left out.");
  if (source.snapDistance > FarSourceFraction * surface.diagonal())
  {
    std::ostringstream sentence;
    sentence << "The source is up to " << source.snapDistance
             << " away from the surface; it was put onto the surface's closest points. See output "
                "port 1 for the result.";
    notes.add(sentence.str());
  }
}

void addFieldData(vtkPolyData* output, const char* name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  output->GetFieldData()->AddArray(array);
}

bool isPositive(double value)
{
  return value > 0.0 && value < geodesic::Infinity;
}

}

/// One execution's work, and the surface that the next one may reuse.
class vtkGeodesicDistanceField::vtkInternals
{
public:
  explicit vtkInternals(vtkGeodesicDistanceField* self)
    : Self(self)
  {
  }

  /// \throws geodesic::Error
  void Execute(vtkPolyData* input, vtkPolyData* source, vtkPolyData* output, vtkPolyData* curves);

  void ReleaseSurface() { this->Surface.reset(); }

private:
  /// What is known at points after the solve and after refinement.
  struct Result
  {
    std::vector<double> vertexDistances;
    /// Whether there is a refined mesh.
    bool isRefined = false;
    geodesic::RefinedMesh refined;
  };

  geodesic::ProgressCallback ProgressBetween(double begin, double end);
  /// Tells that the execution has come so far.
  ///
  /// \throws geodesic::Aborted
  void Reach(double fraction);
  void UpdateSurface(vtkPolyData* input);
  geodesic::SourceCurves CollectSources(vtkPolyData* source);
  void AddBoundary(bool hasCurve, std::vector<geodesic::SourceCurve>& curves);
  bool CanRefine();
  double Tolerance() const;
  Result Compute(const std::vector<geodesic::SourceCurve>& curves);
  geodesic::DistanceField Solve(const std::vector<geodesic::SourceCurve>& curves, bool refine);
  geodesic::RefinedMesh Refine(const geodesic::DistanceField& field);
  void WriteSurface(const Result& result, vtkPolyData* input, vtkPolyData* output);
  void WriteDistances(const Result& result, vtkPolyData* input, vtkPolyData* output);

  vtkGeodesicDistanceField* Self;
  Notes Told;

  std::unique_ptr<geodesic::PolyDataSurface> Surface;
  /// What Surface was made from. Never dereferenced: the time of modification, which no two objects
  /// share, tells whether it is still the same.
  const vtkPolyData* SurfaceInput = nullptr;
  vtkMTimeType SurfaceTime = 0;
  bool SurfaceMerged = false;
};

//------------------------------------------------------------------------------
void vtkGeodesicDistanceField::vtkInternals::Execute(
  vtkPolyData* input, vtkPolyData* source, vtkPolyData* output, vtkPolyData* curves)
{
  this->Told = Notes();
  this->UpdateSurface(input);
  const geodesic::SourceCurves sources = this->CollectSources(source);
  this->Self->SourceSnapDistance = sources.snapDistance;
  const Result result = this->Compute(sources.curves);
  this->Reach(FieldDone);

  this->WriteSurface(result, input, output);
  addFieldData(output, "WindowsPropagatedPerEdge", this->Self->WindowsPropagatedPerEdge);
  addFieldData(output, "SourceSnapDistance", this->Self->SourceSnapDistance);
  addFieldData(output, "RelativeErrorBound", this->Self->RelativeErrorBound);
  addFieldData(output, "InterpolationErrorBound", this->Self->InterpolationErrorBound);
  geodesic::writeCurves(this->Surface->mesh(), sources.curves, curves);

  if (!this->Told.text().empty())
  {
    vtkWarningWithObjectMacro(this->Self, "About the input:" << this->Told.text());
  }
}

//------------------------------------------------------------------------------
geodesic::ProgressCallback vtkGeodesicDistanceField::vtkInternals::ProgressBetween(
  double begin, double end)
{
  return [this, begin, end](double fraction)
  {
    this->Self->UpdateProgress(begin + fraction * (end - begin));
#if VTK_VERSION_NUMBER >= 90220220630ULL
    return !this->Self->CheckAbort();
#else
    return !this->Self->GetAbortExecute();
#endif
  };
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceField::vtkInternals::Reach(double fraction)
{
  if (!this->ProgressBetween(fraction, fraction)(1.0))
  {
    throw geodesic::Aborted();
  }
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceField::vtkInternals::UpdateSurface(vtkPolyData* input)
{
  const bool merge = this->Self->MergeCoincidentPoints;
  if (!this->Surface || this->SurfaceInput != input || this->SurfaceTime != input->GetMTime() ||
    this->SurfaceMerged != merge)
  {
    this->ReleaseSurface();
    this->Surface = std::make_unique<geodesic::PolyDataSurface>(
      input, merge, this->ProgressBetween(0.0, SurfaceDone));
    this->SurfaceInput = input;
    this->SurfaceTime = input->GetMTime();
    this->SurfaceMerged = merge;
    noteSurface(*this->Surface, this->Told);
  }
  this->Reach(SurfaceDone);
}

//------------------------------------------------------------------------------
geodesic::SourceCurves vtkGeodesicDistanceField::vtkInternals::CollectSources(vtkPolyData* source)
{
  const int type = this->Self->SourceType;
  if (type == SOURCE_CURVE && !source)
  {
    throw SourceError("There is no source: connect a curve to input port 1 (SetSourceConnection or "
                      "SetSourceData; Source in ParaView), or set SourceType to Surface Boundary.");
  }
  geodesic::SourceCurves sources;
  if (type != SURFACE_BOUNDARY && source)
  {
    const auto lines = geodesic::readSource(
      source, *this->Surface, this->ProgressBetween(SurfaceDone, SourceLocated));
    sources = geodesic::putOntoSurface(this->Surface->mesh(), lines,
      geodesic::snapOptionsFor(source), geodesic::joinByShortestPaths(this->Surface->mesh()),
      this->ProgressBetween(SourceLocated, SourceDone));
    noteSource(*this->Surface, sources, this->Told);
  }
  if (type != SOURCE_CURVE)
  {
    this->AddBoundary(source && type == CURVE_AND_BOUNDARY, sources.curves);
  }
  return sources;
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceField::vtkInternals::AddBoundary(
  bool hasCurve, std::vector<geodesic::SourceCurve>& curves)
{
  std::vector<geodesic::SourceCurve> boundary = geodesic::boundaryCurves(this->Surface->mesh());
  if (boundary.empty() && !hasCurve)
  {
    throw SourceError(
      "The surface (input port 0) is closed: it has no boundary to measure from. Set "
      "SourceType to Source Curve and connect a curve to input port 1.");
  }
  if (boundary.empty())
  {
    this->Told.add("The surface is closed, without boundary: the curve alone is the source.");
  }
  if (!hasCurve && this->Self->SourceType == CURVE_AND_BOUNDARY)
  {
    this->Told.add("No curve is connected to input port 1: the boundary alone is the source.");
  }
  std::move(boundary.begin(), boundary.end(), std::back_inserter(curves));
}

//------------------------------------------------------------------------------
double vtkGeodesicDistanceField::vtkInternals::Tolerance() const
{
  return this->Self->ToleranceIsAbsolute
    ? this->Self->AbsoluteRefinementTolerance
    : this->Self->RefinementTolerance * this->Surface->diagonal();
}

//------------------------------------------------------------------------------
bool vtkGeodesicDistanceField::vtkInternals::CanRefine()
{
  const vtkIdType most = this->Self->MaximumNumberOfCells;
  const vtkIdType count = this->Surface->numberOfTriangles();
  if (!this->Self->RefineMesh || !(this->Tolerance() > 0.0))
  {
    return false; // a surface without extent has nothing to refine
  }
  if (most > 0 && count > most)
  {
    vtkWarningWithObjectMacro(this->Self,
      "The surface has " << count << " triangles, more than MaximumNumberOfCells (" << most
                         << "): it is not refined. Raise MaximumNumberOfCells to refine it, or "
                            "switch RefineMesh off.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
vtkGeodesicDistanceField::vtkInternals::Result vtkGeodesicDistanceField::vtkInternals::Compute(
  const std::vector<geodesic::SourceCurve>& curves)
{
  Result result;
  result.isRefined = this->CanRefine();
  const geodesic::DistanceField field = this->Solve(curves, result.isRefined);
  this->Self->WindowsPropagatedPerEdge = static_cast<double>(field.windowsPropagated()) /
    static_cast<double>(this->Surface->mesh().numberOfEdges());
  this->Self->RelativeErrorBound = field.relativeErrorBound();
  if (result.isRefined)
  {
    result.refined = this->Refine(field);
    this->Self->InterpolationErrorBound = result.refined.errorBound;
  }
  result.vertexDistances = field.vertexDistances();
  return result;
}

//------------------------------------------------------------------------------
geodesic::DistanceField vtkGeodesicDistanceField::vtkInternals::Solve(
  const std::vector<geodesic::SourceCurve>& curves, bool refine)
{
  geodesic::FrontOptions options;
  if (this->Self->Accuracy == APPROXIMATE)
  {
    options.relativeError = this->Self->RelativeError;
  }
  if (this->Self->MaximumDistance > 0.0)
  {
    options.maximumDistance = this->Self->MaximumDistance;
  }
  options.parallelFor = geodesic::smpParallelFor();
  options.progress =
    this->ProgressBetween(SourceDone, refine ? FieldDoneBeforeRefinement : FieldDone);
  const geodesic::TriangleMesh& mesh = this->Surface->mesh();
  return refine ? geodesic::solveForRefinement(mesh, curves, this->Tolerance(), options)
                : geodesic::solve(mesh, curves, options);
}

//------------------------------------------------------------------------------
geodesic::RefinedMesh vtkGeodesicDistanceField::vtkInternals::Refine(
  const geodesic::DistanceField& field)
{
  const geodesic::TriangleMesh& mesh = this->Surface->mesh();
  const auto most = static_cast<std::uint64_t>(this->Self->MaximumNumberOfCells);
  geodesic::RefinementOptions options;
  options.tolerance = this->Tolerance();
  if (most > 0)
  {
    const auto duplicates =
      static_cast<std::uint64_t>(this->Surface->numberOfTriangles()) - mesh.numberOfFaces();
    options.maximumFaces = most - duplicates;
  }
  if (this->Self->MaximumDistance > 0.0)
  {
    options.maximumDistance = this->Self->MaximumDistance;
  }
  if (this->Surface->hasMergedPoints())
  {
    options.cornerPoints.reserve(mesh.numberOfFaces());
    for (geodesic::Id face = 0; face < mesh.numberOfFaces(); ++face)
    {
      options.cornerPoints.push_back(this->Surface->cornerPoints(face));
    }
    options.numberOfPoints = static_cast<geodesic::Id>(this->Surface->numberOfPoints());
  }
  options.progress = this->ProgressBetween(FieldDoneBeforeRefinement, FieldDone);
  geodesic::RefinedMesh refined = geodesic::refine(field, options);
  geodesic::addDuplicateFaces(*this->Surface, most, refined);
  if (refined.stoppedAtMaximum)
  {
    vtkWarningWithObjectMacro(this->Self,
      "MaximumNumberOfCells (" << most << ") is reached: the refined surface meets a tolerance of "
                               << refined.errorBound << " instead of " << options.tolerance
                               << ". Raise MaximumNumberOfCells or the tolerance.");
  }
  else if (refined.errorBound > options.tolerance)
  {
    vtkWarningWithObjectMacro(this->Self,
      "The refined surface meets a tolerance of "
        << refined.errorBound << " instead of " << options.tolerance
        << ", which is near the rounding of distances. Raise the tolerance.");
  }
  return refined;
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceField::vtkInternals::WriteSurface(
  const Result& result, vtkPolyData* input, vtkPolyData* output)
{
  const auto progress = this->ProgressBetween(FieldDone, SurfaceWritten);
  if (result.isRefined)
  {
    geodesic::writeRefined(*this->Surface, result.refined, input, output, progress);
    if (input->GetCellData()->HasArray("OriginalCellIds"))
    {
      this->Told.add("The surface already has a cell array named OriginalCellIds; the output has "
                     "the input's cells in its place.");
    }
  }
  else
  {
    this->Surface->copyTo(input, output, progress);
  }
  this->WriteDistances(result, input, output);
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceField::vtkInternals::WriteDistances(
  const Result& result, vtkPolyData* input, vtkPolyData* output)
{
  const char* name = this->Self->DistanceArrayName;
  const vtkIdType count = input->GetNumberOfPoints();
  geodesic::requireMemory(output->GetNumberOfPoints(), sizeof(double));
  vtkNew<vtkDoubleArray> distances;
  distances->SetName(name);
  distances->SetNumberOfTuples(output->GetNumberOfPoints());
  for (vtkIdType i = 0; i < count; ++i)
  {
    distances->SetValue(i, result.vertexDistances[this->Surface->vertexOf(i)]);
  }
  vtkIdType next = count;
  for (const geodesic::RefinedPoint& point : result.refined.points)
  {
    distances->SetValue(next++, point.distance);
  }
  if (input->GetPointData()->HasArray(name))
  {
    this->Told.add(std::string("The surface already has a point array named ") + name +
      "; the output has the distance in its place. Change DistanceArrayName to keep both.");
  }
  output->GetPointData()->AddArray(distances);
  output->GetPointData()->SetActiveScalars(name);
}

//------------------------------------------------------------------------------
vtkGeodesicDistanceField::vtkGeodesicDistanceField()
  : Internals(new vtkInternals(this))
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  this->SetDistanceArrayName("GeodesicDistance");
}

//------------------------------------------------------------------------------
vtkGeodesicDistanceField::~vtkGeodesicDistanceField()
{
  this->SetDistanceArrayName(nullptr);
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceField::SetSourceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceField::SetSourceData(vtkPolyData* source)
{
  this->SetInputData(1, source);
}

//------------------------------------------------------------------------------
int vtkGeodesicDistanceField::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
const char* vtkGeodesicDistanceField::FindWrongProperty() const
{
  if (!this->DistanceArrayName || !*this->DistanceArrayName)
  {
    return "DistanceArrayName is empty: set a name for the distance array.";
  }
  if (this->Accuracy == APPROXIMATE &&
    !(this->RelativeError >= 0.0 && this->RelativeError < geodesic::Infinity))
  {
    return "RelativeError is not a finite number of at least 0: set the largest relative error "
           "that is allowed "
           "in approximate mode, such as 0.001, or 0 for the exact distance.";
  }
  if (this->RefineMesh && !this->ToleranceIsAbsolute && !isPositive(this->RefinementTolerance))
  {
    return "RefinementTolerance is not a positive number: set the largest difference that is "
           "allowed, as a fraction of the surface's bounding box diagonal, such as 0.001, or "
           "switch RefineMesh off.";
  }
  if (this->RefineMesh && this->ToleranceIsAbsolute &&
    !isPositive(this->AbsoluteRefinementTolerance))
  {
    return "AbsoluteRefinementTolerance is not a positive number: set the largest difference that "
           "is allowed, in the units of the surface, or switch RefineMesh off.";
  }
  return nullptr;
}

//------------------------------------------------------------------------------
int vtkGeodesicDistanceField::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->WindowsPropagatedPerEdge = 0.0;
  this->SourceSnapDistance = 0.0;
  this->RelativeErrorBound = 0.0;
  this->InterpolationErrorBound = geodesic::Infinity;

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
  if (const char* wrong = this->FindWrongProperty())
  {
    vtkErrorMacro(<< wrong);
    return 0;
  }

  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* curves = vtkPolyData::GetData(outputVector, 1);
  const auto release = [output, curves]()
  {
    output->Initialize();
    curves->Initialize();
  };
  std::unique_ptr<char[]> reserve; // for what telling that memory has run out takes itself
  try
  {
    reserve = std::make_unique<char[]>(MemoryForMessages);
    this->Internals->Execute(
      vtkPolyData::GetData(inputVector[0]), vtkPolyData::GetData(inputVector[1]), output, curves);
    return 1;
  }
  catch (const geodesic::Aborted&)
  {
    release();
    return 1;
  }
  catch (const geodesic::Error& error)
  {
    release();
    vtkErrorMacro(<< error.what());
  }
  catch (const std::bad_alloc&)
  {
    release();
    this->Internals->ReleaseSurface();
    reserve.reset();
    vtkErrorMacro(
      "There is not enough memory for this surface. Decimate it, cut it into parts, set "
      "MaximumDistance, switch RefineMesh off or set Accuracy to Approximate.");
  }
  return 0;
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SourceType: " << this->SourceType << "\n";
  os << indent << "Accuracy: " << (this->Accuracy == EXACT ? "Exact" : "Approximate") << "\n";
  os << indent << "RelativeError: " << this->RelativeError << "\n";
  os << indent << "RefineMesh: " << (this->RefineMesh ? "On" : "Off") << "\n";
  os << indent << "RefinementTolerance: " << this->RefinementTolerance << "\n";
  os << indent << "ToleranceIsAbsolute: " << (this->ToleranceIsAbsolute ? "On" : "Off") << "\n";
  os << indent << "AbsoluteRefinementTolerance: " << this->AbsoluteRefinementTolerance << "\n";
  os << indent << "MaximumNumberOfCells: " << this->MaximumNumberOfCells << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
  os << indent << "MergeCoincidentPoints: " << (this->MergeCoincidentPoints ? "On" : "Off") << "\n";
  os << indent
     << "DistanceArrayName: " << (this->DistanceArrayName ? this->DistanceArrayName : "(none)")
     << "\n";
  os << indent << "WindowsPropagatedPerEdge: " << this->WindowsPropagatedPerEdge << "\n";
  os << indent << "SourceSnapDistance: " << this->SourceSnapDistance << "\n";
  os << indent << "RelativeErrorBound: " << this->RelativeErrorBound << "\n";
  os << indent << "InterpolationErrorBound: " << this->InterpolationErrorBound << "\n";
}
