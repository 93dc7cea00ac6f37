// SPDX-License-Identifier: BSD-3-Clause
#include "Lines.h"

#include "Stripes.h"

#include "vtkAlgorithm.h"
#include "vtkCell.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPointSet.h"
#include "vtkSMBoundsDomain.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMSourceProxy.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace
{

/// What a filter's input is connected to: a proxy and its output port.
std::pair<vtkSMProxy*, unsigned int> producerOf(vtkSMProxy* filter, const char* input)
{
  vtkSMPropertyHelper helper(filter, input, true);
  vtkSMProxy* producer = helper.GetAsProxy();
  return { producer, producer ? helper.GetOutputPort() : 0 };
}

/// The output of a proxy that consists of points and cells, where it is in this process.
vtkPointSet* outputOf(vtkSMSourceProxy* producer, unsigned int port)
{
  auto* algorithm = vtkAlgorithm::SafeDownCast(producer->GetClientSideObject());
  return algorithm && static_cast<int>(port) < algorithm->GetNumberOfOutputPorts()
    ? vtkPointSet::SafeDownCast(algorithm->GetOutputDataObject(static_cast<int>(port)))
    : nullptr;
}

/// Also where there is nothing yet, which may become curves.
bool mayBeCurvesOrPoints(vtkPointSet* data)
{
  for (vtkIdType i = 0; data && i < data->GetNumberOfCells(); ++i)
  {
    if (data->GetCell(i)->GetCellDimension() > 1)
    {
      return false;
    }
  }
  return data != nullptr;
}

/// Whose maximum is the default distance; none of other filters than a contour.
vtkSMBoundsDomain* boundsOf(vtkSMSourceProxy* filter)
{
  vtkSMProperty* distances = filter->GetProperty("Distances");
  return distances ? distances->FindDomain<vtkSMBoundsDomain>() : nullptr;
}

/// A value of UnreachedValue.
constexpr int UnreachedIsCustom = 2;

/// VTK's shader of tubes and balls reads gl_FragDepth before it writes it. Where the driver leaves
/// any number there (Mesa 25), they are drawn behind the surface, or shine through it.
constexpr const char* DepthFromTheStart = R"([{ "type": "fragment",
  "original": "//VTK::UniformFlow::Impl",
  "replacement": "gl_FragDepth = gl_FragCoord.z;\n//VTK::UniformFlow::Impl\n" }])";

}

