// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/UnmeshedTriangles.h"

#include "Questions.h"

#include <cstdint>
#include <utility>

namespace geodesic
{

UnmeshedTriangles::UnmeshedTriangles(const PolyDataSurface& surface)
  : surface_(surface)
{
  const MeshPartition& partition = surface.partition;
  std::vector<std::uint8_t> isFace(surface.numberOfParts, 0);
  for (Id face = partition.firstOwnFace(); face < partition.endOfOwnFaces(); ++face)
  {
    isFace[surface.partOf(face)] = 1;
  }
  for (Id part = 0; part < isFace.size(); ++part)
  {
    if (isFace[part] == 0)
    {
      this->triangles_.push_back({ part });
    }
  }
  if (this->areOnAnyRank())
  {
    this->remote_ = surface.remoteVertices();
    this->findFaces();
  }
}

void UnmeshedTriangles::findFaces()
{
  const int rank = this->surface_.exchange().rank();
  Questions questions(this->surface_.exchange());
  for (std::size_t i = 0; i < this->triangles_.size(); ++i)
  {
    UnmeshedTriangle& triangle = this->triangles_[i];
    const Triangle numbers = this->surface_.verticesAt(triangle.part);
    std::array<RankAddress, 3> holders;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const GlobalVertex vertex = this->vertex(numbers[k]);
      triangle.vertices[k] = vertex.globalId;
      holders[k] = vertex.holder;
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t next = (k + 1) % 3;
      if (numbers[k] != numbers[next] && holders[k].id != NoId && holders[next].id != NoId)
      {
        // A rank with some of the faces around a vertex knows all of them: this rank, if possible.
        const bool isNextHere = holders[k].rank != rank && holders[next].rank == rank;
        const RankAddress& asked = holders[isNextHere ? next : k];
        questions.ask(asked.rank, 3 * i + k, asked.id,
          Triangle{
            triangle.vertices[k], triangle.vertices[next], triangle.vertices[(k + 2) % 3] });
      }
    }
  }
  questions.exchangeAnswers(
    [this](MessageReader& question, Message& answer)
    {
      const Id vertex = question.get<Id>();
      put(answer, this->faceAround(vertex, question.get<Triangle>()));
    },
    [this](std::size_t i, MessageReader& answer)
    { this->triangles_[i / 3].faces[i % 3] = answer.get<GlobalFace>(); });
  for (UnmeshedTriangle& triangle : this->triangles_)
  {
    if (triangle.isOnFace())
    {
      triangle.faces[1] = triangle.faces[2] = {};
    }
  }
}

// A face on all three vertices is best, then one that the rank owns.
GlobalFace UnmeshedTriangles::faceAround(Id vertex, const Triangle& wanted) const
{
  const MeshPartition& partition = this->surface_.partition;
  const auto idOf = [&partition](Id corner) { return static_cast<Id>(partition.globalId(corner)); };
  GlobalFace found;
  int best = -1;
  for (const Id corner : partition.mesh().cornersAt(vertex))
  {
    const Id number = TriangleMesh::faceOf(corner);
    const auto& [a, b, c] = partition.mesh().triangle(number);
    const GlobalFace face{ partition.addressOf(number), { idOf(a), idOf(b), idOf(c) } };
    const int order = (face.hasVertex(wanted[2]) ? 2 : 0) + (partition.isOwn(number) ? 1 : 0);
    if (order > best && face.hasVertex(wanted[0]) && face.hasVertex(wanted[1]))
    {
      found = face;
      best = order;
    }
  }
  return found;
}

// The owner of the face at the edge counts the triangle.
std::unordered_map<Id, Id> UnmeshedTriangles::countAtEdges() const
{
  Exchange& exchange = this->surface_.exchange();
  std::vector<Message> messages = exchange.noMessages();
  for (const UnmeshedTriangle& triangle : this->triangles_)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const GlobalFace& face = triangle.faces[k];
      if (face.isThere() && !triangle.isOnFace() && !this->surface_.isCopy(triangle.part))
      {
        const Id edge = face.edgeBetween(triangle.vertices[k], triangle.vertices[(k + 1) % 3]);
        put(
          messages[rankIndex(face.address.rank)], TriangleMesh::halfedgeOf(face.address.id, edge));
      }
    }
  }
  std::unordered_map<Id, Id> count;
  readEach(exchange.step(std::move(messages)),
    [&](int, MessageReader& reader) { ++count[this->surface_.mesh().edgeOf(reader.get<Id>())]; });
  return count;
}

}
