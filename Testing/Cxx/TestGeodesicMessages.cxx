// SPDX-License-Identifier: BSD-3-Clause
// Of everything that goes wrong there is one message, in words that users of ParaView have before
// them, which scripts can ask for; the pipeline goes on.
#include "GeodesicTesting.h"

#include "vtkErrorCode.h"
#include "vtkGeodesicContour.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicPaths.h"
#include "vtkImageData.h"
#include "vtkLogger.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkUnstructuredGrid.h"

using namespace GeodesicTesting;

namespace
{

/// An output window that keeps what it is given.
class Window : public vtkOutputWindow
{
public:
  static Window* New();
  vtkTypeMacro(Window, vtkOutputWindow);
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override { this->Errors.emplace_back(text); }
  void DisplayWarningText(const char* text) override { this->Warnings.emplace_back(text); }

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
};
vtkStandardNewMacro(Window);

/// Keeps what is shown to the user as long as it lives; the log, which a test must leave without
/// errors, does not get it.
class Shown
{
public:
  Shown()
    : Before(vtkOutputWindow::GetInstance())
  {
    vtkOutputWindow::SetInstance(this->Now);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }
  ~Shown()
  {
    vtkOutputWindow::SetInstance(this->Before);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_INFO);
  }
  Shown(const Shown&) = delete;
  void operator=(const Shown&) = delete;
  const std::vector<std::string>& Errors() const { return this->Now->Errors; }
  const std::vector<std::string>& Warnings() const { return this->Now->Warnings; }

private:
  vtkSmartPointer<vtkOutputWindow> Before;
  vtkNew<Window> Now;
};

/// The four filters, with points as targets where they need some.
std::vector<vtkSmartPointer<vtkGeodesicAlgorithm>> AllFilters()
{
  vtkNew<vtkGeodesicContour> contour;
  contour->SetValue(0, 0.25);
  vtkNew<vtkGeodesicPaths> paths;
  paths->SetTargetsData(PointSources({ { 1, 1, 0 } }));
  vtkNew<vtkGeodesicDistanceMatrix> matrix;
  matrix->SetTargetsData(PointSources({ { 1, 1, 0 } }));
  return { vtkSmartPointer<vtkGeodesicDistanceField>::New().Get(), contour.Get(), paths.Get(),
    matrix.Get() };
}

/// Whether the words of C++ stand in a message.
bool HasCode(const std::string& text)
{
  for (const char* word : { "SetSource", "SetTargets", "SourceType", "SetInput", "()" })
  {
    if (Contains(text, word))
    {
      return true;
    }
  }
  return false;
}

/// Runs the filter twice: it fails, with one message each time at most, and one the first time. The
/// executive takes the empty outputs as it takes others.
void CheckOneError(Check& check, vtkGeodesicAlgorithm* filter,
  const std::vector<std::string>& words, const std::string& what)
{
  const std::string name = std::string(filter->GetClassName()) + ", " + what;
  Shown shown;
  const bool goesOn = filter->GetExecutive()->Update() == 1;
  const std::string first = shown.Errors().empty() ? "" : shown.Errors().front();
  check.Equal(shown.Errors().size(), 1.0, name + ": messages");
  check.That(goesOn, name + ": the pipeline goes on");
  check.That(filter->GetErrorCode() == vtkErrorCode::UserError, name + ": the code of an error");
  check.That(shown.Warnings().empty(), name + ": no warning beside the error");
  CheckWords(check, first, words, name);
  const std::string message = filter->GetErrorMessage();
  check.That(!message.empty() && Contains(first, "): " + message),
    name + ": scripts get the message: " + message);
  check.That(!HasCode(message), name + ": the message has no words of C++: " + message);
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    filter->Update(port);
  }
  check.Equal(shown.Errors().size(), 1.0, name + ": messages after all outputs were asked for");
}

