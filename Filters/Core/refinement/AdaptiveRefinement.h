// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_AdaptiveRefinement_h
#define geodesic_AdaptiveRefinement_h

#include "Job.h"
#include "field/DistanceField.h"
#include "refinement/RefinedMesh.h"
#include "refinement/SourceRegions.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace geodesic
{

struct RefinementOptions
{
  /// Largest allowed difference anywhere between the distance and the linear interpolant of the
  /// result, in the surface's units.
  double tolerance = 0.0;
  /// Largest number of triangles of the result over all ranks, including trianglesBeside; 0: no
  /// limit.
  std::uint64_t maximumFaces = 0;
  /// For each face of the mesh, the ids of the caller's points at its corners, if these are not the
  /// mesh's vertices: several points may be one vertex (a seam). The result then refers to these
  /// points. Empty: the mesh's vertices.
  std::vector<Triangle> cornerPoints;
  /// Number of the caller's points; ignored without cornerPoints, unless this rank has no face.
  Id numberOfPoints = 0;
  /// For an edge, named by TriangleMesh::edgeOf, the number of triangles outside of the mesh that
  /// the caller will close against the edge's splits; edges without such triangles have no entry.
  /// The closed triangles count for maximumFaces.
  std::unordered_map<Id, Id> trianglesBeside;
  /// Null: there are no regions. A triangle with corners in several regions is split until its
  /// edges are no longer than the tolerance, unless these are the two sides of one curve, and a
  /// straight line between them may cross the curve. Asked by one thread.
  SourceRegions* regions = nullptr;
  /// The result does not depend on its threads.
  Job job;
};

/// Refines a mesh until the linear interpolant of the distance is within the tolerance everywhere,
/// including inside faces (paper, section 6, which considers edges). The surface does not change:
/// new points lie on its edges and faces, where the distance is exact without a new propagation.
///
/// If the tolerance needs more than the maximum of triangles, the surface is refined to a larger
/// one, the smallest found for which there is room.
///
/// With an approximate field the distance is the computed one. The faces at a point may differ by
/// what was merged on their edge; this difference is subtracted from the tolerance and added to
/// errorBound. It is small if solveForRefinement() has computed the field. Bounds.md explains how
/// the certified bounds add up.
///
/// Faces in which the field has no exact values, such as those beyond the limit of a solve, are
/// split only if their neighbours' splits require it.
///
/// All ranks call this together, with the same tolerance and maximum, and refine the faces that
/// they own; the options' values for faces of other ranks are ignored. Points on edges of several
/// ranks are the same on all of them, bit for bit. The maximum counts the triangles of all ranks;
/// errorBound and stoppedAtMaximum are global. Partitions change few triangles: fields differ in
/// their last bits, and ranks keep the windows of faces at seams.
///
/// \param field with windows kept.
/// \throws Error if the tolerance is not a positive number, or the field has no windows; Aborted.
RefinedMesh refine(const DistanceField& field, const RefinementOptions& options);

}

#endif
