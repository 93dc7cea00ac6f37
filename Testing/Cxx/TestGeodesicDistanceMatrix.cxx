// SPDX-License-Identifier: BSD-3-Clause
// The table of distances: columns and rows, truth on a plane, the bits of the field, sources of all
// kinds, threads, progress, abort, and what is wrong with the input.
#include "GeodesicTesting.h"

#include "vtkDoubleArray.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"

#include <thread>

using namespace GeodesicTesting;

namespace
{

double At(vtkTable* table, vtkIdType target, vtkIdType source)
{
  return vtkDoubleArray::SafeDownCast(table->GetColumn(source + 1))->GetValue(target);
}

/// Checks the names and types of columns.
void CheckColumns(
  Check& check, vtkTable* table, vtkIdType rows, int sources, const std::string& what)
{
  check.Equal(
    static_cast<double>(table->GetNumberOfRows()), static_cast<double>(rows), what + "rows");
  check.Equal(static_cast<double>(table->GetNumberOfColumns()), sources + 1, what + "columns");
  auto* ids = vtkIdTypeArray::SafeDownCast(table->GetColumnByName("TargetId"));
  check.That(ids && ids == table->GetColumn(0), what + "TargetId comes first");
  for (vtkIdType i = 0; i < rows; ++i)
  {
    check.Equal(static_cast<double>(ids->GetValue(i)), static_cast<double>(i), what + "TargetId");
  }
  for (int i = 0; i < sources; ++i)
  {
    auto* column = vtkDoubleArray::SafeDownCast(table->GetColumn(i + 1));
    check.That(column && column->GetName() == "Source" + std::to_string(i), what + "Source column");
  }
}

void CheckTruthInTheSquare(Check& check)
{
  const std::vector<Point> points = { { 0.1, 0.2, 0 }, { 0.9, 0.7, 0 }, { 0.4, 0.35, 0 } };
  const std::vector<Point> targets = { { 0.5, 0.5, 0 }, { 0.25, 0.75, 0 }, { 0.9, 0.7, 0 },
    { 0.1, 0.99, 0 } };
  vtkNew<vtkGeodesicDistanceMatrix> filter;
  filter->SetInputData(Square(8));
  filter->SetSourceData(PointSources(points));
  filter->SetTargetsData(PointSources(targets));
  Messages messages(filter);
  messages.Update();
  check.That(messages.Error().empty() && messages.Warning().empty(), "square: no message");
  vtkTable* table = filter->GetOutput();
  CheckColumns(check, table, 4, 3, "square: ");
  for (std::size_t t = 0; t < targets.size(); ++t)
  {
    for (std::size_t s = 0; s < points.size(); ++s)
    {
      const double expected =
        std::hypot(targets[t][0] - points[s][0], targets[t][1] - points[s][1]);
      const double distance = At(table, static_cast<vtkIdType>(t), static_cast<vtkIdType>(s));
      check.That(std::abs(distance - expected) <= 1e-15, "square: the distance is Euclidean");
    }
  }
  filter->SetMaximumDistance(0.5);
  messages.Update();
  vtkNew<vtkTable> limited;
  limited->DeepCopy(filter->GetOutput());
  filter->SetMaximumDistance(0.0);
  messages.Update();
  for (vtkIdType t = 0; t < 4; ++t)
  {
    for (vtkIdType s = 0; s < 3; ++s)
    {
      const double distance = At(filter->GetOutput(), t, s);
      check.Equal(At(limited, t, s), distance <= 0.5 ? distance : vtkMath::Inf(), "limited");
    }
  }
}

/// Lines, vertex cells, cells without points, several blocks, and the loops of the boundary.
void CheckSources(Check& check)
{
  auto cells =
    PointSources({ { 0.25, 0.25, 0 }, { 0.25, 0.75, 0 }, { 0.75, 0.25, 0 }, { 0.875, 0.25, 0 } });
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 2, 3 });
  cells->SetVerts(verts);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(0);
  lines->InsertNextCell({ 0, 1 });
  cells->SetLines(lines);
  vtkNew<vtkMultiBlockDataSet> sources;
  sources->SetBlock(0, cells);
  sources->SetBlock(1, PointSources({ { 0.5, 0.9, 0 } }));
  vtkNew<vtkGeodesicDistanceMatrix> filter;
  filter->SetInputData(Square(16));
  filter->SetSourceData(sources);
  filter->SetTargetsData(PointSources({ { 0.5, 0.5, 0 }, { 1.0, 0.25, 0.5 } }));
  filter->SetSourceTypeToCurveAndBoundary();
  filter->Update();
  vtkTable* table = filter->GetOutput();
  CheckColumns(check, table, 2, 5, "sources: ");
  const double inf = vtkMath::Inf();
  const double corner = std::hypot(0.25, 0.25);
  const double expected[2][5] = { { corner, inf, 0.25, 0.4, 0.5 },
    { 0.125, inf, 0.75, std::hypot(0.5, 0.65), 0.0 } };
  for (vtkIdType t = 0; t < 2; ++t)
  {
    for (vtkIdType s = 0; s < 5; ++s)
    {
      const double distance = At(table, t, s);
      const double truth = expected[t][s];
      // A path crosses up to 30 faces, each with a rounding or two.
      check.That(distance == truth || std::abs(distance - truth) <= 4e-15,
        "source " + std::to_string(s) + ": " + std::to_string(distance));
    }
  }
}

