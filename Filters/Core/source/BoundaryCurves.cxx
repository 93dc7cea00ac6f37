// SPDX-License-Identifier: BSD-3-Clause
#include "source/BoundaryCurves.h"

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
    // First the curves between vertices where the boundary branches or ends, then the loops left.
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

  /// Whether one curve goes on through the boundary vertex.
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

} // anonymous namespace

std::vector<SourceCurve> boundaryCurves(const TriangleMesh& mesh)
{
  return BoundaryChains(mesh).run();
}

}
