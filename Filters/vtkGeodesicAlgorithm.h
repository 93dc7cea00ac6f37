// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicAlgorithm
 * @brief   what filters that measure geodesic distance on a surface have in common
 *
 * vtkGeodesicAlgorithm is the superclass of filters that take a surface on input port 0 and,
 * optionally, a source on input port 1, from which distances on the surface are measured. It reads
 * both, keeps the structure of the surface from one execution to the next, and turns what goes
 * wrong into VTK's errors with empty outputs. What follows holds for all of these filters.
 *
 * @par Surface (port 0):
 * A vtkPolyData of polygons or strips, which are triangulated. It may have boundary and holes,
 * several components, edges of three and more faces, vertices where several sheets meet, and
 * inconsistent orientation. Lines and vertices are dropped with a warning, and so are faces with
 * two equal corners. A vtkUnstructuredGrid of two-dimensional cells is a surface, too, as Clip,
 * Threshold, Append Datasets and Redistribute DataSet make it: outputs that show the surface are a
 * vtkPolyData then, with the points and the data of the grid, and cells are numbered as in the
 * grid. Quadratic and other curved cells become triangles through all their points; a
 * three-dimensional cell is an error that names it. Coordinates may have any size between 1e-290
 * and 1e290.
 *
 * @par Source (port 1):
 * Each polyline is a curve, as are lines that meet (see SetJoinLines()); each point of a vertex
 * cell is a point source; faces are regions. Data with vertex cells only, or without cells, are a
 * set of points, each of which (of those that the vertex cells have) is a source of its own. A
 * vtkUnstructuredGrid gives its vertices, lines and flat faces, with a warning if it has other
 * cells; any other vtkPointSet gives its points.
 * @par
 * A region consists of the faces with one id (SetSourceIdArrayName()); without ids, of faces that
 * meet in edges (SetJoinLines()). The edges that one of these faces uses are its outline, which is
 * a curve. The faces of the surface that the region covers, because they are its faces or were cut
 * from the same polygons, belong to the source as a whole: their distance is 0. Faces beside the
 * surface cover nothing: their outline alone is put onto the surface.
 * @par
 * A curve need not be made of mesh edges, nor lie on the surface exactly. Its points are put onto
 * the closest points of the surface, and onto a vertex or an edge when within the precision of the
 * coordinates. Consecutive points in one face are joined straight, others by the shortest path
 * between them on the surface. So a section by vtkCutter, the lines of vtkFeatureEdges and a
 * polyline drawn on the surface can all be used as they come. Where the surface touches or overlaps
 * itself, several faces are equally close to a point: the filter takes those that consecutive
 * points have in common, so that a section of the surface comes out as it went in. If a curve
 * passes between sheets that are not connected, it is cut in two there.
 *
 * @par Composite inputs:
 * Each port takes such a data set, or a vtkMultiBlockDataSet, vtkPartitionedDataSet or
 * vtkPartitionedDataSetCollection of these, nested or with null and empty blocks. The blocks of a
 * surface are one surface with one distance field: see SetMergeCoincidentPoints() for where they
 * are joined. All blocks of a source are one source; ids of cells and points go on from block to
 * block. A block of another type is an error that names it; the Extract Surface filter makes it
 * usable.
 * @par
 * Cells that a ghost array marks as duplicates are not surface: they get the values, and the
 * refinement, of what they duplicate. A duplicate without an original counts once. Hidden cells are
 * holes.
 *
 * @par Execution:
 * The structure of the surface is kept, so that executing again with another source costs only the
 * propagation. It is built anew when coordinates, cells, barriers, ghost flags or global ids have
 * changed (these are compared each time, also where nothing says that they were modified), not when
 * other arrays have, and is released after each execution where ReleaseDataFlag is set. Inputs are
 * never modified. Progress is reported, and abort is obeyed. The work is done on the threads that
 * vtkSMPTools is set to use; the result is the same, to the last bit, for any number of threads.
 *
 * @par Errors and warnings:
 * Each thing that goes wrong gives one error, and all outputs are empty; of a composite surface
 * they have the blocks. Cells that cannot be read, because offsets are missing, decrease or lead
 * past the end of the point ids, are an error that names the first one. The pipeline goes on:
 * filters and views downstream take the empty outputs, and the next execution without an error
 * shows everywhere. Scripts find the error in GetErrorCode() and GetErrorMessage().
 * @par
 * A warning (say, that the source is farther from the surface than a hundredth of the surface's
 * size) is not repeated at every time step. It is given if the execution before had no reason for
 * it, or if something else has been connected to the port that the warning is about.
 *
 * @par Pieces:
 * A piece of a surface has other distances than the whole. Whatever piece is asked for, in one
 * process the filter asks for the whole of its inputs; piece 0 of its outputs has everything, and
 * the others are empty, so that pieces that are written and read back hold each cell once.
 *
 * @par Ranks:
 * If the controller (SetController()) has several processes, executing is collective: every rank
 * executes, also one without cells. Each port is asked for this rank's piece, whatever piece is
 * asked for downstream, and a rank's output is that of its own piece of the one surface. Ranks
 * exchange what passes their seams: no rank needs memory for the whole surface, and distances are
 * those of one process, to the last bits.
 * - Points of different pieces are joined as points of different blocks are
 *   (SetMergeCoincidentPoints()), and also if all pieces have global ids and theirs are equal.
 * - Ghost cells are treated as those of blocks, over all ranks. Boundary, counts and the numbers in
 *   field data are those of the whole, the same on every rank.
 * - Barriers count on all ranks, whichever has them.
 * - Sources and targets of all ranks are gathered; ids follow the ranks, then the blocks and the
 *   cells of each. What is the same on all ranks counts once. What shows the source is on rank 0.
 * - If one rank has the whole surface and the others have nothing, it works as a process alone; if
 *   all have the same surface, each does.
 * - An error on one rank is given by all, with one message; an abort on one aborts all.
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
   * line ends. Polylines of more points stay as they are. Faces with a common edge are joined to
   * one region, whose id is that of its first face.
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
  /// \param waiting the ranks that wait for this one; null: none do.
  void Fail(const std::string& message, bool isSurfaceKept, geodesic::Exchange* waiting,
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
