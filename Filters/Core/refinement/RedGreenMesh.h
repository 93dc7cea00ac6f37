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
/// Only red triangles are kept: input faces and the four parts of a red triangle whose edges were
/// split (figure 7). A leaf with split edges is closed in the output, and only there: by a
/// bisection, or with two or three split edges into three or four triangles whose inner edges may
/// be flipped. When more of it is to be split, those green triangles have never been, so that they
/// are never split again.
///
/// This is the structure, with single operations. Which edges are split, and that no leaf is left
/// that cannot be closed, is the work of RedGreenClosure.
///
/// Points are the mesh's vertices and then the splits, in order. A triangle is an input face or
/// `number of faces + i` for part i. Edges along an input edge are shared by all faces around it,
/// so that no T-vertex can arise.
class RedGreenMesh
{
public:
  struct Point
  {
    /// Ends of the edge it splits, and the fraction of the way from the first to the second.
    std::array<Id, 2> parents;
    double weight;
    SurfacePoint place;
    double distance;
  };

  struct Edge
  {
    std::array<Id, 2> ends;
    /// The point that splits it, and its halves (the second one follows): from ends[0] to the point
    /// and on to ends[1].
    Id split = NoId;
    Id halves = NoId;
    /// The edge that it is a half of.
    Id parent = NoId;
    /// The input edge that it lies along (the edge's name); NoId inside a face.
    Id halfedge;
    /// A face that holds it.
    Id face;
    /// First of the corners of parts at which it begins: 3 * part + k.
    Id firstCorner = NoId;
  };

  /// Where an edge is split, and the distance there.
  struct Placement
  {
    double weight;
    double distance;
  };

  /// The triangles that a leaf is in the output: a leaf with split edges is a polygon of corners
  /// and splits.
  struct Closing
  {
    Id size = 0;
    /// The polygon's points and, from each to the next, the edge (NoId: not made yet) and the k of
    /// the leaf's edge that it is or is half of.
    std::array<Id, 6> points;
    std::array<Id, 6> edges;
    std::array<Id, 6> along;
    /// Indices into the polygon.
    Id count = 0;
    std::array<std::array<Id, 3>, 4> triangles;
  };

  /// \param frozen faces that are not refined; where a neighbour splits one of their edges, they
  ///        are only closed.
  /// \param beside how many triangles outside of the mesh are closed with it at an edge
  ///        (RefinementOptions::trianglesBeside).
  /// \param surface the faces that it owns are refined and in the output; the others must be
  ///        frozen.
  RedGreenMesh(const MeshPartition& surface, std::vector<std::uint8_t> frozen,
    std::unordered_map<Id, Id> beside = {});

  const TriangleMesh& mesh() const { return this->mesh_; }
  /// The faces of the output are those from the first to before the end.
  Id firstFace() const { return this->firstFace_; }
  Id endOfFaces() const { return this->endOfFaces_; }
  Id numberOfInputPoints() const { return this->mesh_.numberOfVertices(); }
  const std::vector<Point>& points() const { return this->points_; }
  SurfacePoint place(Id point) const;
  /// A point of a face in the face's plane, as in FaceDistance.
  Vec2 inPlane(Id point, Id face) const;

  bool isFrozen(Id face) const { return this->frozen_[face] != 0; }
  /// Whether an input face is in the output as it is: nobody has even asked for its edges.
  bool isWhole(Id face) const { return !this->hasEdges_[face] && this->partsOfFace_[face] == NoId; }
  bool isLeaf(Id triangle) const { return this->partsOf(triangle) == NoId; }
  Id faceOf(Id triangle) const;
  /// Corners in the order of the input face.
  Triangle corners(Id triangle) const;
  /// The edge from corner k to corner k + 1. May move the data of others.
  Id edge(Id triangle, Id k);
  /// The same, where it has been made already; else NoId.
  Id existingEdge(Id triangle, Id k) const;
  const Edge& edgeData(Id edge) const { return this->edges_[edge]; }
  /// Where a split edge is split.
  Placement placementOf(Id edge) const
  {
    const Point& split = this->points_[this->edges_[edge].split - this->numberOfInputPoints()];
    return { split.weight, split.distance };
  }
  Id numberOfEdges() const { return static_cast<Id>(this->edges_.size()); }
  bool isSplit(Id edge) const { return edge != NoId && this->edges_[edge].split != NoId; }
  /// How many edges of a leaf are split.
  Id splitEdges(Id triangle) const;
  /// Whether an edge of it is split and a half of that, too.
  bool isSplitTwice(Id triangle) const;
  /// In how many ways a leaf with so many split edges can be cut: they differ by flips of edges
  /// inside it.
  static Id waysToClose(Id splitEdges) { return splitEdges < 2 ? 1 : 2 * splitEdges - 2; }
  Closing closing(Id triangle, Id way) const;
  /// The way in which a leaf is cut in the output.
  Id wayOf(Id triangle) const;
  void setWay(Id triangle, Id way);

