// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "looks/LookSettings.h"

#include "vtkGIPass.h"
#include "vtkGITechnique.h"

namespace penumbra
{
LookSettings::LookSettings(vtkGIPass* pass)
  : Pass(pass)
{
}

LookSettings::~LookSettings()
{
  this->Undo();
}

vtkGIPass* LookSettings::GetPass() const
{
  return this->Pass;
}

void LookSettings::Apply(const std::map<std::string, LookTechnique>& settings)
{
  this->Undo();
  for (const auto& [name, technique] : settings)
  {
    vtkGITechnique* target = this->Pass->GetTechnique(name.c_str());
    LookTechnique& before = this->Before[name];
    before.Enabled = target->GetEnabled();
    for (const auto& parameter : technique.Parameters)
    {
      before.Parameters[parameter.first] = target->GetParameter(parameter.first.c_str());
    }
  }
  Set(this->Pass, settings);
}

void LookSettings::Set(vtkGIPass* pass, const std::map<std::string, LookTechnique>& settings)
{
  for (const auto& [name, technique] : settings)
  {
    vtkGITechnique* target = pass->GetTechnique(name.c_str());
    for (const auto& [parameter, value] : technique.Parameters)
    {
      target->SetParameter(parameter.c_str(), value);
    }
    target->SetEnabled(technique.Enabled.value_or(target->GetEnabled()));
  }
}

void LookSettings::Undo()
{
  if (this->Pass)
  {
    Set(this->Pass, this->Before);
  }
  this->Before.clear();
}
}
