// SPDX-License-Identifier: BSD-3-Clause
// Sources of every kind that a vtkPolyData can hold, and those that other filters make: the
// distance is that to the curve, and output port 1 is the curve as it lies on the surface.
#include "GeodesicTesting.h"

#include "vtkCleanPolyData.h"
#include "vtkCutter.h"
#include "vtkFeatureEdges.h"
#include "vtkIdList.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"
#include "vtkPolyDataNormals.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"

#include <set>

using namespace GeodesicTesting;

namespace
{

vtkPolyData* Curves(vtkGeodesicDistanceField* filter)
{
  return OutputOf(filter, 1);
}

void CheckSource(Check& check, const std::string& name, vtkPolyData* source, const Distance& truth,
  vtkIdType lines, vtkIdType vertices)
{
  for (const Cells cells : { Cells::Triangles, Cells::Quads })
  {
    const auto filter = PlainField(Square(8, cells), source);
    RunWithoutError(check, filter, name);
    CheckDistances(check, filter, truth, name);
    check.Equal(Curves(filter)->GetNumberOfLines(), lines, name + ": lines on the surface");
    check.Equal(Curves(filter)->GetNumberOfVerts(), vertices, name + ": vertices on the surface");
  }
}

enum class Kind
{
  Verts,
  Lines,
  Polys,
  Strips
};

vtkSmartPointer<vtkPolyData> WithCells(
  vtkSmartPointer<vtkPolyData> data, Kind kind, const std::vector<std::vector<vtkIdType>>& ids)
{
  const auto cells = CellArray(ids);
  kind == Kind::Verts     ? data->SetVerts(cells)
    : kind == Kind::Lines ? data->SetLines(cells)
    : kind == Kind::Polys ? data->SetPolys(cells)
                          : data->SetStrips(cells);
  return data;
}

void CheckKinds(Check& check)
{
  const std::vector<Point> p = { { 0.21, 0.13, 0 }, { 0.83, 0.27, 0 }, { 0.75, 0.625, 0 },
    { 0.31, 0.9, 0 } };
  const std::vector<Point> outline = { p[0], p[1], p[2], p[3], p[0] };
  const auto least = [](std::vector<Distance> parts) -> Distance
  {
    return [parts](const Point& x)
    {
      double result = parts[0](x);
      for (const Distance& part : parts)
      {
        result = std::min(result, part(x));
      }
      return result;
    };
  };

  CheckSource(check, "points without cells", PointSources(p),
    least(
      { DistanceTo({ p[0] }), DistanceTo({ p[1] }), DistanceTo({ p[2] }), DistanceTo({ p[3] }) }),
    0, 4);
  CheckSource(check, "an open polyline", Polyline(p), DistanceTo(p), 1, 0);
  CheckSource(check, "a closed polyline", Polyline(p, true), DistanceTo(outline), 1, 0);
  const auto withCells = [&](Kind kind, const std::vector<std::vector<vtkIdType>>& ids)
  { return WithCells(PointSources(p), kind, ids); };
  CheckSource(check, "vertex cells leave other points out",
    withCells(Kind::Verts, { { 1 }, { 3, 0 } }),
    least({ DistanceTo({ p[0] }), DistanceTo({ p[1] }), DistanceTo({ p[3] }) }), 0, 3);
  CheckSource(check, "two lines that are one curve, and a vertex",
    WithCells(withCells(Kind::Lines, { { 0, 1 }, { 2, 1 } }), Kind::Verts, { { 3 } }),
    least({ DistanceTo({ p[0], p[1], p[2] }), DistanceTo({ p[3] }) }), 1, 1);
  CheckSource(check, "a polygon inside faces stands for its outline",
    withCells(Kind::Polys, { { 0, 1, 2, 3 } }), DistanceTo(outline), 1, 0);
  CheckSource(check, "a strip inside faces stands for its outline",
    withCells(Kind::Strips, { { 0, 1, 3, 2 } }), DistanceTo(outline), 1, 0);
  CheckSource(check, "a line of one point is a point", withCells(Kind::Lines, { { 2 } }),
    DistanceTo({ p[2] }), 0, 1);
}

void CheckCurveAndBoundary(Check& check)
{
  const std::vector<Point> line = { { 0.3, 0.45, 0 }, { 0.6, 0.55, 0 } };
  const Distance toLine = DistanceTo(line);
  const auto filter = PlainField(Square(16), Polyline(line));
  Messages messages(filter);
  filter->SetSourceTypeToSurfaceBoundary();
  messages.Update();
  CheckDistances(
    check, filter, DistanceToBoundaryOfSquare, "the boundary, though a curve is there");
  check.Equal(Curves(filter)->GetNumberOfPoints(), 64.0, "points of the square's boundary");
  filter->SetSourceTypeToCurveAndBoundary();
  messages.Update();
  CheckDistances(
    check, filter,
    [&](const Point& p) { return std::min(toLine(p), DistanceToBoundaryOfSquare(p)); },
    "curve and boundary");
  check.Equal(Curves(filter)->GetNumberOfLines(), 2.0, "lines of curve and boundary");
}

/// Edges of the sphere that the plane z = height crosses.
vtkIdType CrossedEdges(vtkPolyData* sphere, double height)
{
  std::set<std::pair<vtkIdType, vtkIdType>> edges;
  for (const std::vector<vtkIdType>& ids : CellsOf(sphere->GetPolys()))
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const vtkIdType a = ids[k];
      const vtkIdType b = ids[(k + 1) % 3];
      if ((sphere->GetPoint(a)[2] < height) != (sphere->GetPoint(b)[2] < height))
      {
        edges.insert(std::minmax(a, b));
      }
    }
  }
  return static_cast<vtkIdType>(edges.size());
}

