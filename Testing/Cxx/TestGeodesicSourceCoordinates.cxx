// SPDX-License-Identifier: BSD-3-Clause
// Coordinates along and across a source: in blocks; against the source as it lies on the surface,
// and against the ends of shortest paths.
#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkGeodesicPaths.h"
#include "vtkMultiBlockDataSet.h"

#include <limits>

using namespace GeodesicTesting;

namespace
{

constexpr double Pi = 3.14159265358979323846;

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

/// Two blocks side by side and a line across their seam, which is arc length along x.
void CheckBlocks(Check& check, bool refine)
{
  const auto right = Moved(Square(8), MovedBy(1.0));
  const auto blocks = Blocks({ Square(8), nullptr, right });
  const auto filter = RefinedField(blocks, Polyline({ { 0.3, 0.4, 0 }, { 1.6, 0.4, 0 } }));
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
      const Point p = PointAt(block, i);
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
    const Point a = PointAt(curves, ids->GetId(k));
    const Point b = PointAt(curves, ids->GetId(k + 1));
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
  const auto filter = RefinedField(WavySphere(48, 33, 0.05), SourcesOnBumpy());
  filter->SetRefineMesh(refine);
  filter->SetRefinementTolerance(5e-3);
  filter->GenerateSourceIdsOn();
  filter->GenerateClosestPointsOn();
  filter->GenerateSourceArcLengthOn();
  filter->Update();
  auto* curves = OutputOf(filter, 1);
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
    const Point closest = TupleAt(arrays->GetArray("ClosestSourcePoint"), i);
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
  const auto field = PlainField(WavySphere(48, 33, 0.05), SourcesOnBumpy());
  field->GenerateSourceIdsOn();
  AskForCoordinates(field);
  field->Update();
  const auto paths = FilterOn<vtkGeodesicPaths>(WavySphere(48, 33, 0.05), SourcesOnBumpy());
  paths->SetTargetsData(WavySphere(48, 33, 0.05));
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
  check.Equal(count, field->GetOutput()->GetNumberOfPoints(), "a path from each vertex");
  vtkDataArray* ids = field->GetOutput()->GetPointData()->GetArray("SourceId");
  int apart = 0;
  const double largest = arrays.Distances->GetRange()[1];
  for (vtkIdType i = 0; i < count; ++i)
  {
    check.Near(CellValue(paths->GetOutput(), "GeodesicDistance", i), arrays.Distances->GetTuple1(i),
      1e-12 * largest, "a path is as long as the distance");
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
  const auto filter = RefinedField(Square(8), PointSources({ { 0.3, 0.4, 0 } }));
  AskForCoordinates(filter);
  filter->UpdatePiece(1, 2, 0);
  check.Equal(filter->GetOutput()->GetNumberOfPoints(), 0.0, "piece 1");
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
      const Point p = PointAt(surface, i);
      surface->GetPoints()->SetPoint(i, side * p[0], side * p[1], side * p[2]);
    }
    const auto filter =
      PlainField(surface, Polyline({ { 0, 0.5 * side, 0 }, { side, 0.5 * side, 0 } }));
    filter->SetMaximumDistance(0.3 * side);
    filter->SetUnreachedValueToCustom();
    filter->SetCustomUnreachedValue(-7.0);
    filter->GenerateTextureCoordinatesOn();
    filter->SetTextureScale(asked);
    filter->Update();
    vtkPolyData* output = filter->GetOutput();
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const Point p = PointAt(output, i);
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
    const auto filter =
      PlainField(Square(4), isCurve ? Polyline(curve) : PointSources({ { 0.5, 0.5, 0 } }));
    filter->GenerateTextureCoordinatesOn();
    filter->SetTextureScale(0.5);
    filter->Update();
    const auto tiles = CopyOf(filter->GetOutput());
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
    CheckBlocks(check, refine);
    CheckAgainstSourceOnSurface(check, refine);
  }
  CheckTextureScale(check);
  CheckSinglePicture(check);
  CheckAgainstPaths(check);
  CheckPieces(check);
  CheckDefaults(check);
  return check.Result();
}
