// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/rays/SurfaceMaterial.h"

#include "private/Matrices.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkTexture.h"

namespace penumbra
{
namespace
{
/// The mean colour of a picture, linear; white where there is none.
glm::vec3 MeanColor(vtkTexture* texture)
{
  vtkImageData* image = texture ? texture->GetInput() : nullptr;
  vtkDataArray* values = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!values || values->GetNumberOfTuples() == 0)
  {
    return glm::vec3(1.0f);
  }
  const bool bytes = values->GetDataType() == VTK_UNSIGNED_CHAR;
  glm::dvec3 sum(0.0);
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      const int component = std::min(channel, values->GetNumberOfComponents() - 1);
      const double value = values->GetComponent(i, component) / (bytes ? 255.0 : 1.0);
      sum[channel] += texture->GetUseSRGBColorSpace() ? std::pow(value, 2.2) : value;
    }
  }
  return glm::vec3(sum / static_cast<double>(values->GetNumberOfTuples()));
}
}

void Recolor(shared::RaySurface& surface, vtkProperty* property, const glm::vec3& color)
{
  const bool phong = (surface.Where.z & GI_SURFACE_MODEL) == GI_SURFACE_PHONG;
  const auto diffuse = static_cast<float>(phong ? property->GetDiffuse() : 1.0);
  surface.Color = glm::vec4(color * diffuse, surface.Color.a);
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

shared::RaySurface MakeRaySurface(vtkProperty* property)
{
  shared::RaySurface surface{};
  int flags = GI_SURFACE_PHONG;
  const glm::vec3 diffuse(ToVec3(property->GetDiffuseColor()));
  if (!property->GetLighting())
  {
    flags = GI_SURFACE_UNLIT;
    surface.Color = glm::vec4(diffuse, 0.0f);
  }
  else if (property->GetInterpolation() == VTK_PBR)
  {
    flags = GI_SURFACE_PBR;
    surface.Color = glm::vec4(diffuse, 0.0f);
    surface.Specular = glm::vec4(ToVec3(property->GetEdgeTint()),
      vtkProperty::ComputeReflectanceFromIOR(property->GetBaseIOR(), 1.0));
    surface.Factors = glm::vec4(property->GetMetallic(), property->GetRoughness(), 0.0f, 0.0f);
    if (vtkTexture* emission = property->GetTexture("emissiveTex"))
    {
      surface.Emission =
        glm::vec4(glm::vec3(ToVec3(property->GetEmissiveFactor())) * MeanColor(emission), 0.0f);
    }
  }
  else
  {
    surface.Color = glm::vec4(diffuse * static_cast<float>(property->GetDiffuse()), 0.0f);
    surface.Specular = glm::vec4(
      ToVec3(property->GetSpecularColor()) * property->GetSpecular(), property->GetSpecularPower());
    surface.Emission =
      glm::vec4(ToVec3(property->GetAmbientColor()) * property->GetAmbient(), 0.0f);
    surface.Factors = glm::vec4(property->GetDiffuse(), property->GetAmbient(), 0.0f, 0.0f);
  }
  surface.Color.a = static_cast<float>(property->GetOpacity());
  flags |= property->GetBackfaceCulling() ? GI_SURFACE_CULL_BACK | GI_SURFACE_PARTLY : 0;
  flags |= property->GetFrontfaceCulling() ? GI_SURFACE_CULL_FRONT | GI_SURFACE_PARTLY : 0;
  flags |= property->GetOpacity() < 1.0 ? GI_SURFACE_PARTLY : 0;
  surface.Where = glm::ivec4(0, 0, flags, -1);
  return surface;
}
}
