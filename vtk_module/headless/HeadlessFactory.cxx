// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause

#include "headless/HeadlessFactory.h"

#include "headless/HeadlessChoice.h"
#include "vtkHeadlessRenderWindow.h"

#include "vtkGenericRenderWindowInteractor.h"
#include "vtkObjectFactory.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkVersion.h"

#include <cstring>
#include <string>

//------------------------------------------------------------------------------
// The overrides of vtkRenderWindow and its interactor. It decides at each New(), so that it does not matter whether
// VTK's own override was registered before or after it, nor when the environment was set.
class vtkHeadlessRenderWindowFactory : public vtkObjectFactory
{
public:
  static vtkHeadlessRenderWindowFactory* New();
  vtkTypeMacro(vtkHeadlessRenderWindowFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "Render window for machines without a display"; }

  static vtkHeadlessRenderWindowFactory* FindRegistered()
  {
    vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
    vtkCollectionSimpleIterator it;
    factories->InitTraversal(it);
    while (vtkObjectFactory* factory = factories->GetNextObjectFactory(it))
    {
      if (auto ours = vtkHeadlessRenderWindowFactory::SafeDownCast(factory))
      {
        return ours;
      }
    }
    return nullptr;
  }

protected:
  vtkHeadlessRenderWindowFactory()
  {
    this->RegisterOverride("vtkRenderWindow", "vtkHeadlessRenderWindow", this->GetDescription(), 1,
      []() -> vtkObject* { return vtkHeadlessRenderWindow::New(); });
    // X's interactor, which the first Render() would initialise, needs the display as well.
    this->RegisterOverride("vtkRenderWindowInteractor", "vtkGenericRenderWindowInteractor",
      this->GetDescription(), 1,
      []() -> vtkObject* { return vtkGenericRenderWindowInteractor::New(); });
  }

  // Null lets the next factory answer.
  vtkObject* CreateObject(const char* name) override
  {
    return this->HasOverride(name) && this->IsWanted() ? this->Superclass::CreateObject(name)
                                                       : nullptr;
  }

private:
  bool IsWanted()
  {
    switch (penumbra::ReadBackendWish())
    {
      case penumbra::BackendWish::EGL:
      case penumbra::BackendWish::OSMesa:
        return true;
      case penumbra::BackendWish::X11:
        return false;
      case penumbra::BackendWish::None:
        return this->IsNeeded();
      case penumbra::BackendWish::Unknown:
        break;
    }
    if (this->IsNeeded())
    {
      return true; // and the window will complain
    }
    if (!this->Complained)
    {
      this->Complained = true;
      vtkErrorMacro(<< penumbra::DescribeUnknownBackend());
    }
    return false;
  }

  // Whether VTK itself would be at a loss.
  bool IsNeeded()
  {
    if (*penumbra::ReadVariable("DISPLAY") != '\0')
    {
      return false;
    }
    const std::string stock = this->StockWindow();
    // VTK's own chooser, where there is one, tries X first and warns when it finds none; who names a window has chosen.
    if (stock == "vtkOpenGLRenderWindow")
    {
      return *penumbra::ReadVariable("VTK_DEFAULT_OPENGL_WINDOW") == '\0';
    }
    // A VTK built for EGL, OSMesa, Windows or macOS needs no display. With no override loaded (yet), this window is
    // better than none.
    return stock == "vtkXOpenGLRenderWindow" || stock.empty();
  }

  // The class that VTK makes for vtkRenderWindow; empty where no other factory has one.
  std::string StockWindow()
  {
    vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
    vtkCollectionSimpleIterator it;
    factories->InitTraversal(it);
    while (vtkObjectFactory* factory = factories->GetNextObjectFactory(it))
    {
      for (int i = 0; factory != this && i < factory->GetNumberOfOverrides(); ++i)
      {
        if (std::strcmp(factory->GetClassOverrideName(i), "vtkRenderWindow") == 0 &&
          factory->GetEnableFlag(i))
        {
          return factory->GetClassOverrideWithName(i);
        }
      }
    }
    return std::string();
  }

  bool Complained = false;
};

vtkStandardNewMacro(vtkHeadlessRenderWindowFactory);

namespace penumbra
{
void SetHeadlessFactory(bool wanted)
{
  vtkHeadlessRenderWindowFactory* registered = vtkHeadlessRenderWindowFactory::FindRegistered();
  if (wanted == (registered != nullptr))
  {
    return;
  }
  if (!wanted)
  {
    vtkObjectFactory::UnRegisterFactory(registered);
    return;
  }
  vtkHeadlessRenderWindowFactory* factory = vtkHeadlessRenderWindowFactory::New();
  vtkObjectFactory::RegisterFactory(factory);
  // The first factory to answer wins and VTK's own may be registered already: move to the front.
  vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
  factories->RemoveItem(factory);
  if (factories->GetNumberOfItems() == 0)
  {
    factories->AddItem(factory);
  }
  else
  {
    factories->InsertItem(-1, factory);
  }
  factory->Delete();
}

bool HasHeadlessFactory()
{
  return vtkHeadlessRenderWindowFactory::FindRegistered() != nullptr;
}
}
