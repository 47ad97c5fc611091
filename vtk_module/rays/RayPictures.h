// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The pictures on surfaces, in one buffer from which shaders filter them (rays/pictures.glsl): there
 * may be more of them than a shader can have textures.
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
    int First = -1;         ///< texel where it begins; -1 where there are no pixels to read
    bool Partly = false;    ///< some of it is not opaque
    glm::vec3 Mean{ 1.0f }; ///< linear
  };

  /// A texture's picture, brought up to date. Throws std::runtime_error where it does not fit.
  const Picture& Use(vtkTexture* texture);

  /// Forget the pictures that were not used since the last call.
  void Sweep();
  bool IsEmpty() const { return this->Entries.empty(); }
  void AddTo(Arguments& arguments) const;
  void Release();

private:
  struct Entry
  {
    Picture Shown;
    std::size_t Texels = 0;
    vtkMTimeType Time = 0;
    bool Used = false;
  };
  static void Measure(const TexturePixels& pixels, Picture& shown);
  void Forget(Entry& entry);

  std::map<vtkTexture*, Entry> Entries;
  RayBuffer Texels{ "pictures on surfaces", 1 };
};
}
