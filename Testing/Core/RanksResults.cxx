// SPDX-License-Identifier: BSD-3-Clause
#include "RanksResults.h"

#include "OnThreads.h"
#include "contours/IsolineSupport.h"
#include "refinement/RefinementSupport.h"

#include "contours/IsolineSides.h"
#include "contours/SolveForIsolines.h"
#include "field/NearestSource.h"
#include "paths/PathCorridor.h"
#include "paths/PathInStrip.h"
#include "refinement/RefinedOnRanks.h"
#include "refinement/SolveForRefinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <tuple>

namespace geodesictest
{

using geodesic::DistanceField;
using geodesic::Id;
using geodesic::MeshPartition;
using geodesic::RankAddress;
using geodesic::RefinedMesh;
using geodesic::RefinedPoint;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

geodesic::FrontOptions frontOf(const Scene& scene)
{
  geodesic::FrontOptions options;
  options.maximumDistance = scene.maximumDistance;
  options.relativeError = scene.relativeError;
  options.keepArrivals = scene.relativeError == 0.0;
  return options;
}

/// The whole mesh's number of a face that a rank owns.
Id wholeFace(const RankOfRun& rank, Id face)
{
  return static_cast<Id>(rank.wholeFaces[rank.part.triangleOf(face)]);
}

/// The queries in faces that a rank owns.
struct OwnQueries
{
  std::vector<std::size_t> numbers;
  std::vector<SurfacePoint> points;

  OwnQueries(const RankOfRun& rank, const std::vector<MeshPoint>& queries)
  {
    for (std::size_t i = 0; i < queries.size(); ++i)
    {
      const RankAddress face = rank.facesOnRanks[queries[i].face];
      if (face.rank == rank.exchange.rank() && rank.part.isOwn(face.id))
      {
        this->numbers.push_back(i);
        this->points.push_back(
          geodesic::fromBarycentric(rank.part.mesh(), face.id, queries[i].weights));
      }
    }
  }
};

std::vector<geodesic::SourceCurve> numbered(std::vector<geodesic::SourceCurve> curves)
{
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    curves[i].source = static_cast<Id>(i);
  }
  return curves;
}

Vec3 plainPlace(const TriangleMesh& mesh, const SurfacePoint& point)
{
  const geodesic::Vec3 p = geodesic::position(mesh, point);
  return { p[0], p[1], p[2] };
}

} // anonymous namespace

FieldOnRanks fieldOnRanks(const CutMesh& cut, const Scene& scene)
{
  FieldOnRanks result;
  result.distances.assign(cut.mesh.points.size(), geodesic::Infinity);
  std::map<geodesic::Id, double> atVertex;
  std::mutex mutex;
  onRanks(cut, scene.curves, scene.disorder,
    [&](const RankOfRun& rank)
    {
      geodesic::FrontOptions options = frontOf(scene);
      geodesic::KeepNone none;
      const geodesic::FrontResult front = propagate(rank.part, rank.sources, options, none);
      const std::lock_guard<std::mutex> lock(mutex);
      for (std::size_t i = 0; i < rank.wholeVertices.size(); ++i)
      {
        result.distances[rank.wholeVertices[i]] = front.vertexDistances[i];
      }
      // Also at the halo's vertices, which other ranks own.
      for (std::size_t vertex = 0; vertex < front.vertexDistances.size(); ++vertex)
      {
        const auto number = static_cast<Id>(rank.part.globalId(static_cast<Id>(vertex)));
        const double distance = front.vertexDistances[vertex];
        EXPECT_EQ(atVertex.emplace(number, distance).first->second, distance)
          << "ranks differ at vertex " << number;
      }
      result.relativeErrorBound = front.relativeErrorBound;
      result.windowsPropagated = front.windowsPropagated;
    });
  return result;
}

namespace
{

class NearestAsker
{
public:
  NearestAsker(const CutMesh& cut, const Scene& scene)
    : scene_(scene)
    , answers_(cut.mesh.points.size() + scene.queries.size())
    , answeredBy_(answers_.size(), cut.numberOfRanks)
  {
    onRanks(cut, scene.curves, scene.disorder, [this](const RankOfRun& rank) { this->ask(rank); });
  }