vtkSmartPointer<vtkPolyData> Bumpy()
{
  return ChangedSphere(60, 40,
    [](const Point& p) {
      return Point{ p[0] + 0.02 * std::sin(20.0 * p[1]), 0.6 * p[1], 1.7 * p[2] };
    });
}

/// Some of the surface's own points.
vtkSmartPointer<vtkPolyData> SomePoints(vtkPolyData* surface, int step)
{
  std::vector<Point> points;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); i += step)
  {
    surface->GetPoint(i, points.emplace_back().data());
  }
  return PointSources(points);
}

/// Without targets the points of port 1 are those; between points the table is symmetric, and at
/// vertices it has the bits of the field of each source.
void CheckSymmetryAndField(Check& check)
{
  const auto surface = Bumpy();
  const int step = 97;
  const auto points = SomePoints(surface, step);
  const vtkIdType count = points->GetNumberOfPoints();
  vtkNew<vtkGeodesicDistanceMatrix> filter;
  filter->SetInputData(surface);
  filter->SetSourceData(points);
  filter->Update();
  vtkTable* table = filter->GetOutput();
  CheckColumns(check, table, count, static_cast<int>(count), "symmetry: ");
  vtkNew<vtkGeodesicDistanceField> field;
  field->SetInputData(surface);
  field->SetRefineMesh(false);
  double largest = 0.0;
  double worst = 0.0;
  for (vtkIdType s = 0; s < count; ++s)
  {
    Point p;
    points->GetPoint(s, p.data());
    field->SetSourceData(PointSources({ p }));
    field->Update();
    for (vtkIdType t = 0; t < count; ++t)
    {
      check.Equal(At(table, t, s), Distances(field)->GetTuple1(t * step), "the bits of the field");
      largest = std::max(largest, At(table, t, s));
      worst = std::max(worst, std::abs(At(table, t, s) - At(table, s, t)));
    }
  }
  check.That(worst <= 1e-12 * largest, "symmetric up to " + std::to_string(worst / largest));
}

/// Where a point lies depends neither on whether it is a source or a target nor on how precise its
/// coordinates are.
void CheckPointsBesideTheSurface(Check& check)
{
  const auto sphere = ChangedSphere(16, 16, [](const Point& p) { return Point(p); });
  for (const int dataType : { VTK_FLOAT, VTK_DOUBLE })
  {
    for (const double away : { 1.1, 0.9, 1.5 })
    {
      std::vector<Point> points;
      for (int i = 0; i < 40; ++i)
      {
        const double polar = 0.2 + 2.7 * i / 40.0;
        const double around = 2.4 * i;
        points.push_back({ 0.5 * away * std::sin(polar) * std::cos(around),
          0.5 * away * std::sin(polar) * std::sin(around), 0.5 * away * std::cos(polar) });
      }
      // Beside an edge of the sphere as seen from both of its faces.
      points.push_back({ 0.5 * away, 1e-5, 1e-5 });
      points.push_back({ 1e-5, 1e-5, 0.5 * away });
      vtkNew<vtkGeodesicDistanceMatrix> filter;
      filter->SetInputData(sphere);
      filter->SetSourceData(PointSources(points, dataType));
      filter->Update();
      vtkTable* table = filter->GetOutput();
      const auto count = static_cast<vtkIdType>(points.size());
      CheckColumns(check, table, count, static_cast<int>(count), "beside the surface: ");
      for (vtkIdType s = 0; s < count; ++s)
      {
        check.Equal(At(table, s, s), 0.0, "a point's distance to itself");
        for (vtkIdType t = 0; t < s; ++t)
        {
          check.That(std::abs(At(table, t, s) - At(table, s, t)) <= 1e-12,
            "distances beside the surface are symmetric");
        }
      }
    }
  }
}

vtkSmartPointer<vtkTable> RunBumpy(const std::vector<Point>& targets)
{
  vtkNew<vtkGeodesicDistanceMatrix> filter;
  const auto surface = Bumpy();
  filter->SetInputData(surface);
  filter->SetSourceData(SomePoints(surface, 301));
  filter->SetTargetsData(PointSources(targets));
  filter->Update();
  return filter->GetOutput();
}

/// With a far target each solve stops later.
void CheckFarTarget(Check& check)
{
  const std::vector<Point> near = { { 0.0, 0.0, 0.85 }, { 0.1, 0.1, 0.8 }, { -0.1, 0.03, 0.8 } };
  std::vector<Point> withFar = near;
  withFar.push_back({ 0.0, 0.0, -0.85 });
  const auto alone = RunBumpy(near);
  const auto other = RunBumpy(withFar);
  for (vtkIdType s = 0; s + 1 < alone->GetNumberOfColumns(); ++s)
  {
    for (vtkIdType t = 0; t < 3; ++t)
    {
      check.Equal(At(alone, t, s), At(other, t, s), "the same bits with a far target");
    }
  }
}

