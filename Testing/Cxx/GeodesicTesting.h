// SPDX-License-Identifier: BSD-3-Clause
// What the filter's tests share: surfaces whose distances are known, curves, captured messages.
#ifndef GeodesicTesting_h
#define GeodesicTesting_h

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkCutter.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkGeodesicDistanceField.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlane.h"
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
#include <cstring>
#include <ctime>
#include <functional>
#include <initializer_list>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace GeodesicTesting
{

using Point = std::array<double, 3>;
using Distance = std::function<double(const Point&)>;
using Change = std::function<Point(const Point&)>;
using Where = std::function<bool(const Point&)>;

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
  /// Numbers of any two types, compared as double.
  template <typename Actual, typename Expected>
  void Equal(Actual actual, Expected expected, const std::string& what)
  {
    this->Near(static_cast<double>(actual), static_cast<double>(expected), 0.0, what);
  }
  /// Infinity is near to itself alone, NaN to nothing.
  void Near(double actual, double expected, double tolerance, const std::string& what)
  {
    if (!(actual == expected || std::abs(actual - expected) <= tolerance))
    {
      this->That(
        false, what + ": " + std::to_string(actual) + " instead of " + std::to_string(expected));
    }
  }
  /// To be returned by the test.
  int Result() const { return this->Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE; }

private:
  int Failures = 0;
};

inline bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

inline void CheckWords(Check& check, const std::string& message,
  const std::vector<std::string>& words, const std::string& what)
{
  for (const std::string& word : words)
  {
    check.That(Contains(message, word), what + ": \"" + word + "\" is missing in: " + message);
  }
}

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
  /// Each of these runs the filter. All words have to stand in the message.
  void ExpectError(Check& check, const std::vector<std::string>& words, const std::string& what)
  {
    this->Update();
    CheckWords(check, this->Error(), words, what);
  }
  void ExpectWarning(Check& check, const std::vector<std::string>& words, const std::string& what)
  {
    this->Update();
    CheckWords(check, this->Warning(), words, what);
  }
  void ExpectNoError(Check& check, const std::string& what)
  {
    this->Update();
    check.That(this->Error().empty(), what + ": " + this->Error());
  }
  void ExpectNoWarning(Check& check, const std::string& what)
  {
    this->Update();
    check.That(this->Warning().empty(), what + ": " + this->Warning());
  }
  void ExpectNothing(Check& check, const std::string& what)
  {
    this->ExpectNoWarning(check, what);
    check.That(this->Error().empty(), what + ": " + this->Error());
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

/// Runs a filter, which must not fail. \returns its warnings.
inline std::string RunWithoutError(Check& check, vtkAlgorithm* filter, const std::string& what)
{
  Messages messages(filter);
  messages.ExpectNoError(check, what);
  return messages.Warning();
}

/// A filter with its inputs. By default a distance field refines the mesh.
template <typename Filter>
vtkSmartPointer<Filter> FilterOn(vtkDataObject* surface, vtkDataObject* source)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputDataObject(0, surface);
  filter->SetSourceData(source);
  return filter;
}

inline vtkSmartPointer<vtkGeodesicDistanceField> RefinedField(
  vtkDataObject* surface, vtkDataObject* source)
{
  return FilterOn<vtkGeodesicDistanceField>(surface, source);
}

