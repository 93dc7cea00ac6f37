// SPDX-License-Identifier: BSD-3-Clause
// Coordinates along and across a source: on tubes and cones, which unroll into the plane, around
// the pole of a sphere, in blocks and at other scales; against the source as it lies on the
// surface, and against the ends of shortest paths.
#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkGeodesicPaths.h"
#include "vtkMultiBlockDataSet.h"

#include <limits>

using namespace GeodesicTesting;

namespace
{

constexpr double Pi = 3.14159265358979323846;

/// Rows of points around the z axis, joined by triangles whose normals point outward.
vtkSmartPointer<vtkPolyData> Tube(
  int sides, int rows, const std::function<Point(double angle, int row)>& place)
{
  auto tube = PointSources({});
  vtkNew<vtkCellArray> polys;
  for (int row = 0; row <= rows; ++row)
  {
    for (int k = 0; k < sides; ++k)
    {
      tube->GetPoints()->InsertNextPoint(place(2.0 * Pi * k / sides, row).data());
      if (row < rows)
      {
        const vtkIdType below = row * sides;
        const vtkIdType next = (k + 1) % sides;
        InsertSquare(polys, Cells::Triangles,
          { below + k, below + next, below + sides + next, below + sides + k });
      }
    }
  }
  tube->SetPolys(polys);
  return tube;
}

/// The facet of a regular polygon around the z axis that a point is on, and how far along it.
struct OnFacet
{
  int Facet;
  /// From the facet's middle, in units of the apothem.
  double Aside;
};

OnFacet FacetOf(const Point& p, int sides)
{
  const double width = 2.0 * Pi / sides;
  double angle = std::atan2(p[1], p[0]);
  angle += angle < 0.0 ? 2.0 * Pi : 0.0;
  const int facet = std::min(static_cast<int>(angle / width), sides - 1);
  return { facet, std::tan(angle - (facet + 0.5) * width) };
}

/// Whether two angles are the same, up to turns.
bool IsSameAngle(double a, double b, double tolerance)
{
  return std::abs(std::remainder(a - b, 2.0 * Pi)) <= tolerance;
}

struct AskedArrays
{
  explicit AskedArrays(vtkPolyData* output)
    : Distances(output->GetPointData()->GetArray("GeodesicDistance"))
    , ArcLengths(output->GetPointData()->GetArray("SourceArcLength"))
    , Angles(output->GetPointData()->GetArray("SourceAngle"))
    , Texture(output->GetPointData()->GetTCoords())
  {
  }

  vtkDataArray* Distances;
  vtkDataArray* ArcLengths;
  vtkDataArray* Angles;
  vtkDataArray* Texture;
};

void AskForCoordinates(vtkGeodesicDistanceField* filter)
{
  filter->GenerateSourceArcLengthOn();
  filter->GenerateSourceAngleOn();
  filter->GenerateTextureCoordinatesOn();
  filter->SetTextureScale(1.0);
}

/// Runs a filter and calls visit(const Point&, distance, arc length, angle, u, v) for each point.
template <typename Visit>
void ForEachPoint(
  Check& check, vtkGeodesicDistanceField* filter, const std::string& what, const Visit& visit)
{
  AskForCoordinates(filter);
  Messages messages(filter);
  messages.Update();
  check.That(messages.Error().empty(), what + ": " + messages.Error());
  vtkPolyData* output = filter->GetOutput();
  const AskedArrays arrays(output);
  if (!arrays.ArcLengths || !arrays.Angles || !arrays.Texture)
  {
    check.That(false, what + ": all arrays are there");
    return;
  }
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    Point p;
    output->GetPoint(i, p.data());
    visit(p, arrays.Distances->GetTuple1(i), arrays.ArcLengths->GetTuple1(i),
      arrays.Angles->GetTuple1(i), arrays.Texture->GetComponent(i, 0),
      arrays.Texture->GetComponent(i, 1));
  }
}

constexpr int Sides = 20;
constexpr double Height = 1.5;

