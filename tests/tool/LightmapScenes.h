// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes to unwrap, and light to put into their maps.
#pragma once

#include "bake/lightmap/LightmapFile.h"

#include <vtkActor.h>
#include <vtkCubeSource.h>
#include <vtkNew.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <cmath>

namespace penumbra_test
{
using namespace penumbra::lightmap;

class Scene
{
public:
  vtkActor* Add(vtkPolyDataAlgorithm* source)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    return actor;
  }
  void AddTorus()
  {
    vtkNew<vtkParametricTorus> torus;
    vtkNew<vtkParametricFunctionSource> source;
    source->SetParametricFunction(torus);
    source->SetUResolution(48);
    source->SetVResolution(24);
    this->Add(source);
  }
  vtkActor* AddSphere()
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(40);
    sphere->SetPhiResolution(24);
    return this->Add(sphere);
  }
  vtkActor* AddBox()
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetXLength(2.0);
    return this->Add(cube);
  }
  vtkNew<vtkRenderer> Renderer;
};

inline Atlas PackAll(const std::vector<Chart>& charts, double texel, int largest = 2048)
{
  return PackAtlas(
    charts, std::vector<std::array<bool, 2>>(charts.size(), { { true, true } }), texel, largest);
}

// The light that a texel should have: smooth over the surface.
inline float Wanted(const Vec3& at, int channel)
{
  return static_cast<float>(
    1.0 + 0.5 * std::sin(2.0 * at.x + channel) * std::cos(1.5 * at.y - at.z));
}

inline Light Fill(
  const Atlas& atlas, const std::vector<Texel>& texels, std::vector<unsigned char>& known)
{
  Light light(atlas.Width, atlas.Height, 3);
  known.assign(std::size_t(atlas.Width) * atlas.Height, 0);
  for (const Texel& texel : texels)
  {
    known[texel.Index] = 1;
    for (int c = 0; c < 3; ++c)
    {
      light.Pixel(texel.Index)[c] = Wanted(texel.At, c);
    }
  }
  return light;
}
}
