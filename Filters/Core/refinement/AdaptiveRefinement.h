// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_AdaptiveRefinement_h
#define geodesic_AdaptiveRefinement_h

#include "field/DistanceField.h"
#include "Progress.h"
#include "mesh/SurfacePoint.h"
#include "mesh/TriangleMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace geodesic
{

struct RefinementOptions
{
  /// Largest difference between the distance and the linear interpolant of the result, anywhere, in
  /// the surface's units.
  double tolerance = 0.0;
  /// Most triangles of the result; 0: no limit.
  std::uint64_t maximumFaces = 0;
  /// The limit of the solve. Faces without exact values inside are left as they are.
  double maximumDistance = Infinity;
  /// For each face of the mesh, the ids of the caller's points at its corners, where these are not
  /// the mesh's vertices: several points may be one vertex (a seam). The result is then in terms of
  /// these points. Empty: the mesh's vertices.
  std::vector<Triangle> cornerPoints;
  /// How many points the caller has; ignored without cornerPoints.
  Id numberOfPoints = 0;
  /// Called now and then with the fraction done in [0, 1]; returning false stops with Aborted.
  ProgressCallback progress;
};

/// A point that refinement has added.
struct RefinedPoint
{
  /// The points on whose connection it lies, and the fraction of the way from the first to the
  /// second: what is known at points can be interpolated in the order of the points.
  std::array<Id, 2> parents;
  double weight;
  /// The place on the input mesh: on an edge or in a face.
  SurfacePoint place;
  Vec3 position;
  double distance;
};

struct RefinedMesh
{
  /// Points up to here are the caller's, unchanged.
  Id numberOfInputPoints = 0;
  /// The others.
  std::vector<RefinedPoint> points;
  std::vector<Triangle> triangles;
  /// The face of the mesh that each triangle is a part of; ascending.
  std::vector<Id> faces;
  /// Certified: nowhere on a face that could be refined is the difference between distance and
  /// interpolant larger. At most the tolerance, unless more faces would have been needed, or an
  /// approximate field was not solved for this tolerance.
  double errorBound = 0.0;
  /// Whether more faces would have been needed.
  bool stoppedAtMaximum = false;
};

/// Refines a mesh until the linear interpolant of the distance is within the tolerance anywhere,
/// also inside faces (paper, section 6, which looks at edges). The surface stays what it is: new
/// points lie on its edges and faces, where the distance is exact without a new propagation.
///
/// Triangles that are worst come first. Their edges over the tolerance are split where the
/// deviation is largest, moved away from the ends by the table of section 6.2; where a part's
/// smallest angle would be too small, the table yields: the edge is split halfway to its middle, or
/// there. Too small is under 14 degrees and under 0.6 of the input face's smallest, and 3 degrees
/// while the edge is far over the tolerance (Tolerance.h).
///
/// Triangles with split edges are closed by two to four triangles (see RedGreenMesh). Of the ways
/// to do that, which differ by flips inside the triangle, the one of the best shapes is taken that
/// meets the tolerance, so that an edge follows where the distance bends. Where there is none, more
/// of its edges are split, and then it is split into four.
///
/// With an approximate field the distance is the computed one. The faces at a point may differ by
/// what was merged on their edge; that is taken off the tolerance, and counted in errorBound. It is
/// small where solveForRefinement() has made the field.
///
/// \param field with windows kept.
/// \throws Error where the tolerance is not a positive number, or the field has no windows;
///         Aborted.
RefinedMesh refine(const DistanceField& field, const RefinementOptions& options);

}

#endif
