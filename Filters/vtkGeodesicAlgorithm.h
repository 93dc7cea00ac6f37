// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicAlgorithm
 * @brief   what filters that measure geodesic distance on a surface have in common
 *
 * vtkGeodesicAlgorithm is the superclass of filters that take a surface on input port 0 and,
 * optionally, a source on input port 1, from which distances on the surface are measured. What
 * follows holds for all of these filters; the page Reference (Filters/Reference.md) has the
 * details, and lists errors and warnings.
 *
 * @par Surface (port 0):
 * A vtkPolyData of polygons or strips, which are triangulated, or a vtkUnstructuredGrid of
 * two-dimensional cells. Any triangulation will do: with boundary, several components, edges of
 * three and more faces, and inconsistent orientation.
 *
 * @par Source (port 1):
 * Each polyline is a curve, as are lines that meet (see SetJoinLines()); each point of a vertex
 * cell is a point source; faces are regions, whose distance is 0; in data without other cells than
 * vertices each point is a source of its own. Of a vtkUnstructuredGrid the vertices, lines and flat
 * faces are sources, of any other vtkPointSet the points. Points of the source are put onto the
 * closest points of the surface, and consecutive ones are joined by the shortest path.
 *
 * @par Composite inputs:
 * Each port takes such a data set, or a vtkMultiBlockDataSet, vtkPartitionedDataSet or
 * vtkPartitionedDataSetCollection of these. All blocks of a surface are one surface, all blocks of
 * a source one source, whose ids go on from block to block.
 *
 * @par Execution:
 * The structure of the surface is kept for the next execution, unless ReleaseDataFlag is set.
 * Inputs are never modified. The threads are those of vtkSMPTools; the result is the same, to the
 * last bit, for any number of them.
 *
 * @par Errors and warnings:
 * Each thing that goes wrong gives one error, and all outputs are empty; see GetErrorMessage().
 *
 * @par Pieces and ranks:
 * In one process piece 0 of the outputs has everything, and the others are empty. If the controller
 * (SetController()) has several processes, executing is collective, and a rank's output is that of
 * its own piece of the one surface.
 *
 * @sa
 * vtkGeodesicDistanceField vtkGeodesicContour vtkGeodesicPaths vtkGeodesicDistanceMatrix
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
struct ExecutionPlan;
class Exchange;
class FilterExecution;
struct Inputs;
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
   * The source on port 1. Not needed when the boundary is the source.
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
   * Whether cells of the source that are lines of two points are joined to curves, through points
   * at which exactly two of them meet, and faces with a common edge to regions. On by default. A
   * curve runs as most of its lines do; ids are the lowest cell id of the lines, or faces.
   */
  vtkSetMacro(JoinLines, bool);
  vtkGetMacro(JoinLines, bool);
  vtkBooleanMacro(JoinLines, bool);
  ///@}

  ///@{
  /**
   * Name of an array of the source that names its parts: cells (points, in a set of points) with
   * equal values are one source, whose id is the value. Empty (null), the default, and "None"
   * stand for no such array: ids are then numbers of cells (of points). Integers from 0 to 2^53 -
   * 1, one component, in every block; anything else is an error.
   */
  vtkSetStringMacro(SourceIdArrayName);
  vtkGetStringMacro(SourceIdArrayName);
  ///@}

  ///@{
  /**
   * Whether points at one place are one point, so that faces around it are connected: points with
   * equal coordinates and, on the boundary of the surface or of its blocks and pieces, points that
   * differ by a few roundings of the precision in which they are stored, or by MergeTolerance, in
   * the units of the surface (default: 0), and by at most half of the shortest edge at either of
   * them. On by default. The output keeps the points of the input in either case. A MergeTolerance
   * that is negative or NaN is an error.
   */
  vtkSetMacro(MergeCoincidentPoints, bool);
  vtkGetMacro(MergeCoincidentPoints, bool);
  vtkBooleanMacro(MergeCoincidentPoints, bool);
  vtkSetMacro(MergeTolerance, double);
  vtkGetMacro(MergeTolerance, double);
  ///@}

  ///@{
  /**
   * Name of a numeric cell array of the surface that is not 0 in its barriers, faces that no path
   * passes through. Empty (null), the default, and "None" stand for no barriers. The array has one
   * component and a value for each cell, or for each face; blocks and pieces without it have no
   * barriers. An array that none has, or with NaN in it, is an error, as is a curve with a point
   * inside a barrier.
   */
  vtkSetStringMacro(BarrierArrayName);
  vtkGetStringMacro(BarrierArrayName);
  ///@}

  ///@{
  /**
   * The processes among which the surface may be distributed, by default those of the global
   * controller. All of them execute together. With null this process works alone: a filter that is
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
  /// Reads the inputs and computes, and hands exceptions to vtkErrorMacro.
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
  /// What the filter needs of its inputs, and the stages of its work.
  virtual geodesic::ExecutionPlan Plan() const = 0;
  /// Fills the outputs. May throw.
  virtual void Compute(const geodesic::Inputs& inputs, geodesic::FilterExecution& execution,
    vtkInformationVector* outputVector) = 0;

  int SourceType = SOURCE_CURVE;

private:
  vtkGeodesicAlgorithm(const vtkGeodesicAlgorithm&) = delete;
  void operator=(const vtkGeodesicAlgorithm&) = delete;

  /// Reads the inputs, computes and warns. An exception becomes an error.
  void Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector);
  /// Empties the outputs and reports an error.
  ///
  /// \param message what went wrong; empty: the user has aborted the execution.
  /// \param isSurfaceKept whether the next execution may use what was read of the surface.
  /// \param exchange with the ranks that wait for this one; null: none do.
  void Fail(const std::string& message, bool isSurfaceKept, geodesic::Exchange* exchange,
    vtkInformationVector** inputVector, vtkInformationVector* outputVector);
  /// Keeps the error of an execution for scripts; an empty message: there is none.
  void SetError(std::string message);

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
