// SPDX-License-Identifier: BSD-3-Clause
// What the filter's tests share: surfaces whose distances are known, curves, captured messages.
#ifndef GeodesicTesting_h
#define GeodesicTesting_h

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkGeodesicDistanceField.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkTestErrorObserver.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <functional>
#include <iostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace GeodesicTesting
{

using Point = std::array<double, 3>;
using Distance = std::function<double(const Point&)>;
using Change = std::function<Point(const Point&)>;

/// Counts and prints what does not hold.
class Check
{
public:
  void That(bool holds, const std::string& what)
  {
    if (!holds)
    {
      std::cout << "FAILED: " << what << "\n";
      ++this->Failures;
    }
  }
  void Equal(double actual, double expected, const std::string& what)
  {
    this->That(actual == expected,
      what + ": " + std::to_string(actual) + " instead of " + std::to_string(expected));
  }
  /// To be returned by the test.
  int Result() const { return this->Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE; }

private:
  int Failures = 0;
};

/// Runs a filter and keeps what it says.
class Messages
{
public:
  explicit Messages(vtkAlgorithm* filter)
    : Filter(filter)
  {
    filter->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    filter->AddObserver(vtkCommand::WarningEvent, this->Observer);
    // What hinders it from executing, its executive says.
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->ExecutiveObserver);
  }
  void Clear()
  {
    this->Observer->Clear();
    this->ExecutiveObserver->Clear();
  }
  void Update()
  {
    this->Clear();
    this->Filter->Update();
  }
  std::string Error() const { return Text(this->Observer->GetErrorMessage()); }
  std::string ExecutiveError() const { return this->ExecutiveObserver->GetErrorMessage(); }
  std::string Warning() const { return Text(this->Observer->GetWarningMessage()); }

private:
  /// The message without "ERROR: In file, line, object:", which the test harness takes for a
  /// failure.
  static std::string Text(const std::string& message)
  {
    const std::size_t begin = message.find("): ");
    return begin == std::string::npos ? message : message.substr(begin + 3);
  }

  vtkAlgorithm* Filter;
  vtkNew<vtkTest::ErrorObserver> Observer;
  vtkNew<vtkTest::ErrorObserver> ExecutiveObserver;
};

/// Calls a function at an event of an object, for as long as both exist.
class Listener
{
public:
  Listener(vtkObject* object, unsigned long event, std::function<void()> function)
    : Object(object)
    , Function(std::move(function))
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* self, void*)
      { static_cast<Listener*>(self)->Function(); });
    object->AddObserver(event, this->Command);
  }
  ~Listener()
  {
    if (this->Object)
    {
      this->Object->RemoveObserver(this->Command);
    }
  }
  Listener(const Listener&) = delete;
  void operator=(const Listener&) = delete;

private:
  vtkWeakPointer<vtkObject> Object;
  std::function<void()> Function;
  vtkNew<vtkCallbackCommand> Command;
};

/// Tells in which executions a filter has built the structure of the surface: reading that is the
/// first part of the work, of which there is no progress where the structure is used again.
class BuildWatch
{
public:
  explicit BuildWatch(vtkAlgorithm* filter)
    : Filter(filter)
    , Begin(filter, vtkCommand::StartEvent, [this] { this->IsCounted = false; })
    , Progress(filter, vtkCommand::ProgressEvent, [this] { this->Look(); })
  {
  }
  /// How often since this was asked last.
  int Count() { return std::exchange(this->Times, 0); }

private:
  void Look()
  {
    constexpr double surfaceRead = 0.1;
    const double progress = this->Filter->GetProgress();
    if (progress > 0.0 && progress < surfaceRead && !this->IsCounted)
    {
      this->IsCounted = true;
      ++this->Times;
    }
  }

  vtkAlgorithm* Filter;
  Listener Begin;
  Listener Progress;
  bool IsCounted = false;
  int Times = 0;
};

inline bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

enum class Cells
{
  Triangles,
  Quads,
  Strips
};

inline void InsertSquare(vtkCellArray* polys, Cells cells, const std::array<vtkIdType, 4>& corners)
{
  if (cells == Cells::Quads)
  {
    polys->InsertNextCell(4, corners.data());
    return;
  }
  polys->InsertNextCell({ corners[0], corners[1], corners[2] });
  polys->InsertNextCell({ corners[0], corners[2], corners[3] });
}