vtkSmartPointer<vtkPolyData> Cylinder()
{
  return Tube(Sides, 6,
    [](double angle, int row) {
      return Point{ std::cos(angle), std::sin(angle), row * Height / 6.0 };
    });
}

/// How far around the cylinder a point is, in the direction of growing angles from (1, 0).
double AroundCylinder(const Point& p)
{
  const OnFacet at = FacetOf(p, Sides);
  return 2.0 * std::sin(Pi / Sides) * (at.Facet + 0.5) + std::cos(Pi / Sides) * at.Aside;
}

/// Up a line on the cylinder: seen from outside, angles grow to the right.
void CheckLineUpACylinder(Check& check, bool refine)
{
  const double around = 2.0 * std::sin(Pi / Sides) * Sides;
  const double begin = 0.3;
  const double end = 1.2;
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(Cylinder());
  filter->SetSourceData(Polyline({ { 1, 0, begin }, { 1, 0, 0.7 }, { 1, 0, end } }));
  filter->SetRefineMesh(refine);
  int points = 0;
  ForEachPoint(check, filter, "up a cylinder",
    [&](const Point& p, double distance, double length, double angle, double u, double v)
    {
      const double left = -std::remainder(AroundCylinder(p), around);
      const double foot = std::clamp(p[2], begin, end);
      const std::string at =
        "up a cylinder, at " + std::to_string(left) + ", " + std::to_string(p[2]) + ": ";
      check.That(std::abs(distance - std::hypot(left, p[2] - foot)) <= 1e-12, at + "distance");
      check.That(std::abs(length - (foot - begin)) <= 1e-12, at + "SourceArcLength");
      // Behind the line both sides are as near.
      if (std::abs(std::abs(left) - 0.5 * around) > 1e-9 && std::abs(left) > 1e-9)
      {
        const double expected =
          foot == p[2] ? std::copysign(Pi / 2.0, left) : std::atan2(left, p[2] - foot);
        check.That(std::abs(angle - expected) <= 1e-11, at + "SourceAngle");
        check.That(u == length && v == std::copysign(distance, left), at + "texture coordinates");
        ++points;
      }
    });
  check.That(points > 50, "up a cylinder: points were looked at");
}

/// Around the cylinder: left of the way to growing angles is up.
void CheckRingAroundACylinder(Check& check, bool refine)
{
  std::vector<Point> ring;
  for (int k = 0; k < Sides; ++k)
  {
    const double angle = 2.0 * Pi * k / Sides;
    ring.push_back({ std::cos(angle), std::sin(angle), 0.55 });
  }
  const double around = 2.0 * std::sin(Pi / Sides) * Sides;
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(Cylinder());
  filter->SetSourceData(Polyline(ring, true));
  filter->SetRefineMesh(refine);
  ForEachPoint(check, filter, "around a cylinder",
    [&](const Point& p, double distance, double length, double angle, double u, double v)
    {
      const double up = p[2] - 0.55;
      const std::string at =
        "around a cylinder, at " + std::to_string(length) + ", " + std::to_string(up) + ": ";
      check.That(std::abs(distance - std::abs(up)) <= 1e-12, at + "distance");
      const double apart = std::abs(length - AroundCylinder(p));
      check.That(
        std::min(apart, around - apart) <= 1e-12 && length >= 0.0 && length < around + 1e-12,
        at + "SourceArcLength");
      check.That(u == length, at + "u");
      if (std::abs(up) > 1e-9)
      {
        check.That(std::abs(angle - std::copysign(Pi / 2.0, up)) <= 1e-11, at + "SourceAngle");
        check.That(std::abs(v - up) <= 1e-12, at + "v");
      }
    });
}

