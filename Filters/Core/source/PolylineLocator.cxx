// SPDX-License-Identifier: BSD-3-Clause
#include "source/PolylineLocator.h"

#include "mesh/Box.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// Points located between two calls of the progress callback.
constexpr std::size_t PointsPerReport = 256;

/// The fraction of the progress for the first point, which builds most of the tree.
constexpr double FirstPoint = 0.5;

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

/// The index of each point's place.
std::vector<std::size_t> indicesOf(
  const LocatedPolyline& polyline, const std::vector<Vec3>& sortedPlaces)
{
  std::vector<std::size_t> indices;
  indices.reserve(polyline.points.size());
  for (const Vec3& p : polyline.points)
  {
    const auto at = std::lower_bound(sortedPlaces.begin(), sortedPlaces.end(), p);
    indices.push_back(static_cast<std::size_t>(at - sortedPlaces.begin()));
  }
  return indices;
}

/// Whether a vertex of the first place and one of the second are in one face.
bool haveCommonFace(
  const TriangleMesh& mesh, const std::vector<Id>& first, const std::vector<Id>& second)
{
  for (const Id a : first)
  {
    for (const Id b : second)
    {
      if (commonFace(mesh, SurfacePoint::atVertex(a), SurfacePoint::atVertex(b)) != NoId)
      {
        return true;
      }
    }
  }
  return false;
}

/// Whether a polyline runs from vertex to vertex, always in one face. No other equally close face
/// could be better then.
bool isAlongEdges(const TriangleMesh& mesh, const LocatedPolyline& polyline,
  const std::vector<std::size_t>& indices, const std::vector<std::vector<Id>>& vertices)
{
  for (std::size_t i = 0; i < indices.size(); ++i)
  {
    const bool isLast = i + 1 == indices.size();
    const std::size_t next = isLast ? (polyline.closed ? 0 : i) : i + 1;
    if (!haveCommonFace(mesh, vertices[indices[i]], vertices[indices[next]]))
    {
      return false;
    }
  }
  return true;
}

}

/// For each place, the vertices exactly there that belong to a face.
std::vector<std::vector<Id>> PolylineLocator::verticesAt(
  const std::vector<Vec3>& sortedPlaces) const
{
  std::vector<std::vector<Id>> vertices(sortedPlaces.size());
  Box box;
  for (const Vec3& p : sortedPlaces)
  {
    box.add(p);
  }
  for (Id vertex = 0; vertex < this->mesh_.numberOfVertices(); ++vertex)
  {
    const Vec3& p = this->mesh_.point(vertex);
    if (!box.holds(p) || this->mesh_.cornersAt(vertex).size() == 0)
    {
      continue;
    }
    const auto at = std::lower_bound(sortedPlaces.begin(), sortedPlaces.end(), p);
    if (at != sortedPlaces.end() && *at == p)
    {
      vertices[static_cast<std::size_t>(at - sortedPlaces.begin())].push_back(vertex);
    }
  }
  return vertices;
}

/// The faces of places: the closest ones where isSearched is set, else one for each vertex at the
/// place.
std::vector<std::vector<Id>> PolylineLocator::findFaces(const std::vector<Vec3>& places,
  const std::vector<std::vector<Id>>& vertices, const std::vector<std::uint8_t>& isSearched,
  double coordinatePrecision, const ProgressCallback& progress)
{
  std::vector<std::vector<Id>> faces(places.size());
  double done = 0.0;
  const auto report = [&](double fraction)
  {
    done = std::max(done, fraction);
    return !progress || progress(done);
  };
  const auto growing = [&](double fraction) { return report(FirstPoint * fraction); };
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double fraction = static_cast<double>(i) / static_cast<double>(places.size());
    if (i % PointsPerReport == 0 &&
      !report(i == 0 ? 0.0 : FirstPoint + (1.0 - FirstPoint) * fraction))
    {
      throw Aborted();
    }
    if (isSearched[i])
    {
      faces[i] = this->faceLocator_->closest(places[i], coordinatePrecision, growing);
      continue;
    }
    for (const Id vertex : vertices[i])
    {
      faces[i].push_back(TriangleMesh::faceOf(*this->mesh_.cornersAt(vertex).begin()));
    }
    std::sort(faces[i].begin(), faces[i].end());
  }
  return faces;
}

void PolylineLocator::locate(std::vector<LocatedPolyline>& polylines, double coordinatePrecision,
  const ProgressCallback& progress)
{
  const std::vector<Vec3> places = placesOf(polylines);
  const std::vector<std::vector<Id>> vertices = this->verticesAt(places);
  std::vector<std::uint8_t> isSearched(places.size(), 0);
  for (const LocatedPolyline& polyline : polylines)
  {
    const std::vector<std::size_t> indices = indicesOf(polyline, places);
    if (!isAlongEdges(this->mesh_, polyline, indices, vertices))
    {
      for (const std::size_t i : indices)
      {
        isSearched[i] = 1;
      }
    }
  }
  const bool isAnySearched = std::find(isSearched.begin(), isSearched.end(), 1) != isSearched.end();
  if (isAnySearched && !this->faceLocator_)
  {
    this->faceLocator_ = std::make_unique<FaceLocator>(this->mesh_);
  }
  const std::vector<std::vector<Id>> faces =
    this->findFaces(places, vertices, isSearched, coordinatePrecision, progress);
  for (LocatedPolyline& polyline : polylines)
  {
    polyline.faces.clear();
    for (const std::size_t i : indicesOf(polyline, places))
    {
      polyline.faces.push_back(faces[i]);
    }
  }
}

}
