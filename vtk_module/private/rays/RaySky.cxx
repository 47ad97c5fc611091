// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/rays/RaySky.h"

#include "private/Matrices.h"
#include "private/rays/TexturePixels.h"

#include "ray_surface.h"

#include "vtkRenderer.h"
#include "vtkTexture.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace penumbra
{
namespace
{
// Finer tables cost memory and find hardly more.
constexpr int MostColumns = 1024;
constexpr int MostRows = 512;
// Finer pictures are averaged: two gigabytes of sky would light no differently.
constexpr int MostWidth = 8192;

struct Sphere
{
  int Width = 0;
  int Height = 0;
  std::vector<glm::vec4> Pixels;
};

Sphere Unfold(const TexturePixels& pixels)
{
  const int step = (std::max(pixels.Width, pixels.Height) + MostWidth - 1) / MostWidth;
  Sphere sphere{ pixels.Width / std::max(1, step), pixels.Height / std::max(1, step), {} };
  sphere.Pixels.reserve(static_cast<std::size_t>(sphere.Width) * sphere.Height);
  for (int y = 0; y < sphere.Height; ++y)
  {
    for (int x = 0; x < sphere.Width; ++x)
    {
      glm::vec4 sum(0.0f);
      for (int i = 0; i < step * step; ++i)
      {
        sum += glm::max(pixels.At(x * step + i % step, y * step + i / step), 0.0f);
      }
      sphere.Pixels.push_back(sum / static_cast<float>(step * step));
    }
  }
  return sphere;
}

/// A cube map's value in a direction, by OpenGL's rules for its faces.
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

Sphere Unfold(vtkTexture* cube, vtkRenderer* renderer)
{
  TexturePixels faces[6];
  Sphere sphere;
  for (int i = 0; i < 6; ++i)
  {
    faces[i] = ReadTexturePixels(cube, i);
    if (faces[i].Width == 0)
    {
      return sphere;
    }
  }
  // VTK turns the direction once more before it looks into a cube map.
  const glm::vec3 right(ToVec3(renderer->GetEnvironmentRight()));
  const glm::vec3 up(ToVec3(renderer->GetEnvironmentUp()));
  const glm::vec3 front = glm::cross(up, right);
  sphere.Width = std::min(4 * faces[0].Width, MostWidth);
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
      const glm::vec3 turned(glm::dot(d, right), glm::dot(d, up), glm::dot(d, front));
      sphere.Pixels.push_back(glm::max(Lookup(faces, turned), 0.0f));
    }
  }
  return sphere;
}
}

std::vector<float> MakeSkyTable(
  const std::vector<glm::vec4>& pixels, int width, int height, int columns, int rows)
{
  // What a cell sends is the sum of its pixels, by their share of the sphere; pixels as filtering
  // blends them with their neighbours, or the rim of a sun would be found too seldom.
  std::vector<double> cells(static_cast<std::size_t>(columns) * rows, 0.0);
  double total = 0.0;
  for (int y = 0; y < height; ++y)
  {
    const double share = std::cos(((y + 0.5) / height - 0.5) * glm::pi<double>());
    const auto row = static_cast<std::size_t>(static_cast<long long>(y) * rows / height);
    for (int x = 0; x < width; ++x)
    {
      double sent = 0.0;
      for (int i = 0; i < 9; ++i)
      {
        const int across = (x + i % 3 - 1 + width) % width;
        const int along = std::clamp(y + i / 3 - 1, 0, height - 1);
        const double weight = (2 - std::abs(i % 3 - 1)) * (2 - std::abs(i / 3 - 1)) / 16.0;
        const glm::vec4& p = pixels[static_cast<std::size_t>(along) * width + across];
        sent += weight * share * (0.2126 * p.r + 0.7152 * p.g + 0.0722 * p.b);
      }
      cells[row * columns +
        static_cast<std::size_t>(static_cast<long long>(x) * columns / width)] += sent;
      total += sent;
    }
  }
  // No direction may have no chance: float sums round what is faint to nothing.
  constexpr double even = 0.1;
  for (int row = 0; row < rows; ++row)
  {
    const double band = std::sin(((row + 1.0) / rows - 0.5) * glm::pi<double>()) -
      std::sin((static_cast<double>(row) / rows - 0.5) * glm::pi<double>());
    for (int column = 0; column < columns; ++column)
    {
      double& cell = cells[static_cast<std::size_t>(row) * columns + column];
      cell = even * 0.5 * band / columns + (total > 0.0 ? (1.0 - even) * cell / total : 0.0);
    }
  }
  const auto stride = static_cast<std::size_t>(std::max(columns, rows)) + 1;
  std::vector<float> table(stride * (static_cast<std::size_t>(rows) + 1), 1.0f);
  std::vector<double> bands;
  for (int row = 0; row < rows; ++row)
  {
    const double* cell = &cells[static_cast<std::size_t>(row) * columns];
    bands.push_back(std::accumulate(cell, cell + columns, 0.0));
    double sum = 0.0;
    for (int column = 0; column < columns; ++column)
    {
      table[row * stride + column] = static_cast<float>(sum / bands.back());
      sum += cell[column];
    }
  }
  const double all = std::accumulate(bands.begin(), bands.end(), 0.0);
  double sum = 0.0;
  for (int row = 0; row < rows; ++row)
  {
    table[rows * stride + row] = static_cast<float>(sum / all);
    sum += bands[static_cast<std::size_t>(row)];
  }
  return table;
}