/// A distance field at the points of the surface alone.
inline vtkSmartPointer<vtkGeodesicDistanceField> PlainField(
  vtkDataObject* surface, vtkDataObject* source)
{
  auto filter = RefinedField(surface, source);
  filter->RefineMeshOff();
  return filter;
}

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
  /// Runs the filter without an error; it builds the structure, or does not.
  void Expect(Check& check, bool built, const std::string& when)
  {
    RunWithoutError(check, this->Filter, when);
    check.That(this->Count() == (built ? 1 : 0),
      "the structure is " + std::string(built ? "" : "not ") + "built " + when);
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

/// A point of a data set, or of vtkPoints.
template <typename Data>
Point PointAt(const Data& data, vtkIdType id)
{
  Point p;
  data->GetPoint(id, p.data());
  return p;
}

/// The numbers of an array at a point, as a place or a direction.
inline Point TupleAt(vtkDataArray* array, vtkIdType id)
{
  Point p;
  array->GetTuple(id, p.data());
  return p;
}

inline double Dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point Minus(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline Point Cross(const Point& a, const Point& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

/// All points of a data set.
template <typename Data>
std::vector<Point> PlacesOf(const Data& data)
{
  std::vector<Point> places;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    places.push_back(PointAt(data, i));
  }
  return places;
}

/// All numbers of an array.
inline std::vector<double> NumbersOf(vtkDataArray* array)
{
  std::vector<double> numbers;
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    numbers.push_back(array->GetComponent(
      i / array->GetNumberOfComponents(), static_cast<int>(i % array->GetNumberOfComponents())));
  }
  return numbers;
}

/// Some points of a data set.
template <typename Data>
std::vector<Point> PlacesOf(const Data& data, const std::vector<vtkIdType>& ids)
{
  std::vector<Point> places;
  for (const vtkIdType id : ids)
  {
    places.push_back(PointAt(data, id));
  }
  return places;
}

inline double PointValue(vtkDataSet* data, const char* name, vtkIdType point)
{
  return data->GetPointData()->GetArray(name)->GetTuple1(point);
}

inline double CellValue(vtkDataSet* data, const char* name, vtkIdType cell)
{
  return data->GetCellData()->GetArray(name)->GetTuple1(cell);
}

/// Gives a data set's points, cells or itself an array of these values.
template <typename Array, typename Values>
Array* AddArray(vtkFieldData* data, const char* name, const Values& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  for (const auto& value : values)
  {
    array->InsertNextValue(static_cast<typename Array::ValueType>(value));
  }
  data->AddArray(array);
  return array;
}

template <typename Array>
Array* AddArray(
  vtkFieldData* data, const char* name, std::initializer_list<typename Array::ValueType> values)
{
  return AddArray<Array>(data, name, std::vector<typename Array::ValueType>(values));
}

/// \param valueOf the value of each of so many points or cells.
template <typename Array, typename Function>
Array* AddArrayOf(vtkFieldData* data, const char* name, vtkIdType count, const Function& valueOf)
{
  std::vector<typename Array::ValueType> values;
  for (vtkIdType i = 0; i < count; ++i)
  {
    values.push_back(static_cast<typename Array::ValueType>(valueOf(i)));
  }
  return AddArray<Array>(data, name, values);
}

/// The points of a cell.
inline std::vector<vtkIdType> IdsOf(vtkCellArray* cells, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  cells->GetCellAtId(cell, ids);
  return { ids->begin(), ids->end() };
}

inline std::vector<std::vector<vtkIdType>> CellsOf(vtkCellArray* cells)
{
  std::vector<std::vector<vtkIdType>> result;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    result.push_back(IdsOf(cells, i));
  }
  return result;
}

/// Cells by the numbers of their points, of any type.
template <typename Polygons>
vtkSmartPointer<vtkCellArray> CellArrayOf(const Polygons& cells)
{
  auto array = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& cell : cells)
  {
    array->InsertNextCell(static_cast<int>(cell.size()));
    for (const auto id : cell)
    {
      array->InsertCellPoint(static_cast<vtkIdType>(id));
    }
  }
  return array;
}

inline vtkSmartPointer<vtkCellArray> CellArray(const std::vector<std::vector<vtkIdType>>& cells)
{
  return CellArrayOf(cells);
}

inline vtkPolyData* OutputOf(vtkAlgorithm* filter, int port = 0)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port));
}

/// The data sets that a data object is made of: itself, or the leaves of a composite.
inline std::vector<vtkPolyData*> LeavesOf(vtkDataObject* data)
{
  if (auto* one = vtkPolyData::SafeDownCast(data))
  {
    return { one };
  }
  std::vector<vtkPolyData*> leaves;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto iterator = vtk::TakeSmartPointer(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      leaves.push_back(vtkPolyData::SafeDownCast(iterator->GetCurrentDataObject()));
    }
  }
  return leaves;
}

inline vtkSmartPointer<vtkMultiBlockDataSet> Blocks(
  const std::vector<vtkSmartPointer<vtkDataObject>>& parts)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (unsigned int i = 0; i < parts.size(); ++i)
  {
    blocks->SetBlock(i, parts[i]);
  }
  return blocks;
}

