// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/SourceFaces.h"

#include "PolyData/Hash.h"
#include "PolyData/reading/LineChains.h"

#include <algorithm>
#include <array>
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

/// An edge of a source's face: its ends, the lower one first, and where the face has it.
struct FaceEdge
{
  std::array<std::uint64_t, 2> ends;
  std::size_t face;
  std::size_t corner;

  bool operator<(const FaceEdge& other) const
  {
    return std::tie(this->ends, this->face, this->corner) <
      std::tie(other.ends, other.face, other.corner);
  }
};

/// The edges that have a length, equal ones side by side.
std::vector<FaceEdge> edgesOf(const std::vector<std::vector<std::uint64_t>>& corners)
{
  std::vector<FaceEdge> edges;
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

/// The region of each face is the first face in it.
class RegionsOfFaces
{
public:
  explicit RegionsOfFaces(std::size_t count)
    : parents_(count)
  {
    std::iota(this->parents_.begin(), this->parents_.end(), std::size_t{ 0 });
  }

  std::size_t of(std::size_t face)
  {
    while (this->parents_[face] != face)
    {
      this->parents_[face] = this->parents_[this->parents_[face]];
      face = this->parents_[face];
    }
    return face;
  }
  void join(std::size_t a, std::size_t b)
  {
    const auto [first, other] = std::minmax({ this->of(a), this->of(b) });
    this->parents_[other] = first;
  }

private:
  std::vector<std::size_t> parents_;
};

LocatedPolyline cornersOf(const LocatedPolyline& face, std::initializer_list<std::size_t> corners)
{
  LocatedPolyline line;
  line.name = face.name;
  line.source = face.source;
  for (const std::size_t i : corners)
  {
    line.points.push_back(face.points[i]);
    line.vertices.push_back(face.vertexOf(i));
    line.pointNames.push_back(face.nameOfPoint(i));
  }
  return line;
}

/// Whether each face repeats another of its region, as a ghost cell does.
std::vector<bool> findRepeats(
  RegionsOfFaces& regions, std::vector<std::vector<std::uint64_t>> corners)
{
  std::set<std::vector<std::uint64_t>> known;
  std::vector<bool> isRepeat;
  for (std::size_t face = 0; face < corners.size(); ++face)
  {
    std::sort(corners[face].begin(), corners[face].end());
    corners[face].push_back(regions.of(face));
    isRepeat.push_back(!known.insert(std::move(corners[face])).second);
  }
  return isRepeat;
}

/// The edges that only one face of a region uses, apart from those that repeat another.
std::vector<FaceEdge> outlinesOf(RegionsOfFaces& regions,
  const std::vector<std::vector<std::uint64_t>>& corners, std::vector<FaceEdge> edges)
{
  const std::vector<bool> isRepeat = findRepeats(regions, corners);
  edges.erase(std::remove_if(edges.begin(), edges.end(),
                [&](const FaceEdge& edge) { return isRepeat[edge.face]; }),
    edges.end());
  std::vector<FaceEdge> outlines;
  std::unordered_map<std::size_t, std::size_t> uses;
  for (auto edge = edges.begin(); edge != edges.end();)
  {
    const auto next = std::find_if(
      edge, edges.end(), [&](const FaceEdge& other) { return other.ends != edge->ends; });
    uses.clear();
    std::for_each(edge, next, [&](const FaceEdge& use) { ++uses[regions.of(use.face)]; });
    std::copy_if(edge, next, std::back_inserter(outlines),
      [&](const FaceEdge& use) { return uses[regions.of(use.face)] == 1; });
    edge = next;
  }
  return outlines;
}

} // anonymous namespace

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

void makeRegions(SourceCells& cells, bool areJoined)
{
  std::vector<const LocatedPolyline*> faces; // the parts of all
  std::vector<SourceFace*> wholes;
  for (SourceFace& face : cells.faces)
  {
    wholes.insert(wholes.end(), face.parts.size(), &face);
    std::transform(face.parts.begin(), face.parts.end(), std::back_inserter(faces),
      [](const LocatedPolyline& part) { return &part; });
  }
  RegionsOfFaces regions(faces.size());
  std::unordered_map<vtkIdType, std::size_t> withValue;
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    const vtkIdType value = cells.valueOf(faces[face]->source);
    regions.join(withValue.emplace(value, face).first->second, face);
  }
  const std::vector<std::vector<std::uint64_t>> corners = numberCorners(faces);
  const std::vector<FaceEdge> edges = edgesOf(corners);
  for (std::size_t i = 1; areJoined && i < edges.size(); ++i)
  {
    if (edges[i].ends == edges[i - 1].ends)
    {
      regions.join(edges[i].face, edges[i - 1].face);
    }
  }
  std::vector<std::size_t> lines;
  std::vector<vtkIdType> regionOfLine;
  std::vector<bool> hasOutline(faces.size(), false);
  const auto add = [&](std::size_t face, std::initializer_list<std::size_t> points)
  {
    cells.polylines.push_back(cornersOf(*faces[face], points));
    cells.polylines.back().source = faces[regions.of(face)]->source;
  };
  for (const FaceEdge& edge : outlinesOf(regions, corners, edges))
  {
    const std::size_t region = regions.of(edge.face);
    hasOutline[region] = true;
    lines.push_back(cells.polylines.size());
    regionOfLine.push_back(static_cast<vtkIdType>(region));
    add(edge.face, { edge.corner, (edge.corner + 1) % corners[edge.face].size() });
  }
  joinLines(cells.polylines, lines, regionOfLine);
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    wholes[face]->outline.source = faces[regions.of(face)]->source;
    if (regions.of(face) == face && !hasOutline[face])
    {
      add(face, { 0 });
    }
  }
}

}
