// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicDistanceField
 * @brief   exact geodesic distance from points, curves and boundaries on a triangle mesh
 *
 * vtkGeodesicDistanceField puts on every point of a surface the length of the shortest path *on*
 * the surface to the nearest point of a source: points, open or closed polylines (all points of
 * their segments count), the surface's boundary, or any mix of them.
 *
 * @par Algorithm:
 * The filter implements Bommes and Kobbelt (2007), who extend the window propagation of Mitchell,
 * Mount and Papadimitriou (1987) from points to polygonal curves. All shortest paths that cross one
 * piece of a mesh edge through the same sequence of faces form a *window*: unfolded into the plane
 * they come straight from one point (a circular window), or run in parallel from a straight segment
 * of the curve (a linear window). Windows start in the faces that hold the source. A front visits
 * the vertices in the order of their distance and pushes the windows that wait on the edges around
 * through the next faces; where two windows overlap, each keeps the part on which it is the
 * shorter. Shortest paths bend only at vertices of negative curvature and at reflex corners of the
 * boundary: there the front emits circular windows anew. The result is exact up to the rounding of
 * double-precision numbers, on any triangulation: accuracy does not depend on the shape or size of
 * the triangles. The tests that drop a window when a path through a vertex beats it come from Xin
 * and Wang (2009), the order of the front by vertices, which handles the windows around a vertex
 * together, from Qin et al. (2016).
 *
 * @par Accuracy:
 * In approximate mode (SetAccuracy()) neighboring windows are merged: distances are then at most
 * the exact ones, and smaller by no more than RelativeError. With RefineMesh triangles are split,
 * on their own planes, until VTK's linear interpolant is within a tolerance of the computed
 * distance everywhere. Both bounds are certified: interpolated values differ from the exact
 * distance d by at most GetRelativeErrorBound() * d + GetInterpolationErrorBound().
 *
 * @par Input:
 * Port 0 takes the surface, port 1, optional, the source: see vtkGeodesicAlgorithm, also for
 * composite data, threads, pieces, ranks and errors.
 *
 * @par Output:
 * Port 0 has the surface as triangles, with all points of the input in order, then those that
 * refinement has added; of a composite surface (GetOutputDataObject(0); GetOutput() is null then)
 * it has the structure and the names, and each block its own points and arrays:
 * - point data array `GeodesicDistance` (DistanceArrayName), in double precision, and those of
 *   SetGenerateSourceIds() and the next properties, if they are asked for,
 * - cell data array `OriginalCellIds`, if the mesh was refined: the cell of the input (of its
 *   block) that each triangle is a part of,
 * - field data arrays with the names of the getters below; with GenerateSourceAngle `SourceFrame`.
 * @par
 * Port 1 has the source as it lies on the surface, in double precision: polylines with a point at
 * every mesh edge that they cross, and a vertex for each point source, with the cell data array
 * `SourceId` and, with GenerateSourceArcLength, the point data array `SourceArcLength`.
 * @par
 * The page Reference (Filters/Reference.md) says what happens to the input's data and at borders of
 * blocks, how the arrays are measured exactly, where they jump, and what the bounds are bounds of.
 *
 * @par Thanks:
 * David Bommes and Leif Kobbelt, "Accurate Computation of Geodesic Distance Fields for Polygonal
 * Curves on Triangle Meshes", Proceedings of Vision, Modeling, and Visualization (VMV) 2007.
 * @par
 * Shi-Qing Xin and Guo-Jin Wang, "Improving Chen and Han's Algorithm on the Discrete Geodesic
 * Problem", ACM Transactions on Graphics 28 (4), 2009, doi:10.1145/1559755.1559761.
 * @par
 * Yipeng Qin, Xiaoguang Han, Hongchuan Yu, Yizhou Yu and Jianjun Zhang, "Fast and Exact Discrete
 * Geodesic Computation Based on Triangle-Oriented Wavefront Propagation", ACM Transactions on
 * Graphics 35 (4), 2016, doi:10.1145/2897824.2925930.
 *
 * @sa
 * vtkDijkstraGraphGeodesicPath vtkDistancePolyDataFilter vtkFeatureEdges vtkCutter
 */

#ifndef vtkGeodesicDistanceField_h
#define vtkGeodesicDistanceField_h

#include "vtkFiltersGeodesicModule.h" // for the export macro
#include "vtkGeodesicAlgorithm.h"