/// A surface of two parts: from the one no path leads to the other.
void CheckUnreached(Check& check)
{
  auto far = Square(2);
  MovePoints(far, [](const Point& p) { return Point{ p[0] + 5.0, p[1], p[2] }; });
  vtkNew<vtkMultiBlockDataSet> surface;
  surface->SetBlock(0, Square(2));
  surface->SetBlock(1, far);
  vtkNew<vtkGeodesicDistanceMatrix> filter;
  filter->SetInputData(surface);
  filter->SetSourceData(PointSources({ { 0, 0, 0 }, { 5, 0, 0 } }));
  filter->Update();
  vtkTable* table = filter->GetOutput();
  check.That(table != nullptr, "a table for a composite surface");
  CheckColumns(check, table, 2, 2, "unreached: ");
  check.Equal(At(table, 0, 0), 0.0, "itself");
  check.Equal(At(table, 1, 1), 0.0, "itself");
  check.Equal(At(table, 0, 1), vtkMath::Inf(), "the other part");
  check.Equal(At(table, 1, 0), vtkMath::Inf(), "the other part");
}

/// Where sources are solved on several threads, progress comes from the caller's all the same.
void CheckProgressOnThreads(Check& check)
{
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(2);
  for (const double fraction : { 2.0, 0.31, 0.6, 0.9 })
  {
    vtkNew<vtkGeodesicDistanceMatrix> filter;
    const auto surface = Bumpy();
    filter->SetInputData(surface);
    filter->SetSourceData(SomePoints(surface, 17));
    std::vector<double> progress;
    const auto caller = std::this_thread::get_id();
    Listener listener(filter, vtkCommand::ProgressEvent,
      [&]()
      {
        check.That(std::this_thread::get_id() == caller, "progress comes from the caller's thread");
        progress.push_back(filter->GetProgress());
        filter->SetAbortExecute(progress.back() >= fraction ? 1 : 0);
      });
    const std::string what = "at " + std::to_string(fraction);
    RunWithoutError(check, filter, what);
    check.That(std::is_sorted(progress.begin(), progress.end()), what + ": progress never falls");
    const auto inside = [](double x) { return x > 0.3 && x < 0.98; };
    check.That((filter->GetOutput()->GetNumberOfColumns() == 0) == (fraction < 1.0),
      what + ": the output is empty if it was aborted");
    check.That(fraction < 1.0 || std::count_if(progress.begin(), progress.end(), inside) > 5,
      what + ": progress is reported while sources are solved");
  }
  vtkSMPTools::SetBackend("Sequential");
}

/// Input about which there is an error.
struct Bad
{
  std::string Name;
  vtkSmartPointer<vtkDataObject> Source;
  vtkSmartPointer<vtkDataObject> Targets;
  double MaximumDistance;
  std::vector<std::string> Words;
};

void CheckBadInput(Check& check)
{
  const double nan = vtkMath::Nan();
  const auto good = PointSources({ { 0, 0, 0 } });
  const std::vector<Bad> cases = {
    { "no source", nullptr, good, 0.0, { "no source", "choose a Source" } },
    { "neither", nullptr, nullptr, 0.0, { "port 2", "targets" } },
    { "empty targets", good, vtkSmartPointer<vtkPolyData>::New(), 0.0, { "port 2", "empty" } },
    { "NaN targets", good, PointSources({ { 0, 0, 0 }, { nan, 0, 0 } }), 0.0,
      { "port 2", "NaN", "point 1", "Remove" } },
    { "a negative limit", good, good, -1.0, { "MaximumDistance" } },
    { "a limit that is no number", good, good, nan, { "MaximumDistance" } },
  };
  for (const Bad& bad : cases)
  {
    vtkNew<vtkGeodesicDistanceMatrix> filter;
    filter->SetInputData(Square(2));
    filter->SetSourceData(good);
    Messages messages(filter);
    messages.Update();
    check.Equal(static_cast<double>(filter->GetOutput()->GetNumberOfRows()), 1, "a good run");
    filter->SetSourceData(bad.Source);
    filter->SetTargetsData(bad.Targets);
    filter->SetMaximumDistance(bad.MaximumDistance);
    messages.Update();
    std::cout << bad.Name << ":\n" << messages.Error() << "\n";
    for (const std::string& word : bad.Words)
    {
      check.That(Contains(messages.Error(), word), bad.Name + ": says \"" + word + "\"");
    }
    check.Equal(static_cast<double>(filter->GetOutput()->GetNumberOfColumns()), 0,
      bad.Name + " leaves the output empty");
  }
}

}

int TestGeodesicDistanceMatrix(int, char*[])
{
  Check check;
  CheckTruthInTheSquare(check);
  CheckSources(check);
  CheckSymmetryAndField(check);
  CheckPointsBesideTheSurface(check);
  CheckFarTarget(check);
  CheckUnreached(check);
  CheckProgressOnThreads(check);
  CheckBadInput(check);
  return check.Result();
}