/// The unit square in the plane z = 0 with n x n squares. With n a power of two the coordinates are
/// exact in 32 bits too. The distance in it is the Euclidean one.
inline vtkSmartPointer<vtkPolyData> Square(
  int n, Cells cells = Cells::Triangles, int dataType = VTK_DOUBLE)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(dataType);
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      points->InsertNextPoint(static_cast<double>(i) / n, static_cast<double>(j) / n, 0.0);
    }
  }
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkCellArray> strips;
  for (int j = 0; j < n; ++j)
  {
    if (cells == Cells::Strips)
    {
      strips->InsertNextCell(2 * (n + 1));
    }
    for (int i = 0; i <= n; ++i)
    {
      const vtkIdType below = j * (n + 1) + i;
      const vtkIdType above = below + n + 1;
      if (cells == Cells::Strips)
      {
        strips->InsertCellPoint(below);
        strips->InsertCellPoint(above);
      }
      else if (i < n)
      {
        InsertSquare(polys, cells, { below, below + 1, above + 1, above });
      }
    }
  }
  auto square = vtkSmartPointer<vtkPolyData>::New();
  square->SetPoints(points);
  square->SetPolys(polys);
  square->SetStrips(strips);
  return square;
}

/// Of this process, in seconds.
inline double ProcessorTime()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// A square of n x n with every point moved a little, so that there are saddles everywhere.
inline vtkSmartPointer<vtkPolyData> NoisySquare(int n, Cells cells = Cells::Triangles)
{
  auto surface = Square(n, cells);
  std::mt19937_64 random(2007);
  std::uniform_real_distribution<double> offset(-0.15 / n, 0.15 / n);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    for (double& x : p)
    {
      x += offset(random);
    }
    surface->GetPoints()->SetPoint(i, p);
  }
  return surface;
}

/// Moves every point; nothing is told that it is modified.
inline void MovePoints(vtkPolyData* data, const Change& change)
{
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    Point p;
    data->GetPoint(i, p.data());
    data->GetPoints()->SetPoint(i, change(p).data());
  }
}

/// A sphere whose points were moved.
inline vtkSmartPointer<vtkPolyData> ChangedSphere(
  int thetaResolution, int phiResolution, const Change& change)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(thetaResolution);
  sphere->SetPhiResolution(phiResolution);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  vtkSmartPointer<vtkPolyData> surface = sphere->GetOutput();
  MovePoints(surface, change);
  return surface;
}

/// Triangles that share no points, as an STL file has them.
inline vtkSmartPointer<vtkPolyData> Soup(vtkPolyData* data)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  for (vtkIdType f = 0; f < data->GetNumberOfPolys(); ++f)
  {
    vtkNew<vtkIdList> ids;
    data->GetPolys()->GetCellAtId(f, ids);
    polys->InsertNextCell(3);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      polys->InsertCellPoint(points->InsertNextPoint(data->GetPoint(ids->GetId(k))));
    }
  }
  auto soup = vtkSmartPointer<vtkPolyData>::New();
  soup->SetPoints(points);
  soup->SetPolys(polys);
  return soup;
}

/// A surface without boundary.
inline vtkSmartPointer<vtkPolyData> Tetrahedron()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0, 1, 0);
  points->InsertNextPoint(0, 0, 1);
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 2, 1 });
  polys->InsertNextCell({ 0, 1, 3 });
  polys->InsertNextCell({ 1, 2, 3 });
  polys->InsertNextCell({ 2, 0, 3 });
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(polys);
  return surface;
}

/// Points without cells.
inline vtkSmartPointer<vtkPolyData> PointSources(
  const std::vector<Point>& positions, int dataType = VTK_DOUBLE)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(dataType);
  for (const Point& p : positions)
  {
    points->InsertNextPoint(p.data());
  }
  auto source = vtkSmartPointer<vtkPolyData>::New();
  source->SetPoints(points);
  return source;
}

/// One polyline through the points.
inline vtkSmartPointer<vtkPolyData> Polyline(
  const std::vector<Point>& positions, bool closed = false, int dataType = VTK_DOUBLE)
{
  auto curve = PointSources(positions, dataType);
  const auto size = static_cast<vtkIdType>(positions.size());
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(size) + (closed ? 1 : 0));
  for (vtkIdType i = 0; i < size + (closed ? 1 : 0); ++i)
  {
    lines->InsertCellPoint(i % size);
  }
  curve->SetLines(lines);
  return curve;
}

/// Where on a segment it is nearest to p, as a fraction of the way from a to b.
inline double FractionNearestTo(const Point& p, const Point& a, const Point& b)
{
  double along = 0.0;
  double length2 = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    along += (p[k] - a[k]) * (b[k] - a[k]);
    length2 += (b[k] - a[k]) * (b[k] - a[k]);
  }
  return length2 > 0.0 ? std::clamp(along / length2, 0.0, 1.0) : 0.0;
}

