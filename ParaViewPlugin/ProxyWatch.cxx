// SPDX-License-Identifier: BSD-3-Clause
#include "ProxyWatch.h"

#include "Displays.h"
#include "Lines.h"
#include "Stripes.h"

#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPVGeneralSettings.h"
#include "vtkProcessModule.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSettings.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMTransferFunctionProxy.h"
#include "vtkSMViewProxy.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cstring>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{

/// Whether views show a scalar bar when something is colored by an array.
bool areScalarBarsShown(vtkSMProxy* proxy)
{
  vtkSMProxy* settings = proxy->GetSessionProxyManager()->GetProxy("settings", "GeneralSettings");
  return settings &&
    vtkSMPropertyHelper(settings, "ScalarBarMode", true).GetAsInt() ==
    vtkPVGeneralSettings::AUTOMATICALLY_SHOW_AND_HIDE_SCALAR_BARS;
}

/// Whether this is ParaView's window; else a script does what it says, and no more.
bool hasPanel()
{
  return vtkSMProxyManager::GetProxyManager()->GetUndoStackBuilder() != nullptr;
}

void colorBy(vtkSMPVRepresentationProxy* representation, const char* array)
{
  representation->SetScalarColoring(array, vtkDataObject::POINT);
  if (!areScalarBarsShown(representation))
  {
    return;
  }
  for (unsigned int i = 0; i < representation->GetNumberOfConsumers(); ++i)
  {
    vtkSMProxy* view = representation->GetConsumerProxy(i);
    if (view && view->IsA("vtkSMViewProxy"))
    {
      representation->SetScalarBarVisibility(view, true);
    }
  }
}

/// The distance with the side of the source as its sign has a name that users cannot change.
const std::string SignedArray = "SignedGeodesicDistance";
const std::string SourceIds = "SourceId";

/// The panel's Color By Stripes; other filters than the field have none.
bool showsStripes(vtkSMProxy* filter)
{
  return vtkSMPropertyHelper(filter, "ColorByStripes", true).GetAsInt() != 0;
}

class RegistrationWatch;

/// Looks after one filter.
class FilterWatch : public vtkCommand
{
public:
  static FilterWatch* New() { return new FilterWatch; }

  /// At each execution.
  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    auto* filter = vtkSMSourceProxy::SafeDownCast(caller);
    filter->UpdatePropertyInformation();
    lines::setResults(filter);
    this->ColorNewResult(filter);
    this->SetRangesOfContours();
    if (this->HasStripes != showsStripes(filter))
    {
      this->HasStripes = !this->HasStripes;
      this->SwitchStripes(filter);
    }
    this->FitTables(filter);
  }

  const RegistrationWatch* Filters = nullptr;
  /// As the panel asks for them when the filter is made.
  bool HasStripes = false;

private:
  /// The color maps of the filter's results cover them at every time step.
  void FitTables(vtkSMSourceProxy* filter) const;

  void SetRangesOfContours() const;

  /// Puts stripes into the color maps that show the filter's distances, or ParaView's own colors.
  void SwitchStripes(vtkSMSourceProxy* filter) const;

  static bool IsEmpty(vtkSMSourceProxy* filter, unsigned int port)
  {
    vtkPVDataInformation* data = filter->GetDataInformation(port);
    return data->GetNumberOfPoints() == 0 && data->GetNumberOfRows() == 0;
  }

  void ColorNewResult(vtkSMSourceProxy* filter);

  /// Of each output port, whether the execution before has left it empty.
  std::vector<bool> WasEmpty;
  /// The representations for which there was something to choose from: what they show is what
  /// ParaView or the user has chosen. Only to be compared.
  std::set<vtkSMProxy*> Chosen;
};

void FilterWatch::ColorNewResult(vtkSMSourceProxy* filter)
{
  this->WasEmpty.resize(filter->GetNumberOfOutputPorts(), false);
  std::set<vtkSMProxy*> chosen;
  for (unsigned int i = 0; i < filter->GetNumberOfConsumers(); ++i)
  {
    auto* shown = vtkSMPVRepresentationProxy::SafeDownCast(filter->GetConsumerProxy(i));
    const unsigned int port = shown ? vtkSMPropertyHelper(shown, "Input", true).GetOutputPort() : 0;
    if (!shown || port >= this->WasEmpty.size())
    {
      continue;
    }
    const bool hadNoChoice =
      !lines::areOutput(filter, port) && this->WasEmpty[port] && this->Chosen.count(shown) == 0;
    if (hadNoChoice && IsEmpty(filter, port))
    {
      continue;
    }
    vtkPVArrayInformation* scalars =
      filter->GetDataInformation(port)->GetPointDataInformation()->GetAttributeInformation(
        vtkDataSetAttributes::SCALARS);
    if (hadNoChoice && scalars && !shown->GetUsingScalarColoring())
    {
      colorBy(shown, scalars->GetName());
    }
    chosen.insert(shown);
  }
  this->Chosen = chosen;
  for (unsigned int port = 0; port < this->WasEmpty.size(); ++port)
  {
    this->WasEmpty[port] = IsEmpty(filter, port);
  }
}

