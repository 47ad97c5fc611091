// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/sky_light/SkyDirections.h"

#include "base/Luminance.h"
#include "base/Matrices.h"
#include "rays/RaySky.h"
#include "rays/TexturePixels.h"

#include "vtkRenderer.h"
#include "vtkTexture.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// Finer tables cost memory and hardly improve the sampling.
constexpr int MaxColumns = 1024;
constexpr int MaxRows = 512;
// Share of the directions that are drawn evenly from the whole sphere. With more of them, a small sun gets too few maps;
// with fewer, directions have too large weights once the sky has turned.
constexpr double UniformShare = 0.3;
// Rows and columns of the cells of equal solid angle that are summed up for the unoccluded light.
constexpr int OpenCells = 64;

std::uint32_t ReverseBits(std::uint32_t v)
{
  std::uint32_t result = 0;
  for (int bit = 0; bit < 32; ++bit, v >>= 1)
  {
    result = result << 1 | (v & 1u);
  }
  return result;
}

// The second dimension of Sobol's sequence, as in lib/sequence.glsl; the first is the reversed index.
std::uint32_t SobolSecond(std::uint32_t index)
{
  std::uint32_t result = 0;
  for (std::uint32_t v = 0x80000000u; index != 0; index >>= 1, v ^= v >> 1)
  {
    result ^= (index & 1u) != 0 ? v : 0u;
  }
  return result;
}

// Point of the sequence, shifted digitally so that no point lies at the edge of a stratum.
glm::dvec2 SobolPoint(std::uint32_t index)
{
  constexpr double unit = 1.0 / 4294967296.0;
  return { (ReverseBits(index) ^ 0x5bd1e995u) * unit, (SobolSecond(index) ^ 0x27d4eb2fu) * unit };
}

// Decode octahedral coordinates in [0, 1]. Those beyond continue across the fold, so that a border can be filled.
glm::dvec3 DecodeOctahedral(const glm::dvec2& e)
{
  const glm::dvec2 p = 2.0 * e - 1.0;
  glm::dvec3 n(p, 1.0 - std::abs(p.x) - std::abs(p.y));
  const double fold = std::max(-n.z, 0.0);
  n.x += n.x >= 0.0 ? -fold : fold;
  n.y += n.y >= 0.0 ? -fold : fold;
  return glm::normalize(n);
}

double BandArea(int row, int rows)
{
  return std::sin(((row + 1.0) / rows - 0.5) * glm::pi<double>()) -
    std::sin((static_cast<double>(row) / rows - 0.5) * glm::pi<double>());
}
}

bool SkyDirections::Update(vtkRenderer* renderer)
{
  vtkTexture* texture =
    renderer->GetUseImageBasedLighting() ? renderer->GetEnvironmentTexture() : nullptr;
  const bool shone = this->Shines();
  if (!texture)
  {
    *this = SkyDirections();
    return shone;
  }
  const glm::vec3 right(ToVec3(renderer->GetEnvironmentRight()));
  const glm::vec3 up(ToVec3(renderer->GetEnvironmentUp()));
  const glm::mat3 toSky = glm::transpose(glm::mat3(right, up, glm::cross(right, up)));
  const vtkMTimeType time = TextureTime(texture);
  const SkyDecoding decoding = SkyDecoding::Of(renderer);
  const bool turned = toSky != this->SkyFromWorld;
  this->SkyFromWorld = toSky;
  if (texture == this->Source && time == this->Time && decoding == this->Decoding)
  {
    return turned && shone;
  }
  this->Source = texture;
  this->Time = time;
  this->Decoding = decoding;
  this->Open.reset();
  const SkyPictures sky = SkyPictures::Of(renderer, decoding);
  if (sky.Width > 0)
  {
    this->Build(sky);
    this->BuildOpenLight(sky);
  }
  return true;
}

void SkyDirections::Build(const SkyPictures& sky)
{
  this->Columns = std::min(sky.Width, MaxColumns);
  this->Rows = std::min(sky.Height, MaxRows);
  const std::size_t count = static_cast<std::size_t>(this->Columns) * this->Rows;
  std::vector<glm::dvec4> sums(count, glm::dvec4(0.0));
  for (int y = 0; y < sky.Height; ++y)
  {
    const double share = BandArea(y, sky.Height);
    const auto row = static_cast<std::size_t>(static_cast<long long>(y) * this->Rows / sky.Height);
    for (int x = 0; x < sky.Width; ++x)
    {
      const auto column =
        static_cast<std::size_t>(static_cast<long long>(x) * this->Columns / sky.Width);
      const glm::vec4& pixel = sky.Matte[static_cast<std::size_t>(y) * sky.Width + x];
      sums[row * this->Columns + column] += share * glm::dvec4(glm::dvec3(pixel), 1.0);
    }
  }
  double total = 0.0; // luminance times solid angle
  for (const glm::dvec4& sum : sums)
  {
    total += Luminance(sum.x, sum.y, sum.z);
  }
  this->Cells.resize(count);
  this->Densities.resize(count);
  this->ColumnSums.resize(count);
  this->RowSums.clear();
  double all = 0.0;
  for (int row = 0; row < this->Rows; ++row)
  {
    const double area = BandArea(row, this->Rows) / this->Columns;
    double sum = 0.0;
    for (int column = 0; column < this->Columns; ++column)
    {
      const std::size_t i = static_cast<std::size_t>(row) * this->Columns + column;
      const glm::dvec4& cell = sums[i];
      this->Cells[i] = glm::vec3(glm::dvec3(cell) / std::max(cell.w, 1e-30));
      const double even = 0.5 * area;
      const double probability = total > 0.0
        ? UniformShare * even + (1.0 - UniformShare) * Luminance(cell.x, cell.y, cell.z) / total
        : even;
      this->Densities[i] = probability / (2.0 * glm::pi<double>() * area);
      sum += probability;
      this->ColumnSums[i] = sum;
    }
    for (int column = 0; column < this->Columns; ++column)
    {
      this->ColumnSums[static_cast<std::size_t>(row) * this->Columns + column] /= sum;
    }
    all += sum;
    this->RowSums.push_back(all);
  }
  for (double& sum : this->RowSums)
  {
    sum /= all;
  }
}

