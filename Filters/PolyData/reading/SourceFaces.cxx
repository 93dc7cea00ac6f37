// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/SourceFaces.h"

#include "PolyData/Hash.h"
#include "PolyData/reading/LineChains.h"
#include "Tolerance.h"
#include "mesh/FacesWithoutArea.h"
#include "mesh/PolygonTriangles.h"
#include "mesh/SurfaceLocator.h"
#include "mesh/SurfaceSnap.h"

#include <algorithm>
#include <array>
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

/// A corner of one of several faces.
struct CornerOfFace
{
  std::size_t face = 0;
  std::size_t corner = 0;
};

/// The numbers of each face's corners: points at one place have one number.
std::vector<std::vector<std::uint64_t>> numberCorners(const std::vector<LocatedPolyline>& faces)
{
  using Place = std::array<double, 4>;
  std::unordered_map<Place, std::uint64_t, Hash> numbers;
  std::vector<std::vector<std::uint64_t>> corners(faces.size());
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    for (std::size_t i = 0; i < faces[face].points.size(); ++i)
    {
      const Vec3 p = faces[face].points[i] + Vec3{}; // -0 and 0 are one place
      const Place place = { p[0], p[1], p[2], static_cast<double>(faces[face].vertexOf(i)) };
      corners[face].push_back(numbers.emplace(place, numbers.size()).first->second);
    }
  }
  return corners;
}

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

LocatedPolyline lineAlong(const LocatedPolyline& face, std::size_t corner)
{
  LocatedPolyline line;
  line.name = face.name;
  line.source = face.source;
  for (const std::size_t i : { corner, (corner + 1) % face.points.size() })
  {
    line.points.push_back(face.points[i]);
    line.vertices.push_back(face.vertexOf(i));
    line.pointNames.push_back(face.nameOfPoint(i));
  }
  return line;
}

LocatedPolyline firstPointOf(const LocatedPolyline& face)
{
  LocatedPolyline point = lineAlong(face, 0);
  point.points.pop_back();
  point.vertices.pop_back();
  point.pointNames.pop_back();
  return point;
}

/// Gives each face the source of its region. \returns the sources that are gone, ascending.
std::vector<Id> takeSourcesOfRegions(RegionsOfFaces& regions, std::vector<LocatedPolyline>& faces)
{
  std::vector<Id> gone;
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    const Id source = faces[regions.of(face)].source;
    if (faces[face].source != source)
    {
      gone.push_back(faces[face].source);
      faces[face].source = source;
    }
  }
  std::sort(gone.begin(), gone.end());
  return gone;
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

/// The faces of a source as a mesh of triangles of their own.
struct FaceTriangles
{
  std::vector<Vec3> points{};
  std::vector<Triangle> triangles{};
  /// The face of each triangle, and the first triangle of each face.
  std::vector<std::size_t> faces{};
  std::vector<std::size_t> first{};
  Box box{};

  explicit FaceTriangles(const std::vector<LocatedPolyline>& given)
  {
    for (const LocatedPolyline& face : given)
    {
      const Id offset = static_cast<Id>(this->points.size());
      this->first.push_back(this->triangles.size());
      for (const Triangle& t : trianglesOf(face.points))
      {
        this->triangles.push_back({ offset + t[0], offset + t[1], offset + t[2] });
        this->faces.push_back(this->first.size() - 1);
      }
      this->points.insert(this->points.end(), face.points.begin(), face.points.end());
      std::for_each(face.points.begin(), face.points.end(),
        [this](const Vec3& point) { this->box.add(point); });
    }
    this->first.push_back(this->triangles.size());
  }

  static std::vector<Triangle> trianglesOf(const std::vector<Vec3>& corners)
  {
    return corners.size() < 3 ? std::vector<Triangle>() : triangulatePolygon(corners).triangles;
  }
};

Vec3 middleOf(const TriangleMesh& mesh, Id face)
{
  const Triangle& t = mesh.triangle(face);
  return (1.0 / 3.0) * (mesh.point(t[0]) + mesh.point(t[1]) + mesh.point(t[2]));
}

/// The triangles of faces, on the places of all corners, cut as those of a surface where faces have
/// no area.
class CutFaces
{
public:
  explicit CutFaces(const std::vector<LocatedPolyline>& faces)
    : faces_(faces)
    , isCut_(faces.size(), false)
    , parts_(faces.size())
  {
    this->addTriangles();
    std::vector<std::uint64_t> keys; // none in one process
    const CutTriangles cut = removeFacesWithoutArea(
      this->points_, keys, this->points_.size(), this->triangles_, {}, OneRank::instance());
    const std::vector<Triangle>& parts = cut.isEmpty() ? this->triangles_ : cut.parts;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      this->addPart(parts[i], cut.isEmpty() ? i : cut.triangles[i]);
    }
  }

  bool isCut(std::size_t face) const { return this->isCut_[face]; }
  /// Those with an area.
  const std::vector<LocatedPolyline>& partsOf(std::size_t face) const { return this->parts_[face]; }

