// SPDX-License-Identifier: BSD-3-Clause
// Faces that belong to the source as a whole, compared with brute force on the surface without
// these faces, from its edges where they were.
#include "EngineSupport.h"
#include "RanksSupport.h"

#include "contours/Isolines.h"
#include "field/NearestSource.h"
#include "refinement/AdaptiveRefinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace geodesictest;
using geodesic::Id;
using geodesic::NoId;
using geodesic::SourceCurve;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

/// Random regions of a mesh, with holes; two may touch, and one may be the whole surface.
struct RegionCase
{
  RegionCase(const MeshKind& kind, Random& random)
    : plain(kind.make(random.between(10, 150), random))
    , mesh(engineMesh(plain))
    , regionOf(mesh.numberOfFaces(), NoId)
  {
    const Index regions = random.between(1, 3);
    for (Id region = 0; region < regions; ++region)
    {
      this->grow(region, random);
    }
    this->makeCurves(regions);
    this->findTruth(randomPoints(this->plain, 20, random));
  }

  bool isCovered(Id face) const { return this->regionOf[face] != NoId; }

  PlainMesh plain;
  TriangleMesh mesh;
  /// NoId: none.
  std::vector<Id> regionOf;
  std::vector<SourceCurve> curves;
  std::vector<MeshPoint> queries;
  BruteForceResult truth;

private:
  void grow(Id region, Random& random)
  {
    const std::size_t wanted = 1 + random.below(random.chance(0.1) ? 1000 : 30);
    std::vector<Id> faces = { random.below(this->mesh.numberOfFaces()) };
    this->regionOf[faces.front()] = region;
    for (std::size_t i = 0; i < faces.size() && faces.size() < wanted; ++i)
    {
      for (const Id halfedge : TriangleMesh::halfedgesOf(faces[i]))
      {
        const Id next = TriangleMesh::faceOf(this->mesh.nextSibling(halfedge));
        if (!this->isCovered(next))
        {
          this->regionOf[next] = region;
          faces.push_back(next);
        }
      }
    }
    for (const Id face : faces)
    {
      this->regionOf[face] = faces.size() > 4 && random.chance(0.1) ? NoId : region;
    }
  }

  void makeCurves(Id regions)
  {
    for (Id region = 0; region < regions; ++region)
    {
      const std::size_t first = this->curves.size();
      std::vector<Id> faces;
      for (Id face = 0; face < this->mesh.numberOfFaces(); ++face)
      {
        if (this->regionOf[face] == region)
        {
          faces.push_back(face);
          this->addOutline(face);
        }
      }
      if (!faces.empty() && this->curves.size() == first)
      {
        this->curves.push_back(
          geodesic::pointCurve(SurfacePoint::atVertex(this->mesh.triangle(faces.front())[0])));
        this->curves.back().source = region;
      }
      if (!faces.empty())
      {
        this->curves[first].coveredFaces = faces;
      }
    }
    geodesic::addBordersWithoutCurves(this->mesh, this->curves);
  }

  /// The edges that only this face of its region has.
  void addOutline(Id face)
  {
    for (const Id halfedge : TriangleMesh::halfedgesOf(face))
    {
      bool isAlone = true;
      for (Id s = this->mesh.nextSibling(halfedge); s != halfedge; s = this->mesh.nextSibling(s))
      {
        isAlone = isAlone && this->regionOf[TriangleMesh::faceOf(s)] != this->regionOf[face];
      }
      if (isAlone)
      {
        this->curves.push_back({ { SurfacePoint::atVertex(this->mesh.origin(halfedge)),
                                   SurfacePoint::atVertex(this->mesh.destination(halfedge)) },
          { face }, { 0, 0 }, this->regionOf[face] });
      }
    }
  }

