// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CutEdges_h
#define geodesic_CutEdges_h

#include "mesh/SurfacePoint.h"
#include "refinement/Deviation.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace geodesic
{

/// A point that refinement has put on an edge of the input.
struct PointOnEdge
{
  Id edge;
  /// The fraction of the way along the edge.
  double at;
  double distance;
  /// The points between which it was put, and the fraction of the way from the first to the second.
  /// Points are numbered: the vertices at the edges, then these.
  std::array<Id, 2> parents;
  double weight;
  /// Whether shapes alone have asked for it.
  bool isForShape;
};

/// An edge of the input under refinement, whose points all faces around it share.
struct CutEdge
{
  /// The one along which it runs, the same for any order of the faces: of all at the edge the one
  /// whose origin and apex have the least coordinates.
  Id halfedge;
  /// The numbers of its points, in their order along it.
  std::vector<Id> points;
  /// How far the distance along each piece between neighbouring points deviates from linear: one
  /// more than points.
  std::vector<Deviation> pieces;

  Id numberOfPieces() const { return static_cast<Id>(this->points.size()) + 1; }
};

/// Why a triangle has to be split, the most urgent reason first.
enum class SplitReason : std::uint8_t
{
  /// Its difference to the distance is over the tolerance.
  Error,
  /// Its smallest angle is too small.
  Shape,
  /// A border of regions passes it.
  Border
};

/// A point to be put on a piece of an edge: a face asks for it, and EdgeSplitter adds its distance.
struct EdgeSplit
{
  Id edge;
  Id piece;
  SplitReason reason;
  /// What is worse comes first.
  double urgency;
  /// The fraction of the way along the piece.
  double weight;
  double distance = 0.0;
};

/// The edges of the faces that are refined, and the points on them.
class CutEdges
{
public:
  /// \param firstPoint the number of the first point: that of the vertices at the edges.
  CutEdges(const TriangleMesh& mesh, Id firstPoint)
    : mesh_(mesh)
    , firstPoint_(firstPoint)
  {
  }

  const CutEdge& operator[](Id edge) const { return this->edges_[edge]; }
  CutEdge& operator[](Id edge) { return this->edges_[edge]; }
  Id size() const { return static_cast<Id>(this->edges_.size()); }
  /// The number of an edge, which is added if necessary.
  ///
  /// \param halfedge any of the edge's.
  Id ensure(Id halfedge);
  /// The points on the edge, along this halfedge of it; none if the edge is not there.
  std::vector<Id> pointsAlong(Id halfedge) const;

  const std::vector<PointOnEdge>& points() const { return this->points_; }
  bool isVertex(Id point) const { return point < this->firstPoint_; }
  const PointOnEdge& point(Id number) const { return this->points_[number - this->firstPoint_]; }
  /// Where a vertex or a point on an edge is, and its distance.
  SurfacePoint placeOf(Id number) const;
  double distanceOf(Id number, const std::vector<double>& vertexDistances) const
  {
    return this->isVertex(number) ? vertexDistances[number] : this->point(number).distance;
  }
  /// The end of a piece, piece i lying between ends i and i + 1; and the fraction of the way along
  /// the edge there.
  Id endOfPiece(Id edge, Id end) const;
  double placeOfEnd(Id edge, Id end) const;
  double lengthOfPiece(Id edge, Id piece) const;
  /// The piece at a fraction of the way along the edge.
  Id pieceAt(Id edge, double at) const;

  /// The deviations of both parts of the piece are not known then.
  void split(const EdgeSplit& split);

private:
  const TriangleMesh& mesh_;
  Id firstPoint_;
  std::vector<CutEdge> edges_;
  std::unordered_map<Id, Id> numbers_;
  std::vector<PointOnEdge> points_;
};

}

#endif
