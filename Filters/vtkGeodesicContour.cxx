// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicContour.h"

#include "PolyData/FilterExecution.h"
#include "PolyData/Inputs.h"
#include "PolyData/writing/LineWriter.h"
#include "PolyData/writing/SourceArrays.h"
#include "contours/IsolineSides.h"
#include "contours/Isolines.h"
#include "contours/SolveForIsolines.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <vector>

using namespace geodesic;

vtkStandardNewMacro(vtkGeodesicContour);

namespace
{

/// The values that lines are drawn at.
struct LineValues
{
  /// In the user's scale: ascending, each once, without 0.
  std::vector<double> values;
  bool hasZero = false;
  /// The distances of all values, ascending, each once; and which values each stands for.
  std::vector<double> distances;
  std::vector<SidedValue> sides;
};

/// Values that are equal in the engine, which drops digits of tiny numbers, count as one.
///
/// \param values in the user's scale.
LineValues FindValues(std::vector<double> values, const PowerOfTwoScale& scale)
{
  LineValues found;
  std::sort(values.begin(), values.end());
  std::map<double, SidedValue> byDistance;
  for (const double value : values)
  {
    const double inEngine = scale.toEngine(value);
    found.hasZero = found.hasZero || inEngine == 0.0;
    if (inEngine == 0.0 || !(std::abs(inEngine) < Infinity))
    {
      continue;
    }
    SidedValue& sides = byDistance[std::abs(inEngine)];
    std::size_t& index = inEngine < 0.0 ? sides.right : sides.left;
    if (index == SidedValue::None)
    {
      index = found.values.size();
      found.values.push_back(value);
    }
  }
  for (const auto& [distance, sides] : byDistance)
  {
    found.distances.push_back(distance);
    found.sides.push_back(sides);
  }
  return found;
}

/// Cuts lines where the side of the source's curves changes, and keeps the parts on the wanted
/// sides.
Isolines OnSides(const DistanceField& field, const Isolines& isolines,
  const std::vector<SidedValue>& sides, const Inputs& inputs, const Job& job)
{
  NearestSource nearest(field, *inputs.patch, inputs.sources.curves, job.part(0.0, 0.5));
  return linesOnSides(
    field, nearest, [&](const Foot& foot) { return isOnRight(foot, inputs.sources); }, isolines,
    sides, job.part(0.5, 1.0));
}

/// Solves up to the largest distance, and draws the lines.
///
/// \param chordTolerance in the engine's units.
/// \param areSigned whether a line belongs to one side of the source's curves.
Isolines Draw(const Inputs& inputs, const LineValues& wanted, double chordTolerance, bool areSigned,
  FilterExecution& execution)
{
  FrontOptions front;
  front.keepArrivals = areSigned;
  front.job = execution.begin(Stage::Solve);
  const DistanceField field = solveForIsolines(
    inputs.surface->partition, inputs.sourceWindows(front.job), wanted.distances, front);
  IsolineOptions options;
  options.values = wanted.distances;
  options.chordTolerance = chordTolerance;
  options.job = execution.begin(Stage::DrawLines);
  Isolines isolines = drawIsolines(field, options);
  if (areSigned)
  {
    isolines = OnSides(field, isolines, wanted.sides, inputs, execution.begin(Stage::FindSides));
  }
  return isolines;
}

}

//------------------------------------------------------------------------------
vtkMTimeType vtkGeodesicContour::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->ContourValues->GetMTime());
}

//------------------------------------------------------------------------------
std::string vtkGeodesicContour::FindWrongProperty() const
{
  const vtkIdType count = this->ContourValues->GetNumberOfContours();
  if (count < 1)
  {
    return "There is no value to draw lines at: set at least one distance (SetValue, "
           "GenerateValues; Distances in ParaView).";
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double value = this->ContourValues->GetValue(static_cast<int>(i));
    const bool isFinite = std::abs(value) < Infinity;
    if (!isFinite || (value < 0.0 && !this->SignedDistances))
    {
      std::ostringstream text;
      text << "Value " << i << " is " << value << ": set distances that are finite numbers"
           << (isFinite ? " of at least 0, or switch SignedDistances on." : ".");
      return text.str();
    }
  }
  if (!this->ToleranceIsAbsolute && !isPositive(this->ChordTolerance))
  {
    return "ChordTolerance is not a positive number: set the largest distance of a chord from its "
           "arc, as a fraction of the surface's bounding box diagonal, such as 0.0001.";
  }
  if (this->ToleranceIsAbsolute && !isPositive(this->AbsoluteChordTolerance))
  {
    return "AbsoluteChordTolerance is not a positive number: set the largest distance of a chord "
           "from its arc, in the units of the surface.";
  }
  return this->Superclass::FindWrongProperty();
}

//------------------------------------------------------------------------------
ExecutionPlan vtkGeodesicContour::Plan() const
{
  ExecutionPlan plan;
  plan.stages = { Stage::Solve, Stage::DrawLines, Stage::Write };
  if (this->SignedDistances)
  {
    plan.stages.insert(plan.stages.end() - 1, Stage::FindSides);
    plan.needsSides = true;
  }
  return plan;
}

//------------------------------------------------------------------------------
void vtkGeodesicContour::Compute(
  const Inputs& inputs, FilterExecution& execution, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  if (!inputs.rank.isWorking())
  {
    const TriangleMesh& none = inputs.surface->mesh();
    writeIsolines({ none, {}, {}, none, {} }, {}, output, {});
    return;
  }
  const PolyDataSurface& surface = *inputs.surface;
  if (this->SignedDistances)
  {
    requireSides(surface, "SignedDistances");
  }
  const double* values = this->ContourValues->GetValues();
  const LineValues wanted =
    FindValues({ values, values + this->ContourValues->GetNumberOfContours() }, surface.scale);
  const double chordTolerance = inputs.toleranceOf(
    this->ToleranceIsAbsolute, this->AbsoluteChordTolerance, this->ChordTolerance);
  Isolines isolines;
  // On a surface without extent nothing but the source is at any distance.
  if (!wanted.distances.empty() && chordTolerance > 0.0)
  {
    isolines = Draw(inputs, wanted, chordTolerance, this->SignedDistances, execution);
  }
  execution.notes().add(NoteOn::Surface, inputs.sumOverPieces(isolines.linesWithoutDirection),
    "line crosses", "lines cross",
    "faces of opposite orientation: the direction of such a line says nothing.");
  const bool hasCurves = wanted.hasZero && inputs.rank.writesSource();
  writeIsolines({ surface.mesh(), isolines, wanted.values, inputs.patch->mesh(),
                  hasCurves ? inputs.sources.curves : std::vector<SourceCurve>() },
    surface.scale, output, execution.begin(Stage::Write));
}

//------------------------------------------------------------------------------
void vtkGeodesicContour::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ContourValues:\n";
  this->ContourValues->PrintSelf(os, indent.GetNextIndent());
  os << indent << "ChordTolerance: " << this->ChordTolerance << "\n";
  os << indent << "ToleranceIsAbsolute: " << (this->ToleranceIsAbsolute ? "On" : "Off") << "\n";
  os << indent << "AbsoluteChordTolerance: " << this->AbsoluteChordTolerance << "\n";
  os << indent << "SignedDistances: " << (this->SignedDistances ? "On" : "Off") << "\n";
}
