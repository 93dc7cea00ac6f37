// SPDX-License-Identifier: BSD-3-Clause
// What stands at points that are not reached, and whether points that no face uses are put out.
#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <limits>
#include <sstream>

using namespace GeodesicTesting;

namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();
constexpr double Custom = -7.25;

/// A point that no face uses, a square, another such point, and a square apart.
vtkSmartPointer<vtkPolyData> TwoSquaresAndUnusedPoints()
{
  auto data = Mesh({ { -1, -1, 0 } }, {});
  Append(data, Square(4));
  data->GetPoints()->InsertNextPoint(9.0, 9.0, 9.0);
  Append(data, Moved(Square(4), MovedBy(3.0)));
  return data;
}

/// A line across the first square, whose left side is that of greater x.
vtkSmartPointer<vtkPolyData> Line()
{
  return Polyline({ { 0.4, 1, 0 }, { 0.4, 0, 0 } });
}

/// Whether two numbers are the same, NaN and NaN too.
bool IsSame(double a, double b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

vtkDataArray* ArrayOf(vtkGeodesicDistanceField* filter, const char* name)
{
  return filter->GetOutput()->GetPointData()->GetArray(name);
}

void ChooseAll(vtkGeodesicDistanceField* filter)
{
  filter->SetInputData(TwoSquaresAndUnusedPoints());
  filter->SetSourceData(Line());
  AskForAllArrays(filter);
}

/// Against the same with infinity: what is finite is the same, what is infinite is the value, in
/// the distance, the signed one and the coordinates; nothing else changes.
void CheckValue(
  Check& check, vtkGeodesicDistanceField* filter, double value, const std::string& what)
{
  vtkNew<vtkGeodesicDistanceField> infinite;
  ChooseAll(infinite);
  infinite->SetRefineMesh(filter->GetRefineMesh());
  infinite->SetMaximumDistance(filter->GetMaximumDistance());
  infinite->SetRemoveUnusedPoints(filter->GetRemoveUnusedPoints());
  infinite->Update();
  filter->Update();
  const vtkIdType count = infinite->GetOutput()->GetNumberOfPoints();
  check.Equal(filter->GetOutput()->GetNumberOfPoints(), count, what + ": points");
  for (const char* name : { "GeodesicDistance", "SignedGeodesicDistance", "SourceArcLength",
         "SourceAngle", "SourceTextureCoordinates" })
  {
    vtkDataArray* before = ArrayOf(infinite, name);
    vtkDataArray* after = ArrayOf(filter, name);
    bool isRight = true;
    vtkIdType unreached = 0;
    for (vtkIdType i = 0; i < count; ++i)
    {
      for (int k = 0; k < before->GetNumberOfComponents(); ++k)
      {
        const double old = before->GetComponent(i, k);
        unreached += old == Infinite && k == 0 ? 1 : 0;
        isRight = isRight && IsSame(after->GetComponent(i, k), old == Infinite ? value : old);
      }
    }
    check.That(isRight, what + ": " + name);
    check.That(
      unreached > 0 && unreached < count, what + ": some points are not reached by " + name);
  }
  for (const char* name : { "SourceId", "ClosestSourcePoint", "DistanceGradient" })
  {
    vtkDataArray* before = ArrayOf(infinite, name);
    vtkDataArray* after = ArrayOf(filter, name);
    check.That(NumbersOf(before) == NumbersOf(after), what + ": " + name + " does not change");
  }
  check.Equal(filter->GetInterpolationErrorBound(), infinite->GetInterpolationErrorBound(),
    what + ": the bound");
}

void CheckUnreachedValues(Check& check)
{
  for (const bool refine : { false, true })
  {
    for (const double limit : { 0.0, 0.3 })
    {
      for (const bool remove : { false, true })
      {
        vtkNew<vtkGeodesicDistanceField> filter;
        ChooseAll(filter);
        filter->SetRefineMesh(refine);
        filter->SetMaximumDistance(limit);
        filter->SetRemoveUnusedPoints(remove);
        std::ostringstream what;
        what << (refine ? "refined" : "plain") << ", maximum " << limit
             << (remove ? ", used points" : "");
        CheckValue(check, filter, Infinite, "Infinity, " + what.str());
        filter->SetUnreachedValueToNaN();
        CheckValue(check, filter, vtkMath::Nan(), "NaN, " + what.str());
        filter->SetCustomUnreachedValue(Custom);
        filter->SetUnreachedValueToCustom();
        CheckValue(check, filter, Custom, "Custom, " + what.str());
        filter->SetCustomUnreachedValue(12.0); // has no sign of a side
        CheckValue(check, filter, 12.0, "Custom above 0, " + what.str());
        filter->SetUnreachedValueToInfinity();
        CheckValue(check, filter, Infinite, "Infinity again, " + what.str());
      }
    }
  }
}

/// The second square is not reached. Its points do not count if no face uses them.
void CheckFarthest(Check& check)
{
  for (const int mode : { 0, 1, 2 })
  {
    for (const bool isAlone : { false, true })
    {
      auto surface = TwoSquaresAndUnusedPoints();
      const auto alone = CopyOf(surface);
      vtkNew<vtkCellArray> faces;
      vtkNew<vtkIdList> ids;
      for (vtkIdType i = 0; i < surface->GetNumberOfPolys() / 2; ++i)
      {
        surface->GetPolys()->GetCellAtId(i, ids);
        faces->InsertNextCell(ids);
      }
      alone->SetPolys(faces);
      const auto filter = RefinedField(isAlone ? alone.GetPointer() : surface.GetPointer(), Line());
      filter->SetUnreachedValue(mode);
      filter->SetCustomUnreachedValue(1e6);
      filter->Update();
      check.That(filter->GetHasUnreachedPoints() == !isAlone, "faces that are not reached");
      double largest = 0.0;
      vtkPolyData* output = filter->GetOutput();
      vtkDataArray* distances = output->GetPointData()->GetArray("GeodesicDistance");
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        const double distance = distances->GetTuple1(i);
        largest = distance < 1e6 ? std::max(largest, distance) : largest;
      }
      check.Equal(filter->GetLargestDistance(), largest, "the largest distance");
      Point place;
      filter->GetFarthestPoint(place.data());
      // Newer VTK hides the FindPoint of three numbers.
      const vtkIdType there = output->FindPoint(place.data());
      check.Equal(distances->GetTuple1(there), largest, "where the largest distance is");
      check.That(PointAt(output, there) == place, "the farthest is a point");
    }
  }
}

