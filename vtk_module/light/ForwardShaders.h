// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The one place that substitutes into VTK's templates for what VTK draws itself after the opaque props. The
 * inserted text itself lives in glsl/forward/ and in the techniques' folders.
 */
#pragma once

#include "capture/ShaderHooks.h"
#include "light/ForwardPart.h"

#include <string>

namespace penumbra
{
class ForwardShaders
{
public:
  /// So many parts that know indirect light are taken, the first ones.
  static constexpr std::size_t MostParts = 2;

  ForwardShaders(const ShaderLibrary& shaders, const ForwardLight& light)
    : Shaders(shaders)
    , Light(light)
  {
  }

  /// Remember places in a fragment shader's template, before the mapper fills it in.
  static void MarkSurface(std::string& text);
  static void MarkVolume(std::string& text);

  /// Light what the mapper has filled in; as it is where it is not lit.
  void LightSurface(const ShaderTexts& texts) const;
  void LightVolume(std::string& text) const;

  /// What VTK would come to: small shaders like its own, lit; by name.
  std::vector<std::pair<std::string, std::string>> Examples() const;

  /// Throws std::runtime_error, naming the example and with the compiler's message, where one does not compile.
  void Check() const;

private:
  void Declare(std::string& text, bool volume, Defines visibility) const;
  std::string Parts(bool volume) const;
  void AddAround(std::string& text) const;
  void DimLamps(std::string& text) const;
  bool DimLampsOfVolume(std::string& text, Defines& variant) const;
  bool AddScattered(std::string& text) const;

  const ShaderLibrary& Shaders;
  const ForwardLight& Light;
};
}