  void findTruth(const std::vector<MeshPoint>& points)
  {
    PlainMesh outside;
    outside.points = this->plain.points;
    std::vector<Id> numbers(this->mesh.numberOfFaces(), NoId);
    Sources edges;
    for (Id face = 0; face < this->mesh.numberOfFaces(); ++face)
    {
      if (this->isCovered(face))
      {
        continue;
      }
      numbers[face] = static_cast<Id>(outside.triangles.size());
      outside.triangles.push_back(this->plain.triangles[face]);
      this->addEdges(face, numbers[face], edges);
    }
    for (const MeshPoint& point : points)
    {
      if (!this->isCovered(point.face))
      {
        this->queries.push_back(point);
      }
    }
    std::vector<MeshPoint> outsideQueries = this->queries;
    for (MeshPoint& point : outsideQueries)
    {
      point.face = numbers[point.face];
    }
    if (!outside.triangles.empty())
    {
      this->truth = bruteForceDistances(outside, edges, outsideQueries);
    }
    this->truth.vertices.resize(this->plain.points.size(), geodesic::Infinity);
    for (Id face = 0; face < this->mesh.numberOfFaces(); ++face)
    {
      for (const Id vertex : this->mesh.triangle(face))
      {
        this->truth.vertices[vertex] = this->isCovered(face) ? 0.0 : this->truth.vertices[vertex];
      }
    }
  }

  /// Vertices of regions are sources, too, where no edge of theirs is left.
  void addEdges(Id face, Id number, Sources& edges) const
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id halfedge = TriangleMesh::halfedgeOf(face, k);
      const auto corners = this->mesh.cornersAt(this->mesh.origin(halfedge));
      if (std::any_of(corners.begin(), corners.end(),
            [&](Id corner) { return this->isCovered(TriangleMesh::faceOf(corner)); }))
      {
        MeshPoint at{ number, { 0.0, 0.0, 0.0 } };
        at.weights[k] = 1.0;
        edges.points.push_back(at);
      }
      for (Id s = this->mesh.nextSibling(halfedge); s != halfedge; s = this->mesh.nextSibling(s))
      {
        if (this->isCovered(TriangleMesh::faceOf(s)))
        {
          MeshSegment edge{ number, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } };
          edge.from[k] = 1.0;
          edge.to[(k + 1) % 3] = 1.0;
          edges.segments.push_back(edge);
          break;
        }
      }
    }
  }
};

const MeshKind& kindOf(Random& random)
{
  return meshKinds()[random.below(meshKinds().size())];
}

/// Calls test(const RegionCase&) for random regions.
template <typename Test>
void forEachCase(std::uint64_t salt, const Test& test)
{
  for (Random& random : EachSeed(meshesOfAKind(60), salt))
  {
    const MeshKind& kind = kindOf(random);
    SCOPED_TRACE(kind.name);
    test(RegionCase(kind, random), kind);
  }
}

geodesic::DistanceField solveWithArrivals(const RegionCase& c)
{
  geodesic::FrontOptions options;
  options.keepArrivals = true;
  return geodesic::solve(c.mesh, c.curves, options, geodesic::KeepWindows::All);
}

SurfacePoint middleOf(Id face)
{
  return SurfacePoint::inFace(face, 1.0 / 3.0, 1.0 / 3.0);
}

}

TEST(Regions, HaveTheDistancesOfTheSurfaceWithoutThem)
{
  forEachCase(530000,
    [](const RegionCase& c, const MeshKind& kind)
    {
      const EngineResult found = engineDistances(c.plain, c.curves, c.mesh, c.queries);
      // If all corners are on the source, distances are smaller than the faces.
      const double largest = std::max(largestFinite(c.truth.vertices), c.mesh.shape(0).longest());
      EXPECT_LE(worstError(found.vertices, c.truth.vertices, largest), accuracyOn(kind));
      EXPECT_LE(worstError(found.queries, c.truth.queries, largest), accuracyOn(kind));
    });
}

