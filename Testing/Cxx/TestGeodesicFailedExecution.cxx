// SPDX-License-Identifier: BSD-3-Clause
// After an error the pipeline goes on: filters downstream execute with nothing, and with data again
// after the next execution, which gives what a filter that has never failed gives.
#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkContourFilter.h"
#include "vtkErrorCode.h"
#include "vtkGeodesicContour.h"
#include "vtkGeodesicDistanceFieldFromDrawnCurve.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicPaths.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkPolyDataNormals.h"
#include "vtkTable.h"

#include <stdexcept>

using namespace GeodesicTesting;

namespace
{

/// Passes on any kind of data and counts its executions.
class Downstream : public vtkPassInputTypeAlgorithm
{
public:
  static Downstream* New();
  vtkTypeMacro(Downstream, vtkPassInputTypeAlgorithm);
  int Executions = 0;

protected:
  int FillInputPortInformation(int, vtkInformation* info) override
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override
  {
    ++this->Executions;
    vtkDataObject::GetData(outputVector, 0)->ShallowCopy(vtkDataObject::GetData(inputVector[0]));
    return 1;
  }
};
vtkStandardNewMacro(Downstream);

struct Kind
{
  std::string Name;
  std::function<vtkSmartPointer<vtkGeodesicAlgorithm>()> Make;
  /// Moves the source to a point; without one there is no source.
  std::function<void(vtkGeodesicAlgorithm*, const std::vector<Point>&)> SetSource;
};

void SetPoints(vtkGeodesicAlgorithm* filter, const std::vector<Point>& points)
{
  filter->SetSourceData(PointSources(points));
}

void DrawPoints(vtkGeodesicAlgorithm* filter, const std::vector<Point>& points)
{
  auto* drawn = static_cast<vtkGeodesicDistanceFieldFromDrawnCurve*>(filter);
  drawn->SetNumberOfCurvePoints(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    drawn->SetCurvePoint(static_cast<vtkIdType>(i), points[i][0], points[i][1], points[i][2]);
  }
}

template <typename Filter>
vtkSmartPointer<vtkGeodesicAlgorithm> Make()
{
  return vtkSmartPointer<Filter>::New().Get();
}

template <typename Filter>
vtkSmartPointer<vtkGeodesicAlgorithm> MakeWithTargets()
{
  const auto filter = vtkSmartPointer<Filter>::New();
  filter->SetTargetsData(PointSources({ { 1, 1, 0 }, { 0.3, 0.8, 0 } }));
  return filter.Get();
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeContour()
{
  const auto contour = vtkSmartPointer<vtkGeodesicContour>::New();
  contour->SetValue(0, 0.25);
  return contour.Get();
}

std::vector<Kind> Kinds()
{
  return { { "field", Make<vtkGeodesicDistanceField>, SetPoints },
    { "drawn curve", Make<vtkGeodesicDistanceFieldFromDrawnCurve>, DrawPoints },
    { "contour", MakeContour, SetPoints },
    { "paths", MakeWithTargets<vtkGeodesicPaths>, SetPoints },
    { "matrix", MakeWithTargets<vtkGeodesicDistanceMatrix>, SetPoints } };
}

vtkSmartPointer<vtkDataObject> TwoBlocks()
{
  return Blocks({ Square(4), nullptr, Moved(Square(4), MovedBy(1.0)) }).Get();
}

/// All coordinates and numbers of a data set, of all blocks.
std::vector<double> AllNumbersOf(vtkDataObject* data)
{
  std::vector<double> numbers;
  const auto add = [&numbers](const std::vector<double>& more)
  { numbers.insert(numbers.end(), more.begin(), more.end()); };
  const auto addAll = [&add](vtkFieldData* arrays)
  {
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      add(NumbersOf(arrays->GetArray(i)));
    }
  };
  addAll(data->GetFieldData());
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
    {
      add(blocks->GetBlock(i) ? AllNumbersOf(blocks->GetBlock(i)) : std::vector<double>());
    }
  }
  else if (auto* table = vtkTable::SafeDownCast(data))
  {
    addAll(table->GetRowData());
  }
  else if (auto* set = vtkPolyData::SafeDownCast(data))
  {
    add(NumbersOf(set->GetPoints() ? set->GetPoints()->GetData() : nullptr));
    addAll(set->GetPointData());
    addAll(set->GetCellData());
    numbers.push_back(static_cast<double>(set->GetNumberOfCells()));
  }
  return numbers;
}

