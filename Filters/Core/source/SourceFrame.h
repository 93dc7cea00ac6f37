// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceFrame_h
#define geodesic_SourceFrame_h

#include "source/CurveChains.h"
#include "source/VerticesOnCurves.h"

namespace geodesic
{

/// The tangent plane at a source, as unit vectors in space: the direction of angle 0, the one at a
/// right angle to its left, and the normal of the face there.
struct SourceFrame
{
  Vec3 x = {};
  Vec3 y = {};
  Vec3 normal = {};
};

/// The frame of a single point, or of a curve at its first segment: NearestSource::frameOf().
SourceFrame sourceFrame(
  const TriangleMesh& mesh, const CurveChains& chains, const VerticesOnCurves& onCurves, Id curve);

}

#endif
