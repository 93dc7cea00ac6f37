// SPDX-License-Identifier: BSD-3-Clause
// What the tests of barriers share: surfaces with a barrier array, parts of surfaces, and what a
// refined surface must hold.
#ifndef BarrierTesting_h
#define BarrierTesting_h

#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkUnsignedCharArray.h"

#include <limits>
#include <map>
#include <set>

namespace GeodesicTesting
{

/// Marks cells by their centre, in the array "barrier".
inline vtkSmartPointer<vtkPolyData> WithBarriers(
  vtkSmartPointer<vtkPolyData> data, const Where& isBarrier)
{
  AddArrayOf<vtkIntArray>(data->GetCellData(), "barrier", data->GetNumberOfCells(),
    [&](vtkIdType cell) { return isBarrier(CentreOf(data, cell)) ? 1 : 0; });
  return data;
}

/// A wall in the unit square, from below: paths go around its two upper corners.
constexpr double WallBegin = 0.5;
constexpr double WallEnd = 0.625;
constexpr double WallTop = 0.75;

inline bool IsInWall(const Point& p)
{
  return p[0] > WallBegin && p[0] < WallEnd && p[1] < WallTop;
}

/// Whether the straight way passes beside the wall or along its rim.
inline bool IsFree(const Point& a, const Point& b)
{
  double first = 0.0;
  double last = 1.0;
  const auto clip = [&](double from, double to, double bound, bool isBelow)
  {
    const double begin = isBelow ? bound - from : from - bound;
    const double change = isBelow ? from - to : to - from; // of what is inside
    if (change == 0.0)
    {
      last = begin > 0.0 ? last : -1.0;
    }
    else if (change > 0.0)
    {
      first = std::max(first, -begin / change);
    }
    else
    {
      last = std::min(last, begin / -change);
    }
  };
  clip(a[0], b[0], WallBegin, false);
  clip(a[0], b[0], WallEnd, true);
  clip(a[1], b[1], WallTop, true);
  return last - first <= 1e-12;
}

inline double Length(const Point& a, const Point& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// The distance from a point in the square with the wall.
inline Distance AroundWall(const Point& source)
{
  return [source](const Point& p)
  {
    const Point corners[] = { { WallBegin, WallTop, 0 }, { WallEnd, WallTop, 0 } };
    const double infinity = std::numeric_limits<double>::infinity();
    if (IsInWall(p))
    {
      return infinity;
    }
    double least = IsFree(source, p) ? Length(source, p) : infinity;
    for (int k = 0; k < 2; ++k)
    {
      const Point& near = corners[k];
      const Point& far = corners[1 - k];
      const double toNear = IsFree(source, near) ? Length(source, near) : infinity;
      least = IsFree(near, p) ? std::min(least, toNear + Length(near, p)) : least;
      least =
        IsFree(far, p) ? std::min(least, toNear + WallEnd - WallBegin + Length(far, p)) : least;
    }
    return least;
  };
}

inline vtkSmartPointer<vtkPolyData> SquareWithWall(int n, Cells cells = Cells::Triangles)
{
  return WithBarriers(Square(n, cells), IsInWall);
}

/// Runs a filter on a surface with barriers, without an error.
///
/// \param source nothing: the boundary.
/// \returns its warnings.
inline std::string RunWithBarriers(Check& check, vtkGeodesicAlgorithm* filter,
  vtkDataObject* surface, vtkPolyData* source, const std::string& what)
{
  filter->SetInputDataObject(0, surface);
  filter->SetSourceData(source);
  if (!source)
  {
    filter->SetSourceTypeToSurfaceBoundary();
  }
  filter->SetBarrierArrayName("barrier");
  return RunWithoutError(check, filter, what);
}

/// Flags cells by their centre: by default as duplicates.
inline vtkSmartPointer<vtkPolyData> WithGhosts(vtkSmartPointer<vtkPolyData> data,
  const Where& isGhost, unsigned char flag = vtkDataSetAttributes::DUPLICATECELL)
{
  AddArrayOf<vtkUnsignedCharArray>(data->GetCellData(), vtkDataSetAttributes::GhostArrayName(),
    data->GetNumberOfCells(), [&](vtkIdType i) { return isGhost(CentreOf(data, i)) ? flag : 0; });
  return data;
}

/// The corners of the triangles whose centre is between two x, with their distances.
inline std::multiset<std::set<std::array<double, 4>>> TrianglesIn(
  vtkPolyData* data, double begin, double end)
{
  std::multiset<std::set<std::array<double, 4>>> triangles;
  vtkDataArray* distances = data->GetPointData()->GetArray("GeodesicDistance");
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    const Point centre = CentreOf(data, cell);
    if (centre[0] < begin || centre[0] > end)
    {
      continue;
    }
    vtkNew<vtkIdList> ids;
    data->GetCellPoints(cell, ids);
    std::set<std::array<double, 4>> corners;
    for (const vtkIdType id : { ids->GetId(0), ids->GetId(1), ids->GetId(2) })
    {
      const double* p = data->GetPoint(id);
      corners.insert({ p[0], p[1], p[2], distances->GetTuple1(id) });
    }
    triangles.insert(corners);
  }
  return triangles;
}

inline double LargestDistance(vtkGeodesicDistanceField* filter)
{
  double largest = 0.0;
  for (vtkIdType i = 0; i < Distances(filter)->GetNumberOfTuples(); ++i)
  {
    largest = std::max(largest, Distances(filter)->GetTuple1(i));
  }
  return largest;
}

/// The triangles of a refined surface that are parts of barriers.
inline vtkIdType CountBarrierParts(vtkPolyData* output, const Where& isBarrier)
{
  vtkIdType count = 0;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    count += isBarrier(CentreOf(output, cell)) ? 1 : 0;
  }
  return count;
}

