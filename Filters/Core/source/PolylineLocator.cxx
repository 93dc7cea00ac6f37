// SPDX-License-Identifier: BSD-3-Clause
#include "source/PolylineLocator.h"

#include "mesh/Box.h"
#include "source/SideChoice.h"

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
bool haveCommonFace(const TriangleMesh& mesh, const IdRange& first, const IdRange& second)
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
  const auto at = [&](std::size_t i) -> IdRange
  {
    if (polyline.vertexOf(i) != NoId)
    {
      return { &polyline.vertices[i], &polyline.vertices[i] + 1 };
    }
    const std::vector<Id>& there = vertices[located.indexOf(polyline.points[i])];
    return { there.data(), there.data() + there.size() };
  };
  const std::size_t count = polyline.points.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t before = i > 0 ? i - 1 : polyline.closed ? count - 1 : 0;
    if (!haveCommonFace(mesh, at(before), at(i)))
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
    if (const Id i = indexIn(places, p); i != NoId)
    {
      vertices[i].push_back(vertex);
    }
  }
  return vertices;
}

/// Those of polylines that leave the edges.
std::vector<std::uint8_t> placesOffEdges(const TriangleMesh& mesh,
  const std::vector<LocatedPolyline>& polylines, const LocatedPlaces& located,
  const std::vector<std::vector<Id>>& vertices)
{
  std::vector<std::uint8_t> isOff(located.places.size(), 0);
  for (const LocatedPolyline& polyline : polylines)
  {
    if (!isAlongEdges(mesh, polyline, located, vertices))
    {
      for (const Vec3& p : polyline.points)
      {
        isOff[located.indexOf(p)] = 1;
      }
    }
  }
  return isOff;
}

/// One face of a mesh on one rank for each of the vertices at a place, by number.
std::vector<ClosestFace> facesAt(const TriangleMesh& mesh, const std::vector<Id>& vertices)
{
  std::vector<ClosestFace> faces;
  for (const Id vertex : vertices)
  {
    faces.push_back({ { 0, someFace(mesh, SurfacePoint::atVertex(vertex)) } });
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

} // anonymous namespace

void LocatedPlaces::setFaces(
  const ReplicatedPatch& patch, std::vector<LocatedPolyline>& polylines) const
{
  for (LocatedPolyline& polyline : polylines)
  {
    polyline.faces.clear();
    for (std::size_t i = 0; i < polyline.points.size(); ++i)
    {
      std::vector<Id>& onPatch = polyline.faces.emplace_back();
      if (polyline.vertexOf(i) != NoId)
      {
        onPatch.push_back(someFace(patch.mesh(), SurfacePoint::atVertex(polyline.vertices[i])));
        continue;
      }
      for (const ClosestFace& found : this->faces[this->indexOf(polyline.points[i])])
      {
        onPatch.push_back(patch.faceAt(found.face));
      }
    }
  }
}

LocatedPlaces PolylineLocator::locate(
  const std::vector<LocatedPolyline>& polylines, double coordinatePrecision, const Job& job)
{
  job.reach(0.0);
  LocatedPlaces located;
  located.places = placesOf(polylines);
  // With several ranks all places are searched: a rank does not know the vertices of the others.
  std::vector<std::uint8_t> isSearched(located.places.size(), 1);
  std::vector<std::vector<Id>> vertices;
  const TriangleMesh& mesh = this->locator_.surface().mesh();
  if (!this->locator_.surface().isDistributed())
  {
    vertices = verticesAt(mesh, located.places);
    isSearched = placesOffEdges(mesh, polylines, located, vertices);
  }
  located.faces = this->locator_.closest(located.places, isSearched, coordinatePrecision, job);
  for (std::size_t i = 0; i < isSearched.size(); ++i)
  {
    if (!isSearched[i])
    {
      located.faces[i] = facesAt(mesh, vertices[i]);
    }
  }
  return located;
}

void PolylineLocator::keepOnOneSide(const std::vector<LocatedPolyline>& polylines,
  double coordinatePrecision, LocatedPlaces& located, const Job& job)
{
  std::vector<RowOfPlaces> rows;
  std::vector<std::uint8_t> isWanted(located.places.size(), 0);
  for (const LocatedPolyline& polyline : polylines)
  {
    RowOfPlaces row = { {}, polyline.closed };
    bool isBeside = false;
    for (const Vec3& p : polyline.points)
    {
      row.places.push_back(located.indexOf(p));
      const std::vector<ClosestFace>& faces = located.faces[row.places.back()];
      isBeside = isBeside || (!faces.empty() && faces.front().isBeside);
    }
    if (isBeside && row.places.size() > 1)
    {
      for (const std::size_t place : row.places)
      {
        isWanted[place] = 1;
      }
      rows.push_back(std::move(row));
    }
  }
  if (rows.empty())
  {
    return;
  }
  ClosestFaces opposite =
    this->locator_.opposite(located.places, isWanted, located.faces, coordinatePrecision, job);
  const std::vector<std::uint8_t> isOpposite =
    chooseSides(located.places, rows, located.faces, opposite);
  for (std::size_t i = 0; i < isOpposite.size(); ++i)
  {
    if (isOpposite[i])
    {
      located.faces[i] = std::move(opposite[i]);
    }
  }
}

}
