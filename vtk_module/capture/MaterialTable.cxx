// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "capture/MaterialTable.h"

#include "vtkProperty.h"

namespace penumbra
{
void MaterialTable::Clear()
{
  this->Entries.assign(1, { glm::vec4(0.0f), glm::ivec4(GI_MATERIAL_AS_DRAWN, 0, 0, 0) });
  this->Index.clear();
  this->Specular = false;
  this->PartialCoverage = false;
  this->Catcher = -1;
}

int MaterialTable::Add(const shared::MaterialData& material)
{
  this->Entries.push_back(material);
  const int index = static_cast<int>(this->Entries.size()) - 1;
  this->Catcher = material.Model.x == GI_MATERIAL_CATCHER ? index : this->Catcher;
  return index;
}

int MaterialTable::Find(vtkProperty* property, const Owner& owner)
{
  const bool pbr = property->GetInterpolation() == VTK_PBR;
  const double* color = pbr ? property->GetEdgeTint() : property->GetSpecularColor();
  const double scale = pbr ? 1.0 : property->GetSpecular();
  const double last = pbr ? vtkProperty::ComputeReflectanceFromIOR(property->GetBaseIOR(), 1.0)
                          : property->GetSpecularPower();
  const bool thin = property->GetRepresentation() != VTK_SURFACE;
  const std::array<float, 9> key = { { static_cast<float>(color[0] * scale),
    static_cast<float>(color[1] * scale), static_cast<float>(color[2] * scale),
    static_cast<float>(last), pbr ? 1.0f : 0.0f, thin ? 1.0f : 0.0f,
    static_cast<float>(owner.Motion), static_cast<float>(owner.Number),
    owner.ColoredByData ? 1.0f : 0.0f } };
  const auto found = this->Index.find(key);
  if (found != this->Index.end())
  {
    return found->second;
  }
  this->Specular |= !pbr && scale > 0.0;
  constexpr std::size_t limit = 65536;
  if (this->Entries.size() == limit)
  {
    return static_cast<int>(limit) - 1;
  }
  this->Entries.push_back({ glm::vec4(key[0], key[1], key[2], key[3]),
    glm::ivec4(pbr ? GI_MATERIAL_PBR : GI_MATERIAL_PHONG,
      (thin ? GI_MATERIAL_THIN : 0) | (owner.ColoredByData ? GI_MATERIAL_DATA : 0), owner.Motion,
      owner.Number) });
  return this->Index[key] = static_cast<int>(this->Entries.size()) - 1;
}

void MaterialTable::Upload()
{
  this->Storage.Upload(GL_SHADER_STORAGE_BUFFER, this->Entries.data(),
    this->Entries.size() * sizeof(this->Entries[0]));
}
}
