// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/build/Techniques.h"

#include "common/Failure.h"
#include "common/Names.h"
#include "common/VtkMessages.h"

#include <vtkGIPass.h>
#include <vtkGITechnique.h>

namespace penumbra::tool
{
namespace
{
/// The place of a name among so many; throws a Failure that names the nearest where it is not there.
template <typename NameOf>
int Find(const std::string& name, int count, const NameOf& nameOf, const char* kind,
  const std::string& owner = "")
{
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i)
  {
    names.emplace_back(nameOf(i));
    if (names.back() == name)
    {
      return i;
    }
  }
  FailUsage("{}", UnknownName(kind, name, owner, names));
}

vtkGITechnique* Find(vtkGIPass* pass, const std::string& name)
{
  const auto nameOf = [pass](int i) { return pass->GetTechnique(i)->GetName(); };
  return pass->GetTechnique(Find(name, pass->GetNumberOfTechniques(), nameOf, "technique"));
}

void SetParameter(vtkGITechnique* technique, const ParameterSetting& setting)
{
  Find(
    setting.Parameter, technique->GetNumberOfParameters(),
    [technique](int i) { return technique->GetParameterName(i); }, "parameter", setting.Technique);
  if (!technique->SetParameterFromText(setting.Parameter.c_str(), setting.Value.c_str()))
  {
    TakeVtkMessages(); // the same sentence, printed by VTK's macro
    FailUsage("{}", technique->GetLastError());
  }
}
}

void ApplyTechniques(const TechniqueSettings& settings, vtkGIPass* pass)
{
  Find(
    settings.Preset, pass->GetNumberOfPresets(), [pass](int i) { return pass->GetPresetName(i); },
    "preset");
  pass->SetPreset(settings.Preset.c_str());
  for (const std::string& name : settings.On)
  {
    Find(pass, name)->EnabledOn();
  }
  for (const std::string& name : settings.Off)
  {
    Find(pass, name)->EnabledOff();
  }
  for (const ParameterSetting& setting : settings.Parameters)
  {
    SetParameter(Find(pass, setting.Technique), setting);
  }
}
}
