// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cases.h"
#include "SceneParts.h"

#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPBRIrradianceTexture.h"
#include "vtkPBRLUTTexture.h"
#include "vtkPBRPrefilterTexture.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataTangents.h"
#include "vtkUnsignedCharArray.h"

namespace penumbra_test
{
namespace
{
//------------------------------------------------------------------------------
// Scalars

vtkSmartPointer<vtkPolyData> WithScalars(bool perCell)
{
  vtkSmartPointer<vtkPolyData> torus = Torus();
  const vtkIdType count = perCell ? torus->GetNumberOfCells() : torus->GetNumberOfPoints();
  vtkNew<vtkDoubleArray> values;
  values->SetName("height");
  for (vtkIdType i = 0; i < count; ++i)
  {
    values->InsertNextValue(std::sin(0.01 * i) + (i % 3) * 0.1);
  }
  perCell ? torus->GetCellData()->SetScalars(values) : torus->GetPointData()->SetScalars(values);
  return torus;
}

vtkPolyDataMapper* AddScalars(Stage& stage, bool perCell)
{
  vtkActor* actor = stage.Add(WithScalars(perCell));
  actor->GetMapper()->SetScalarRange(-1.0, 1.2);
  Stage::LookAround(stage.Renderer);
  return static_cast<vtkPolyDataMapper*>(actor->GetMapper());
}

// Half of the surface is transparent. It is masked, not blended, because the actor is forced opaque.
void AddMaskedOpacity(Stage& stage)
{
  vtkSmartPointer<vtkPolyData> torus = Torus();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < torus->GetNumberOfPoints(); ++i)
  {
    const auto green = static_cast<unsigned char>(i % 256);
    const unsigned char color[4] = { 200, green, 90,
      static_cast<unsigned char>(i % 40 < 20 ? 0 : 255) };
    colors->InsertNextTypedTuple(color);
  }
  torus->GetPointData()->SetScalars(colors);
  stage.Add(torus)->ForceOpaqueOn();
  Stage::LookAround(stage.Renderer);
}

//------------------------------------------------------------------------------
// Textures

vtkSmartPointer<vtkTexture> CheckerTexture(int components = 3, bool sRGB = false)
{
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(Checkerboard(components));
  texture->InterpolateOn();
  texture->SetUseSRGBColorSpace(sRGB);
  return texture;
}

// A colour with a slight gradient.
vtkSmartPointer<vtkTexture> GradientTexture(unsigned char r, unsigned char g, unsigned char b)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(16, 16, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 256; ++i)
  {
    auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(i % 16, i / 16, 0));
    pixel[0] = r;
    pixel[1] = static_cast<unsigned char>(std::min(255, g + 4 * (i % 16)));
    pixel[2] = static_cast<unsigned char>(std::min(255, b + 4 * (i / 16)));
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  return texture;
}

vtkActor* AddTextured(Stage& stage, vtkTexture* texture)
{
  vtkActor* actor = stage.Add(Torus());
  actor->GetProperty()->SetColor(0.9, 0.9, 0.8);
  actor->SetTexture(texture);
  Stage::LookAround(stage.Renderer);
  return actor;
}

//------------------------------------------------------------------------------
// Physically based materials

vtkProperty* AddPBR(Stage& stage, double metallic = 0.2, double roughness = 0.4)
{
  vtkNew<vtkPolyDataTangents> tangents;
  tangents->SetInputData(Torus());
  vtkActor* actor = stage.Add(tangents);
  Stage::LookAround(stage.Renderer);
  vtkProperty* property = actor->GetProperty();
  property->SetInterpolationToPBR();
  property->SetMetallic(metallic);
  property->SetRoughness(roughness);
  return property;
}

// A sky with a warm patch that is brighter than white.
void SetEnvironment(Stage& stage, bool sphericalHarmonics)
{
  vtkNew<vtkImageData> image;
  constexpr int width = 64;
  constexpr int height = 32;
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      auto* pixel = static_cast<float*>(image->GetScalarPointer(x, y, 0));
      const bool sun = x > 40 && x < 46 && y > 20 && y < 26;
      pixel[0] = sun ? 9.0f : 0.2f + 0.5f * y / height;
      pixel[1] = sun ? 7.0f : 0.4f;
      pixel[2] = sun ? 4.0f : 0.9f - 0.6f * x / width;
    }
  }
  auto* renderer = static_cast<vtkOpenGLRenderer*>(stage.Renderer.Get());
  renderer->SetEnvironmentTexture(EnvironmentTexture(image));
  renderer->UseImageBasedLightingOn();
  renderer->SetUseSphericalHarmonics(sphericalHarmonics);
  // Small tables: filtering would take longer than the picture.
  renderer->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(32);
  renderer->GetEnvMapPrefiltered()->SetPrefilterLevels(3);
  renderer->GetEnvMapIrradiance()->SetIrradianceSize(16);
  renderer->GetEnvMapIrradiance()->SetIrradianceStep(0.1f);
  renderer->GetEnvMapLookupTable()->SetLUTSize(64);
  renderer->GetEnvMapLookupTable()->SetLUTSamples(64);
}

