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
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const auto& [id, c] : order)
  {
    const Curve curve = Directed(curves[c], places.at(lines[static_cast<std::size_t>(id)]),
      directions[c][0], directions[c][1]);
    const vtkIdType first = points->GetNumberOfPoints();
    cells->InsertNextCell(static_cast<int>(curve.points.size()) + (curve.closed ? 1 : 0));
    for (const Point& p : curve.points)
    {
      cells->InsertCellPoint(points->InsertNextPoint(p.data()));
    }
    if (curve.closed)
    {
      cells->InsertCellPoint(first);
    }
    made.Ids.push_back(id);
  }
  made.Source = vtkSmartPointer<vtkPolyData>::New();
  made.Source->SetPoints(points);
  made.Source->SetLines(cells);
  return made;
}

/// Lines as cells, with points of their own or one a place.
inline vtkSmartPointer<vtkPolyData> LinesOf(
  const std::vector<Segment>& lines, bool arePointsShared = true)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  std::map<Point, vtkIdType> numbers;
  for (const Segment& line : lines)
  {
    cells->InsertNextCell(2);
    for (const Point& p : line)
    {
      const auto [at, isNew] = numbers.emplace(p, points->GetNumberOfPoints());
      cells->InsertCellPoint(
        isNew || !arePointsShared ? points->InsertNextPoint(p.data()) : at->second);
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
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
    check.Equal(
      static_cast<double>(different), 0.0, what + ": values of " + name + " that are different");
  }
}

inline std::vector<std::vector<vtkIdType>> CellsOf(vtkCellArray* cells)
{
  std::vector<std::vector<vtkIdType>> result;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    cells->GetCellAtId(i, ids);
    result.emplace_back(ids->begin(), ids->end());
  }
  return result;
}

inline std::vector<Point> PlacesOf(vtkPolyData* data)
{
  std::vector<Point> places(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoint(i, places[static_cast<std::size_t>(i)].data());
  }
  return places;
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

inline vtkPolyData* OutputOf(vtkAlgorithm* filter, int port = 0)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port));
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

template <typename Filter>
void SetInputs(Filter* lines, Filter* byHand, vtkDataObject* surface, const TwoForms& forms)
{
  for (Filter* filter : { lines, byHand })
  {
    filter->SetInputDataObject(0, surface);
  }
  lines->SetSourceData(forms.Lines);
  byHand->SetSourceData(forms.Curves.Source);
  byHand->JoinLinesOff();
}

/// Distances, ids, arc lengths, signs, angles and frames are those of the curves.
inline void CompareFields(Check& check, vtkDataObject* surface, const TwoForms& forms,
  bool isRefined, const std::string& what)
{
  vtkNew<vtkGeodesicDistanceField> lines;
  vtkNew<vtkGeodesicDistanceField> byHand;
  SetInputs(lines.Get(), byHand.Get(), surface, forms);
  for (vtkGeodesicDistanceField* filter : { lines.Get(), byHand.Get() })
  {
    filter->SetRefineMesh(isRefined);
    filter->SetMaximumNumberOfCells(20000);
    filter->GenerateSourceIdsOn();
    filter->GenerateClosestPointsOn();
    filter->GenerateSourceArcLengthOn();
    filter->GenerateSourceAngleOn();
    filter->GenerateSignedDistanceOn();
  }
  Messages ofByHand(byHand);
  Messages ofLines(lines);
  ofByHand.Update();
  if (HasNoSides(ofByHand.Error()))
  {
    lines->GenerateSignedDistanceOff();
    byHand->GenerateSignedDistanceOff();
    ofByHand.Update();
  }
  ofLines.Update();
  check.That(ofByHand.Error().empty(), what + ", by hand: " + ofByHand.Error());
  check.That(ofLines.Error().empty(), what + ": " + ofLines.Error());
  CompareData(check, OutputOf(lines), OutputOf(byHand), forms.Curves.Ids, what + ": field");
  CompareData(check, OutputOf(lines, 1), OutputOf(byHand, 1), forms.Curves.Ids, what + ": source");
  vtkDataArray* frames = lines->GetOutputDataObject(0)->GetFieldData()->GetArray("SourceFrame");
  vtkDataArray* wanted = byHand->GetOutputDataObject(0)->GetFieldData()->GetArray("SourceFrame");
  for (std::size_t i = 0; wanted && i < forms.Curves.Ids.size(); ++i)
  {
    for (int k = 0; k < 9; ++k)
    {
      check.That(frames && forms.Curves.Ids[i] < frames->GetNumberOfTuples() &&
          frames->GetComponent(forms.Curves.Ids[i], k) ==
            wanted->GetComponent(static_cast<vtkIdType>(i), k),
        what + ": frame of source " + std::to_string(forms.Curves.Ids[i]));
    }
  }
}

/// Lines of the value 0 are the curves.
inline void CompareContours(
  Check& check, vtkDataObject* surface, const TwoForms& forms, const std::string& what)
{
  vtkNew<vtkGeodesicContour> lines;
  vtkNew<vtkGeodesicContour> byHand;
  SetInputs(lines.Get(), byHand.Get(), surface, forms);
  for (vtkGeodesicContour* filter : { lines.Get(), byHand.Get() })
  {
    filter->SetValue(0, 0.0);
    filter->SetValue(1, 0.2);
  }
  Messages messages(lines);
  Messages ofByHand(byHand);
  messages.Update();
  ofByHand.Update();
  check.That(messages.Error().empty(), what + ": " + messages.Error());
  CompareData(check, OutputOf(lines), OutputOf(byHand), forms.Curves.Ids, what + ": contour");
}

inline void ComparePaths(Check& check, vtkDataObject* surface, const TwoForms& forms,
  vtkPolyData* targets, const std::string& what)
{
  vtkNew<vtkGeodesicPaths> lines;
  vtkNew<vtkGeodesicPaths> byHand;
  SetInputs(lines.Get(), byHand.Get(), surface, forms);
  for (vtkGeodesicPaths* filter : { lines.Get(), byHand.Get() })
  {
    filter->SetTargetsData(targets);
    filter->GenerateSourceArcLengthOn();
  }
  Messages messages(lines);
  Messages ofByHand(byHand);
  messages.Update();
  ofByHand.Update();
  check.That(messages.Error().empty(), what + ": " + messages.Error());
  CompareData(check, OutputOf(lines), OutputOf(byHand), forms.Curves.Ids, what + ": paths");
}

inline void CompareMatrices(Check& check, vtkDataObject* surface, const TwoForms& forms,
  vtkPolyData* targets, const std::string& what)
{
  vtkNew<vtkGeodesicDistanceMatrix> lines;
  vtkNew<vtkGeodesicDistanceMatrix> byHand;
  SetInputs(lines.Get(), byHand.Get(), surface, forms);
  lines->SetTargetsData(targets);
  byHand->SetTargetsData(targets);
  Messages messages(lines);
  messages.Update();
  byHand->Update();
  check.That(messages.Error().empty(), what + ": " + messages.Error());
  vtkTable* table = lines->GetOutput();
  check.Equal(static_cast<double>(table->GetNumberOfColumns()),
    static_cast<double>(forms.Curves.Ids.size() + 1), what + ": columns");
  for (std::size_t i = 0; i < forms.Curves.Ids.size(); ++i)
  {
    const std::string name = "Source" + std::to_string(forms.Curves.Ids[i]);
    auto* column = vtkDataArray::SafeDownCast(table->GetColumnByName(name.c_str()));
    auto* wanted = vtkDataArray::SafeDownCast(
      byHand->GetOutput()->GetColumnByName(("Source" + std::to_string(i)).c_str()));
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
