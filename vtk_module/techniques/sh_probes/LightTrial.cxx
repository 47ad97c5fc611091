// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/sh_probes/LightTrial.h"

#include "bake/GatherStage.h"
#include "techniques/sh_probes/ProbePlacement.h"
#include "techniques/sh_probes/ProbeTextures.h"

#include "vtkGISHProbes.h"

#include "vtkNew.h"

#include "gathering.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace penumbra
{
namespace
{
constexpr int Lines = 1 << 17; // traced through the scene to find points on surfaces
constexpr int LineNumbers = GI_SURFACE_NUMBERS;

// Numbers of paths in each of two independent halves. The product of both halves' errors is an unbiased estimate of the
// squared error.
constexpr int PointSamples = 16;
constexpr int ProbeSamples = 64;

// Number of cells along the scene's longest side, by which points are weighted.
constexpr double CellsAcross = 24.0;

std::vector<float> FindSurfaces(GatherStage& stage, const glm::dvec3& middle, double radius)
{
  std::vector<float> found(static_cast<std::size_t>(Lines) * LineNumbers, 0.0f);
  stage.Results.Upload(GL_SHADER_STORAGE_BUFFER, found.data(), found.size() * sizeof(found[0]));
  stage.Run("gathering/surfaces.comp", {},
    Arguments()
      .Set("middle", glm::vec3(middle - stage.Origin()))
      .Set("radius", radius)
      .Set("pointCount", Lines),
    Lines / GI_GATHER_GROUP);
  stage.Read(found);
  return found;
}
}

// Pick about count of the points found, evenly by area. A point's weight is proportional to the area in its cell of
// space, because viewers look at places with much to see.
void LightTrial::SelectPoints(const std::vector<float>& found, const glm::dvec3& origin,
  const std::array<double, 6>& bounds, std::size_t count)
{
  const glm::dvec3 low(bounds[0], bounds[2], bounds[4]);
  const glm::dvec3 extent = glm::dvec3(bounds[1], bounds[3], bounds[5]) - low;
  const double side = std::max({ extent.x, extent.y, extent.z, 1e-30 * CellsAcross }) / CellsAcross;
  const glm::dvec3 first = glm::floor(low / side);
  std::map<std::array<int, 3>, std::vector<std::size_t>> cells;
  std::map<std::array<int, 3>, double> areas;
  for (std::size_t i = 0; i < found.size(); i += LineNumbers)
  {
    if (found[i + 6] > 0.0f)
    {
      const glm::dvec3 place = origin + glm::dvec3(found[i], found[i + 1], found[i + 2]);
      const glm::ivec3 cell(glm::floor(place / side) - first);
      cells[{ cell.x, cell.y, cell.z }].push_back(i);
      areas[{ cell.x, cell.y, cell.z }] += found[i + 6];
    }
  }
  double area = 0.0;
  double squares = 0.0;
  for (const auto& cell : areas)
  {
    area += cell.second;
    squares += cell.second * cell.second;
  }
  for (const auto& cell : cells)
  {
    const std::vector<std::size_t>& lines = cell.second;
    const double cellArea = areas[cell.first];
    const double desired = std::ceil(static_cast<double>(count) * cellArea / area);
    // The lines are distributed evenly, so any regular subset of them is, too.
    const std::size_t stride = std::max<std::size_t>(
      1, static_cast<std::size_t>(static_cast<double>(lines.size()) / desired));
    double sum = 0.0;
    const std::size_t firstOfCell = this->Weights.size();
    for (std::size_t k = 0; k < lines.size(); k += stride)
    {
      const float* line = &found[lines[k]];
      this->Points.push_back(origin + glm::dvec3(line[0], line[1], line[2]));
      this->Normals.push_back(glm::dvec3(line[3], line[4], line[5]));
      this->Weights.push_back(line[6]);
      sum += line[6];
    }
    for (std::size_t k = firstOfCell; k < this->Weights.size(); ++k)
    {
      this->Weights[k] *= cellArea * cellArea / (sum * squares);
    }
  }
}

bool LightTrial::Prepare(
  GatherStage& stage, const std::array<double, 6>& bounds, int points, const Gather& gather)
{
  const glm::dvec3 low(bounds[0], bounds[2], bounds[4]);
  const glm::dvec3 high(bounds[1], bounds[3], bounds[5]);
  const double radius = 0.501 * glm::length(high - low);
  this->SelectPoints(FindSurfaces(stage, 0.5 * (low + high), radius), stage.Origin(), bounds,
    static_cast<std::size_t>(points));
  std::vector<float> surroundings[2];
  for (int half = 0; half < 2 && !this->Points.empty(); ++half)
  {
    this->Light[half] =
      gather(this->Points, this->Normals, half * PointSamples, PointSamples, &surroundings[half]);
    if (this->Light[half].empty())
    {
      return false;
    }
  }
  return this->DiscardHidden(surroundings);
}

// Give weight 0 to points that are inside solid objects or face the void around the scene. They receive no light, and
// rays from them hit backfaces or nothing.
bool LightTrial::DiscardHidden(const std::vector<float>* surroundings)
{
  double sum = 0.0;
  double weights = 0.0;
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    double light = 0.0;
    for (std::size_t k = 3 * i; k < 3 * i + 3; ++k)
    {
      light += (this->Light[0][k] + this->Light[1][k]) / 6.0;
    }
    const double backfaces = 0.5 * (surroundings[0][3 * i] + surroundings[1][3 * i]);
    const double hits = 0.5 * (surroundings[0][3 * i + 1] + surroundings[1][3 * i + 1]);
    const bool visible = light > 0.0 || (hits > 0.0 && backfaces < SolidBackfaceRatio);
    this->Weights[i] = visible ? this->Weights[i] : 0.0;
    weights += this->Weights[i];
    sum += this->Weights[i] * light;
  }
  for (double& weight : this->Weights)
  {
    weight /= std::max(weights, 1e-300);
  }
  this->MeanSquare = sum > 0.0 ? sum / weights * sum / weights : 0.0;
  return sum > 0.0;
}

