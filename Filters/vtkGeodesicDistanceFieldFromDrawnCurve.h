// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicDistanceFieldFromDrawnCurve
 * @brief   exact geodesic distance on a triangle mesh from one polyline, given by its points
 *
 * vtkGeodesicDistanceFieldFromDrawnCurve is a vtkGeodesicDistanceField that needs no second input:
 * its source is one polyline, open or closed, whose points are properties of the filter. So a
 * widget with which a curve is drawn in a view can be tied to the filter directly, as ParaView does
 * it. The points need not lie on the surface: each is put onto the closest point of the surface,
 * with a warning if that is over half of the surface's diagonal away, and consecutive ones are
 * joined by the shortest path between them on the surface, unless PointsOnly is on. One point is a
 * point source; without points there is an error, unless the boundary is the source.
 *
 * The polyline is on input port 1: do not connect anything else there.
 *
 * @sa
 * vtkGeodesicDistanceField vtkPolyLineSource
 */

#ifndef vtkGeodesicDistanceFieldFromDrawnCurve_h
#define vtkGeodesicDistanceFieldFromDrawnCurve_h

#include "vtkFiltersGeodesicModule.h" // for the export macro
#include "vtkGeodesicDistanceField.h"
#include "vtkNew.h" // for vtkNew

class vtkPolyData;

class VTKFILTERSGEODESIC_EXPORT vtkGeodesicDistanceFieldFromDrawnCurve
  : public vtkGeodesicDistanceField
{
public:
  ///@{
  /**
   * Standard methods for construction, type information and printing.
   */
  static vtkGeodesicDistanceFieldFromDrawnCurve* New();
  vtkTypeMacro(vtkGeodesicDistanceFieldFromDrawnCurve, vtkGeodesicDistanceField);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * The number of points of the curve, 0 by default. Points that are there already stay; new ones
   * are at the origin. A negative number is taken as 0.
   */
  void SetNumberOfCurvePoints(vtkIdType number);
  vtkIdType GetNumberOfCurvePoints();
  ///@}

  ///@{
  /**
   * A point of the curve, in the order of the curve, by its number from 0 on. Setting one that is
   * not there makes the curve as long as that; asking for one is an error, and gives the origin.
   */
  void SetCurvePoint(vtkIdType index, double x, double y, double z);
  void GetCurvePoint(vtkIdType index, double point[3]) VTK_SIZEHINT(3);
  ///@}

  ///@{
  /**
   * Whether the last point is joined to the first one. Off by default. It takes three points to
   * close a curve; with fewer this is not looked at.
   */
  void SetCurveClosed(bool closed);
  vtkGetMacro(CurveClosed, bool);
  vtkBooleanMacro(CurveClosed, bool);
  ///@}

  ///@{
  /**
   * Whether the points are not joined: each is a point source, whose number is its `SourceId`. Off
   * by default.
   */
  void SetPointsOnly(bool pointsOnly);
  vtkGetMacro(PointsOnly, bool);
  vtkBooleanMacro(PointsOnly, bool);
  ///@}

  /**
   * Connects the curve anew: an executive that is exchanged, as ParaView does it, takes what was
   * connected with it.
   */
  void SetExecutive(vtkExecutive* executive) override;

protected:
  vtkGeodesicDistanceFieldFromDrawnCurve();
  ~vtkGeodesicDistanceFieldFromDrawnCurve() override;

  std::string FindWrongProperty() const override;
  geodesic::ExecutionPlan Plan() const override;

private:
  vtkGeodesicDistanceFieldFromDrawnCurve(const vtkGeodesicDistanceFieldFromDrawnCurve&) = delete;
  void operator=(const vtkGeodesicDistanceFieldFromDrawnCurve&) = delete;

  /// Makes one polyline of all the points, or none.
  void JoinCurvePoints();

  vtkNew<vtkPolyData> Curve;
  bool CurveClosed = false;
  bool PointsOnly = false;
};

#endif
