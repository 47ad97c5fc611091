// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/build/SceneBuilder.h"

#include "common/Failure.h"
#include "sky/SkyProp.h"
#include "scene/build/ColorMaps.h"
#include "scene/build/ObjectActors.h"
#include "scene/build/TextureFiles.h"

#include <vtkActor2D.h>
#include <vtkGILightShape.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkPropCollection.h>
#include <vtkScalarBarActor.h>
#include <vtkSkybox.h>
#include <vtkTextProperty.h>

namespace penumbra::tool
{
namespace
{
void SetEnvironment(
  const EnvironmentMap& environment, const DefaultView& view, vtkRenderer* renderer)
{
  if (environment.Sky)
  {
    // The default view looks north.
    environment.Sky->SetUp(view.Up[0], view.Up[1], view.Up[2]);
    environment.Sky->SetNorth(-view.Front[0], -view.Front[1], -view.Front[2]);
    environment.Sky->ApplyTo(renderer);
    return;
  }
  vtkSmartPointer<vtkTexture> texture = ReadEnvironmentTexture(environment.Path);
  Vec3 up = view.Up, right;
  vtkMath::Cross(view.Up.data(), view.Front.data(), right.data());
  renderer->UseImageBasedLightingOn();
  renderer->SetEnvironmentTexture(texture, false);
  renderer->SetEnvironmentUp(up.data());
  renderer->SetEnvironmentRight(right.data());
  if (environment.Visible)
  {
    auto sky = MakeSkybox(texture);
    Orient(sky, right.data(), up.data());
    renderer->AddActor(sky);
  }
}

void Aim(vtkLight* light, const Light& from)
{
  light->SetLightTypeToSceneLight();
  light->SetPosition(from.Position[0], from.Position[1], from.Position[2]);
  light->SetFocalPoint(from.Target[0], from.Target[1], from.Target[2]);
}

void SetShape(vtkLight* light, const Light& from)
{
  if (from.Diameter)
  {
    vtkGILightShape::SetAngle(light, *from.Diameter);
  }
  if (from.Radius)
  {
    vtkGILightShape::SetSphere(light, *from.Radius);
  }
  if (from.Disc)
  {
    vtkGILightShape::SetDisc(light, *from.Disc);
  }
  if (!from.Rectangle.empty())
  {
    vtkGILightShape::SetRectangle(light, from.Rectangle[0], from.Rectangle[1], from.Turn);
  }
}

void AddLight(const Light& from, vtkRenderer* renderer)
{
  vtkNew<vtkLight> light;
  switch (from.Kind)
  {
    case LightKind::Key:
      light->SetLightTypeToCameraLight();
      light->SetDirectionAngle(from.Elevation, from.Azimuth);
      break;
    case LightKind::Head:
      light->SetLightTypeToHeadlight();
      break;
    case LightKind::Directional:
      Aim(light, from);
      break;
    case LightKind::Point:
      Aim(light, from);
      light->PositionalOn();
      light->SetConeAngle(90); // VTK's convention for no cone
      break;
    case LightKind::Cone:
      Aim(light, from);
      light->PositionalOn();
      light->SetConeAngle(from.Angle);
      light->SetExponent(from.Exponent);
      break;
  }
  light->SetAttenuationValues(from.Attenuation[0], from.Attenuation[1], from.Attenuation[2]);
  light->SetColor(from.Color[0], from.Color[1], from.Color[2]);
  light->SetIntensity(from.Intensity);
  light->SetSwitch(from.On);
  SetShape(light, from);
  renderer->AddLight(light);
}

/// A key light from above left that follows the camera, and a weak headlight that brightens its shadows. None where the
/// environment has a sun.
std::vector<Light> DefaultLights(const Scene& scene)
{
  const auto& environment = scene.Environment;
  if (environment && environment->Sky && environment->Sky->GetSun())
  {
    return {};
  }
  Light key, fill;
  key.Kind = LightKind::Key;
  key.Intensity = 0.95;
  fill.Kind = LightKind::Head;
  fill.Intensity = 0.15;
  return { key, fill };
}

bool IsTranslucent(vtkRenderer* renderer)
{
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cursor;
  props->InitTraversal(cursor);
  while (vtkProp* prop = props->GetNextProp(cursor))
  {
    if (prop->HasTranslucentPolygonalGeometry())
    {
      return true;
    }
  }
  return false;
}

void AddScalarBar(vtkLookupTable* table, const ColorBy& color, vtkRenderer* renderer)
{
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(table);
  bar->SetTitle(color.Array.c_str());
  bar->SetNumberOfLabels(5);
  bar->SetMaximumWidthInPixels(130);
  bar->SetBarRatio(0.2);
  bar->UnconstrainedFontSizeOn();
  bar->SetLabelFormat("%.3g");
  bar->SetPosition(0.85, 0.2);
  bar->SetWidth(0.13);
  bar->SetHeight(0.6);
  bar->DrawTickLabelsOn();
  for (vtkTextProperty* text : { bar->GetTitleTextProperty(), bar->GetLabelTextProperty() })
  {
    text->SetFontFamilyToArial();
    text->SetFontSize(16);
    text->BoldOff();
    text->ItalicOff();
    text->ShadowOff();
  }
  renderer->AddActor2D(bar);
}
}

void SetBackground(const Background& background, vtkRenderer* renderer)
{
  renderer->SetBackground(background.Bottom[0], background.Bottom[1], background.Bottom[2]);
  renderer->SetBackground2(background.Top[0], background.Top[1], background.Top[2]);
  renderer->SetGradientBackground(background.Top != background.Bottom && !background.Transparent);
  renderer->SetBackgroundAlpha(background.Transparent ? 0 : 1);
  SetTextColors(renderer);
}

void SetTextColors(vtkRenderer* renderer)
{
  const double* top =
    renderer->GetGradientBackground() ? renderer->GetBackground2() : renderer->GetBackground();
  const double ink = top[0] + top[1] + top[2] > 1.5 ? 0.12 : 0.92;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cursor;
  props->InitTraversal(cursor);
  while (vtkProp* prop = props->GetNextProp(cursor))
  {
    if (auto* bar = vtkScalarBarActor::SafeDownCast(prop))
    {
      bar->GetTitleTextProperty()->SetColor(ink, ink, ink);
      bar->GetLabelTextProperty()->SetColor(ink, ink, ink);
    }
  }
}

BuiltScene BuildScene(const Scene& scene, vtkIdType maximumTriangles, Reporter& reporter)
{
  BuiltScene built;
  built.Renderer = vtkSmartPointer<vtkRenderer>::New();
  std::vector<Vec3> points;
  TriangleBudget budget(maximumTriangles);
  DefaultView view;
  std::size_t paletteIndex = 0;
  bool hasScalarBar = false;
  for (const Object& object : scene.Objects)
  {
    ObjectActors actors =
      MakeActors(object, scene.Environment.has_value(), paletteIndex, points, budget, reporter);
    view = &object == &scene.Objects.front() ? actors.View : view;
    budget.Spend(actors.Triangles, Describe(object));
    built.Balls += actors.Balls;
    for (vtkActor* actor : actors.Actors)
    {
      built.Renderer->AddActor(actor);
      if (!object.Name.empty())
      {
        built.Names[actor] = object.Name;
      }
    }
    if (actors.Coloring)
    {
      hasScalarBar = true;
      AddScalarBar(actors.Coloring, *object.Color, built.Renderer);
    }
  }
  if (scene.Objects.empty())
  {
    FailUsage("the scene has no objects: name a file to draw");
  }
  built.Triangles = budget.GetSpent();
  SetBackground(scene.Backdrop.value_or(Background()), built.Renderer);
  built.Renderer->AutomaticLightCreationOff();
  for (const Light& light : scene.Lights ? *scene.Lights : DefaultLights(scene))
  {
    AddLight(light, built.Renderer);
  }
  if (scene.Environment)
  {
    SetEnvironment(*scene.Environment, view, built.Renderer);
  }
  if (scene.DepthPeeling && IsTranslucent(built.Renderer))
  {
    built.DepthPeeling = true;
    built.Renderer->UseDepthPeelingOn();
    built.Renderer->SetMaximumNumberOfPeels(8);
    built.Renderer->SetOcclusionRatio(0.001);
  }
  // A scalar bar covers the right edge, so keep a margin on both sides.
  const double free = hasScalarBar ? 0.72 : 1;
  SetCamera(scene.View, view, points, free * scene.Width / scene.Height, built.Renderer);
  return built;
}

void ConfigureWindow(const Scene& scene, const BuiltScene& built, vtkRenderWindow* window)
{
  window->SetSize(scene.Width, scene.Height);
  window->SetAlphaBitPlanes(1); // for depth peeling and transparent backgrounds
  // In a multisampled window, VTK's depth peeling loses translucent surfaces.
  constexpr int samples = 8;
  window->SetMultiSamples(built.DepthPeeling ? 0 : samples);
  built.Renderer->SetUseFXAA(built.DepthPeeling);
  window->AddRenderer(built.Renderer);
}
}
