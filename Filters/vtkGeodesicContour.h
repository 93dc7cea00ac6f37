// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicContour
 * @brief   exact lines of equal geodesic distance: offset curves on a triangle mesh
 *
 * vtkGeodesicContour draws on a surface the lines whose points have a given geodesic distance to
 * the nearest point of a source: points, open and closed polylines, the surface's boundary, or any
 * mix of them. They are the offset curves of the source, such as tool paths at equal steps.
 *
 * @par Algorithm:
 * In a face the distance is the least of a few functions, each of which is the distance from an
 * unfolded point or from a line (see vtkGeodesicDistanceField). So the lines are made of arcs of
 * circles and straight pieces, drawn face by face from the windows, not from an interpolant: all
 * points are exactly at the value, up to rounding.
 *
 * @par Input:
 * Port 0 takes the surface, port 1, optional, the source: see vtkGeodesicAlgorithm, also for
 * composite data, threads, pieces, ranks and errors.
 *
 * @par Output:
 * A vtkPolyData, also of composite inputs, with a polyline for each line; a closed one has its
 * first point again at the end. The distance grows to the left of a line, seen with the normals of
 * the faces towards the viewer; if the surface is not consistently oriented, directions say
 * nothing, and a warning tells so. Lines end at the boundary and, in shared points, at edges of
 * three and more faces. They are in the ascending order of their values, behind those of 0: the
 * source as it lies on the surface, curves in their own direction and a vertex for each point.
 * There are
 * - cell data array and point data array `GeodesicDistance`: the value,
 * - point data array `LineId`: the number of the first cell that has the point. Points stand in the
 *   order of their lines, so that a table of the points can be cut into lines again.
 *
 * @par Execution:
 * The propagation stops beyond the largest value. If there are several ranks, each has the lines in
 * its piece of the surface. Lines end at seams, where the lines of another rank go on from points
 * with the same coordinates. The source itself, at a value of 0, is on rank 0.
 *
 * @sa
 * vtkGeodesicDistanceField vtkContourFilter vtkContourValues
 */

#ifndef vtkGeodesicContour_h
#define vtkGeodesicContour_h

#include "vtkContourValues.h"         // for the inline functions
#include "vtkFiltersGeodesicModule.h" // for the export macro
#include "vtkGeodesicAlgorithm.h"
#include "vtkNew.h" // for vtkNew

#include <string> // for std::string

class VTKFILTERSGEODESIC_EXPORT vtkGeodesicContour : public vtkGeodesicAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for construction, type information and printing.
   */
  static vtkGeodesicContour* New();
  vtkTypeMacro(vtkGeodesicContour, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * The distances to draw lines at, in the units of the surface, set as the values of
   * vtkContourFilter; equal ones count once. No value, the default, is an error, as is one that is
   * infinite, NaN or, unless SignedDistances is on, negative.
   */
  void SetValue(int i, double value) { this->ContourValues->SetValue(i, value); }
  double GetValue(int i) { return this->ContourValues->GetValue(i); }
  double* GetValues() VTK_SIZEHINT(GetNumberOfContours())
  {
    return this->ContourValues->GetValues();
  }
  void GetValues(double* values) { this->ContourValues->GetValues(values); }
  void SetNumberOfContours(int number) { this->ContourValues->SetNumberOfContours(number); }
  vtkIdType GetNumberOfContours() { return this->ContourValues->GetNumberOfContours(); }
  void GenerateValues(int number, double range[2])
  {
    this->ContourValues->GenerateValues(number, range);
  }
  void GenerateValues(int number, double first, double last)
  {
    this->ContourValues->GenerateValues(number, first, last);
  }
  ///@}

  ///@{
  /**
   * The largest distance of a chord from the arc that it stands for: ChordTolerance, as a fraction
   * of the diagonal of the bounding box of the points that faces use (default: 0.0001), or, where
   * ToleranceIsAbsolute is on (off by default), AbsoluteChordTolerance, in the units of the surface
   * (default: 1). Anything but a positive number is an error; below 1e-12 of an arc's radius counts
   * as that.
   */
  vtkSetMacro(ChordTolerance, double);
  vtkGetMacro(ChordTolerance, double);
  vtkSetMacro(ToleranceIsAbsolute, bool);
  vtkGetMacro(ToleranceIsAbsolute, bool);
  vtkBooleanMacro(ToleranceIsAbsolute, bool);
  vtkSetMacro(AbsoluteChordTolerance, double);
  vtkGetMacro(AbsoluteChordTolerance, double);
  ///@}

  ///@{
  /**
   * Whether values are those of vtkGeodesicDistanceField::SetGenerateSignedDistance(): a positive
   * one means points on the left of the curves only, a negative one those on their right. Off by
   * default. Lines end where the sign jumps, such as beyond open ends of a curve, and run so that
   * the signed distance grows to their left. An edge of three and more faces, or faces of opposite
   * orientation side by side, is an error.
   */
  vtkSetMacro(SignedDistances, bool);
  vtkGetMacro(SignedDistances, bool);
  vtkBooleanMacro(SignedDistances, bool);
  ///@}

  /**
   * Also newer when a value has changed.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkGeodesicContour() { this->ContourValues->SetNumberOfContours(0); }
  ~vtkGeodesicContour() override = default;

  std::string FindWrongProperty() const override;
  geodesic::ExecutionPlan Plan() const override;
  void Compute(const geodesic::Inputs& inputs, geodesic::FilterExecution& execution,
    vtkInformationVector* outputVector) override;

private:
  vtkGeodesicContour(const vtkGeodesicContour&) = delete;
  void operator=(const vtkGeodesicContour&) = delete;

  vtkNew<vtkContourValues> ContourValues;
  double ChordTolerance = 0.0001;
  bool ToleranceIsAbsolute = false;
  double AbsoluteChordTolerance = 1.0;
  bool SignedDistances = false;
};

#endif
