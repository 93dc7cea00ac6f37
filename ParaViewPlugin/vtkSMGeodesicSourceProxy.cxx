// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMGeodesicSourceProxy.h"

#include "vtkClientServerInterpreter.h"
#include "vtkClientServerInterpreterInitializer.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPVGeneralSettings.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"

vtkStandardNewMacro(vtkSMGeodesicSourceProxy);

namespace
{

/// Whether a view shows a scalar bar when something is colored by an array.
bool AreScalarBarsShown(vtkSMProxy* proxy)
{
  vtkSMProxy* settings = proxy->GetSessionProxyManager()->GetProxy("settings", "GeneralSettings");
  return settings &&
    vtkSMPropertyHelper(settings, "ScalarBarMode", true).GetAsInt() ==
    vtkPVGeneralSettings::AUTOMATICALLY_SHOW_AND_HIDE_SCALAR_BARS;
}

void ColorBy(vtkSMPVRepresentationProxy* representation, const char* array)
{
  representation->SetScalarColoring(array, vtkDataObject::POINT);
  if (!AreScalarBarsShown(representation))
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

vtkObjectBase* NewGeodesicSourceProxy(void*)
{
  return vtkSMGeodesicSourceProxy::New();
}

void AddToInterpreter(vtkClientServerInterpreter* interpreter)
{
  interpreter->AddNewInstanceFunction("vtkSMGeodesicSourceProxy", NewGeodesicSourceProxy);
}

}

void registerGeodesicSourceProxy()
{
  vtkClientServerInterpreterInitializer::GetInitializer()->RegisterCallback(AddToInterpreter);
}

//------------------------------------------------------------------------------
vtkSMGeodesicSourceProxy::vtkSMGeodesicSourceProxy() = default;

//------------------------------------------------------------------------------
vtkSMGeodesicSourceProxy::~vtkSMGeodesicSourceProxy() = default;

//------------------------------------------------------------------------------
void vtkSMGeodesicSourceProxy::PostUpdateData(bool usingCache)
{
  const bool isUpdated = this->NeedsUpdate;
  this->Superclass::PostUpdateData(usingCache);
  if (isUpdated && this->ObjectsCreated)
  {
    this->UpdatePropertyInformation();
    this->ColorNewResult();
  }
}

//------------------------------------------------------------------------------
bool vtkSMGeodesicSourceProxy::IsOutputEmpty(unsigned int port)
{
  vtkPVDataInformation* data = this->GetDataInformation(port);
  return data->GetNumberOfPoints() == 0 && data->GetNumberOfRows() == 0;
}

//------------------------------------------------------------------------------
// A representation that was made when there was a result shows what ParaView or the user has
// chosen.
void vtkSMGeodesicSourceProxy::ColorNewResult()
{
  this->WasEmpty.resize(this->GetNumberOfOutputPorts(), false);
  std::set<vtkSMProxy*> chosen;
  for (unsigned int i = 0; i < this->GetNumberOfConsumers(); ++i)
  {
    auto* shown = vtkSMPVRepresentationProxy::SafeDownCast(this->GetConsumerProxy(i));
    const unsigned int port = shown ? vtkSMPropertyHelper(shown, "Input", true).GetOutputPort() : 0;
    if (!shown || port >= this->WasEmpty.size())
    {
      continue;
    }
    const bool hadNoChoice = this->WasEmpty[port] && this->Chosen.count(shown) == 0;
    if (hadNoChoice && this->IsOutputEmpty(port))
    {
      continue;
    }
    vtkPVArrayInformation* scalars =
      this->GetDataInformation(port)->GetPointDataInformation()->GetAttributeInformation(
        vtkDataSetAttributes::SCALARS);
    if (hadNoChoice && scalars && !shown->GetUsingScalarColoring())
    {
      ColorBy(shown, scalars->GetName());
    }
    chosen.insert(shown);
  }
  this->Chosen = chosen;
  for (unsigned int port = 0; port < this->WasEmpty.size(); ++port)
  {
    this->WasEmpty[port] = this->IsOutputEmpty(port);
  }
}

//------------------------------------------------------------------------------
void vtkSMGeodesicSourceProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WasEmpty:";
  for (const bool wasEmpty : this->WasEmpty)
  {
    os << (wasEmpty ? " yes" : " no");
  }
  os << "\n";
}
