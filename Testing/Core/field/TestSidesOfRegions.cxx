// SPDX-License-Identifier: BSD-3-Clause
// The side of a curve from which shortest paths come, on oriented surfaces that curves divide in
// two.
#include "EngineSupport.h"
#include "truth/RandomMeshKinds.h"

#include "field/NearestSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace geodesictest;
using geodesic::Foot;
using geodesic::Id;
using geodesic::NearestSource;
using geodesic::SurfacePoint;

namespace
{

constexpr std::uint64_t MeshesOfAKind = meshesOfAKind(12);
constexpr std::size_t NumberOfQueries = 160;

/// A region of an oriented mesh, where a function that is linear in each face is positive, and its
/// rim: curves that have the region to their left or, reversed, to their right. The rim crosses
/// faces, follows edges and goes through vertices.
class Region
{
public:
  Region(const PlainMesh& mesh, Random& random)
    : mesh_(mesh)
    , values_(mesh.points.size())
  {
    // Few levels, so that many vertices are at 0.
    const bool isSmooth = random.chance(0.5);
    const bool isCoarse = random.chance(0.5);
    const Vec3 centre = mesh.points[random.below(mesh.points.size())];
    const double radius =
      random.uniform(0.1, 0.9) * spaceDistance(centre, mesh.points[random.below(values_.size())]);
    for (std::size_t v = 0; v < values_.size(); ++v)
    {
      const double smooth = radius - spaceDistance(centre, mesh.points[v]);
      const double any = isSmooth ? smooth / (radius + 1e-300) : random.uniform(-1.0, 1.0);
      values_[v] = isCoarse ? std::round(1.6 * any) : any;
    }
    findSegments();
    joinSegments(random);
  }

  const std::vector<Polyline>& curves() const { return curves_; }
  bool isReversed(Id curve) const { return isReversed_[curve]; }

  /// Whether a point is in the region; a point on the rim may be either.
  bool contains(const MeshPoint& point) const
  {
    const Triangle& t = mesh_.triangles[point.face];
    double value = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      value += point.weights[k] * values_[t[k]];
    }
    // An edge at 0 between two faces of the region is no rim.
    const bool isFaceIn =
      std::any_of(t.begin(), t.end(), [&](Index v) { return values_[v] > 0.0; });
    return value > 0.0 || (value == 0.0 && isFaceIn);
  }

private:
  /// An end of a rim segment: on an edge, or at a vertex, which is given twice.
  using Place = std::pair<Index, Index>;

  struct Segment
  {
    MeshSegment inFace;
    Place from;
    Place to;
  };

  Place addEnd(Index face, std::size_t k, Barycentric& weights) const
  {
    const Triangle& t = mesh_.triangles[face];
    const Index a = t[k];
    const Index b = t[(k + 1) % 3];
    if (values_[a] == 0.0)
    {
      weights[k] = 1.0;
      return { a, a };
    }
    const bool isAscending = a < b; // the same bits in both faces
    const double low = values_[isAscending ? a : b];
    const double high = values_[isAscending ? b : a];
    // Computed from either end, the point is the same to the last bit.
    const double fraction = 1.0 - (1.0 - low / (low - high));
    weights[k] = isAscending ? 1.0 - fraction : fraction;
    weights[(k + 1) % 3] = isAscending ? fraction : 1.0 - fraction;
    return { std::min(a, b), std::max(a, b) };
  }

  // Along edges at 0 between a face of the region and one outside, and through faces.
  void findSegments()
  {
    std::set<Place> outside; // the halfedges of faces outside
    for (const Triangle& t : mesh_.triangles)
    {
      if (std::none_of(t.begin(), t.end(), [&](Index v) { return values_[v] > 0.0; }))
      {
        outside.insert({ { t[0], t[1] }, { t[1], t[2] }, { t[2], t[0] } });
      }
    }
    for (Index f = 0; f < mesh_.triangles.size(); ++f)
    {
      const Triangle& t = mesh_.triangles[f];
      for (std::size_t k = 0; k < 3; ++k)
      {
        const bool isAtZero = values_[t[k]] == 0.0 && values_[t[(k + 1) % 3]] == 0.0;
        if (isAtZero && values_[t[(k + 2) % 3]] > 0.0 &&
          outside.count({ t[(k + 1) % 3], t[k] }) != 0)
        {
          Segment segment{ { f, {}, {} }, {}, {} };
          segment.from = addEnd(f, k, segment.inFace.from);
          segment.to = addEnd(f, (k + 1) % 3, segment.inFace.to);
          segments_.push_back(segment);
        }
      }
      addSegmentThrough(f);
    }
  }

