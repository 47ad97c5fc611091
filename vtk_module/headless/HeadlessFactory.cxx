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
// Overrides of vtkRenderWindow and its interactor. The factory decides at each New(), so that it does not matter
// whether VTK's own override was registered earlier or later, or when the environment was set.
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
    // X's interactor, which the first Render() would initialise, also needs a display.
    this->RegisterOverride("vtkRenderWindowInteractor", "vtkGenericRenderWindowInteractor",
      this->GetDescription(), 1,
      []() -> vtkObject* { return vtkGenericRenderWindowInteractor::New(); });
  }

  // Null lets the next factory create the object.
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
      return true; // the window will report the error
    }
    if (!this->ErrorReported)
    {
      this->ErrorReported = true;
      vtkErrorMacro(<< penumbra::DescribeUnknownBackend());
    }
    return false;
  }

  // Whether VTK itself could not create a usable window.
  bool IsNeeded()
  {
    if (*penumbra::ReadVariable("DISPLAY") != '\0')
    {
      return false;
    }
    const std::string windowClass = this->OtherWindowClass();
    // VTK's own chooser (9.4 and later) tries X first and warns if there is none. The variable names the user's choice.
    if (windowClass == "vtkOpenGLRenderWindow")
    {
      return *penumbra::ReadVariable("VTK_DEFAULT_OPENGL_WINDOW") == '\0';
    }
    // A VTK built for EGL, OSMesa, Windows or macOS needs no display. If no override is loaded yet, this window is
    // better than none.
    return windowClass == "vtkXOpenGLRenderWindow" || windowClass.empty();
  }

  // The class that other factories create for vtkRenderWindow; empty if there is none.
  std::string OtherWindowClass()
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

  bool ErrorReported = false;
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
  // The first factory that creates the object wins, and VTK's own may be registered already: move to the front.
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