void CheckDefaults(Check& check)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  check.Equal(filter->GetUnreachedValue(), 0, "the default is Infinity");
  check.That(!filter->GetRemoveUnusedPoints(), "unused points stay by default");
  filter->SetUnreachedValue(17);
  check.Equal(
    filter->GetUnreachedValue(), vtkGeodesicDistanceField::UNREACHED_CUSTOM, "values are clamped");
  filter->SetCustomUnreachedValue(0.125);
  filter->RemoveUnusedPointsOn();
  std::ostringstream printed;
  filter->Print(printed);
  for (const char* words :
    { "UnreachedValue: Custom", "CustomUnreachedValue: 0.125", "RemoveUnusedPoints: On" })
  {
    check.That(Contains(printed.str(), words), std::string("printed: ") + words);
  }
}

/// Point data of all kinds that say which point of the input each was.
vtkSmartPointer<vtkPolyData> WithNumbers(vtkSmartPointer<vtkPolyData> data)
{
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Id");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    numbers->InsertNextValue(static_cast<int>(i));
    names->InsertNextValue("p" + std::to_string(i));
    ids->InsertNextValue(1000 + i);
  }
  data->GetPointData()->AddArray(numbers);
  data->GetPointData()->AddArray(names);
  data->GetPointData()->SetGlobalIds(ids);
  return data;
}

std::vector<bool> ArePointsUsed(vtkPolyData* data)
{
  std::vector<bool> are(static_cast<std::size_t>(data->GetNumberOfPoints()), false);
  for (const std::vector<vtkIdType>& ids : CellsOf(data->GetPolys()))
  {
    for (const vtkIdType id : ids)
    {
      are[static_cast<std::size_t>(id)] = true;
    }
  }
  return are;
}

