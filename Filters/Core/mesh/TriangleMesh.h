// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TriangleMesh_h
#define geodesic_TriangleMesh_h

#include "Job.h"
#include "Tolerance.h"
#include "Types.h"
#include "mesh/FaceShape.h"

#include <algorithm>
#include <vector>

namespace geodesic
{

/// An indexed triangle mesh of any topology: with boundary, several components, edges of three and
/// more faces, bow-tie vertices, inconsistent orientation.
///
/// A halfedge is one edge of one face, numbered 3 * face + k for the edge from corner k to corner k
/// + 1 (mod 3). A corner has the number of the halfedge that begins there. The halfedges of one
/// edge are siblings (after geometry-central) and form a circular list (nextSibling): a boundary
/// edge has one halfedge, an inner edge two, a non-manifold edge more; siblings may run in either
/// direction. The mesh stores no other topology.
class TriangleMesh
{
public:
  /// A mesh without vertices and faces: the partition of a rank that has none.
  TriangleMesh() = default;

  /// Builds the mesh. Each point becomes a vertex; the caller has already merged coincident points.
  /// Faces that name a vertex twice, or the same three vertices as an earlier face, are left out.
  /// A face without area gets a height that changes no length: paths may run along its edges, but
  /// the surface must not go on behind it (removeFacesWithoutArea).
  ///
  /// \param points coordinates, finite.
  /// \param triangles three vertex ids a face, in any orientation.
  /// \throws MeshError if no face is left, an id is out of range or a coordinate is not finite;
  /// MeshTooLarge; Aborted.
  TriangleMesh(
    std::vector<Vec3> points, const std::vector<Triangle>& triangles, const Job& job = {});

  Id numberOfVertices() const { return static_cast<Id>(this->points_.size()); }
  Id numberOfFaces() const { return static_cast<Id>(this->faces_.size()); }
  Id numberOfHalfedges() const { return 3 * this->numberOfFaces(); }
  /// Edges of three and more faces.
  Id numberOfNonManifoldEdges() const { return this->numberOfNonManifoldEdges_; }

  const Vec3& point(Id vertex) const { return this->points_[vertex]; }
  const Triangle& triangle(Id face) const { return this->faces_[face].corners; }
  const FaceShape& shape(Id face) const { return this->faces_[face].shape; }
  /// The index of this face in the constructor's `triangles`.
  Id inputFace(Id face) const { return this->inputFaces_.empty() ? face : this->inputFaces_[face]; }
  /// The first face made of this one of the constructor's `triangles` or a later one.
  Id firstFaceFrom(Id input) const;

  static Id faceOf(Id halfedge) { return halfedge / 3; }
  /// Which halfedge of its face it is: 0, 1 or 2.
  static Id indexInFace(Id halfedge) { return halfedge % 3; }
  static Id halfedgeOf(Id face, std::size_t index) { return 3 * face + static_cast<Id>(index); }
  static std::array<Id, 3> halfedgesOf(Id face) { return { 3 * face, 3 * face + 1, 3 * face + 2 }; }
  /// The same halfedge of a copy of its face, which ranks number differently.
  static Id inCopy(Id halfedge, Id copy) { return halfedgeOf(copy, indexInFace(halfedge)); }
  /// The next halfedge of the same face, which begins at this one's end.
  static Id nextInFace(Id halfedge)
  {
    return indexInFace(halfedge) == 2 ? halfedge - 2 : halfedge + 1;
  }
  static Id previousInFace(Id halfedge)
  {
    return indexInFace(halfedge) == 0 ? halfedge + 2 : halfedge - 1;
  }
  /// Their indices in the face.
  static Id nextIndex(Id halfedge)
  {
    const Id k = indexInFace(halfedge);
    return k == 2 ? 0 : k + 1;
  }
  static Id previousIndex(Id halfedge)
  {
    const Id k = indexInFace(halfedge);
    return k == 0 ? 2 : k - 1;
  }

