// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/LoadBakes.h"

#include "bake/lightmap/LightmapFile.h"
#include "common/Failure.h"
#include "common/Reporter.h"

#include <vtkGIBakeFile.h>
#include <vtkGIPass.h>
#include <vtkGITechnique.h>
#include <vtkImageData.h>
#include <vtkNew.h>

namespace penumbra::tool
{
namespace
{
void LoadOldLightmap(const std::string& path, vtkGIPass* pass, Reporter& reporter)
{
  vtkGITechnique* technique = pass->GetTechnique("lightmap");
  if (!technique->SetBake(lightmap::MakeImage(lightmap::ReadOldLightmap(path))))
  {
    Fail("the lightmap '{}' cannot be used: {}", path, technique->GetBakeError());
  }
  technique->EnabledOn();
  reporter.Note(fmt::format("'{0}' is an OpenEXR file, the old form of lightmaps: convert it with "
                            "penumbra bake convert {0} -o NEW.vti",
    path));
}
}

void LoadBakes(const std::vector<std::string>& files, vtkGIPass* pass, Reporter& reporter)
{
  for (const std::string& path : files)
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
}
