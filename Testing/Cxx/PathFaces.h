// SPDX-License-Identifier: BSD-3-Clause
// Whether pieces of paths lie in the cells that FaceId names, seen in space alone.
#ifndef PathFaces_h
#define PathFaces_h

#include "GeodesicTesting.h"

#include "vtkIdTypeArray.h"

namespace GeodesicTesting
{

using Corners = std::array<Point, 3>;
/// The triangles that a cell of the surface may have been made of.
using TrianglesOf = std::function<std::vector<Corners>(vtkIdType cell)>;

/// Of a triangle, a quad (by either diagonal) or a strip.
inline std::vector<Corners> TrianglesOfCell(vtkPolyData* surface, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  surface->GetCellPoints(cell, ids);
  const auto triangle = [&](vtkIdType a, vtkIdType b, vtkIdType c)
  {
    Corners corners;
    surface->GetPoint(ids->GetId(a), corners[0].data());
    surface->GetPoint(ids->GetId(b), corners[1].data());
    surface->GetPoint(ids->GetId(c), corners[2].data());
    return corners;
  };
  std::vector<Corners> triangles;
  const vtkIdType size = ids->GetNumberOfIds();
  if (surface->GetCellType(cell) == VTK_QUAD)
  {
    return { triangle(0, 1, 2), triangle(0, 2, 3), triangle(0, 1, 3), triangle(1, 2, 3) };
  }
  for (vtkIdType i = 0; i + 2 < size; ++i)
  {
    triangles.push_back(triangle(i, i + 1, i + 2));
  }
  return triangles;
}

/// In more digits than coordinates have, so that needles have a plane.
inline double DistanceToTriangle(const Point& p, const Corners& t)
{
  using Vector = std::array<long double, 3>;
  const auto minus = [](const Point& a, const Point& b)
  {
    return Vector{ static_cast<long double>(a[0]) - b[0], static_cast<long double>(a[1]) - b[1],
      static_cast<long double>(a[2]) - b[2] };
  };
  const auto cross = [](const Vector& a, const Vector& b)
  {
    return Vector{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
      a[0] * b[1] - a[1] * b[0] };
  };
  const auto dot = [](const Vector& a, const Vector& b)
  { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  double least = std::min({ DistanceToSegment(p, t[0], t[1]), DistanceToSegment(p, t[1], t[2]),
    DistanceToSegment(p, t[2], t[0]) });
  const Vector normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  const long double area = std::sqrt(dot(normal, normal));
  bool isAbove = area > 0.0L;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vector side = minus(t[(k + 1) % 3], t[k]);
    isAbove = isAbove && dot(cross(side, minus(p, t[k])), normal) >= 0.0L;
  }
  if (isAbove)
  {
    least = std::min(least, static_cast<double>(std::abs(dot(normal, minus(p, t[0]))) / area));
  }
  return least;
}

/// Checks that there is a cell for each point, and that each piece lies in its.
///
/// \returns how far any end of a piece is from its cell.
inline double CheckFacesOfPaths(
  Check& check, vtkPolyData* paths, const TrianglesOf& trianglesOf, const std::string& what)
{
  auto* cells = vtkIdTypeArray::SafeDownCast(paths->GetPointData()->GetArray("FaceId"));
  check.That(cells && cells->GetNumberOfTuples() == paths->GetNumberOfPoints(),
    what + ": each point of a path has a cell");
  double worst = 0.0;
  for (vtkIdType line = 0; cells && line < paths->GetNumberOfLines(); ++line)
  {
    vtkNew<vtkIdList> ids;
    paths->GetLines()->GetCellAtId(line, ids);
    for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
    {
      const vtkIdType cell = cells->GetValue(ids->GetId(i));
      const Point a = PointAt(paths, ids->GetId(i));
      const Point b = PointAt(paths, ids->GetId(i + 1));
      double least = std::numeric_limits<double>::infinity(); // no such cell: no triangle
      for (const Corners& triangle : trianglesOf(cell))
      {
        least = std::min(
          least, std::max(DistanceToTriangle(a, triangle), DistanceToTriangle(b, triangle)));
      }
      worst = std::max(worst, least);
    }
    const vtkIdType last = ids->GetId(ids->GetNumberOfIds() - 1);
    check.That(cells->GetValue(last) == cells->GetValue(last - 1),
      what + ": the last point has the last piece's cell");
  }
  return worst;
}

}

#endif
