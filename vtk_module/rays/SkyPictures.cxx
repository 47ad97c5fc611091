// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/SkyPictures.h"

#include "base/Matrices.h"
#include "rays/TexturePixels.h"

#include "vtkOpenGLRenderer.h"
#include "vtkPBRIrradianceTexture.h"
#include "vtkPBRPrefilterTexture.h"
#include "vtkTexture.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// Larger images are reduced: two gigabytes of sky would not change the light.
constexpr int MaxWidth = 8192;

constexpr float ToLinear = 2.2f; // decoding exponent of VTK's image-based lighting

struct SphericalImage
{
  int Width = 0;
  int Height = 0;
  std::vector<glm::vec4> Pixels;
};

// Decodes each pixel by a power before averaging it with others.
SphericalImage Unfold(const TexturePixels& pixels, float power)
{
  const int step = (std::max(pixels.Width, pixels.Height) + MaxWidth - 1) / MaxWidth;
  SphericalImage sphere{ pixels.Width / std::max(1, step), pixels.Height / std::max(1, step), {} };
  sphere.Pixels.reserve(static_cast<std::size_t>(sphere.Width) * sphere.Height);
  for (int y = 0; y < sphere.Height; ++y)
  {
    for (int x = 0; x < sphere.Width; ++x)
    {
      glm::vec3 sum(0.0f);
      for (int i = 0; i < step * step; ++i)
      {
        const glm::vec3 value(glm::max(pixels.At(x * step + i % step, y * step + i / step), 0.0f));
        sum += power == 1.0f ? value : glm::pow(value, glm::vec3(power));
      }
      sphere.Pixels.emplace_back(sum / static_cast<float>(step * step), 1.0f);
    }
  }
  return sphere;
}

/// Value of a cube map in a direction, by OpenGL's rules for its faces.
glm::vec4 Lookup(const TexturePixels (&faces)[6], const glm::vec3& d)
{
  const glm::vec3 size = glm::abs(d);
  int face = 0;
  glm::vec2 p;
  float major = size.x;
  if (size.x >= size.y && size.x >= size.z)
  {
    face = d.x > 0.0f ? 0 : 1;
    p = glm::vec2(d.x > 0.0f ? -d.z : d.z, -d.y);
  }
  else if (size.y >= size.z)
  {
    major = size.y;
    face = d.y > 0.0f ? 2 : 3;
    p = glm::vec2(d.x, d.y > 0.0f ? d.z : -d.z);
  }
  else
  {
    major = size.z;
    face = d.z > 0.0f ? 4 : 5;
    p = glm::vec2(d.z > 0.0f ? d.x : -d.x, -d.y);
  }
  const TexturePixels& pixels = faces[face];
  const glm::vec2 place = (p / major * 0.5f + 0.5f) * glm::vec2(pixels.Width, pixels.Height);
  return pixels.At(std::clamp(static_cast<int>(place.x), 0, pixels.Width - 1),
    std::clamp(static_cast<int>(place.y), 0, pixels.Height - 1));
}

SphericalImage Unfold(vtkTexture* cube, vtkRenderer* renderer, float power)
{
  TexturePixels faces[6];
  SphericalImage sphere;
  for (int i = 0; i < 6; ++i)
  {
    faces[i] = ReadTexturePixels(cube, i);
    if (faces[i].Width == 0)
    {
      return sphere;
    }
  }
  // VTK rotates the direction again before it looks it up in a cube map.
  const glm::vec3 right(ToVec3(renderer->GetEnvironmentRight()));
  const glm::vec3 up(ToVec3(renderer->GetEnvironmentUp()));
  const glm::vec3 front = glm::cross(up, right);
  sphere.Width = std::min(4 * faces[0].Width, MaxWidth);
  sphere.Height = sphere.Width / 2;
  for (int y = 0; y < sphere.Height; ++y)
  {
    const float latitude =
      ((y + 0.5f) / static_cast<float>(sphere.Height) - 0.5f) * glm::pi<float>();
    for (int x = 0; x < sphere.Width; ++x)
    {
      const float longitude =
        ((x + 0.5f) / static_cast<float>(sphere.Width) - 0.5f) * glm::two_pi<float>();
      const glm::vec3 d(std::cos(latitude) * std::cos(longitude), std::sin(latitude),
        std::cos(latitude) * std::sin(longitude));
      const glm::vec3 rotated(glm::dot(d, right), glm::dot(d, up), glm::dot(d, front));
      const glm::vec3 value(glm::max(Lookup(faces, rotated), 0.0f));
      sphere.Pixels.emplace_back(power == 1.0f ? value : glm::pow(value, glm::vec3(power)), 1.0f);
    }
  }
  return sphere;
}

