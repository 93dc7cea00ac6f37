// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathsToSource_h
#define geodesic_PathsToSource_h

#include "field/FootFinder.h"
#include "front/Front.h"
#include "mesh/ReplicatedPatch.h"
#include "mesh/SurfacePoint.h"
#include "paths/PathTracer.h"
#include "source/SourceCurve.h"

#include <functional>
#include <optional>
#include <vector>

namespace geodesic
{

/// The end of a path on the source.
struct PathEnd
{
  /// SourceCurve::source of the curve that the end lies on.
  Id source = NoId;
  /// The length along this curve, from its first point.
  double arcLength = 0.0;
  /// The direction in which the path leaves the source, seen from its end: FootFinder::angleOf(). 0
  /// for a target on the source.
  double angle = 0.0;
};

/// A shortest path from a target to the source.
struct PathToSource
{
  /// Which of its rank's targets the path begins at.
  Id target = NoId;
  /// The target, a point on every edge that the path crosses, the vertices that it passes, its end
  /// on the source; twice the target where that is on the source. Consecutive points have a face in
  /// common.
  std::vector<SurfacePoint> points = {};
  PathEnd end = {};
  /// Must outlive the path.
  const MeshPartition* part = nullptr;
  /// The faces that the path goes through, if they were gathered from several ranks; if not, the
  /// points lie on the part.
  std::optional<GatheredFaces> gathered = {};
  /// Whether tracing lost the path, so that windows had to find it again, which takes much longer.
  bool wasLost = false;

  /// The mesh that the points lie on.
  const TriangleMesh& mesh() const
  {
    return this->gathered ? this->gathered->mesh() : this->part->mesh();
  }
  /// A face that holds a point and the next one; any of those that do.
  RankAddress faceAfter(std::size_t point) const
  {
    const Id face = commonFace(this->mesh(), this->points[point], this->points[point + 1]);
    return this->gathered ? this->gathered->ownerOf(face) : this->part->addressOf(face);
  }
};

/// Takes over the path of a target. Paths come one after another, in no order. Targets that are not
/// reached have none.
using TakePath = std::function<void(const PathToSource& path)>;

/// The end of a path that is complete, by its last two points and the piece that has led there.
///
/// \param curves those of the feet.
PathEnd endOf(const TracedPath& path, FootFinder& feet, const std::vector<SourceCurve>& curves);

/// Finds the shortest paths from points of the surface to the nearest point of the source, one path
/// for each target.
///
/// One front goes from the source until the targets of all ranks are settled; it keeps windows only
/// around the targets. Each rank then traces the paths of its targets backwards through the faces
/// that it owns, by the directions in which paths came to vertices (followPath()). If a path comes
/// to another rank's face, that rank is asked for the next part (PathsOnRanks). Where a path runs
/// so close to vertices that rounding leads it astray, pathInStrip() finds it again.
///
/// All ranks call this together.
///
/// \param patch that the curves lie on.
/// \param targets in faces that this rank owns; maybe none.
/// \throws SourceError where there is no source; Aborted.
void pathsToSource(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<SourceCurve>& curves, const std::vector<SurfacePoint>& targets, const Job& job,
  const TakePath& take);

}

#endif
