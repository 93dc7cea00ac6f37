// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicFarthestPoints
 * @brief   points spread evenly over a surface by geodesic distance
 *
 * vtkGeodesicFarthestPoints chooses points of a surface one after the other: each is the one that
 * is farthest, on the surface, from the source and from all points before. So after each point
 * every point of the surface is within the next one's distance of the source and of those chosen.
 *
 * @par Algorithm:
 * A front goes out from the source (see vtkGeodesicDistanceField), then one from each point, as
 * soon as that is chosen. It goes no farther than its point is the nearest: 1,000 points on 70,000
 * faces take about as long as five fields.
 *
 * @par Input:
 * Port 0 takes the surface, port 1 the source: see vtkGeodesicAlgorithm. All of the source counts
 * from the beginning.
 *
 * @par Output:
 * A vtkTable with a row for each point, in their order, and the columns
 * - `PointId` (vtkIdType): the point of the surface; with a composite data set ids go on from block
 *   to block. Of points at one place it is the first; of points that are equally far, too.
 * - `GeodesicDistance` (double): its distance to the source and to the points before.
 * @par
 * It has fewer rows than NumberOfPoints where there are no more points at different places to which
 * a path leads from the source. On several ranks the rank that has the whole surface has the rows.
 *
 * @sa
 * vtkGeodesicDistanceField vtkGeodesicDistanceMatrix
 */

#ifndef vtkGeodesicFarthestPoints_h
#define vtkGeodesicFarthestPoints_h

#include "vtkFiltersGeodesicModule.h" // for the export macro
#include "vtkGeodesicAlgorithm.h"

class vtkTable;

class VTKFILTERSGEODESIC_EXPORT vtkGeodesicFarthestPoints : public vtkGeodesicAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for construction, type information and printing.
   */
  static vtkGeodesicFarthestPoints* New();
  vtkTypeMacro(vtkGeodesicFarthestPoints, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * How many points to choose. 100 by default.
   */
  vtkSetClampMacro(NumberOfPoints, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(NumberOfPoints, vtkIdType);
  ///@}

  /**
   * The output: a table, where the superclass has a vtkPolyData.
   */
  vtkTable* GetOutput();

protected:
  vtkGeodesicFarthestPoints() = default;
  ~vtkGeodesicFarthestPoints() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  geodesic::ExecutionPlan Plan() const override;
  void Compute(const geodesic::Inputs& inputs, geodesic::FilterExecution& execution,
    vtkInformationVector* outputVector) override;

private:
  vtkGeodesicFarthestPoints(const vtkGeodesicFarthestPoints&) = delete;
  void operator=(const vtkGeodesicFarthestPoints&) = delete;

  vtkIdType NumberOfPoints = 100;
};

#endif
