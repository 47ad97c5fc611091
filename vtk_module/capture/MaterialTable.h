// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The reflecting properties of a frame's materials beside what the G-buffer holds per pixel. Equal
 * properties share an entry; entry 0 reflects nothing and shows VTK's own colour.
 */
#pragma once

#include "gpu/Arguments.h"

#include "material.h"

#include <array>
#include <map>
#include <vector>

class vtkProperty;

namespace penumbra
{
class MaterialTable
{
public:
  MaterialTable() { this->Clear(); }
  void Clear();

  /// Which prop an entry is of, where that matters: the row of its motion, and a number that stays.
  struct Owner
  {
    int Motion = 0;
    int Number = 0;
  };

  /// The entry of a property, made on first sight. The G-buffer holds 16 bits: materials past
  /// 65535 different ones in a frame share the last.
  int Find(vtkProperty* property, const Owner& owner);

  bool HasPBR() const { return this->PBR; }
  bool HasSpecular() const { return this->Specular; }

  /// Whether fragments drawn as opaque may cover a pixel in part, by the alpha of a texture or of
  /// colours; VTK blends such fragments in the order of drawing.
  void SetCoverInPart(bool part) { this->PartCover = part; }
  bool CoverInPart() const { return this->PartCover; }

  /// Once the frame's materials are known.
  void Upload();
  /// For shaders that include shared/material.h.
  Arguments ShaderArguments() const { return Arguments().Block("MaterialBlock", this->Storage); }
  void ReleaseGraphicsResources() { this->Storage = Buffer(); }

private:
  std::vector<shared::MaterialData> Entries;
  std::map<std::array<float, 8>, int> Index;
  bool PBR = false;
  bool Specular = false;
  bool PartCover = false;
  Buffer Storage;
};
}
