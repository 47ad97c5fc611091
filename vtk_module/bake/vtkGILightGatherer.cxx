// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGILightGatherer.h"

#include "bake/GatherStage.h"

#include "gathering.h"

#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <chrono>
#include <cmath>
#include <stdexcept>

vtkStandardNewMacro(vtkGILightGatherer);

using namespace penumbra;

namespace
{
// Number of paths in the first batch. Later ones adapt to the time taken.
constexpr std::size_t FirstPaths = 4096;

/// Samples that are traced at once.
struct Batch
{
  std::size_t Points;
  int FirstSample;
  int Samples;
  std::size_t Numbers; ///< results per point
  bool Hemisphere;
};

// The error of an array that should hold finite vectors, or "".
std::string CheckVectors(vtkDataArray* array, const char* name)
{
  if (!array || array->GetNumberOfComponents() != 3)
  {
    return std::string(name) + " must have three components.";
  }
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const double* v = array->GetTuple3(i);
    if (!std::isfinite(v[0]) || !std::isfinite(v[1]) || !std::isfinite(v[2]))
    {
      return std::string(name) + " must be finite, and number " + std::to_string(i) + " is not.";
    }
  }
  return "";
}

std::string CheckArrays(vtkDataArray* points, vtkDataArray* normals, vtkFloatArray* light)
{
  std::string error = CheckVectors(points, "the points");
  if (error.empty() && normals)
  {
    error = CheckVectors(normals, "the normals");
    if (error.empty() && normals->GetNumberOfTuples() != points->GetNumberOfTuples())
    {
      error = "there must be as many normals as points.";
    }
  }
  return error.empty() && !light ? "there is no array to put the light into." : error;
}

void WriteMeans(const std::vector<double>& sums, int samples, int components, vtkFloatArray* light,
  vtkFloatArray* surroundings)
{
  const std::size_t numbers = static_cast<std::size_t>(components) + GI_GATHER_SURROUNDINGS;
  const auto count = static_cast<vtkIdType>(sums.size() / numbers);
  light->SetNumberOfComponents(components);
  light->SetNumberOfTuples(count);
  if (surroundings)
  {
    surroundings->SetNumberOfComponents(3);
    surroundings->SetNumberOfTuples(count);
  }
  for (vtkIdType point = 0; point < count; ++point)
  {
    const double* sum = &sums[static_cast<std::size_t>(point) * numbers];
    for (int k = 0; k < components; ++k)
    {
      light->SetTypedComponent(point, k, static_cast<float>(sum[k] / samples));
    }
    if (surroundings)
    {
      sum += components;
      const double hits = sum[GI_GATHER_HITS];
      surroundings->SetTypedComponent(point, 0, static_cast<float>(sum[GI_GATHER_BACKS] / samples));
      surroundings->SetTypedComponent(point, 1, static_cast<float>(hits / samples));
      surroundings->SetTypedComponent(
        point, 2, hits > 0.0 ? static_cast<float>(sum[GI_GATHER_DISTANCE] / hits) : 0.0f);
    }
  }
}

glm::dvec3 At(vtkDataArray* array, vtkIdType index)
{
  const double* v = array->GetTuple3(index);
  return { v[0], v[1], v[2] };
}
}

struct vtkGILightGatherer::Internals
{
  GatherStage Stage;
  std::string Error;
  WorkSize Paths{ FirstPaths };
  int LampsLeftOut = 0;
  int PropsLeftOut = 0;

  void Upload(vtkDataArray* points, vtkDataArray* normals, std::size_t first, std::size_t count);
  void Trace(const vtkGILightGatherer& settings, const Batch& batch, double* sums);
};

vtkGILightGatherer::vtkGILightGatherer()
  : Impl(new Internals)
{
}

vtkGILightGatherer::~vtkGILightGatherer() = default;

void vtkGILightGatherer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Samples: " << this->Samples << "\n";
  os << indent << "FirstSample: " << this->FirstSample << "\n";
  os << indent << "Bounces: " << this->Bounces << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "MaximumAlbedo: " << this->MaximumAlbedo << "\n";
  os << indent << "EnergyCompensation: " << this->EnergyCompensation << "\n";
  os << indent << "IncludeLamps: " << this->IncludeLamps << "\n";
  os << indent << "IncludeIndirect: " << this->IncludeIndirect << "\n";
  os << indent << "Directional: " << this->Directional << "\n";
}

void vtkGILightGatherer::Internals::Upload(
  vtkDataArray* points, vtkDataArray* normals, std::size_t first, std::size_t count)
{
  std::vector<shared::GatherPoint> data(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto index = static_cast<vtkIdType>(first + i);
    data[i].Position = glm::vec4(glm::vec3(At(points, index) - this->Stage.Origin()), 0.0f);
    data[i].Normal = normals ? glm::vec4(glm::vec3(At(normals, index)), 0.0f) : glm::vec4(0.0f);
  }
  this->Stage.Points.Upload(GL_SHADER_STORAGE_BUFFER, data.data(), count * sizeof(data[0]));
}

