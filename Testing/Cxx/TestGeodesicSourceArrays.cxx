// SPDX-License-Identifier: BSD-3-Clause
// Which source is nearest, where on it a shortest path ends and how far along it that is, in which
// direction it leaves, the gradient, the sign and texture coordinates: in closed form on a plane,
// where all of them are those of the straight line to the nearest segment.
#include "GeodesicTesting.h"

#include "truth/PlaneEnds.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"

#include <limits>

using namespace GeodesicTesting;

namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();
constexpr double Pi = 3.14159265358979323846;

using Line = std::vector<Point>;

double Length(const Point& a)
{
  return std::hypot(a[0], a[1], a[2]);
}

Point Unit(const Point& a)
{
  const double length = Length(a);
  return { a[0] / length, a[1] / length, a[2] / length };
}

vtkSmartPointer<vtkPolyData> SourceOf(const std::vector<Line>& lines)
{
  std::vector<Point> points;
  std::vector<std::vector<vtkIdType>> vertices;
  std::vector<std::vector<vtkIdType>> cells;
  for (const Line& line : lines)
  {
    std::vector<vtkIdType>& ids = (line.size() > 1 ? cells : vertices).emplace_back();
    for (const Point& p : line)
    {
      ids.push_back(static_cast<vtkIdType>(points.size()));
      points.push_back(p);
    }
  }
  auto data = PointSources(points);
  data->SetVerts(CellArray(vertices));
  data->SetLines(CellArray(cells));
  return data;
}

vtkDataArray* Array(vtkGeodesicDistanceField* filter, const char* name)
{
  return filter->GetOutput()->GetPointData()->GetArray(name);
}

void SwitchAllOn(vtkGeodesicDistanceField* filter)
{
  AskForAllArrays(filter);
  filter->SetTextureScale(1.0);
}

/// What the arrays have at a point.
struct Coordinates
{
  Point Place;
  vtkIdType Source;
  Point Foot;
  double Distance;
  double SignedDistance;
  double ArcLength;
  double Angle;
  double U;
  double V;
};

/// The frames of lines in the plane z = 0.
std::vector<geodesictest::PlainFrame> FramesOf(const std::vector<Line>& lines, vtkDataArray* frames)
{
  std::vector<geodesictest::PlainFrame> result(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    const double* axes = frames->GetTuple(static_cast<vtkIdType>(i));
    result[i] = { { axes[0], axes[1], axes[2] }, { axes[3], axes[4], axes[5] },
      { axes[6], axes[7], axes[8] } };
  }
  return result;
}

/// Whether a path may end like this. Directions of nearby points have fewer digits.
bool Fits(const geodesictest::TrueEnd& end, const Coordinates& at)
{
  constexpr double tolerance = 1e-12;
  return static_cast<vtkIdType>(end.source) == at.Source &&
    std::abs(end.arcLength - at.ArcLength) <= tolerance &&
    Length(Minus(end.place, at.Foot)) <= tolerance &&
    (at.Distance <= 1e-9 || geodesictest::gapOfAngles(end.angle, at.Angle) <= 1e-11 / at.Distance);
}

void CheckCoordinates(
  Check& check, const std::string& name, bool isPoint, const Coordinates& at, const double* frame)
{
  constexpr double tolerance = 1e-12;
  if (isPoint)
  {
    check.Equal(at.ArcLength, 0.0, name + ": the arc length at a point");
    const double u = at.Distance * std::cos(at.Angle);
    const double v = at.Distance * std::sin(at.Angle);
    check.That(std::abs(at.U - u) <= tolerance && std::abs(at.V - v) <= tolerance,
      name + ": texture coordinates by the angle");
    const Point reached = { at.Foot[0] + at.U * frame[0] + at.V * frame[3],
      at.Foot[1] + at.U * frame[1] + at.V * frame[4],
      at.Foot[2] + at.U * frame[2] + at.V * frame[5] };
    check.That(Length(Minus(reached, at.Place)) <= tolerance, name + ": coordinates in the frame");
    return;
  }
  check.That(at.U == at.ArcLength && at.V == at.SignedDistance, name + ": texture coordinates");
  check.That(std::abs(at.Angle) <= Pi, name + ": angles are between -pi and pi");
}