/// The points of the output of one block: those of the input that faces use, in their order.
void CheckUsedPoints(Check& check, vtkPolyData* input, vtkPolyData* output, const std::string& what)
{
  const std::vector<bool> isUsed = ArePointsUsed(input);
  auto* names = vtkStringArray::SafeDownCast(output->GetPointData()->GetAbstractArray("Name"));
  check.That(output->GetPointData()->GetScalars() &&
      std::string(output->GetPointData()->GetScalars()->GetName()) == "GeodesicDistance",
    what + ": the distance is the active array");
  vtkIdType next = 0;
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    if (isUsed[static_cast<std::size_t>(i)])
    {
      check.That(next < output->GetNumberOfPoints() && PointAt(input, i) == PointAt(output, next) &&
          PointValue(output, "Number", next) == static_cast<double>(i) &&
          names->GetValue(next) == "p" + std::to_string(i),
        what + ": point " + std::to_string(i) + " of the input");
      ++next;
    }
  }
  const std::vector<bool> isUsedNow = ArePointsUsed(output);
  check.That(std::find(isUsedNow.begin(), isUsedNow.end(), false) == isUsedNow.end(),
    what + ": every point of the output is used");
}

/// Every triangle is at its place.
void CheckSameTriangles(
  Check& check, vtkPolyData* whole, vtkPolyData* used, const std::string& what)
{
  check.Equal(used->GetNumberOfPolys(), whole->GetNumberOfPolys(), what + ": triangles");
  bool isSame = true;
  for (vtkIdType f = 0; f < whole->GetNumberOfPolys(); ++f)
  {
    const std::vector<vtkIdType> a = IdsOf(whole->GetPolys(), f);
    const std::vector<vtkIdType> b = IdsOf(used->GetPolys(), f);
    for (std::size_t k = 0; k < 3; ++k)
    {
      isSame = isSame && PointAt(whole, a[k]) == PointAt(used, b[k]) &&
        IsSame(
          PointValue(whole, "GeodesicDistance", a[k]), PointValue(used, "GeodesicDistance", b[k]));
    }
  }
  check.That(isSame, what + ": corners and their distances");
}

void CheckRemoval(Check& check)
{
  for (const bool refine : { false, true })
  {
    const std::string what = refine ? "refined" : "plain";
    const auto input = WithNumbers(TwoSquaresAndUnusedPoints());
    const vtkMTimeType time = input->GetMTime();
    const auto filter = RefinedField(input, Line());
    filter->SetRefineMesh(refine);
    filter->Update();
    const auto whole = CopyOf(filter->GetOutput());
    const auto curves = CopyOf(OutputOf(filter, 1));
    check.Equal(PointValue(whole, "GeodesicDistance", 0), Infinite,
      what + ": an unused point is infinitely far");

    filter->RemoveUnusedPointsOn();
    filter->Update();
    vtkPolyData* used = filter->GetOutput();
    check.Equal(used->GetNumberOfPoints(), whole->GetNumberOfPoints() - 2,
      what + ": two points are left out");
    CheckUsedPoints(check, input, used, what);
    CheckSameTriangles(check, whole, used, what);
    check.That(input->GetMTime() == time && input->GetNumberOfPoints() == 52 &&
        input->GetPointData()->GetArray("Number")->GetNumberOfTuples() == 52,
      what + ": the input stays as it is");
    check.That(refine ||
        (used->GetPointData()->GetGlobalIds() &&
          used->GetPointData()->GetGlobalIds()->GetTuple1(0) == 1001.0),
      what + ": global ids go with their points");
    auto* line = OutputOf(filter, 1);
    check.Equal(line->GetNumberOfPoints(), curves->GetNumberOfPoints(),
      what + ": output port 1 stays as it is");
  }
}

void CheckNothingToRemove(Check& check)
{
  const auto input = Square(4);
  const auto filter = PlainField(input, PointSources({ { 0, 0, 0 } }));
  filter->RemoveUnusedPointsOn();
  filter->Update();
  check.That(filter->GetOutput()->GetPoints() == input->GetPoints() &&
      filter->GetOutput()->GetPolys() == input->GetPolys(),
    "where all points are used, they are shared with the input");
}

