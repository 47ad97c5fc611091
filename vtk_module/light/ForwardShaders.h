// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The only place that substitutes into VTK's templates for what VTK draws itself after the opaque props. The
 * inserted text lives in glsl/forward/ and in the techniques' folders.
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
  /// Maximum number of parts with indirect light; further ones are ignored.
  static constexpr std::size_t MaximumParts = 2;

  ForwardShaders(const ShaderLibrary& shaders, const ForwardLight& light)
    : Shaders(shaders)
    , Light(light)
  {
  }

  /// Insert tags into a fragment shader's template, before the mapper fills it in.
  static void MarkSurface(std::string& text);
  static void MarkVolume(std::string& text);

  /// Add light to a shader that the mapper has filled in. Unlit shaders stay unchanged.
  void LightSurface(const ShaderTexts& texts) const;
  void LightVolume(std::string& text) const;

  /// Small shaders that resemble VTK's, with light added, by name.
  std::vector<std::pair<std::string, std::string>> Examples() const;

  /// Throws std::runtime_error, with the example's name and the compiler's message, if one does not compile.
  void Check() const;

private:
  void Declare(std::string& text, bool volume, Defines visibility) const;
  std::string IndirectSource(bool volume) const;
  void AddIndirect(std::string& text) const;
  void ApplyRules(std::string& text) const;
  bool FinishVolume(std::string& text) const;
  void ApplyVisibility(std::string& text) const;
  bool ApplyVolumeVisibility(std::string& text, Defines& variant) const;
  bool AddScattered(std::string& text) const;

  const ShaderLibrary& Shaders;
  const ForwardLight& Light;
};
}