// Trace a batch for the uploaded points, and add the results to sums.
void vtkGILightGatherer::Internals::Trace(
  const vtkGILightGatherer& settings, const Batch& batch, double* sums)
{
  Defines defines;
  if (batch.Hemisphere)
  {
    defines["GI_HEMISPHERE"] = "1";
  }
  if (batch.Hemisphere && settings.Directional)
  {
    defines["GI_DIRECTIONAL"] = "1";
  }
  int lanes = 1;
  while (lanes < std::min(batch.Samples, GI_GATHER_GROUP))
  {
    lanes *= 2;
  }
  const int blocks = (batch.Samples + lanes - 1) / lanes;
  std::vector<float> found(batch.Points * blocks * batch.Numbers, 0.0f);
  this->Stage.Results.Upload(
    GL_SHADER_STORAGE_BUFFER, found.data(), found.size() * sizeof(found[0]));
  const auto perGroup = static_cast<std::size_t>(GI_GATHER_GROUP / lanes);
  this->Stage.Run("gathering/gather.comp", defines,
    Arguments()
      .Set("pointCount", static_cast<int>(batch.Points))
      .Set("firstSample", batch.FirstSample)
      .Set("samples", batch.Samples)
      .Set("lanes", lanes)
      .Set("blocks", blocks)
      .Set("seedOfAll", settings.Seed)
      .Set("bounces", settings.Bounces - 1) // after the first surface
      .Set("lamps", settings.IncludeLamps)
      .Set("indirect", settings.IncludeIndirect)
      .Set("offset", batch.Hemisphere ? 2.0 * this->Stage.Error() : 0.0),
    (batch.Points + perGroup - 1) / perGroup * blocks);
  this->Stage.Read(found);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    sums[i / batch.Numbers / blocks * batch.Numbers + i % batch.Numbers] += found[i];
  }
}

bool vtkGILightGatherer::Trace(vtkRenderer* renderer, vtkDataArray* points, vtkDataArray* normals,
  std::size_t numbers, std::vector<double>& sums)
{
  using Clock = std::chrono::steady_clock;
  Internals& impl = *this->Impl;
  SurfaceRules rules;
  rules.Reflectance = this->MaximumAlbedo;
  rules.Compensates = this->EnergyCompensation;
  impl.Stage.SetRules(rules);
  impl.Stage.Prepare(renderer);
  impl.LampsLeftOut = impl.Stage.LampsLeftOut();
  impl.PropsLeftOut = static_cast<int>(impl.Stage.PropsLeftOut());
  const auto count = static_cast<std::size_t>(points->GetNumberOfTuples());
  const auto samples = static_cast<std::size_t>(this->Samples);
  for (std::size_t first = 0; first < count;)
  {
    const std::size_t block = std::min<std::size_t>(samples, GI_GATHER_GROUP);
    const std::size_t pointCount =
      std::min(count - first, std::max<std::size_t>(1, impl.Paths.Get() / block));
    impl.Upload(points, normals, first, pointCount);
    for (std::size_t done = 0; done < samples;)
    {
      const std::size_t sampleCount =
        std::min(samples - done, std::max(block, impl.Paths.Get() / pointCount / block * block));
      const auto start = Clock::now();
      impl.Trace(*this,
        { pointCount, this->FirstSample + static_cast<int>(done), static_cast<int>(sampleCount),
          numbers, normals != nullptr },
        &sums[first * numbers]);
      impl.Paths.Adapt(
        pointCount * sampleCount, std::chrono::duration<double>(Clock::now() - start).count());
      done += sampleCount;
      const double fraction = static_cast<double>(done) / static_cast<double>(samples);
      double progress = (static_cast<double>(first) + static_cast<double>(pointCount) * fraction) /
        static_cast<double>(count);
      this->InvokeEvent(vtkCommand::ProgressEvent, &progress);
      if (this->Abort)
      {
        return false;
      }
      renderer->GetRenderWindow()->MakeCurrent(); // observers may have changed the context
    }
    first += pointCount;
  }
  return true;
}

bool vtkGILightGatherer::Gather(vtkRenderer* renderer, vtkDataArray* points, vtkDataArray* normals,
  vtkFloatArray* light, vtkFloatArray* surroundings)
{
  this->Abort = false;
  std::string& error = this->Impl->Error;
  error = CheckArrays(points, normals, light);
  if (!error.empty())
  {
    return false;
  }
  const int components = normals ? (this->Directional ? 15 : 3) : 27;
  const auto numbers = static_cast<std::size_t>(components) + GI_GATHER_SURROUNDINGS;
  std::vector<double> sums(static_cast<std::size_t>(points->GetNumberOfTuples()) * numbers, 0.0);
  try
  {
    if (!this->Trace(renderer, points, normals, numbers, sums))
    {
      return false;
    }
  }
  catch (const std::exception& problem)
  {
    error = problem.what();
    return false;
  }
  WriteMeans(sums, this->Samples, components, light, surroundings);
  return true;
}

int vtkGILightGatherer::GetNumberOfLampsLeftOut()
{
  return this->Impl->LampsLeftOut;
}

int vtkGILightGatherer::GetNumberOfPropsLeftOut()
{
  return this->Impl->PropsLeftOut;
}

const char* vtkGILightGatherer::GetLastError()
{
  return this->Impl->Error.c_str();
}

void vtkGILightGatherer::ReleaseGraphicsResources(vtkWindow*)
{
  this->Impl->Stage.Release();
}