TEST(Regions, AreTheSourceAllOverAndNoWindowEntersThem)
{
  forEachCase(531000,
    [](const RegionCase& c, const MeshKind&)
    {
      const geodesic::DistanceField field = solveWithArrivals(c);
      geodesic::NearestSource nearest(field, geodesic::ReplicatedPatch(c.mesh), c.curves);
      for (Id face = 0; face < c.mesh.numberOfFaces(); ++face)
      {
        EXPECT_EQ(field.isCovered(face), c.isCovered(face));
        if (!c.isCovered(face))
        {
          continue;
        }
        EXPECT_EQ(field.distance(middleOf(face)), 0.0);
        const geodesic::IncomingSegment piece = incomingSegmentTo(field, middleOf(face));
        EXPECT_EQ(gradientOf(c.mesh, piece), geodesic::Vec3{});
        const geodesic::Foot foot = nearest.of(piece);
        ASSERT_TRUE(foot.isKnown());
        EXPECT_EQ(c.curves[foot.curve].source, c.regionOf[face]);
        for (const Id halfedge : TriangleMesh::halfedgesOf(face))
        {
          EXPECT_TRUE(field.windowsOn(halfedge).empty());
          EXPECT_TRUE(nearest.atVertex(c.mesh.origin(halfedge)).isKnown());
        }
      }
    });
}

TEST(Regions, AreNotRefinedAndHaveNoIsolines)
{
  forEachCase(532000,
    [](const RegionCase& c, const MeshKind&)
    {
      const double largest = largestFinite(c.truth.vertices);
      if (!(largest > 0.0))
      {
        return;
      }
      geodesic::RefinementOptions options;
      options.tolerance = 0.1 * largest;
      const geodesic::RefinedMesh refined =
        geodesic::refine(solveForRefinement(c.mesh, c.curves, options.tolerance), options);
      EXPECT_LE(refined.errorBound, options.tolerance);
      for (const geodesic::RefinedPoint& point : refined.points)
      {
        EXPECT_FALSE(point.place.kind == SurfacePoint::Kind::Face && c.isCovered(point.place.id));
      }
      geodesic::IsolineOptions lines;
      lines.values = { 0.3 * largest };
      lines.chordTolerance = 0.01 * largest;
      const geodesic::Isolines drawn =
        drawIsolines(solveForIsolines(c.mesh, c.curves, lines.values), lines);
      const geodesic::DistanceField field = solveKeepingAll(c.mesh, c.curves);
      for (const SurfacePoint& point : drawn.points)
      {
        EXPECT_NEAR(field.distance(point), lines.values[0], 1e-8 * largest);
      }
    });
}

TEST(Regions, EndPathsAtTheirOutlineAndPathsFromInsideHaveNoLength)
{
  forEachCase(533000,
    [](const RegionCase& c, const MeshKind&)
    {
      std::vector<SurfacePoint> targets;
      std::vector<double> lengths;
      std::vector<Id> regions; // that the target is inside
      for (Id face = 0; face < c.mesh.numberOfFaces(); face += 3)
      {
        regions.push_back(c.regionOf[face]);
        targets.push_back(
          c.isCovered(face) ? middleOf(face) : SurfacePoint::atVertex(c.mesh.triangle(face)[0]));
        lengths.push_back(c.isCovered(face) ? 0.0 : c.truth.vertices[c.mesh.triangle(face)[0]]);
      }
      for (Id vertex = 0; vertex < c.mesh.numberOfVertices(); vertex += 2)
      {
        targets.push_back(SurfacePoint::atVertex(vertex));
        lengths.push_back(c.truth.vertices[vertex]);
        const auto corners = c.mesh.cornersAt(vertex);
        const auto regionAt = [&](Id corner) { return c.regionOf[TriangleMesh::faceOf(corner)]; };
        const Id region = regionAt(*corners.begin());
        const bool isInside = std::all_of(
          corners.begin(), corners.end(), [&](Id corner) { return regionAt(corner) == region; });
        regions.push_back(isInside ? region : NoId);
      }
      const std::vector<FoundPath> paths = findPaths(c.mesh, c.curves, targets);
      const double largest = largestFinite(c.truth.vertices);
      for (std::size_t i = 0; i < targets.size(); ++i)
      {
        ASSERT_EQ(paths[i].points.empty(), !(lengths[i] < geodesic::Infinity)) << i;
        double length = 0.0;
        for (std::size_t k = 1; k < paths[i].places.size(); ++k)
        {
          length += spaceDistance(paths[i].places[k], paths[i].places[k - 1]);
        }
        EXPECT_TRUE(paths[i].points.empty() || std::abs(length - lengths[i]) <= 1e-8 * largest);
        EXPECT_TRUE(regions[i] == NoId || paths[i].source == regions[i]);
      }
    });
}
