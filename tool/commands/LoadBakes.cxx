// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/LoadBakes.h"

#include "bake/lightmap/LightmapFile.h"
#include "common/Failure.h"
#include "common/VtkMessages.h"
#include "scene/readers/ProbeFile.h"

#include <vtkGILightmap.h>
#include <vtkGIPass.h>
#include <vtkGISHProbes.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <filesystem>

namespace penumbra::tool
{
namespace
{
void LoadLightmap(const std::string& path, vtkGIPass* pass)
{
  const lightmap::Lightmap map = lightmap::ReadLightmap(path);
  auto* technique = vtkGILightmap::SafeDownCast(pass->GetTechnique("lightmap"));
  if (!technique->SetBake(lightmap::MakeSurfaces(map), lightmap::MakeImage(map)))
  {
    TakeVtkMessages(); // said below
    Fail("the lightmap '{}' cannot be used: bake it again with this version", path);
  }
  technique->EnabledOn();
}

void LoadProbes(const std::string& path, vtkGIPass* pass)
{
  const vtkSmartPointer<vtkImageData> field = ReadProbes(path);
  auto* technique = vtkGISHProbes::SafeDownCast(pass->GetTechnique("sh-probes"));
  if (!technique->SetBake(field))
  {
    Fail("the probes '{}' cannot be used: {}", path, technique->GetBakeError());
  }
  technique->EnabledOn();
}

struct BakeKind
{
  bool (*Is)(const std::string& path);
  void (*Load)(const std::string& path, vtkGIPass* pass);
};
constexpr BakeKind Kinds[] = { { lightmap::IsLightmap, LoadLightmap }, { IsProbes, LoadProbes } };
}

void LoadBakes(const std::vector<std::string>& files, vtkGIPass* pass)
{
  for (const std::string& path : files)
  {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
    {
      Fail("the bake '{}' does not exist: make one with penumbra bake", path);
    }
    bool found = false;
    for (const BakeKind& kind : Kinds)
    {
      if (kind.Is(path))
      {
        kind.Load(path, pass);
        found = true;
        break;
      }
    }
    if (!found)
    {
      Fail("'{}' holds no baked light, or is damaged beyond telling which: give a file that "
           "penumbra bake lightmap or penumbra bake probes wrote",
        path);
    }
  }
}
}