/// Points that are farther than the tolerance from those before.
vtkIdType Places(vtkPolyData* data, double tolerance)
{
  vtkIdType places = 0;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    bool isNew = true;
    for (vtkIdType j = 0; j < i && isNew; ++j)
    {
      isNew = LengthBetween(PointAt(data, i), PointAt(data, j)) > tolerance;
    }
    places += isNew ? 1 : 0;
  }
  return places;
}

/// A section of a sphere crosses each edge at one point, in 32 and 64 bits, whether its segments
/// come one by one or joined.
void CheckSliceOfSphere(Check& check, int precision, bool joined)
{
  const std::string name = std::string("slice of a ") +
    (precision == vtkAlgorithm::SINGLE_PRECISION ? "32" : "64") + "-bit sphere" +
    (joined ? ", joined" : "");
  const double height = 0.0137;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(37);
  sphere->SetPhiResolution(26);
  sphere->SetOutputPointsPrecision(precision);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0, 0, height);
  plane->SetNormal(0, 0, 1);
  vtkNew<vtkCutter> slice;
  slice->SetCutFunction(plane);
  slice->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkStripper> stripper;
  stripper->SetInputConnection(slice->GetOutputPort());

  vtkNew<vtkGeodesicDistanceField> filter;
  filter->RefineMeshOff();
  filter->SetInputConnection(sphere->GetOutputPort());
  filter->SetSourceConnection(joined ? stripper->GetOutputPort() : slice->GetOutputPort());
  Messages messages(filter);
  messages.ExpectNoError(check, name);

  const bool is32 = precision == vtkAlgorithm::SINGLE_PRECISION;
  const double rounding = is32 ? 1e-6 : 1e-14;
  check.That(filter->GetSourceSnapDistance() < rounding, name + " lies on the surface");
  check.Equal(Places(Curves(filter), rounding), CrossedEdges(sphere->GetOutput(), height),
    name + ": points on edges");
  vtkIdType segments = 0;
  for (const std::vector<vtkIdType>& ids : CellsOf(Curves(filter)->GetLines()))
  {
    segments += static_cast<vtkIdType>(ids.size()) - 1;
  }
  check.Equal(segments, slice->GetOutput()->GetNumberOfLines(),
    name + ": segments, one a face, without slivers");
  for (vtkIdType i = 0; i < Curves(filter)->GetNumberOfPoints(); ++i)
  {
    check.Near(Curves(filter)->GetPoint(i)[2], height, rounding, name + ": its height");
  }
  // By symmetry the poles are as far as straight down their meridians' faces.
  const double north = Distances(filter)->GetTuple1(0);
  const double south = Distances(filter)->GetTuple1(1);
  check.That(south > north && std::abs(south - north - 2.0 * height) < 0.01, name + ": its poles");

  filter->RefineMeshOn();
  filter->SetMaximumNumberOfCells(20000);
  messages.ExpectNoWarning(check, name + ": few triangles are enough");
  check.That(filter->GetInterpolationErrorBound() <= 1e-3 * sphere->GetOutput()->GetLength(),
    name + ": the bound is below the tolerance");
}

/// The axis-aligned unit cube with n x n squares a side.
vtkSmartPointer<vtkPolyData> Cube(int n)
{
  auto cube = Mesh({}, {});
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (const double level : { 0.0, 1.0 })
    {
      Append(cube,
        Moved(Square(n),
          [&](const Point& q)
          {
            Point p;
            p[axis] = level;
            p[(axis + 1) % 3] = q[0];
            p[(axis + 2) % 3] = q[1];
            return p;
          }));
    }
  }
  return cube;
}

