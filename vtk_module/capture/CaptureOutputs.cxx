// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "capture/CaptureOutputs.h"

#include "vtkShaderProgram.h"

namespace penumbra
{
std::vector<const CaptureOutputs::Optional*> CaptureOutputs::RequestedTargets() const
{
  std::vector<const Optional*> targets;
  for (const Optional& optional : All)
  {
    if (this->Has(optional.Resource))
    {
      targets.push_back(&optional);
    }
  }
  return targets;
}

std::vector<const char*> CaptureOutputs::Resources() const
{
  std::vector<const char*> resources = { resource::Albedo, resource::Normal,
    this->Ambient ? resource::Ambient : nullptr };
  if (this->Extended)
  {
    resources.push_back(resource::Surface);
    resources.push_back(resource::Emission);
  }
  for (const Optional* optional : this->RequestedTargets())
  {
    resources.push_back(optional->Resource);
  }
  return resources;
}

Defines CaptureOutputs::SnippetDefines() const
{
  Defines defines;
  if (this->Extended)
  {
    defines["GI_EXTENDED"] = "1";
  }
  for (const Optional* optional : this->RequestedTargets())
  {
    defines[optional->Name] = "1";
  }
  return defines;
}

void CaptureOutputs::NumberTargets(std::string& snippet) const
{
  std::size_t number = this->Extended ? 5 : 3;
  for (const Optional* optional : this->RequestedTargets())
  {
    vtkShaderProgram::Substitute(snippet, std::string("gl_FragData[") + optional->Name + "]",
      "gl_FragData[" + std::to_string(number++) + "]");
  }
}
}