/// Compares all arrays with the plane's. \returns how many points have no sign but by rounding.
int CheckArrays(Check& check, const std::string& of, vtkGeodesicDistanceField* filter,
  const std::vector<Line>& lines)
{
  vtkDataArray* distances = Distances(filter);
  vtkDataArray* ids = Array(filter, "SourceId");
  vtkDataArray* feet = Array(filter, "ClosestSourcePoint");
  vtkDataArray* gradients = Array(filter, "DistanceGradient");
  vtkDataArray* sides = Array(filter, "SignedGeodesicDistance");
  vtkDataArray* lengths = Array(filter, "SourceArcLength");
  vtkDataArray* angles = Array(filter, "SourceAngle");
  vtkDataArray* texture = filter->GetOutput()->GetPointData()->GetTCoords();
  vtkDataArray* frames = filter->GetOutput()->GetFieldData()->GetArray("SourceFrame");
  const bool areThere = ids && feet && gradients && sides && lengths && angles && texture && frames;
  check.That(areThere, of + ": all arrays are there");
  if (!areThere)
  {
    return 0;
  }
  check.That(
    texture == Array(filter, "SourceTextureCoordinates") && texture->GetNumberOfComponents() == 2,
    of + ": the texture coordinates are active");
  check.That(frames->GetNumberOfComponents() == 9 &&
      frames->GetNumberOfTuples() == static_cast<vtkIdType>(lines.size()),
    of + ": a frame for each source");
  check.That(vtkIdTypeArray::SafeDownCast(ids) != nullptr, of + ": SourceId is of vtkIdType");
  constexpr double tolerance = 1e-12;
  int withoutSign = 0;
  const geodesictest::PlaneEnds plane(lines);
  const std::vector<geodesictest::PlainFrame> framesOfLines = FramesOf(lines, frames);
  for (vtkIdType i = 0; i < distances->GetNumberOfTuples(); ++i)
  {
    const std::string name = of + ", point " + std::to_string(i);
    Coordinates at = { {}, static_cast<vtkIdType>(ids->GetTuple1(i)), {}, distances->GetTuple1(i),
      sides->GetTuple1(i), lengths->GetTuple1(i), angles->GetTuple1(i), texture->GetComponent(i, 0),
      texture->GetComponent(i, 1) };
    filter->GetOutput()->GetPoint(i, at.Place.data());
    feet->GetTuple(i, at.Foot.data());
    const auto source = static_cast<std::size_t>(at.Source);
    const bool isPoint = lines[source].size() == 1;
    const double d = at.Distance;
    const std::vector<geodesictest::TrueEnd> ends = plane.of(at.Place, framesOfLines);
    check.Near(d, ends.front().length, tolerance, name + ": the distance");
    // Ties may give any of the ends. Where several lines meet, angles are those of one of them.
    std::vector<geodesictest::TrueEnd> here = ends;
    here.erase(std::remove_if(here.begin(), here.end(),
                 [&](const auto& end) { return Length(Minus(end.place, at.Foot)) > 1e-9; }),
      here.end());
    const bool isOfOne =
      std::all_of(here.begin(), here.end(), [&](const auto& end) { return end.source == source; });
    const bool fits = std::any_of(here.begin(), here.end(),
      [&](geodesictest::TrueEnd end)
      {
        end.angle = isOfOne ? end.angle : at.Angle;
        return Fits(end, at);
      });
    check.That(fits,
      name + ": SourceId " + std::to_string(at.Source) + ", SourceArcLength " +
        std::to_string(at.ArcLength) + ", SourceAngle " + std::to_string(at.Angle));
    const Point gradient = TupleAt(gradients, i);
    const Point expected = d > 1e-9 ? Unit(Minus(at.Place, at.Foot)) : gradient;
    check.That(Length(Minus(gradient, expected)) <= 1e-9, name + ": DistanceGradient");
    check.That(d > 0.0 || Length(gradient) == 0.0, name + ": no gradient on the source");
    const double side = at.SignedDistance;
    check.That(std::abs(side) == d && !(d == 0.0 && std::signbit(side)), name + ": |signed|");
    // Straight behind an end and ahead of it the sides part.
    const bool hasSign = isPoint || (d > 1e-9 && std::abs(std::sin(at.Angle)) > 1e-9);
    withoutSign += hasSign ? 0 : 1;
    check.That(
      !hasSign || d == 0.0 || (side > 0.0) == (isPoint || at.Angle > 0.0), name + ": sign");
    CheckCoordinates(check, name, isPoint, at, frames->GetTuple(at.Source));
  }
  return withoutSign;
}

