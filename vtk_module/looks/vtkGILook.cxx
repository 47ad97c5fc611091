// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGILook.h"

#include "looks/AppliedLooks.h"
#include "looks/LookFile.h"
#include "looks/LookLibrary.h"

#include "vtkGIPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkGILook);

class vtkGILook::Internals
{
public:
  std::string Name = "as-is";
  penumbra::LookDescription Look;
  std::string LastError;
};

vtkGILook::vtkGILook()
  : Impl(new Internals)
{
}

vtkGILook::~vtkGILook() = default;

void vtkGILook::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Name: " << this->Impl->Name << "\n";
  os << indent << "Title: " << this->Impl->Look.Title << "\n";
}

namespace
{
std::vector<std::string>& Names()
{
  static std::vector<std::string> names = penumbra::LookNames();
  return names;
}
}

int vtkGILook::GetNumberOfLooks()
{
  Names() = penumbra::LookNames();
  return static_cast<int>(Names().size());
}

const char* vtkGILook::GetLookName(int index)
{
  return index < 0 || index >= static_cast<int>(Names().size()) ? nullptr : Names()[index].c_str();
}

bool vtkGILook::Load(const char* nameOrPath)
{
  const std::string name = nameOrPath ? nameOrPath : "";
  try
  {
    vtkNew<vtkGIPass> pass; // never drawn, only asked for its techniques
    this->Impl->Look = penumbra::ReadLook(penumbra::FindLook(name), name, pass);
    this->Impl->Name = name;
    this->Impl->LastError.clear();
    this->Modified();
    return true;
  }
  catch (const penumbra::LookError& error)
  {
    this->Impl->LastError = error.what();
    return false;
  }
}

const char* vtkGILook::GetName()
{
  return this->Impl->Name.c_str();
}

const char* vtkGILook::GetTitle()
{
  return this->Impl->Look.Title.c_str();
}

const char* vtkGILook::GetDescription()
{
  return this->Impl->Look.Text.c_str();
}

const char* vtkGILook::GetLastError()
{
  return this->Impl->LastError.c_str();
}

void vtkGILook::ApplyTo(vtkRenderer* renderer, vtkGIPass* pass)
{
  if (renderer)
  {
    penumbra::ApplyLook(this->Impl->Name, this->Impl->Look, renderer, pass);
  }
}

void vtkGILook::RemoveFrom(vtkRenderer* renderer)
{
  penumbra::RemoveLook(renderer);
}

void vtkGILook::Restore(vtkRenderer* renderer)
{
  penumbra::RestoreLook(renderer);
}

const char* vtkGILook::GetAppliedName(vtkRenderer* renderer)
{
  const char* name = penumbra::AppliedLookName(renderer);
  return name ? name : "as-is";
}
