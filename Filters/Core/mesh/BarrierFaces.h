// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BarrierFaces_h
#define geodesic_BarrierFaces_h

#include "mesh/FaceLocator.h"
#include "mesh/SurfaceSnap.h"
#include "mesh/TriangleMesh.h"

#include <vector>

namespace geodesic
{

/// Whether a point in space lies in a barrier rather than on an open face. A place on the rim is
/// also a place on an open face, equally close. So a point lies inside a barrier if it is nearer to
/// the barrier by more than the precision of its place.
///
/// \param inBarrier the point, put onto the barrier.
/// \param toOpen the point's distance from the open faces.
inline bool isInBarrier(const SnappedPoint& inBarrier, double toOpen)
{
  return inBarrier.distance + inBarrier.tolerance < toOpen;
}

/// The barriers of a surface: faces that no path may enter. They are not part of the mesh, which
/// has holes in their place. So paths run along a barrier's rim and bend at its vertices if these
/// are reflex corners of the mesh, and the engine needs no other notion of barriers. This class
/// locates them, for points that have to be put onto the surface.
class BarrierFaces
{
public:
  /// \param mesh the open faces of the surface; must outlive this.
  /// \param triangles the barriers, on the vertices of the mesh; at least one.
  /// \throws MeshError if none of them has three different corners.
  BarrierFaces(const TriangleMesh& mesh, const std::vector<Triangle>& triangles);

  /// faceLocator_ refers to barriers_.
  BarrierFaces(const BarrierFaces&) = delete;
  void operator=(const BarrierFaces&) = delete;

  /// The barriers as a separate mesh on the same vertices. TriangleMesh::inputFace() gives the
  /// triangle that each face came from.
  const TriangleMesh& mesh() const { return this->barriers_; }

  /// The barrier that contains a point in space, or is closest to it: a face of mesh(). NoId if an
  /// open face is as close, within the precision of the place: a point on the rim lies outside. Not
  /// thread-safe.
  ///
  /// \param closest the open faces that are closest to the point.
  /// \param coordinatePrecision relative precision of the point's coordinates.
  Id barrierAt(const Vec3& point, const std::vector<Id>& closest, double coordinatePrecision);

private:
  const TriangleMesh& open_;
  TriangleMesh barriers_;
  FaceLocator faceLocator_;
};

}

#endif
