// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The pixels of a vtkTexture as it uploads them.
 */
#pragma once

#include <glm/glm.hpp>

#include "vtkType.h"

#include <cstdint>
#include <vector>

class vtkTexture;

namespace penumbra
{
struct TexturePixels
{
  int Width = 0; ///< 0 if the texture has no readable pixels
  int Height = 0;
  /// The pixels, lowest row first, in one of the two: RGBA8, the first channel in the lowest bits, or floats.
  std::vector<std::uint32_t> Bytes;
  std::vector<glm::vec4> Floats;
  bool Srgb = false;
  bool Mapped = false;    ///< whether the pixels are colours of a lookup table
  bool EightBits = false; ///< whether the image has eight bits per component

  /// A pixel with linear rgb, and coverage.
  glm::vec4 At(int x, int y) const;
};

/// Read the pixels of a texture, after updating its input. face: face of a cube map.
TexturePixels ReadTexturePixels(vtkTexture* texture, int face = 0);

/// Whether shaders read values encoded for display from a texture: eight bits that nothing decodes.
bool HoldsDisplayValues(vtkTexture* texture);

/// Numbers of a texture's image with three or four components, without its lookup table; integers are scaled to [0, 1].
TexturePixels ReadPlainPixels(vtkTexture* texture);

/// Time of the last change of a texture or its image.
vtkMTimeType TextureTime(vtkTexture* texture);
}