/// Each block for itself; a block without faces has no points then.
void CheckComposite(Check& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  const auto first = WithNumbers(TwoSquaresAndUnusedPoints());
  const auto second = Moved(WithNumbers(Square(4)), MovedBy(-1.0));
  blocks->SetBlock(0, first);
  blocks->SetBlock(1, second);
  blocks->SetBlock(3, PointSources({ { 5, 5, 5 } }));
  for (const bool refine : { false, true })
  {
    const std::string what = refine ? "composite, refined" : "composite";
    const auto filter = RefinedField(blocks, Line());
    filter->SetRefineMesh(refine);
    filter->RemoveUnusedPointsOn();
    filter->Update();
    auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    check.Equal(output->GetNumberOfBlocks(), 4, what + ": blocks");
    CheckUsedPoints(check, first, vtkPolyData::SafeDownCast(output->GetBlock(0)), what + ", 0");
    CheckUsedPoints(check, second, vtkPolyData::SafeDownCast(output->GetBlock(1)), what + ", 1");
    auto* empty = vtkPolyData::SafeDownCast(output->GetBlock(3));
    check.That(empty && empty->GetNumberOfPoints() == 0, what + ": a block without faces");
  }
}

/// Hides or bars the cells of the second square, from the half of the cells on.
void MarkSecondSquare(vtkPolyData* data, const char* name, int mark)
{
  AddArrayOf<vtkUnsignedCharArray>(data->GetCellData(), name, data->GetNumberOfCells(),
    [&](vtkIdType cell)
    { return static_cast<unsigned char>(cell < data->GetNumberOfCells() / 2 ? 0 : mark); });
}

/// Depth images and scans have points that are NaN; many of them, here.
vtkSmartPointer<vtkPolyData> WithUnusedPoints(double value, bool toSingle)
{
  auto data = TwoSquaresAndUnusedPoints();
  constexpr vtkIdType many = 20000;
  for (vtkIdType i = 0; i < many; ++i)
  {
    const double x = value + static_cast<double>(i + 1); // no two finite ones at one place
    data->GetPoints()->InsertNextPoint(x, i % 2 == 0 ? value : 0.25, i % 4 == 0 ? value : 0.0);
  }
  data->GetPoints()->SetPoint(0, value, value, value);
  data->GetPoints()->SetPoint(26, 0.0, value, 0.0);
  if (toSingle)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToFloat();
    points->DeepCopy(data->GetPoints());
    data->SetPoints(points);
  }
  return data;
}

/// Points that no face uses are not reached, wherever they are, and the others have the values that
/// they have beside finite ones.
void CheckUnusedPointsAreAnywhere(Check& check)
{
  const double inf = vtkMath::Inf();
  for (const double value : { vtkMath::Nan(), inf, -inf })
  {
    for (const int choice : { 0, 1, 2, 3, 4, 5, 6, 7 })
    {
      const bool toSingle = (choice & 1) != 0;
      const bool refine = (choice & 2) != 0;
      const bool merge = (choice & 4) != 0;
      const auto input = WithUnusedPoints(value, toSingle);
      const auto output = [&](vtkPolyData* surface)
      {
        vtkNew<vtkGeodesicDistanceField> filter;
        ChooseAll(filter);
        filter->SetInputData(surface);
        filter->SetRefineMesh(refine);
        filter->SetMergeCoincidentPoints(merge);
        Messages(filter).ExpectNothing(check, "unused points are not worth a word");
        vtkSmartPointer<vtkPolyData> result = filter->GetOutput();
        return result;
      };
      std::ostringstream what;
      what << "unused points at " << value << ", choice " << choice;
      const auto is = output(input);
      const auto was = output(WithUnusedPoints(9.0, toSingle));
      check.Equal(is->GetNumberOfPoints(), was->GetNumberOfPoints(), what.str() + ": points");
      vtkDataArray* distances = was->GetPointData()->GetArray("GeodesicDistance");
      for (int a = 0; a < was->GetPointData()->GetNumberOfArrays(); ++a)
      {
        vtkDataArray* before = was->GetPointData()->GetArray(a);
        const std::string name = before->GetName();
        vtkDataArray* after = is->GetPointData()->GetArray(name.c_str());
        bool areSame = true;
        for (vtkIdType i = 0; i < before->GetNumberOfValues(); ++i)
        {
          const int k = static_cast<int>(i % before->GetNumberOfComponents());
          const vtkIdType point = i / before->GetNumberOfComponents();
          double expected = before->GetComponent(point, k);
          if (name == "ClosestSourcePoint" && distances->GetTuple1(point) == Infinite)
          {
            expected = is->GetPoint(point)[k]; // nothing is closest
          }
          areSame = areSame && IsSame(expected, after->GetComponent(point, k));
        }
        check.That(areSame, what.str() + ": " + name);
      }
      bool areThere = true;
      for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
      {
        const Point p = PointAt(input, i);
        const Point q = PointAt(is, i);
        areThere = areThere && IsSame(p[0], q[0]) && IsSame(p[1], q[1]) && IsSame(p[2], q[2]);
      }
      check.That(areThere, what.str() + ": the points are where they were");
      check.Equal(PointValue(is, "GeodesicDistance", 26), Infinite, what.str() + ": not reached");
    }
  }
}