/// The corners of a cell, and their middle.
inline std::vector<Point> CornersOf(vtkPolyData* data, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  data->GetCellPoints(cell, ids);
  return PlacesOf(data, { ids->begin(), ids->end() });
}

inline Point CentreOf(vtkPolyData* data, vtkIdType cell)
{
  const std::vector<Point> corners = CornersOf(data, cell);
  Point centre{};
  for (const Point& corner : corners)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      centre[i] += corner[i] / static_cast<double>(corners.size());
    }
  }
  return centre;
}

/// Some faces of a surface with their arrays and the points that they use, which have global ids if
/// that is asked for.
inline vtkSmartPointer<vtkPolyData> Part(
  vtkPolyData* surface, const std::vector<vtkIdType>& faces, bool hasGlobalIds = false)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(surface->GetPoints()->GetDataType());
  vtkNew<vtkIdTypeArray> globalIds;
  globalIds->SetName("GlobalPointIds");
  std::map<vtkIdType, vtkIdType> numbers;
  std::vector<std::vector<vtkIdType>> polygons;
  for (const vtkIdType face : faces)
  {
    polygons.push_back(IdsOf(surface->GetPolys(), face));
    for (vtkIdType& id : polygons.back())
    {
      const auto [at, isNew] = numbers.emplace(id, points->GetNumberOfPoints());
      if (isNew)
      {
        points->InsertNextPoint(surface->GetPoint(id));
        globalIds->InsertNextValue(id);
      }
      id = at->second;
    }
  }
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->SetPoints(points);
  part->SetPolys(CellArrayOf(polygons));
  part->GetCellData()->CopyAllocate(surface->GetCellData());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    part->GetCellData()->CopyData(surface->GetCellData(), faces[i], static_cast<vtkIdType>(i));
  }
  if (hasGlobalIds)
  {
    part->GetPointData()->SetGlobalIds(globalIds);
  }
  return part;
}

/// The faces whose centre is there.
inline vtkSmartPointer<vtkPolyData> Part(vtkPolyData* surface, const Where& isThere)
{
  std::vector<vtkIdType> faces;
  for (vtkIdType face = 0; face < surface->GetNumberOfPolys(); ++face)
  {
    if (isThere(CentreOf(surface, face)))
    {
      faces.push_back(face);
    }
  }
  return Part(surface, faces);
}

/// A block of the output.
inline vtkPolyData* Block(vtkAlgorithm* filter, unsigned int index)
{
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  return output ? vtkPolyData::SafeDownCast(output->GetBlock(index)) : nullptr;
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
    Point p = PointAt(surface, i);
    for (double& x : p)
    {
      x += offset(random);
    }
    surface->GetPoints()->SetPoint(i, p.data());
  }
  return surface;
}

inline vtkSmartPointer<vtkPolyData> CopyOf(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(data);
  return copy;
}

/// Moves every point; nothing is told that it is modified.
inline void MovePoints(vtkPolyData* data, const Change& change)
{
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const Point p = PointAt(data, i);
    data->GetPoints()->SetPoint(i, change(p).data());
  }
}

inline Change MovedBy(double x, double y = 0.0, double z = 0.0)
{
  return [=](const Point& p) { return Point{ p[0] + x, p[1] + y, p[2] + z }; };
}

inline Change ScaledBy(double scale)
{
  return [=](const Point& p) { return Point{ scale * p[0], scale * p[1], scale * p[2] }; };
}

inline vtkSmartPointer<vtkPolyData> Moved(vtkSmartPointer<vtkPolyData> data, const Change& change)
{
  MovePoints(data, change);
  return data;
}

