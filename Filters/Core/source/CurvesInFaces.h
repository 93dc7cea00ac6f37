// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CurvesInFaces_h
#define geodesic_CurvesInFaces_h

#include "mesh/TriangleMesh.h"
#include "source/SourceCurve.h"
#include "source/SourceInFace.h"

#include <vector>

namespace geodesic
{

/// Finds the curve of a source at a point of the surface.
class CurvesInFaces
{
public:
  /// \param mesh must outlive this.
  CurvesInFaces(const TriangleMesh& mesh, const std::vector<SourceCurve>& curves);

  /// SourceCurve::source of a curve through a point on the source, or of the nearest curve in the
  /// faces around it. NoId if these faces contain no curve.
  Id sourceAt(const SurfacePoint& point) const;

private:
  struct Piece
  {
    SourceInFace place;
    Id source;
  };

  void add(Id face, const SurfacePoint& p, const SurfacePoint& q, Id source);

  const TriangleMesh& mesh_;
  /// In the order of the faces.
  std::vector<Piece> pieces_;
};

}

#endif
