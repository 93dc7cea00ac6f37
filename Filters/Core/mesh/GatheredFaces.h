// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_GatheredFaces_h
#define geodesic_GatheredFaces_h

#include "mesh/MeshPartition.h"

#include <vector>

namespace geodesic
{

/// A face as one rank sends it to another.
struct SentFace
{
  RankAddress owner;
  /// The vertices' global numbers, and where they lie.
  Triangle vertices;
  std::array<Vec3, 3> points;

  bool operator<(const SentFace& other) const { return this->owner < other.owner; }
};

SentFace sentFace(const MeshPartition& part, Id face);

/// Faces of several ranks as a mesh of their own.
class GatheredFaces
{
public:
  /// \param faces ascending, each once; maybe none.
  explicit GatheredFaces(const std::vector<SentFace>& faces);

  /// Its faces stand in the order of the constructor's, its vertices in that of their global
  /// numbers. Empty where there are no faces.
  const TriangleMesh& mesh() const { return this->mesh_; }
  const RankAddress& ownerOf(Id face) const { return this->owners_[face]; }
  Id globalId(Id vertex) const { return this->globalIds_[vertex]; }
  /// A face of the mesh by its address, and a vertex by its global number; NoId where it is none.
  Id faceAt(const RankAddress& face) const;
  Id vertexAt(Id globalId) const;

private:
  TriangleMesh mesh_;
  std::vector<RankAddress> owners_;
  std::vector<Id> globalIds_;
};

}

#endif
