// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/sh_probes/ProbeTextures.h"

#include "techniques/sh_probes/Harmonics.h"

#include "vtkGIProbeBaker.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
constexpr int LightTexels = GI_FIELD_HARMONICS;
constexpr int Inner = ProbeField::DistanceTexels;
constexpr int Outer = Inner + 2; // with the border

// Texture size that every OpenGL implementation with compute shaders supports.
constexpr int MaximumTexels = 16384;
static_assert(vtkGIProbeBaker::MostProbes == (MaximumTexels / Outer) * (MaximumTexels / Outer),
  "as many as fit");

void Fill(const Texture& texture, GLenum channels, const std::vector<float>& texels)
{
  glBindTexture(GL_TEXTURE_2D, texture.Get());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, texture.Desc().Width, texture.Desc().Height, channels,
    GL_FLOAT, texels.data());
  glBindTexture(GL_TEXTURE_2D, 0);
}

/// The inner texel that a texel of the map with its border shows: border texels repeat what lies across the fold.
glm::ivec2 SourceTexel(glm::ivec2 texel)
{
  texel -= 1;
  const bool acrossX = texel.x < 0 || texel.x >= Inner;
  const bool acrossY = texel.y < 0 || texel.y >= Inner;
  if (acrossX)
  {
    texel.y = Inner - 1 - texel.y;
  }
  if (acrossY)
  {
    texel.x = Inner - 1 - texel.x;
  }
  return glm::clamp(texel, glm::ivec2(0), glm::ivec2(Inner - 1));
}
}

ProbeTextures::ProbeTextures(const ProbeField& field, bool window)
  : Grids(field.Grids)
  , Columns(ProbeUniforms::Columns(field.Grids.Size()))
  , Rows(ProbeUniforms::Rows(field.Grids.Size(), this->Columns))
  , LightTexture({ GL_RGBA16F, this->Columns * LightTexels, this->Rows, 0 })
  , DistanceTexture({ GL_RG32F, this->Columns * Outer, this->Rows * Outer, 0 })
  , ProbeTexture({ GL_RGBA32F, this->Columns, this->Rows, 0 })
{
  this->FillLight(field, window);
  this->FillDistance(field);
  this->FillProbes(field);
}

void ProbeTextures::FillLight(const ProbeField& field, bool window)
{
  constexpr int n = ProbeField::Harmonics;
  const std::size_t width = static_cast<std::size_t>(this->Columns) * LightTexels * 4;
  std::vector<float> texels(width * this->Rows, 0.0f);
  std::vector<float> light = field.Light;
  double most = 0.0;
  for (int probe = 0; probe < this->Grids.Size(); ++probe)
  {
    float* colors = &light[static_cast<std::size_t>(probe) * n];
    ToIrradiance(colors);
    if (window)
    {
      WindowHarmonics(colors);
    }
    for (int k = 0; k < n; ++k)
    {
      most = std::max(most, static_cast<double>(std::abs(colors[k])));
    }
  }
  this->Scale = most > 0.0 ? most : 1.0;
  for (int probe = 0; probe < this->Grids.Size(); ++probe)
  {
    float* target = &texels[static_cast<std::size_t>(probe / this->Columns) * width +
      static_cast<std::size_t>(probe % this->Columns) * LightTexels * 4];
    for (int k = 0; k < n; ++k)
    {
      target[k] = static_cast<float>(light[static_cast<std::size_t>(probe) * n + k] / this->Scale);
    }
  }
  Fill(this->LightTexture, GL_RGBA, texels);
}

void ProbeTextures::FillDistance(const ProbeField& field)
{
  const std::size_t width = static_cast<std::size_t>(this->Columns) * Outer;
  std::vector<float> texels(2 * width * this->Rows * Outer, 0.0f);
  for (int probe = 0; probe < this->Grids.Size(); ++probe)
  {
    const auto reach = static_cast<float>(field.Reach(this->Grids.Of(probe)));
    const float* map = &field.Distance[static_cast<std::size_t>(probe) * ProbeField::Distances];
    const glm::ivec2 corner(probe % this->Columns * Outer, probe / this->Columns * Outer);
    for (int i = 0; i < Outer * Outer; ++i)
    {
      const glm::ivec2 texel(i % Outer, i / Outer);
      const glm::ivec2 from = SourceTexel(texel);
      const float mean = map[2 * (from.y * Inner + from.x)] * reach;
      const float deviation = map[2 * (from.y * Inner + from.x) + 1] * reach;
      const std::size_t index = 2 *
        (static_cast<std::size_t>(corner.y + texel.y) * width +
          static_cast<std::size_t>(corner.x + texel.x));
      texels[index] = mean;
      texels[index + 1] = mean * mean + deviation * deviation;
    }
  }
  this->DistanceTexture.SetParameter(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  this->DistanceTexture.SetParameter(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  Fill(this->DistanceTexture, GL_RG, texels);
}

void ProbeTextures::FillProbes(const ProbeField& field)
{
  std::vector<float> texels(static_cast<std::size_t>(this->Columns) * this->Rows * 4, 0.0f);
  for (int probe = 0; probe < this->Grids.Size(); ++probe)
  {
    const glm::dvec3& spacing = this->Grids.Get(this->Grids.Of(probe)).Spacing;
    const glm::vec3 offset(glm::dvec3(field.Offsets[probe]) * spacing);
    float* texel = &texels[static_cast<std::size_t>(probe) * 4];
    std::copy_n(&offset[0], 3, texel);
    texel[3] = static_cast<float>(field.Sight[probe]);
  }
  Fill(this->ProbeTexture, GL_RGBA, texels);
}

Arguments ProbeTextures::ShaderArguments(double bias, const glm::dvec3& origin) const
{
  return ProbeUniforms{ this->Grids, origin, bias }
    .ShaderArguments()
    .Sample("probeLight", &this->LightTexture)
    .Sample("fieldDistance", &this->DistanceTexture)
    .Sample("fieldProbes", &this->ProbeTexture)
    .Set("lightScale", this->Scale);
}
}
