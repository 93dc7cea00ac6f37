// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/GatheredFaces.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// The place of a value in an ascending list; NoId where it is not there.
template <typename Value>
Id placeIn(const std::vector<Value>& values, const Value& value)
{
  const auto found = std::lower_bound(values.begin(), values.end(), value);
  return found == values.end() || value < *found ? NoId : static_cast<Id>(found - values.begin());
}

} // anonymous namespace

SentFace sentFace(const MeshPartition& part, Id face)
{
  SentFace sent = { part.addressOf(face), {}, {} };
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id vertex = part.mesh().triangle(face)[k];
    sent.vertices[k] = part.globalId(vertex);
    sent.points[k] = part.mesh().point(vertex);
  }
  return sent;
}

GatheredFaces::GatheredFaces(const std::vector<SentFace>& faces)
{
  for (const SentFace& face : faces)
  {
    this->owners_.push_back(face.owner);
    this->globalIds_.insert(this->globalIds_.end(), face.vertices.begin(), face.vertices.end());
  }
  std::sort(this->globalIds_.begin(), this->globalIds_.end());
  this->globalIds_.erase(
    std::unique(this->globalIds_.begin(), this->globalIds_.end()), this->globalIds_.end());
  std::vector<Vec3> points(this->globalIds_.size());
  std::vector<Triangle> triangles;
  triangles.reserve(faces.size());
  for (const SentFace& face : faces)
  {
    Triangle& triangle = triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
    {
      triangle[k] = this->vertexAt(face.vertices[k]);
      points[triangle[k]] = face.points[k];
    }
  }
  if (!triangles.empty())
  {
    this->mesh_ = TriangleMesh(std::move(points), triangles);
  }
}

Id GatheredFaces::faceAt(const RankAddress& face) const
{
  return placeIn(this->owners_, face);
}

Id GatheredFaces::vertexAt(Id globalId) const
{
  return placeIn(this->globalIds_, globalId);
}

}
