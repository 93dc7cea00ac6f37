// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/GlobalFaces.h"

#include "Questions.h"

#include <algorithm>

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

Id GlobalFace::cornerAt(Id vertex) const
{
  return static_cast<Id>(
    std::find(this->vertices.begin(), this->vertices.end(), vertex) - this->vertices.begin());
}

Id GlobalFace::edgeBetween(Id a, Id b) const
{
  const Id k = this->cornerAt(a);
  return this->vertices[(k + 1) % 3] == b ? k : (k + 2) % 3;
}

GlobalFaces::GlobalFaces(const PolyDataSurface& surface)
  : surface_(surface.partition())
  , remote_(surface.remoteVertices())
{
}

// Around a vertex all faces are known to this rank, or to the one that holds it.
std::vector<GlobalFace> GlobalFaces::find(const std::vector<Triangle>& vertices) const
{
  std::vector<GlobalFace> faces(vertices.size());
  Questions questions(this->surface_.exchange());
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const Triangle& wanted = vertices[i];
    const auto here = std::find_if(
      wanted.begin(), wanted.end(), [this](Id vertex) { return !this->isRemote(vertex); });
    const auto held = std::find_if(wanted.begin(), wanted.end(),
      [this](Id vertex) { return this->isRemote(vertex) && this->hasFace(vertex); });
    if (here != wanted.end())
    {
      faces[i] = this->findAround(*here, this->globalIds(wanted));
    }
    else if (held != wanted.end())
    {
      const RankAddress& holder = this->remote(*held).holder;
      questions.ask(holder.rank, i, holder.id, this->globalIds(wanted));
    }
  }
  questions.exchangeAnswers(
    [this](MessageReader& question, Message& answer)
    {
      const Id vertex = question.get<Id>();
      put(answer, this->findAround(vertex, question.get<Triangle>()));
    },
    [&faces](std::size_t i, MessageReader& answer) { faces[i] = answer.get<GlobalFace>(); });
  return faces;
}

GlobalFace GlobalFaces::findAround(Id vertex, const Triangle& wanted) const
{
  GlobalFace found;
  for (const Id corner : this->surface_.mesh().cornersAt(vertex))
  {
    const Id face = TriangleMesh::faceOf(corner);
    const Triangle vertices = this->globalIds(this->surface_.mesh().triangle(face));
    if ((!found.isThere() || this->surface_.isOwn(face)) && hasAll(vertices, wanted))
    {
      found = { this->surface_.addressOf(face), vertices };
    }
  }
  return found;
}

}
