// SPDX-License-Identifier: BSD-3-Clause
// In flat parts of a surface a vertex splits a pencil of rays into two that still have one source,
// and rays of segments with nearly equal directions have nearly equal distances over long ways.
// Neither may break windows into more and more pieces.
#include "EngineSupport.h"
#include "truth/AnalyticDistances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

using namespace geodesictest;
using geodesic::Id;

namespace
{

/// A long sheet in the plane with irregular triangles; its first halfedge bends like a parabola.
class Strip
{
public:
  Strip(Index nx, Index ny, double bend, Random& random)
    : nx_(nx)
    , ny_(ny)
  {
    const double middle = 0.5 * ny;
    for (Index j = 0; j <= ny; ++j)
    {
      for (Index i = 0; i <= nx; ++i)
      {
        const bool inner = i > 0 && i < nx && j > 0 && j < ny;
        const double x = i > 0 ? i : bend * (j - middle) * (j - middle);
        this->mesh_.points.push_back({ x + (inner ? random.uniform(-0.2, 0.2) : 0.0),
          j + (inner ? random.uniform(-0.2, 0.2) : 0.0), 0.0 });
      }
    }
    for (Index j = 0; j < ny; ++j)
    {
      for (Index i = 0; i < nx; ++i)
      {
        this->mesh_.triangles.push_back(
          { this->at(i, j), this->at(i + 1, j), this->at(i + 1, j + 1) });
        this->mesh_.triangles.push_back(
          { this->at(i, j), this->at(i + 1, j + 1), this->at(i, j + 1) });
      }
    }
  }

  const PlainMesh& mesh() const { return this->mesh_; }

  geodesic::SourceCurve firstHalfedge() const
  {
    geodesic::SourceCurve curve;
    for (Index j = 0; j <= this->ny_; ++j)
    {
      curve.points.push_back(geodesic::SurfacePoint::atVertex(this->at(0, j)));
      curve.isCut.push_back(0);
    }
    for (Index j = 0; j < this->ny_; ++j)
    {
      curve.faces.push_back(2 * j * this->nx_ + 1);
    }
    return curve;
  }

  double distanceToFirstSide(const Vec3& p) const
  {
    double least = geodesic::Infinity;
    for (Index j = 0; j < this->ny_; ++j)
    {
      const Vec3& a = this->mesh_.points[this->at(0, j)];
      const Vec3& b = this->mesh_.points[this->at(0, j + 1)];
      least = std::min(least, distanceToSegment({ p[0], p[1] }, { a[0], a[1] }, { b[0], b[1] }));
    }
    return least;
  }

private:
  Index at(Index i, Index j) const { return j * (this->nx_ + 1) + i; }

  Index nx_;
  Index ny_;
  PlainMesh mesh_;
};

}

TEST(FlatParts, PencilsStayWhole)
{
  for (const double bend : { 0.0, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, -1e-3, -1e-4, -1e-6, -1e-8 })
  {
    SCOPED_TRACE(::testing::Message() << "bend " << bend);
    Random random(5);
    const Strip strip(200, 30, bend, random);
    const geodesic::TriangleMesh mesh = engineMesh(strip.mesh());
    const geodesic::DistanceField field = geodesic::solve(mesh, { strip.firstHalfedge() });
    const double largest = 201.0;
    for (Id v = 0; v < mesh.numberOfVertices(); ++v)
    {
      ASSERT_NEAR(field.vertexDistances()[v], strip.distanceToFirstSide(strip.mesh().points[v]),
        EngineAccuracy * largest)
        << "vertex " << v;
    }
    const double windowsAnEdge =
      static_cast<double>(field.windowsPropagated()) / static_cast<double>(numberOfEdges(mesh));
    std::cout << "bend " << bend << ": " << windowsAnEdge << " windows an edge\n";
    EXPECT_LT(windowsAnEdge, 6.0) << "pieces of pencils go on as pencils of their own";
  }
}
