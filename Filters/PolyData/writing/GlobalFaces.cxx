// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/GlobalFaces.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

namespace
{

bool hasAll(const Triangle& face, const Triangle& wanted)
{
  return std::all_of(wanted.begin(), wanted.end(),
    [&face](Id vertex) { return std::find(face.begin(), face.end(), vertex) != face.end(); });
}

}

Id FaceOfWhole::cornerAt(Id vertex) const
{
  return static_cast<Id>(
    std::find(this->vertices.begin(), this->vertices.end(), vertex) - this->vertices.begin());
}

Id FaceOfWhole::edgeOn(const Triangle& edge) const
{
  Id k = 0;
  while (std::find(edge.begin(), edge.end(), this->vertices[(k + 2) % 3]) != edge.end())
  {
    ++k;
  }
  return k;
}

GlobalFaces::GlobalFaces(const PolyDataSurface& surface)
  : part_(surface.partition())
  , vertices_(surface.pieceVertices())
{
  const TriangleMesh& mesh = surface.mesh();
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    this->holders_.push_back({ this->part_.exchange().rank(), vertex });
  }
  for (Id vertex = this->part_.numberOfOwnVertices(); vertex < mesh.numberOfVertices(); ++vertex)
  {
    this->haloVertices_.emplace(this->vertices_.numbers[vertex], vertex);
  }
  surface.completeValues(RankAddress{ -1, NoId }, this->holders_);
}

std::vector<FaceOfWhole> GlobalFaces::find(const std::vector<Triangle>& vertices) const
{
  std::vector<FaceOfWhole> faces;
  faces.reserve(vertices.size());
  std::vector<Message> questions = this->part_.exchange().noMessages();
  std::vector<std::vector<std::size_t>> asked(questions.size());
  for (const Triangle& wanted : vertices)
  {
    faces.push_back(this->findHere(wanted));
    const RankAddress holder = this->otherHolder(wanted);
    if (!faces.back().isThere() && holder.id != NoId)
    {
      const auto rank = rankIndex(holder.rank);
      put(questions[rank], holder.id);
      put(questions[rank], this->numbersOf(wanted));
      asked[rank].push_back(faces.size() - 1);
    }
  }
  std::vector<std::size_t> next(asked.size(), 0);
  readEach(this->part_.exchange().step(this->answer(std::move(questions))),
    [&](int rank, MessageReader& reader)
    {
      const auto from = rankIndex(rank);
      faces[asked[from][next[from]++]] = reader.get<FaceOfWhole>();
    });
  return faces;
}

FaceOfWhole GlobalFaces::faceOfWhole(Id face) const
{
  return { this->part_.addressOf(face), this->numbersOf(this->part_.mesh().triangle(face)) };
}

/// A face of the part's mesh, owned or not.
FaceOfWhole GlobalFaces::findHere(const Triangle& vertices) const
{
  const Triangle wanted = this->numbersOf(vertices);
  for (const Id vertex : vertices)
  {
    if (vertex < this->part_.mesh().numberOfVertices())
    {
      return this->findAround(vertex, wanted); // the part has all faces around
    }
    const auto halo = this->haloVertices_.find(this->vertices_.numbers[vertex]);
    if (halo != this->haloVertices_.end())
    {
      const FaceOfWhole found = this->findAround(halo->second, wanted);
      if (found.isThere())
      {
        return found;
      }
    }
  }
  return {};
}

FaceOfWhole GlobalFaces::findAround(Id vertex, const Triangle& wanted) const
{
  FaceOfWhole found;
  for (const Id corner : this->part_.mesh().cornersAt(vertex))
  {
    const Id face = TriangleMesh::faceOf(corner);
    if ((!found.isThere() || this->part_.isOwn(face)) &&
      hasAll(this->numbersOf(this->part_.mesh().triangle(face)), wanted))
    {
      found = this->faceOfWhole(face);
    }
  }
  return found;
}

/// A rank that owns faces at one of the vertices, where that is another one, and the vertex's
/// number there: it has all faces around it.
RankAddress GlobalFaces::otherHolder(const Triangle& vertices) const
{
  for (const Id vertex : vertices)
  {
    if (this->holders_[vertex].rank >= 0 &&
      this->holders_[vertex].rank != this->part_.exchange().rank())
    {
      return this->holders_[vertex];
    }
  }
  return { -1, NoId };
}

std::vector<Message> GlobalFaces::answer(std::vector<Message> questions) const
{
  std::vector<Message> answers = this->part_.exchange().noMessages();
  readEach(this->part_.exchange().step(std::move(questions)),
    [&](int rank, MessageReader& reader)
    {
      const Id vertex = reader.get<Id>();
      put(answers[rankIndex(rank)], this->findAround(vertex, reader.get<Triangle>()));
    });
  return answers;
}

}