/// The angles around the apex of a cone, whose sum is less, are scaled to a full turn.
void CheckApexOfACone(Check& check, bool refine)
{
  constexpr int rows = 4;
  constexpr double slope = 1.7;
  auto cone = Tube(Sides, rows,
    [](double angle, int row)
    {
      const double radius = 1.0 - static_cast<double>(row) / rows;
      return Point{ radius * std::cos(angle), radius * std::sin(angle), slope * (1.0 - radius) };
    });
  const double facet = 2.0 * std::asin(std::sin(Pi / Sides) / std::hypot(1.0, slope));
  const auto turnAt = [&](const Point& p)
  {
    const OnFacet at = FacetOf(p, Sides);
    const double apothem = std::hypot(p[0], p[1]) / std::hypot(1.0, at.Aside);
    const double down = std::hypot(apothem, slope * apothem / std::cos(Pi / Sides));
    return facet * (at.Facet + 0.5) + std::atan(apothem * at.Aside / down);
  };
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(cone);
  filter->SetSourceData(PointSources({ { 0, 0, slope } }));
  filter->SetRefineMesh(refine);
  filter->GenerateSourceAngleOn();
  filter->Update();
  vtkDataArray* frames = filter->GetOutput()->GetFieldData()->GetArray("SourceFrame");
  check.That(frames && frames->GetNumberOfTuples() == 1, "cone: a frame");
  if (!frames)
  {
    return;
  }
  // The first axis runs along an edge.
  const double* frame = frames->GetTuple(0);
  const double first = turnAt({ frame[0], frame[1], 0.0 });
  check.That(std::abs(std::remainder(first, facet)) <= 1e-12, "cone: the frame is along an edge");
  ForEachPoint(check, filter, "cone",
    [&](const Point& p, double distance, double length, double angle, double u, double v)
    {
      const double radius = std::hypot(p[0], p[1]);
      if (radius > 1e-9)
      {
        const double expected = (turnAt(p) - first) * 2.0 * Pi / (facet * Sides);
        check.That(IsSameAngle(angle, expected, 1e-10),
          "cone: SourceAngle " + std::to_string(angle) + " for " + std::to_string(expected));
      }
      check.Equal(length, 0.0, "cone: SourceArcLength");
      check.That(std::abs(u - distance * std::cos(angle)) <= 1e-12 &&
          std::abs(v - distance * std::sin(angle)) <= 1e-12,
        "cone: texture coordinates");
    });
}

/// Meridians have the same angle all along, up to half a facet.
void CheckPoleOfASphere(Check& check)
{
  constexpr int meridians = 72;
  auto sphere = ChangedSphere(meridians, 41, [](const Point& p) { return p; });
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(sphere);
  filter->SetSourceData(PointSources({ { 0, 0, 0.5 } }));
  filter->GenerateSourceAngleOn();
  filter->Update();
  const double* frame = filter->GetOutput()->GetFieldData()->GetArray("SourceFrame")->GetTuple(0);
  const double first = std::atan2(frame[1], frame[0]);
  ForEachPoint(check, filter, "pole",
    [&](const Point& p, double, double, double angle, double, double)
    {
      const bool isPole = std::hypot(p[0], p[1]) < 1e-6;
      check.That(
        isPole || IsSameAngle(angle, std::atan2(p[1], p[0]) - first, 1.001 * Pi / meridians),
        "pole: SourceAngle " + std::to_string(angle));
    });
}