private:
  void addTriangles()
  {
    const std::vector<std::vector<std::uint64_t>> corners = numberCorners(this->faces_);
    for (std::size_t face = 0; face < corners.size(); ++face)
    {
      for (std::size_t i = 0; i < corners[face].size(); ++i)
      {
        if (corners[face][i] == this->points_.size())
        {
          this->points_.push_back(this->faces_[face].points[i]);
          this->firstAt_.push_back({ face, i });
        }
      }
      for (const Triangle& t : FaceTriangles::trianglesOf(this->faces_[face].points))
      {
        const auto number = [&](std::size_t k) { return static_cast<Id>(corners[face][t[k]]); };
        this->addTriangle({ number(0), number(1), number(2) }, face);
      }
    }
  }

  void addTriangle(const Triangle& triangle, std::size_t face)
  {
    if (!hasThreeVertices(triangle))
    {
      this->isCut_[face] = true;
      return;
    }
    this->triangles_.push_back(triangle);
    this->faceOf_.push_back(face);
  }

  void addPart(const Triangle& part, std::size_t triangle)
  {
    const std::size_t face = this->faceOf_[triangle];
    const std::array<Vec3, 3> corners = { this->points_[part[0]], this->points_[part[1]],
      this->points_[part[2]] };
    const bool hasArea = !isWithoutArea(shapeOf(corners), corners);
    this->isCut_[face] = this->isCut_[face] || part != this->triangles_[triangle] || !hasArea;
    if (hasArea)
    {
      this->parts_[face].push_back(this->polygonOf(part, this->faces_[face]));
    }
  }

  LocatedPolyline polygonOf(const Triangle& part, const LocatedPolyline& face) const
  {
    LocatedPolyline polygon;
    polygon.name = face.name;
    polygon.source = face.source;
    polygon.closed = true;
    for (const Id corner : part)
    {
      const bool isNew = corner >= this->firstAt_.size();
      const CornerOfFace first = isNew ? CornerOfFace{} : this->firstAt_[corner];
      const LocatedPolyline& with = this->faces_[first.face];
      polygon.points.push_back(this->points_[corner]);
      polygon.vertices.push_back(isNew ? NoId : with.vertexOf(first.corner));
      polygon.pointNames.push_back(isNew ? face.name : with.nameOfPoint(first.corner));
    }
    return polygon;
  }

  const std::vector<LocatedPolyline>& faces_;
  /// The place with each number, and the first corner there. A cut may add places.
  std::vector<Vec3> points_;
  std::vector<CornerOfFace> firstAt_;
  std::vector<Triangle> triangles_;
  std::vector<std::size_t> faceOf_;
  /// Whether a face is not the whole of its triangles as they are.
  std::vector<bool> isCut_;
  std::vector<std::vector<LocatedPolyline>> parts_;
};

/// Whether faces of a source cover faces of a surface.
struct CoverTest
{
  const TriangleMesh& surface;
  const FaceTriangles& source;
  const TriangleMesh& sourceMesh;
  double precision;

  /// Corners, middles of edges, and the middle: a polygon covers a triangle on its own corners if
  /// it has these.
  bool isCovered(Id face, std::size_t by) const
  {
    const Triangle& t = this->surface.triangle(face);
    const Vec3& a = this->surface.point(t[0]);
    const Vec3& b = this->surface.point(t[1]);
    const Vec3& c = this->surface.point(t[2]);
    return this->holds(by, a) && this->holds(by, b) && this->holds(by, c) &&
      this->holds(by, 0.5 * (a + b)) && this->holds(by, 0.5 * (b + c)) &&
      this->holds(by, 0.5 * (c + a)) && this->holds(by, middleOf(this->surface, face));
  }

  double area2(std::size_t of) const
  {
    double area2 = 0.0;
    for (std::size_t t = this->source.first[of]; t < this->source.first[of + 1]; ++t)
    {
      area2 += this->sourceMesh.shape(static_cast<Id>(t)).area2;
    }
    return area2;
  }

  bool holds(std::size_t by, const Vec3& point) const
  {
    for (std::size_t t = this->source.first[by]; t < this->source.first[by + 1]; ++t)
    {
      const auto triangle = static_cast<Id>(t);
      const SnappedPoint there = snapToFace(this->sourceMesh, triangle, point, this->precision);
      const double cut = this->sourceMesh.shape(triangle).roundingOfCuts();
      if (there.distance <= std::max(there.tolerance, cut))
      {
        return true;
      }
    }
    return false;
  }
};

} // anonymous namespace