std::vector<float> LightTrial::ProbeLight(GatherStage& stage, const ProbeField& field) const
{
  const ProbeTextures textures(field, false);
  std::vector<shared::GatherPoint> data(this->Points.size());
  for (std::size_t i = 0; i < data.size(); ++i)
  {
    data[i] = { glm::vec4(glm::vec3(this->Points[i] - stage.Origin()), 0.0f),
      glm::vec4(glm::vec3(this->Normals[i]), 0.0f) };
  }
  stage.Points.Upload(GL_SHADER_STORAGE_BUFFER, data.data(), data.size() * sizeof(data[0]));
  std::vector<float> light(3 * data.size(), 0.0f);
  stage.Results.Upload(GL_SHADER_STORAGE_BUFFER, light.data(), light.size() * sizeof(light[0]));
  vtkNew<vtkGISHProbes> technique;
  stage.Run("sh_probes/points.comp", textures.Variant(),
    textures.ShaderArguments(technique->GetBias(), stage.Origin())
      .Set("pointCount", static_cast<int>(data.size()))
      .Set("offset", 2.0 * stage.Error()),
    (data.size() + GI_GATHER_GROUP - 1) / GI_GATHER_GROUP);
  stage.Read(light);
  return light;
}

std::vector<PointError> LightTrial::MeasureErrors(
  GatherStage& stage, ProbeField field, const Gather& gather) const
{
  const std::vector<glm::dvec3> positions = field.Positions(0, field.Grids.Size());
  std::vector<float> probeLight[2];
  for (int half = 0; half < 2; ++half)
  {
    field.Light = gather(positions, {}, half * ProbeSamples, ProbeSamples, nullptr);
    if (field.Light.empty())
    {
      return {};
    }
    probeLight[half] = this->ProbeLight(stage, field);
  }
  std::vector<PointError> errors;
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    if (this->Weights[i] == 0.0)
    {
      continue;
    }
    double error = 0.0;
    double mean = 0.0;
    for (std::size_t k = 3 * i; k < 3 * i + 3; ++k)
    {
      const double lights[2] = { this->Light[0][k], this->Light[1][k] };
      error += (probeLight[0][k] - lights[0]) * (probeLight[1][k] - lights[1]) / 3.0;
      // Includes the probes' light, because the light of single points is noisy.
      mean += 0.25 * (lights[0] + lights[1] + probeLight[0][k] + probeLight[1][k]) / 3.0;
    }
    const double share = this->Weights[i] / (mean * mean + 0.01 * this->MeanSquare);
    errors.push_back({ this->Points[i], share * error });
  }
  return errors;
}
}
