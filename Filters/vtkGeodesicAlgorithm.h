// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicAlgorithm
 * @brief   what filters that measure geodesic distance on a surface have in common
 *
 * vtkGeodesicAlgorithm is the superclass of filters that take a surface on input port 0 and,
 * optionally, a source on input port 1, from which distances on the surface are measured. It reads
 * both, keeps the structure of the surface from one execution to the next, and turns what goes
 * wrong into VTK's errors with empty outputs. See vtkGeodesicDistanceField for what inputs may be.
 *
 * Each thing that goes wrong gives one error, and all outputs are empty; of a composite surface
 * they have the blocks. The pipeline goes on: filters and views downstream take the empty outputs,
 * and the next execution without an error shows everywhere. Scripts find the error in
 * GetErrorCode() and GetErrorMessage().
 *
 * A warning, such as that the source or a target is farther than a hundredth of the surface's size
 * from it, is given when the execution before had no reason for it or something else has been
 * connected to the port that it is about: not at every time step.
 *
 * @sa
 * vtkGeodesicDistanceField
 */

#ifndef vtkGeodesicAlgorithm_h
#define vtkGeodesicAlgorithm_h

#include "vtkFiltersGeodesicModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkMultiProcessController;

namespace geodesic
{
class FilterExecution;
}

