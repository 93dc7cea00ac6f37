// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/ReplicatedPatch.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// Some faces and all faces around their vertices, including copies, ascending.
std::vector<Id> withNeighbours(const TriangleMesh& mesh, const std::vector<Id>& faces)
{
  std::vector<Id> around;
  for (const Id face : faces)
  {
    for (const Id vertex : mesh.triangle(face))
    {
      for (const Id corner : mesh.cornersAt(vertex))
      {
        around.push_back(TriangleMesh::faceOf(corner));
      }
    }
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  return around;
}

/// Every rank sends its faces among those asked for and around them, and what is around these, also
/// copies.
GatheredFaces gathered(const MeshPartition& part, const std::vector<Id>& faces)
{
  const TriangleMesh& mesh = part.mesh();
  std::vector<SentFace> sent;
  for (const Id face : withNeighbours(mesh, part.sendToOwners(withNeighbours(mesh, faces))))
  {
    sent.push_back(part.sentFace(face));
  }
  return GatheredFaces(valuesOfRanks(part.exchange(), sent));
}

} // anonymous namespace

GatheredFaces::GatheredFaces(std::vector<SentFace> faces)
{
  Tables tables;
  std::vector<GlobalId>& ids = tables.globalIds;
  std::sort(faces.begin(), faces.end());
  const auto isSame = [](const SentFace& a, const SentFace& b) { return !(a < b); };
  faces.erase(std::unique(faces.begin(), faces.end(), isSame), faces.end());
  for (const SentFace& face : faces)
  {
    tables.owners.push_back(face.owner);
    ids.insert(ids.end(), face.vertices.begin(), face.vertices.end());
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::vector<Vec3> points(ids.size());
  std::vector<Triangle> triangles(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      triangles[i][k] = indexIn(ids, faces[i].vertices[k]);
      points[triangles[i][k]] = faces[i].points[k];
    }
  }
  if (!triangles.empty())
  {
    tables.mesh = TriangleMesh(std::move(points), triangles);
  }
  this->tables_ = std::make_shared<Tables>(std::move(tables));
  this->mesh_ = &this->tables_->mesh;
}

Id GatheredFaces::faceAt(const RankAddress& face) const
{
  return this->tables_ ? indexIn(this->tables_->owners, face) : face.id;
}

Id GatheredFaces::vertexAt(GlobalId id) const
{
  return this->tables_ ? indexIn(this->tables_->globalIds, id) : static_cast<Id>(id);
}

ReplicatedPatch::ReplicatedPatch(const MeshPartition& part, const std::vector<Id>& faces)
  : GatheredFaces(part.isDistributed() ? gathered(part, faces) : GatheredFaces(part.mesh()))
{
}

}
