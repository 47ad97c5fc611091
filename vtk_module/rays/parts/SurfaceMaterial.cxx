// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/parts/SurfaceMaterial.h"

#include "base/Matrices.h"

#include "vtkActor.h"
#include "vtkProperty.h"
#include "vtkTexture.h"

#include <set>
#include <string>

namespace penumbra
{
void Recolor(shared::RaySurface& surface, vtkProperty* property, const glm::vec3& color)
{
  const bool phong = (surface.Where.z & GI_SURFACE_MODEL) == GI_SURFACE_PHONG;
  surface.Color = glm::vec4(color * surface.Factors.x, surface.Color.a);
  if (phong)
  {
    surface.Emission = glm::vec4(color * static_cast<float>(property->GetAmbient()), 0.0f);
  }
}

void Fade(shared::RaySurface& surface, float opacity)
{
  surface.Color.a *= opacity;
  surface.Where.z |= surface.Color.a < 1.0f ? GI_SURFACE_PARTLY : 0;
}

namespace
{
// Since VTK 9.4 edges have their own width and opacity.
template <typename Property>
auto EdgeWidth(Property* property, int) -> decltype(property->GetEdgeWidth())
{
  return property->GetUseLineWidthForEdgeThickness() ? property->GetLineWidth()
                                                     : property->GetEdgeWidth();
}
template <typename Property>
float EdgeWidth(Property* property, long)
{
  return property->GetLineWidth();
}
template <typename Property>
auto EdgeOpacity(Property* property, int) -> decltype(property->GetEdgeOpacity())
{
  return property->GetEdgeOpacity();
}
template <typename Property>
double EdgeOpacity(Property*, long)
{
  return 1.0;
}
}

shared::RaySurface MakeRaySurface(vtkProperty* property)
{
  shared::RaySurface surface{};
  int flags = GI_SURFACE_PHONG;
  const glm::vec3 color(ToVec3(property->GetDiffuseColor()));
  surface.Factors = glm::vec4(property->GetDiffuse(), property->GetAmbient(), 0.0f, 0.0f);
  if (!property->GetLighting())
  {
    flags = GI_SURFACE_UNLIT;
    surface.Factors = glm::vec4(1.0f, 0.0f, 0.0f, 0.0f);
  }
  else if (property->GetInterpolation() == VTK_PBR)
  {
    flags = GI_SURFACE_PBR;
    surface.Specular = glm::vec4(ToVec3(property->GetEdgeTint()),
      vtkProperty::ComputeReflectanceFromIOR(property->GetBaseIOR(), 1.0));
    surface.Factors =
      glm::vec4(property->GetDiffuse(), 0.0f, property->GetMetallic(), property->GetRoughness());
    surface.More.y = static_cast<float>(property->GetNormalScale());
    surface.More.z = static_cast<float>(property->GetOcclusionStrength());
    if (property->GetTexture("emissiveTex"))
    {
      surface.Emission = glm::vec4(ToVec3(property->GetEmissiveFactor()), 0.0f);
    }
  }
  else
  {
    surface.Specular = glm::vec4(
      ToVec3(property->GetSpecularColor()) * property->GetSpecular(), property->GetSpecularPower());
    surface.Emission =
      glm::vec4(ToVec3(property->GetAmbientColor()) * property->GetAmbient(), 0.0f);
  }
  surface.Color = glm::vec4(color * surface.Factors.x, 0.0f);
  surface.Color.a = static_cast<float>(property->GetOpacity());
  flags |= property->GetBackfaceCulling() ? GI_SURFACE_CULL_BACK | GI_SURFACE_PARTLY : 0;
  flags |= property->GetFrontfaceCulling() ? GI_SURFACE_CULL_FRONT | GI_SURFACE_PARTLY : 0;
  flags |= property->GetOpacity() < 1.0 ? GI_SURFACE_PARTLY : 0;
  flags |= property->GetShowTexturesOnBackface() ? 0 : GI_SURFACE_FRONT_PICTURES;
  surface.Where = glm::ivec4(0, 0, flags, -1);
  surface.Pictures = glm::ivec4(-1);
  surface.More.x = glm::intBitsToFloat(-1);
  surface.More.w = static_cast<float>(EdgeOpacity(property, 0));
  if (property->GetEdgeVisibility())
  {
    constexpr float thinnest = 1.1f; // VTK's minimum
    surface.Edge = glm::vec4(ToVec3(property->GetEdgeColor()),
      std::max(thinnest, static_cast<float>(EdgeWidth(property, 0))));
  }
  return surface;
}

std::array<vtkTexture*, PictureSlots> PropertyPictures(vtkActor* actor)
{
  std::array<vtkTexture*, PictureSlots> pictures{};
  vtkProperty* property = actor->GetProperty();
  if (property->GetLighting() && property->GetInterpolation() == VTK_PBR)
  {
    pictures[BasePicture] = property->GetTexture("albedoTex");
    pictures[MaterialPicture] = property->GetTexture("materialTex");
    pictures[NormalPicture] = property->GetTexture("normalTex");
    pictures[EmissionPicture] = property->GetTexture("emissiveTex");
    return pictures;
  }
  pictures[BasePicture] = actor->GetTexture();
  // Textures with PBR names are not shown on other materials. Of the others, VTK shows the first.
  const std::set<std::string> special = { "albedoTex", "materialTex", "normalTex", "emissiveTex",
    "brdfTex", "anisotropyTex", "coatNormalTex" };
  for (const auto& named : property->GetAllTextures())
  {
    const bool shown = !pictures[BasePicture] && special.count(named.first) == 0;
    pictures[BasePicture] = shown ? named.second : pictures[BasePicture];
  }
  return pictures;
}
}
