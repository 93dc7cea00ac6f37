// SPDX-License-Identifier: BSD-3-Clause
#include "source/BoundaryCurves.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

namespace
{

/// Chains the halfedges on the boundary of a surface into curves.
class BoundaryChains
{
public:
  explicit BoundaryChains(const TriangleMesh& mesh)
    : mesh_(mesh)
    , used_(mesh.numberOfHalfedges(), 0)
    , boundaryHalfedgesAt_(mesh.numberOfVertices(), 0)
  {
    for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
    {
      if (mesh.isBoundary(halfedge))
      {
        ++this->boundaryHalfedgesAt_[mesh.origin(halfedge)];
        ++this->boundaryHalfedgesAt_[mesh.destination(halfedge)];
      }
    }
  }

  std::vector<SourceCurve> run()
  {
    // First the curves between vertices where the boundary branches or ends, then the remaining
    // loops.
    for (const bool loops : { false, true })
    {
      for (Id halfedge = 0; halfedge < this->mesh_.numberOfHalfedges(); ++halfedge)
      {
        for (const Id vertex : { this->mesh_.origin(halfedge), this->mesh_.destination(halfedge) })
        {
          if (this->isFree(halfedge) && (loops || !this->goesOn(vertex)))
          {
            this->follow(halfedge, vertex);
          }
        }
      }
    }
    return std::move(this->curves_);
  }

private:
  bool isFree(Id halfedge) const
  {
    return this->mesh_.isBoundary(halfedge) && !this->used_[halfedge];
  }

  Id otherEnd(Id halfedge, Id vertex) const
  {
    return this->mesh_.origin(halfedge) == vertex ? this->mesh_.destination(halfedge)
                                                  : this->mesh_.origin(halfedge);
  }

  /// Whether a curve continues through the boundary vertex.
  bool goesOn(Id vertex) const { return this->boundaryHalfedgesAt_[vertex] == 2; }

  Id freeHalfedgeAt(Id vertex) const
  {
    for (const Id corner : this->mesh_.cornersAt(vertex))
    {
      for (const Id halfedge : { corner, TriangleMesh::previousInFace(corner) })
      {
        if (this->isFree(halfedge))
        {
          return halfedge;
        }
      }
    }
    return NoId;
  }

  void follow(Id halfedge, Id vertex)
  {
    SourceCurve curve;
    curve.points = { SurfacePoint::atVertex(vertex) };
    do
    {
      this->used_[halfedge] = 1;
      vertex = this->otherEnd(halfedge, vertex);
      curve.points.push_back(SurfacePoint::atVertex(vertex));
      curve.faces.push_back(TriangleMesh::faceOf(halfedge));
      halfedge = this->goesOn(vertex) ? this->freeHalfedgeAt(vertex) : NoId;
    } while (halfedge != NoId);
    curve.isCut.assign(curve.points.size(), 0);
    this->curves_.push_back(std::move(curve));
  }

  const TriangleMesh& mesh_;
  std::vector<std::uint8_t> used_;
  std::vector<Id> boundaryHalfedgesAt_;
  std::vector<SourceCurve> curves_;
};

/// Restricts a boundary curve of a whole surface to the faces of a mesh.
class CurveCutter
{
public:
  CurveCutter(const SourceCurve& curve, const TriangleMesh& mesh)
    : curve_(curve)
    , mesh_(mesh)
    , count_(curve.faces.size())
  {
    for (std::size_t i = 0; i < this->count_; ++i)
    {
      const Id from = curve.points[i].id;
      const Id to = curve.points[i + 1].id;
      const Id halfedge =
        this->hasFaceAt(from) && this->hasFaceAt(to) ? mesh.halfedgeBetween(from, to) : NoId;
      this->faces_.push_back(halfedge == NoId ? NoId : TriangleMesh::faceOf(halfedge));
    }
  }

  void run(std::vector<SourceCurve>& pieces) const
  {
    const auto gap = std::find(this->faces_.begin(), this->faces_.end(), NoId);
    if (gap == this->faces_.end())
    {
      pieces.push_back(this->curve_);
      pieces.back().faces = this->faces_;
      return;
    }
    // A loop begins behind an omitted segment and continues past its last point.
    const bool isLoop = this->curve_.isClosed();
    const auto first = isLoop ? static_cast<std::size_t>(gap - this->faces_.begin()) + 1 : 0;
    SourceCurve piece = this->begin(first);
    for (std::size_t i = 0; i < this->count_; ++i)
    {
      const std::size_t segment = (first + i) % this->count_;
      if (this->faces_[segment] != NoId)
      {
        piece.points.push_back(this->curve_.points[segment + 1]);
        piece.faces.push_back(this->faces_[segment]);
        continue;
      }
      this->add(std::move(piece), pieces);
      piece = this->begin(segment + 1);
    }
    if (!isLoop)
    {
      this->add(std::move(piece), pieces);
    }
  }

private:
  SourceCurve begin(std::size_t point) const
  {
    SourceCurve piece;
    piece.points = { this->curve_.points[isLast(point) ? 0 : point] };
    piece.source = this->curve_.source;
    return piece;
  }

  bool hasFaceAt(Id vertex) const
  {
    return vertex < this->mesh_.numberOfVertices() && this->mesh_.cornersAt(vertex).size() > 0;
  }

  /// Whether the point is the last one of a loop, which repeats the first.
  bool isLast(std::size_t point) const { return point == this->count_ && this->curve_.isClosed(); }

  void add(SourceCurve piece, std::vector<SourceCurve>& pieces) const
  {
    if (this->hasFaceAt(piece.points.front().id))
    {
      piece.isCut.assign(piece.points.size(), 0);
      pieces.push_back(std::move(piece));
    }
  }

  const SourceCurve& curve_;
  const TriangleMesh& mesh_;
  std::size_t count_;
  /// The mesh's face at each segment; NoId if there is none.
  std::vector<Id> faces_;
};

} // anonymous namespace

std::vector<SourceCurve> boundaryCurves(const TriangleMesh& mesh)
{
  return BoundaryChains(mesh).run();
}

std::vector<SourceCurve> boundaryOutsideBarriers(
  const std::vector<SourceCurve>& boundary, const TriangleMesh& mesh)
{
  std::vector<SourceCurve> pieces;
  for (const SourceCurve& curve : boundary)
  {
    CurveCutter(curve, mesh).run(pieces);
  }
  return pieces;
}

}