  std::vector<Nearest>& answers() { return this->answers_; }

private:
  void ask(const RankOfRun& rank)
  {
    for (const auto keep : { geodesic::KeepWindows::None, geodesic::KeepWindows::All })
    {
      const DistanceField field =
        geodesic::solve(rank.part, rank.sources, frontOf(this->scene_), keep);
      geodesic::NearestSource nearest(field, rank.patch, rank.curvesOnPatch);
      for (Id vertex = 0; vertex < rank.wholeVertices.size(); ++vertex)
      {
        const auto piece = geodesic::incomingSegmentTo(field, SurfacePoint::atVertex(vertex));
        this->add(rank, rank.wholeVertices[vertex], nearest, nearest.atVertex(vertex), piece);
      }
      const OwnQueries queries(rank, this->scene_.queries);
      for (std::size_t i = 0; field.hasWindows() && i < queries.points.size(); ++i)
      {
        const auto piece = geodesic::incomingSegmentTo(field, queries.points[i]);
        this->add(rank, this->answers_.size() - this->scene_.queries.size() + queries.numbers[i],
          nearest, nearest.of(piece), piece);
      }
    }
  }

  void add(const RankOfRun& rank, std::size_t i, const geodesic::NearestSource& nearest,
    const geodesic::Foot& foot, const geodesic::IncomingSegment& piece)
  {
    Nearest answer;
    answer.isKnown = foot.isKnown();
    answer.gradient = geodesic::gradientOf(rank.part.mesh(), piece);
    if (answer.isKnown)
    {
      const TriangleMesh& mesh = nearest.meshOfCurves();
      const SurfacePoint at = nearest.pointOf(foot);
      const Id face = geodesic::someFace(mesh, at);
      answer.curve = foot.curve;
      answer.isRight = foot.isRight;
      answer.foot = { wholeFaceOf(rank, rank.patch.ownerOf(face)),
        geodesic::barycentric(mesh, at, face) };
      answer.place = plainPlace(mesh, at);
    }
    const std::lock_guard<std::mutex> lock(this->mutex_);
    Nearest& known = this->answers_[i];
    int& by = this->answeredBy_[i]; // the lowest rank yet, if any
    EXPECT_TRUE(by == rank.exchange.numberOfRanks() ||
      std::tie(known.isKnown, known.curve, known.isRight, known.place) ==
        std::tie(answer.isKnown, answer.curve, answer.isRight, answer.place))
      << "point " << i << ": ranks differ, or fields with and without windows";
    // Where gradients tie, ranks have different ones: the lowest's counts, whichever comes last.
    if (rank.exchange.rank() <= by)
    {
      known = answer;
      by = rank.exchange.rank();
    }
  }

  const Scene& scene_;
  std::vector<Nearest> answers_;
  std::vector<int> answeredBy_;
  std::mutex mutex_;
};

} // anonymous namespace

std::vector<Nearest> nearestOnRanks(const CutMesh& cut, const Scene& scene)
{
  return NearestAsker(cut, scene).answers();
}

std::vector<FoundPath> pathsOnRanks(const CutMesh& cut, const Scene& scene)
{
  std::vector<FoundPath> paths(scene.queries.size());
  std::mutex mutex;
  onRanks(cut, scene.curves, scene.disorder,
    [&](const RankOfRun& rank)
    {
      const OwnQueries targets(rank, scene.queries);
      const auto own = findPaths(rank.part, rank.patch, numbered(rank.curvesOnPatch),
        targets.points, scene.hasThreads ? geodesic::Job({}, onThreads) : geodesic::Job());
      const std::lock_guard<std::mutex> lock(mutex);
      for (std::size_t i = 0; i < own.size(); ++i)
      {
        paths[targets.numbers[i]] = own[i];
      }
    });
  return paths;
}

// The front has stopped at the target: it knows no larger distance.
std::vector<FoundPath> pathsInStrips(
  const CutMesh& cut, const Scene& scene, const std::vector<double>& distances)
{
  std::vector<FoundPath> paths(scene.queries.size());
  onRanks(cut, scene.curves, scene.disorder,
    [&](const RankOfRun& rank)
    {
      const DistanceField field = geodesic::solve(rank.part, rank.sources, frontOf(scene));
      const std::vector<geodesic::SourceCurve> curves = numbered(rank.curvesOnPatch);
      for (std::size_t i = 0; i < scene.queries.size(); ++i)
      {
        const RankAddress face = rank.facesOnRanks[scene.queries[i].face];
        const bool isHere = face.rank == rank.exchange.rank();
        geodesic::FacePoint target{};
        if (isHere)
        {
          const TriangleMesh& mesh = rank.part.mesh();
          target = geodesic::toFacePoint(
            mesh, face.id, geodesic::fromBarycentric(mesh, face.id, scene.queries[i].weights));
        }
        target = geodesic::valuesOfRanks(rank.exchange, target)[geodesic::rankIndex(face.rank)];
        std::vector<double> atVertices = field.vertexDistances();
        for (double& atVertex : atVertices)
        {
          atVertex = atVertex <= distances[i] ? atVertex : geodesic::Infinity;
        }
        const auto found = geodesic::pathInStrip(rank.part, rank.patch, curves,
          { face, target, distances[i] }, geodesic::lowerBoundsOf(atVertices, distances[i]), {});
        EXPECT_EQ(found.has_value(), isHere);
        if (found)
        {
          paths[i].take(*found);
        }
      }
    });
  return paths;
}