inline double DistanceToSegment(const Point& p, const Point& a, const Point& b)
{
  const double t = FractionNearestTo(p, a, b);
  return std::hypot(p[0] - a[0] - t * (b[0] - a[0]), p[1] - a[1] - t * (b[1] - a[1]),
    p[2] - a[2] - t * (b[2] - a[2]));
}

/// Euclidean distance to a polyline: true on a convex piece of a plane.
inline Distance DistanceTo(std::vector<Point> line)
{
  return [line](const Point& p)
  {
    double least = DistanceToSegment(p, line[0], line[0]);
    for (std::size_t i = 1; i < line.size(); ++i)
    {
      least = std::min(least, DistanceToSegment(p, line[i - 1], line[i]));
    }
    return least;
  };
}

inline double DistanceToBoundaryOfSquare(const Point& p)
{
  return std::min({ p[0], 1.0 - p[0], p[1], 1.0 - p[1] });
}

inline vtkDataArray* Distances(vtkGeodesicDistanceField* filter)
{
  return filter->GetOutput()->GetPointData()->GetArray(filter->GetDistanceArrayName());
}

inline void AskForAllArrays(vtkGeodesicDistanceField* filter)
{
  filter->GenerateSourceIdsOn();
  filter->GenerateClosestPointsOn();
  filter->GenerateGradientsOn();
  filter->GenerateSignedDistanceOn();
  filter->GenerateSourceArcLengthOn();
  filter->GenerateSourceAngleOn();
  filter->GenerateTextureCoordinatesOn();
}

/// Input about which the filter has something to say.
struct Case
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Surface;
  vtkSmartPointer<vtkPolyData> Source;
  /// All of these stand in the message.
  std::vector<std::string> Words;
  int SourceType = vtkGeodesicDistanceField::SOURCE_CURVE;
};

inline void CheckWords(Check& check, const Case& odd, const std::string& message)
{
  std::cout << odd.Name << ":\n" << message << "\n";
  for (const std::string& word : odd.Words)
  {
    check.That(Contains(message, word), odd.Name + ": the message says \"" + word + "\"");
  }
}

/// Runs the filter; what goes in stays as it is.
inline void Run(Check& check, vtkGeodesicDistanceField* filter, Messages& messages, const Case& odd)
{
  // Times of modification, of which a change of anything changes one.
  const auto timeOf = [](vtkPolyData* data) { return data ? data->GetMTime() : 0; };
  filter->SetInputData(odd.Surface);
  filter->SetSourceData(odd.Source);
  filter->SetSourceType(odd.SourceType);
  const vtkMTimeType surfaceTime = timeOf(odd.Surface);
  const vtkMTimeType sourceTime = timeOf(odd.Source);
  messages.Update();
  check.That(timeOf(odd.Surface) == surfaceTime, odd.Name + " leaves the surface untouched");
  check.That(timeOf(odd.Source) == sourceTime, odd.Name + " leaves the source untouched");
}

/// Checks the distances at all points against the truth, within a fraction of the largest.
inline void CheckDistances(Check& check, vtkGeodesicDistanceField* filter, const Distance& truth,
  const std::string& what, double tolerance = 1e-12)
{
  vtkPolyData* output = filter->GetOutput();
  vtkDataArray* distances = Distances(filter);
  if (!distances || distances->GetNumberOfTuples() != output->GetNumberOfPoints() ||
    output->GetNumberOfPoints() == 0)
  {
    check.That(false, what + ": no distance at every point");
    return;
  }
  double largest = 0.0;
  double worst = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    Point p;
    output->GetPoint(i, p.data());
    const double expected = truth(p);
    largest = std::max(largest, expected);
    const double error = std::abs(distances->GetTuple1(i) - expected);
    worst = std::isnan(worst) || error <= worst ? worst : error;
  }
  check.That(worst <= tolerance * largest,
    what + ": wrong by " + std::to_string(worst / largest) + " of the largest distance");
}

inline void CheckOutputsEmpty(
  Check& check, vtkGeodesicDistanceField* filter, const std::string& what)
{
  for (int port = 0; port < 2; ++port)
  {
    auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port));
    check.That(output->GetNumberOfPoints() == 0 && output->GetNumberOfCells() == 0 &&
        output->GetPointData()->GetNumberOfArrays() == 0,
      what + " leaves output port " + std::to_string(port) + " empty");
  }
}

}

#endif