void CheckWhatIsMissing(Check& check)
{
  for (const auto& filter : AllFilters())
  {
    filter->SetInputDataObject(0, Square(2));
    CheckOneError(
      check, filter, { "choose a Source", "Source Type", "Surface Boundary" }, "without a source");
  }
  const auto paths = FilterOn<vtkGeodesicPaths>(Square(2), PointSources({ { 0, 0, 0 } }));
  CheckOneError(check, paths, { "port 2", "Targets" }, "without targets");
}

/// On each of its ports.
void CheckOtherKindsOfData(Check& check)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  vtkNew<vtkUnstructuredGrid> grid; // which can be the surface, and its points targets
  grid->SetPoints(Square(2)->GetPoints());
  const vtkIdType triangle[] = { 0, 1, 4 };
  grid->InsertNextCell(VTK_QUADRATIC_EDGE, 3, triangle);
  const auto blocks = Blocks({ Square(2), image });
  for (const vtkSmartPointer<vtkDataObject>& data :
    std::vector<vtkSmartPointer<vtkDataObject>>{ image.Get(), grid.Get(), blocks.Get() })
  {
    const bool isGrid = data->IsA("vtkUnstructuredGrid");
    for (int port = isGrid ? 1 : 0; port < (isGrid ? 2 : 3); ++port)
    {
      for (const auto& filter : AllFilters())
      {
        filter->SetInputDataObject(0, Square(2));
        filter->SetSourceData(PointSources({ { 0, 0, 0 } }));
        if (port < filter->GetNumberOfInputPorts())
        {
          filter->SetInputDataObject(port, data);
          CheckOneError(check, filter, { "Extract Surface", "port " + std::to_string(port) },
            std::string(data->GetClassName()) + " on port " + std::to_string(port));
        }
      }
    }
  }
}

/// As a reader gives them where it has left all faces out.
void CheckSurfacesWithoutFaces(Check& check)
{
  for (const auto& filter : AllFilters())
  {
    filter->SetSourceData(PointSources({ { 0, 0, 0 } }));
    filter->SetInputDataObject(0, PointSources({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }));
    CheckOneError(check, filter, { "port 0", "3 points", "no faces", "PLY", "triangle strips" },
      "points without cells");
    filter->SetInputDataObject(0, Polyline({ { 0, 0, 0 }, { 1, 0, 0 } }));
    CheckOneError(check, filter, { "port 0", "no faces", "is it the source" }, "a line as surface");
    filter->SetInputDataObject(0, vtkSmartPointer<vtkPolyData>::New());
    CheckOneError(check, filter, { "port 0", "empty", "no faces" }, "an empty surface");
  }
}

/// Wrong properties, too; and what the executive itself has to say is still said.
void CheckOtherErrors(Check& check)
{
  const auto filter = RefinedField(Square(2), PointSources({ { 0, 0, 0 } }));
  filter->SetMaximumDistance(-1.0);
  CheckOneError(check, filter, { "MaximumDistance" }, "a wrong property");
  filter->SetInputData(nullptr);
  Shown shown;
  filter->Update();
  check.That(shown.Errors().size() == 1 && Contains(shown.Errors().front(), "Input port 0"),
    "after an error a missing surface is still told by the executive");
}

void CheckItWorksAfterwards(Check& check)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputData(Square(2));
  {
    Shown shown;
    filter->Update();
  }
  filter->SetSourceData(PointSources({ { 0, 0, 0 } }));
  Shown shown;
  check.That(filter->GetExecutive()->Update() == 1, "the next execution succeeds");
  check.That(shown.Errors().empty(), "and says nothing");
  check.That(filter->GetErrorCode() == vtkErrorCode::NoError && filter->GetErrorMessage().empty(),
    "nor do scripts get an error");
  CheckDistances(check, filter, DistanceTo({ { 0, 0, 0 } }), "after an error");
}

}

int TestGeodesicMessages(int, char*[])
{
  Check check;
  CheckWhatIsMissing(check);
  CheckOtherKindsOfData(check);
  CheckSurfacesWithoutFaces(check);
  CheckOtherErrors(check);
  CheckItWorksAfterwards(check);
  return check.Result();
}
