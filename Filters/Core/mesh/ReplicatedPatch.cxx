// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/ReplicatedPatch.h"

#include <algorithm>

namespace geodesic
{

/// A face as it is sent to all ranks.
struct ReplicatedPatch::Face
{
  RankAddress owner;
  /// In the whole.
  Triangle vertices;
  std::array<Vec3, 3> points;
  std::uint8_t boundary;

  bool operator<(const Face& other) const { return this->owner < other.owner; }
};

ReplicatedPatch::ReplicatedPatch(const MeshPartition& part, const std::vector<Id>& faces)
  : part_(part)
{
  const std::vector<Face> gathered = this->gather(faces);
  for (const Face& face : gathered)
  {
    this->numberInWhole_.insert(
      this->numberInWhole_.end(), face.vertices.begin(), face.vertices.end());
  }
  std::sort(this->numberInWhole_.begin(), this->numberInWhole_.end());
  this->numberInWhole_.erase(std::unique(this->numberInWhole_.begin(), this->numberInWhole_.end()),
    this->numberInWhole_.end());
  std::vector<Vec3> points(this->numberInWhole_.size());
  std::vector<Triangle> triangles;
  for (const Face& face : gathered)
  {
    Triangle triangle;
    for (std::size_t k = 0; k < 3; ++k)
    {
      triangle[k] = static_cast<Id>(std::lower_bound(this->numberInWhole_.begin(),
                                      this->numberInWhole_.end(), face.vertices[k]) -
        this->numberInWhole_.begin());
      points[triangle[k]] = face.points[k];
    }
    triangles.push_back(triangle);
    this->owners_.push_back(face.owner);
    this->boundary_.push_back(face.boundary);
  }
  if (triangles.empty())
  {
    return;
  }
  this->mesh_ = TriangleMesh(std::move(points), triangles);

  const TriangleMesh& own = part.mesh();
  this->vertexOfPart_.assign(this->numberInWhole_.size(), NoId);
  for (Id face = 0; face < this->mesh_.numberOfFaces(); ++face)
  {
    const bool isOwn = this->owners_[face].rank == part.exchange().rank();
    this->faceOfPart_.push_back(isOwn ? this->owners_[face].id : part.copyOf(this->owners_[face]));
    for (std::size_t k = 0; k < 3 && isOwn; ++k)
    {
      this->vertexOfPart_[this->mesh_.triangle(face)[k]] = own.triangle(this->faceOfPart_[face])[k];
    }
  }
}

namespace
{

/// The faces around the vertices of some, and these: with copies, ascending.
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

/// The same of all ranks' faces: what is owned here of it.
std::vector<Id> ownWithNeighbours(const MeshPartition& part, const std::vector<Id>& faces)
{
  std::vector<Id> own;
  std::vector<Message> told = part.exchange().noMessages();
  for (const Id face : withNeighbours(part.mesh(), faces))
  {
    if (part.isOwn(face))
    {
      own.push_back(face);
      continue;
    }
    const RankAddress owner = part.ownerOf(face);
    put(told[rankIndex(owner.rank)], owner.id);
  }
  readEach(part.exchange().step(std::move(told)),
    [&](int, MessageReader& reader) { own.push_back(reader.get<Id>()); });
  return own;
}

} // anonymous namespace

// Every rank sends its faces among those asked for and around them, and what is around these, also
// copies.
std::vector<ReplicatedPatch::Face> ReplicatedPatch::gather(const std::vector<Id>& faces) const
{
  const TriangleMesh& mesh = this->part_.mesh();
  const std::vector<Id> around = withNeighbours(mesh, ownWithNeighbours(this->part_, faces));
  Message message;
  for (const Id id : around)
  {
    const bool isOwn = this->part_.isOwn(id);
    Face face = { this->part_.addressOf(id), {}, {}, 0 };
    for (Id k = 0; k < 3; ++k)
    {
      const Id vertex = mesh.triangle(id)[k];
      face.vertices[k] = this->part_.globalId(vertex);
      face.points[k] = mesh.point(vertex);
      face.boundary |=
        static_cast<std::uint8_t>(isOwn && mesh.isBoundary(3 * id + k) ? 1U << k : 0U);
    }
    put(message, face);
  }
  std::vector<Face> gathered;
  readEach(this->part_.exchange().tellAll(message),
    [&](int, MessageReader& reader) { gathered.push_back(reader.get<Face>()); });
  std::sort(gathered.begin(), gathered.end());
  // Of copies one face is left, which knows what its owner has said of the boundary.
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
  const auto found = std::lower_bound(this->owners_.begin(), this->owners_.end(), face);
  return found == this->owners_.end() || face < *found
    ? NoId
    : static_cast<Id>(found - this->owners_.begin());
}

Id ReplicatedPatch::vertexAt(Id globalId) const
{
  const auto found =
    std::lower_bound(this->numberInWhole_.begin(), this->numberInWhole_.end(), globalId);
  return found == this->numberInWhole_.end() || globalId < *found
    ? NoId
    : static_cast<Id>(found - this->numberInWhole_.begin());
}

}