std::vector<Id> makeRegions(std::vector<LocatedPolyline>& faces,
  const std::vector<vtkIdType>& values, bool areJoined, std::vector<LocatedPolyline>& polylines)
{
  RegionsOfFaces regions(faces.size());
  std::unordered_map<vtkIdType, std::size_t> withValue;
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    regions.join(withValue.emplace(values[face], face).first->second, face);
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
  std::vector<Id> gone = takeSourcesOfRegions(regions, faces);
  std::vector<std::size_t> lines;
  std::vector<vtkIdType> regionOfLine;
  std::vector<bool> hasOutline(faces.size(), false);
  for (const FaceEdge& edge : outlinesOf(regions, corners, edges))
  {
    const std::size_t region = regions.of(edge.face);
    hasOutline[region] = true;
    lines.push_back(polylines.size());
    regionOfLine.push_back(static_cast<vtkIdType>(region));
    polylines.push_back(lineAlong(faces[edge.face], edge.corner));
  }
  joinLines(polylines, lines, regionOfLine);
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    if (regions.of(face) == face && !hasOutline[face])
    {
      polylines.push_back(firstPointOf(faces[face]));
    }
  }
  return gone;
}

std::vector<std::vector<LocatedPolyline>> cutAtFacesWithoutArea(std::vector<LocatedPolyline>& faces)
{
  const CutFaces cut(faces);
  std::vector<std::vector<LocatedPolyline>> parts;
  std::vector<bool> isLeft;
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    parts.push_back(
      cut.isCut(face) ? cut.partsOf(face) : std::vector<LocatedPolyline>{ faces[face] });
    isLeft.push_back(!parts.back().empty());
  }
  if (std::count(isLeft.begin(), isLeft.end(), true) == 0)
  {
    for (std::size_t face = 0; face < faces.size(); ++face)
    {
      parts[face] = { faces[face] };
    }
    return parts;
  }
  std::size_t left = 0;
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    if (isLeft[face])
    {
      std::swap(faces[left], faces[face]);
      std::swap(parts[left], parts[face]);
      ++left;
    }
  }
  faces.resize(left);
  parts.resize(left);
  return parts;
}

std::vector<LocatedPolyline> pointsInside(const std::vector<LocatedPolyline>& faces)
{
  const FaceTriangles source(faces);
  const TriangleMesh mesh(source.points, source.triangles);
  std::vector<LocatedPolyline> inside;
  for (const LocatedPolyline& face : faces)
  {
    inside.push_back(firstPointOf(face));
  }
  std::vector<double> largest(faces.size(), -1.0);
  for (Id triangle = 0; triangle < mesh.numberOfFaces(); ++triangle)
  {
    const std::size_t face = source.faces[mesh.inputFace(triangle)];
    if (mesh.shape(triangle).area2 > largest[face])
    {
      largest[face] = mesh.shape(triangle).area2;
      inside[face].points = { middleOf(mesh, triangle) };
    }
  }
  return inside;
}

std::vector<CoveredFace> findCoveredFaces(const TriangleMesh& surface,
  const std::vector<LocatedPolyline>& faces, double coordinatePrecision, bool isPart,
  const Job& job)
{
  const FaceTriangles source(faces);
  if (source.triangles.empty())
  {
    return {};
  }
  std::vector<Vec3> middles;
  std::vector<std::uint8_t> isWanted;
  for (Id face = 0; face < surface.numberOfFaces(); ++face)
  {
    middles.push_back(middleOf(surface, face));
    isWanted.push_back(source.box.distanceTo(middles.back()) <= surface.shape(face).longest());
  }
  const TriangleMesh mesh(source.points, source.triangles);
  const CoverTest test = { surface, source, mesh, coordinatePrecision };
  const ClosestFaces closest =
    SurfaceLocator(MeshPartition(mesh)).closest(middles, isWanted, coordinatePrecision, job);
  std::vector<CoveredFace> inside;
  std::vector<double> areas(faces.size(), 0.0);
  for (Id face = 0; face < surface.numberOfFaces(); ++face)
  {
    for (const ClosestFace& found : closest[face])
    {
      const std::size_t by = source.faces[mesh.inputFace(found.face.id)];
      const bool isKnown = !inside.empty() && inside.back().face == face &&
        inside.back().source == static_cast<Id>(by);
      if (!isKnown && test.isCovered(face, by))
      {
        inside.push_back({ face, static_cast<Id>(by) });
        areas[by] += surface.shape(face).area2;
      }
    }
  }
  std::vector<CoveredFace> covered;
  for (const CoveredFace& found : inside)
  {
    if (isPart || areas[found.source] >= (1.0 - tolerance::CoveredArea) * test.area2(found.source))
    {
      covered.push_back({ found.face, faces[found.source].source });
    }
  }
  return covered;
}

}