  // A segment that has the region to its left begins where, counterclockwise around the face, the
  // value falls through 0, and ends where it rises.
  void addSegmentThrough(Index f)
  {
    const Triangle& t = mesh_.triangles[f];
    const auto value = [&](std::size_t k) { return values_[t[k % 3]]; };
    Segment segment{ { f, {}, {} }, {}, {} };
    int ends = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double before = value(k) == 0.0 ? value(k + 2) : value(k);
      const bool falls = before > 0.0 && value(k + 1) < 0.0;
      const bool rises = before < 0.0 && value(k + 1) > 0.0;
      if (falls)
      {
        segment.from = addEnd(f, k, segment.inFace.from);
      }
      if (rises)
      {
        segment.to = addEnd(f, k, segment.inFace.to);
      }
      ends += falls || rises ? 1 : 0;
    }
    if (ends == 2)
    {
      segments_.push_back(segment);
    }
  }

  // Pieces of random lengths, half of them reversed.
  void joinSegments(Random& random)
  {
    std::map<Place, std::vector<std::size_t>> leaving;
    for (std::size_t s = 0; s < segments_.size(); ++s)
    {
      leaving[segments_[s].from].push_back(s);
    }
    std::vector<bool> isDone(segments_.size(), false);
    const double goOn = random.chance(0.3) ? 1.0 : random.uniform(0.3, 0.95);
    for (std::size_t first = 0; first < segments_.size(); ++first)
    {
      if (isDone[first])
      {
        continue;
      }
      Polyline curve;
      for (std::size_t s = first; s < segments_.size();)
      {
        isDone[s] = true;
        curve.segments.push_back(segments_[s].inFace);
        const std::vector<std::size_t>& next = leaving[segments_[s].to];
        const auto free =
          std::find_if(next.begin(), next.end(), [&](auto n) { return !isDone[n]; });
        s = free != next.end() && random.chance(goOn) ? *free : segments_.size();
      }
      isReversed_.push_back(random.chance(0.5));
      curves_.push_back(isReversed_.back() ? reversed(curve) : curve);
    }
  }

  const PlainMesh& mesh_;
  std::vector<double> values_;
  std::vector<Segment> segments_;
  std::vector<Polyline> curves_;
  std::vector<bool> isReversed_;
};

/// As putOntoSurface() does: all curves name a point on an edge by the same halfedge.
std::vector<geodesic::SourceCurve> curvesWithSharedPoints(
  const geodesic::TriangleMesh& mesh, const std::vector<Polyline>& lines)
{
  std::vector<geodesic::SourceCurve> curves = engineCurves(mesh, lines);
  for (geodesic::SourceCurve& curve : curves)
  {
    for (SurfacePoint& point : curve.points)
    {
      if (point.kind == SurfacePoint::Kind::Edge)
      {
        const Id edge = mesh.edgeOf(point.id);
        const bool isSame = mesh.origin(edge) == mesh.origin(point.id);
        point = SurfacePoint::onEdge(edge, isSame ? point.u : 1.0 - point.u);
      }
    }
  }
  return curves;
}

/// Flips faces until neighbours have the same orientation, where that is possible.
PlainMesh oriented(PlainMesh mesh)
{
  std::map<std::pair<Index, Index>, std::vector<Index>> facesOfEdge;
  for (Index f = 0; f < mesh.triangles.size(); ++f)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      facesOfEdge[std::minmax(mesh.triangles[f][k], mesh.triangles[f][(k + 1) % 3])].push_back(f);
    }
  }
  const auto runs = [&](Index f, Index a, Index b)
  {
    const Triangle& t = mesh.triangles[f];
    return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
  };
  std::vector<bool> isDone(mesh.triangles.size(), false);
  for (Index first = 0; first < mesh.triangles.size(); ++first)
  {
    std::vector<Index> waiting;
    if (!isDone[first])
    {
      waiting.push_back(first);
      isDone[first] = true;
    }
    while (!waiting.empty())
    {
      const Index f = waiting.back();
      waiting.pop_back();
      const Triangle t = mesh.triangles[f];
      for (std::size_t k = 0; k < 3; ++k)
      {
        for (const Index other : facesOfEdge[std::minmax(t[k], t[(k + 1) % 3])])
        {
          if (!isDone[other])
          {
            if (runs(other, t[k], t[(k + 1) % 3]))
            {
              std::swap(mesh.triangles[other][1], mesh.triangles[other][2]);
            }
            isDone[other] = true;
            waiting.push_back(other);
          }
        }
      }
    }
  }
  return mesh;
}

