// SPDX-License-Identifier: BSD-3-Clause
// Curves that are given as lines of two points, in any order and direction, and the same curves as
// polylines: what every filter must make of the lines.
#ifndef LineTesting_h
#define LineTesting_h

#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkGeodesicContour.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicPaths.h"
#include "vtkTable.h"

#include <map>
#include <set>

namespace GeodesicTesting
{

/// A line of two points.
using Segment = std::array<Point, 2>;

struct Curve
{
  std::vector<Point> points;
  bool closed = false;
  /// Of a closed curve: whether no other line meets it, so that it may begin anywhere.
  bool isFree = true;

  std::size_t CountSegments() const { return this->points.size() - (this->closed ? 0 : 1); }
  Segment SegmentAt(std::size_t i) const
  {
    return { this->points[i], this->points[(i + 1) % this->points.size()] };
  }
};

/// The curves as polylines, in the order of their ids.
struct ByHand
{
  vtkSmartPointer<vtkPolyData> Source;
  /// The lowest line of each.
  std::vector<vtkIdType> Ids;
};

/// Where a line is on the curves.
struct PlaceOnCurve
{
  std::size_t Curve = 0;
  std::size_t Index = 0;
  bool IsReversed = false;
};

/// The curve in the direction, and from the beginning, that its lines give it.
inline Curve Directed(
  const Curve& curve, const PlaceOnCurve& lowest, std::size_t forward, std::size_t reversed)
{
  const std::size_t n = curve.points.size();
  const bool isTurned = reversed > forward || (reversed == forward && lowest.IsReversed);
  Curve result = curve;
  result.points.clear();
  std::size_t first = curve.closed && curve.isFree ? lowest.Index + (isTurned ? 1 : 0) : 0;
  first = isTurned && !curve.closed ? n - 1 : first;
  for (std::size_t i = 0; i < n; ++i)
  {
    result.points.push_back(curve.points[(first + (isTurned ? n - i : i)) % n]);
  }
  return result;
}

/// What the lines are, if together they are these curves. A curve of one point is a line without
/// length.
inline ByHand JoinedByHand(const std::vector<Curve>& curves, const std::vector<Segment>& lines)
{
  std::map<Segment, PlaceOnCurve> places;
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    for (std::size_t i = 0; i < curves[c].CountSegments(); ++i)
    {
      const auto [a, b] = curves[c].SegmentAt(i);
      places[{ a, b }] = { c, i, false };
      places[{ b, a }] = { c, i, true };
    }
    if (curves[c].points.size() == 1)
    {
      places[{ curves[c].points[0], curves[c].points[0] }] = { c, 0, false };
    }
  }
  std::map<std::size_t, vtkIdType> lowest; // of each curve
  std::vector<std::array<std::size_t, 2>> directions(curves.size());
  std::set<std::pair<std::size_t, std::size_t>> known;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    const auto at = places.find(lines[i]);
    if (at != places.end() && known.emplace(at->second.Curve, at->second.Index).second)
    {
      lowest.emplace(at->second.Curve, static_cast<vtkIdType>(i));
      ++directions[at->second.Curve][at->second.IsReversed ? 1 : 0];
    }
  }
  std::vector<std::pair<vtkIdType, std::size_t>> order;
  for (const auto& [curve, id] : lowest)
  {
    order.emplace_back(id, curve);
  }
  std::sort(order.begin(), order.end());
  ByHand made;
  std::vector<Point> points;
  std::vector<std::vector<vtkIdType>> cells;
  for (const auto& [id, c] : order)
  {
    const Curve curve = Directed(curves[c], places.at(lines[static_cast<std::size_t>(id)]),
      directions[c][0], directions[c][1]);
    std::vector<vtkIdType>& cell = cells.emplace_back();
    for (const Point& p : curve.points)
    {
      cell.push_back(static_cast<vtkIdType>(points.size()));
      points.push_back(p);
    }
    if (curve.closed)
    {
      cell.push_back(cell.front());
    }
    made.Ids.push_back(id);
  }
  made.Source = PointSources(points);
  made.Source->SetLines(CellArray(cells));
  return made;
}

