// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/SourceFaces.h"

#include "PolyData/Hash.h"
#include "PolyData/reading/LineChains.h"
#include "mesh/FacesWithoutArea.h"
#include "mesh/PolygonTriangles.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <numeric>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace geodesic
{

namespace
{

/// The numbers of each face's corners: points at one place have one number, in the order of their
/// first corners.
std::vector<std::vector<std::uint64_t>> numberCorners(
  const std::vector<const LocatedPolyline*>& faces)
{
  using Place = std::array<double, 4>;
  std::unordered_map<Place, std::uint64_t, Hash> numbers;
  std::vector<std::vector<std::uint64_t>> corners;
  for (const LocatedPolyline* face : faces)
  {
    std::vector<std::uint64_t>& ofFace = corners.emplace_back();
    for (std::size_t i = 0; i < face->points.size(); ++i)
    {
      const Vec3 p = face->points[i] + Vec3{}; // -0 and 0 are one place
      const Place place = { p[0], p[1], p[2], static_cast<double>(face->vertexOf(i)) };
      ofFace.push_back(numbers.emplace(place, numbers.size()).first->second);
    }
  }
  return corners;
}

/// An edge of a source's face: its ends, the lower one first, and where the face has it.
struct RegionEdge
{
  std::array<std::uint64_t, 2> ends;
  std::size_t face;
  std::size_t corner;

  bool operator<(const RegionEdge& other) const
  {
    return std::tie(this->ends, this->face, this->corner) <
      std::tie(other.ends, other.face, other.corner);
  }
};

/// The edges that have a length, equal ones side by side.
std::vector<RegionEdge> edgesOf(const std::vector<std::vector<std::uint64_t>>& corners)
{
  std::vector<RegionEdge> edges;
  for (std::size_t face = 0; face < corners.size(); ++face)
  {
    const std::size_t count = corners[face].size();
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::uint64_t a = corners[face][i];
      const std::uint64_t b = corners[face][(i + 1) % count];
      if (a != b)
      {
        edges.push_back({ { std::min(a, b), std::max(a, b) }, face, i });
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// The region of each face, which is the first face in it. Faces with one value are one region and,
/// if they are joined, those with a common edge.
std::vector<std::size_t> findRegions(
  const std::vector<vtkIdType>& values, const std::vector<RegionEdge>& edges, bool areJoined)
{
  std::vector<std::size_t> regions(values.size());
  std::iota(regions.begin(), regions.end(), std::size_t{ 0 });
  const auto regionOf = [&regions](std::size_t face)
  {
    while (regions[face] != face)
    {
      face = regions[face] = regions[regions[face]];
    }
    return face;
  };
  const auto join = [&](std::size_t a, std::size_t b)
  {
    const auto [first, other] = std::minmax({ regionOf(a), regionOf(b) });
    regions[other] = first;
  };
  std::unordered_map<vtkIdType, std::size_t> withValue;
  for (std::size_t face = 0; face < values.size(); ++face)
  {
    join(withValue.emplace(values[face], face).first->second, face);
  }
  for (std::size_t i = 1; areJoined && i < edges.size(); ++i)
  {
    if (edges[i].ends == edges[i - 1].ends)
    {
      join(edges[i].face, edges[i - 1].face);
    }
  }
  for (std::size_t& region : regions)
  {
    region = regionOf(region);
  }
  return regions;
}

void addCorner(const LocatedPolyline& from, std::size_t corner, LocatedPolyline& line)
{
  line.points.push_back(from.points[corner]);
  line.vertices.push_back(from.vertexOf(corner));
  line.pointNames.push_back(from.nameOfPoint(corner));
}

/// A line of a face through some of these points.
LocatedPolyline cornersOf(const LocatedPolyline& face, const LocatedPolyline& points,
  std::initializer_list<std::size_t> corners)
{
  LocatedPolyline line;
  line.name = face.name;
  line.source = face.source;
  for (const std::size_t i : corners)
  {
    addCorner(points, i, line);
  }
  return line;
}

/// Cuts the triangles of faces, on the places of all corners, as those of a surface where faces
/// have no area.
class FaceCutter
{
public:
  explicit FaceCutter(std::vector<SourceFace>& faces)
    : faces_(faces)
    , isCut_(faces.size(), false)
  {
  }

  /// Makes parts of the triangles that have an area, or of the face itself if it is not cut.
  void makeParts()
  {
    this->addTriangles();
    std::vector<std::uint64_t> keys; // none in one process
    std::vector<Vec3>& points = this->places_.points;
    const CutTriangles cut = removeFacesWithoutArea(
      points, keys, points.size(), this->triangles_, {}, OneRank::instance());
    this->places_.vertices.resize(points.size(), NoId);
    this->places_.pointNames.resize(points.size());
    const std::vector<Triangle>& parts = cut.isEmpty() ? this->triangles_ : cut.parts;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      this->addPart(parts[i], cut.isEmpty() ? i : cut.triangles[i]);
    }
    for (std::size_t face = 0; face < this->faces_.size(); ++face)
    {
      if (!this->isCut_[face])
      {
        this->faces_[face].parts = { this->faces_[face].outline };
      }
    }
  }

private:
  void addTriangles()
  {
    std::vector<const LocatedPolyline*> outlines;
    for (const SourceFace& face : this->faces_)
    {
      outlines.push_back(&face.outline);
    }
    const std::vector<std::vector<std::uint64_t>> corners = numberCorners(outlines);
    for (std::size_t face = 0; face < corners.size(); ++face)
    {
      const LocatedPolyline& outline = *outlines[face];
      for (std::size_t i = 0; i < outline.points.size(); ++i)
      {
        if (corners[face][i] == this->numberOfCorners_)
        {
          addCorner(outline, i, this->places_);
          ++this->numberOfCorners_;
        }
      }
      this->faces_[face].triangles = triangulatePolygon(outline.points).triangles;
      for (const Triangle& t : this->faces_[face].triangles)
      {
        const auto number = [&](std::size_t k) { return static_cast<Id>(corners[face][t[k]]); };
        const Triangle triangle = { number(0), number(1), number(2) };
        this->isCut_[face] = this->isCut_[face] || !hasThreeVertices(triangle);
        if (hasThreeVertices(triangle))
        {
          this->triangles_.push_back(triangle);
          this->faceOf_.push_back(face);
        }
      }
    }
  }

  void addPart(const Triangle& part, std::size_t triangle)
  {
    const std::size_t face = this->faceOf_[triangle];
    LocatedPolyline polygon =
      cornersOf(this->faces_[face].outline, this->places_, { part[0], part[1], part[2] });
    const std::array<Vec3, 3> corners = { polygon.points[0], polygon.points[1], polygon.points[2] };
    const bool hasArea = !isWithoutArea(shapeOf(corners), corners);
    this->isCut_[face] = this->isCut_[face] || part != this->triangles_[triangle] || !hasArea;
    if (hasArea)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const bool isNew = part[k] >= this->numberOfCorners_;
        polygon.pointNames[k] = isNew ? polygon.name : polygon.pointNames[k];
      }
      polygon.closed = true;
      this->faces_[face].parts.push_back(std::move(polygon));
    }
  }

  std::vector<SourceFace>& faces_;
  /// The places of corners, each with the name of the first corner there, then those that a cut
  /// adds.
  LocatedPolyline places_;
  std::size_t numberOfCorners_ = 0;
  std::vector<Triangle> triangles_;
  std::vector<std::size_t> faceOf_;
  /// Whether a face is not the whole of its triangles as they are.
  std::vector<bool> isCut_;
};

/// Whether each face repeats another of its region, as a ghost cell does.
std::vector<bool> findRepeats(
  const std::vector<std::size_t>& regions, std::vector<std::vector<std::uint64_t>> corners)
{
  std::set<std::vector<std::uint64_t>> known;
  std::vector<bool> isRepeat;
  for (std::size_t face = 0; face < corners.size(); ++face)
  {
    std::sort(corners[face].begin(), corners[face].end());
    corners[face].push_back(regions[face]);
    isRepeat.push_back(!known.insert(std::move(corners[face])).second);
  }
  return isRepeat;
}

/// The edges that only one face of a region uses, apart from those that repeat another.
std::vector<RegionEdge> outlinesOf(const std::vector<std::size_t>& regions,
  const std::vector<bool>& isRepeat, const std::vector<RegionEdge>& edges)
{
  std::vector<RegionEdge> outlines;
  std::unordered_map<std::size_t, std::size_t> uses;
  for (auto edge = edges.begin(); edge != edges.end();)
  {
    const auto next = std::find_if(
      edge, edges.end(), [&](const RegionEdge& other) { return other.ends != edge->ends; });
    uses.clear();
    std::for_each(edge, next,
      [&](const RegionEdge& use) { uses[regions[use.face]] += isRepeat[use.face] ? 0 : 1; });
    std::copy_if(edge, next, std::back_inserter(outlines),
      [&](const RegionEdge& use) { return !isRepeat[use.face] && uses[regions[use.face]] == 1; });
    edge = next;
  }
  return outlines;
}

} // anonymous namespace

void cutAtFacesWithoutArea(std::vector<SourceFace>& faces)
{
  FaceCutter(faces).makeParts();
  const auto isWithoutArea = [](const SourceFace& face) { return face.parts.empty(); };
  if (!std::all_of(faces.begin(), faces.end(), isWithoutArea))
  {
    faces.erase(std::remove_if(faces.begin(), faces.end(), isWithoutArea), faces.end());
    return;
  }
  for (SourceFace& face : faces)
  {
    face.parts = { face.outline };
  }
}

void makeRegions(SourceCells& cells, bool areJoined)
{
  std::vector<const LocatedPolyline*> faces; // the parts of all
  std::vector<SourceFace*> wholes;
  std::vector<vtkIdType> values;
  for (SourceFace& face : cells.faces)
  {
    for (const LocatedPolyline& part : face.parts)
    {
      faces.push_back(&part);
      wholes.push_back(&face);
      values.push_back(cells.valueOf(part.source));
    }
  }
  const std::vector<std::vector<std::uint64_t>> corners = numberCorners(faces);
  const std::vector<RegionEdge> edges = edgesOf(corners);
  const std::vector<std::size_t> regions = findRegions(values, edges, areJoined);
  std::vector<std::size_t> lines;
  std::vector<vtkIdType> regionOfLine;
  std::vector<bool> hasOutline(faces.size(), false);
  const auto add = [&](std::size_t face, std::initializer_list<std::size_t> points)
  {
    cells.polylines.push_back(cornersOf(*faces[face], *faces[face], points));
    cells.polylines.back().source = faces[regions[face]]->source;
  };
  for (const RegionEdge& edge : outlinesOf(regions, findRepeats(regions, corners), edges))
  {
    hasOutline[regions[edge.face]] = true;
    lines.push_back(cells.polylines.size());
    regionOfLine.push_back(static_cast<vtkIdType>(regions[edge.face]));
    add(edge.face, { edge.corner, (edge.corner + 1) % corners[edge.face].size() });
  }
  joinLines(cells.polylines, lines, regionOfLine);
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    wholes[face]->outline.source = faces[regions[face]]->source;
    if (regions[face] == face && !hasOutline[face])
    {
      add(face, { 0 });
    }
  }
}

}