void CheckFeatureEdgesOfCube(Check& check)
{
  vtkNew<vtkCleanPolyData> cube;
  cube->SetInputData(Cube(8));
  vtkNew<vtkPolyDataNormals> oriented;
  oriented->SetInputConnection(cube->GetOutputPort());
  oriented->SplittingOff();
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputConnection(oriented->GetOutputPort());
  edges->BoundaryEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->FeatureEdgesOn();
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->RefineMeshOff();
  filter->SetInputConnection(oriented->GetOutputPort());
  filter->SetSourceConnection(edges->GetOutputPort());
  Messages messages(filter);
  messages.Update();
  check.Equal(edges->GetOutput()->GetNumberOfLines(), 96.0, "feature edges");
  const auto toEdges = [](const Point& p)
  {
    double nearest[3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      nearest[k] = std::min(p[k], 1.0 - p[k]);
    }
    std::sort(nearest, nearest + 3); // the first is 0: the face that the point lies in
    return nearest[1];
  };
  CheckDistances(check, filter, toEdges, "feature edges of a cube");
  check.Equal(filter->GetSourceSnapDistance(), 0.0, "snap distance of feature edges");
}

/// A curve above the surface is put onto it, and the snap distance tells from where.
void CheckSnapDistance(Check& check)
{
  const std::vector<Point> below = { { 0.2, 0.3, 0 }, { 0.9, 0.4, 0 } };
  const auto filter =
    PlainField(Square(8), Polyline({ { 0.2, 0.3, 0.004 }, { 0.9, 0.4, 0.0078125 } }));
  Messages messages(filter);
  messages.Update();
  CheckDistances(check, filter, DistanceTo(below), "a curve above the surface");
  check.Near(filter->GetSourceSnapDistance(), 0.0078125, 1e-15, "its snap distance");
  check.That(messages.Warning().empty(), "a curve near the surface is not warned of");
}

/// Outlines and lines keep the order of their points, on the surface too.
void CheckOrder(Check& check)
{
  const std::vector<Point> p = { { 0.5, 0.0625, 0 }, { 0.53125, 0.125, 0 }, { 0.625, 0.0625, 0 },
    { 0.65625, 0.125, 0 }, { 0.75, 0.0625, 0 } };
  const auto onSurface = [&](bool isStrip, const std::vector<vtkIdType>& ids)
  {
    auto source = PointSources(p);
    const auto filter =
      PlainField(Square(1), WithCells(source, isStrip ? Kind::Strips : Kind::Lines, { ids }));
    filter->Update();
    return PlacesOf(Curves(filter), IdsOf(Curves(filter)->GetLines(), 0));
  };
  const auto are = [&](const std::vector<Point>& points, const std::vector<std::size_t>& expected)
  {
    return points.size() == expected.size() &&
      std::equal(points.begin(), points.end(), expected.begin(),
        [&p](const Point& a, std::size_t b) { return DistanceToSegment(a, p[b], p[b]) < 1e-15; });
  };
  check.That(are(onSurface(false, { 0, 1, 0 }), { 0, 1, 0 }), "a line there and back");
  check.That(are(onSurface(false, { 0, 1, 2, 0 }), { 0, 1, 2, 0 }), "a closed line");
  check.That(are(onSurface(true, { 0, 1, 2, 3 }), { 0, 1, 3, 2, 0 }), "a strip of four points");
  check.That(are(onSurface(true, { 0, 1, 2, 3, 4 }), { 0, 1, 3, 4, 2, 0 }), "one of five");
}

/// The blocks of a source have one precision, the least of any of them.
void CheckPrecisionOfBlocks(Check& check)
{
  const auto surface = NoisySquare(8);
  const auto rounded = PointSources({ PointAt(surface, 30) }, VTK_FLOAT);
  const auto other = PointSources({ { 0.9, 0.9, 0.0 } });
  for (const bool isFirst : { true, false })
  {
    const auto blocks = Blocks({ isFirst ? rounded : other, isFirst ? other : rounded });
    const auto filter = PlainField(surface, blocks);
    filter->Update();
    check.Equal(Distances(filter)->GetTuple1(30), 0.0,
      std::string("a point in single precision in the ") + (isFirst ? "first" : "last") +
        " block is the vertex that it was rounded from");
  }
}

}

int TestGeodesicSources(int, char*[])
{
  Check check;
  CheckKinds(check);
  CheckCurveAndBoundary(check);
  for (const bool joined : { false, true })
  {
    CheckSliceOfSphere(check, vtkAlgorithm::SINGLE_PRECISION, joined);
    CheckSliceOfSphere(check, vtkAlgorithm::DOUBLE_PRECISION, joined);
  }
  CheckFeatureEdgesOfCube(check);
  CheckSnapDistance(check);
  CheckOrder(check);
  CheckPrecisionOfBlocks(check);
  return check.Result();
}
