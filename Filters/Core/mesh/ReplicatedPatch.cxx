// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/ReplicatedPatch.h"

#include <algorithm>
#include <numeric>

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

/// A face of the patch, and a bit for each of its halfedges on the boundary.
struct FaceOfPatch : SentFace
{
  std::uint8_t boundary;
};

// Every rank sends its faces among those asked for and around them, and what is around these, also
// copies. Only the owner of a face says what of it is boundary.
std::vector<FaceOfPatch> gather(const MeshPartition& part, const std::vector<Id>& faces)
{
  const TriangleMesh& mesh = part.mesh();
  std::vector<FaceOfPatch> own;
  for (const Id face : withNeighbours(mesh, part.sendToOwners(withNeighbours(mesh, faces))))
  {
    FaceOfPatch entry = { part.sentFace(face), 0 };
    for (Id k = 0; k < 3; ++k)
    {
      const bool isBoundary =
        part.isOwn(face) && mesh.isBoundary(TriangleMesh::halfedgeOf(face, k));
      entry.boundary |= static_cast<std::uint8_t>(isBoundary ? 1U << k : 0U);
    }
    own.push_back(entry);
  }
  return valuesOfRanks(part.exchange(), own);
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
  : GatheredFaces(part.mesh())
  , faces_(faces)
{
  if (!part.isDistributed())
  {
    return;
  }
  const std::vector<FaceOfPatch> gathered = gather(part, faces);
  static_cast<GatheredFaces&>(*this) =
    GatheredFaces(std::vector<SentFace>(gathered.begin(), gathered.end()));
  OnThisRank known;
  known.boundary.assign(this->mesh().numberOfFaces(), 0);
  for (const FaceOfPatch& entry : gathered)
  {
    known.boundary[this->faceAt(entry.owner)] |= entry.boundary;
  }
  known.vertexOfPart.assign(this->mesh().numberOfVertices(), NoId);
  for (Id face = 0; face < this->mesh().numberOfFaces(); ++face)
  {
    const Id ofPart = part.faceAt(this->ownerOf(face));
    known.faceOfPart.push_back(ofPart);
    for (std::size_t k = 0; k < 3 && ofPart != NoId; ++k)
    {
      const Id vertex = part.mesh().triangle(ofPart)[k];
      Id& found = known.vertexOfPart[this->mesh().triangle(face)[k]];
      found = vertex < part.numberOfOwnVertices() ? vertex : found;
    }
  }
  this->onThisRank_ = std::make_shared<OnThisRank>(std::move(known));
  this->faces_.resize(this->mesh().numberOfFaces());
  std::iota(this->faces_.begin(), this->faces_.end(), Id(0));
}

}