/// Two blocks side by side and a line across their seam, which is arc length along x.
void CheckBlocks(Check& check, bool refine)
{
  auto right = Square(8);
  MovePoints(right, [](const Point& p) { return Point{ p[0] + 1.0, p[1], p[2] }; });
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Square(8));
  blocks->SetBlock(1, nullptr);
  blocks->SetBlock(2, right);
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputDataObject(blocks);
  filter->SetSourceData(Polyline({ { 0.3, 0.4, 0 }, { 1.6, 0.4, 0 } }));
  filter->SetRefineMesh(refine);
  AskForCoordinates(filter);
  filter->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  check.That(output && output->GetFieldData()->HasArray("SourceFrame"), "blocks: frames of all");
  for (const unsigned int number : { 0U, 2U })
  {
    auto* block = vtkPolyData::SafeDownCast(output->GetBlock(number));
    const AskedArrays arrays(block);
    check.That(arrays.ArcLengths && arrays.Angles && arrays.Texture &&
        block->GetFieldData()->HasArray("SourceFrame"),
      "blocks: arrays and frames of each");
    for (vtkIdType i = 0; i < block->GetNumberOfPoints(); ++i)
    {
      Point p;
      block->GetPoint(i, p.data());
      const double foot = std::clamp(p[0], 0.3, 1.6);
      const double up = p[1] - 0.4;
      const double angle = std::atan2(up, p[0] - foot);
      check.That(std::abs(arrays.ArcLengths->GetTuple1(i) - (foot - 0.3)) <= 1e-12 &&
          std::abs(arrays.Texture->GetComponent(i, 0) - (foot - 0.3)) <= 1e-12 &&
          std::abs(arrays.Texture->GetComponent(i, 1) -
            std::copysign(std::hypot(up, p[0] - foot), up)) <= 1e-12,
        "blocks: coordinates");
      check.That(std::abs(up) < 1e-9 || IsSameAngle(arrays.Angles->GetTuple1(i), angle, 1e-11),
        "blocks: angles");
    }
  }
}

/// Lengths are in the user's units, angles have none.
void CheckScale(Check& check)
{
  const auto run = [](double scale)
  {
    const auto scaled = [scale](const Point& p) {
      return Point{ p[0] * scale, p[1] * scale, p[2] * scale };
    };
    auto surface = NoisySquare(10);
    MovePoints(surface, scaled);
    auto source = Polyline({ { 0.2, 0.3, 0 }, { 0.8, 0.5, 0 }, { 0.4, 0.8, 0 } });
    MovePoints(source, scaled);
    auto filter = vtkSmartPointer<vtkGeodesicDistanceField>::New();
    filter->SetInputData(surface);
    filter->SetSourceData(source);
    filter->RefineMeshOff();
    AskForCoordinates(filter);
    filter->Update();
    return filter;
  };
  const auto ordinary = run(1.0);
  for (const double scale : { std::ldexp(1.0, 400), std::ldexp(1.0, -400) })
  {
    const auto other = run(scale);
    for (const int port : { 0, 1 })
    {
      const auto arrayOf = [port](vtkGeodesicDistanceField* filter, const char* name)
      {
        return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port))
          ->GetPointData()
          ->GetArray(name);
      };
      vtkDataArray* lengths = arrayOf(other, "SourceArcLength");
      for (vtkIdType i = 0; i < lengths->GetNumberOfTuples(); ++i)
      {
        check.Equal(lengths->GetTuple1(i) / scale,
          arrayOf(ordinary, "SourceArcLength")->GetTuple1(i), "arc length at a scale");
        if (port == 0)
        {
          check.Equal(arrayOf(other, "SourceAngle")->GetTuple1(i),
            arrayOf(ordinary, "SourceAngle")->GetTuple1(i), "angle at a scale");
        }
      }
    }
  }
}

vtkSmartPointer<vtkPolyData> Bumpy()
{
  return ChangedSphere(48, 33,
    [](const Point& p) {
      return Point{ p[0] + 0.05 * std::sin(20.0 * p[1]), 0.6 * p[1], 1.7 * p[2] };
    });
}

/// A bent line, a closed one and two points.
vtkSmartPointer<vtkPolyData> SourcesOnBumpy()
{
  auto sources =
    PointSources({ { 0.4, 0.1, 0.2 }, { 0.1, 0.3, 0.3 }, { -0.3, 0.2, 0.1 }, { 0.3, -0.2, -0.3 },
      { 0.1, -0.3, -0.5 }, { -0.1, -0.3, -0.2 }, { 0, 0, 0.85 }, { -0.4, -0.1, -0.3 } });
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 6 });
  verts->InsertNextCell({ 7 });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1, 2 });
  lines->InsertNextCell({ 3, 4, 5, 3 });
  sources->SetVerts(verts);
  sources->SetLines(lines);
  return sources;
}

