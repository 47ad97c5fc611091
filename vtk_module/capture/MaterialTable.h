// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reflection parameters of a frame's materials that the G-buffer does not hold per pixel. Equal
 * materials share an entry. Entry 0 reflects nothing and shows VTK's own colour.
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

  /// The prop that an entry belongs to, if that matters: the row of its motion, and its persistent number.
  struct Owner
  {
    int Motion = 0;
    int Number = 0;
    bool ColoredByData = false;
  };

  /// Index of a property's entry, created at first use. The G-buffer holds 16 bits: materials beyond
  /// 65535 different ones in a frame share the last entry.
  int Find(vtkProperty* property, const Owner& owner);

  /// Index of a new entry for a surface that is no prop.
  int Add(const shared::MaterialData& material);

  /// Whether a surface shows the background, see GI_MATERIAL_CATCHER. A frame has at most one.
  bool HasCatcher() const { return this->Catcher >= 0; }

  bool HasSpecular() const { return this->Specular; }

  /// Whether fragments that are drawn as opaque may cover a pixel partly, by the alpha of a texture or of
  /// colours. VTK blends such fragments in drawing order.
  void SetPartialCoverage(bool part) { this->PartialCoverage = part; }
  bool HasPartialCoverage() const { return this->PartialCoverage; }

  /// Upload the entries, after all of the frame's props are drawn.
  void Upload();
  /// Arguments of shaders that include shared/material.h. catcher: index of that surface's material, or -1.
  Arguments ShaderArguments() const
  {
    return Arguments().Block("MaterialBlock", this->Storage).Set("catcher", this->Catcher);
  }
  void ReleaseGraphicsResources() { this->Storage = Buffer(); }

private:
  std::vector<shared::MaterialData> Entries;
  std::map<std::array<float, 9>, int> Index;
  bool Specular = false;
  bool PartialCoverage = false;
  int Catcher = -1;
  Buffer Storage;
};
}
