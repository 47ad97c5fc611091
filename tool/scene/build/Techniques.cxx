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
vtkGITechnique* Find(vtkGIPass* pass, const std::string& name)
{
  std::vector<std::string> names;
  for (int i = 0; i < pass->GetNumberOfTechniques(); ++i)
  {
    vtkGITechnique* technique = pass->GetTechnique(i);
    if (name == technique->GetName())
    {
      return technique;
    }
    names.emplace_back(technique->GetName());
  }
  FailUsage("{}", UnknownName("technique", name, "", names));
}

void CheckPreset(vtkGIPass* pass, const std::string& preset)
{
  std::vector<std::string> names;
  for (int i = 0; i < pass->GetNumberOfPresets(); ++i)
  {
    names.emplace_back(pass->GetPresetName(i));
    if (names.back() == preset)
    {
      return;
    }
  }
  FailUsage("{}", UnknownName("preset", preset, "", names));
}

void SetParameter(vtkGITechnique* technique, const ParameterSetting& setting)
{
  std::vector<std::string> names;
  for (int i = 0; i < technique->GetNumberOfParameters(); ++i)
  {
    names.emplace_back(technique->GetParameterName(i));
  }
  if (std::find(names.begin(), names.end(), setting.Parameter) == names.end())
  {
    FailUsage("{}", UnknownName("parameter", setting.Parameter, setting.Technique, names));
  }
  if (!technique->SetParameterFromText(setting.Parameter.c_str(), setting.Value.c_str()))
  {
    TakeVtkMessages(); // the same sentence, printed by VTK's macro
    const char* reason = technique->GetLastError();
    FailUsage("{}",
      reason
        ? reason
        : fmt::format("{}.{} cannot be '{}'", setting.Technique, setting.Parameter, setting.Value));
  }
}
}

void ApplyTechniques(const TechniqueSettings& settings, vtkGIPass* pass)
{
  CheckPreset(pass, settings.Preset);
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