/// Of a composite output the blocks are there.
bool IsEmpty(vtkDataObject* data)
{
  const std::vector<double> numbers = AllNumbersOf(data); // each block's number of cells
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data);
  const bool hasBlocks = !blocks ||
    (blocks->GetNumberOfBlocks() == 3 && vtkPolyData::SafeDownCast(blocks->GetBlock(0)) &&
      !blocks->GetBlock(1) && vtkPolyData::SafeDownCast(blocks->GetBlock(2)));
  return hasBlocks &&
    numbers ==
    std::vector<double>(blocks     ? 2
        : data->IsA("vtkPolyData") ? 1
                                   : 0,
      0.0);
}

void CheckGoesOn(Check& check, const Kind& kind, vtkDataObject* surface, const std::string& on)
{
  const std::string name = kind.Name + on;
  const std::vector<Point> good{ { 0.25, 0.5, 0 } };
  const auto filter = kind.Make();
  filter->SetInputDataObject(0, surface);
  Messages messages(filter);
  int executions = 0;
  Listener listener(filter, vtkCommand::StartEvent, [&] { ++executions; });
  vtkNew<Downstream> end;
  end->SetInputConnection(filter->GetOutputPort());
  int times = 0;
  const auto update = [&](bool isGood, const std::string& when)
  {
    ++times;
    for (int again = 0; again < 2; ++again)
    {
      check.That(end->GetExecutive()->Update() == 1, name + ": Update() " + when);
      check.Equal(executions, times, name + ": executions " + when);
      check.Equal(end->Executions, times, name + ": executions downstream " + when);
    }
    check.That(messages.ExecutiveError().empty(),
      name + ": the executive has nothing to say " + when + ": " + messages.ExecutiveError());
    check.That(messages.Error() == filter->GetErrorMessage() + (isGood ? "" : "\n\n"),
      name + ": message " + when + ": '" + filter->GetErrorMessage() + "' and '" +
        messages.Error() + "'");
    check.That(Contains(filter->GetErrorMessage(), isGood ? "" : "Source Type") &&
        filter->GetErrorMessage().empty() == isGood,
      name + ": GetErrorMessage() " + when);
    check.Equal(filter->GetErrorCode(), isGood ? vtkErrorCode::NoError : vtkErrorCode::UserError,
      name + ": error code " + when);
    for (int port = 0; port < filter->GetNumberOfOutputPorts() && !isGood; ++port)
    {
      check.That(IsEmpty(filter->GetOutputDataObject(port)),
        name + ": port " + std::to_string(port) + " is empty " + when);
    }
    check.That(IsEmpty(end->GetOutputDataObject(0)) != isGood, name + ": downstream " + when);
    messages.Clear();
  };
  kind.SetSource(filter, {});
  update(false, "at first");
  kind.SetSource(filter, { { 0, 0, 0 } });
  update(true, "after a failure");
  kind.SetSource(filter, {});
  update(false, "after a success");
  filter->Modified();
  update(false, "after a failure, again");
  kind.SetSource(filter, good);
  update(true, "at last");

  const auto fresh = kind.Make();
  fresh->SetInputDataObject(0, surface);
  kind.SetSource(fresh, good);
  fresh->Update();
  check.That(
    AllNumbersOf(end->GetOutputDataObject(0)) == AllNumbersOf(fresh->GetOutputDataObject(0)),
    name + ": downstream has what a fresh filter gives");
}

/// Of VTK's own filters.
void CheckFiltersOfVtk(Check& check)
{
  vtkNew<vtkGeodesicDistanceField> field;
  field->SetInputData(NoisySquare(8));
  Messages messages(field);
  vtkNew<vtkContourFilter> lines;
  lines->SetInputConnection(field->GetOutputPort());
  lines->SetValue(0, 0.3);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(field->GetOutputPort());
  const auto counts = [&]
  {
    lines->Update();
    normals->Update();
    return std::vector<vtkIdType>{ lines->GetOutput()->GetNumberOfPoints(),
      normals->GetOutput()->GetNumberOfPoints() };
  };
  field->SetSourceData(PointSources({ { 0, 0, 0 } }));
  const std::vector<vtkIdType> before = counts();
  check.That(before[0] > 0 && before[1] > 0, "VTK's filters have data");
  field->SetSourceData(PointSources({}));
  check.That(counts() == std::vector<vtkIdType>{ 0, 0 }, "VTK's filters have nothing");
  field->SetSourceData(PointSources({ { 0, 0, 0 } }));
  check.That(counts() == before, "VTK's filters have data again");
}

