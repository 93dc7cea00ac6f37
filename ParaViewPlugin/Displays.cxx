// SPDX-License-Identifier: BSD-3-Clause
#include "Displays.h"

#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMParaViewPipelineController.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyLink.h"
#include "vtkSMProxyProperty.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <cstring>
#include <sstream>
#include <string>

namespace
{

/// The words for a filter's length; empty if it has no single one.
std::string lengthOf(vtkSMSourceProxy* filter)
{
  const bool hasPaths = filter->GetProperty("NumberOfPaths") != nullptr;
  const double length =
    vtkSMPropertyHelper(filter, hasPaths ? "ShortestLength" : "SourceLength", true).GetAsDouble();
  std::ostringstream words;
  if (length > 0.0 && (!hasPaths || vtkSMPropertyHelper(filter, "NumberOfPaths").GetAsInt() == 1))
  {
    words << "Length " << length;
  }
  return words.str();
}

/// A view that shows an output of a filter.
vtkSMViewProxy* viewOf(vtkSMSourceProxy* filter)
{
  for (unsigned int i = 0; i < filter->GetNumberOfConsumers(); ++i)
  {
    auto* shown = vtkSMPVRepresentationProxy::SafeDownCast(filter->GetConsumerProxy(i));
    if (vtkSMViewProxy* view = shown ? vtkSMViewProxy::FindView(shown) : nullptr)
    {
      return view;
    }
  }
  return nullptr;
}

/// Words in a view. They are hidden as handles are: not in the pipeline, and not in state files.
class LengthLabel : public vtkCommand
{
public:
  static LengthLabel* New() { return new LengthLabel; }

  vtkWeakPointer<vtkSMPVRepresentationProxy> Line;

  /// After an execution of the filter.
  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    auto* filter = static_cast<vtkSMSourceProxy*>(caller);
    const std::string words = lengthOf(filter);
    if (!this->Shown && !words.empty())
    {
      this->Make(filter);
    }
    if (this->Shown)
    {
      vtkSMPropertyHelper(this->Words, "Text").Set(words.c_str());
      this->Words->UpdateVTKObjects();
      this->Words->UpdatePipeline();
    }
  }

private:
  void Make(vtkSMSourceProxy* filter)
  {
    this->View = viewOf(filter);
    if (!this->View || !this->Line || !this->View->GetProperty("HiddenRepresentations"))
    {
      return;
    }
    vtkNew<vtkSMParaViewPipelineController> controller;
    this->Words.TakeReference(vtkSMSourceProxy::SafeDownCast(
      filter->GetSessionProxyManager()->NewProxy("sources", "TextSource")));
    controller->InitializeProxy(this->Words);
    this->Words->UpdateVTKObjects();
    this->Shown.TakeReference(this->View->CreateDefaultRepresentation(this->Words, 0));
    controller->PreInitializeProxy(this->Shown);
    vtkSMPropertyHelper(this->Shown, "Input").Set(this->Words);
    controller->PostInitializeProxy(this->Shown);
    vtkSMPropertyHelper(this->Shown, "WindowLocation").Set("Lower Center");
    this->Shown->UpdateVTKObjects();
    vtkSMPropertyHelper(this->View, "HiddenRepresentations").Add(this->Shown);
    this->View->UpdateVTKObjects();
    this->Link->AddLinkedProperty(this->Line, "Visibility", vtkSMLink::INPUT);
    this->Link->AddLinkedProperty(this->Shown, "Visibility", vtkSMLink::OUTPUT);
  }

  ~LengthLabel() override
  {
    if (this->View && this->Shown)
    {
      vtkSMPropertyHelper(this->View, "HiddenRepresentations").Remove(this->Shown);
      this->View->UpdateVTKObjects();
    }
  }

  vtkWeakPointer<vtkSMViewProxy> View;
  vtkSmartPointer<vtkSMSourceProxy> Words;
  vtkSmartPointer<vtkSMProxy> Shown;
  vtkNew<vtkSMPropertyLink> Link;
};

class TextureWatch : public vtkCommand
{
public:
  static TextureWatch* New() { return new TextureWatch; }

  vtkWeakPointer<vtkSMSourceProxy> Field;

  /// When a property of the representation is set.
  void Execute(vtkObject* caller, unsigned long, void* property) override
  {
    if (!this->Field || !property || std::strcmp(static_cast<char*>(property), "Texture") != 0)
    {
      return;
    }
    auto* shown = static_cast<vtkSMPVRepresentationProxy*>(caller);
    const bool hasTexture = vtkSMPropertyHelper(shown, "Texture").GetAsProxy() != nullptr;
    const char* distance = vtkSMPropertyHelper(this->Field, "DistanceArrayName").GetAsString();
    shown->SetScalarColoring(hasTexture ? nullptr : distance, vtkDataObject::POINT);
    vtkSMPropertyHelper(shown, "RepeatTextures", true)
      .Set(vtkSMPropertyHelper(this->Field, "TextureRepeats").GetAsInt());
    shown->UpdateVTKObjects();
  }
};

}

namespace displays
{

void labelLength(vtkSMSourceProxy* filter, vtkSMPVRepresentationProxy* line)
{
  vtkNew<LengthLabel> label;
  label->Line = line;
  filter->AddObserver(vtkCommand::UpdateDataEvent, label);
  label->Execute(filter, vtkCommand::UpdateDataEvent, nullptr);
}

void makeRoomForTexture(vtkSMSourceProxy* field, vtkSMPVRepresentationProxy* surface)
{
  vtkNew<TextureWatch> watch;
  watch->Field = field;
  surface->AddObserver(vtkCommand::PropertyModifiedEvent, watch);
}

}
