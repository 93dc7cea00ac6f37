// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_GlobalFaces_h
#define geodesic_GlobalFaces_h

#include "PolyData/reading/PolyDataSurface.h"
#include "Questions.h"

#include <algorithm>
#include <vector>

namespace geodesic
{

/// A face of the mesh of the whole surface, and the global numbers of the vertices at its corners.
struct GlobalFace
{
  RankAddress address{ -1, NoId };
  Triangle vertices{ NoId, NoId, NoId };

  bool isThere() const { return this->address.id != NoId; }
  /// Which of its corners is at a vertex; 3 if none is.
  Id cornerAt(Id vertex) const
  {
    return static_cast<Id>(
      std::find(this->vertices.begin(), this->vertices.end(), vertex) - this->vertices.begin());
  }
  /// Which of its edges has these vertices.
  Id edgeBetween(Id a, Id b) const
  {
    const Id k = this->cornerAt(a);
    return this->vertices[(k + 1) % 3] == b ? k : (k + 2) % 3;
  }
};

/// Finds the faces, of any rank, at vertices of this rank's points.
class GlobalFaces
{
public:
  /// All ranks call together, as for find().
  explicit GlobalFaces(const PolyDataSurface& surface)
    : surface_(surface.partition())
    , remote_(surface.remoteVertices())
  {
  }

  /// Calls visit(k, edge as find() takes it) for each edge k of a triangle whose ends have faces.
  template <typename Visit>
  void forEachEdgeWithFaces(const Triangle& t, Visit&& visit) const
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id next = t[(k + 1) % 3];
      if (this->hasFace(t[k]) && this->hasFace(next))
      {
        visit(k, Triangle{ t[k], next, next });
      }
    }
  }

  /// For each three vertices a face that has all of them. Of several faces at an edge one that this
  /// rank owns, if there is one.
  std::vector<GlobalFace> find(const std::vector<Triangle>& vertices) const
  {
    std::vector<GlobalFace> faces(vertices.size());
    Questions questions(this->surface_.exchange());
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      // Around a vertex all faces are known to this rank, or to the one that holds it.
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

  /// Of a vertex that PolyDataSurface::vertexOf() names: RemoteVertex::globalId, or that of the
  /// mesh, where it lies, and whether it has a face.
  Id globalId(Id vertex) const
  {
    return this->isRemote(vertex) ? this->remote(vertex).globalId : this->surface_.globalId(vertex);
  }
  Triangle globalIds(const Triangle& vertices) const
  {
    return { this->globalId(vertices[0]), this->globalId(vertices[1]),
      this->globalId(vertices[2]) };
  }
  const Vec3& position(Id vertex) const
  {
    return this->isRemote(vertex) ? this->remote(vertex).position
                                  : this->surface_.mesh().point(vertex);
  }
  bool hasFace(Id vertex) const
  {
    return this->isRemote(vertex) ? this->remote(vertex).holder.id != NoId
                                  : this->surface_.mesh().cornersAt(vertex).size() > 0;
  }

private:
  bool isRemote(Id vertex) const { return vertex >= this->surface_.mesh().numberOfVertices(); }
  const RemoteVertex& remote(Id vertex) const
  {
    return this->remote_[vertex - this->surface_.mesh().numberOfVertices()];
  }
  GlobalFace findAround(Id vertex, const Triangle& wanted) const
  {
    GlobalFace found;
    for (const Id corner : this->surface_.mesh().cornersAt(vertex))
    {
      const Id number = TriangleMesh::faceOf(corner);
      const GlobalFace face{ this->surface_.addressOf(number),
        this->globalIds(this->surface_.mesh().triangle(number)) };
      const bool hasAll =
        std::all_of(wanted.begin(), wanted.end(), [&face](Id id) { return face.cornerAt(id) < 3; });
      if ((!found.isThere() || this->surface_.isOwn(number)) && hasAll)
      {
        found = face;
      }
    }
    return found;
  }

  const MeshPartition& surface_;
  std::vector<RemoteVertex> remote_;
};

}

#endif
