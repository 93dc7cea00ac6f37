// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_GlobalFaces_h
#define geodesic_GlobalFaces_h

#include "PolyData/reading/PolyDataSurface.h"

#include <unordered_map>
#include <vector>

namespace geodesic
{

/// A face of the mesh of the whole surface, and its corners' vertices by PieceVertices::numbers.
struct FaceOfWhole
{
  RankAddress address{ -1, NoId };
  Triangle vertices{ NoId, NoId, NoId };

  bool isThere() const { return this->address.id != NoId; }
  /// Which of its corners is at a vertex; 3 where none is.
  Id cornerAt(Id vertex) const;
  /// Which of its edges is the one that was asked for.
  ///
  /// \param edge the numbers of GlobalFaces::edge().
  Id edgeOn(const Triangle& edge) const;
};

/// Finds the faces, of any rank, at vertices of a piece.
class GlobalFaces
{
public:
  /// All ranks call together, as for find().
  explicit GlobalFaces(const PolyDataSurface& surface);

  /// What to ask for to find a face at an edge.
  static Triangle edge(Id a, Id b) { return { a, b, b }; }

  /// For each three vertices a face that has all of them. Of several at an edge it is one that this
  /// rank owns, where there is such a one.
  std::vector<FaceOfWhole> find(const std::vector<Triangle>& vertices) const;

  Triangle numbersOf(const Triangle& vertices) const
  {
    const std::vector<Id>& numbers = this->vertices_.numbers;
    return { numbers[vertices[0]], numbers[vertices[1]], numbers[vertices[2]] };
  }
  const Vec3& position(Id vertex) const { return this->vertices_.positions[vertex]; }

private:
  FaceOfWhole faceOfWhole(Id face) const;
  FaceOfWhole findHere(const Triangle& vertices) const;
  FaceOfWhole findAround(Id vertex, const Triangle& wanted) const;
  RankAddress otherHolder(const Triangle& vertices) const;
  std::vector<Message> answer(std::vector<Message> questions) const;

  const MeshPartition& part_;
  /// Of each vertex that PolyDataSurface::vertexOf() names: what it is in the whole, and who owns
  /// faces there.
  PieceVertices vertices_;
  std::vector<RankAddress> holders_;
  std::unordered_map<Id, Id> haloVertices_;
};

}

#endif
