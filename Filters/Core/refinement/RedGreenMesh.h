// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RedGreenMesh_h
#define geodesic_RedGreenMesh_h

#include "mesh/MeshPartition.h"
#include "mesh/SurfacePoint.h"
#include "mesh/TriangleMesh.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace geodesic
{

/// A triangle mesh under red-green refinement (Bank, Sherman & Weiser 1983, "Refinement algorithms
/// and data structures for regular local mesh refinement"; the paper's one-to-four splits).
///
/// The mesh stores only red triangles: input faces and the four parts of a red triangle whose edges
/// were split (figure 7). A leaf with split edges is closed only in the output: by a bisection;
/// with two or three split edges, into three or four triangles whose inner edges may be flipped;
/// or, if an edge is split more than once, by a strip. These green triangles are not stored, and so
/// they are never split again.
///
/// A thin triangle is much longer than high. Four parts would halve its short edges, too, which
/// need no points; k halvings of the long ones would give 4^k parts. So a thin leaf may have any
/// number of points on its edges, and a strip of triangles between its long edges closes it: about
/// two for each point of one edge. If that does not suffice, the strip's triangles are stored as
/// the leaf's parts, which are refined in turn.
///
/// This class is the structure with its single operations. RedGreenClosure decides which edges are
/// split, and that every leaf can be closed.
///
/// Points are the mesh's vertices followed by the splits, in order. A triangle is an input face or
/// `number of faces + i` for part i. All faces around an input edge share the edges along it, so no
/// T-vertex can arise.
class RedGreenMesh
{
public:
  struct Point
  {
    /// The ends of the edge that it splits, and the fraction of the way from the first to the
    /// second.
    std::array<Id, 2> parents;
    double weight;
    SurfacePoint place;
    double distance;
  };

  struct Edge
  {
    std::array<Id, 2> ends;
    /// The point that splits it, and the first of its halves (the second one follows): from ends[0]
    /// to the point, and from the point to ends[1].
    Id split = NoId;
    Id halves = NoId;
    /// The edge of which it is a half.
    Id parent = NoId;
    /// The input edge along which it lies (the edge's name); NoId inside a face.
    Id halfedge;
    /// A face that contains it.
    Id face;
    /// The first corner of a part at which it begins: 3 * part + k.
    Id firstCorner = NoId;
  };

  /// Where an edge is split, and the distance there.
  struct Placement
  {
    double weight;
    double distance;
  };

  /// The output triangles of a leaf. A leaf with split edges is a polygon of corners and splits.
  struct Closing
  {
    /// The polygon's points, and the edge from each to the next (NoId if not made yet).
    std::vector<Id> points;
    std::vector<Id> edges;
    /// Indices into the polygon.
    std::vector<std::array<Id, 3>> triangles;

    Id size() const { return static_cast<Id>(this->points.size()); }
    /// The edge of the mesh from one point to another, both given as indices; NoId if the way
    /// between them crosses the leaf.
    Id edgeBetween(Id from, Id to) const
    {
      return to == (from + 1) % this->size() ? this->edges[from] : NoId;
    }
  };

  /// \param frozen faces that are not refined, but are closed if a neighbour splits one of their
  ///        edges.
  /// \param beside for an edge, how many triangles outside of the mesh are closed with it
  ///        (RefinementOptions::trianglesBeside).
  /// \param surface its own faces are refined and written; all others must be frozen.
  RedGreenMesh(const MeshPartition& surface, std::vector<std::uint8_t> frozen,
    std::unordered_map<Id, Id> beside = {});

  const TriangleMesh& mesh() const { return this->mesh_; }
  /// The output consists of the faces from the first to before the end.
  Id firstFace() const { return this->firstFace_; }
  Id endOfFaces() const { return this->endOfFaces_; }
  Id numberOfInputPoints() const { return this->mesh_.numberOfVertices(); }
  const std::vector<Point>& points() const { return this->points_; }
  SurfacePoint place(Id point) const;
  /// A point of a face in the face's plane, as in FaceDistance.
  Vec2 inPlane(Id point, Id face) const;
  std::array<Vec2, 3> inPlane(const Triangle& corners, Id face) const;
  /// The places of a closing's points.
  std::vector<Vec2> inPlane(const Closing& closing, Id face) const;

  bool isFrozen(Id face) const { return this->frozen_[face] != 0; }
  /// Whether an input face is unchanged in the output: even its edges have not been made.
  bool isWhole(Id face) const { return this->redOfFace_[face] == NoId; }
  bool isLeaf(Id triangle) const { return this->partsOf(triangle) == NoId; }
  Id faceOf(Id triangle) const
  {
    return triangle < this->faces_ ? triangle : this->parts_[triangle - this->faces_].face;
  }
  /// Corners in the order of the input face.
  Triangle corners(Id triangle) const
  {
    return triangle < this->faces_ ? this->mesh_.triangle(triangle)
                                   : this->parts_[triangle - this->faces_].corners;
  }
  /// Makes the edge from corner k to corner k + 1 if necessary, which invalidates references to
  /// edge data. \returns the edge.
  Id ensureEdge(Id triangle, Id k);
  /// The edge from corner k to corner k + 1 if it has been made, else NoId.
  Id existingEdge(Id triangle, Id k) const
  {
    const Red* red = this->find(triangle);
    return red ? red->edges[k] : NoId;
  }
  const Edge& edgeData(Id edge) const { return this->edges_[edge]; }
  /// Where an edge was split.
  Placement placementOf(Id edge) const
  {
    const Point& split = this->points_[this->edges_[edge].split - this->numberOfInputPoints()];
    return { split.weight, split.distance };
  }
  Id numberOfEdges() const { return static_cast<Id>(this->edges_.size()); }
  bool isSplit(Id edge) const { return edge != NoId && this->edges_[edge].split != NoId; }
  /// Whether a triangle is much longer than high, so that it is never split into four. The four
  /// parts of another triangle are not thin, whatever their shapes.
  bool isThin(Id triangle) const;
  /// Whether a triangle has an area beyond rounding.
  bool hasArea(Id triangle) const;
  /// Whether one of these parts of a leaf's edges is about as short as the strip there is wide: its
  /// triangle, of those that close the leaf, is not thin, or the part is the shortest side.
  bool isAnyAsShortAsWide(Id triangle, const std::vector<Id>& edges) const;
  /// The corner at which the longest edge of a triangle begins.
  Id longestEdge(Id triangle) const;
  /// The height of a triangle over its longest edge.
  double height(Id triangle) const;
  /// The length of an edge, or of a part of one.
  double lengthOf(Id edge) const;
  /// The number of a leaf's split edges.
  Id splitEdges(Id triangle) const;
  /// The number of points on a leaf's edges.
  Id pointsOnEdges(Id triangle) const;
  /// Whether one of its edges is split and a half of that edge, too.
  bool isSplitTwice(Id triangle) const;
  /// The number of ways to cut a leaf; they differ by flips of its inner edges. There is one way to
  /// close it by a strip.
  Id waysToClose(Id triangle) const;
  /// A leaf with an edge that is split twice is closed by a strip between the longest edge, with
  /// which its polygon begins, and the other two. Its triangles are Delaunay's.
  Closing closing(Id triangle, Id way) const;
  /// The way in which the output cuts a leaf.
  Id wayOf(Id triangle) const
  {
    const Red* red = this->find(triangle);
    return red ? red->way : 0;
  }
  /// For a leaf that has edges.
  void setWay(Id triangle, Id way) { this->red(triangle).way = way; }

  /// Visits the input faces that contain an edge.
  template <typename Visitor>
  void forEachFaceAt(const Edge& edge, Visitor&& visit) const
  {
    forEachFace(this->mesh_,
      edge.halfedge == NoId ? SurfacePoint::inFace(edge.face, 0.0, 0.0)
                            : SurfacePoint::onEdge(edge.halfedge, 0.0),
      visit);
  }
  /// Visits the leaves (except frozen ones) at this edge, split or unsplit.
  template <typename Visitor>
  void forEachLeafAt(Id edge, Visitor&& visit) const
  {
    const Edge e = this->edges_[edge]; // a copy: the visitor may ask for edges, which adds them
    for (Id corner = e.firstCorner; corner != NoId;
         corner = this->parts_[corner / 3].nextCorner[corner % 3])
    {
      if (this->parts_[corner / 3].parts == NoId)
      {
        visit(this->faces_ + corner / 3);
      }
    }
    if (e.halfedge != NoId && e.parent == NoId)
    {
      this->forEachFaceAt(e,
        [&](Id face)
        {
          if (this->isLeaf(face) && !this->isFrozen(face))
          {
            visit(face);
          }
        });
    }
  }

  /// Visits the leaves (except frozen ones) with an edge of which this edge is the whole or a part.
  template <typename Visitor>
  void forEachLeafAround(Id edge, Visitor&& visit) const
  {
    for (Id e = edge; e != NoId; e = this->edges_[e].parent)
    {
      this->forEachLeafAt(e, visit);
    }
  }

  /// Visits an edge and all parts of which it consists.
  template <typename Visitor>
  void forEachPartOf(Id edge, Visitor&& visit) const
  {
    visit(edge);
    if (this->isSplit(edge))
    {
      const Id halves = this->edges_[edge].halves;
      this->forEachPartOf(halves, visit);
      this->forEachPartOf(halves + 1, visit);
    }
  }

  /// Visits the parts of a leaf's edges between neighbouring points. Makes edges if necessary.
  template <typename Visitor>
  void forEachPartOfEdges(Id leaf, Visitor&& visit)
  {
    for (Id k = 0; k < 3; ++k)
    {
      this->forEachPartOf(this->ensureEdge(leaf, k),
        [&](Id edge)
        {
          if (!this->isSplit(edge))
          {
            visit(edge);
          }
        });
    }
  }

  /// Splits an edge that is not split yet.
  void split(Id edge, const Placement& placement);
  /// Splits a leaf whose three edges are split into four.
  void splitIntoFour(Id triangle);
  /// Divides a leaf with split edges into the triangles that close it.
  void divide(Id triangle);
  /// Takes a triangle that is new, or one of whose edges (or halves of edges) was split since the
  /// triangle was last taken; NoId if there is none. The order is last first. A triangle may be
  /// returned several times, and may have ceased to be a leaf.
  Id takeTouched();
  bool isAnyTouched() const { return !this->touched_.empty(); }

  /// The number of output triangles, including those that cut the triangles beside the mesh.
  std::uint64_t numberOfTriangles() const { return this->numberOfTriangles_; }

  /// Starts a transaction: rollBack() undoes all changes and removes all edges made since begin().
  void begin();
  void rollBack();

  /// Calls emit(face, corners) for every triangle, face by face.
  template <typename Emit>
  void forEachTriangle(Emit&& emit) const
  {
    this->forEachTriangle(this->firstFace_, this->endOfFaces_, emit);
  }
  /// Calls emit(face, corners) for the triangles of some faces.
  template <typename Emit>
  void forEachTriangle(Id firstFace, Id endOfFaces, Emit&& emit) const
  {
    for (Id face = firstFace; face < endOfFaces; ++face)
    {
      if (this->isWhole(face))
      {
        emit(face, this->mesh_.triangle(face));
      }
      else if (this->isFrozen(face))
      {
        this->closeFrozen(face, this->corners(face), this->find(face)->edges, emit);
      }
      else
      {
        this->closeTriangle(face, emit);
      }
    }
  }
  /// Calls emit(face, corners) for the triangles of a leaf, or of all parts of another triangle.
  template <typename Emit>
  void closeTriangle(Id triangle, Emit&& emit) const
  {
    const Id parts = this->partsOf(triangle);
    if (parts != NoId)
    {
      const Id end = parts + this->find(triangle)->numberOfParts;
      for (Id part = parts; part < end; ++part)
      {
        this->closeTriangle(this->faces_ + part, emit);
      }
      return;
    }
    const Id face = this->faceOf(triangle);
    const Closing closing = this->closing(triangle, this->wayOf(triangle));
    for (const std::array<Id, 3>& t : closing.triangles)
    {
      emit(face, Triangle{ closing.points[t[0]], closing.points[t[1]], closing.points[t[2]] });
    }
  }

private:
  /// A red triangle: a part, or an input face with edges.
  struct Red
  {
    Id face;
    Triangle corners;
    std::array<Id, 3> edges = { NoId, NoId, NoId };
    /// In a part, the next corner at which each of the edges begins.
    std::array<Id, 3> nextCorner = {};
    Id parts = NoId;
    Id numberOfParts = 0;
    Id way = 0;
    bool isThin = false;
  };

  /// Nothing for an input face without edges; most have none.
  const Red* find(Id triangle) const
  {
    if (triangle >= this->faces_)
    {
      return &this->parts_[triangle - this->faces_];
    }
    const Id index = this->redOfFace_[triangle];
    return index == NoId ? nullptr : &this->redFaces_[index];
  }
  Red& red(Id triangle)
  {
    return triangle < this->faces_ ? this->redFaces_[this->redOfFace_[triangle]]
                                   : this->parts_[triangle - this->faces_];
  }
  Id partsOf(Id triangle) const
  {
    const Red* red = this->find(triangle);
    return red ? red->parts : NoId;
  }
  Id addEdge(Id a, Id b, Id parent, Id halfedge, Id face);
  SurfacePoint between(const Edge& edge, double weight) const;
  Id halfAt(Id edge, Id end) const;
  void addAlong(Closing& closing, Id begin, Id edge) const;
  void closeStrip(Closing& closing, Id face, const Triangle& corners) const;
  Id addPart(Id face, const Triangle& corners, const std::array<Id, 3>& edges);
  /// Bisects at the longest split edge first, for the shapes.
  template <typename Emit>
  void closeFrozen(Id face, const Triangle& c, const std::array<Id, 3>& edges, Emit& emit) const
  {
    std::size_t k = 3;
    double length = -1.0;
    for (std::size_t j = 0; j < 3; ++j)
    {
      const Vec3 begin = position(this->mesh_, this->place(c[j]));
      const double ofEdge = norm(position(this->mesh_, this->place(c[(j + 1) % 3])) - begin);
      if (this->isSplit(edges[j]) && ofEdge > length)
      {
        k = j;
        length = ofEdge;
      }
    }
    if (k == 3)
    {
      emit(face, c);
      return;
    }
    const std::size_t next = (k + 1) % 3;
    const std::size_t previous = (k + 2) % 3;
    const Id middle = this->edges_[edges[k]].split;
    this->closeFrozen(face, { c[k], middle, c[previous] },
      { this->halfAt(edges[k], c[k]), NoId, edges[previous] }, emit);
    this->closeFrozen(face, { middle, c[next], c[previous] },
      { this->halfAt(edges[k], c[next]), edges[next], NoId }, emit);
  }

  const TriangleMesh& mesh_;
  Id faces_;
  Id firstFace_;
  Id endOfFaces_;
  std::vector<std::uint8_t> frozen_;
  std::unordered_map<Id, Id> beside_;
  std::vector<Point> points_;
  std::vector<Edge> edges_;
  std::vector<Red> parts_;
  /// The input faces with edges, and for each input face its index there or NoId.
  std::vector<Red> redFaces_;
  std::vector<Id> redOfFace_;
  std::vector<Id> touched_;
  std::uint64_t numberOfTriangles_;

  /// The numbers at begin(): whatever has a higher one was made since.
  std::size_t pointsBefore_ = 0;
  Id edgesBefore_ = 0;
  Id partsBefore_ = 0;
  std::uint64_t trianglesBefore_ = 0;
};

}

#endif
