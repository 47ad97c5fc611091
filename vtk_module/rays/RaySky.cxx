// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/RaySky.h"

#include "base/Luminance.h"
#include "base/Matrices.h"
#include "rays/SkyPictures.h"
#include "rays/TexturePixels.h"

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
// Finer tables cost memory and hardly improve the sampling.
constexpr int MaxColumns = 1024;
constexpr int MaxRows = 512;
// Number of rows and of columns of the cells of equal solid angle; a power of two.
constexpr int FineCells = 128;
}

std::vector<float> MakeSkyTable(
  const std::vector<glm::vec4>& pixels, int width, int height, int columns, int rows)
{
  // The weight of a cell is the sum of its pixels times their solid angles. Pixels are blended with their neighbours as
  // by texture filtering; otherwise the rim of a sun would be sampled too rarely.
  std::vector<double> cells(static_cast<std::size_t>(columns) * rows, 0.0);
  double total = 0.0;
  for (int y = 0; y < height; ++y)
  {
    const double share = std::cos(((y + 0.5) / height - 0.5) * glm::pi<double>());
    const auto row = static_cast<std::size_t>(static_cast<long long>(y) * rows / height);
    for (int x = 0; x < width; ++x)
    {
      double radiance = 0.0;
      for (int i = 0; i < 9; ++i)
      {
        const int across = (x + i % 3 - 1 + width) % width;
        const int along = std::clamp(y + i / 3 - 1, 0, height - 1);
        const double weight = (2 - std::abs(i % 3 - 1)) * (2 - std::abs(i / 3 - 1)) / 16.0;
        const glm::vec4& p = pixels[static_cast<std::size_t>(along) * width + across];
        radiance += weight * share * Luminance(p.r, p.g, p.b);
      }
      cells[row * columns +
        static_cast<std::size_t>(static_cast<long long>(x) * columns / width)] += radiance;
      total += radiance;
    }
  }
  // No direction may have zero probability, but float sums round small contributions to nothing.
  constexpr double uniformShare = 0.1;
  for (int row = 0; row < rows; ++row)
  {
    const double bandArea = std::sin(((row + 1.0) / rows - 0.5) * glm::pi<double>()) -
      std::sin((static_cast<double>(row) / rows - 0.5) * glm::pi<double>());
    for (int column = 0; column < columns; ++column)
    {
      double& cell = cells[static_cast<std::size_t>(row) * columns + column];
      cell = uniformShare * 0.5 * bandArea / columns +
        (total > 0.0 ? (1.0 - uniformShare) * cell / total : 0.0);
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

EqualCells EqualCells::Of(
  const std::vector<glm::vec4>& pixels, int width, int height, int columns, int rows)
{
  EqualCells cells{ columns, rows, {} };
  cells.Values.assign(static_cast<std::size_t>(columns) * rows, glm::vec4(0.0f));
  // Subdivide pixels that are larger than cells. Near the poles many rows of pixels fall into one row of cells.
  const int across = (4 * columns + width - 1) / width;
  const int along = (4 * rows + height - 1) / height;
  const int steps = along * height;
  std::vector<double> weights(static_cast<std::size_t>(rows), 0.0);
  for (int step = 0; step < steps; ++step)
  {
    const double low = std::sin((static_cast<double>(step) / steps - 0.5) * glm::pi<double>());
    const double high = std::sin((step + 1.0) / steps * glm::pi<double>() - glm::half_pi<double>());
    const int row = std::min(static_cast<int>(0.25 * (low + high + 2.0) * rows), rows - 1);
    weights[static_cast<std::size_t>(row)] += (high - low) * across * width / columns;
    const glm::vec4* line = &pixels[static_cast<std::size_t>(step / along) * width];
    for (int x = 0; x < across * width; ++x)
    {
      const auto column = static_cast<std::size_t>(
        static_cast<long long>(x) * columns / (static_cast<long long>(across) * width));
      cells.Values[static_cast<std::size_t>(row) * columns + column] +=
        static_cast<float>(high - low) * line[x / across];
    }
  }
  for (std::size_t i = 0; i < cells.Values.size(); ++i)
  {
    const double weight = weights[i / static_cast<std::size_t>(columns)];
    cells.Values[i] /= static_cast<float>(std::max(weight, 1e-30));
  }
  return cells;
}

EqualCells EqualCells::Coarser(int columns, int rows) const
{
  EqualCells cells{ columns, rows, {} };
  cells.Values.assign(static_cast<std::size_t>(columns) * rows, glm::vec4(0.0f));
  const int across = this->Columns / columns;
  const int along = this->Rows / rows;
  for (int y = 0; y < along * rows; ++y)
  {
    for (int x = 0; x < across * columns; ++x)
    {
      cells.Values[static_cast<std::size_t>(y / along) * columns + x / across] +=
        this->Values[static_cast<std::size_t>(y) * this->Columns + x] /
        static_cast<float>(across * along);
    }
  }
  return cells;
}

namespace
{
vtkTexture* SkyTexture(vtkRenderer* renderer)
{
  return renderer->GetUseImageBasedLighting() ? renderer->GetEnvironmentTexture() : nullptr;
}

glm::dmat3 WorldToSky(vtkRenderer* renderer)
{
  const glm::dvec3 right = ToVec3(renderer->GetEnvironmentRight());
  const glm::dvec3 up = ToVec3(renderer->GetEnvironmentUp());
  return glm::transpose(glm::dmat3(right, up, glm::cross(right, up)));
}
}

glm::dvec3 OpenSkyLight(vtkRenderer* renderer, const glm::dvec3& normal)
{
  glm::dvec3 sum(0.0);
  if (!SkyTexture(renderer))
  {
    return sum;
  }
  const SkyPictures sky = SkyPictures::Of(renderer, SkyDecoding::Of(renderer));
  const glm::dvec3 n = WorldToSky(renderer) * normal;
  for (int y = 0; y < sky.Height; ++y)
  {
    const double latitude = ((y + 0.5) / sky.Height - 0.5) * glm::pi<double>();
    for (int x = 0; x < sky.Width; ++x)
    {
      const double longitude = ((x + 0.5) / sky.Width - 0.5) * glm::two_pi<double>();
      const double cosine =
        std::cos(latitude) * (n.x * std::cos(longitude) + n.z * std::sin(longitude)) +
        n.y * std::sin(latitude);
      const std::size_t at = static_cast<std::size_t>(y) * sky.Width + x;
      sum += std::max(cosine, 0.0) * std::cos(latitude) * glm::dvec3(sky.Matte[at]);
    }
  }
  return sky.Width > 0 ? sum * (glm::two_pi<double>() / sky.Width / sky.Height) : sum;
}

void RaySky::Update(vtkRenderer* renderer)
{
  vtkTexture* texture = SkyTexture(renderer);
  if (!texture)
  {
    this->Release();
    return;
  }
  const glm::mat3 toSky(WorldToSky(renderer));
  const vtkMTimeType time = TextureTime(texture);
  const SkyDecoding decoding = SkyDecoding::Of(renderer);
  if (texture == this->Source && time == this->Time && toSky == this->ToSky &&
    decoding == this->Decoding)
  {
    return;
  }
  this->ToSky = toSky;
  this->Source = texture;
  this->Time = time;
  this->Decoding = decoding;
  this->Radiance.reset();
  this->Table.reset();
  this->Means.reset();
  const SkyPictures sky = SkyPictures::Of(renderer, decoding);
  if (sky.Width == 0)
  {
    return;
  }
  const int layers = sky.Gloss.empty() ? 1 : 2;
  this->Radiance =
    std::make_unique<Texture>(TextureDesc{ GL_RGBA32F, sky.Width, sky.Height, layers });
  this->Radiance->SetParameter(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  this->Radiance->SetParameter(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  this->Radiance->SetParameter(GL_TEXTURE_WRAP_S, GL_REPEAT);
  glBindTexture(GL_TEXTURE_2D_ARRAY, this->Radiance->Get());
  for (int layer = 0; layer < layers; ++layer)
  {
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, layer, sky.Width, sky.Height, 1, GL_RGBA,
      GL_FLOAT, (layer == 0 ? sky.Matte : sky.Gloss).data());
  }
  glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
  const int columns = std::min(sky.Width, MaxColumns);
  const int rows = std::min(sky.Height, MaxRows);
  const std::vector<float> table = MakeSkyTable(sky.Matte, sky.Width, sky.Height, columns, rows);
  this->Fine = EqualCells::Of(sky.Matte, sky.Width, sky.Height, FineCells, FineCells);
  const int stride = std::max(columns, rows) + 1;
  this->Cells = glm::ivec2(columns, rows);
  this->Table = std::make_unique<Texture>(TextureDesc{ GL_R32F, stride, rows + 1, 0 });
  glBindTexture(GL_TEXTURE_2D, this->Table->Get());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, stride, rows + 1, GL_RED, GL_FLOAT, table.data());
  glBindTexture(GL_TEXTURE_2D, 0);
}

void RaySky::AddTo(Arguments& arguments) const
{
  arguments.Sample("raySky", this->Radiance.get())
    .Sample("raySkyTable", this->Table.get())
    .Set("sceneToSky", this->ToSky)
    .Set("skyCells", this->Cells);
}

void RaySky::AddCells(Arguments& arguments, int rays)
{
  if (!this->Means || this->MeansRays != rays)
  {
    // One cell per ray, which filtering spreads over four. With fewer cells light is blurred; with more, rays miss some
    // of it.
    int rows = 2;
    int columns = 2;
    while (columns * rows < rays && rows < FineCells)
    {
      (columns > rows ? rows : columns) *= 2;
    }
    const EqualCells means = this->Fine.Coarser(columns, rows);
    this->MeansRays = rays;
    this->Means =
      std::make_unique<Texture>(TextureDesc{ GL_RGBA32F, means.Columns, means.Rows, 0 });
    this->Means->SetParameter(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    this->Means->SetParameter(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    this->Means->SetParameter(GL_TEXTURE_WRAP_S, GL_REPEAT);
    glBindTexture(GL_TEXTURE_2D, this->Means->Get());
    glTexSubImage2D(
      GL_TEXTURE_2D, 0, 0, 0, means.Columns, means.Rows, GL_RGBA, GL_FLOAT, means.Values.data());
    glBindTexture(GL_TEXTURE_2D, 0);
  }
  arguments.Sample("raySkyCells", this->Means.get());
}

void RaySky::Release()
{
  this->Means.reset();
  this->Radiance.reset();
  this->Table.reset();
  this->Source = nullptr;
}
}