/// The color maps that show a filter's arrays, with the names of the arrays.
std::set<std::pair<vtkSMProxy*, std::string>> tablesOf(vtkSMSourceProxy* filter)
{
  std::set<std::pair<vtkSMProxy*, std::string>> tables;
  for (unsigned int i = 0; i < filter->GetNumberOfConsumers(); ++i)
  {
    auto* shown = vtkSMPVRepresentationProxy::SafeDownCast(filter->GetConsumerProxy(i));
    vtkSMProxy* table =
      shown ? vtkSMPropertyHelper(shown, "LookupTable", true).GetAsProxy() : nullptr;
    if (table)
    {
      tables.emplace(
        table, vtkSMPropertyHelper(shown, "ColorArrayName").GetInputArrayNameToProcess());
    }
  }
  return tables;
}

void FilterWatch::SwitchStripes(vtkSMSourceProxy* filter) const
{
  const std::string distance = vtkSMPropertyHelper(filter, "DistanceArrayName").GetAsString();
  for (const auto& [table, array] : tablesOf(filter))
  {
    if (array != distance && array != SignedArray)
    {
      continue;
    }
    if (this->HasStripes)
    {
      stripes::fill(table, array == SignedArray);
    }
    else if (stripes::areIn(table))
    {
      vtkSMTransferFunctionProxy::ResetPropertiesToDefaults(table, array.c_str(), true);
    }
  }
}

/// Keeps the stripes of a color map round when ParaView rescales it, and the ticks of its scalar
/// bars where stripes meet.
class TableWatch : public vtkCommand
{
public:
  static TableWatch* New() { return new TableWatch; }

  void Execute(vtkObject* caller, unsigned long, void*) override;

  const RegistrationWatch* Filters = nullptr;
  std::string Array;

private:
  bool HadStripes = false;
};

/// Looks after what is shown: a color map that it begins to use may be an old one.
class DisplayWatch : public vtkCommand
{
public:
  static DisplayWatch* New() { return new DisplayWatch; }

  /// When a property of the representation is set.
  void Execute(vtkObject* caller, unsigned long, void* property) override;

  const RegistrationWatch* Filters = nullptr;
};

/// Sees what proxies are registered.
class RegistrationWatch : public vtkCommand
{
public:
  static RegistrationWatch* New() { return new RegistrationWatch; }

  void Execute(vtkObject*, unsigned long, void* data) override
  {
    this->AddPresets();
    const auto* registered = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
    if (!registered || !registered->Proxy)
    {
      return;
    }
    const std::string group = registered->GroupName;
    if (group == "lookup_tables")
    {
      this->WatchTable(registered->Proxy, registered->ProxyName);
    }
    else if (group == "scalar_bars")
    {
      vtkSMProxy* table = vtkSMPropertyHelper(registered->Proxy, "LookupTable", true).GetAsProxy();
      if (table && stripes::areIn(table))
      {
        stripes::setTicks(registered->Proxy, table);
      }
    }
    else if (auto* shown = vtkSMPVRepresentationProxy::SafeDownCast(registered->Proxy))
    {
      vtkSMPropertyHelper input(shown, "Input", true);
      auto* filter = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
      if (!filter || shown->GetSessionProxyManager()->GetInLoadXMLState())
      {
        return;
      }
      if (lines::areOutput(filter, input.GetOutputPort()))
      {
        lines::show(shown);
      }
      vtkNew<DisplayWatch> watch;
      watch->Filters = this;
      shown->AddObserver(vtkCommand::PropertyModifiedEvent, watch);
      if (hasPanel())
      {
        this->LookAfter(filter, shown, input.GetOutputPort());
      }
    }
    else if (auto* filter = vtkSMSourceProxy::SafeDownCast(registered->Proxy))
    {
      if (group == "sources") // and no prototype for menus
      {
        this->WatchFilter(filter);
      }
    }
  }

