// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicDistanceMatrix
 * @brief   exact geodesic distances from each of several sources to each of several targets
 *
 * vtkGeodesicDistanceMatrix measures the length of the shortest path *on* a triangle mesh from each
 * of several sources, every one alone, to each of several targets, and puts these numbers into a
 * table. Distances are exact up to the rounding of double-precision numbers: those that
 * vtkGeodesicDistanceField gives for that source alone.
 *
 * @par Algorithm:
 * For each source a front goes out (see vtkGeodesicDistanceField), until all targets are settled.
 * Sources are solved side by side on the threads that vtkSMPTools is set to use, one thread a
 * source, each of which takes the memory of one solve. Where fronts from the targets are fewer, and
 * go less far by an estimate, they go out from there: 3 targets of 500 sources take 3 solves.
 *
 * @par Input:
 * Port 0 takes the surface, port 1 the sources: see vtkGeodesicAlgorithm. Each part of port 1 that
 * has an id of its own is a source, as is each loop of the boundary, if SourceType asks for it.
 * Port 2, optional, takes the targets.
 *
 * @par Output:
 * A vtkTable with one row a target, in their order, and the columns
 * - `TargetId` (vtkIdType): the target, by its point id on its port (with a composite data set ids
 *   go on from block to block), or by its value of TargetIdArrayName,
 * - `TargetName` (vtkStringArray): what the target is called, with TargetNameArrayName only,
 * - `TargetPosition` (vtkDoubleArray of 3 components), with GenerateTargetPositions only,
 * - `Source0`, `Source1`, ... (double): the distance from each source, by its id, or name
 *   (SourceNameArrayName). Infinite where no path leads from the source to the target, as to one in
 *   a barrier, beyond MaximumDistance, and for a cell without points.
 *
 * @par Execution:
 * Where fronts go out from the sources, the numbers are those of the field of each source, at
 * vertices to the last bit, whatever other sources and targets there are; where they go out from
 * the targets, those of the field of each target. The two differ by roundings. On several ranks
 * rank 0 has the rows; the whole surface must be on one rank, or on each: one that is distributed
 * is an error.
 *
 * @sa
 * vtkGeodesicDistanceField vtkGeodesicPaths
 */

#ifndef vtkGeodesicDistanceMatrix_h
#define vtkGeodesicDistanceMatrix_h

#include "vtkFiltersGeodesicModule.h" // for the export macro
#include "vtkGeodesicAlgorithm.h"

class vtkTable;

class VTKFILTERSGEODESIC_EXPORT vtkGeodesicDistanceMatrix : public vtkGeodesicAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for construction, type information and printing.
   */
  static vtkGeodesicDistanceMatrix* New();
  vtkTypeMacro(vtkGeodesicDistanceMatrix, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * The targets on port 2: every point of a vtkPointSet, or of all blocks of a composite data set,
   * put onto the closest point of the surface, or sets of points, lines and regions
   * (TargetIdArrayName). Without this input the targets are those of port 1.
   */
  void SetTargetsConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(2, output); }
  void SetTargetsData(vtkDataObject* targets) { this->SetInputDataInternal(2, targets); }
  ///@}

  ///@{
  /**
   * Distances are measured up to this one, in the units of the surface; larger ones are infinite.
   * 0, the default, is no limit. A negative value or NaN is an error.
   */
  vtkSetMacro(MaximumDistance, double);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /**
   * Name of an array of strings or integers that says what the source's parts are called: their
   * columns have these names. It belongs to the points of a set of points, and to the cells of any
   * other data set. Parts that are one source go by the first one's name. Of two points 3 and 5
   * called "Cz" the columns are "Cz" and "Cz_5"; without a name, as loops of the boundary are, a
   * column is "Source" and the id. Empty (null), the default, and "None" stand for no such array.
   */
  vtkSetStringMacro(SourceNameArrayName);
  vtkGetStringMacro(SourceNameArrayName);
  ///@}

  ///@{
  /**
   * Name of an array of whole numbers of the targets (where port 2 is not connected, of the source)
   * that makes sets of them: all that has one value is one target, with one row, whose `TargetId`
   * is the value; rows ascend. Negative values stand for no target. It is an array of the points of
   * a set of points, and of the cells of any other data set, or else of its points. The distance of
   * a target is the least over its points, its lines, and its faces, which are a region (as those
   * of a source are). Empty (null), the default, and "None" stand for no such array: each point is
   * a target. If port 2 is not connected and SourceIdArrayName is the same array, the table is that
   * of all sets from one another.
   */
  vtkSetStringMacro(TargetIdArrayName);
  vtkGetStringMacro(TargetIdArrayName);
  ///@}

  ///@{
  /**
   * Name of an array of strings or integers at the points of the targets (where port 2 is not
   * connected, of the source) that says what they are called: the column `TargetName`. With
   * TargetIdArrayName it is an array of what that one is of, and a target goes by the first name in
   * it. Empty (null), the default, and "None" stand for no such array.
   */
  vtkSetStringMacro(TargetNameArrayName);
  vtkGetStringMacro(TargetNameArrayName);
  ///@}

  ///@{
  /**
   * Whether the table has the column `TargetPosition` (3 doubles): where each target is in its own
   * data set; with TargetIdArrayName a point of it on the surface. Off by default.
   */
  vtkSetMacro(GenerateTargetPositions, bool);
  vtkGetMacro(GenerateTargetPositions, bool);
  vtkBooleanMacro(GenerateTargetPositions, bool);
  ///@}

  /**
   * The output: a table, where the superclass has a vtkPolyData.
   */
  vtkTable* GetOutput();

protected:
  vtkGeodesicDistanceMatrix() { this->SetNumberOfInputPorts(3); }
  ~vtkGeodesicDistanceMatrix() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  std::string FindWrongProperty() const override;
  std::string AdviceOnMemory() const override;
  geodesic::ExecutionPlan Plan() const override;
  void Compute(const geodesic::Inputs& inputs, geodesic::FilterExecution& execution,
    vtkInformationVector* outputVector) override;

private:
  vtkGeodesicDistanceMatrix(const vtkGeodesicDistanceMatrix&) = delete;
  void operator=(const vtkGeodesicDistanceMatrix&) = delete;

  double MaximumDistance = 0.0;
  bool GenerateTargetPositions = false;
  char* SourceNameArrayName = nullptr;
  char* TargetNameArrayName = nullptr;
  char* TargetIdArrayName = nullptr;
};

#endif