/// Lines as cells, with points of their own or one a place.
inline vtkSmartPointer<vtkPolyData> LinesOf(
  const std::vector<Segment>& lines, bool arePointsShared = true)
{
  std::vector<Point> points;
  std::vector<std::vector<vtkIdType>> cells;
  std::map<Point, vtkIdType> numbers;
  for (const Segment& line : lines)
  {
    std::vector<vtkIdType>& cell = cells.emplace_back();
    for (const Point& p : line)
    {
      const auto next = static_cast<vtkIdType>(points.size());
      const auto [at, isNew] = numbers.emplace(p, next);
      cell.push_back(isNew || !arePointsShared ? next : at->second);
      if (cell.back() == next)
      {
        points.push_back(p);
      }
    }
  }
  auto data = PointSources(points);
  data->SetLines(CellArray(cells));
  return data;
}

/// Compares arrays bit for bit. In SourceId each id of the curves by hand stands for another.
inline void CompareArrays(Check& check, vtkFieldData* actual, vtkFieldData* expected,
  const std::vector<vtkIdType>& ids, const std::string& what)
{
  check.Equal(actual->GetNumberOfArrays(), expected->GetNumberOfArrays(), what + ": arrays");
  for (int k = 0; k < expected->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* wanted = expected->GetArray(k);
    const std::string name = wanted->GetName();
    vtkDataArray* found = actual->GetArray(name.c_str());
    if (!found || found->GetNumberOfTuples() != wanted->GetNumberOfTuples())
    {
      check.That(false, what + ": " + name + " is missing or of another size");
      continue;
    }
    const bool areIds = name == "SourceId";
    vtkIdType different = 0;
    for (vtkIdType i = 0; i < wanted->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < wanted->GetNumberOfComponents(); ++c)
      {
        double value = wanted->GetComponent(i, c);
        value = areIds && value >= 0.0 ? static_cast<double>(ids[static_cast<std::size_t>(value)])
                                       : value;
        different += found->GetComponent(i, c) == value ? 0 : 1;
      }
    }
    check.Equal(different, 0.0, what + ": values of " + name + " that are different");
  }
}

inline void CompareData(Check& check, vtkPolyData* actual, vtkPolyData* expected,
  const std::vector<vtkIdType>& ids, const std::string& what)
{
  check.That(PlacesOf(actual) == PlacesOf(expected), what + ": the points");
  check.That(CellsOf(actual->GetVerts()) == CellsOf(expected->GetVerts()), what + ": vertices");
  check.That(CellsOf(actual->GetLines()) == CellsOf(expected->GetLines()), what + ": lines");
  check.That(CellsOf(actual->GetPolys()) == CellsOf(expected->GetPolys()), what + ": polygons");
  CompareArrays(check, actual->GetPointData(), expected->GetPointData(), ids, what + ", at points");
  CompareArrays(check, actual->GetCellData(), expected->GetCellData(), ids, what + ", of cells");
}

inline std::vector<std::string> ColumnsOf(vtkTable* table)
{
  std::vector<std::string> names;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    names.emplace_back(table->GetColumnName(i));
  }
  return names;
}

/// Whether a face is not oriented as its neighbors are, or an edge has three faces: there are no
/// sides then.
inline bool HasNoSides(const std::string& error)
{
  return Contains(error, "one orientation");
}

/// Sources in two forms: lines, and the same by hand.
struct TwoForms
{
  vtkDataObject* Lines;
  ByHand Curves;
};

/// A filter for either form.
template <typename Filter>
struct FilterPair
{
  FilterPair(vtkDataObject* surface, const TwoForms& forms, const std::function<void(Filter*)>& set)
    : Ids(forms.Curves.Ids)
  {
    for (Filter* filter : { this->Lines.Get(), this->ByHand.Get() })
    {
      filter->SetInputDataObject(0, surface);
      set(filter);
    }
    this->Lines->SetSourceData(forms.Lines);
    this->ByHand->SetSourceData(forms.Curves.Source);
    this->ByHand->JoinLinesOff();
  }
  void Run(Check& check, const std::string& what)
  {
    RunWithoutError(check, this->ByHand, what + ", by hand");
    RunWithoutError(check, this->Lines, what);
  }
  void Compare(Check& check, int port, const std::string& what)
  {
    CompareData(check, OutputOf(this->Lines, port), OutputOf(this->ByHand, port), this->Ids, what);
  }

  const std::vector<vtkIdType>& Ids;
  vtkNew<Filter> Lines;
  vtkNew<Filter> ByHand;
};