  /// The next halfedge of the same edge; the halfedge itself on a boundary edge.
  Id nextSibling(Id halfedge) const
  {
    return this->faces_[faceOf(halfedge)].nextSibling[indexInFace(halfedge)];
  }
  bool isBoundary(Id halfedge) const { return this->nextSibling(halfedge) == halfedge; }
  /// Whether the halfedge's edge has exactly two faces.
  bool isInner(Id halfedge) const
  {
    const Id other = this->nextSibling(halfedge);
    return other != halfedge && this->nextSibling(other) == halfedge;
  }
  Id origin(Id halfedge) const
  {
    return this->faces_[faceOf(halfedge)].corners[indexInFace(halfedge)];
  }
  Id destination(Id halfedge) const
  {
    return this->faces_[faceOf(halfedge)].corners[nextIndex(halfedge)];
  }
  /// The vertex opposite the halfedge in its face.
  Id opposite(Id halfedge) const
  {
    return this->faces_[faceOf(halfedge)].corners[previousIndex(halfedge)];
  }
  double length(Id halfedge) const
  {
    return this->faces_[faceOf(halfedge)].shape.length[indexInFace(halfedge)];
  }
  /// The other halfedge of an edge with two faces of the same orientation; otherwise NoId.
  Id acrossOriented(Id halfedge) const
  {
    const Id other = this->nextSibling(halfedge);
    const bool isOpposed =
      this->isInner(halfedge) && this->origin(other) == this->destination(halfedge);
    return isOpposed ? other : NoId;
  }
  /// The halfedge of a face on the edge of the given halfedge; there must be one.
  Id siblingInFace(Id halfedge, Id face) const
  {
    while (faceOf(halfedge) != face)
    {
      halfedge = this->nextSibling(halfedge);
    }
    return halfedge;
  }
  /// The corner of a face at a vertex of the face, as the halfedge that begins there.
  Id cornerAt(Id face, Id vertex) const
  {
    Id corner = halfedgeOf(face, 0);
    while (this->origin(corner) != vertex)
    {
      ++corner;
    }
    return corner;
  }
  /// The lowest-numbered halfedge of the edge, which identifies the edge.
  Id edgeOf(Id halfedge) const;
  /// A halfedge of the edge between two vertices, in either direction; NoId if there is none.
  Id halfedgeBetween(Id a, Id b) const;

  /// The corners at a vertex.
  IdRange cornersAt(Id vertex) const
  {
    const Id* data = this->corners_.data();
    return { data + this->cornerStart_[vertex], data + this->cornerStart_[vertex + 1] };
  }
  /// The angle of a face at a corner, in radians.
  double cornerAngle(Id corner) const;

  /// Why a geodesic may bend at a vertex, which makes it a pseudo-source (paper, section 3).
  enum class PseudoSource : std::uint8_t
  {
    None,
    /// One fan of faces, whose total angle exceeds 2 pi, on the boundary pi.
    Saddle,
    /// Several fans, an edge of three and more faces, or another vertex so close that rounding
    /// turns its rays past this one: angles do not decide.
    Irregular
  };
  PseudoSource pseudoSource(Id vertex) const { return this->pseudoSource_[vertex]; }

  /// The number of the connected component (by shared vertices) of each vertex. Every call walks
  /// the whole mesh.
  std::vector<Id> components() const;

  /// Prefetches a face. The faces along a front are scattered over the memory.
  void prefetch(Id face) const { geodesic::prefetch(this->faces_.data() + face); }

private:
  /// The data of a face, stored together because they are used together.
  struct Face
  {
    Triangle corners;
    /// The next sibling of each halfedge.
    std::array<Id, 3> nextSibling;
    FaceShape shape;
  };

  class Builder;

  std::vector<Vec3> points_;
  std::vector<Id> inputFaces_;
  UninitializedVector<Face> faces_;
  std::vector<Id> cornerStart_;
  UninitializedVector<Id> corners_;
  std::vector<PseudoSource> pseudoSource_;
  Id numberOfNonManifoldEdges_ = 0;
};

/// A corner of a vertex that a walk from face to face has come to across an edge.
struct EnteredCorner
{
  Id corner;
  /// The corner's other edge.
  Id onward;

  /// \param entered the edge's halfedge in the corner's face.
  EnteredCorner(const TriangleMesh& mesh, Id vertex, Id entered)
    : corner(mesh.origin(entered) == vertex ? entered : TriangleMesh::nextInFace(entered))
    , onward(this->corner == entered ? TriangleMesh::previousInFace(entered) : this->corner)
  {
  }
};

}

#endif