void SetEveryTexture(vtkProperty* property)
{
  property->SetBaseColorTexture(CheckerTexture(3, true));
  property->SetORMTexture(GradientTexture(200, 120, 40));
  property->SetNormalTexture(GradientTexture(150, 100, 200));
  property->SetEmissiveTexture(CheckerTexture(3, true));
  property->SetEmissiveFactor(0.3, 0.1, 0.2);
  property->SetOcclusionStrength(0.8);
  property->SetNormalScale(0.7);
}
}

ParityCases MaterialCases()
{
  return {
    { "scalars per point", [](Stage& s) { AddScalars(s, false); } },
    { "scalars per cell", [](Stage& s) { AddScalars(s, true); } },
    { "scalars, interpolated before mapping",
      [](Stage& s) { AddScalars(s, false)->InterpolateScalarsBeforeMappingOn(); } },
    { "scalars per cell, flat, edges",
      [](Stage& s) {
        AddScalars(s, true);
        vtkProperty* property = s.Renderer->GetActors()->GetLastActor()->GetProperty();
        property->SetInterpolationToFlat();
        property->EdgeVisibilityOn();
      } },
    { "scalars, physically based",
      [](Stage& s) {
        AddScalars(s, false);
        s.Renderer->GetActors()->GetLastActor()->GetProperty()->SetInterpolationToPBR();
      } },
    { "opacity masked", AddMaskedOpacity },
    { "texture", [](Stage& s) { AddTextured(s, CheckerTexture()); } },
    { "texture, specular and ambient",
      [](Stage& s) {
        vtkProperty* property = AddTextured(s, CheckerTexture())->GetProperty();
        property->SetSpecular(0.6);
        property->SetSpecularPower(10.0);
        property->SetAmbient(0.2);
      } },
    { "texture, LightingOff",
      [](Stage& s) { AddTextured(s, CheckerTexture())->GetProperty()->LightingOff(); } },
    { "texture with alpha", [](Stage& s) { AddTextured(s, CheckerTexture(4)); }, false },
    { "texture with alpha, masked",
      [](Stage& s) { AddTextured(s, CheckerTexture(4))->ForceOpaqueOn(); } },
    { "texture, grey", [](Stage& s) { AddTextured(s, CheckerTexture(1)); } },
    { "texture from scalars",
      [](Stage& s) {
        auto texture = CheckerTexture(1);
        vtkNew<vtkLookupTable> table;
        table->SetRange(0.0, 255.0);
        table->Build();
        texture->SetLookupTable(table);
        texture->SetColorModeToMapScalars();
        AddTextured(s, texture);
      } },
    { "two textures",
      [](Stage& s) {
        vtkActor* actor = AddTextured(s, nullptr);
        actor->GetProperty()->SetTexture("checks", CheckerTexture());
        actor->GetProperty()->SetTexture("gradient", GradientTexture(240, 180, 170));
      } },
    { "texture beside plain",
      [](Stage& s) {
        AddTextured(s, CheckerTexture());
        s.Add(Ball(20))->GetProperty()->SetSpecular(0.5);
      } },
    { "physically based", [](Stage& s) { AddPBR(s); } },
    { "physically based, metal",
      [](Stage& s) { AddPBR(s, 1.0, 0.2)->SetEdgeTint(0.9, 0.8, 1.0); } },
    { "physically based, rough", [](Stage& s) { AddPBR(s, 0.0, 1.0)->SetBaseIOR(2.0); } },
    { "physically based, smooth", [](Stage& s) { AddPBR(s, 0.5, 0.05); } },
    { "physically based beside Phong",
      [](Stage& s) {
        AddPBR(s);
        s.Add(Ball(20))->GetProperty()->SetSpecular(0.5);
      } },
    { "physically based, two lights",
      [](Stage& s) {
        AddPBR(s, 0.3, 0.3);
        for (const double x : { -3.0, 3.0 })
        {
          vtkNew<vtkLight> light;
          light->SetPosition(x, 2.0, 3.0);
          light->SetColor(1.0, 0.5 + 0.1 * x, 0.7);
          s.Renderer->AddLight(light);
        }
      } },
    { "physically based, every texture", [](Stage& s) { SetEveryTexture(AddPBR(s)); } },
    { "physically based, environment",
      [](Stage& s) {
        AddPBR(s, 0.6, 0.25);
        SetEnvironment(s, true);
      } },
    { "physically based, irradiance texture",
      [](Stage& s) {
        AddPBR(s, 0.6, 0.25);
        SetEnvironment(s, false);
      } },
    { "physically based, textures, environment",
      [](Stage& s) {
        SetEveryTexture(AddPBR(s));
        SetEnvironment(s, true);
      } },
    { "physically based, environment, no light",
      [](Stage& s) {
        AddPBR(s, 0.6, 0.25);
        SetEnvironment(s, true);
        s.Renderer->AutomaticLightCreationOff();
      } },
    { "physically based, anisotropic",
      [](Stage& s) {
        vtkProperty* property = AddPBR(s, 0.8, 0.3);
        property->SetAnisotropy(0.8);
        property->SetAnisotropyRotation(0.2);
      } },
    { "physically based, clear coat",
      [](Stage& s) {
        vtkProperty* property = AddPBR(s, 0.4, 0.5);
        property->SetCoatStrength(0.8);
        property->SetCoatRoughness(0.1);
        property->SetCoatColor(1.0, 0.8, 0.8);
      } },
    { "physically based, LightingOff", [](Stage& s) { AddPBR(s)->LightingOff(); } },
  };
}
}
