// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CurvesInFaces_h
#define geodesic_CurvesInFaces_h

#include "mesh/TriangleMesh.h"
#include "source/CurveChains.h"
#include "source/SourceInFace.h"

#include <vector>

namespace geodesic
{

/// Finds the segment of a source at a point of the surface.
class CurvesInFaces
{
public:
  /// \param mesh must outlive this.
  CurvesInFaces(const TriangleMesh& mesh, const CurveChains& chains);

  /// The segment, or source that is a point, nearest to a point in the faces around it. Null if
  /// these faces contain none.
  ///
  /// \param face around the point: its segments are preferred to those of other faces that are as
  ///        near but for rounding.
  const SourceInFace* nearest(const SurfacePoint& point, Id face) const;

private:
  const TriangleMesh& mesh_;
  /// In the order of the faces.
  std::vector<SourceInFace> pieces_;
};

}

#endif
