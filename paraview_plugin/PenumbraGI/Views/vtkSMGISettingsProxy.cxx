// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMGISettingsProxy.h"

#include "vtkPVGIParameters.h"

#include "vtkGIPass.h"
#include "vtkGITechnique.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSMPropertyHelper.h"

vtkStandardNewMacro(vtkSMGISettingsProxy);

namespace
{
constexpr const char* PresetProperty = "GIPreset";
}

void vtkSMGISettingsProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

// The preset is not applied as soon as the property is set: the widget that sets it ignores changes meanwhile.
void vtkSMGISettingsProxy::UpdateVTKObjects()
{
  if (this->GetObjectsCreated())
  {
    vtkSMPropertyHelper preset(this, PresetProperty);
    const int index = preset.GetAsInt();
    if (index >= 0)
    {
      preset.Set(-1);
      this->ApplyPreset(index);
    }
  }
  this->Superclass::UpdateVTKObjects();
}

void vtkSMGISettingsProxy::ApplyPreset(int index)
{
  vtkNew<vtkGIPass> pass; // never drawn, only used for its values
  if (!pass->SetPreset(vtkGIPass::GetPresetName(index)))
  {
    return;
  }
  for (const vtkPVGIParameters::Row& row : vtkPVGIParameters::Table())
  {
    vtkGITechnique* technique = pass->GetTechnique(row.Technique);
    vtkSMPropertyHelper(this, row.Property)
      .Set(row.Parameter ? technique->GetParameter(row.Parameter) : technique->GetEnabled());
  }
}