void CheckPlane(Check& check, const std::string& name, const std::vector<Line>& lines)
{
  for (const bool refine : { false, true })
  {
    for (const Cells cells : { Cells::Triangles, Cells::Quads })
    {
      const std::string of = name + (refine ? ", refined" : "");
      const auto filter = RefinedField(Square(8, cells), SourceOf(lines));
      filter->SetRefineMesh(refine);
      filter->SetRefinementTolerance(2e-3);
      filter->JoinLinesOff(); // each is a curve of its own
      Messages messages(filter);
      messages.Update();
      const std::vector<double> plain = NumbersOf(Distances(filter));
      SwitchAllOn(filter);
      filter->GenerateTextureCoordinatesOff(); // these refine borders, too
      messages.ExpectNoError(check, of);
      check.That(
        NumbersOf(Distances(filter)) == plain, of + ": the arrays change no distance and no point");
      filter->GenerateTextureCoordinatesOn();
      messages.ExpectNoError(check, of);
      const int withoutSign = CheckArrays(check, of, filter, lines);
      const auto count = static_cast<int>(Distances(filter)->GetNumberOfTuples());
      check.That(withoutSign < count / 2, of + ": most points have a sign");
    }
  }
}

Line Reversed(Line line)
{
  std::reverse(line.begin(), line.end());
  return line;
}

void CheckPlanes(Check& check)
{
  const Line bent = { { 0.21, 0.13, 0 }, { 0.83, 0.27, 0 }, { 0.75, 0.625, 0 }, { 0.31, 0.55, 0 } };
  const Line sharp = { { 0.1, 0.5, 0 }, { 0.7, 0.55, 0 }, { 0.2, 0.6, 0 } };
  const Line closed = { { 0.3, 0.3, 0 }, { 0.7, 0.25, 0 }, { 0.65, 0.7, 0 }, { 0.3, 0.3, 0 } };
  const Line alongEdges = { { 0.25, 0.25, 0 }, { 0.75, 0.25, 0 }, { 0.75, 0.75, 0 } };
  const Line throughVertices = { { 0.125, 0.25, 0 }, { 0.5, 0.5, 0 }, { 0.5, 0.875, 0 } };
  for (const Line& line : { bent, sharp, closed, alongEdges, throughVertices })
  {
    const std::string name =
      "line " + std::to_string(line[0][0]) + " " + std::to_string(line[0][1]);
    CheckPlane(check, name, { line });
    CheckPlane(check, name + " reversed", { Reversed(line) });
  }
  CheckPlane(check, "a point", { { { 0.3, 0.4, 0 } } });
  CheckPlane(check, "points at a vertex, on edges and on the boundary",
    { { { 0.5, 0.5, 0 } }, { { 0.25, 0.8125, 0 } }, { { 0.8125, 0.1875, 0 } }, { { 0, 0.25, 0 } },
      { { 1, 1, 0 } }, { { 0.3125, 0, 0 } } });
  CheckPlane(check, "points, a line and a loop",
    { { { 0.1, 0.9, 0 } }, { { 0.5, 0.5, 0 } }, { { 0.7, 0.1, 0 }, { 0.9, 0.3, 0 } },
      { { 0.2, 0.2, 0 }, { 0.3, 0.2, 0 }, { 0.25, 0.35, 0 }, { 0.2, 0.2, 0 } } });
  CheckPlane(check, "lines that share ends",
    { { { 0.25, 0.5, 0 }, { 0.5, 0.5, 0 } }, { { 0.5, 0.5, 0 }, { 0.75, 0.8, 0 } },
      { { 0.5, 0.5, 0 }, { 0.6, 0.2, 0 } } });
  CheckPlane(check, "a line of many cells, some of them the other way",
    { { { 0.2, 0.3, 0 }, { 0.3, 0.35, 0 } }, { { 0.4, 0.4, 0 }, { 0.3, 0.35, 0 } },
      { { 0.4, 0.4, 0 }, { 0.5, 0.5, 0 }, { 0.55, 0.6, 0 } },
      { { 0.7, 0.8, 0 }, { 0.55, 0.6, 0 } } });
  CheckPlane(check, "lines that cross",
    { { { 0.2, 0.3, 0 }, { 0.8, 0.7, 0 } }, { { 0.3, 0.8, 0 }, { 0.6, 0.1, 0 } } });
}

