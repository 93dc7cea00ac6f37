// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeodesicDistanceField
 * @brief   exact geodesic distance from points, curves and boundaries on a triangle mesh
 *
 * vtkGeodesicDistanceField puts on every point of a surface the length of the shortest path *on*
 * the surface to the nearest point of a source. The source is made of points, open or closed
 * polylines, the surface's boundary, or any mix of them, and the segments of a polyline count with
 * all their points, not only with their ends.
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
 * the triangles.
 *
 * @par
 * A curve need not be made of mesh edges, nor lie on the surface exactly. Its points are put onto
 * the closest points of the surface, and onto a vertex or an edge when within the precision of the
 * coordinates. Consecutive points in one face are joined straight, others by the shortest path
 * between them on the surface. So a section by vtkCutter, the lines of vtkFeatureEdges and a
 * polyline drawn on the surface can all be used as they come.
 *
 * @par Input:
 * Port 0 takes the surface. It may have boundary and holes, several components, edges of three and
 * more faces, vertices where several sheets meet, and inconsistent orientation. Polygons and strips
 * are triangulated; lines and vertices are dropped with a warning; faces with two equal corners are
 * left out with a warning. Port 1, optional, takes the source: each line or polyline is a curve,
 * each point of a vertex cell a point source, polygons stand for their outlines, and a vtkPolyData
 * without cells gives all its points as point sources. Inputs are never modified.
 *
 * @par Output:
 * Port 0 has the surface with all points of the input, unchanged and in order, and
 * - point data array `GeodesicDistance` (or DistanceArrayName): the distance, in double precision;
 *   infinite at points that no path connects to the source, or beyond MaximumDistance,
 * - field data array `WindowsPropagatedPerEdge`: see GetWindowsPropagatedPerEdge(),
 * - field data array `SourceSnapDistance`: see GetSourceSnapDistance().
 * @par
 * Port 1 has the source as it lies on the surface: polylines with a point at every mesh edge that
 * they cross, and a vertex for each point source.
 *
 * @par Execution:
 * The structure of the surface is kept, so that executing again with another source costs only the
 * propagation. Progress is reported, and abort is obeyed. After an abort or an error both outputs
 * are empty.
 *
 * @warning
 * The surface must be whole in one process: with several MPI ranks the filter refuses to execute.
 *
 * @par Thanks:
 * David Bommes and Leif Kobbelt, "Accurate Computation of Geodesic Distance Fields for Polygonal
 * Curves on Triangle Meshes", Proceedings of Vision, Modeling, and Visualization (VMV) 2007.
 *
 * @sa
 * vtkDijkstraGraphGeodesicPath vtkDistancePolyDataFilter vtkFeatureEdges vtkCutter
 */

#ifndef vtkGeodesicDistanceField_h
#define vtkGeodesicDistanceField_h

#include "vtkFiltersGeodesicModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for std::unique_ptr

class VTKFILTERSGEODESIC_EXPORT vtkGeodesicDistanceField : public vtkPolyDataAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for construction, type information and printing.
   */
  static vtkGeodesicDistanceField* New();
  vtkTypeMacro(vtkGeodesicDistanceField, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * The source on port 1: curves and points. Not needed when the boundary is the source.
   */
  void SetSourceConnection(vtkAlgorithmOutput* output);
  void SetSourceData(vtkPolyData* source);
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
   * Stop at this distance, in the units of the surface; 0, the default, is no limit. Every face
   * that has a point within the limit gets exact values at all its points, so that contours inside
   * the limit are whole. Points beyond that are infinitely far.
   */
  vtkSetClampMacro(MaximumDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /**
   * Whether points at exactly one place are one point, so that faces around it are connected. On by
   * default: formats without shared points (STL) or with seams (OBJ) need it. The output keeps the
   * points of the input in either case.
   */
  vtkSetMacro(MergeCoincidentPoints, bool);
  vtkGetMacro(MergeCoincidentPoints, bool);
  vtkBooleanMacro(MergeCoincidentPoints, bool);
  ///@}

  ///@{
  /**
   * Name of the point data array with the distances. Default: GeodesicDistance.
   */
  vtkSetStringMacro(DistanceArrayName);
  vtkGetStringMacro(DistanceArrayName);
  ///@}

  ///@{
  /**
   * After an execution: the number of windows that the propagation handled, divided by the number
   * of mesh edges. It tells how hard the surface was.
   */
  vtkGetMacro(WindowsPropagatedPerEdge, double);
  ///@}

  ///@{
  /**
   * After an execution: the farthest that any point of the source was from where it was put on the
   * surface. It tells whether the source belongs to this surface.
   */
  vtkGetMacro(SourceSnapDistance, double);
  ///@}

protected:
  vtkGeodesicDistanceField();
  ~vtkGeodesicDistanceField() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkGeodesicDistanceField(const vtkGeodesicDistanceField&) = delete;
  void operator=(const vtkGeodesicDistanceField&) = delete;

  int SourceType = SOURCE_CURVE;
  double MaximumDistance = 0.0;
  bool MergeCoincidentPoints = true;
  char* DistanceArrayName = nullptr;
  double WindowsPropagatedPerEdge = 0.0;
  double SourceSnapDistance = 0.0;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
