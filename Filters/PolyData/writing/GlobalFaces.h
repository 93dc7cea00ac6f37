// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_GlobalFaces_h
#define geodesic_GlobalFaces_h

#include "PolyData/reading/PolyDataSurface.h"
#include "Questions.h"

#include <algorithm>
#include <vector>

namespace geodesic
{

/// Which corner of a triangle is at a vertex; 3 if none is.
inline Id cornerAt(const Triangle& triangle, Id vertex)
{
  return static_cast<Id>(std::find(triangle.begin(), triangle.end(), vertex) - triangle.begin());
}

/// A face of the mesh of the whole surface, and the global numbers of the vertices at its corners.
struct GlobalFace
{
  RankAddress address{ -1, NoId };
  Triangle vertices{ NoId, NoId, NoId };

  bool isThere() const { return this->address.id != NoId; }
  /// Which of its edges has these vertices.
  Id edgeBetween(Id a, Id b) const
  {
    const Id k = cornerAt(this->vertices, a);
    return this->vertices[(k + 1) % 3] == b ? k : (k + 2) % 3;
  }
};

/// Finds the faces, of any rank, at vertices of this rank's points.
class GlobalFaces
{
public:
  /// All ranks call together, as for find().
  explicit GlobalFaces(const PolyDataSurface& surface)
    : surface_(surface)
    , remote_(surface.remoteVertices())
  {
  }

  /// A vertex that PolyDataSurface::vertexOf() names.
  GlobalVertex vertex(Id number) const
  {
    const Id inMesh = this->surface_.mesh().numberOfVertices();
    return number < inMesh ? this->surface_.vertexOfMesh(number) : this->remote_[number - inMesh];
  }
  Triangle globalIds(const Triangle& t) const
  {
    return { this->vertex(t[0]).globalId, this->vertex(t[1]).globalId,
      this->vertex(t[2]).globalId };
  }

  /// Calls visit(k, edge as find() takes it) for each edge k of a triangle whose ends have faces.
  template <typename Visit>
  void forEachEdgeWithFaces(const Triangle& t, Visit&& visit) const
  {
    const auto hasFace = [this](Id number) { return this->vertex(number).holder.id != NoId; };
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id next = t[(k + 1) % 3];
      if (hasFace(t[k]) && hasFace(next))
      {
        visit(k, Triangle{ t[k], next, next });
      }
    }
  }

  /// For each three vertices a face that has all of them. Of several faces at an edge one that this
  /// rank owns, if there is one.
  std::vector<GlobalFace> find(const std::vector<Triangle>& vertices) const
  {
    Exchange& exchange = this->surface_.exchange();
    std::vector<GlobalFace> faces(vertices.size());
    Questions questions(exchange);
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      // All faces around a vertex are known to a rank that has some of them: to this one, best.
      RankAddress asked{ -1, NoId };
      for (const Id number : vertices[i])
      {
        const RankAddress holder = this->vertex(number).holder;
        if (holder.id != NoId &&
          (asked.id == NoId || (holder.rank == exchange.rank() && asked.rank != exchange.rank())))
        {
          asked = holder;
        }
      }
      if (asked.id != NoId)
      {
        questions.ask(asked.rank, i, asked.id, this->globalIds(vertices[i]));
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

private:
  GlobalFace findAround(Id vertex, const Triangle& wanted) const
  {
    const MeshPartition& partition = this->surface_.partition;
    GlobalFace found;
    for (const Id corner : partition.mesh().cornersAt(vertex))
    {
      const Id number = TriangleMesh::faceOf(corner);
      const GlobalFace face{ partition.addressOf(number),
        this->globalIds(partition.mesh().triangle(number)) };
      const bool hasAll = std::all_of(
        wanted.begin(), wanted.end(), [&face](Id id) { return cornerAt(face.vertices, id) < 3; });
      if ((!found.isThere() || partition.isOwn(number)) && hasAll)
      {
        found = face;
      }
    }
    return found;
  }

  const PolyDataSurface& surface_;
  std::vector<GlobalVertex> remote_;
};

}

#endif