/// Points of flat surfaces that lie inside an edge of a triangle: there are none where refined
/// neighbours fit.
inline double CountHangingPoints(const std::vector<vtkPolyData*>& surfaces)
{
  std::set<Point> points;
  std::set<std::pair<Point, Point>> edges;
  for (vtkPolyData* data : surfaces)
  {
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
    {
      const std::vector<Point> corners = CornersOf(data, cell);
      points.insert(corners.begin(), corners.end());
      for (std::size_t k = 0; k < 3; ++k)
      {
        edges.insert(std::minmax(corners[k], corners[(k + 1) % 3]));
      }
    }
  }
  double count = 0.0;
  for (const auto& [a, b] : edges)
  {
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    // Points are sorted by x first.
    for (auto p = points.lower_bound({ a[0] - 1e-12, -1e300, 0 });
         p != points.end() && (*p)[0] <= b[0] + 1e-12; ++p)
    {
      const double along =
        (((*p)[0] - a[0]) * (b[0] - a[0]) + ((*p)[1] - a[1]) * (b[1] - a[1])) / length;
      const double beside =
        (((*p)[0] - a[0]) * (b[1] - a[1]) - ((*p)[1] - a[1]) * (b[0] - a[0])) / length;
      const bool isInside = along > 1e-9 && along < length - 1e-9;
      count += isInside && std::abs(beside) < 1e-12 ? 1.0 : 0.0;
    }
  }
  return count;
}

/// By how much the total length of the edges with one cell, with two, three and so on differs
/// between a surface of triangles and its refinement, as a fraction of all; edges of two cells are
/// left out, as refinement adds some. Where neighbours do not fit, there are more edges of one.
inline double EdgeLengthsDiffer(vtkPolyData* input, vtkPolyData* output)
{
  const auto lengthsOf = [](vtkPolyData* data)
  {
    std::map<std::pair<vtkIdType, vtkIdType>, int> cellsAt;
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
    {
      vtkNew<vtkIdList> ids;
      data->GetCellPoints(cell, ids);
      for (vtkIdType k = 0; k < 3; ++k)
      {
        ++cellsAt[std::minmax({ ids->GetId(k), ids->GetId((k + 1) % 3) })];
      }
    }
    std::map<int, double> lengths;
    for (const auto& [edge, cells] : cellsAt)
    {
      const Point a = PointAt(data, edge.first);
      const Point b = PointAt(data, edge.second);
      lengths[cells] += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
    return lengths;
  };
  const std::map<int, double> before = lengthsOf(input);
  std::map<int, double> after = lengthsOf(output);
  double total = 0.0;
  double worst = 0.0;
  for (const auto& [cells, length] : before)
  {
    total += length;
    after[cells] -= length;
  }
  for (const auto& [cells, difference] : after)
  {
    worst = cells == 2 ? worst : std::max(worst, std::abs(difference));
  }
  return worst / total;
}

/// Of a plane cell.
inline double AreaOf(vtkPolyData* data, vtkIdType cell)
{
  const std::vector<Point> corners = CornersOf(data, cell);
  Point normal{};
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    const Point& a = corners[k];
    const Point& b = corners[(k + 1) % corners.size()];
    for (std::size_t i = 0; i < 3; ++i)
    {
      normal[i] += 0.5 * (a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);
    }
  }
  return std::hypot(normal[0], normal[1], normal[2]);
}

/// The largest difference between the area of a cell and that of its parts, as a fraction of the
/// largest area.
inline double AreaError(vtkPolyData* input, vtkPolyData* output)
{
  std::vector<double> areas(static_cast<std::size_t>(input->GetNumberOfCells()), 0.0);
  vtkDataArray* originals = output->GetCellData()->GetArray("OriginalCellIds");
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    areas[static_cast<std::size_t>(originals->GetTuple1(cell))] += AreaOf(output, cell);
  }
  double worst = 0.0;
  double largest = 0.0;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    largest = std::max(largest, AreaOf(input, cell));
    worst = std::max(worst, std::abs(areas[static_cast<std::size_t>(cell)] - AreaOf(input, cell)));
  }
  return worst / largest;
}

/// The largest difference between the linear interpolant and the truth, at some points of each
/// triangle that is no barrier.
inline double InterpolationError(vtkPolyData* output, const Where& isBarrier, const Distance& truth)
{
  double worst = 0.0;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    if (isBarrier(CentreOf(output, cell)))
    {
      continue;
    }
    vtkNew<vtkIdList> ids;
    output->GetCellPoints(cell, ids);
    constexpr int steps = 6;
    for (int i = 0; i <= steps; ++i)
    {
      for (int j = 0; i + j <= steps; ++j)
      {
        const double weights[] = { 1.0 - static_cast<double>(i + j) / steps,
          static_cast<double>(i) / steps, static_cast<double>(j) / steps };
        Point p{};
        double value = 0.0;
        for (vtkIdType k = 0; k < 3; ++k)
        {
          const double* corner = output->GetPoint(ids->GetId(k));
          p = { p[0] + weights[k] * corner[0], p[1] + weights[k] * corner[1], 0.0 };
          value += weights[k] * PointValue(output, "GeodesicDistance", ids->GetId(k));
        }
        // A little inside, as rounding might put it into a barrier.
        const Point centre = CentreOf(output, cell);
        p = { p[0] + 1e-9 * (centre[0] - p[0]), p[1] + 1e-9 * (centre[1] - p[1]), 0.0 };
        worst = std::max(worst, std::abs(value - truth(p)));
      }
    }
  }
  return worst;
}

}

#endif