void SkyDirections::BuildOpenLight(const SkyPictures& sky)
{
  const EqualCells cells = EqualCells::Of(sky.Matte, sky.Width, sky.Height, OpenCells, OpenCells);
  std::vector<glm::dvec3> directions;
  for (int row = 0; row < OpenCells; ++row)
  {
    const double height = 2.0 * (row + 0.5) / OpenCells - 1.0;
    const double radius = std::sqrt(1.0 - height * height);
    for (int column = 0; column < OpenCells; ++column)
    {
      const double longitude = ((column + 0.5) / OpenCells - 0.5) * 2.0 * glm::pi<double>();
      directions.emplace_back(radius * std::cos(longitude), height, radius * std::sin(longitude));
    }
  }
  constexpr int width = OpenTexels + 2;
  std::vector<glm::vec4> texels;
  for (int y = 0; y < width; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const glm::dvec3 normal =
        DecodeOctahedral((glm::dvec2(x, y) - 0.5) / static_cast<double>(OpenTexels));
      glm::dvec3 light(0.0);
      double weights = 0.0; // of a uniform sky, for which the result is exact
      for (std::size_t i = 0; i < directions.size(); ++i)
      {
        const double cosine = std::max(0.0, glm::dot(normal, directions[i]));
        light += cosine * glm::dvec3(cells.Values[i]);
        weights += cosine;
      }
      light /= weights;
      texels.emplace_back(
        glm::vec3(light), static_cast<float>(Luminance(light.x, light.y, light.z)));
    }
  }
  this->Open = std::make_unique<Texture>(TextureDesc{ GL_RGBA32F, width, width, 0 });
  this->Open->SetParameter(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  this->Open->SetParameter(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glBindTexture(GL_TEXTURE_2D, this->Open->Get());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, width, GL_RGBA, GL_FLOAT, texels.data());
  glBindTexture(GL_TEXTURE_2D, 0);
}

SkyDirections::Sample SkyDirections::Draw(unsigned int index) const
{
  const auto within = [](double u, double begin, double end) {
    return std::clamp((u - begin) / std::max(end - begin, 1e-30), 0.0, 1.0);
  };
  const glm::dvec2 u = SobolPoint(index);
  const auto band = std::lower_bound(this->RowSums.begin(), this->RowSums.end() - 1, u.y);
  const auto row = static_cast<std::size_t>(band - this->RowSums.begin());
  const auto first = this->ColumnSums.begin() + static_cast<std::ptrdiff_t>(row * this->Columns);
  const auto place = std::lower_bound(first, first + this->Columns - 1, u.x);
  const auto column = static_cast<std::size_t>(place - first);
  const double along = within(u.y, row > 0 ? this->RowSums[row - 1] : 0.0, *band);
  const double across = within(u.x, column > 0 ? *(place - 1) : 0.0, *place);
  const double longitude = ((column + across) / this->Columns - 0.5) * 2.0 * glm::pi<double>();
  const double low = std::sin((static_cast<double>(row) / this->Rows - 0.5) * glm::pi<double>());
  const double height =
    std::clamp(low + along * BandArea(static_cast<int>(row), this->Rows), -1.0, 1.0);
  const double radius = std::sqrt(1.0 - height * height);
  const glm::dvec3 inSky(radius * std::cos(longitude), height, radius * std::sin(longitude));
  return { glm::normalize(glm::transpose(glm::dmat3(this->SkyFromWorld)) * inSky),
    this->Densities[row * this->Columns + column] };
}

glm::dvec3 SkyDirections::Radiance(const glm::dvec3& toward) const
{
  return glm::dvec3(this->Cells[this->CellOf(glm::dmat3(this->SkyFromWorld) * toward)]);
}

int SkyDirections::CellOf(const glm::dvec3& inSky) const
{
  const double longitude = std::atan2(inSky.z, inSky.x) / (2.0 * glm::pi<double>()) + 0.5;
  const double latitude = std::asin(std::clamp(inSky.y, -1.0, 1.0)) / glm::pi<double>() + 0.5;
  const int column = std::clamp(static_cast<int>(longitude * this->Columns), 0, this->Columns - 1);
  const int row = std::clamp(static_cast<int>(latitude * this->Rows), 0, this->Rows - 1);
  return row * this->Columns + column;
}
}
