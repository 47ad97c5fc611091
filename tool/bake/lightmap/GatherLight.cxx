// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/lightmap/GatherLight.h"

#include "bake/lightmap/Bake.h"
#include "common/Failure.h"
#include "common/Reporter.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkGILightGatherer.h>

#include <algorithm>
#include <cmath>

namespace penumbra::lightmap
{
namespace
{
void Fill(vtkDoubleArray* array, const std::vector<Vec3>& values)
{
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetTypedTuple(static_cast<vtkIdType>(i), &values[i][0]);
  }
}

/// Reduces the first moment by the share of light near the horizon. A tilted normal loses only half as much of light from
/// all directions above the surface as of light from straight above, because light that falls below the horizon cannot
/// become negative. Irradiance and mean radiance give the radiance near the horizon, assuming that it is linear in the
/// cosine. Without this change, the moment along the normal would be half of the irradiance divided by pi, and redundant.
void ReduceMoments(float* values, const float* meanRadiance, const Vec3& normal)
{
  for (int color = 0; color < 3; ++color)
  {
    const float horizon = 4.0f * meanRadiance[color] - 3.0f * values[color];
    for (int axis = 0; axis < 3 && std::isfinite(horizon); ++axis)
    {
      values[3 + 3 * axis + color] -= 0.25f * horizon * static_cast<float>(normal[axis]);
    }
  }
}
}

GatherLight::GatherLight(vtkRenderer* renderer, const BakeSettings& settings)
  : Renderer(renderer)
  , Directional(settings.Directional)
{
  this->Gatherer->SetBounces(settings.Bounces);
  this->Gatherer->SetMaximumAlbedo(settings.MaximumAlbedo);
  this->Gatherer->SetEnergyCompensation(settings.EnergyCompensation);
  this->Gatherer->SetDirectional(settings.Directional);
}

GatherLight::~GatherLight()
{
  this->Gatherer->ReleaseGraphicsResources(nullptr);
}

void GatherLight::Include(bool indirect, bool direct)
{
  this->Indirect = indirect;
  this->Gatherer->SetIncludeIndirect(indirect);
  this->Gatherer->SetIncludeLamps(direct);
}

void GatherLight::operator()(const std::vector<Vec3>& points, const std::vector<Vec3>& normals,
  int firstSample, int samples, const std::function<void(double)>& advance)
{
  vtkNew<vtkDoubleArray> at, to;
  vtkNew<vtkFloatArray> light, around;
  Fill(at, points);
  Fill(to, normals);
  this->Gatherer->SetFirstSample(firstSample);
  this->Gatherer->SetSamples(samples);
  const tool::ProgressObserver observer(this->Gatherer, advance);
  const bool done = this->Gatherer->Gather(this->Renderer, at, to, light, around);
  if (!done)
  {
    tool::Fail("light cannot be gathered: {}", this->Gatherer->GetLastError());
  }
  const auto channels = static_cast<std::size_t>(this->Channels());
  this->Light.resize(points.size() * channels);
  this->Backs.resize(points.size());
  constexpr int meanRadiance = 3; // components between irradiance and moments
  const int components = light->GetNumberOfComponents();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto tuple = static_cast<vtkIdType>(i);
    for (std::size_t c = 0; c < channels; ++c)
    {
      const int from = static_cast<int>(c) + (c < 3 ? 0 : meanRadiance);
      const float value = light->GetTypedComponent(tuple, from);
      this->Light[i * channels + c] = std::isfinite(value) ? value : 0.0f;
    }
    if (this->Directional && this->Indirect)
    {
      ReduceMoments(&this->Light[i * channels],
        light->GetPointer(tuple * components) + meanRadiance, normals[i]);
    }
    this->Backs[i] = around->GetTypedComponent(tuple, 0);
  }
}

int GatherLight::CameraLights() const
{
  return this->Gatherer->GetNumberOfLampsLeftOut();
}
}
