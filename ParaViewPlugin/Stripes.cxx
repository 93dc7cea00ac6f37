// SPDX-License-Identifier: BSD-3-Clause
#include "Stripes.h"

#include "PolyData/RoundNumbers.h"

#include "vtkAbstractArray.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkPVProminentValuesInformation.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMTransferFunctionPresets.h"
#include "vtkSMTransferFunctionProxy.h"
#include "vtkSmartPointer.h"
#include "vtkVariant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using Color = std::array<double, 3>;

const Color Near{ 0.98, 0.84, 0.42 }, Middle{ 0.87, 0.36, 0.38 }, Far{ 0.22, 0.26, 0.58 };
const Color White{ 0.97, 0.96, 0.94 }, Red{ 0.86, 0.36, 0.30 }, Blue{ 0.25, 0.42, 0.70 };
const Color Black{ 0.0, 0.0, 0.0 };
/// The id of points that are not reached.
constexpr int NoSource = -1;

/// Of points that are not reached.
const Color Gray{ 0.75, 0.75, 0.75 };

/// Of ids, one after the other: none is the green of curves. Points that are not reached are gray.
const std::vector<Color> IdColors{ { 0.90, 0.62, 0.00 }, { 0.34, 0.71, 0.91 }, { 0.80, 0.47, 0.65 },
  { 0.94, 0.89, 0.26 }, { 0.00, 0.45, 0.70 }, { 0.84, 0.37, 0.00 }, { 0.55, 0.40, 0.30 },
  { 0.80, 0.75, 0.90 } };

/// More would be too thin to count; of round widths the next one gives at least 17.
constexpr int MostStripes = 40;
constexpr int MostTicks = 9;
constexpr int PresetStripes = 32;
/// How much of its color the palest stripe of a signed distance has.
constexpr double PaleAtSource = 0.35;
/// A multiple of a width that rounding has made larger is no stripe more.
constexpr double Slack = 1e-6;

Color mix(const Color& a, const Color& b, double t)
{
  return { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]) };
}

std::vector<Color> fromNearToFar(int count)
{
  std::vector<Color> colors;
  for (int i = 0; i < count; ++i)
  {
    const double along = 2.0 * i / (count - 1);
    const Color shade = along < 1.0 ? mix(Near, Middle, along) : mix(Middle, Far, along - 1.0);
    colors.push_back(mix(shade, Black, i % 2 == 0 ? 0.0 : 0.28));
  }
  return colors;
}

std::vector<Color> onBothSides(int count)
{
  const int half = count / 2;
  std::vector<Color> colors;
  for (int i = 0; i < count; ++i)
  {
    const int fromSource = i < half ? half - 1 - i : i - half;
    // Beside the source, where one looks first, both colors are seen already.
    const double depth = PaleAtSource + (1.0 - PaleAtSource) * (fromSource + 1.0) / half;
    const Color shade = mix(White, i < half ? Blue : Red, depth);
    colors.push_back(mix(shade, Black, fromSource % 2 == 0 ? 0.0 : 0.15));
  }
  return colors;
}

struct Stripes
{
  double low = 0.0;
  double width = 0.0;
  int count = 0;
  bool isSigned = false;
};

/// The nodes of a color map, position and color. In a map of steps each node has the color before
/// it.
std::vector<double> nodesOf(const Stripes& stripes)
{
  const std::vector<Color> colors =
    stripes.isSigned ? onBothSides(stripes.count) : fromNearToFar(stripes.count);
  std::vector<double> nodes;
  for (int i = 0; i <= stripes.count; ++i)
  {
    const Color& color = colors[static_cast<std::size_t>(std::max(i - 1, 0))];
    nodes.push_back(stripes.low + i * stripes.width);
    nodes.insert(nodes.end(), color.begin(), color.end());
  }
  return nodes;
}

bool haveColors(const std::vector<double>& nodes, const Stripes& stripes)
{
  const std::vector<double> expected = nodesOf(stripes);
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    if (i % 4 != 0 && std::abs(nodes[i] - expected[i]) > Slack)
    {
      return false;
    }
  }
  return true;
}

/// No stripes where the color map has other colors.
Stripes read(vtkSMProxy* table)
{
  const std::vector<double> nodes = vtkSMPropertyHelper(table, "RGBPoints").GetDoubleArray();
  const int count = static_cast<int>(nodes.size() / 4) - 1;
  const bool hasSteps =
    std::strcmp(vtkSMPropertyHelper(table, "ColorSpace").GetAsString(), "Step") == 0;
  if (!hasSteps || count < 2)
  {
    return {};
  }
  const double low = nodes.front(), high = nodes[nodes.size() - 4];
  Stripes stripes{ low, (high - low) / count, count, false };
  for (const bool isSigned : { false, true })
  {
    stripes.isSigned = isSigned;
    if (haveColors(nodes, stripes))
    {
      return stripes;
    }
  }
  return {};
}