/// Numbers of an execution that came far before it failed, or was stopped, are not left.
void CheckGetters(Check& check)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetSourceData(PointSources({ { 0, 0, 0.125 } }));
  Messages messages(filter);
  const auto expectNone = [&](const std::string& after)
  {
    check.That(filter->GetWindowsPropagatedPerEdge() == 0.0 &&
        filter->GetSourceSnapDistance() == 0.0 && filter->GetSourceLength() == 0.0 &&
        filter->GetRelativeErrorBound() == 0.0 &&
        std::isinf(filter->GetInterpolationErrorBound()) && filter->GetSeamPointsJoined() == 0 &&
        filter->GetLargestDistance() == 0.0 && filter->GetFarthestPoint()[0] == 0.0 &&
        !filter->GetHasUnreachedPoints(),
      "results are as before the first execution " + after);
  };
  filter->SetInputData(Square(4));
  messages.Update();
  check.That(filter->GetWindowsPropagatedPerEdge() > 0.0 && filter->GetSourceSnapDistance() > 0.0 &&
      !std::isinf(filter->GetInterpolationErrorBound()),
    "results of an execution");

  const auto runUntil = [&](double fraction, const std::function<void()>& stop)
  {
    Listener listener(filter, vtkCommand::ProgressEvent,
      [&]
      {
        if (filter->GetProgress() > fraction)
        {
          stop();
        }
      });
    filter->Modified();
    messages.Update();
    filter->RemoveObservers(vtkCommand::ProgressEvent);
  };
  constexpr double writing = 0.9;
  bool hasThrown = false;
  runUntil(writing,
    [&hasThrown]
    {
      if (!std::exchange(hasThrown, true))
      {
        throw std::runtime_error("too late");
      }
    });
  check.That(Contains(filter->GetErrorMessage(), "too late") &&
      filter->GetErrorCode() == vtkErrorCode::UserError,
    "an error that comes late: " + filter->GetErrorMessage());
  CheckOutputsEmpty(check, filter, "an error that comes late");
  expectNone("after an error");

  messages.Update();
  runUntil(writing, [&filter] { filter->SetAbortExecute(1); });
  check.That(filter->GetErrorMessage().empty() && messages.Error().empty() &&
      filter->GetErrorCode() == vtkErrorCode::NoError,
    "an abort is no error");
  CheckOutputsEmpty(check, filter, "an abort");
  expectNone("after an abort");
}

/// Observers of the error have it at hand, and where errors are switched off scripts have it.
void CheckWhoIsTold(Check& check)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(Square(2));
  std::string told;
  Listener listener(filter, vtkCommand::ErrorEvent, [&] { told = filter->GetErrorMessage(); });
  filter->Update();
  check.That(Contains(told, "no source") && told == filter->GetErrorMessage(),
    "the message is there with the event: " + told);

  told.clear();
  filter->SetSourceData(PointSources({}));
  vtkObject::GlobalWarningDisplayOff();
  filter->Update();
  vtkObject::GlobalWarningDisplayOn();
  check.That(told.empty() && Contains(filter->GetErrorMessage(), "is empty") &&
      filter->GetErrorCode() == vtkErrorCode::UserError,
    "the message is there without the event: " + filter->GetErrorMessage());
}

}

int TestGeodesicFailedExecution(int, char*[])
{
  Check check;
  for (const Kind& kind : Kinds())
  {
    CheckGoesOn(check, kind, Square(4), "");
    CheckGoesOn(check, kind, TwoBlocks(), " on blocks");
  }
  CheckFiltersOfVtk(check);
  CheckGetters(check);
  CheckWhoIsTold(check);
  return check.Result();
}
