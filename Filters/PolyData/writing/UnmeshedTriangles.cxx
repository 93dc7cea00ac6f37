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
    const Triangle numbers = this->surface_.verticesAt(this->triangles_[i].part);
    const std::array<GlobalVertex, 3> corners = { this->vertex(numbers[0]),
      this->vertex(numbers[1]), this->vertex(numbers[2]) };
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t next = (k + 1) % 3;
      const RankAddress& here = corners[k].holder;
      const RankAddress& there = corners[next].holder;
      if (numbers[k] != numbers[next] && here.id != NoId && there.id != NoId)
      {
        // A rank with some of the faces around a vertex knows all of them: this rank, if possible.
        const RankAddress& asked = here.rank != rank && there.rank == rank ? there : here;
        questions.ask(asked.rank, 3 * i + k, asked.id,
          GlobalTriangle{ corners[0].globalId, corners[1].globalId, corners[2].globalId }, k);
      }
    }
  }
  questions.exchangeAnswers(
    [this](MessageReader& question, Message& answer)
    {
      const Id vertex = question.get<Id>();
      const auto ids = question.get<GlobalTriangle>();
      put(answer, this->faceAround(vertex, ids, question.get<std::size_t>()));
    },
    [this](std::size_t i, MessageReader& answer)
    { this->triangles_[i / 3].faces[i % 3] = answer.get<FaceAtEdge>(); });
  for (UnmeshedTriangle& triangle : this->triangles_)
  {
    if (triangle.isOnFace())
    {
      triangle.faces[1] = triangle.faces[2] = {};
    }
  }
}

// A face on all three vertices is best, then one that the rank owns.
FaceAtEdge UnmeshedTriangles::faceAround(Id vertex, const GlobalTriangle& ids, std::size_t k) const
{
  const MeshPartition& partition = this->surface_.partition;
  const std::size_t next = (k + 1) % 3;
  FaceAtEdge found;
  int best = -1;
  for (const Id corner : partition.mesh().cornersAt(vertex))
  {
    const Id number = TriangleMesh::faceOf(corner);
    FaceAtEdge face{ partition.addressOf(number) };
    // If the third corner is at an end of the edge, the end counts: it comes later.
    for (const std::size_t own : { (k + 2) % 3, next, k })
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        const bool isThere = partition.globalId(partition.mesh().triangle(number)[i]) == ids[own];
        face.corners[i] = isThere ? static_cast<Id>(own) : face.corners[i];
      }
    }
    const bool isOnAll = face.find(FaceAtEdge::None) == FaceAtEdge::None;
    const int order = (isOnAll ? 2 : 0) + (partition.isOwn(number) ? 1 : 0);
    if (order > best && face.find(k) != FaceAtEdge::None && face.find(next) != FaceAtEdge::None)
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
      const FaceAtEdge& face = triangle.faces[k];
      if (face.isThere() && !triangle.isOnFace() && !this->surface_.isCopy(triangle.part))
      {
        put(messages[rankIndex(face.address.rank)],
          TriangleMesh::halfedgeOf(face.address.id, face.edge(k)));
      }
    }
  }
  std::unordered_map<Id, Id> count;
  readEach(exchange.step(std::move(messages)),
    [&](int, MessageReader& reader) { ++count[this->surface_.mesh().edgeOf(reader.get<Id>())]; });
  return count;
}

}