Stripes roundStripes(double low, double high, bool isSigned)
{
  const double largest = isSigned ? std::max(-low, high) : high;
  if (!(largest > 0.0) || !std::isfinite(largest))
  {
    return {};
  }
  const double width = stripes::roundStep(largest, isSigned ? MostStripes / 2 : MostStripes);
  const int count = std::max(static_cast<int>(std::ceil(largest / width - Slack)), 1);
  return { isSigned ? -count * width : 0.0, width, isSigned ? 2 * count : count, isSigned };
}

void write(vtkSMProxy* table, const Stripes& stripes)
{
  const std::vector<double> nodes = nodesOf(stripes);
  vtkSMPropertyHelper(table, "ColorSpace").Set("Step");
  vtkSMPropertyHelper(table, "RGBPoints")
    .Set(nodes.data(), static_cast<unsigned int>(nodes.size()));
  // As many samples in every stripe.
  vtkSMPropertyHelper(table, "NumberOfTableValues").Set(1024 / stripes.count * stripes.count);
  vtkSMPropertyHelper(table, "Discretize").Set(1);
  vtkSMPropertyHelper(table, "AboveRangeColor").Set(Gray.data(), 3);
  vtkSMPropertyHelper(table, "NanColor").Set(Gray.data(), 3);
  table->UpdateVTKObjects();
  if (vtkSMProxy* opacity = vtkSMPropertyHelper(table, "ScalarOpacityFunction", true).GetAsProxy())
  {
    vtkSMTransferFunctionProxy::RescaleTransferFunction(
      opacity, stripes.low, stripes.low + stripes.count * stripes.width);
  }
}

std::vector<vtkSMProxy*> barsOf(vtkSMProxy* table)
{
  std::vector<vtkSMProxy*> bars;
  for (unsigned int i = 0; i < table->GetNumberOfConsumers(); ++i)
  {
    vtkSMProxy* consumer = table->GetConsumerProxy(i);
    if (consumer && consumer->GetProperty("UseCustomLabels"))
    {
      bars.push_back(consumer);
    }
  }
  return bars;
}

/// The ids that occur in what a color map shows. Of more than ParaView can tell apart, 32, none.
std::set<int> idsShownBy(vtkSMProxy* table)
{
  std::set<vtkSMPVRepresentationProxy*> all; // parts of a representation are consumers, too
  for (unsigned int i = 0; i < table->GetNumberOfConsumers(); ++i)
  {
    auto* shown =
      vtkSMPVRepresentationProxy::SafeDownCast(table->GetConsumerProxy(i)->GetTrueParentProxy());
    if (shown && shown->GetUsingScalarColoring())
    {
      all.insert(shown);
    }
  }
  std::set<int> ids;
  for (vtkSMPVRepresentationProxy* shown : all)
  {
    vtkSMPropertyHelper input(shown, "Input"), array(shown, "ColorArrayName");
    vtkNew<vtkPVProminentValuesInformation> found;
    found->SetPortNumber(static_cast<int>(input.GetOutputPort()));
    found->SetFieldAssociation(
      vtkDataObject::GetAssociationTypeAsString(array.GetInputArrayAssociation()));
    found->SetFieldName(array.GetInputArrayNameToProcess());
    found->SetNumberOfComponents(1);
    found->SetFraction(0.0); // an id that few points have counts, too
    input.GetAsProxy()->GatherInformation(found);
    const auto values = vtk::TakeSmartPointer(found->GetProminentComponentValues(0));
    if (!values)
    {
      return {};
    }
    for (vtkIdType k = 0; k < values->GetNumberOfTuples(); ++k)
    {
      ids.insert(values->GetVariantValue(k).ToInt());
    }
  }
  return ids;
}

void addPreset(const char* name, bool isSigned)
{
  auto* presets = vtkSMTransferFunctionPresets::GetInstance();
  if (presets->HasPreset(name))
  {
    return;
  }
  const double low = isSigned ? -1.0 : 0.0;
  std::ostringstream text;
  text << "{\"ColorSpace\": \"Step\", \"NumberOfTableValues\": 1024, \"NanColor\": [0.75, 0.75, "
          "0.75], "
          "\"UseAboveRangeColor\": 1, \"AboveRangeColor\": [0.75, 0.75, 0.75], \"RGBPoints\": [";
  const char* comma = "";
  for (const double value : nodesOf({ low, (1.0 - low) / PresetStripes, PresetStripes, isSigned }))
  {
    text << comma << value;
    comma = ", ";
  }
  text << "]}";
  presets->AddPreset(name, text.str());
}

}