/// Adds points and polygons, which share nothing with those that are there.
inline void Append(vtkPolyData* to, vtkPolyData* more)
{
  const vtkIdType first = to->GetNumberOfPoints();
  for (const Point& p : PlacesOf(more))
  {
    to->GetPoints()->InsertNextPoint(p.data());
  }
  for (std::vector<vtkIdType>& ids : CellsOf(more->GetPolys()))
  {
    for (vtkIdType& id : ids)
    {
      id += first;
    }
    to->GetPolys()->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
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

/// Polygons over these points; ids of any type.
template <typename Polygons = std::vector<std::vector<vtkIdType>>>
vtkSmartPointer<vtkPolyData> Mesh(
  const std::vector<Point>& positions, const Polygons& polygons, int dataType = VTK_DOUBLE)
{
  auto mesh = PointSources(positions, dataType);
  mesh->SetPolys(CellArrayOf(polygons));
  return mesh;
}

/// A closed surface without symmetry.
inline vtkSmartPointer<vtkPolyData> WavySphere(
  int thetaResolution, int phiResolution, double height = 0.02)
{
  return ChangedSphere(thetaResolution, phiResolution,
    [height](const Point& p) {
      return Point{ p[0] + height * std::sin(20.0 * p[1]), 0.6 * p[1], 1.7 * p[2] };
    });
}

/// Triangles that share no points, as an STL file has them.
inline vtkSmartPointer<vtkPolyData> Soup(vtkPolyData* data)
{
  std::vector<Point> points;
  std::vector<std::vector<vtkIdType>> triangles;
  for (vtkIdType f = 0; f < data->GetNumberOfPolys(); ++f)
  {
    const std::vector<Point> corners = CornersOf(data, f);
    points.insert(points.end(), corners.begin(), corners.end());
    triangles.push_back({ 3 * f, 3 * f + 1, 3 * f + 2 });
  }
  return Mesh(points, triangles);
}

/// A surface without boundary.
inline vtkSmartPointer<vtkPolyData> Tetrahedron()
{
  return Mesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } });
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

inline double LengthBetween(const Point& a, const Point& b)
{
  return DistanceToSegment(a, b, b);
}

/// The length of one line of a data set, and of all.
inline double LengthOf(vtkPolyData* data, vtkIdType line)
{
  const std::vector<vtkIdType> ids = IdsOf(data->GetLines(), line);
  double length = 0.0;
  for (std::size_t i = 1; i < ids.size(); ++i)
  {
    length += LengthBetween(PointAt(data, ids[i - 1]), PointAt(data, ids[i]));
  }
  return length;
}

inline double TotalLength(vtkPolyData* data)
{
  double length = 0.0;
  for (vtkIdType line = 0; line < data->GetNumberOfLines(); ++line)
  {
    length += LengthOf(data, line);
  }
  return length;
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
  CheckWords(check, message, odd.Words, odd.Name);
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
    const Point p = PointAt(output, i);
    const double expected = truth(p);
    largest = std::max(largest, expected);
    const double error = std::abs(distances->GetTuple1(i) - expected);
    worst = std::isnan(worst) || error <= worst ? worst : error;
  }
  check.That(worst <= tolerance * largest,
    what + ": wrong by " + std::to_string(worst / largest) + " of the largest distance");
}

/// Checks the distances at all points of a data set, infinity included.
inline void CheckTruth(Check& check, vtkPolyData* output, const Distance& truth,
  const std::string& what, double tolerance = 1e-12)
{
  vtkDataArray* distances = output->GetPointData()->GetArray("GeodesicDistance");
  check.That(distances && distances->GetNumberOfTuples() == output->GetNumberOfPoints(),
    what + ": a distance at every point");
  for (vtkIdType i = 0; distances && i < output->GetNumberOfPoints(); ++i)
  {
    check.Near(distances->GetTuple1(i), truth(PointAt(output, i)), tolerance,
      what + ", point " + std::to_string(i));
  }
}

/// Bit for bit.
inline bool AreSame(vtkDataArray* a, vtkDataArray* b)
{
  return a == b ||
    (a && b && a->GetDataType() == b->GetDataType() &&
      a->GetNumberOfValues() == b->GetNumberOfValues() &&
      a->GetNumberOfComponents() == b->GetNumberOfComponents() &&
      (a->GetNumberOfValues() == 0 ||
        std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
          static_cast<std::size_t>(a->GetNumberOfValues() * a->GetDataTypeSize())) == 0));
}

/// A plane section, as lines of two points.
inline vtkSmartPointer<vtkPolyData> Section(
  vtkPolyData* surface, const Point& normal, const Point& origin)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(normal.data());
  plane->SetOrigin(origin.data());
  vtkNew<vtkCutter> slice;
  slice->SetInputData(surface);
  slice->SetCutFunction(plane);
  slice->Update();
  return slice->GetOutput();
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