/// Distances, ids, arc lengths, signs, angles and frames are those of the curves.
inline void CompareFields(Check& check, vtkDataObject* surface, const TwoForms& forms,
  bool isRefined, const std::string& what)
{
  FilterPair<vtkGeodesicDistanceField> pair(surface, forms,
    [&](vtkGeodesicDistanceField* filter)
    {
      filter->SetRefineMesh(isRefined);
      filter->SetMaximumNumberOfCells(20000);
      filter->GenerateSourceIdsOn();
      filter->GenerateClosestPointsOn();
      filter->GenerateSourceArcLengthOn();
      filter->GenerateSourceAngleOn();
      filter->GenerateSignedDistanceOn();
    });
  Messages ofByHand(pair.ByHand);
  ofByHand.Update();
  if (HasNoSides(ofByHand.Error()))
  {
    pair.Lines->GenerateSignedDistanceOff();
    pair.ByHand->GenerateSignedDistanceOff();
    ofByHand.Update();
  }
  check.That(ofByHand.Error().empty(), what + ", by hand: " + ofByHand.Error());
  pair.Run(check, what);
  pair.Compare(check, 0, what + ": field");
  pair.Compare(check, 1, what + ": source");
  const auto framesOf = [](vtkAlgorithm* filter)
  { return filter->GetOutputDataObject(0)->GetFieldData()->GetArray("SourceFrame"); };
  vtkDataArray* frames = framesOf(pair.Lines);
  vtkDataArray* wanted = framesOf(pair.ByHand);
  for (std::size_t i = 0; wanted && i < pair.Ids.size(); ++i)
  {
    for (int k = 0; k < 9; ++k)
    {
      check.That(frames && pair.Ids[i] < frames->GetNumberOfTuples() &&
          frames->GetComponent(pair.Ids[i], k) ==
            wanted->GetComponent(static_cast<vtkIdType>(i), k),
        what + ": frame of source " + std::to_string(pair.Ids[i]));
    }
  }
}

/// Lines of the value 0 are the curves.
inline void CompareContours(
  Check& check, vtkDataObject* surface, const TwoForms& forms, const std::string& what)
{
  FilterPair<vtkGeodesicContour> pair(surface, forms,
    [](vtkGeodesicContour* filter)
    {
      filter->SetValue(0, 0.0);
      filter->SetValue(1, 0.2);
    });
  pair.Run(check, what);
  pair.Compare(check, 0, what + ": contour");
}

inline void ComparePaths(Check& check, vtkDataObject* surface, const TwoForms& forms,
  vtkPolyData* targets, const std::string& what)
{
  FilterPair<vtkGeodesicPaths> pair(surface, forms,
    [&](vtkGeodesicPaths* filter)
    {
      filter->SetTargetsData(targets);
      filter->GenerateSourceArcLengthOn();
    });
  pair.Run(check, what);
  pair.Compare(check, 0, what + ": paths");
}

inline void CompareMatrices(Check& check, vtkDataObject* surface, const TwoForms& forms,
  vtkPolyData* targets, const std::string& what)
{
  FilterPair<vtkGeodesicDistanceMatrix> pair(
    surface, forms, [&](vtkGeodesicDistanceMatrix* filter) { filter->SetTargetsData(targets); });
  pair.Run(check, what);
  vtkTable* table = pair.Lines->GetOutput();
  check.Equal(table->GetNumberOfColumns(), forms.Curves.Ids.size() + 1, what + ": columns");
  for (std::size_t i = 0; i < forms.Curves.Ids.size(); ++i)
  {
    const std::string name = "Source" + std::to_string(forms.Curves.Ids[i]);
    auto* column = vtkDataArray::SafeDownCast(table->GetColumnByName(name.c_str()));
    auto* wanted = vtkDataArray::SafeDownCast(
      pair.ByHand->GetOutput()->GetColumnByName(("Source" + std::to_string(i)).c_str()));
    check.That(column && wanted, what + ": a column " + name);
    for (vtkIdType row = 0; column && wanted && row < wanted->GetNumberOfTuples(); ++row)
    {
      check.Equal(column->GetTuple1(row), wanted->GetTuple1(row), what + ": " + name);
    }
  }
}

/// All four filters make the same of lines as of the curves by hand, bit for bit.
inline void CompareAll(Check& check, vtkPolyData* surface, vtkDataObject* lines,
  const ByHand& curves, const std::string& what, bool isRefined = false)
{
  const TwoForms forms{ lines, curves };
  CompareFields(check, surface, forms, isRefined, what);
  CompareContours(check, surface, forms, what);
  ComparePaths(check, surface, forms, surface, what);
  CompareMatrices(check, surface, forms, surface, what);
}
}

#endif