void CheckIds(Check& check)
{
  // Cells of several blocks, polylines of several points, a block without cells.
  const auto source =
    Blocks({ SourceOf({ { { 0.1, 0.1, 0 } }, { { 0.9, 0.1, 0 }, { 0.9, 0.3, 0 } } }),
      PointSources({ { 0.1, 0.9, 0 }, { 0.9, 0.9, 0 } }) });
  const auto filter = PlainField(Square(8), source);
  filter->GenerateSourceIdsOn();
  filter->Update();
  vtkDataArray* ids = Array(filter, "SourceId");
  const auto idAt = [&](int i, int j) { return ids->GetTuple1(9 * j + i); };
  check.Equal(idAt(0, 0), 0, "the vertex cell");
  check.Equal(idAt(8, 0), 1, "the line");
  check.Equal(idAt(0, 8), 2, "the first point without cell");
  check.Equal(idAt(8, 8), 3, "the second point without cell");
  check.Equal(
    filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 2, "no array that was not asked for");
  check.That(!filter->GetOutput()->GetPointData()->GetTCoords() &&
      !filter->GetOutput()->GetFieldData()->HasArray("SourceFrame"),
    "no texture coordinates and frames that were not asked for");
  auto* curves = OutputOf(filter, 1);
  vtkDataArray* ofCurves = curves->GetCellData()->GetArray("SourceId");
  check.That(NumbersOf(ofCurves) == std::vector<double>{ 0, 2, 3, 1 }, "vertices come first");

  filter->SetSourceTypeToCurveAndBoundary();
  filter->GenerateSignedDistanceOn();
  filter->Update();
  check.Equal(Array(filter, "SourceId")->GetTuple1(0), 4, "the boundary comes after the cells");
  check.Equal(Array(filter, "SourceId")->GetTuple1(9 * 7 + 4), 4, "near the boundary");
  const double least = Array(filter, "SignedGeodesicDistance")->GetRange()[0];
  check.Equal(least, 0.0, "distances from the boundary and from points are positive");
}

void CheckLimit(Check& check)
{
  const auto filter = RefinedField(Square(16), SourceOf({ { { 0.1, 0.1, 0 }, { 0.2, 0.1, 0 } } }));
  filter->SetMaximumDistance(0.3);
  SwitchAllOn(filter);
  filter->Update();
  int unreached = 0;
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const double d = Distances(filter)->GetTuple1(i);
    const bool isReached = d < Infinite;
    unreached += isReached ? 0 : 1;
    const Point p = PointAt(filter->GetOutput(), i);
    const Point foot = TupleAt(Array(filter, "ClosestSourcePoint"), i);
    const Point gradient = TupleAt(Array(filter, "DistanceGradient"), i);
    check.Equal(Array(filter, "SourceId")->GetTuple1(i), isReached ? 0 : -1, "SourceId");
    check.That(isReached || foot == p, "an unreached point is its own closest one");
    check.That(isReached || Length(gradient) == 0.0, "no gradient where not reached");
    for (const char* name :
      { "SignedGeodesicDistance", "SourceArcLength", "SourceAngle", "SourceTextureCoordinates" })
    {
      vtkDataArray* array = Array(filter, name);
      check.That(isReached ||
          (array->GetComponent(i, 0) == d &&
            array->GetComponent(i, array->GetNumberOfComponents() - 1) == d),
        std::string("not reached: ") + name);
    }
  }
  check.That(unreached > 0, "some points are beyond the limit");
}

/// The named source and the foot are within the error that was asked for.
void CheckApproximate(Check& check)
{
  const std::vector<Line> lines = { { { 0.5, 0.8, 0 } }, { { 0.21, 0.13, 0 }, { 0.83, 0.27, 0 } } };
  const auto filter = RefinedField(Square(16), SourceOf(lines));
  filter->SetAccuracyToApproximate();
  filter->SetRelativeError(0.05);
  filter->SetMaximumDistance(0.4);
  SwitchAllOn(filter);
  Messages messages(filter);
  messages.Update();
  check.That(messages.Error().empty(), messages.Error());
  const std::vector<geodesictest::PlainFrame> frames =
    FramesOf(lines, filter->GetOutput()->GetFieldData()->GetArray("SourceFrame"));
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const double d = Distances(filter)->GetTuple1(i);
    if (!(d < Infinite))
    {
      continue;
    }
    const Point p = PointAt(filter->GetOutput(), i);
    const Point foot = TupleAt(Array(filter, "ClosestSourcePoint"), i);
    const Point away = Minus(p, foot);
    const auto isWithin = [d](double distance)
    { return distance >= d - 1e-12 && distance <= d / 0.95 + 1e-12; };
    check.That(isWithin(Length(away)), "point " + std::to_string(i) + ": from the foot");
    const auto source = static_cast<vtkIdType>(Array(filter, "SourceId")->GetTuple1(i));
    const Line& line = lines[static_cast<std::size_t>(source)];
    vtkDataArray* texture = Array(filter, "SourceTextureCoordinates");
    const Coordinates at = { p, source, foot, d,
      Array(filter, "SignedGeodesicDistance")->GetTuple1(i),
      Array(filter, "SourceArcLength")->GetTuple1(i), Array(filter, "SourceAngle")->GetTuple1(i),
      texture->GetComponent(i, 0), texture->GetComponent(i, 1) };
    if (line.size() == 1)
    {
      check.Near(std::hypot(at.U, at.V), d, 1e-12, "around the point");
      continue;
    }
    // The end of the straight path to a place on the way from the foot.
    const double part = d > 1e-9 ? 0.01 / Length(away) : 0.0;
    const Point beside = { foot[0] + part * away[0], foot[1] + part * away[1], 0.0 };
    const std::vector<geodesictest::TrueEnd> ends =
      geodesictest::PlaneEnds(lines).of(beside, frames);
    check.That(std::any_of(ends.begin(), ends.end(),
                 [&](const geodesictest::TrueEnd& end) { return Fits(end, at); }),
      "along the line");
  }
}

