// SPDX-License-Identifier: BSD-3-Clause
#include "ProxyWatch.h"

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
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cstring>
#include <set>
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
    this->ColorNewResult(filter);
  }

private:
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
    const bool hadNoChoice = this->WasEmpty[port] && this->Chosen.count(shown) == 0;
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

/// Sees what proxies are registered.
class RegistrationWatch : public vtkCommand
{
public:
  static RegistrationWatch* New() { return new RegistrationWatch; }

  void Execute(vtkObject*, unsigned long, void* data) override
  {
    const auto* registered = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
    auto* filter = registered ? vtkSMSourceProxy::SafeDownCast(registered->Proxy) : nullptr;
    const char* name = filter ? filter->GetVTKClassName() : nullptr;
    const char* const ours = "vtkGeodesic";
    if (!name || std::strncmp(name, ours, std::strlen(ours)) != 0)
    {
      return;
    }
    // A filter that is given another name is registered again.
    auto& watched = this->Watched;
    watched.erase(std::remove(watched.begin(), watched.end(), nullptr), watched.end());
    if (std::find(watched.begin(), watched.end(), filter) == watched.end())
    {
      watched.emplace_back(filter);
      vtkNew<FilterWatch> watch;
      filter->AddObserver(vtkCommand::UpdateDataEvent, watch);
    }
  }

private:
  std::vector<vtkWeakPointer<vtkSMSourceProxy>> Watched;
};

}

void watchGeodesicProxies()
{
  const auto type = vtkProcessModule::GetProcessType();
  if (type == vtkProcessModule::PROCESS_CLIENT || type == vtkProcessModule::PROCESS_BATCH)
  {
    vtkNew<RegistrationWatch> watch;
    vtkSMProxyManager::GetProxyManager()->AddObserver(vtkCommand::RegisterEvent, watch);
  }
}
