// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Images on surfaces, in one buffer from which shaders filter them (rays/pictures.glsl). There
 * may be more images than a shader can have textures.
 */
#pragma once

#include "rays/RayBuffer.h"

#include <glm/glm.hpp>

#include "vtkType.h"

#include <map>

class vtkTexture;

namespace penumbra
{
struct TexturePixels;

class RayPictures
{
public:
  struct Picture
  {
    int First = -1;         ///< its first texel; -1 if there are no readable pixels
    bool Partly = false;    ///< whether some pixels are not opaque
    glm::vec3 Mean{ 1.0f }; ///< linear
  };

  /// Bring a texture's image up to date and return it. Throws std::runtime_error if it does not fit.
  const Picture& Use(vtkTexture* texture);

  /// Delete the images that were not used since the last call.
  void Sweep();
  bool IsEmpty() const { return this->Entries.empty(); }
  void AddTo(Arguments& arguments) const;
  void Release();

private:
  struct Entry
  {
    Picture Image;
    std::size_t Texels = 0;
    vtkMTimeType Time = 0;
    bool Used = false;
  };
  static void Measure(const TexturePixels& pixels, Picture& image);
  void Forget(Entry& entry);

  std::map<vtkTexture*, Entry> Entries;
  RayBuffer Texels{ "pictures on surfaces", 1 };
};
}
