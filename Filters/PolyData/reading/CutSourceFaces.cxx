// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/CutSourceFaces.h"

#include "PolyData/reading/SourceFaces.h"
#include "mesh/FacesWithoutArea.h"
#include "mesh/PolygonTriangles.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace geodesic
{

namespace
{

/// A corner of one of several faces.
struct CornerOfFace
{
  std::size_t face = 0;
  std::size_t corner = 0;
};

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
      for (const Triangle& t : triangulatePolygon(this->faces_[face].points).triangles)
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

} // anonymous namespace

std::vector<std::vector<LocatedPolyline>> cutAtFacesWithoutArea(std::vector<LocatedPolyline>& faces)
{
  const CutFaces cut(faces);
  std::vector<std::vector<LocatedPolyline>> parts;
  bool isAnyLeft = false;
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    parts.push_back(
      cut.isCut(face) ? cut.partsOf(face) : std::vector<LocatedPolyline>{ faces[face] });
    isAnyLeft = isAnyLeft || !parts.back().empty();
  }
  std::size_t left = 0;
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    if (!isAnyLeft)
    {
      parts[face] = { faces[face] };
    }
    if (!parts[face].empty())
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

}