/// A closed curve around a sphere parts it in two.
void CheckSphere(Check& check)
{
  auto sphere = ChangedSphere(24, 17, [](const Point& p) { return p; });
  Line equator;
  for (int i = 0; i <= 24; ++i)
  {
    const double angle = 2.0 * Pi * (i % 24) / 24.0;
    equator.push_back({ 0.5 * std::cos(angle), 0.5 * std::sin(angle), 0.0 });
  }
  for (const bool reverse : { false, true })
  {
    const auto filter = RefinedField(sphere, SourceOf({ reverse ? Reversed(equator) : equator }));
    filter->GenerateSignedDistanceOn();
    filter->Update();
    for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
    {
      const Point p = PointAt(filter->GetOutput(), i);
      const double side = Array(filter, "SignedGeodesicDistance")->GetTuple1(i);
      const double north = reverse ? -side : side;
      check.That(std::abs(p[2]) < 1e-6 || (north > 0.0) == (p[2] > 0.0),
        "the north is on the left of the way to the east");
    }
  }
}

void CheckOrientation(Check& check)
{
  auto flipped = Square(2);
  auto triangles = CellsOf(flipped->GetPolys());
  std::swap(triangles[5][0], triangles[5][1]);
  flipped->SetPolys(CellArrayOf(triangles));
  auto fin = Square(2);
  fin->GetPoints()->InsertNextPoint(0.5, 0.5, 1.0);
  fin->GetPolys()->InsertNextCell({ 4, 1, 9 });
  for (vtkPolyData* surface : { flipped.Get(), fin.Get() })
  {
    const auto filter = RefinedField(surface, SourceOf({ { { 0.1, 0.1, 0 }, { 0.9, 0.3, 0 } } }));
    filter->GenerateSignedDistanceOn();
    Messages messages(filter);
    messages.ExpectError(check, { "GenerateSignedDistance", "cell " }, "an error names a cell");
    check.That(filter->GetOutput()->GetNumberOfPoints() == 0, "the output is empty");
    filter->GenerateSignedDistanceOff();
    filter->GenerateTextureCoordinatesOn();
    messages.ExpectError(
      check, { "GenerateTextureCoordinates", "cell " }, "texture coordinates need sides, too");
    filter->GenerateTextureCoordinatesOff();
    filter->GenerateSourceIdsOn();
    filter->GenerateSourceArcLengthOn();
    filter->GenerateSourceAngleOn();
    messages.ExpectNoError(check, "without the sign it works");
  }
}

void CheckNames(Check& check)
{
  const auto filter = RefinedField(Square(2), SourceOf({ { { 0.1, 0.1, 0 } } }));
  filter->GenerateSourceIdsOn();
  filter->SetDistanceArrayName("SourceId");
  Messages messages(filter);
  messages.Update();
  check.That(Contains(messages.Error(), "DistanceArrayName is SourceId"), messages.Error());
  filter->GenerateTextureCoordinatesOn();
  filter->SetDistanceArrayName("SourceTextureCoordinates");
  messages.Update();
  check.That(
    Contains(messages.Error(), "DistanceArrayName is SourceTextureCoordinates"), messages.Error());
}

}

int TestGeodesicSourceArrays(int, char*[])
{
  Check check;
  CheckPlanes(check);
  CheckIds(check);
  CheckLimit(check);
  CheckApproximate(check);
  CheckSphere(check);
  CheckOrientation(check);
  CheckNames(check);
  return check.Result();
}
