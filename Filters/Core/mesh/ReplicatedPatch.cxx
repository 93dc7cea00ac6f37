// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/ReplicatedPatch.h"

#include <algorithm>

namespace geodesic
{

/// A face as sent to all ranks.
struct ReplicatedPatch::Face
{
  RankAddress owner;
  /// Global ids.
  Triangle vertices;
  std::array<Vec3, 3> points;
  std::uint8_t boundary;

  bool operator<(const Face& other) const { return this->owner < other.owner; }
};

ReplicatedPatch::ReplicatedPatch(const MeshPartition& part, const std::vector<Id>& faces)
  : tables_(part.isDistributed() ? std::make_shared<Tables>(part, faces) : nullptr)
  , mesh_(tables_ ? &tables_->mesh : &part.mesh())
{
}

ReplicatedPatch::Tables::Tables(const MeshPartition& part, const std::vector<Id>& faces)
{
  const std::vector<Face> gathered = gather(part, faces);
  for (const Face& face : gathered)
  {
    this->globalIds.insert(this->globalIds.end(), face.vertices.begin(), face.vertices.end());
  }
  std::sort(this->globalIds.begin(), this->globalIds.end());
  this->globalIds.erase(
    std::unique(this->globalIds.begin(), this->globalIds.end()), this->globalIds.end());
  std::vector<Vec3> points(this->globalIds.size());
  std::vector<Triangle> triangles;
  for (const Face& face : gathered)
  {
    Triangle triangle;
    for (std::size_t k = 0; k < 3; ++k)
    {
      triangle[k] = static_cast<Id>(
        std::lower_bound(this->globalIds.begin(), this->globalIds.end(), face.vertices[k]) -
        this->globalIds.begin());
      points[triangle[k]] = face.points[k];
    }
    triangles.push_back(triangle);
    this->owners.push_back(face.owner);
    this->boundary.push_back(face.boundary);
  }
  if (triangles.empty())
  {
    return;
  }
  this->mesh = TriangleMesh(std::move(points), triangles);

  const TriangleMesh& own = part.mesh();
  this->vertexOfPart.assign(this->globalIds.size(), NoId);
  for (Id face = 0; face < this->mesh.numberOfFaces(); ++face)
  {
    const bool isOwn = this->owners[face].rank == part.exchange().rank();
    this->faceOfPart.push_back(isOwn ? this->owners[face].id : part.copyOf(this->owners[face]));
    for (std::size_t k = 0; k < 3 && isOwn; ++k)
    {
      this->vertexOfPart[this->mesh.triangle(face)[k]] = own.triangle(this->faceOfPart[face])[k];
    }
  }
}

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

/// The same for all ranks' faces together, restricted to faces that this rank owns.
std::vector<Id> ownWithNeighbours(const MeshPartition& part, const std::vector<Id>& faces)
{
  std::vector<Id> own;
  std::vector<Message> messages = part.exchange().noMessages();
  for (const Id face : withNeighbours(part.mesh(), faces))
  {
    if (part.isOwn(face))
    {
      own.push_back(face);
      continue;
    }
    const RankAddress owner = part.ownerOf(face);
    put(messages[rankIndex(owner.rank)], owner.id);
  }
  readEach(part.exchange().step(std::move(messages)),
    [&](int, MessageReader& reader) { own.push_back(reader.get<Id>()); });
  return own;
}

} // anonymous namespace

// Every rank sends its own faces among the requested ones and their neighbours, together with the
// faces around these, including copies.
std::vector<ReplicatedPatch::Face> ReplicatedPatch::gather(
  const MeshPartition& part, const std::vector<Id>& faces)
{
  const TriangleMesh& mesh = part.mesh();
  const std::vector<Id> around = withNeighbours(mesh, ownWithNeighbours(part, faces));
  Message message;
  for (const Id id : around)
  {
    const bool isOwn = part.isOwn(id);
    Face face = { part.addressOf(id), {}, {}, 0 };
    for (Id k = 0; k < 3; ++k)
    {
      const Id vertex = mesh.triangle(id)[k];
      face.vertices[k] = part.globalId(vertex);
      face.points[k] = mesh.point(vertex);
      face.boundary |=
        static_cast<std::uint8_t>(isOwn && mesh.isBoundary(3 * id + k) ? 1U << k : 0U);
    }
    put(message, face);
  }
  std::vector<Face> gathered;
  readEach(part.exchange().tellAll(message),
    [&](int, MessageReader& reader) { gathered.push_back(reader.get<Face>()); });
  std::sort(gathered.begin(), gathered.end());
  // If there are copies, the one from the owner is kept, which has the right boundary.
  std::vector<Face> result;
  for (const Face& face : gathered)
  {
    if (!result.empty() && !(result.back() < face))
    {
      result.back().boundary |= face.boundary;
      continue;
    }
    result.push_back(face);
  }
  return result;
}

Id ReplicatedPatch::faceAt(const RankAddress& face) const
{
  if (!this->tables_)
  {
    return face.id;
  }
  const std::vector<RankAddress>& owners = this->tables_->owners;
  const auto found = std::lower_bound(owners.begin(), owners.end(), face);
  return found == owners.end() || face < *found ? NoId : static_cast<Id>(found - owners.begin());
}

Id ReplicatedPatch::vertexAt(Id globalId) const
{
  if (!this->tables_)
  {
    return globalId;
  }
  const std::vector<Id>& ids = this->tables_->globalIds;
  const auto found = std::lower_bound(ids.begin(), ids.end(), globalId);
  return found == ids.end() || globalId < *found ? NoId : static_cast<Id>(found - ids.begin());
}

}