/// Whether a line of the source as it lies on the surface has a point where its array says that it
/// has this arc length.
bool HasPlace(vtkPolyData* curves, vtkIdType line, const Point& place, double length)
{
  vtkDataArray* lengths = curves->GetPointData()->GetArray("SourceArcLength");
  vtkNew<vtkIdList> ids;
  curves->GetLines()->GetCellAtId(line, ids);
  for (vtkIdType k = 0; k + 1 < ids->GetNumberOfIds(); ++k)
  {
    Point a;
    Point b;
    curves->GetPoint(ids->GetId(k), a.data());
    curves->GetPoint(ids->GetId(k + 1), b.data());
    const double begin = lengths->GetTuple1(ids->GetId(k));
    const double whole = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    const double t = std::clamp((length - begin) / whole, 0.0, 1.0);
    const Point at = { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]),
      a[2] + t * (b[2] - a[2]) };
    if (std::abs(length - (begin + t * whole)) <= 1e-10 &&
      std::hypot(at[0] - place[0], at[1] - place[1], at[2] - place[2]) <= 1e-10)
    {
      return true;
    }
  }
  return false;
}

/// Arc lengths fit to the closest points and to output port 1.
void CheckAgainstSourceOnSurface(Check& check, bool refine)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(Bumpy());
  filter->SetSourceData(SourcesOnBumpy());
  filter->SetRefineMesh(refine);
  filter->SetRefinementTolerance(5e-3);
  filter->GenerateSourceIdsOn();
  filter->GenerateClosestPointsOn();
  filter->GenerateSourceArcLengthOn();
  filter->Update();
  auto* curves = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
  vtkDataArray* onCurves = curves->GetPointData()->GetArray("SourceArcLength");
  check.That(onCurves && onCurves->GetNumberOfTuples() == curves->GetNumberOfPoints(),
    "an arc length at each point of port 1");
  if (!onCurves)
  {
    return;
  }
  vtkPointData* arrays = filter->GetOutput()->GetPointData();
  int seen[4] = {};
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const auto source = static_cast<vtkIdType>(arrays->GetArray("SourceId")->GetTuple1(i));
    const double length = arrays->GetArray("SourceArcLength")->GetTuple1(i);
    Point closest;
    arrays->GetArray("ClosestSourcePoint")->GetTuple(i, closest.data());
    check.That(source < 2 ? length == 0.0 : HasPlace(curves, source - 2, closest, length),
      "SourceArcLength " + std::to_string(length) + " of source " + std::to_string(source));
    ++seen[source];
  }
  check.That(*std::min_element(seen, seen + 4) > 0, "each source is nearest somewhere");
  filter->GenerateSourceArcLengthOff();
  filter->Update();
  check.Equal(curves->GetPointData()->GetNumberOfArrays(), 0, "port 1 without the array");
}