  bool HasFilters() const { return !this->Filters.empty(); }

  /// Once: a user may take them away.
  void AddPresets()
  {
    if (!this->HasPresets)
    {
      this->HasPresets = true;
      stripes::addPresets();
    }
  }

  /// The series of values of a contour ends at the largest distance that any filter knows.
  void SetRangesOfContours() const
  {
    for (vtkSMSourceProxy* filter : this->Filters)
    {
      if (filter && filter->GetProperty("DistanceRange"))
      {
        lines::setRangeOfDistances(filter, { this->Filters.begin(), this->Filters.end() });
      }
    }
  }

  /// Whether a filter has not reached points to which its distance is asked for by this name.
  bool HasUnreached(const std::string& array) const
  {
    return std::any_of(this->Filters.begin(), this->Filters.end(),
      [&array](vtkSMSourceProxy* filter)
      {
        const char* name =
          filter ? vtkSMPropertyHelper(filter, "DistanceArrayName", true).GetAsString() : nullptr;
        return name && (array == name || array == SignedArray) && lines::hasUnreached(filter);
      });
  }

  /// Whether a filter has not reached points, whatever their distance is.
  bool HaveUnreached() const
  {
    return std::any_of(this->Filters.begin(), this->Filters.end(),
      [](vtkSMSourceProxy* filter) {
        return filter && vtkSMPropertyHelper(filter, "HasUnreachedPoints", true).GetAsInt() != 0;
      });
  }

  /// Whether an array has the ids of sources, which its color map then shows.
  bool ShowIds(vtkSMProxy* table, const std::string& array) const
  {
    const bool areIds = array == SourceIds && this->HasFilters();
    if (areIds)
    {
      stripes::showIds(table, this->HaveUnreached());
    }
    return areIds;
  }

  /// A color map shows the ids that occur, and gray if something is not reached.
  void Fit(vtkSMProxy* table, const std::string& array) const
  {
    if (!this->ShowIds(table, array) && stripes::areIn(table) && this->HasStripes(array))
    {
      stripes::setUnreached(table, this->HasUnreached(array));
    }
  }

  /// Whether an array is a distance of filters of this plugin, none of which has its stripes off.
  bool HasStripes(const std::string& array) const
  {
    bool isDistance = false;
    for (vtkSMSourceProxy* filter : this->Filters)
    {
      const char* name =
        filter ? vtkSMPropertyHelper(filter, "DistanceArrayName", true).GetAsString() : nullptr;
      if (!filter || (array != SignedArray && array != (name ? name : "GeodesicDistance")))
      {
        continue;
      }
      if (filter->GetProperty("ColorByStripes") && !showsStripes(filter))
      {
        return false;
      }
      isDistance = true;
    }
    return isDistance;
  }

private:
  void WatchFilter(vtkSMSourceProxy* filter)
  {
    if (!lines::isGeodesicFilter(filter))
    {
      return;
    }
    // A filter that is given another name is registered again.
    auto& filters = this->Filters;
    filters.erase(std::remove(filters.begin(), filters.end(), nullptr), filters.end());
    if (std::find(filters.begin(), filters.end(), filter) == filters.end())
    {
      filters.emplace_back(filter);
      vtkNew<FilterWatch> watch;
      watch->Filters = this;
      watch->HasStripes = showsStripes(filter);
      filter->AddObserver(vtkCommand::UpdateDataEvent, watch);
      lines::roundDefaultDistance(filter);
      if (hasPanel() && !filter->GetSessionProxyManager()->GetInLoadXMLState())
      {
        lines::chooseOnlySource(filter);
        lines::putDefaultCurveOnSurface(filter);
      }
      this->SetRangesOfContours();
    }
  }

  /// A representation of a filter's output in ParaView's window.
  void LookAfter(vtkSMSourceProxy* filter, vtkSMPVRepresentationProxy* shown, unsigned int port)
  {
    if (lines::isField(filter) && port == 0)
    {
      displays::makeRoomForTexture(filter, shown);
    }
    if (lines::isField(filter) && port == 1)
    {
      this->HideOtherFields(filter);
    }
    if (filter->GetProperty("NumberOfPaths") || (port == 1 && filter->GetProperty("Points")))
    {
      displays::labelLength(filter, shown);
    }
  }

