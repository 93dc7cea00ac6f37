// SPDX-License-Identifier: BSD-3-Clause
#include "source/PolylineLocator.h"

#include "mesh/Box.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

namespace
{

/// The different places in space of all polylines' points, sorted.
std::vector<Vec3> placesOf(const std::vector<LocatedPolyline>& polylines)
{
  std::vector<Vec3> places;
  for (const LocatedPolyline& polyline : polylines)
  {
    places.insert(places.end(), polyline.points.begin(), polyline.points.end());
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

/// Whether a vertex of the first place and one of the second are in one face.
bool haveCommonFace(
  const TriangleMesh& mesh, const std::vector<Id>& first, const std::vector<Id>& second)
{
  const auto areInOne = [&mesh](Id a, Id b)
  { return commonFace(mesh, SurfacePoint::atVertex(a), SurfacePoint::atVertex(b)) != NoId; };
  return std::any_of(first.begin(), first.end(),
    [&](Id a)
    { return std::any_of(second.begin(), second.end(), [&](Id b) { return areInOne(a, b); }); });
}

/// Whether a polyline runs from vertex to vertex, always in one face. No other equally close face
/// could be better then.
bool isAlongEdges(const TriangleMesh& mesh, const LocatedPolyline& polyline,
  const LocatedPlaces& located, const std::vector<std::vector<Id>>& vertices)
{
  const std::size_t count = polyline.points.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool isLast = i + 1 == count;
    const std::size_t next = isLast ? (polyline.closed ? 0 : i) : i + 1;
    if (!haveCommonFace(mesh, vertices[located.indexOf(polyline.points[i])],
          vertices[located.indexOf(polyline.points[next])]))
    {
      return false;
    }
  }
  return true;
}

/// For each of some places the vertices, with faces, that lie exactly there.
std::vector<std::vector<Id>> verticesAt(const TriangleMesh& mesh, const std::vector<Vec3>& places)
{
  std::vector<std::vector<Id>> vertices(places.size());
  Box box;
  for (const Vec3& p : places)
  {
    box.add(p);
  }
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    const Vec3& p = mesh.point(vertex);
    if (!box.holds(p) || mesh.cornersAt(vertex).size() == 0)
    {
      continue;
    }
    const auto at = std::lower_bound(places.begin(), places.end(), p);
    if (at != places.end() && *at == p)
    {
      vertices[static_cast<std::size_t>(at - places.begin())].push_back(vertex);
    }
  }
  return vertices;
}

/// Those of polylines that leave the edges. With several ranks all are: a rank does not know the
/// vertices of the others.
std::vector<std::uint8_t> placesToSearch(const MeshPartition& surface,
  const std::vector<LocatedPolyline>& polylines, const LocatedPlaces& located,
  const std::vector<std::vector<Id>>& vertices)
{
  const bool isDistributed = surface.isDistributed();
  std::vector<std::uint8_t> isSearched(located.places.size(), isDistributed ? 1 : 0);
  for (const LocatedPolyline& polyline : polylines)
  {
    if (!isDistributed && !isAlongEdges(surface.mesh(), polyline, located, vertices))
    {
      for (const Vec3& p : polyline.points)
      {
        isSearched[located.indexOf(p)] = 1;
      }
    }
  }
  return isSearched;
}

/// One face for each of the vertices at a place, by number.
std::vector<ClosestFace> facesAt(const MeshPartition& surface, const std::vector<Id>& vertices)
{
  std::vector<ClosestFace> faces;
  for (const Id vertex : vertices)
  {
    const Id corner = *surface.mesh().cornersAt(vertex).begin();
    faces.push_back({ surface.addressOf(TriangleMesh::faceOf(corner)) });
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

} // anonymous namespace

std::size_t LocatedPlaces::indexOf(const Vec3& place) const
{
  const auto at = std::lower_bound(this->places.begin(), this->places.end(), place);
  return static_cast<std::size_t>(at - this->places.begin());
}

void LocatedPlaces::setFaces(
  const ReplicatedPatch& patch, std::vector<LocatedPolyline>& polylines) const
{
  for (LocatedPolyline& polyline : polylines)
  {
    polyline.faces.clear();
    for (const Vec3& point : polyline.points)
    {
      std::vector<Id>& onPatch = polyline.faces.emplace_back();
      for (const ClosestFace& found : this->faces[this->indexOf(point)])
      {
        onPatch.push_back(patch.faceAt(found.face));
      }
    }
  }
}

LocatedPlaces PolylineLocator::locate(const std::vector<LocatedPolyline>& polylines,
  double coordinatePrecision, const ProgressCallback& progress)
{
  reportProgress(progress, 0.0);
  LocatedPlaces located;
  located.places = placesOf(polylines);
  const std::vector<std::vector<Id>> vertices = verticesAt(this->surface_.mesh(), located.places);
  const std::vector<std::uint8_t> isSearched =
    placesToSearch(this->surface_, polylines, located, vertices);
  located.faces = this->locator_.closest(located.places, isSearched, coordinatePrecision, progress);
  for (std::size_t i = 0; i < isSearched.size(); ++i)
  {
    if (!isSearched[i])
    {
      located.faces[i] = facesAt(this->surface_, vertices[i]);
    }
  }
  return located;
}

}
