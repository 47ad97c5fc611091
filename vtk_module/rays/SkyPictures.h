// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A renderer's environment texture as equirectangular images of radiance, read as VTK's image-based lighting reads it.
 *
 * VTK reads the image twice. Reflections are filtered from the texture, which OpenGL decodes if the texture is sRGB,
 * and VTK by a power of 2.2 if SetEnvironmentTexture() was told so. Diffuse light comes from spherical harmonics by
 * default. They are computed from the image itself, regardless of both flags, and images of eight bits are always
 * decoded by a power of 2.2. Without harmonics, and with cube maps, diffuse light comes from the texture too.
 */
#pragma once

#include <glm/glm.hpp>

#include <vector>

class vtkRenderer;

namespace penumbra
{
/// VTK's decoding in addition to the texture's own flags.
struct SkyDecoding
{
  bool Harmonics = false;     ///< diffuse light comes from spherical harmonics
  bool MatteToLinear = false; ///< else: diffuse light is decoded by a power of 2.2
  bool GlossToLinear = false; ///< reflections are decoded by a power of 2.2

  static SkyDecoding Of(vtkRenderer* renderer);
  bool operator==(const SkyDecoding& other) const
  {
    return this->Harmonics == other.Harmonics && this->MatteToLinear == other.MatteToLinear &&
      this->GlossToLinear == other.GlossToLinear;
  }
};

struct SkyPictures
{
  int Width = 0; ///< 0 if no image can be read
  int Height = 0;
  std::vector<glm::vec4> Matte; ///< for diffuse reflection, lowest row first
  std::vector<glm::vec4> Gloss; ///< for highlights; empty if it is the same

  static SkyPictures Of(vtkRenderer* renderer, const SkyDecoding& decoding);
};
}
