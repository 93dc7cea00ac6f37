// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_AdaptiveRefinement_h
#define geodesic_AdaptiveRefinement_h

#include "Progress.h"
#include "field/DistanceField.h"
#include "refinement/RefinedMesh.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace geodesic
{

struct RefinementOptions
{
  /// Largest difference between the distance and the linear interpolant of the result, anywhere, in
  /// the surface's units.
  double tolerance = 0.0;
  /// Most triangles of the result, with those beside it (below), over all ranks; 0: no limit.
  std::uint64_t maximumFaces = 0;
  /// For each face of the mesh, the ids of the caller's points at its corners, where these are not
  /// the mesh's vertices: several points may be one vertex (a seam). The result is then in terms of
  /// these points. Empty: the mesh's vertices.
  std::vector<Triangle> cornerPoints;
  /// How many points the caller has; ignored without cornerPoints, unless this rank has no face.
  Id numberOfPoints = 0;
  /// How many triangles that are none of the mesh's the caller will close against the splits of an
  /// edge, by the edge's name (TriangleMesh::edgeOf); edges without such have no entry. What these
  /// come to counts for maximumFaces.
  std::unordered_map<Id, Id> trianglesBeside;
  /// Absent: one task after another. The result does not depend on it.
  ParallelFor parallelFor;
  /// Called now and then with the fraction done in [0, 1]; returning false stops with Aborted.
  ProgressCallback progress;
};

/// Refines a mesh until the linear interpolant of the distance is within the tolerance anywhere,
/// also inside faces (paper, section 6, which looks at edges). The surface stays what it is: new
/// points lie on its edges and faces, where the distance is exact without a new propagation.
///
/// Triangles that are worst come first. Their edges over the tolerance are split near where the
/// deviation is largest (DeviationRules), as far as the shapes of the parts allow it (PartShapes).
///
/// Triangles with split edges are closed by two to four triangles (RedGreenMesh). Of the ways
/// to do that, which differ by flips inside the triangle, the one of the best shapes is taken that
/// meets the tolerance, so that an edge follows where the distance bends. Where there is none, more
/// of its edges are split, and then it is split into four.
///
/// With an approximate field the distance is the computed one. The faces at a point may differ by
/// what was merged on their edge; that is taken off the tolerance, and counted in errorBound. It is
/// small where solveForRefinement() has made the field. How what is certified adds up: Bounds.md.
///
/// Faces in which the field has no exact values, as beyond the limit of a solve, are left as they
/// are, but for what their neighbours' splits ask for.
///
/// Over ranks all call together, with the same tolerance and maximum, and get the faces that they
/// own refined; what the options say of faces of other ranks is not looked at. The refined parts
/// fit together: points on edges of several ranks have the same place along the edge
/// (RefinedPoint::weight), position and distance on all of them, bit for bit. The maximum of
/// triangles counts all ranks' together; errorBound and stoppedAtMaximum are those of the whole,
/// and the same everywhere. Which triangles there are depends on the cut, as leaves are refined in
/// batches then.
///
/// \param field with windows kept.
/// \throws Error where the tolerance is not a positive number, or the field has no windows;
///         Aborted.
RefinedMesh refine(const DistanceField& field, const RefinementOptions& options);

}

#endif