namespace stripes
{

double roundStep(double length, int atMost)
{
  if (!(length > 0.0) || !std::isfinite(length))
  {
    return length;
  }
  const std::array<double, 4> steps = geodesic::roundNumbersAround(length / atMost);
  return *std::find_if(
    steps.begin(), steps.end() - 1, [&](double step) { return length <= (atMost + Slack) * step; });
}

void addPresets()
{
  addPreset("Geodesic Distance Stripes", false);
  addPreset("Signed Geodesic Distance Stripes", true);
}

bool areIn(vtkSMProxy* table)
{
  return read(table).count > 0;
}

void fill(vtkSMProxy* table, bool isSigned)
{
  double range[2] = { 0.0, 1.0 };
  vtkSMTransferFunctionProxy::GetRange(table, range);
  const Stripes wanted = roundStripes(range[0], range[1], isSigned);
  write(table, wanted.count > 0 ? wanted : roundStripes(0.0, 1.0, isSigned));
}

void setUnreached(vtkSMProxy* table, bool isUnreached)
{
  vtkSMPropertyHelper gray(table, "UseAboveRangeColor");
  if (areIn(table) && (gray.GetAsInt() != 0) != isUnreached)
  {
    gray.Set(isUnreached ? 1 : 0);
    table->UpdateVTKObjects();
  }
}

void makeRound(vtkSMProxy* table)
{
  const Stripes now = read(table);
  const Stripes wanted = roundStripes(now.low, now.low + now.count * now.width, now.isSigned);
  const double rounding = Slack * wanted.width;
  if (wanted.count > 0 &&
    (wanted.count != now.count || std::abs(wanted.low - now.low) > rounding ||
      std::abs(wanted.width - now.width) > rounding))
  {
    write(table, wanted);
  }
}

void setTicks(vtkSMProxy* bar, vtkSMProxy* table)
{
  // ParaView has no word for the box of infinite values: the one of NaN, which is gray, too, has
  // it.
  const int hasGray = vtkSMPropertyHelper(table, "UseAboveRangeColor").GetAsInt();
  vtkSMPropertyHelper(bar, "DrawNanAnnotation").Set(hasGray);
  vtkSMPropertyHelper(bar, "NanAnnotation").Set("not reached");
  bar->UpdateVTKObjects();
  const Stripes shown = read(table);
  const double length = shown.count * shown.width;
  double step = roundStep(length, MostTicks);
  const auto isMultiple = [&shown](double ticks)
  { return std::abs(ticks / shown.width - std::round(ticks / shown.width)) <= Slack; };
  if (!isMultiple(step))
  {
    step = roundStep(step * (1.0 + 2.0 * Slack), 1);
  }
  if (!isMultiple(step)) // a width that is not round, as of the preset with a range of the user's
  {
    return;
  }
  std::vector<double> ticks;
  const int first = static_cast<int>(std::ceil(shown.low / step - Slack));
  const int last = static_cast<int>(std::floor((shown.low + length) / step + Slack));
  for (int i = first; i <= last; ++i)
  {
    ticks.push_back(i * step);
  }
  vtkSMPropertyHelper(bar, "CustomLabels")
    .Set(ticks.data(), static_cast<unsigned int>(ticks.size()));
  vtkSMPropertyHelper(bar, "UseCustomLabels").Set(1);
  vtkSMPropertyHelper(bar, "AddRangeLabels").Set(0);
  bar->UpdateVTKObjects();
}

void setTicks(vtkSMProxy* table)
{
  for (vtkSMProxy* bar : barsOf(table))
  {
    setTicks(bar, table);
  }
}

void showIds(vtkSMProxy* table, bool isUnreached)
{
  const bool isNew = vtkSMPropertyHelper(table, "AnnotationsInitialized", true).GetAsInt() == 0;
  if (!isNew && vtkSMPropertyHelper(table, "IndexedLookup").GetAsInt() == 0)
  {
    return;
  }
  std::vector<std::string> words;
  std::vector<double> colors;
  std::size_t next = 0;
  std::set<int> ids = idsShownBy(table);
  if (!isUnreached)
  {
    ids.erase(NoSource); // points that no face uses have it, too
  }
  for (const int id : ids)
  {
    words.push_back(std::to_string(id));
    words.push_back(id < 0 ? "not reached" : words.back());
    const Color& color = id < 0 ? Gray : IdColors[next++ % IdColors.size()];
    colors.insert(colors.end(), color.begin(), color.end());
  }
  vtkSMPropertyHelper annotations(table, "Annotations");
  const auto count = static_cast<unsigned int>(words.size());
  bool areSame = annotations.GetNumberOfElements() == count;
  for (unsigned int i = 0; areSame && i < count; ++i)
  {
    areSame = words[i] == annotations.GetAsString(i);
  }
  if (areSame || words.empty())
  {
    return;
  }
  annotations.SetNumberOfElements(count);
  for (unsigned int i = 0; i < count; ++i)
  {
    annotations.Set(i, words[i].c_str());
  }
  vtkSMPropertyHelper(table, "IndexedColors")
    .Set(colors.data(), static_cast<unsigned int>(colors.size()));
  vtkSMPropertyHelper(table, "IndexedLookup").Set(1);
  vtkSMPropertyHelper(table, "AnnotationsInitialized", true).Set(1);
  table->UpdateVTKObjects();
}

void resetTicks(vtkSMProxy* table)
{
  for (vtkSMProxy* bar : barsOf(table))
  {
    vtkSMPropertyHelper(bar, "UseCustomLabels").Set(0);
    vtkSMPropertyHelper(bar, "AddRangeLabels").Set(1);
    bar->UpdateVTKObjects();
  }
}

}
