// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicPaths
 * @brief   exact shortest paths on a surface from points to the nearest point of a source
 *
 * vtkGeodesicPaths finds for each of its targets the shortest path *on* a triangle mesh to the
 * nearest point of a source, as for vtkGeodesicDistanceField. Paths are exact up to the rounding of
 * double-precision numbers: they go straight through faces and bend only at vertices of negative
 * curvature and at reflex corners of the boundary.
 *
 * @par Algorithm:
 * One front goes from the source (see vtkGeodesicDistanceField), until all targets are settled. A
 * path is then followed backwards, straight through face after face to the pseudo-source or the
 * source that its rays left.
 *
 * @par Input:
 * Port 0 takes the surface, port 1, optional, the source: see vtkGeodesicAlgorithm, also for
 * composite data, threads, pieces, ranks and errors. Port 2 takes the targets: every point of a
 * vtkPointSet, or of all blocks of a composite data set. A target is put onto the closest point of
 * the surface, with a warning where that is farther than a hundredth of the surface's size.
 *
 * @par Output:
 * A vtkPolyData with one polyline for each target that is reached, in the order of the targets,
 * from the target to the source. It has a point at every mesh edge that it crosses, and no others
 * but its ends and the vertices that it passes; each piece lies in one face. A target on the source
 * gives two equal points. Lines do not share points. There are
 * - cell data array `TargetId` (vtkIdType): the target, by its point id on port 2; with a composite
 *   data set ids go on from block to block,
 * - cell data array `SourceId` (vtkIdType): the part of the source that the path ends on, as
 *   vtkGeodesicDistanceField::SetGenerateSourceIds() counts them; one of several that hold the end,
 * - cell data array `GeodesicDistance`: the length of the path,
 * - cell data array `TargetSnapDistance`: how far the target was from the surface,
 * - point data array `GeodesicDistance`: what is left of the path from the point on; 0 at its end,
 * - if they are asked for, the arrays of SetGenerateSourceArcLength(), SetGenerateSourceAngle() and
 *   SetGenerateFaceIds().
 * @par
 * Targets that no path joins to the source, such as those in a barrier (BarrierArrayName), have no
 * line; one warning counts them.
 *
 * @par Execution:
 * Each path is the same whatever other targets there are. On several ranks a path is put out by the
 * rank where its target was, by rank 0 where all had the same targets.
 *
 * @sa
 * vtkGeodesicDistanceField vtkGeodesicDistanceMatrix vtkDijkstraGraphGeodesicPath
 */

#ifndef vtkGeodesicPaths_h
#define vtkGeodesicPaths_h

#include "vtkFiltersGeodesicModule.h" // for the export macro
#include "vtkGeodesicAlgorithm.h"

class VTKFILTERSGEODESIC_EXPORT vtkGeodesicPaths : public vtkGeodesicAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for construction, type information and printing.
   */
  static vtkGeodesicPaths* New();
  vtkTypeMacro(vtkGeodesicPaths, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * The targets on port 2. Without targets there is an error.
   */
  void SetTargetsConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(2, output); }
  void SetTargetsData(vtkDataObject* targets) { this->SetInputDataInternal(2, targets); }
  ///@}

  ///@{
  /**
   * Whether the output has the cell array SourceArcLength: where along its part of the source each
   * path ends, as vtkGeodesicDistanceField::SetGenerateSourceArcLength() defines it. Off by
   * default.
   */
  vtkSetMacro(GenerateSourceArcLength, bool);
  vtkGetMacro(GenerateSourceArcLength, bool);
  vtkBooleanMacro(GenerateSourceArcLength, bool);
  ///@}

  ///@{
  /**
   * Whether the output has the cell array SourceAngle: the direction, in radians, in which each
   * path leaves the source, seen from there, and the field data array SourceFrame, both as
   * vtkGeodesicDistanceField::SetGenerateSourceAngle() defines them; 0 for a target on the source.
   * Off by default.
   */
  vtkSetMacro(GenerateSourceAngle, bool);
  vtkGetMacro(GenerateSourceAngle, bool);
  vtkBooleanMacro(GenerateSourceAngle, bool);
  ///@}

  ///@{
  /**
   * Whether the output has the point array FaceId: the cell of the surface's input (any of those at
   * an edge) in which each path goes on from the point; at its last point, the cell that it has
   * come through. Cells of all blocks in their flattened order, and of the pieces of all ranks,
   * ghost cells included, are numbered as one data set. Off by default.
   */
  vtkSetMacro(GenerateFaceIds, bool);
  vtkGetMacro(GenerateFaceIds, bool);
  vtkBooleanMacro(GenerateFaceIds, bool);
  ///@}

protected:
  vtkGeodesicPaths() { this->SetNumberOfInputPorts(3); }
  ~vtkGeodesicPaths() override = default;

  geodesic::ExecutionPlan Plan() const override;
  void Compute(const geodesic::Inputs& inputs, geodesic::FilterExecution& execution,
    vtkInformationVector* outputVector) override;

private:
  vtkGeodesicPaths(const vtkGeodesicPaths&) = delete;
  void operator=(const vtkGeodesicPaths&) = delete;

  bool GenerateSourceArcLength = false;
  bool GenerateSourceAngle = false;
  bool GenerateFaceIds = false;
};

#endif
