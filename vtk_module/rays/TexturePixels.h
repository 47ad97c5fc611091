// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The pixels of a vtkTexture, as it brings them to the graphics card.
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
  int Width = 0; ///< 0 where the texture has no pixels that can be read
  int Height = 0;
  /// One of the two, from the lowest row on: RGBA8, the first channel in the lowest bits, or floats.
  std::vector<std::uint32_t> Bytes;
  std::vector<glm::vec4> Floats;
  bool Srgb = false;
  bool Mapped = false;    ///< colours of a lookup table, not the picture's numbers
  bool EightBits = false; ///< the picture has that many

  /// A pixel in linear values, rgb and coverage.
  glm::vec4 At(int x, int y) const;
};

/// Brings the texture's input up to date. face: of a cube map.
TexturePixels ReadTexturePixels(vtkTexture* texture, int face = 0);

/// Whether shaders read values for display from it: eight bits that nothing decodes.
bool HoldsDisplayValues(vtkTexture* texture);

/// The numbers of a texture's picture of three or four components, integers from 0 to 1, whatever its colours are.
TexturePixels ReadPlainPixels(vtkTexture* texture);

/// When a texture or what it shows changed last.
vtkMTimeType TextureTime(vtkTexture* texture);
}
