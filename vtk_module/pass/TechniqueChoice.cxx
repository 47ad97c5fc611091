// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pass/TechniqueChoice.h"

#include "technique/FrameBuilder.h"

#include <cstring>

namespace penumbra
{
namespace
{
// Whether one technique takes precedence over another that offers the same resource.
bool IsPreferred(vtkGITechnique* one, vtkGITechnique* other)
{
  return one->GetRank() != other->GetRank() ? one->GetRank() > other->GetRank()
                                            : std::strcmp(one->GetName(), other->GetName()) < 0;
}

using Offers = std::map<std::string, vtkGITechnique*>;

Offers PreferredOffers(const std::vector<vtkSmartPointer<vtkGITechnique>>& techniques)
{
  Offers preferred;
  for (vtkGITechnique* technique : techniques)
  {
    const char* resource = technique->GetOfferedResource();
    if (technique->GetEnabled() && resource)
    {
      vtkGITechnique*& best = preferred[resource];
      best = !best || IsPreferred(technique, best) ? technique : best;
    }
  }
  return preferred;
}
}

std::vector<vtkGITechnique*> ChooseTechniques(
  const std::vector<vtkSmartPointer<vtkGITechnique>>& techniques, FrameBuilder& frame,
  LightingPlan& plan)
{
  const Offers preferred = PreferredOffers(techniques);
  std::vector<vtkGITechnique*> chosen;
  for (vtkGITechnique* technique : techniques)
  {
    const char* resource = technique->GetOfferedResource();
    vtkGITechnique* best = technique->GetEnabled() && resource ? preferred.at(resource) : technique;
    if (best != technique)
    {
      frame.AddNote(std::string(technique->GetName()) + " is not used, because " + best->GetName() +
        ", which is on too, takes its place");
    }
    else if (technique->GetEnabled())
    {
      chosen.push_back(technique);
    }
  }
  for (vtkGITechnique* technique : chosen)
  {
    technique->Plan(plan, frame);
  }
  // The first by name stands in. Its plan supplies what was missing, so that no other does.
  std::vector<vtkGITechnique*> disabled;
  for (vtkGITechnique* technique : techniques)
  {
    if (!technique->GetEnabled())
    {
      disabled.push_back(technique);
    }
  }
  std::sort(disabled.begin(), disabled.end(), [](vtkGITechnique* a, vtkGITechnique* b) {
    return std::strcmp(a->GetName(), b->GetName()) < 0;
  });
  for (vtkGITechnique* technique : disabled)
  {
    if (technique->StandsIn(plan))
    {
      technique->Plan(plan, frame);
      chosen.push_back(technique);
    }
  }
  return chosen;
}
}
