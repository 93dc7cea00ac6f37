// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/ranks/SourcePatch.h"

#include "source/BoundaryCurves.h"

#include <algorithm>
#include <array>
#include <set>

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

bool SourcePatch::addFaces(const std::vector<Id>& faces)
{
  for (const Id face : faces)
  {
    this->isChosen_[face] = 1;
  }
  return this->surface_.exchange().isTrueAnywhere(!faces.empty());
}

void SourcePatch::addBoundary(const std::vector<SourceCurve>& loops)
{
  std::vector<GlobalId> globalIds;
  for (const SourceCurve& loop : loops)
  {
    for (const SurfacePoint& point : loop.points)
    {
      globalIds.push_back(GlobalId{ point.id });
    }
  }
  std::sort(globalIds.begin(), globalIds.end());
  for (Id vertex = 0; !this->isChosen_.empty() && vertex < this->surface_.numberOfOwnVertices();
       ++vertex)
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

/// An edge of a triangle, from corner k to the next, and the vertex opposite.
///
/// \param idOf (Id) -> GlobalId.
template <typename IdOf>
FaceEdge edgeOf(const Triangle& t, std::size_t k, const IdOf& idOf)
{
  const auto number = [&](std::size_t i) { return static_cast<std::uint64_t>(idOf(t[i % 3])); };
  return { number(k), number(k + 1), number(k + 2) };
}

/// Adds the edges on the boundary of a partition, of faces that this rank owns.
///
/// \param idOf of a vertex of the partition: (Id) -> GlobalId.
template <typename IdOf>
void addBoundaryOf(const MeshPartition& partition, const IdOf& idOf, std::vector<FaceEdge>& edges)
{
  const TriangleMesh& mesh = partition.mesh();
  for (Id face = partition.firstOwnFace(); face < partition.endOfOwnFaces(); ++face)
  {
    const Triangle& t = mesh.triangle(face);
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (mesh.isBoundary(TriangleMesh::halfedgeOf(face, static_cast<Id>(k))))
      {
        edges.push_back(edgeOf(t, k, idOf));
      }
    }
  }
}

/// Of the edges of all faces, barriers or not, those on the boundary of one or the other.
///
/// \param edges on the boundary of the open faces, of this rank; then those of all faces.
void addBarriers(const PolyDataSurface& surface, std::vector<FaceEdge>& edges)
{
  const std::vector<GlobalVertex> remote = surface.remoteVertices();
  const Id inMesh = surface.mesh().numberOfVertices();
  const auto idOf = [&](Id vertex) {
    return vertex < inMesh ? surface.partition.globalId(vertex) : remote[vertex - inMesh].globalId;
  };
  addBoundaryOf(
    surface.barriers->surface(), [&](Id i) { return idOf(surface.barrierVertices[i]); }, edges);
  std::set<std::array<std::uint64_t, 2>> rims;
  for (const FaceEdge& edge : valuesOfRanks(surface.exchange(), edges))
  {
    rims.insert(endsOf(edge));
  }
  edges.clear();
  for (Id part = 0; part < surface.numberOfParts; ++part)
  {
    const Triangle t = surface.verticesAt(part);
    for (std::size_t k = 0; k < 3 && surface.isFace(part); ++k)
    {
      const FaceEdge edge = edgeOf(t, k, idOf);
      if (rims.count(endsOf(edge)) > 0)
      {
        edges.push_back(edge);
      }
    }
  }
}

} // anonymous namespace

std::vector<SourceCurve> boundaryOfAllFaces(const PolyDataSurface& surface)
{
  std::vector<FaceEdge> own;
  addBoundaryOf(
    surface.partition, [&](Id vertex) { return surface.partition.globalId(vertex); }, own);
  if (surface.barriers)
  {
    addBarriers(surface, own);
  }
  std::vector<Id> ends;
  for (const FaceEdge& edge : edgesOfOneFace(valuesOfRanks(surface.exchange(), own)))
  {
    ends.insert(ends.end(), { static_cast<Id>(edge[0]), static_cast<Id>(edge[1]) });
  }
  return curvesAlong(ends, std::vector<Id>(ends.size() / 2, NoId));
}

}