#include <limits> // for std::numeric_limits
#include <string> // for std::string

class VTKFILTERSGEODESIC_EXPORT vtkGeodesicDistanceField : public vtkGeodesicAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for construction, type information and printing.
   */
  static vtkGeodesicDistanceField* New();
  vtkTypeMacro(vtkGeodesicDistanceField, vtkGeodesicAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * Whether distances are exact.
   */
  enum AccuracyModes
  {
    EXACT = 0,
    APPROXIMATE = 1
  };

  ///@{
  /**
   * Compute the exact distance (the default), or a smaller one, which is faster: within
   * RelativeError of it (default: 0.001; 0: exact) at any point that is reached. A RelativeError
   * that is negative or NaN is an error.
   */
  vtkSetClampMacro(Accuracy, int, EXACT, APPROXIMATE);
  vtkGetMacro(Accuracy, int);
  void SetAccuracyToExact() { this->SetAccuracy(EXACT); }
  void SetAccuracyToApproximate() { this->SetAccuracy(APPROXIMATE); }
  vtkSetMacro(RelativeError, double);
  vtkGetMacro(RelativeError, double);
  ///@}

  ///@{
  /**
   * Whether triangles are split until the linear interpolant of the output is within a tolerance of
   * the computed distance everywhere (on by default): RefinementTolerance, as a fraction of the
   * diagonal of the bounding box of the points that faces use (default: 0.001), or, where
   * ToleranceIsAbsolute is on (off by default), AbsoluteRefinementTolerance, in the units of the
   * surface (default: 1). Anything but a positive number is an error.
   */
  vtkSetMacro(RefineMesh, bool);
  vtkGetMacro(RefineMesh, bool);
  vtkBooleanMacro(RefineMesh, bool);
  vtkSetMacro(RefinementTolerance, double);
  vtkGetMacro(RefinementTolerance, double);
  vtkSetMacro(ToleranceIsAbsolute, bool);
  vtkGetMacro(ToleranceIsAbsolute, bool);
  vtkBooleanMacro(ToleranceIsAbsolute, bool);
  vtkSetMacro(AbsoluteRefinementTolerance, double);
  vtkGetMacro(AbsoluteRefinementTolerance, double);
  ///@}

  ///@{
  /**
   * The refined output has no more triangles than this (default: 50,000,000; 0: no limit), but a
   * larger tolerance, with a warning, where that needs more. A negative number is an error.
   */
  vtkSetMacro(MaximumNumberOfCells, vtkIdType);
  vtkGetMacro(MaximumNumberOfCells, vtkIdType);
  ///@}

  ///@{
  /**
   * Whether RefineMesh also splits triangles, down to the tolerance, where the nearest part of the
   * source changes, or with GenerateSignedDistance its side. Takes one more solve. Off by default.
   */
  vtkSetMacro(RefineSourceBorders, bool);
  vtkGetMacro(RefineSourceBorders, bool);
  vtkBooleanMacro(RefineSourceBorders, bool);
  ///@}

  ///@{
  /**
   * Stop at this distance, in the units of the surface (default: 0, no limit). Faces that have a
   * point within the limit get exact values at all their points, points beyond these are infinitely
   * far. A negative value or NaN is an error.
   */
  vtkSetMacro(MaximumDistance, double);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  /**
   * What points that are not reached have for a distance.
   */
  enum UnreachedValues
  {
    UNREACHED_INFINITY = 0,
    UNREACHED_NAN = 1,
    UNREACHED_CUSTOM = 2
  };

  ///@{
  /**
   * The distance, arc length, angle and texture coordinates of points that no path reaches (in
   * barriers, beyond MaximumDistance, in other components): +infinity (the default), NaN, or
   * CustomUnreachedValue, any number (default: -1).
   */
  vtkSetClampMacro(UnreachedValue, int, UNREACHED_INFINITY, UNREACHED_CUSTOM);
  vtkGetMacro(UnreachedValue, int);
  void SetUnreachedValueToInfinity() { this->SetUnreachedValue(UNREACHED_INFINITY); }
  void SetUnreachedValueToNaN() { this->SetUnreachedValue(UNREACHED_NAN); }
  void SetUnreachedValueToCustom() { this->SetUnreachedValue(UNREACHED_CUSTOM); }
  vtkSetMacro(CustomUnreachedValue, double);
  vtkGetMacro(CustomUnreachedValue, double);
  ///@}

  ///@{
  /**
   * Points of output port 0: their precision, SINGLE_PRECISION, DOUBLE_PRECISION, or
   * DEFAULT_PRECISION, the default (double where refinement has added points, otherwise the input's
   * points); and whether those that no triangle uses are left out (off by default).
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  vtkSetMacro(RemoveUnusedPoints, bool);
  vtkGetMacro(RemoveUnusedPoints, bool);
  vtkBooleanMacro(RemoveUnusedPoints, bool);
  ///@}

  ///@{
  /**
   * Name of the point data array with the distances (default: GeodesicDistance). An empty name, or
   * that of another array that is asked for, is an error.
   */
  vtkSetStringMacro(DistanceArrayName);
  vtkGetStringMacro(DistanceArrayName);
  ///@}

  ///@{
  /**
   * Whether the output has the point array SourceId (vtkIdType): the nearest part of the source,
   * as the number of a cell on port 1 (over all blocks in their order), or of a point if a block
   * is a set of points; loops of the boundary follow. -1 where a point is not reached.
   *
   * This and the arrays that follow are off by default and never change the distance. In
   * approximate mode all but DistanceGradient take the time of the exact field, too. Where a point
   * is not reached lengths and angles are UnreachedValue.
   */
  vtkSetMacro(GenerateSourceIds, bool);
  vtkGetMacro(GenerateSourceIds, bool);
  vtkBooleanMacro(GenerateSourceIds, bool);
  ///@}

  ///@{
  /**
   * Whether the output has the point array ClosestSourcePoint (3 doubles): the point of the source
   * where a shortest path ends; the point itself where it is not reached.
   */
  vtkSetMacro(GenerateClosestPoints, bool);
  vtkGetMacro(GenerateClosestPoints, bool);
  vtkBooleanMacro(GenerateClosestPoints, bool);
  ///@}

  ///@{
  /**
   * Whether the output has the point array DistanceGradient (3 doubles): the unit vector away from
   * the source in the last face of a shortest path; zero on the source and where not reached.
   */
  vtkSetMacro(GenerateGradients, bool);
  vtkGetMacro(GenerateGradients, bool);
  vtkBooleanMacro(GenerateGradients, bool);
  ///@}

  ///@{
  /**
   * Whether the output has the point array SignedGeodesicDistance: positive on the left of the
   * curve's direction (normals towards the viewer), negative on its right; positive from points and
   * the boundary. GetInterpolationErrorBound() does not cover this array, whose sign jumps. An edge
   * of three and more faces, or faces of opposite orientation side by side, is an error.
   */
  vtkSetMacro(GenerateSignedDistance, bool);
  vtkGetMacro(GenerateSignedDistance, bool);
  vtkBooleanMacro(GenerateSignedDistance, bool);
  ///@}

  ///@{
  /**
   * Whether the output has the point array SourceArcLength: the length of the source's line, on the
   * surface, from its first point to ClosestSourcePoint; 0 for a point source.
   */
  vtkSetMacro(GenerateSourceArcLength, bool);
  vtkGetMacro(GenerateSourceArcLength, bool);
  vtkBooleanMacro(GenerateSourceArcLength, bool);
  ///@}

  ///@{
  /**
   * Whether the output has the point array SourceAngle: the direction, in radians, in which a
   * shortest path leaves ClosestSourcePoint, counterclockwise (normals towards the viewer) from the
   * first axis of a point's frame, in the field data array SourceFrame, or from a curve's
   * direction. 0 on the source.
   */
  vtkSetMacro(GenerateSourceAngle, bool);
  vtkGetMacro(GenerateSourceAngle, bool);
  vtkBooleanMacro(GenerateSourceAngle, bool);
  ///@}

  ///@{
  /**
   * Whether the output has the point array SourceTextureCoordinates, as active texture coordinates:
   * SourceArcLength and SignedGeodesicDistance of a curve, the distance times the cosine and the
   * sine of SourceAngle around a point, divided by TextureScale. That is the length, in the units
   * of the surface, after which a texture repeats (default: 0, a round number near a tenth of the
   * bounding box's diagonal). With TextureRepeats, the default, tiles begin at the source; without,
   * 0 to 1 is one picture with a point source in its middle, or a curve through half of its height.
   * Includes RefineSourceBorders; the surface must be oriented as for SetGenerateSignedDistance().
   * A TextureScale that is negative, infinite or NaN is an error.
   */
  vtkSetMacro(GenerateTextureCoordinates, bool);
  vtkGetMacro(GenerateTextureCoordinates, bool);
  vtkBooleanMacro(GenerateTextureCoordinates, bool);
  vtkSetMacro(TextureScale, double);
  vtkGetMacro(TextureScale, double);
  vtkSetMacro(TextureRepeats, bool);
  vtkGetMacro(TextureRepeats, bool);
  vtkBooleanMacro(TextureRepeats, bool);
  ///@}

  ///@{
  /**
   * After an execution: the number of windows that the propagation handled, divided by the number
   * of mesh edges; the length on the surface of all curves of the source; the farthest that any
   * point of the source was from where it was put on the surface; and how many points on the
   * boundary of the surface, its blocks or ranks' pieces were joined with others although their
   * coordinates differ.
   */
  vtkGetMacro(WindowsPropagatedPerEdge, double);
  vtkGetMacro(SourceLength, double);
  vtkGetMacro(SourceSnapDistance, double);
  vtkGetMacro(SeamPointsJoined, vtkIdType);
  ///@}

  ///@{
  /**
   * After an execution, certified: the relative error of the computed distance, at most
   * RelativeError, 0 where it is exact; and the difference between the linear interpolant of the
   * output and the computed distance, anywhere on triangles that are reached and have a point
   * within MaximumDistance, in the units of the surface: at most the tolerance, or a warning says
   * why not; infinite if the surface was not refined.
   */
  vtkGetMacro(RelativeErrorBound, double);
  vtkGetMacro(InterpolationErrorBound, double);
  ///@}

  ///@{
  /**
   * After an execution, of the points of the output's triangles, on all ranks: the largest distance
   * of those that are reached; where the first such point is, in space (the origin as long as the
   * largest distance is 0); and whether a point is not reached.
   */
  vtkGetMacro(LargestDistance, double);
  vtkGetVector3Macro(FarthestPoint, double);
  vtkGetMacro(HasUnreachedPoints, bool);
  ///@}

protected:
  vtkGeodesicDistanceField();
  ~vtkGeodesicDistanceField() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  std::string FindWrongProperty() const override;
  std::string AdviceOnMemory() const override;
  void ResetResults() override;
  geodesic::ExecutionPlan Plan() const override;
  void Compute(const geodesic::Inputs& inputs, geodesic::FilterExecution& execution,
    vtkInformationVector* outputVector) override;

private:
  vtkGeodesicDistanceField(const vtkGeodesicDistanceField&) = delete;
  void operator=(const vtkGeodesicDistanceField&) = delete;

  class vtkWorker;

  int Accuracy = EXACT;
  double RelativeError = 0.001;
  bool RefineMesh = true;
  double RefinementTolerance = 0.001;
  bool ToleranceIsAbsolute = false;
  double AbsoluteRefinementTolerance = 1.0;
  vtkIdType MaximumNumberOfCells = 50000000;
  int OutputPointsPrecision = DEFAULT_PRECISION;
  bool RefineSourceBorders = false;
  double MaximumDistance = 0.0;
  int UnreachedValue = UNREACHED_INFINITY;
  double CustomUnreachedValue = -1.0;
  bool RemoveUnusedPoints = false;
  char* DistanceArrayName = nullptr;
  bool GenerateSourceIds = false;
  bool GenerateClosestPoints = false;
  bool GenerateGradients = false;
  bool GenerateSignedDistance = false;
  bool GenerateSourceArcLength = false;
  bool GenerateSourceAngle = false;
  bool GenerateTextureCoordinates = false;
  double TextureScale = 0.0;
  bool TextureRepeats = true;
  double WindowsPropagatedPerEdge = 0.0;
  double SourceLength = 0.0;
  double SourceSnapDistance = 0.0;
  double RelativeErrorBound = 0.0;
  double InterpolationErrorBound = std::numeric_limits<double>::infinity();
  vtkIdType SeamPointsJoined = 0;
  double LargestDistance = 0.0;
  double FarthestPoint[3] = { 0.0, 0.0, 0.0 };
  bool HasUnreachedPoints = false;
};

#endif