void RaySky::Update(vtkRenderer* renderer)
{
  vtkTexture* texture =
    renderer->GetUseImageBasedLighting() ? renderer->GetEnvironmentTexture() : nullptr;
  if (!texture)
  {
    this->Release();
    return;
  }
  const glm::vec3 right(ToVec3(renderer->GetEnvironmentRight()));
  const glm::vec3 up(ToVec3(renderer->GetEnvironmentUp()));
  const glm::mat3 toSky = glm::transpose(glm::mat3(right, up, glm::cross(right, up)));
  const vtkMTimeType time = TextureTime(texture);
  if (texture == this->Source && time == this->Time && toSky == this->ToSky)
  {
    return;
  }
  this->ToSky = toSky;
  this->Source = texture;
  this->Time = time;
  const Sphere sphere =
    texture->GetCubeMap() ? Unfold(texture, renderer) : Unfold(ReadTexturePixels(texture));
  this->Radiance.reset();
  this->Table.reset();
  if (sphere.Width == 0)
  {
    return;
  }
  this->Radiance =
    std::make_unique<Texture>(TextureDesc{ GL_RGBA32F, sphere.Width, sphere.Height, 0 });
  this->Radiance->SetParameter(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  this->Radiance->SetParameter(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  this->Radiance->SetParameter(GL_TEXTURE_WRAP_S, GL_REPEAT);
  glBindTexture(GL_TEXTURE_2D, this->Radiance->Get());
  glTexSubImage2D(
    GL_TEXTURE_2D, 0, 0, 0, sphere.Width, sphere.Height, GL_RGBA, GL_FLOAT, sphere.Pixels.data());
  const int columns = std::min(sphere.Width, MostColumns);
  const int rows = std::min(sphere.Height, MostRows);
  const std::vector<float> table =
    MakeSkyTable(sphere.Pixels, sphere.Width, sphere.Height, columns, rows);
  const int stride = std::max(columns, rows) + 1;
  this->Cells = glm::ivec2(columns, rows);
  this->Table = std::make_unique<Texture>(TextureDesc{ GL_R32F, stride, rows + 1, 0 });
  glBindTexture(GL_TEXTURE_2D, this->Table->Get());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, stride, rows + 1, GL_RED, GL_FLOAT, table.data());
  glBindTexture(GL_TEXTURE_2D, 0);
}

void RaySky::Bind(const Program& program) const
{
  GLint active = 0; // VTK remembers it
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
  glActiveTexture(GL_TEXTURE0 + GI_RAY_SKY_UNIT);
  glBindTexture(GL_TEXTURE_2D, this->Radiance->Get());
  glActiveTexture(GL_TEXTURE0 + GI_RAY_SKY_TABLE_UNIT);
  glBindTexture(GL_TEXTURE_2D, this->Table->Get());
  glActiveTexture(static_cast<GLenum>(active));
  glUniformMatrix3fv(program.Location("sceneToSky"), 1, GL_FALSE, &this->ToSky[0][0]);
  glUniform2i(program.Location("skyCells"), this->Cells.x, this->Cells.y);
}

void RaySky::Release()
{
  this->Radiance.reset();
  this->Table.reset();
  this->Source = nullptr;
}
}