std::vector<PlainLine> linesOnRanks(const CutMesh& cut, const Scene& scene, bool leftOnly)
{
  std::vector<PlainLine> lines;
  std::mutex mutex;
  onRanks(cut, scene.curves, scene.disorder,
    [&](const RankOfRun& rank)
    {
      const TriangleMesh& mesh = rank.part.mesh();
      const DistanceField field = scene.keepsAllWindows
        ? solveKeeping(rank.part, rank.sources, frontOf(scene), rank.part.ownFaces())
        : solveForIsolines(rank.part, rank.sources, scene.values, frontOf(scene));
      geodesic::Isolines isolines =
        drawIsolines(field, { scene.values, scene.chordTolerance, geodesic::Job() });
      if (leftOnly)
      {
        std::vector<geodesic::SidedValue> sided;
        for (std::size_t i = 0; i < scene.values.size(); ++i)
        {
          sided.push_back({ i, geodesic::SidedValue::None });
        }
        geodesic::NearestSource nearest(field, rank.patch, rank.curvesOnPatch);
        isolines = linesOnSides(
          field, nearest, [](const geodesic::Foot& foot) { return foot.isRight; }, isolines, sided);
      }
      const std::lock_guard<std::mutex> lock(mutex);
      expectChordsInFaces(mesh, isolines);
      for (const geodesic::Isoline& line : isolines.lines)
      {
        PlainLine& plain = lines.emplace_back();
        plain.value = line.value;
        for (std::size_t i = 0; i < line.points.size(); ++i)
        {
          const SurfacePoint& point = isolines.points[line.points[i]];
          const Id face = line.faces[std::min(i, line.faces.size() - 1)];
          ASSERT_TRUE(rank.part.isOwn(face));
          plain.places.push_back(plainPlace(mesh, point));
          plain.points.push_back(
            { wholeFace(rank, face), geodesic::barycentric(mesh, point, face) });
        }
      }
    });
  return lines;
}

namespace
{

/// A corner of a refined triangle: a vertex with its global number, or an added point with its
/// distance.
using Placed = std::pair<geodesic::Vec3, double>;
using PlacedTriangle = std::array<Placed, 3>;

bool areSame(const RankAddress& a, const RankAddress& b)
{
  return a.rank == b.rank && a.id == b.id;
}

/// Joins refined parts, and checks what ranks tell each other about them.
class Joiner
{
public:
  Joiner(const CutMesh& cut, const Scene& scene)
    : whole_(engineMesh(cut.mesh))
    , scene_(scene)
  {
    this->joined_.refined.numberOfInputPoints = this->whole_.numberOfVertices();
    this->joined_.vertexDistances.assign(this->whole_.numberOfVertices(), geodesic::Infinity);
    onRanks(
      cut, scene.curves, scene.disorder, [this](const RankOfRun& rank) { this->refine(rank); });
    this->finish();
  }

  Joined& joined() { return this->joined_; }

private:
  struct Part
  {
    Id face;
    geodesic::Triangle corners;
  };
  /// A point that a rank has added to an edge, and the point whose values it takes.
  struct PointOnEdge
  {
    RankAddress own;
    RankAddress taken;
    bool isKnown;
  };

