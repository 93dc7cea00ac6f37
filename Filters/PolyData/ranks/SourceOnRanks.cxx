// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/ranks/SourceOnRanks.h"

#include "Tolerance.h"
#include "source/BoundaryCurves.h"

#include <algorithm>
#include <unordered_set>

namespace geodesic
{

namespace
{

/// A found face, as it is told to all ranks.
struct ToldFace
{
  std::uint64_t place;
  RankAddress face;
  /// With the vertices' numbers in the whole.
  FaceLocator::Candidate candidate;
};

constexpr std::size_t PointsPerReport = 256;

}

LocatorOnRanks::LocatorOnRanks(const MeshPartition& part)
  : part_(part)
  , locator_(part.mesh())
{
  const TriangleMesh& mesh = part.mesh();
  for (Id face = part.firstOwnFace(); face < part.endOfOwnFaces(); ++face)
  {
    for (const Id vertex : mesh.triangle(face))
    {
      this->box_.add(mesh.point(vertex));
    }
  }
}

std::vector<std::vector<LocatorOnRanks::Found>> LocatorOnRanks::locate(
  const std::vector<Vec3>& points, double coordinatePrecision, const ProgressCallback& progress)
{
  std::vector<Candidates> candidates(points.size());
  std::vector<double> least(points.size(), Infinity);
  const auto search = [&](std::size_t i)
  {
    candidates[i] = this->locator_.candidates(points[i], coordinatePrecision, progress);
    for (const FaceLocator::Candidate& candidate : candidates[i])
    {
      least[i] = std::min(least[i], candidate.distance);
    }
  };
  // First those ranks search in whose box a point is: most others need not then.
  for (const bool isInBox : { true, false })
  {
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (i % PointsPerReport == 0 && progress && !progress(isInBox ? 0.0 : 0.5))
      {
        throw Aborted();
      }
      const double distance = this->box_.distanceTo(points[i]);
      const double slack = tolerance::SnapRoundings * coordinatePrecision *
        std::max(largestCoordinate(points[i]), this->box_.largestCoordinate());
      const bool isSearched =
        isInBox ? distance == 0.0 : distance > 0.0 && distance <= least[i] + slack;
      if (isSearched && distance < Infinity)
      {
        search(i);
      }
    }
    this->part_.exchange().findLeast(least);
  }

  Message message;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (const FaceLocator::Candidate& candidate : candidates[i])
    {
      if (candidate.isClosest(least[i]) && this->part_.isOwn(candidate.face))
      {
        put(message,
          ToldFace{
            i, { this->part_.exchange().rank(), candidate.face }, this->inWhole(candidate) });
      }
    }
  }
  std::vector<Candidates> told(points.size());
  std::vector<std::vector<RankAddress>> addresses(points.size());
  readEach(this->part_.exchange().tellAll(message),
    [&](int, MessageReader& reader)
    {
      auto face = reader.get<ToldFace>();
      face.candidate.face = static_cast<Id>(addresses[face.place].size());
      addresses[face.place].push_back(face.face);
      told[face.place].push_back(face.candidate);
    });
  std::vector<std::vector<Found>> found(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (const FaceLocator::Candidate& chosen : FaceLocator::chosen(told[i]))
    {
      found[i].push_back({ addresses[i][chosen.face], chosen.isClosestUpToRounding(least[i]) });
    }
    std::sort(found[i].begin(), found[i].end());
  }
  return found;
}

FaceLocator::Candidate LocatorOnRanks::inWhole(FaceLocator::Candidate candidate) const
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    candidate.corners[k] = this->part_.globalId(candidate.corners[k]);
    candidate.support[k] = candidate.support[k] == NoId ? NoId : candidate.corners[k];
  }
  return candidate;
}

SourceOnRanks::SourceOnRanks(const MeshPartition& part)
  : part_(part)
  , isChosen_(part.mesh().numberOfFaces(), 0)
{
}

void SourceOnRanks::addCurves(const std::vector<LocatedPolyline>& polylines,
  double coordinatePrecision, LocatorOnRanks& locator, const ProgressCallback& progress)
{
  for (const LocatedPolyline& polyline : polylines)
  {
    this->places_.insert(this->places_.end(), polyline.points.begin(), polyline.points.end());
  }
  std::sort(this->places_.begin(), this->places_.end());
  this->places_.erase(std::unique(this->places_.begin(), this->places_.end()), this->places_.end());
  this->faces_ = locator.locate(this->places_, coordinatePrecision, progress);
  for (const std::vector<LocatorOnRanks::Found>& faces : this->faces_)
  {
    for (const LocatorOnRanks::Found& found : faces)
    {
      const Id face = found.face.rank == this->part_.exchange().rank()
        ? found.face.id
        : this->part_.copyOf(found.face);
      if (face != NoId)
      {
        this->addFacesAround(face);
      }
    }
  }
}

/// Segments of a curve lie in the faces of its points, and points may be put onto their vertices:
/// all faces there belong to the patch.
void SourceOnRanks::addFacesAround(Id face)
{
  for (const Id vertex : this->part_.mesh().triangle(face))
  {
    this->addFacesAtVertex(vertex);
  }
}

