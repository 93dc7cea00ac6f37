// SPDX-License-Identifier: BSD-3-Clause
// Whatever piece is asked for, distances are those on the whole surface, and each of its cells is
// in one piece. With several processes the filter refuses, unless it is told to work alone.
#include "GeodesicTesting.h"

#include "vtkDummyCommunicator.h"
#include "vtkDummyController.h"
#include "vtkInformation.h"
#include "vtkPointSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

using namespace GeodesicTesting;

namespace
{

const double Radius = 0.5;

/// A sphere that can be had in pieces, and a point source at its pole.
struct Pipeline
{
  Pipeline()
  {
    this->Sphere->SetThetaResolution(40);
    this->Sphere->SetPhiResolution(40);
    this->Sphere->SetLatLongTessellation(true); // of quads, which the filter tells of
    this->Sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    this->Source->SetNumberOfPoints(1);
    this->Source->SetRadius(0.0);
    this->Source->SetCenter(0.0, 0.0, Radius);
    this->Source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    this->Filter->SetInputConnection(this->Sphere->GetOutputPort());
    this->Filter->SetSourceConnection(this->Source->GetOutputPort());
    this->Filter->RefineMeshOff();
  }

  vtkNew<vtkSphereSource> Sphere;
  vtkNew<vtkPointSource> Source;
  vtkNew<vtkGeodesicDistanceField> Filter;
};

/// A convex surface in a sphere: no path on it is shorter than the chord, and the shortest is not
/// longer than the arc on the sphere, since putting each point of the arc to the surface's closest
/// point makes no piece of it longer.
void CheckDistancesOfSphere(Check& check, vtkPolyData* output, const std::string& what)
{
  vtkDataArray* distances = output->GetPointData()->GetArray("GeodesicDistance");
  check.That(distances && distances->GetNumberOfTuples() == output->GetNumberOfPoints() &&
      output->GetNumberOfPoints() > 1000,
    what + ": a distance at every point");
  for (vtkIdType i = 0; distances && i < output->GetNumberOfPoints(); ++i)
  {
    const double* p = output->GetPoint(i);
    const double chord = std::hypot(p[0], p[1], p[2] - Radius);
    const double arc = Radius * 2.0 * std::asin(std::min(1.0, chord / (2.0 * Radius)));
    const double distance = distances->GetTuple1(i);
    check.That(distance >= chord * (1.0 - 1e-12) && distance <= arc * (1.0 + 1e-7),
      what + ": the distance is between the chord " + std::to_string(chord) + " and the arc " +
        std::to_string(arc) + ": " + std::to_string(distance));
  }
}

void CheckPiecesAreOfTheWhole(Check& check)
{
  Pipeline p;
  Messages messages(p.Filter);
  p.Filter->UpdatePiece(1, 2, 0);
  check.Equal(p.Filter->GetOutput()->GetNumberOfCells(), 0.0, "cells of the second piece");
  check.Equal(
    p.Filter->GetOutput(1)->GetNumberOfCells(), 0.0, "cells of the second piece of the source");
  p.Filter->UpdatePiece(0, 2, 0);
  CheckDistancesOfSphere(check, p.Filter->GetOutput(), "the first of two pieces");
  using Streaming = vtkStreamingDemandDrivenPipeline;
  for (vtkAlgorithm* upstream : std::initializer_list<vtkAlgorithm*>{ p.Sphere, p.Source })
  {
    vtkInformation* info = upstream->GetOutputInformation(0);
    check.Equal(info->Get(Streaming::UPDATE_PIECE_NUMBER()), 0, "the piece asked for upstream");
    check.Equal(info->Get(Streaming::UPDATE_NUMBER_OF_PIECES()), 1, "of so many pieces");
    check.Equal(info->Get(Streaming::UPDATE_NUMBER_OF_GHOST_LEVELS()), 0, "ghost levels");
  }
}

void CheckPiecesOfTheSecondOutput(Check& check)
{
  Pipeline p;
  Messages messages(p.Filter);
  p.Filter->UpdatePiece(0, 3, 0);
  p.Filter->Update(1);
  check.Equal(
    p.Filter->GetOutput(1)->GetNumberOfPoints(), 1.0, "points of the source on the surface");
}

void CheckPiecesWrittenAndReadBack(Check& check, int mode, const std::string& name, bool refine)
{
  Pipeline p;
  p.Filter->SetRefineMesh(refine);
  BuildWatch builds(p.Filter);
  int read = 0;
  Listener upstream(p.Sphere, vtkCommand::StartEvent, [&] { ++read; });
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(p.Filter->GetOutputPort());
  writer->SetNumberOfPieces(3);
  writer->SetDataMode(mode);
  writer->WriteToOutputStringOn();
  writer->Write();
  check.Equal(builds.Count(), 1, name + ": times that the surface was read");
  check.Equal(read, 1, name + ": times that upstream was executed");

  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(writer->GetOutputString());
  reader->Update();
  Pipeline whole;
  whole.Filter->SetRefineMesh(refine);
  Messages quiet(whole.Filter);
  quiet.Update();
  check.Equal(reader->GetOutput()->GetNumberOfCells(),
    whole.Filter->GetOutput()->GetNumberOfCells(), name + ": cells");
  check.Equal(reader->GetOutput()->GetNumberOfPoints(),
    whole.Filter->GetOutput()->GetNumberOfPoints(), name + ": points");
  CheckDistancesOfSphere(check, reader->GetOutput(), name);
}

/// Speaks for two processes, of which there is one.
class TwoProcesses : public vtkDummyCommunicator
{
public:
  static TwoProcesses* New() { VTK_STANDARD_NEW_BODY(TwoProcesses); }
  vtkTypeMacro(TwoProcesses, vtkDummyCommunicator);

protected:
  TwoProcesses()
  {
    this->MaximumNumberOfProcesses = 2;
    this->NumberOfProcesses = 2;
  }
};

void CheckProcesses(Check& check)
{
  vtkNew<TwoProcesses> communicator;
  vtkNew<vtkDummyController> two;
  two->SetCommunicator(communicator);
  const auto filter = RefinedField(Square(4), PointSources({ { 0, 0, 0 } }));
  const auto run = [&](const std::string& what)
  {
    filter->Update();
    CheckDistances(check, filter, DistanceTo({ { 0, 0, 0 } }), what);
  };
  check.That(
    filter->GetController() == vtkMultiProcessController::GetGlobalController(), "the default");
  run("without a controller");
  filter->SetController(two);
  check.That(filter->GetController() == two.Get(), "the controller that was set");
  filter->SetController(nullptr);
  run("this process alone");

  vtkMultiProcessController* before = vtkMultiProcessController::GetGlobalController();
  vtkMultiProcessController::SetGlobalController(two);
  filter->Modified();
  run("this process alone under a global controller of two");
  vtkNew<vtkGeodesicDistanceField> other;
  check.That(other->GetController() == two.Get(), "by default the global controller");
  vtkMultiProcessController::SetGlobalController(before);
}

}

int TestGeodesicPieces(int, char*[])
{
  Check check;
  CheckPiecesAreOfTheWhole(check);
  CheckPiecesOfTheSecondOutput(check);
  CheckPiecesWrittenAndReadBack(check, vtkXMLWriter::Binary, "binary", false);
  CheckPiecesWrittenAndReadBack(check, vtkXMLWriter::Binary, "refined", true);
  // Refined, since VTK reads no infinite numbers from text.
  CheckPiecesWrittenAndReadBack(check, vtkXMLWriter::Ascii, "refined, as text", true);
  CheckProcesses(check);
  return check.Result();
}