  /// The leaves (none of them frozen) with this edge as it is, unsplit or not.
  template <typename Visitor>
  void forEachLeafAt(Id edge, Visitor&& visit) const;

  /// Splits an edge that is not split yet.
  void split(Id edge, const Placement& placement);
  /// Splits a leaf whose three edges are split into four.
  void splitIntoFour(Id triangle);
  /// A triangle that is new, or that an edge of has been split (or a half of one) since it was last
  /// taken; NoId where there is none. The last one first; a triangle may come several times, and it
  /// may be no leaf any more.
  Id takeTouched();

  /// Number of triangles in the output, with the cuts of those beside it.
  std::uint64_t numberOfTriangles() const { return this->numberOfTriangles_; }

  /// What was done since begin() is undone by rollBack(); edges made since then are gone.
  void begin();
  void rollBack();

  /// Calls emit(face, corners) for every triangle, face by face.
  template <typename Emit>
  void forEachTriangle(Emit&& emit) const
  {
    this->forEachTriangle(this->firstFace_, this->endOfFaces_, emit);
  }
  /// The same of some faces of the output.
  template <typename Emit>
  void forEachTriangle(Id firstFace, Id endOfFaces, Emit&& emit) const;

private:
  struct Part
  {
    Id face;
    Triangle corners;
    std::array<Id, 3> edges;
    std::array<Id, 3> nextCorner;
    Id parts = NoId;
    Id way = 0;
  };

  enum class Change : std::uint32_t
  {
    EdgeSplit,
    FirstCorner,
    TriangleSplit,
    InputEdge
  };
  struct Undo
  {
    Change change;
    Id id;
    Id old;
  };

  Id partsOf(Id triangle) const;
  void setParts(Id triangle, Id parts);
  const Part& part(Id triangle) const { return this->parts_[triangle - this->faces_]; }
  Id addEdge(Id a, Id b, Id parent, Id halfedge, Id face);
  Id addPoint(const Edge& edge, const Placement& placement);
  SurfacePoint between(const Edge& edge, double weight) const;
  Id halfAt(Id edge, Id end) const;
  Id addPart(Id face, const Triangle& corners, const std::array<Id, 3>& edges);
  void addPolygon(Id triangle, Id begin, Closing& closing) const;
  Id trianglesBeside(const Edge& edge) const;
  Id frozenFacesAt(const Edge& edge) const;
  template <typename Emit>
  void closeLeaf(Id triangle, Emit&& emit) const;
  template <typename Emit>
  void closeFrozen(
    Id face, const Triangle& corners, const std::array<Id, 3>& edges, Emit&& emit) const;
  double lengthOf(Id a, Id b) const;

  const TriangleMesh& mesh_;
  Id faces_;
  Id firstFace_;
  Id endOfFaces_;
  std::vector<std::uint8_t> frozen_;
  std::unordered_map<Id, Id> beside_;
  std::vector<Point> points_;
  std::vector<Edge> edges_;
  std::unordered_map<Id, Id> inputEdges_;
  /// Input faces that may have some of these; most have none.
  std::vector<std::uint8_t> hasEdges_;
  std::vector<Part> parts_;
  /// First of the four parts of each input face.
  std::vector<Id> partsOfFace_;
  /// The ways in which input faces are closed, where not the first.
  std::unordered_map<Id, Id> waysOfFaces_;
  std::vector<Id> touched_;
  std::uint64_t numberOfTriangles_;

  std::vector<Undo> journal_;
  std::size_t pointsBefore_ = 0;
  std::size_t edgesBefore_ = 0;
  std::size_t partsBefore_ = 0;
  std::uint64_t trianglesBefore_ = 0;
};

}

#include "refinement/RedGreenMesh.txx"

#endif