// The image as vtkSphericalHarmonics reads it: its own numbers, never the colours of a lookup table.
SphericalImage UnfoldPlain(vtkTexture* texture, const TexturePixels& texturePixels)
{
  TexturePixels plain = texturePixels.Mapped ? ReadPlainPixels(texture) : texturePixels;
  plain.Srgb = false;
  return Unfold(plain, plain.EightBits ? ToLinear : 1.0f);
}

// VTK has spherical harmonics since 9.1.
template <typename Renderer>
auto UsesHarmonics(Renderer* renderer, int) -> decltype(renderer->GetUseSphericalHarmonics())
{
  return renderer->GetUseSphericalHarmonics();
}
template <typename Renderer>
bool UsesHarmonics(Renderer*, long)
{
  return false;
}
}

SkyDecoding SkyDecoding::Of(vtkRenderer* renderer)
{
  SkyDecoding decoding;
  auto* glRenderer = vtkOpenGLRenderer::SafeDownCast(renderer);
  vtkTexture* texture = renderer->GetEnvironmentTexture();
  if (glRenderer && texture)
  {
    decoding.Harmonics = UsesHarmonics(glRenderer, 0) && !texture->GetCubeMap();
    decoding.MatteToLinear =
      !decoding.Harmonics && glRenderer->GetEnvMapIrradiance()->GetConvertToLinear();
    decoding.GlossToLinear = glRenderer->GetEnvMapPrefiltered()->GetConvertToLinear();
  }
  return decoding;
}

SkyPictures SkyPictures::Of(vtkRenderer* renderer, const SkyDecoding& decoding)
{
  const auto power = [](bool decoded) { return decoded ? ToLinear : 1.0f; };
  vtkTexture* texture = renderer->GetEnvironmentTexture();
  const float gloss = power(decoding.GlossToLinear);
  const float matte = power(decoding.MatteToLinear);
  SphericalImage specular;
  SphericalImage diffuse;
  bool differ = false;
  if (texture->GetCubeMap())
  {
    differ = gloss != matte;
    diffuse = Unfold(texture, renderer, matte);
    specular = differ ? Unfold(texture, renderer, gloss) : SphericalImage();
  }
  else
  {
    const TexturePixels texturePixels = ReadTexturePixels(texture);
    const bool plain = decoding.Harmonics && texturePixels.Width > 0;
    differ =
      plain ? texturePixels.Mapped || texturePixels.EightBits || gloss != 1.0f : gloss != matte;
    diffuse = plain ? UnfoldPlain(texture, texturePixels) : Unfold(texturePixels, matte);
    specular = differ ? Unfold(texturePixels, gloss) : SphericalImage();
  }
  SkyPictures sky{ diffuse.Width, diffuse.Height, std::move(diffuse.Pixels), {} };
  // With a lookup table the texture may be readable although VTK's harmonics cannot read the image.
  if (differ && specular.Pixels.size() == sky.Matte.size() && specular.Pixels != sky.Matte)
  {
    sky.Gloss = std::move(specular.Pixels);
  }
  return sky;
}
}
