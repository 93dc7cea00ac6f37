// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkQueries.h"

#include "BenchmarkMeter.h"

#include "vtkContourFilter.h"
#include "vtkGeodesicContour.h"
#include "vtkGeodesicDistanceField.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicPaths.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <random>
#include <stdexcept>

namespace
{

void setSource(vtkGeodesicAlgorithm* filter, const QuerySubject& subject)
{
  filter->SetInputData(subject.surface);
  if (subject.source)
  {
    filter->SetSourceData(subject.source);
  }
  else
  {
    filter->SetSourceTypeToSurfaceBoundary();
  }
}

/// \param last what is updated; by default the filter itself.
QueryRun measured(vtkGeodesicAlgorithm* filter, vtkAlgorithm* last = nullptr)
{
  last = last ? last : filter;
  last->Update();
  filter->Modified();
  forgetPeakMemory();
  QueryRun run;
  run.loadedBytes = memory("VmRSS");
  Stopwatch watch;
  last->Update();
  run.seconds = watch.lap();
  run.peakBytes = memory("VmHWM");
  if (auto* output = vtkPolyData::SafeDownCast(last->GetOutputDataObject(0)))
  {
    run.outputPoints = output->GetNumberOfPoints();
    run.outputCells = output->GetNumberOfCells();
  }
  return run;
}

QueryRun requireOutput(QueryRun run, const char* name)
{
  if (run.outputCells == 0)
  {
    throw std::runtime_error(std::string(name) + " has given no output");
  }
  return run;
}

/// Faces whose corners are within a distance, with that of the farthest corner.
std::vector<std::pair<double, vtkIdType>> facesWithin(const QuerySubject& subject, double distance)
{
  std::vector<std::pair<double, vtkIdType>> faces;
  vtkNew<vtkIdList> ids;
  for (vtkIdType face = 0; face < subject.surface->GetNumberOfCells(); ++face)
  {
    subject.surface->GetCellPoints(face, ids);
    double farthest = 0.0;
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      farthest = std::max(farthest, subject.distances[static_cast<std::size_t>(ids->GetId(k))]);
    }
    if (farthest <= distance)
    {
      faces.emplace_back(farthest, face);
    }
  }
  return faces;
}

/// The distances of the isolines that are measured.
double valueOf(const QuerySubject& subject, int i, int count)
{
  return subject.largestDistance * (i + 1) / (count + 1);
}

}

vtkSmartPointer<vtkPolyData> randomPoints(
  const QuerySubject& subject, double distance, int count, unsigned int seed)
{
  const auto faces = facesWithin(subject, distance);
  if (faces.empty())
  {
    throw std::runtime_error("--reach: no face is so near to the source");
  }
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> fraction(0.0, 1.0);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdList> ids;
  for (int i = 0; i < count; ++i)
  {
    const vtkIdType face = i == 0 ? std::max_element(faces.begin(), faces.end())->second
                                  : faces[static_cast<std::size_t>(random()) % faces.size()].second;
    subject.surface->GetCellPoints(face, ids);
    std::array<double, 3> weights{ fraction(random), fraction(random), fraction(random) };
    const double sum = weights[0] + weights[1] + weights[2];
    std::array<double, 3> p{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double* corner = subject.surface->GetPoint(ids->GetId(static_cast<vtkIdType>(k)));
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        p[axis] += (sum > 0.0 ? weights[k] / sum : 1.0 / 3.0) * corner[axis];
      }
    }
    points->InsertNextPoint(p.data());
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  return result;
}

QueryRun runField(const QuerySubject& subject, bool arrays)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  setSource(filter, subject);
  filter->RefineMeshOff();
  filter->SetGenerateSourceIds(arrays);
  filter->SetGenerateClosestPoints(arrays);
  filter->SetGenerateGradients(arrays);
  filter->SetGenerateSignedDistance(arrays);
  return requireOutput(measured(filter), "vtkGeodesicDistanceField");
}

QueryRun runPaths(const QuerySubject& subject, vtkPolyData* targets)
{
  vtkNew<vtkGeodesicPaths> filter;
  setSource(filter, subject);
  filter->SetTargetsData(targets);
  return requireOutput(measured(filter), "vtkGeodesicPaths");
}

QueryRun runContour(const QuerySubject& subject, int values, double chordTolerance)
{
  vtkNew<vtkGeodesicContour> filter;
  setSource(filter, subject);
  if (chordTolerance > 0.0)
  {
    filter->SetChordTolerance(chordTolerance);
  }
  for (int i = 0; i < values; ++i)
  {
    filter->SetValue(i, valueOf(subject, i, values));
  }
  return requireOutput(measured(filter), "vtkGeodesicContour");
}

QueryRun runRefinedContour(const QuerySubject& subject, int values, double refine)
{
  vtkNew<vtkGeodesicDistanceField> field;
  setSource(field, subject);
  field->SetRefinementTolerance(refine);
  vtkNew<vtkContourFilter> contour;
  contour->SetInputConnection(field->GetOutputPort());
  contour->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, field->GetDistanceArrayName());
  for (int i = 0; i < values; ++i)
  {
    contour->SetValue(i, valueOf(subject, i, values));
  }
  return requireOutput(measured(field, contour), "vtkContourFilter");
}

QueryRun runMatrix(vtkPolyData* surface, vtkPolyData* sources, vtkPolyData* targets)
{
  vtkNew<vtkGeodesicDistanceMatrix> filter;
  filter->SetInputData(surface);
  filter->SetSourceData(sources);
  filter->SetTargetsData(targets);
  QueryRun run = measured(filter);
  run.outputCells = filter->GetOutput()->GetNumberOfRows();
  return requireOutput(run, "vtkGeodesicDistanceMatrix");
}
