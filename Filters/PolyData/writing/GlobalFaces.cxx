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
  const Id end = surface.mesh().numberOfVertices();
  for (Id vertex = this->surface_.numberOfOwnVertices(); vertex < end; ++vertex)
  {
    this->haloVertices_.emplace(this->surface_.globalId(vertex), vertex);
  }
}

std::vector<GlobalFace> GlobalFaces::find(const std::vector<Triangle>& vertices) const
{
  std::vector<GlobalFace> faces;
  faces.reserve(vertices.size());
  Questions questions(this->surface_.exchange());
  for (const Triangle& wanted : vertices)
  {
    faces.push_back(this->findHere(wanted));
    const RemoteVertex* held = this->heldElsewhere(wanted);
    if (!faces.back().isThere() && held)
    {
      questions.ask(held->holder.rank, faces.size() - 1, held->holder.id, this->globalIds(wanted));
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

/// A face of the mesh here, owned or not.
GlobalFace GlobalFaces::findHere(const Triangle& vertices) const
{
  const Triangle wanted = this->globalIds(vertices);
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (!this->isRemote(vertices[k]))
    {
      return this->findAround(vertices[k], wanted); // the mesh has all faces around
    }
    const auto halo = this->haloVertices_.find(wanted[k]);
    if (halo != this->haloVertices_.end())
    {
      const GlobalFace found = this->findAround(halo->second, wanted);
      if (found.isThere())
      {
        return found;
      }
    }
  }
  return {};
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

/// A vertex with faces on another rank, which has all faces around it.
const RemoteVertex* GlobalFaces::heldElsewhere(const Triangle& vertices) const
{
  for (const Id vertex : vertices)
  {
    if (this->isRemote(vertex) && this->hasFace(vertex))
    {
      return &this->remote(vertex);
    }
  }
  return nullptr;
}

}