/// The second square has a NaN at its last corner: an error if paths can reach it, or a barrier
/// has it, but not if its cells are hidden.
void CheckPointsOfHiddenCells(Check& check)
{
  for (const int kind : { 0, 1, 2 })
  {
    const auto input = WithUnusedPoints(9.0, false);
    input->GetPoints()->SetPoint(51, 1.0, vtkMath::Nan(), 0.0);
    vtkNew<vtkGeodesicDistanceField> filter;
    ChooseAll(filter);
    filter->SetInputData(input);
    if (kind == 1)
    {
      MarkSecondSquare(input, "Barrier", 1);
      filter->SetBarrierArrayName("Barrier");
    }
    if (kind == 2)
    {
      MarkSecondSquare(
        input, vtkDataSetAttributes::GhostArrayName(), vtkDataSetAttributes::HIDDENCELL);
    }
    Messages messages(filter);
    messages.Update();
    const bool isError =
      Contains(messages.Error(), "surface") && Contains(messages.Error(), "at point 51. Remove");
    check.That(kind == 2 ? messages.Error().empty() : isError,
      "a NaN at an open, a barred and a hidden face: " + messages.Error());
  }
}

/// Barriers are faces, too; what ghost flags hide is not.
void CheckBarriersAndHiddenCells(Check& check)
{
  const auto input = WithNumbers(TwoSquaresAndUnusedPoints());
  vtkNew<vtkIntArray> barrier;
  barrier->SetName("Barrier");
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    const bool isSecond = cell >= input->GetNumberOfCells() / 2;
    barrier->InsertNextValue(isSecond ? 1 : 0);
    ghosts->InsertNextValue(0);
  }
  input->GetCellData()->AddArray(barrier);
  const auto filter = PlainField(input, Line());
  filter->SetBarrierArrayName("Barrier");
  filter->RemoveUnusedPointsOn();
  filter->Update();
  CheckUsedPoints(check, input, filter->GetOutput(), "barriers");

  for (vtkIdType cell = input->GetNumberOfCells() / 2; cell < input->GetNumberOfCells(); ++cell)
  {
    ghosts->SetValue(cell, vtkDataSetAttributes::HIDDENCELL);
  }
  input->GetCellData()->AddArray(ghosts);
  input->Modified();
  filter->SetBarrierArrayName(nullptr);
  filter->Update();
  check.Equal(
    filter->GetOutput()->GetNumberOfPoints(), 25.0, "points of hidden cells are not used");
}

}

int TestGeodesicUnreached(int, char*[])
{
  Check check;
  CheckDefaults(check);
  CheckFarthest(check);
  CheckUnreachedValues(check);
  CheckRemoval(check);
  CheckNothingToRemove(check);
  CheckComposite(check);
  CheckBarriersAndHiddenCells(check);
  CheckUnusedPointsAreAnywhere(check);
  CheckPointsOfHiddenCells(check);
  return check.Result();
}