  void refine(const RankOfRun& rank)
  {
    const DistanceField field =
      solveForRefinement(rank.part, rank.sources, this->scene_.tolerance, frontOf(this->scene_));
    const RefinedMesh refined = refineTo(field, this->scene_.tolerance, this->scene_.maximumFaces);
    std::vector<RankAddress> others;
    for (Id face = 0; face < rank.part.mesh().numberOfFaces(); ++face)
    {
      if (!rank.part.isOwn(face))
      {
        others.push_back(rank.part.addressOf(face));
      }
    }
    const auto told = findRefinedFaces(others, rank.part, refined, {});
    const geodesic::SeamPoints seams =
      findSeamPoints(refined.points, refined.points.size(), field, field);
    for (int turn = 0; turn < rank.exchange.numberOfRanks(); ++turn)
    {
      if (turn == rank.exchange.rank())
      {
        const std::lock_guard<std::mutex> lock(this->mutex_);
        this->add(rank, field, refined);
        this->addTold(rank, others, told);
        this->addPointsOnEdges(rank, field, refined, seams);
      }
      rank.exchange.isTrueAnywhere(false);
    }
  }

  void add(const RankOfRun& rank, const DistanceField& field, const RefinedMesh& refined)
  {
    RefinedMesh& joined = this->joined_.refined;
    EXPECT_EQ(refined.numberOfInputPoints, rank.part.numberOfOwnVertices());
    EXPECT_TRUE(rank.exchange.rank() == 0 ||
      (joined.errorBound == refined.errorBound &&
        joined.stoppedAtMaximum == refined.stoppedAtMaximum))
      << "ranks differ";
    joined.errorBound = refined.errorBound;
    joined.stoppedAtMaximum = refined.stoppedAtMaximum;
    this->joined_.relativeErrorBound = field.relativeErrorBound();
    for (std::size_t i = 0; i < rank.wholeVertices.size(); ++i)
    {
      this->joined_.vertexDistances[rank.wholeVertices[i]] = field.vertexDistances()[i];
    }
    std::vector<Id> numbers(rank.wholeVertices.begin(), rank.wholeVertices.end());
    for (RefinedPoint point : refined.points)
    {
      point.parents = { numbers[point.parents[0]], numbers[point.parents[1]] };
      point.place = this->placeInWhole(rank, point.place);
      numbers.push_back(this->numberOf(point));
    }
    const auto placeOf = [&](Id point) -> Placed
    {
      if (point < refined.numberOfInputPoints)
      {
        return { rank.part.mesh().point(point), static_cast<Id>(rank.part.globalId(point)) };
      }
      const RefinedPoint& added = refined.points[point - refined.numberOfInputPoints];
      return { added.position, added.distance };
    };
    for (std::size_t i = 0; i < refined.triangles.size(); ++i)
    {
      const auto& [a, b, c] = refined.triangles[i];
      this->triangles_.push_back(
        { wholeFace(rank, refined.faces[i]), { numbers[a], numbers[b], numbers[c] } });
      this->own_[{ rank.exchange.rank(), refined.faces[i] }].push_back(
        { placeOf(a), placeOf(b), placeOf(c) });
    }
  }

  SurfacePoint placeInWhole(const RankOfRun& rank, const SurfacePoint& place) const
  {
    if (place.kind == SurfacePoint::Kind::Face)
    {
      return SurfacePoint::inFace(wholeFace(rank, place.id), place.u, place.v);
    }
    const TriangleMesh& mesh = rank.part.mesh();
    const auto a = static_cast<Id>(rank.wholeVertices.at(mesh.origin(place.id)));
    const auto b = static_cast<Id>(rank.wholeVertices.at(mesh.destination(place.id)));
    const Id halfedge = this->whole_.halfedgeBetween(a, b);
    return SurfacePoint::onEdge(
      halfedge, this->whole_.origin(halfedge) == a ? place.u : 1.0 - place.u);
  }

  Id numberOf(const RefinedPoint& point)
  {
    std::vector<RefinedPoint>& points = this->joined_.refined.points;
    // Inside faces no point belongs to two ranks, but two points may coincide in a flat part.
    const Id element =
      point.place.kind == SurfacePoint::Kind::Face ? point.place.id : geodesic::NoId;
    const auto [at, isNew] = this->numbers_.try_emplace(
      Key{ point.parents, point.weight, point.position, point.distance, element },
      this->whole_.numberOfVertices() + static_cast<Id>(points.size()));
    if (isNew)
    {
      points.push_back(point);
    }
    return at->second;
  }