class VTKFILTERSGEODESIC_EXPORT vtkGeodesicAlgorithm : public vtkPolyDataAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for type information and printing.
   */
  vtkTypeMacro(vtkGeodesicAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * The source on port 1: curves and points, a vtkPolyData, vtkUnstructuredGrid or other
   * vtkPointSet, or a composite data set of these. Not needed when the boundary is the source.
   */
  void SetSourceConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetSourceData(vtkDataObject* source) { this->SetInputDataInternal(1, source); }
  ///@}

  /**
   * What distances are measured from.
   */
  enum SourceTypes
  {
    SOURCE_CURVE = 0,
    SURFACE_BOUNDARY = 1,
    CURVE_AND_BOUNDARY = 2
  };

  ///@{
  /**
   * Measure distances from the curves and points on port 1 (the default), from the boundary of the
   * surface, or from both.
   */
  vtkSetClampMacro(SourceType, int, SOURCE_CURVE, CURVE_AND_BOUNDARY);
  vtkGetMacro(SourceType, int);
  void SetSourceTypeToSourceCurve() { this->SetSourceType(SOURCE_CURVE); }
  void SetSourceTypeToSurfaceBoundary() { this->SetSourceType(SURFACE_BOUNDARY); }
  void SetSourceTypeToCurveAndBoundary() { this->SetSourceType(CURVE_AND_BOUNDARY); }
  ///@}

  ///@{
  /**
   * Whether cells of the source that are lines of two points, as filters that cut or find edges
   * make them, are joined to curves. On by default. A curve is a maximal chain of such lines
   * through places where exactly two of them meet: their ends have equal coordinates, also in
   * different blocks or on different MPI ranks. It runs as most of its lines do (if as many run the
   * other way, as the lowest one), and begins with its lowest line where it is a loop that nothing
   * else meets. Its id is the lowest cell id among its lines; other ids of theirs do not occur in
   * the outputs. A line that is given twice counts once, one without length only where no other
   * line ends. Polylines of more points stay as they are.
   */
  vtkSetMacro(JoinLines, bool);
  vtkGetMacro(JoinLines, bool);
  vtkBooleanMacro(JoinLines, bool);
  ///@}

  ///@{
  /**
   * Name of an array of the source that names its parts: cells (points, in a set of points) with
   * equal values are one source, whose id is the value, in `SourceId`, in the columns of matrices
   * and in paths. Empty (null), the default, and "None" stand for no such array: ids are then
   * numbers of cells (of points). It is an array of the points of a set of points, and of the cells
   * of any other data set, of integers from 0 to 2^53 - 1, with one component; every block of a
   * composite source must have it. Lines of different values are not joined (JoinLines). Loops of
   * the boundary follow the largest value.
   */
  vtkSetStringMacro(SourceIdArrayName);
  vtkGetStringMacro(SourceIdArrayName);
  ///@}

  ///@{
  /**
   * Whether points at one place are one point, so that faces around it are connected. On by
   * default: formats without shared points (STL) or with seams (OBJ) need it. These are points with
   * equal coordinates and, on the boundary of the surface or of its blocks and pieces, points that
   * differ by a few roundings of the precision in which they are stored (single precision, too, if
   * all coordinates in double precision have values of single precision): surfaces that were stored
   * triangle by triangle have such cracks. The output keeps the points of the input in either case.
   * A warning counts what still looks like a crack.
   *
   * Where points at one place are kept apart, a point of a source or of targets stands for the
   * first that fits, unless it says which one it is: by the point array `vtkOriginalPointIds`, as
   * Extract Selection makes it, if it lies at that point of the surface. Numbers of points that are
   * elsewhere or do not exist are ignored, as are all numbers where the surface has several blocks
   * or is distributed over ranks.
   */
  vtkSetMacro(MergeCoincidentPoints, bool);
  vtkGetMacro(MergeCoincidentPoints, bool);
  vtkBooleanMacro(MergeCoincidentPoints, bool);
  ///@}

  ///@{
  /**
   * How far apart two points on the boundary may be that are one point, with
   * MergeCoincidentPoints, in the units of the surface: closes wider cracks. 0, the default: only
   * roundings. Points farther apart than half of the shortest edge at either of them stay apart, so
   * that no edge collapses.
   */
  vtkSetMacro(MergeTolerance, double);
  vtkGetMacro(MergeTolerance, double);
  ///@}

  ///@{
  /**
   * Name of a cell array of the surface that says where its barriers are: no path passes through
   * faces where it is not 0. Empty (null), the default, and "None" stand for no barriers, also
   * where the surface has active cell scalars. The array is numeric, has one component, and a value
   * for each cell of the surface or, where vertices and lines are among these, for each face.
   * Blocks of a composite surface without it have no barriers, nor have pieces on MPI ranks; an
   * array that none has, or that is not numeric, has several components or NaN, or another number
   * of values, is an error.
   *
   * Distances are those on the surface without its barriers, as if they were holes: paths may run
   * along a barrier's rim and bend around its corners, points that belong to barriers only are not
   * reached, and a point that belongs to another face, too, is reached over that face. Outputs that
   * show the surface have the barriers. Their rims are not boundary of the surface. Of
   * SURFACE_BOUNDARY the parts that belong to barriers only are left out, as no path leaves them; a
   * curve on port 1 with a point in a barrier (not on its rim) is an error that names it. Points of
   * a curve on both sides of a barrier are joined by the shortest path around it.
   */
  vtkSetStringMacro(BarrierArrayName);
  vtkGetStringMacro(BarrierArrayName);
  ///@}

  ///@{
  /**
   * The processes among which the surface may be distributed. By default these are those of the
   * global controller. With more than one process executing is collective: all of them execute, and
   * every port is asked for this rank's piece. With null this process works alone: a filter that is
   * executed on one rank only, or on a surface of its own on each, needs that.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  /**
   * What went wrong in the last execution, and what to do; empty if nothing did, and after an
   * abort. With an error GetErrorCode() is vtkErrorCode::UserError, else vtkErrorCode::NoError.
   * Both are set before the error event, and also where vtkObject::GlobalWarningDisplayOff()
   * switches such events off.
   */
  std::string GetErrorMessage() const { return this->ErrorMessage; }

  /**
   * Answers the requests of the pipeline: makes the outputs, asks for the pieces of the inputs,
   * and executes.
   */
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

protected:
  vtkGeodesicAlgorithm();
  ~vtkGeodesicAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  /// Makes output 0 an object of the kind of the surface where it may be any (see
  /// FillOutputPortInformation()).
  virtual int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector);
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  /// In one process asks for the whole of every input, whatever piece is asked of this, in several
  /// for the rank's piece.
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  /// Calls what a subclass has overridden below, and hands its exceptions to vtkErrorMacro.
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /// Says what is wrong with a property and what to do; empty where all are right.
  virtual std::string FindWrongProperty() const;
  /// What the user can do where memory has run out, as a sentence.
  virtual std::string AdviceOnMemory() const
  {
    return "Decimate the surface or cut it into parts.";
  }
  /// Sets the getters' results of an execution to what they are before the first.
  virtual void ResetResults() {}
  /// Reads the inputs (geodesic::FilterExecution::readInputs()) and fills the outputs. May throw.
  virtual void Compute(
    geodesic::FilterExecution& execution, vtkInformationVector* outputVector) = 0;

private:
  vtkGeodesicAlgorithm(const vtkGeodesicAlgorithm&) = delete;
  void operator=(const vtkGeodesicAlgorithm&) = delete;

  /// Does the work and turns exceptions into errors.
  void ComputeOrExplain(vtkInformationVector** inputVector, vtkInformationVector* outputVector);
  /// Keeps the error of an execution for scripts; an empty message: there is none.
  void SetError(std::string message);

  int SourceType = SOURCE_CURVE;
  bool JoinLines = true;
  char* SourceIdArrayName = nullptr;
  bool MergeCoincidentPoints = true;
  double MergeTolerance = 0.0;
  char* BarrierArrayName = nullptr;
  std::string ErrorMessage;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