/// At the ends of paths, which are measured there: the same as in the field, up to ties.
void CheckAgainstPaths(Check& check)
{
  vtkNew<vtkGeodesicDistanceField> field;
  field->SetInputData(Bumpy());
  field->SetSourceData(SourcesOnBumpy());
  field->RefineMeshOff();
  field->GenerateSourceIdsOn();
  AskForCoordinates(field);
  field->Update();
  vtkNew<vtkGeodesicPaths> paths;
  paths->SetInputData(Bumpy());
  paths->SetSourceData(SourcesOnBumpy());
  paths->SetTargetsData(Bumpy());
  paths->Update();
  check.Equal(paths->GetOutput()->GetCellData()->GetNumberOfArrays(), 4,
    "paths: no array that was not asked for");
  paths->GenerateSourceArcLengthOn();
  paths->GenerateSourceAngleOn();
  paths->Update();
  vtkCellData* ends = paths->GetOutput()->GetCellData();
  check.That(ends->HasArray("SourceArcLength") && ends->HasArray("SourceAngle"), "paths: arrays");
  vtkDataArray* frames = paths->GetOutput()->GetFieldData()->GetArray("SourceFrame");
  vtkDataArray* expected = field->GetOutput()->GetFieldData()->GetArray("SourceFrame");
  check.That(frames && frames->GetNumberOfTuples() == 4, "paths: a frame for each source");
  for (vtkIdType i = 0; frames && i < frames->GetNumberOfValues(); ++i)
  {
    check.Equal(frames->GetComponent(i / 9, static_cast<int>(i % 9)),
      expected->GetComponent(i / 9, static_cast<int>(i % 9)), "paths: the field's frames");
  }
  const AskedArrays arrays(field->GetOutput());
  const vtkIdType count = paths->GetOutput()->GetNumberOfLines();
  check.Equal(static_cast<double>(count),
    static_cast<double>(field->GetOutput()->GetNumberOfPoints()), "a path from each vertex");
  vtkDataArray* ids = field->GetOutput()->GetPointData()->GetArray("SourceId");
  int apart = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const bool isSame = ends->GetArray("SourceId")->GetTuple1(i) == ids->GetTuple1(i) &&
      std::abs(ends->GetArray("SourceArcLength")->GetTuple1(i) - arrays.ArcLengths->GetTuple1(i)) <=
        1e-9 &&
      IsSameAngle(ends->GetArray("SourceAngle")->GetTuple1(i), arrays.Angles->GetTuple1(i),
        1e-9 / std::max(1e-9, arrays.Distances->GetTuple1(i)));
    apart += isSame ? 0 : 1;
  }
  check.That(apart <= count / 200, "paths: other ends than in the field: " + std::to_string(apart));
}

void CheckPieces(Check& check)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(Square(8));
  filter->SetSourceData(PointSources({ { 0.3, 0.4, 0 } }));
  AskForCoordinates(filter);
  filter->UpdatePiece(1, 2, 0);
  check.Equal(static_cast<double>(filter->GetOutput()->GetNumberOfPoints()), 0.0, "piece 1");
  filter->UpdatePiece(0, 2, 0);
  const AskedArrays arrays(filter->GetOutput());
  check.That(arrays.Texture &&
      arrays.Texture->GetNumberOfTuples() == filter->GetOutput()->GetNumberOfPoints() &&
      filter->GetOutput()->GetNumberOfPoints() >= 81,
    "piece 0 has the whole surface");
}

/// A texture repeats after the length of a tile; what is not reached keeps its value.
void CheckTextureScale(Check& check)
{
  // The square's diagonal is 1.41 times the side: round lengths up to a tenth of it.
  const struct
  {
    double side, asked, tile;
  } cases[] = { { 1.0, 0.0, 0.1 }, { 1.0, 0.25, 0.25 }, { 2.0, 0.0, 0.2 }, { 5.0, 0.0, 0.5 },
    { 3e-7, 0.0, 2e-8 }, { 1e9, 0.0, 1e8 }, { 1.0, 40.0, 40.0 } };
  for (const auto& [side, asked, tile] : cases)
  {
    auto surface = Square(4);
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      Point p;
      surface->GetPoint(i, p.data());
      surface->GetPoints()->SetPoint(i, side * p[0], side * p[1], side * p[2]);
    }
    vtkNew<vtkGeodesicDistanceField> filter;
    filter->SetInputData(surface);
    filter->SetSourceData(Polyline({ { 0, 0.5 * side, 0 }, { side, 0.5 * side, 0 } }));
    filter->RefineMeshOff();
    filter->SetMaximumDistance(0.3 * side);
    filter->SetUnreachedValueToCustom();
    filter->SetCustomUnreachedValue(-7.0);
    filter->GenerateTextureCoordinatesOn();
    filter->SetTextureScale(asked);
    filter->Update();
    vtkPolyData* output = filter->GetOutput();
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      Point p;
      output->GetPoint(i, p.data());
      const double across = p[1] - 0.5 * side;
      const bool isReached = Distances(filter)->GetTuple1(i) != -7.0;
      check.That(isReached || std::abs(across) > 0.3 * side, "reached within the limit");
      const double u = isReached ? p[0] / tile : -7.0, v = isReached ? across / tile : -7.0;
      const double* uv = output->GetPointData()->GetTCoords()->GetTuple2(i);
      check.That(
        std::abs(uv[0] - u) <= 1e-6 * side / tile && std::abs(uv[1] - v) <= 1e-6 * side / tile,
        "side " + std::to_string(side) + ", asked " + std::to_string(asked) + ": u " +
          std::to_string(uv[0]) + ", v " + std::to_string(uv[1]));
    }
  }
}

