// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cases.h"

#include "vtkColorTransferFunction.h"
#include "vtkCubeSource.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkImageActor.h"
#include "vtkImageMapper3D.h"
#include "vtkImageSlice.h"
#include "vtkImageSliceMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace penumbra_test
{
namespace
{
//------------------------------------------------------------------------------
// Translucent props

// Glass balls around, inside and in front of an opaque torus.
void AddGlass(Stage& stage)
{
  AddTorus(stage, 0.4);
  for (int i = 0; i < 3; ++i)
  {
    vtkActor* glass = stage.Add(Ball());
    glass->SetPosition(0.3 * i - 0.3, 0.2, 0.3 * i);
    glass->GetProperty()->SetColor(0.2, 0.4 * i, 1.0 - 0.3 * i);
    glass->GetProperty()->SetOpacity(0.3 + 0.1 * i);
    glass->GetProperty()->SetSpecular(0.6);
  }
}

void AddPeeledGlass(Stage& stage)
{
  AddGlass(stage);
  stage.Window->SetAlphaBitPlanes(1);
  stage.Renderer->SetUseDepthPeeling(true);
  stage.Renderer->SetMaximumNumberOfPeels(10);
  stage.Renderer->SetOcclusionRatio(0.0);
}

// An actor whose scalars make one half opaque and the other translucent.
void AddTranslucentScalars(Stage& stage)
{
  vtkSmartPointer<vtkPolyData> torus = Torus();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < torus->GetNumberOfPoints(); ++i)
  {
    const unsigned char color[4] = { 220, 120, 60,
      static_cast<unsigned char>(torus->GetPoint(i)[0] > 0.0 ? 90 : 255) };
    colors->InsertNextTypedTuple(color);
  }
  torus->GetPointData()->SetScalars(colors);
  stage.Add(torus);
  stage.Add(Ball())->GetProperty()->SetColor(0.3, 0.3, 0.9);
  Stage::LookAround(stage.Renderer);
}

//------------------------------------------------------------------------------
// Volumes

vtkSmartPointer<vtkImageData> Cloud()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  constexpr int size = 24;
  image->SetDimensions(size, size, size);
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->SetSpacing(2.0 / (size - 1), 2.0 / (size - 1), 2.0 / (size - 1));
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (int z = 0; z < size; ++z)
  {
    for (int y = 0; y < size; ++y)
    {
      for (int x = 0; x < size; ++x)
      {
        const double r = std::hypot(x - 11.5, std::hypot(y - 11.5, z - 11.5)) / 11.5;
        const double value = std::max(0.0, 1.0 - r) * (0.7 + 0.3 * std::sin(x + 0.5 * y));
        *static_cast<unsigned char*>(image->GetScalarPointer(x, y, z)) =
          static_cast<unsigned char>(255.0 * value);
      }
    }
  }
  return image;
}

void AddVolume(Stage& stage, vtkVolumeMapper* mapper, bool shaded)
{
  mapper->SetInputDataObject(Cloud());
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.0, 0.1, 0.2, 0.9);
  colors->AddRGBPoint(200.0, 1.0, 0.9, 0.4);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(20.0, 0.0);
  opacity->AddPoint(250.0, 0.4);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colors);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetShade(shaded);
  stage.Renderer->AddVolume(volume);
  Stage::LookAround(stage.Renderer);
}

void AddSmartVolume(Stage& stage, bool shaded)
{
  vtkNew<vtkSmartVolumeMapper> mapper;
  mapper->SetRequestedRenderModeToGPU();
  mapper->SetAutoAdjustSampleDistances(false);
  mapper->SetSampleDistance(0.05f);
  AddVolume(stage, mapper, shaded);
}

void AddRayCastVolume(Stage& stage)
{
  AddTorus(stage, 0.4);
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->SetAutoAdjustSampleDistances(false);
  mapper->SetSampleDistance(0.1f);
  AddVolume(stage, mapper, false);
}

//------------------------------------------------------------------------------
// Images in the scene

void AddImageActor(Stage& stage)
{
  vtkNew<vtkImageActor> image;
  image->GetMapper()->SetInputData(Checkerboard());
  image->RotateX(30.0);
  stage.Renderer->AddActor(image);
  vtkActor* ball = stage.Add(Ball());
  ball->SetScale(30.0);
  ball->SetPosition(30.0, 30.0, 0.0);
  Stage::LookAround(stage.Renderer);
}

void AddImageSlice(Stage& stage)
{
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(Checkerboard());
  vtkNew<vtkImageSlice> slice;
  slice->SetMapper(mapper);
  stage.Renderer->AddViewProp(slice);
  vtkActor* ball = stage.Add(Ball());
  ball->SetScale(40.0);
  ball->SetPosition(30.0, 30.0, 0.0);
  Stage::LookAround(stage.Renderer);
}
}

ParityCases LayerCases()
{
  return {
    { "translucent", AddGlass },
    { "translucent, depth peeling", AddPeeledGlass },
    { "translucent only", [](Stage& s) { AddTorus(s, 0.4)->GetProperty()->SetOpacity(0.5); },
      false },
    { "translucent, scalars", AddTranslucentScalars },
    { "volume", [](Stage& s) { AddSmartVolume(s, false); }, false },
    { "volume with a surface",
      [](Stage& s) {
        AddTorus(s, 0.4);
        AddSmartVolume(s, true);
      } },
    { "volume, translucent and opaque",
      [](Stage& s) {
        AddGlass(s);
        AddSmartVolume(s, false);
      } },
    { "volume ray cast on the CPU", AddRayCastVolume },
    { "image actor", AddImageActor },
    { "image slice", AddImageSlice },
    { "FXAA",
      [](Stage& s) {
        AddTorus(s, 0.4);
        s.Renderer->UseFXAAOn();
      } },
  };
}
}