void SourceOnRanks::addFacesAtVertex(Id vertex)
{
  for (const Id corner : this->part_.mesh().cornersAt(vertex))
  {
    this->isChosen_[TriangleMesh::faceOf(corner)] = 1;
  }
}

void SourceOnRanks::addBoundary()
{
  const TriangleMesh& mesh = this->part_.mesh();
  for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
  {
    // At the vertices of faces that this rank owns the part is as the whole.
    const bool isKnown = mesh.origin(halfedge) < this->part_.numberOfOwnVertices() ||
      mesh.destination(halfedge) < this->part_.numberOfOwnVertices();
    if (mesh.isBoundary(halfedge) && isKnown)
    {
      this->addFacesAround(TriangleMesh::faceOf(halfedge));
    }
  }
}

void SourceOnRanks::addBoundaryOf(const MeshPartition& whole, const std::vector<Id>& numbers)
{
  SourceOnRanks onWhole(whole);
  onWhole.addBoundary();
  onWhole.makePatch();
  const ReplicatedPatch& patch = onWhole.patch();
  struct Told
  {
    Id vertex;
    Id number;
  };
  Message message;
  for (Id vertex = 0; vertex < patch.mesh().numberOfVertices(); ++vertex)
  {
    if (patch.vertexOfPart(vertex) != NoId)
    {
      put(message, Told{ vertex, numbers[patch.vertexOfPart(vertex)] });
    }
  }
  std::vector<Id> numberOf(patch.mesh().numberOfVertices(), NoId);
  readEach(whole.exchange().tellAll(message),
    [&](int, MessageReader& reader)
    {
      const Told told = reader.get<Told>();
      numberOf[told.vertex] = told.number;
    });
  this->otherBoundary_ = onWhole.boundary();
  std::unordered_set<Id> onBoundary;
  for (SourceCurve& curve : *this->otherBoundary_)
  {
    for (SurfacePoint& point : curve.points)
    {
      point.id = numberOf[point.id];
      onBoundary.insert(point.id);
    }
  }
  for (Id vertex = 0; vertex < this->part_.numberOfOwnVertices(); ++vertex)
  {
    if (onBoundary.count(this->part_.globalId(vertex)) > 0)
    {
      this->addFacesAtVertex(vertex);
    }
  }
}

bool SourceOnRanks::addFaces(const std::vector<Id>& faces)
{
  for (const Id face : faces)
  {
    this->isChosen_[face] = 1;
  }
  return this->part_.exchange().isTrueAnywhere(!faces.empty());
}

void SourceOnRanks::makePatch()
{
  std::vector<Id> faces;
  for (Id face = this->part_.firstOwnFace(); face < this->part_.endOfOwnFaces(); ++face)
  {
    if (this->isChosen_[face])
    {
      faces.push_back(face);
    }
  }
  this->patch_ = std::make_unique<ReplicatedPatch>(this->part_, faces);
}

void SourceOnRanks::locateOnPatch(std::vector<LocatedPolyline>& polylines) const
{
  for (LocatedPolyline& polyline : polylines)
  {
    polyline.faces.clear();
    for (const Vec3& point : polyline.points)
    {
      const auto at = std::lower_bound(this->places_.begin(), this->places_.end(), point);
      std::vector<Id>& faces = polyline.faces.emplace_back();
      for (const LocatorOnRanks::Found& found :
        this->faces_[static_cast<std::size_t>(at - this->places_.begin())])
      {
        faces.push_back(this->patch_->faceAt(found.face));
      }
    }
  }
}

std::vector<SourceCurve> SourceOnRanks::boundary() const
{
  return this->otherBoundary_ ? this->boundaryOfOther() : this->boundaryOfPatch();
}

std::vector<SourceCurve> SourceOnRanks::boundaryOfOther() const
{
  std::vector<SourceCurve> curves = *this->otherBoundary_;
  const Id ofPart = this->part_.numberOfGlobalVertices();
  for (SourceCurve& curve : curves)
  {
    for (SurfacePoint& point : curve.points)
    {
      point.id = point.id < ofPart ? this->patch_->vertexAt(point.id)
                                   : point.id - ofPart + this->patch_->mesh().numberOfVertices();
    }
  }
  return curves;
}

std::vector<SourceCurve> SourceOnRanks::boundaryOfPatch() const
{
  const TriangleMesh& mesh = this->patch_->mesh();
  std::vector<SourceCurve> curves = boundaryCurves(mesh);
  // A curve is boundary of the whole or the end of the patch, as the patch has all faces at each
  // vertex on the boundary.
  const auto isEndOfPatch = [&](const SourceCurve& curve)
  {
    const Id halfedge = mesh.halfedgeBetween(curve.points[0].id, curve.points[1].id);
    return !this->patch_->isGlobalBoundary(halfedge);
  };
  curves.erase(std::remove_if(curves.begin(), curves.end(), isEndOfPatch), curves.end());
  return curves;
}

}