/// Whether all faces have the same orientation and the faces around each vertex form one fan.
bool isOrientedManifold(const PlainMesh& mesh)
{
  std::map<std::pair<Index, Index>, Index> nextAround; // the next spoke, by vertex and spoke
  std::vector<std::size_t> corners(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const bool isNew = nextAround.insert({ { t[k], t[(k + 1) % 3] }, t[(k + 2) % 3] }).second;
      if (!isNew)
      {
        return false;
      }
      ++corners[t[k]];
    }
  }
  std::map<std::pair<Index, Index>, Index> before;
  for (const auto& [at, next] : nextAround)
  {
    before[{ at.first, next }] = at.second;
  }
  for (const auto& [at, next] : nextAround)
  {
    // From a corner where no earlier segment ends or, without one, from any corner.
    Index begin = at.second;
    for (std::size_t n = 0; n < corners[at.first] && before.count({ at.first, begin }) != 0; ++n)
    {
      begin = before[{ at.first, begin }];
    }
    std::size_t count = 0;
    for (auto corner = nextAround.find({ at.first, begin });
         corner != nextAround.end() && count <= corners[at.first];
         corner = nextAround.find({ at.first, corner->second }))
    {
      ++count;
      if (corner->second == begin)
      {
        break;
      }
    }
    if (count != corners[at.first])
    {
      return false;
    }
  }
  return true;
}

class SidesOfRegions : public ::testing::TestWithParam<MeshKind>
{
};

}

// A path leaves a region only across its rim. So all shortest paths from the inside reach the rim
// from the region's side, and all from the outside from the other side.
TEST_P(SidesOfRegions, AreInsideAndOutside)
{
  std::size_t told[2] = { 0, 0 };
  std::size_t wrong = 0;
  for (std::uint64_t seed = 0; seed < MeshesOfAKind; ++seed)
  {
    Random random(seed + 64000);
    const PlainMesh plain = oriented(compacted(GetParam().make(randomSize(random), random)));
    if (!isOrientedManifold(plain))
    {
      continue;
    }
    const Region region(plain, random);
    if (region.curves().empty())
    {
      continue;
    }
    const geodesic::TriangleMesh mesh = engineMesh(plain);
    const std::vector<geodesic::SourceCurve> curves = curvesWithSharedPoints(mesh, region.curves());
    geodesic::FrontOptions options;
    options.keepArrivals = true;
    const geodesic::DistanceField field =
      geodesic::solve(mesh, curves, options, geodesic::KeepWindows::All);
    // A point within rounding of the rim may be on either side of it.
    double least = 1e-9 * largestFinite(field.vertexDistances());
    for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
    {
      least = std::max(least, 1e-12 * mesh.length(halfedge));
    }
    NearestSource nearest(field, geodesic::ReplicatedPatch(field.mesh()), curves);
    const auto expectSide = [&](const MeshPoint& point, const Foot& foot, double distance)
    {
      if (!foot.isKnown() || distance < least)
      {
        return;
      }
      const bool isInside = region.contains(point);
      ++told[isInside ? 1 : 0];
      if ((foot.isRight != region.isReversed(foot.curve)) == isInside)
      {
        ++wrong;
        std::cout << GetParam().name << ", seed " << seed << ", face " << point.face
                  << ", distance " << distance << ", curve " << foot.curve << " at "
                  << foot.parameter << ": the wrong side\n";
      }
    };
    for (Index vertex = 0; vertex < plain.points.size(); ++vertex)
    {
      expectSide(
        vertexPoint(plain, vertex), nearest.atVertex(vertex), field.vertexDistances()[vertex]);
    }
    for (const MeshPoint& query : randomPoints(plain, NumberOfQueries, random))
    {
      const SurfacePoint at = geodesic::normalized(mesh, enginePoint(mesh, query));
      expectSide(query, nearest.of(geodesic::incomingSegmentTo(field, at)), field.distance(at));
    }
  }
  const std::string name = GetParam().name;
  const bool hasSides = name != "MoebiusStrip" && name != "Book" && name != "FlatBook" &&
    name != "BowTie" && name != "SaddleFans";
  EXPECT_EQ(hasSides, told[0] > 0 && told[1] > 0);
  // At the tip of a needle a path from the rim may be closer to the rim than rounding can tell:
  // rays of both sides cover it. This concerns one to three of 100,000 points of thin needles.
  const bool isThin = name == "ThinNeedles" || name == "Needles";
  EXPECT_LE(wrong, isThin ? 1U : 0U);
  std::cout << name << ": " << told[1] << " points inside, " << told[0] << " outside\n";
}

INSTANTIATE_TEST_SUITE_P(Kinds, SidesOfRegions, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });
