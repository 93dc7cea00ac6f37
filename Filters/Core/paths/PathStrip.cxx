// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathStrip.h"

#include "paths/CleanPath.h"

#include <algorithm>
#include <map>

namespace geodesic
{

namespace
{

std::size_t cornerOf(const Triangle& triangle, Id vertex)
{
  return triangle[0] == vertex ? 0 : triangle[1] == vertex ? 1 : 2;
}

/// The faces of a path as a mesh.
class Strip
{
public:
  explicit Strip(const std::vector<PointInFace>& path)
  {
    std::map<RankAddress, const PointInFace*> faces;
    std::map<Id, Vec3> places;
    for (const PointInFace& p : path)
    {
      faces[p.face] = &p;
      for (std::size_t k = 0; k < 3; ++k)
      {
        places[p.vertices[k]] = p.corners[k];
      }
    }
    std::vector<Vec3> points;
    std::map<Id, Id> vertexWithNumber;
    for (const auto& [number, place] : places)
    {
      vertexWithNumber[number] = static_cast<Id>(points.size());
      points.push_back(place);
    }
    std::vector<Triangle> triangles;
    for (const auto& [address, p] : faces)
    {
      this->faces_.push_back(address);
      triangles.push_back({ vertexWithNumber[p->vertices[0]], vertexWithNumber[p->vertices[1]],
        vertexWithNumber[p->vertices[2]] });
    }
    this->mesh_ = TriangleMesh(std::move(points), triangles);
  }

  const TriangleMesh& mesh() const { return this->mesh_; }

  SurfacePoint pointOf(const PointInFace& p) const
  {
    const auto face = static_cast<Id>(
      std::lower_bound(this->faces_.begin(), this->faces_.end(), p.face) - this->faces_.begin());
    SurfacePoint point = p.point;
    point.id = point.kind == SurfacePoint::Kind::Vertex ? this->mesh_.triangle(face)[p.point.id]
      : point.kind == SurfacePoint::Kind::Edge          ? 3 * face + p.point.id
                                                        : face;
    return point;
  }

private:
  std::vector<RankAddress> faces_;
  TriangleMesh mesh_;
};

} // anonymous namespace

PointInFace pointInFace(const MeshPartition& part, Id face, const SurfacePoint& point)
{
  const TriangleMesh& mesh = part.mesh();
  PointInFace result = { part.addressOf(face), {}, {}, point };
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id vertex = mesh.triangle(face)[k];
    result.vertices[k] = part.globalId(vertex);
    result.corners[k] = mesh.point(vertex);
  }
  result.point.id = point.kind == SurfacePoint::Kind::Vertex
    ? static_cast<Id>(cornerOf(mesh.triangle(face), point.id))
    : point.id % 3;
  return result;
}

SurfacePoint pointOfPart(const MeshPartition& part, const RankAddress& address, SurfacePoint point)
{
  const Id face = part.faceAt(address);
  point.id = point.kind == SurfacePoint::Kind::Vertex ? part.mesh().triangle(face)[point.id]
    : point.kind == SurfacePoint::Kind::Edge          ? 3 * face + point.id
                                                      : face;
  return point;
}

std::vector<Vec3> cleanedPlaces(const std::vector<PointInFace>& path, double length)
{
  const Strip strip(path);
  std::vector<SurfacePoint> points;
  points.reserve(path.size());
  for (const PointInFace& p : path)
  {
    points.push_back(strip.pointOf(p));
  }
  points = points.size() == 1
    ? std::vector<SurfacePoint>(2, points.front())
    : cleanedPath(strip.mesh(), points, points.front(), points.back(), length);
  std::vector<Vec3> places;
  places.reserve(points.size());
  for (const SurfacePoint& p : points)
  {
    places.push_back(position(strip.mesh(), p));
  }
  return places;
}

}
