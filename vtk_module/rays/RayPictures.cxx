// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/RayPictures.h"

#include "rays/TexturePixels.h"

#include "ray_surface.h"

#include "vtkTexture.h"

#include <cstring>
#include <vector>

namespace penumbra
{
namespace
{
constexpr std::size_t HeadTexels = 2;

std::vector<glm::uvec4> Encode(vtkTexture* texture, const TexturePixels& pixels)
{
  const std::size_t body = pixels.Floats.size() + (pixels.Bytes.size() + 3) / 4;
  std::vector<glm::uvec4> texels(HeadTexels + body, glm::uvec4(0));
  std::uint32_t flags = static_cast<std::uint32_t>(texture->GetWrap()) << GI_PICTURE_WRAP_SHIFT;
  flags |= pixels.Floats.empty() ? 0 : GI_PICTURE_FLOATS;
  flags |= texture->GetInterpolate() ? 0 : GI_PICTURE_NEAREST;
  flags |= pixels.Srgb ? GI_PICTURE_SRGB : 0;
  texels[0] = glm::uvec4(pixels.Width, pixels.Height, flags, 0);
  std::memcpy(&texels[1], texture->GetBorderColor(), sizeof(texels[1]));
  std::memcpy(
    &texels[HeadTexels], pixels.Floats.data(), pixels.Floats.size() * sizeof(pixels.Floats[0]));
  std::memcpy(
    &texels[HeadTexels], pixels.Bytes.data(), pixels.Bytes.size() * sizeof(pixels.Bytes[0]));
  return texels;
}
}

const RayPictures::Picture& RayPictures::Use(vtkTexture* texture)
{
  Entry& entry = this->Entries[texture];
  entry.Used = true;
  const vtkMTimeType time = TextureTime(texture);
  if (entry.Time != time)
  {
    this->Forget(entry);
    const TexturePixels pixels = ReadTexturePixels(texture);
    if (pixels.Width > 0 && !texture->GetCubeMap())
    {
      const std::vector<glm::uvec4> texels = Encode(texture, pixels);
      const std::size_t first = this->Texels.Allocate(texels.size()); // may throw
      this->Texels.Write(first, texels.data(), texels.size());
      entry.Texels = texels.size();
      entry.Image.First = static_cast<int>(first);
      this->Measure(pixels, entry.Image);
    }
    entry.Time = time;
  }
  return entry.Image;
}

void RayPictures::Measure(const TexturePixels& pixels, Picture& image)
{
  glm::dvec3 sum(0.0);
  for (int y = 0; y < pixels.Height; ++y)
  {
    for (int x = 0; x < pixels.Width; ++x)
    {
      const glm::vec4 value = pixels.At(x, y);
      sum += glm::dvec3(value);
      image.Partly |= value.a < 1.0f;
    }
  }
  image.Mean = glm::vec3(sum / (static_cast<double>(pixels.Width) * pixels.Height));
}

void RayPictures::Forget(Entry& entry)
{
  if (entry.Texels > 0)
  {
    this->Texels.Free(static_cast<std::size_t>(entry.Image.First), entry.Texels);
  }
  entry.Texels = 0;
  entry.Time = 0;
  entry.Image = Picture();
}

void RayPictures::Sweep()
{
  for (auto it = this->Entries.begin(); it != this->Entries.end();)
  {
    if (!it->second.Used)
    {
      this->Forget(it->second);
      it = this->Entries.erase(it);
      continue;
    }
    it->second.Used = false;
    ++it;
  }
}

void RayPictures::AddTo(Arguments& arguments) const
{
  this->Texels.AddSampler(arguments, "rayPictures");
}

void RayPictures::Release()
{
  this->Entries.clear();
  this->Texels.Release();
}
}