namespace lines
{

bool isGeodesicFilter(vtkSMSourceProxy* filter)
{
  const char* name = filter->GetVTKClassName();
  return name && std::string(name).rfind("vtkGeodesic", 0) == 0;
}

bool isField(vtkSMSourceProxy* filter)
{
  const char* name = filter->GetVTKClassName();
  return name && std::string(name).rfind("vtkGeodesicDistanceField", 0) == 0;
}

bool haveSame(const char* input, vtkSMProxy* a, vtkSMProxy* b)
{
  return producerOf(a, input) == producerOf(b, input);
}

bool areOutput(vtkSMSourceProxy* filter, unsigned int port)
{
  const std::string name = filter->GetVTKClassName() ? filter->GetVTKClassName() : "";
  return name == "vtkGeodesicContour" || name == "vtkGeodesicPaths" ||
    (port == 1 && isField(filter));
}

void show(vtkSMPVRepresentationProxy* representation)
{
  auto* filter =
    vtkSMSourceProxy::SafeDownCast(vtkSMPropertyHelper(representation, "Input").GetAsProxy());
  const bool isContour = filter && filter->GetProperty("Distances");
  const double green[3] = { 0.0, 0.7, 0.35 }, cyan[3] = { 0.0, 0.65, 0.85 };
  const double* color = isContour ? cyan : green;
  representation->SetScalarColoring(nullptr, vtkDataObject::POINT);
  for (const char* name : { "AmbientColor", "DiffuseColor" })
  {
    vtkSMPropertyHelper(representation, name, true).Set(color, 3);
  }
  vtkSMPropertyHelper(representation, "Ambient", true).Set(0.3);
  vtkSMPropertyHelper(representation, "LineWidth", true).Set(5.0);
  vtkSMPropertyHelper(representation, "PointSize", true).Set(12.0);
  vtkSMPropertyHelper(representation, "RenderLinesAsTubes", true).Set(1);
  vtkSMPropertyHelper(representation, "RenderPointsAsSpheres", true).Set(1);
  vtkSMPropertyHelper(representation, "ShaderReplacements", true).Set(DepthFromTheStart);
  vtkSMPropertyHelper(representation, "UseShaderReplacements", true).Set(1);
  if (vtkSMPropertyHelper(representation, "Input").GetOutputPort() == 1)
  {
    // Of one color and opaque, points as balls are drawn behind any surface (ParaView 5.11).
    vtkSMPropertyHelper(representation, "Opacity", true).Set(0.999);
  }
  representation->UpdateVTKObjects();
}

void roundDefaultDistance(vtkSMSourceProxy* filter)
{
  vtkSMPropertyHelper distances(filter, "Distances", true);
  vtkSMBoundsDomain* bounds = boundsOf(filter);
  if (bounds && distances.GetNumberOfElements() == 1 && distances.GetAsDouble() > 0.0 &&
    distances.GetAsDouble() == bounds->GetMaximum(0))
  {
    distances.Set(stripes::roundStep(distances.GetAsDouble(), 1));
    filter->UpdateVTKObjects();
  }
}

void chooseOnlySource(vtkSMSourceProxy* filter)
{
  vtkSMProperty* source = filter->GetProperty("Source");
  if (!source || source->GetIsInternal() || producerOf(filter, "Source").first)
  {
    return;
  }
  std::set<std::pair<vtkSMSourceProxy*, unsigned int>> found;
  vtkNew<vtkSMProxyIterator> proxies;
  proxies->SetSessionProxyManager(filter->GetSessionProxyManager());
  for (proxies->Begin("sources"); !proxies->IsAtEnd(); proxies->Next())
  {
    auto* other = vtkSMSourceProxy::SafeDownCast(proxies->GetProxy());
    for (unsigned int port = 0;
         other && !isGeodesicFilter(other) && port < other->GetNumberOfOutputPorts(); ++port)
    {
      if (producerOf(filter, "Input") != std::pair<vtkSMProxy*, unsigned int>(other, port) &&
        mayBeCurvesOrPoints(outputOf(other, port)))
      {
        found.emplace(other, port);
      }
    }
  }
  if (found.size() == 1 &&
    outputOf(found.begin()->first, found.begin()->second)->GetNumberOfPoints() > 0)
  {
    vtkSMPropertyHelper(source).Set(found.begin()->first, found.begin()->second);
    filter->UpdateVTKObjects();
  }
}

bool hasUnreached(vtkSMSourceProxy* filter)
{
  return vtkSMPropertyHelper(filter, "HasUnreachedPoints", true).GetAsInt() != 0 &&
    vtkSMPropertyHelper(filter, "UnreachedValue", true).GetAsInt() != UnreachedIsCustom;
}

void putDefaultCurveOnSurface(vtkSMSourceProxy* filter)
{
  vtkSMPropertyHelper points(filter, "Points", true);
  if (points.GetNumberOfElements() != 6)
  {
    return;
  }
  std::vector<double> curve = points.GetDoubleArray();
  auto* bounds = filter->GetProperty("Points")->FindDomain<vtkSMBoundsDomain>();
  const double low = bounds->GetMinimum(0), high = bounds->GetMaximum(0),
               top = bounds->GetMaximum(2);
  const std::pair<vtkSMProxy*, unsigned int> input = producerOf(filter, "Input");
  auto* producer = vtkSMSourceProxy::SafeDownCast(input.first);
  vtkPointSet* surface = producer ? outputOf(producer, input.second) : nullptr;
  const bool isDefault = curve[0] == low && curve[3] == high && curve[2] == top && curve[5] == top;
  if (!isDefault || !surface || surface->GetNumberOfPoints() == 0)
  {
    return;
  }
  for (std::size_t i = 0; i < curve.size(); i += 3)
  {
    surface->GetPoint(surface->FindPoint(&curve[i]), &curve[i]);
  }
  points.Set(curve.data(), static_cast<unsigned int>(curve.size()));
  filter->UpdateVTKObjects();
}

double largestDistance(vtkSMSourceProxy* filter)
{
  return vtkSMPropertyHelper(filter, "LargestDistance", true).GetAsDouble();
}

void setResults(vtkSMSourceProxy* filter)
{
  if (filter->GetProperty("NumberOfPaths"))
  {
    vtkPVDataInformation* paths = filter->GetDataInformation(0);
    vtkPVArrayInformation* lengths =
      paths->GetCellDataInformation()->GetArrayInformation("GeodesicDistance");
    const bool hasPaths = lengths && paths->GetNumberOfCells() > 0;
    const double none[2] = { 0.0, 0.0 };
    const double* range = hasPaths ? lengths->GetComponentRange(0) : none;
    const auto count = static_cast<int>(hasPaths ? paths->GetNumberOfCells() : 0);
    vtkSMPropertyHelper(filter, "NumberOfPaths").Set(count);
    vtkSMPropertyHelper(filter, "ShortestLength").Set(range[0]);
    vtkSMPropertyHelper(filter, "LongestLength").Set(range[1]);
  }
}

void setRangeOfDistances(vtkSMSourceProxy* contour, const std::vector<vtkSMSourceProxy*>& filters)
{
  double onSurface = 0.0, ofSource = 0.0;
  for (vtkSMSourceProxy* filter : filters)
  {
    if (filter && haveSame("Input", filter, contour))
    {
      const double largest = largestDistance(filter);
      onSurface = std::max(onSurface, largest);
      ofSource = haveSame("Source", filter, contour) ? std::max(ofSource, largest) : ofSource;
    }
  }
  vtkSMBoundsDomain* bounds = boundsOf(contour);
  const double side =
    bounds->GetMaximumExists(0) ? bounds->GetMaximum(0) / bounds->GetScaleFactor() : 1.0;
  const double largest = ofSource > 0.0 ? ofSource : onSurface > 0.0 ? onSurface : side;
  const double range[2] = { 0.0, largest };
  vtkSMPropertyHelper(contour, "DistanceRange").Set(range, 2);
}

}
