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
    const CutTriangles cut = removeFacesWithoutArea(
      this->points_, keys, this->points_.size(), this->triangles_, {}, OneRank::instance());
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
      const std::vector<Vec3>& points = this->faces_[face].outline.points;
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        if (corners[face][i] == this->points_.size())
        {
          this->points_.push_back(points[i]);
          this->firstAt_.push_back({ face, i });
        }
      }
      for (const Triangle& t : triangulatePolygon(points).triangles)
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
      this->faces_[face].parts.push_back(this->polygonOf(part, this->faces_[face].outline));
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
      const LocatedPolyline& with = this->faces_[first.face].outline;
      polygon.points.push_back(this->points_[corner]);
      polygon.vertices.push_back(isNew ? NoId : with.vertexOf(first.corner));
      polygon.pointNames.push_back(isNew ? face.name : with.nameOfPoint(first.corner));
    }
    return polygon;
  }

  std::vector<SourceFace>& faces_;
  /// The place with each number, and the first corner there. A cut may add places.
  std::vector<Vec3> points_;
  std::vector<CornerOfFace> firstAt_;
  std::vector<Triangle> triangles_;
  std::vector<std::size_t> faceOf_;
  /// Whether a face is not the whole of its triangles as they are.
  std::vector<bool> isCut_;
};

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

}