  /// Where a field is shown, older ones of the same surface would shine through it, and their
  /// sources would look like its own. ParaView shows one output after the other: at the second one
  /// the view is no longer empty without them, or ParaView would reset its camera.
  void HideOtherFields(vtkSMSourceProxy* filter)
  {
    vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
    for (unsigned int i = 0; i < filter->GetNumberOfConsumers(); ++i)
    {
      vtkSMProxy* shown = filter->GetConsumerProxy(i);
      const bool isSeen = shown->IsA("vtkSMRepresentationProxy") &&
        vtkSMPropertyHelper(shown, "Visibility", true).GetAsInt() != 0;
      vtkSMViewProxy* view = isSeen ? vtkSMViewProxy::FindView(shown) : nullptr;
      for (vtkSMSourceProxy* other : this->Filters)
      {
        if (view && other && other != filter && lines::isField(other) &&
          lines::haveSame("Input", other, filter))
        {
          for (unsigned int port = 0; port < other->GetNumberOfOutputPorts(); ++port)
          {
            controller->Hide(other, static_cast<int>(port), view);
          }
        }
      }
    }
  }

  /// A color map that is made new gets stripes, unless the user has saved a default for its array.
  void WatchTable(vtkSMProxy* table, const std::string& name)
  {
    vtkNew<TableWatch> watch;
    watch->Filters = this;
    watch->Array = name.substr(0, name.find('.'));
    const bool isSaved = vtkSMSettings::GetInstance()->HasSetting(
      (".array_lookup_tables." + watch->Array + ".PVLookupTable.RGBPoints").c_str());
    if (this->HasStripes(watch->Array) && !isSaved &&
      !table->GetSessionProxyManager()->GetInLoadXMLState())
    {
      stripes::fill(table, watch->Array == SignedArray);
      stripes::setUnreached(table, this->HasUnreached(watch->Array));
    }
    table->AddObserver(vtkCommand::UpdateEvent, watch);
  }

  std::vector<vtkWeakPointer<vtkSMSourceProxy>> Filters;
  bool HasPresets = false;
};

void FilterWatch::SetRangesOfContours() const
{
  this->Filters->SetRangesOfContours();
}

void FilterWatch::FitTables(vtkSMSourceProxy* filter) const
{
  for (const auto& [table, array] : tablesOf(filter))
  {
    this->Filters->Fit(table, array);
    if (stripes::areIn(table) && this->Filters->HasStripes(array))
    {
      const int mode = vtkSMPropertyHelper(table, "AutomaticRescaleRangeMode").GetAsInt();
      if (mode == vtkSMTransferFunctionManager::GROW_ON_APPLY)
      {
        vtkSMTransferFunctionProxy::RescaleTransferFunctionToDataRange(table, /*extend=*/true);
      }
    }
  }
}

void DisplayWatch::Execute(vtkObject* caller, unsigned long, void* property)
{
  auto* shown = static_cast<vtkSMPVRepresentationProxy*>(caller);
  vtkSMProxy* table = property && std::strcmp(static_cast<char*>(property), "LookupTable") == 0
    ? vtkSMPropertyHelper(shown, "LookupTable").GetAsProxy()
    : nullptr;
  const char* array =
    table ? vtkSMPropertyHelper(shown, "ColorArrayName").GetInputArrayNameToProcess() : nullptr;
  if (array)
  {
    this->Filters->Fit(table, array);
  }
}

void TableWatch::Execute(vtkObject* caller, unsigned long, void*)
{
  auto* table = static_cast<vtkSMProxy*>(caller);
  this->Filters->ShowIds(table, this->Array);
  const bool hasStripes = stripes::areIn(table) && this->Filters->HasStripes(this->Array);
  if (hasStripes)
  {
    stripes::makeRound(table);
    stripes::setTicks(table);
  }
  else if (this->HadStripes)
  {
    stripes::resetTicks(table);
  }
  this->HadStripes = hasStripes;
}

}

void watchGeodesicProxies()
{
  const auto type = vtkProcessModule::GetProcessType();
  if (type == vtkProcessModule::PROCESS_CLIENT || type == vtkProcessModule::PROCESS_BATCH)
  {
    vtkNew<RegistrationWatch> watch;
    vtkSMProxyManager* proxies = vtkSMProxyManager::GetProxyManager();
    proxies->AddObserver(vtkCommand::RegisterEvent, watch);
    if (proxies->GetActiveSession()) // else settings may not have been read yet
    {
      watch->AddPresets();
    }
  }
}
