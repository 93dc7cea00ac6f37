// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BarrierFaces_h
#define geodesic_BarrierFaces_h

#include "mesh/FaceLocator.h"
#include "mesh/SurfaceSnap.h"
#include "mesh/TriangleMesh.h"

#include <vector>

namespace geodesic
{

/// Whether a point in space lies in a barrier rather than on a face that is none. A place on the
/// rim is a place on such a face, too, which is as close there: what is nearer to a barrier by more
/// than the precision of its place lies inside.
///
/// \param inBarrier the point, put onto the barrier.
/// \param toOpen how far it is from the faces that are no barriers.
inline bool isInBarrier(const SnappedPoint& inBarrier, double toOpen)
{
  return inBarrier.distance + inBarrier.tolerance < toOpen;
}

/// The faces of a surface that no path may enter. They are none of the faces of its mesh, which has
/// holes in their place: so paths run along a barrier's rim, bend around it where vertices of the
/// rim are reflex corners of the mesh, and the engine needs to know nothing of barriers. This class
/// knows where they are, for points that are to be put onto the surface.
class BarrierFaces
{
public:
  /// \param mesh the faces of the surface that are no barriers; must outlive this.
  /// \param triangles the barriers, on the vertices of the mesh; one at least.
  /// \throws MeshError where none of them has three different corners.
  BarrierFaces(const TriangleMesh& mesh, const std::vector<Triangle>& triangles);

  /// The faceLocator_ refers to barriers_.
  BarrierFaces(const BarrierFaces&) = delete;
  void operator=(const BarrierFaces&) = delete;

  /// The barriers, as a mesh of their own on the same vertices. TriangleMesh::inputFace() tells
  /// which of the triangles each is.
  const TriangleMesh& mesh() const { return this->barriers_; }

  /// The barrier that a point in space lies in, or is closest to: a face of mesh(). NoId where a
  /// face that is no barrier is as close, within the precision of the place: a point on the rim
  /// lies outside. Not thread-safe.
  ///
  /// \param closest the faces of the mesh without barriers that are closest to the point.
  /// \param coordinatePrecision relative precision of the point's coordinates.
  Id barrierAt(const Vec3& point, const std::vector<Id>& closest, double coordinatePrecision);

private:
  const TriangleMesh& open_;
  TriangleMesh barriers_;
  FaceLocator faceLocator_;
};

}

#endif
