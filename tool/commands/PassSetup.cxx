// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/PassSetup.h"

#include "bake/lightmap/LightmapFile.h"
#include "common/Failure.h"
#include "common/Names.h"
#include "common/VtkMessages.h"
#include "scene/build/SceneBuilder.h"

#include <vtkGIBakeFile.h>
#include <vtkGILook.h>
#include <vtkGIPass.h>
#include <vtkGITechnique.h>
#include <vtkImageData.h>
#include <vtkNew.h>

namespace penumbra::tool
{
namespace
{
/// The index of a name; throws a Failure that suggests the nearest one if it is unknown.
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
    TakeVtkMessages(); // the same sentence, reported by VTK's macro
    FailUsage("{}", technique->GetLastError());
  }
}

void LoadOldLightmap(const std::string& path, vtkGIPass* pass, Reporter& reporter)
{
  vtkGITechnique* technique = pass->GetTechnique("lightmap");
  if (!technique->SetBake(lightmap::MakeImage(lightmap::ReadOldLightmap(path))))
  {
    Fail("the lightmap '{}' cannot be used: {}", path, technique->GetBakeError());
  }
  technique->EnabledOn();
  reporter.Note(fmt::format("'{0}' is an OpenEXR file, the old format of lightmaps: convert it "
                            "with penumbra bake convert {0} -o NEW.vti",
    path));
}

/// The scene's switches and parameters.
void ApplySettings(const TechniqueSettings& settings, vtkGIPass* pass)
{
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

void ApplyPreset(const TechniqueSettings& settings, vtkGIPass* pass)
{
  Find(
    settings.Preset, pass->GetNumberOfPresets(), [pass](int i) { return pass->GetPresetName(i); },
    "preset");
  pass->SetPreset(settings.Preset.c_str());
  ApplySettings(settings, pass);
}

void LoadLook(const std::string& name, vtkGILook* look)
{
  if (!look->Load(name.c_str()))
  {
    FailUsage("{}", look->GetLastError());
  }
}
}

Reflection ReflectionIn(const Scene& scene)
{
  vtkNew<vtkGIPass> pass;
  ApplyPreset(scene.Techniques, pass);
  vtkGITechnique* technique = pass->GetTechnique("reflectance");
  return technique->GetEnabled() ? Reflection{ technique->GetParameter("maximum-albedo"),
                                     technique->GetParameter("energy-compensation") != 0 }
                                 : Reflection();
}

void SetUpPass(const Scene& scene, vtkGIPass* pass, Reporter& reporter)
{
  ApplyPreset(scene.Techniques, pass);
  vtkNew<vtkGILook> look; // a mistake is told before data are read
  LoadLook(scene.Look, look);
  for (const std::string& path : scene.Bakes)
  {
    vtkNew<vtkGIBakeFile> file;
    if (lightmap::IsOpenExr(path))
    {
      LoadOldLightmap(path, pass, reporter);
    }
    else if (!file->Load(path.c_str(), pass))
    {
      Fail("{}", file->GetLastError());
    }
  }
}

void ApplyLook(const Scene& scene, vtkRenderer* renderer, vtkGIPass* pass, Reporter& reporter)
{
  vtkNew<vtkGILook> look;
  LoadLook(scene.Look, look);
  look->ApplyTo(renderer, pass);
  if (pass)
  {
    ApplySettings(scene.Techniques, pass);
  }
  SetTextColors(renderer);
  if (scene.Backdrop)
  {
    SetBackground(*scene.Backdrop, renderer);
  }
  if (!scene.LookGiven && scene.Look != OwnLook)
  {
    reporter.Note(fmt::format("the look '{}' lights the scene: --look as-is draws it with a plain "
                              "key light, and penumbra info lists further looks",
      scene.Look));
  }
}
}
