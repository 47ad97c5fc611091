// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A renderer's environment texture as radiance, over longitude and latitude, read as VTK's image-based light reads it.
 *
 * VTK reads the picture twice. Reflections are filtered from the texture, decoded by OpenGL where the texture says sRGB,
 * and by a power of 2.2 where SetEnvironmentTexture() was told so. Diffuse light comes from spherical harmonics by
 * default: these are summed up from the picture itself, without regard to either flag, and decode eight bits by a power
 * of 2.2 always. Otherwise, and with cube maps, it comes from the texture too.
 */
#pragma once

#include <glm/glm.hpp>

#include <vector>

class vtkRenderer;

namespace penumbra
{
/// What VTK decides on beside the texture's own flags.
struct SkyDecoding
{
  bool Harmonics = false;     ///< diffuse light by spherical harmonics
  bool MatteToLinear = false; ///< else: decoded by a power of 2.2 after the texture is
  bool GlossToLinear = false; ///< likewise for reflections

  static SkyDecoding Of(vtkRenderer* renderer);
  bool operator==(const SkyDecoding& other) const
  {
    return this->Harmonics == other.Harmonics && this->MatteToLinear == other.MatteToLinear &&
      this->GlossToLinear == other.GlossToLinear;
  }
};

struct SkyPictures
{
  int Width = 0; ///< 0 where there is no picture that can be read
  int Height = 0;
  std::vector<glm::vec4> Matte; ///< for diffuse reflection, from the lowest row on
  std::vector<glm::vec4> Gloss; ///< for highlights; empty where that is the same

  static SkyPictures Of(vtkRenderer* renderer, const SkyDecoding& decoding);
};
}
