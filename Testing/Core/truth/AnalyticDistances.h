// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_AnalyticDistances_h
#define geodesictest_AnalyticDistances_h

#include "truth/TestMeshes.h"

#include <utility>
#include <vector>

/// Geodesic distances that are known without propagation over a mesh. The source is a straight
/// segment; for a point source, pass the same point twice.
namespace geodesictest
{

/// In the plane.
double distanceToSegment(const Vec2& p, const Vec2& a, const Vec2& b);

/// On the surface of the box [0, size]: the shortest straight line in any unfolding of its faces
/// that stays on them. The segment must lie in one face of the box.
double boxDistance(const Vec3& size, const Vec3& p, const Vec3& a, const Vec3& b);

/// On the side of a prism, unrolled: first coordinate along the perimeter, second along the axis.
/// The segment does not cross the line where the perimeter begins.
double prismDistance(double perimeter, const Vec2& p, const Vec2& a, const Vec2& b);

/// A point of a cone (or of a saddle fan): its distance from the apex and its angle around it.
struct Polar
{
  double radius;
  double angle;
};

/// On a cone with this total angle at its apex. The segment spans less than half a turn.
double coneDistance(double totalAngle, const Polar& p, const Polar& a, const Polar& b);

/// The polar coordinates of a point of fan(), from its position and the face that contains it.
Polar fanCoordinates(
  Index sectors, double angle, Index n, const PlainMesh& mesh, const MeshPoint& p);

/// The place of a point of tetrahedron() in the lattice that unfolds it: face as in tetrahedron().
Vec2 tetrahedronCoordinates(Index tetrahedronFace, const Vec3& position);

/// On the regular tetrahedron of edge length 1, between places from tetrahedronCoordinates(). Its
/// unfoldings tile the plane: the images of a point are its half turns about the lattice's points,
/// and no line is blocked.
double tetrahedronDistance(const Vec2& p, const Vec2& a, const Vec2& b);

/// A planar domain, given by its boundary edges (outlines of the domain and of its holes).
class PlanarDomain
{
public:
  explicit PlanarDomain(std::vector<std::pair<Vec2, Vec2>> edges);

  /// Distances from the segment to each point by a visibility graph; all must be in one component.
  std::vector<double> distances(
    const Vec2& a, const Vec2& b, const std::vector<Vec2>& points) const;

private:
  bool isVisible(const Vec2& p, const Vec2& q) const;
  bool isInside(const Vec2& p) const;
  double visibleDistance(const Vec2& p, const Vec2& a, const Vec2& b) const;

  std::vector<std::pair<Vec2, Vec2>> edges_;
  std::vector<Vec2> corners_;
  double size_ = 0.0;
};

/// The boundary edges of a mesh that lies in the xy plane.
PlanarDomain planarDomain(const PlainMesh& mesh);

}

#endif
