// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/ranks/SourcePatch.h"

#include "source/BoundaryCurves.h"

#include <algorithm>
#include <unordered_map>

namespace geodesic
{

void SourcePatch::addFacesAround(const LocatedPlaces& located)
{
  for (const std::vector<ClosestFace>& faces : located.faces)
  {
    for (const ClosestFace& found : faces)
    {
      this->addFacesAround(found.face);
    }
  }
}

void SourcePatch::addFacesAround(const RankAddress& address)
{
  const Id face = this->surface_.isDistributed() ? this->surface_.faceAt(address) : NoId;
  if (face != NoId)
  {
    this->addFacesAround(face);
  }
}

/// Segments of a curve lie in the faces of its points, and points may be put onto their vertices:
/// all faces there belong to the patch.
void SourcePatch::addFacesAround(Id face)
{
  for (const Id vertex : this->surface_.mesh().triangle(face))
  {
    this->addFacesAtVertex(vertex);
  }
}

void SourcePatch::addFacesAtVertex(Id vertex)
{
  for (const Id corner : this->surface_.mesh().cornersAt(vertex))
  {
    this->isChosen_[TriangleMesh::faceOf(corner)] = 1;
  }
}

void SourcePatch::addBoundary()
{
  if (!this->surface_.isDistributed())
  {
    return;
  }
  const TriangleMesh& mesh = this->surface_.mesh();
  for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
  {
    // At the vertices of faces that this rank owns, the partition is as the whole.
    const bool isKnown = mesh.origin(halfedge) < this->surface_.numberOfOwnVertices() ||
      mesh.destination(halfedge) < this->surface_.numberOfOwnVertices();
    if (mesh.isBoundary(halfedge) && isKnown)
    {
      this->addFacesAround(TriangleMesh::faceOf(halfedge));
    }
  }
}

bool SourcePatch::addFaces(const std::vector<Id>& faces)
{
  for (const Id face : faces)
  {
    this->isChosen_[face] = 1;
  }
  return this->surface_.exchange().isTrueAnywhere(!faces.empty());
}

void SourcePatch::addFacesAt(const std::vector<Id>& globalIds)
{
  if (!this->surface_.isDistributed())
  {
    return;
  }
  for (Id vertex = 0; vertex < this->surface_.numberOfOwnVertices(); ++vertex)
  {
    if (std::binary_search(globalIds.begin(), globalIds.end(), this->surface_.globalId(vertex)))
    {
      this->addFacesAtVertex(vertex);
    }
  }
}

ReplicatedPatch SourcePatch::make() const
{
  std::vector<Id> faces;
  for (Id face = 0; face < this->isChosen_.size(); ++face)
  {
    if (this->isChosen_[face] && this->surface_.isOwn(face))
    {
      faces.push_back(face);
    }
  }
  return { this->surface_, faces };
}

namespace
{

/// The curves of a patch's boundary that are boundary of the whole. A curve is that or the end of
/// the patch, as the patch has all faces at each vertex on the boundary.
std::vector<SourceCurve> globalBoundary(const ReplicatedPatch& patch)
{
  const TriangleMesh& mesh = patch.mesh();
  std::vector<SourceCurve> curves = boundaryCurves(mesh);
  const auto isEndOfPatch = [&](const SourceCurve& curve)
  {
    const Id halfedge = mesh.halfedgeBetween(curve.points[0].id, curve.points[1].id);
    return !patch.isGlobalBoundary(halfedge);
  };
  curves.erase(std::remove_if(curves.begin(), curves.end(), isEndOfPatch), curves.end());
  return curves;
}

/// Gives the points of curves on a patch global numbers in place of vertices.
///
/// \param globalIds of the vertices of each rank's own faces.
/// \returns these numbers, ascending.
std::vector<Id> giveGlobalIds(const ReplicatedPatch& patch, const std::vector<Id>& globalIds,
  Exchange& exchange, std::vector<SourceCurve>& curves)
{
  Message message;
  for (const SourceCurve& curve : curves)
  {
    for (const SurfacePoint& point : curve.points)
    {
      if (patch.vertexOfPart(point.id) != NoId)
      {
        put(message, point.id);
        put(message, globalIds[patch.vertexOfPart(point.id)]);
      }
    }
  }
  std::unordered_map<Id, Id> idOf;
  readEach(exchange.tellAll(message),
    [&](int, MessageReader& reader)
    {
      const Id vertex = reader.get<Id>();
      idOf[vertex] = reader.get<Id>();
    });
  std::vector<Id> all;
  for (SourceCurve& curve : curves)
  {
    for (SurfacePoint& point : curve.points)
    {
      point.id = idOf.at(point.id);
      all.push_back(point.id);
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

} // anonymous namespace

SurfaceBoundary::SurfaceBoundary(const PolyDataSurface& surface, SourcePatch& faces, const Job& job)
  : numberOfGlobalVertices_(surface.partition.numberOfGlobalVertices())
{
  if (!surface.barriers)
  {
    faces.addBoundary();
    return;
  }
  std::vector<Id> globalIds;
  const MeshPartition all = surface.partitionWithBarriers(globalIds, job);
  SourcePatch ofAll(all);
  ofAll.addBoundary();
  const ReplicatedPatch patch = ofAll.make();
  this->ofAllFaces_ = globalBoundary(patch);
  faces.addFacesAt(giveGlobalIds(patch, globalIds, all.exchange(), *this->ofAllFaces_));
}

std::vector<SourceCurve> SurfaceBoundary::curvesOn(const ReplicatedPatch& patch) const
{
  if (!this->ofAllFaces_)
  {
    return globalBoundary(patch);
  }
  std::vector<SourceCurve> curves = *this->ofAllFaces_;
  for (SourceCurve& curve : curves)
  {
    for (SurfacePoint& point : curve.points)
    {
      point.id = point.id < this->numberOfGlobalVertices_
        ? patch.vertexAt(point.id)
        : point.id - this->numberOfGlobalVertices_ + patch.mesh().numberOfVertices();
    }
  }
  return curves;
}

}
