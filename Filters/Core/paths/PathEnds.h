// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathEnds_h
#define geodesic_PathEnds_h

#include "source/CurvesOnPatch.h"

#include <functional>
#include <vector>

namespace geodesic
{

/// The end of a path on the source.
struct PathEnd
{
  /// SourceCurve::source of a curve that the end lies on; NoId if there is none.
  Id source = NoId;
  /// The length along this curve, from its first point.
  double arcLength = 0.0;
  /// The direction in which the path leaves the source, seen from its end:
  /// NearestSource::angleOf(). 0 for a target on the source.
  double angle = 0.0;
};

/// Finds where paths end on the source, from their last piece. Thread-safe.
class PathEnds
{
public:
  /// \param patch that the curves lie on.
  /// \param curves must outlive this.
  PathEnds(const ReplicatedPatch& patch, const std::vector<SourceCurve>& curves);

  /// \param mesh that the path's points lie on.
  /// \param path from the target to the source; consecutive points have a face in common.
  /// \param addressOf the address of a face of the mesh.
  PathEnd of(const TriangleMesh& mesh, const std::vector<SurfacePoint>& path,
    const std::function<RankAddress(Id)>& addressOf) const;

private:
  /// The last piece of a path on the patch: where it ends, and the direction back from there, in
  /// the frame of a face's first halfedge.
  struct LastPiece
  {
    SurfacePoint end;
    Id face;
    Vec2 direction;
  };

  const TriangleMesh& mesh() const { return this->onPatch_.mesh(); }
  const SourceInFace* nearest(const SurfacePoint& point, Id preferred, double rounding) const;
  PathEnd onSegment(const LastPiece& piece, const SourceInFace& segment, double parameter) const;
  PathEnd atPoint(const LastPiece& piece, Id number) const;
  PathEnd endAt(Id chain, double parameter, double angle) const;

  const std::vector<SourceCurve>& curves_;
  CurvesOnPatch onPatch_;
  /// The segments of the curves, and sources that are points, in the order of the faces.
  std::vector<SourceInFace> inFaces_;
};

}

#endif