/// One picture: its middle is at a point, and on a curve, where it begins at the curve's beginning.
void CheckSinglePicture(Check& check)
{
  for (const bool isCurve : { false, true })
  {
    const std::vector<Point> curve = { { 0, 0.5, 0 }, { 1, 0.5, 0 } };
    vtkNew<vtkGeodesicDistanceField> filter;
    filter->SetInputData(Square(4));
    filter->SetSourceData(isCurve ? Polyline(curve) : PointSources({ { 0.5, 0.5, 0 } }));
    filter->RefineMeshOff();
    filter->GenerateTextureCoordinatesOn();
    filter->SetTextureScale(0.5);
    filter->Update();
    vtkNew<vtkPolyData> tiles;
    tiles->DeepCopy(filter->GetOutput());
    filter->TextureRepeatsOff();
    filter->Update();
    const double along = isCurve ? 0.0 : 0.5;
    for (vtkIdType i = 0; i < tiles->GetNumberOfPoints(); ++i)
    {
      const double* tile = tiles->GetPointData()->GetTCoords()->GetTuple2(i);
      const double expected[2] = { tile[0] + along, tile[1] + 0.5 };
      const double* uv = filter->GetOutput()->GetPointData()->GetTCoords()->GetTuple2(i);
      check.That(std::abs(uv[0] - expected[0]) < 1e-6 && std::abs(uv[1] - expected[1]) < 1e-6,
        "one picture: " + std::to_string(uv[0]) + " " + std::to_string(uv[1]));
    }
  }
}

void CheckDefaults(Check& check)
{
  vtkNew<vtkGeodesicDistanceField> field;
  check.Equal(field->GetTextureScale(), 0.0, "a round tile by default");
  check.That(field->GetTextureRepeats(), "tiles by default");
  check.That(!field->GetGenerateSourceArcLength() && !field->GetGenerateSourceAngle() &&
      !field->GetGenerateTextureCoordinates(),
    "off by default");
  vtkNew<vtkGeodesicPaths> paths;
  check.That(
    !paths->GetGenerateSourceArcLength() && !paths->GetGenerateSourceAngle(), "off by default");
  AskForCoordinates(field);
  paths->GenerateSourceArcLengthOn();
  paths->GenerateSourceAngleOn();
  std::ostringstream printed;
  field->Print(printed);
  paths->Print(printed);
  check.That(Contains(printed.str(), "GenerateTextureCoordinates: On"), "printed");
  check.That(Contains(printed.str(), "TextureScale: 1"), "the tile is printed");
  for (const char* words : { "GenerateSourceArcLength: On", "GenerateSourceAngle: On" })
  {
    const std::size_t first = printed.str().find(words);
    check.That(
      first != std::string::npos && printed.str().find(words, first + 1) != std::string::npos,
      std::string("printed by both: ") + words);
  }
}

}

int TestGeodesicSourceCoordinates(int, char*[])
{
  Check check;
  for (const bool refine : { false, true })
  {
    CheckLineUpACylinder(check, refine);
    CheckRingAroundACylinder(check, refine);
    CheckApexOfACone(check, refine);
    CheckBlocks(check, refine);
    CheckAgainstSourceOnSurface(check, refine);
  }
  CheckPoleOfASphere(check);
  CheckScale(check);
  CheckTextureScale(check);
  CheckSinglePicture(check);
  CheckAgainstPaths(check);
  CheckPieces(check);
  CheckDefaults(check);
  return check.Result();
}
