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

// Every rank sends its faces among those asked for and around them, and what is around these, also
// copies: of which one is left. Only the owner of a face says what of it is boundary.
std::vector<SentFace> gather(
  const MeshPartition& part, const std::vector<Id>& faces, std::vector<std::uint8_t>& boundary)
{
  struct Entry
  {
    SentFace face;
    std::uint8_t boundary;
  };
  const TriangleMesh& mesh = part.mesh();
  Message message;
  for (const Id face : withNeighbours(mesh, ownWithNeighbours(part, faces)))
  {
    Entry entry = { sentFace(part, face), 0 };
    for (Id k = 0; k < 3; ++k)
    {
      const bool isBoundary = part.isOwn(face) && mesh.isBoundary(3 * face + k);
      entry.boundary |= static_cast<std::uint8_t>(isBoundary ? 1U << k : 0U);
    }
    put(message, entry);
  }
  std::vector<Entry> gathered;
  readEach(part.exchange().tellAll(message),
    [&](int, MessageReader& reader) { gathered.push_back(reader.get<Entry>()); });
  std::sort(gathered.begin(), gathered.end(),
    [](const Entry& a, const Entry& b) { return a.face < b.face; });
  std::vector<SentFace> result;
  for (const Entry& entry : gathered)
  {
    if (result.empty() || result.back() < entry.face)
    {
      result.push_back(entry.face);
      boundary.push_back(0);
    }
    boundary.back() |= entry.boundary;
  }
  return result;
}

} // anonymous namespace

ReplicatedPatch::Tables::Tables(const MeshPartition& part, const std::vector<Id>& asked)
  : faces(gather(part, asked, this->boundary))
{
  const TriangleMesh& mesh = this->faces.mesh();
  this->vertexOfPart.assign(mesh.numberOfVertices(), NoId);
  for (Id face = 0; face < mesh.numberOfFaces(); ++face)
  {
    const Id ofPart = part.faceAt(this->faces.ownerOf(face));
    this->faceOfPart.push_back(ofPart);
    for (std::size_t k = 0; k < 3 && ofPart != NoId && part.isOwn(ofPart); ++k)
    {
      this->vertexOfPart[mesh.triangle(face)[k]] = part.mesh().triangle(ofPart)[k];
    }
  }
}

ReplicatedPatch::ReplicatedPatch(const MeshPartition& part, const std::vector<Id>& faces)
  : tables_(part.isDistributed() ? std::make_shared<Tables>(part, faces) : nullptr)
  , mesh_(tables_ ? &tables_->faces.mesh() : &part.mesh())
{
}

}