  /// What the owners of the halo's faces have told of these.
  void addTold(const RankOfRun& rank, const std::vector<RankAddress>& faces,
    const std::vector<RefinedMesh>& told)
  {
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      const geodesic::Triangle& corners = rank.part.mesh().triangle(rank.part.faceAt(faces[i]));
      const auto placeOf = [&](Id point) -> Placed
      {
        if (point < 3)
        {
          return { rank.part.mesh().point(corners[point]),
            static_cast<Id>(rank.part.globalId(corners[point])) };
        }
        return { told[i].points[point - 3].position, told[i].points[point - 3].distance };
      };
      std::vector<PlacedTriangle>& triangles =
        this->told_.emplace_back(faces[i], std::vector<PlacedTriangle>()).second;
      for (const auto& [a, b, c] : told[i].triangles)
      {
        triangles.push_back({ placeOf(a), placeOf(b), placeOf(c) });
      }
    }
  }

  void addPointsOnEdges(const RankOfRun& rank, const DistanceField& field,
    const RefinedMesh& refined, const geodesic::SeamPoints& seams)
  {
    std::vector<RankAddress> taken;
    for (Id i = 0; i < refined.points.size(); ++i)
    {
      taken.push_back({ rank.exchange.rank(), i });
    }
    for (std::size_t i = 0; i < seams.here.size(); ++i)
    {
      taken[seams.here[i]] = seams.there[i];
    }
    for (Id i = 0; i < refined.points.size(); ++i)
    {
      const SurfacePoint& place = refined.points[i].place;
      if (place.kind == SurfacePoint::Kind::Edge)
      {
        bool isKnown = false;
        forEachFace(rank.part.mesh(), place,
          [&](Id face)
          { isKnown = isKnown || (rank.part.isOwn(face) && field.knowsInside(face)); });
        const SurfacePoint inWhole = this->placeInWhole(rank, place);
        this->onEdges_[{ this->whole_.edgeOf(inWhole.id), refined.points[i].position }].push_back(
          { { rank.exchange.rank(), i }, taken[i], isKnown });
      }
    }
  }

  void finish()
  {
    std::stable_sort(this->triangles_.begin(), this->triangles_.end(),
      [](const Part& a, const Part& b) { return a.face < b.face; });
    for (const Part& part : this->triangles_)
    {
      this->joined_.refined.faces.push_back(part.face);
      this->joined_.refined.triangles.push_back(part.corners);
    }
    for (const auto& [face, triangles] : this->told_)
    {
      EXPECT_EQ(triangles, this->own_.at(face)) << "a face of another rank";
    }
    this->joined_.toldFaces = this->told_.size();
    for (const auto& [place, ofRanks] : this->onEdges_)
    {
      // The lowest rank that knows a face there provides the values.
      const auto teller = std::find_if(
        ofRanks.begin(), ofRanks.end(), [](const PointOnEdge& point) { return point.isKnown; });
      for (const PointOnEdge& point : ofRanks)
      {
        EXPECT_TRUE(areSame(point.taken, teller != ofRanks.end() ? teller->own : point.own));
      }
      this->joined_.sharedPoints += ofRanks.size() > 1 ? 1 : 0;
    }
  }

  using Key = std::tuple<std::array<Id, 2>, double, geodesic::Vec3, double, Id>;

  const TriangleMesh whole_;
  const Scene& scene_;
  Joined joined_;
  std::map<Key, Id> numbers_;
  std::vector<Part> triangles_;
  std::map<RankAddress, std::vector<PlacedTriangle>> own_;
  std::vector<std::pair<RankAddress, std::vector<PlacedTriangle>>> told_;
  /// By edge and place in space, in the order of the ranks.
  std::map<std::pair<Id, geodesic::Vec3>, std::vector<PointOnEdge>> onEdges_;
  std::mutex mutex_;
};

/// A field that knows the distances at the vertices.
DistanceField fieldOf(const TriangleMesh& whole, const Joined& joined)
{
  geodesic::FrontResult front;
  front.vertexDistances = joined.vertexDistances;
  return DistanceField(MeshPartition(whole), front, {});
}

} // anonymous namespace

Joined refineOnRanks(const CutMesh& cut, const Scene& scene)
{
  return Joiner(cut, scene).joined();
}

void expectFitTogether(const TriangleMesh& whole, const Joined& joined)
{
  const DistanceField field = fieldOf(whole, joined);
  const Points points(field, joined.refined);
  expectFacesPartitioned(whole, joined.refined, points);
  expectWatertight(whole, joined.refined, points);
}

Samples samplesOf(
  const TriangleMesh& whole, const Joined& joined, std::size_t count, Random& random)
{
  return sample(fieldOf(whole, joined), joined.refined, count, random);
}

}
