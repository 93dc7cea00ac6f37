// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinedFaces_h
#define geodesic_RefinedFaces_h

#include "field/DistanceField.h"
#include "refinement/CutEdges.h"
#include "refinement/FaceTriangles.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

/// The faces of this rank under refinement. Each face is triangulated by itself; what it shares
/// with others are the points on its edges.
struct RefinedFaces
{
  /// All arguments must outlive this.
  ///
  /// \param isFrozen for each face, not 0 if this rank does not refine it.
  RefinedFaces(const DistanceField& refined, const std::vector<std::uint8_t>& isFrozen)
    : field(refined)
    , edges(refined.mesh())
    , ofFace(refined.mesh().numberOfFaces(), NoId)
    , isFrozen_(isFrozen)
  {
  }

  bool isFrozen(Id face) const { return this->isFrozen_[face] != 0; }

  /// Begins the triangulation of a face; its edges get numbers.
  void open(Id face)
  {
    const TriangleMesh& mesh = this->field.mesh();
    const Id longest = longestHalfedge(mesh, face); // the plane of FaceDistance
    std::array<FaceTriangles::Point, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
    {
      corners[k].weights = cornerWeights(k);
      corners[k].place = inHalfedgeFrame(mesh, longest, corners[k].weights);
      corners[k].number = mesh.triangle(face)[k];
      corners[k].distance = this->field.vertexDistances()[corners[k].number];
      corners[k].here = corners[k].distance; // a corner is among its faces' candidates
      this->edges.ensure(TriangleMesh::halfedgeOf(face, k));
    }
    this->ofFace[face] = static_cast<Id>(this->open_.size());
    this->open_.emplace_back(face, corners);
  }
  bool isOpen(Id face) const { return this->ofFace[face] != NoId; }
  FaceTriangles& triangles(Id face) { return this->open_[this->ofFace[face]]; }
  const FaceTriangles& triangles(Id face) const { return this->open_[this->ofFace[face]]; }
  const std::vector<FaceTriangles>& openFaces() const { return this->open_; }
  std::vector<FaceTriangles>& openFaces() { return this->open_; }

  const DistanceField& field;
  CutEdges edges;
  /// For each face its number among the open ones; NoId where none is needed.
  std::vector<Id> ofFace;

private:
  const std::vector<std::uint8_t>& isFrozen_;
  std::vector<FaceTriangles> open_;
};

}

#endif
