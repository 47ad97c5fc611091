// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Every change of a scene shows in the next frame: the picture equals that of a scene built with the change.
#include "Scenes.h"

namespace penumbra_test
{
namespace
{
struct Change
{
  const char* Name;
  void (*Apply)(Scene&);
};

vtkSphereSource* BallSource(Scene& scene)
{
  return vtkSphereSource::SafeDownCast(scene.Ball->GetMapper()->GetInputAlgorithm());
}

const std::vector<Change> Changes = {
  { "colour", [](Scene& s) { s.Ball->GetProperty()->SetColor(0.1, 0.2, 0.9); } },
  { "specular", [](Scene& s) { s.Box->GetProperty()->SetSpecular(0.9); } },
  { "interpolation", [](Scene& s) { s.Ball->GetProperty()->SetInterpolationToFlat(); } },
  { "material model", [](Scene& s) { s.Ball->GetProperty()->SetInterpolationToPBR(); } },
  { "opacity", [](Scene& s) { s.Box->GetProperty()->SetOpacity(0.3); } },
  { "position", [](Scene& s) { s.Box->AddPosition(-0.3, 0.4, 0.5); } },
  { "data", [](Scene& s) { BallSource(s)->SetRadius(0.8); } },
  { "visibility", [](Scene& s) { s.Box->VisibilityOff(); } },
  { "added prop",
    [](Scene& s) {
      vtkNew<vtkConeSource> cone;
      s.Add(cone)->SetPosition(0.0, -0.8, 0.5);
    } },
  { "removed prop", [](Scene& s) { s.Renderer->RemoveActor(s.Ball); } },
  { "light added",
    [](Scene& s) {
      vtkNew<vtkLight> light;
      light->SetLightTypeToSceneLight();
      light->SetPosition(-3.0, 2.0, 1.0);
      light->SetColor(1.0, 0.3, 0.3);
      s.Renderer->AddLight(light);
    } },
  { "camera", [](Scene& s) { s.Renderer->GetActiveCamera()->Azimuth(40.0); } },
  { "projection",
    [](Scene& s) {
      s.Renderer->GetActiveCamera()->ParallelProjectionOn();
      s.Renderer->ResetCamera();
    } },
  { "background", [](Scene& s) { s.Renderer->SetBackground(0.8, 0.1, 0.1); } },
};

struct Variant
{
  const char* Name;
  const char* Preset;
  bool Accumulates; ///< temporal accumulation, whose history lasts eight frames
};

class ChangedScene : public testing::TestWithParam<std::tuple<Change, Variant>>
{
};

vtkSmartPointer<vtkGIPass> Prepare(Scene& scene, const Variant& variant)
{
  vtkGIPass* pass = scene.SetPass();
  SetQuietPreset(pass, variant.Preset);
  pass->GetTechnique("temporal-accumulation")->SetEnabled(variant.Accumulates);
  return pass;
}

Picture ShootSettled(Scene& scene, const Variant& variant)
{
  for (int i = 0; variant.Accumulates && i < 8; ++i)
  {
    scene.Window->Render();
  }
  return Shoot(scene.Window);
}

TEST_P(ChangedScene, EqualsAFreshOne)
{
  const auto& [change, variant] = GetParam();
  Scene changed;
  Prepare(changed, variant);
  const Picture before = Shoot(changed.Window);
  changed.Window->Render();
  change.Apply(changed);
  const Picture after = ShootSettled(changed, variant);

  Scene fresh;
  fresh.Window->SetMultiSamples(0);
  change.Apply(fresh);
  Prepare(fresh, variant);
  EXPECT_GT(1.0 - Compare(before, after, 2).Within, 0.002) << "nothing changed";
  ExpectSame(ShootSettled(fresh, variant), after);
}

std::string Name(const testing::TestParamInfo<std::tuple<Change, Variant>>& info)
{
  std::string name = std::string(std::get<0>(info.param).Name) + "_" + std::get<1>(info.param).Name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Changes, ChangedScene,
  testing::Combine(testing::ValuesIn(Changes),
    testing::Values(Variant{ "off", "off", false }, Variant{ "balanced", "balanced", false },
      Variant{ "accumulated", "balanced", true })),
  Name);
}
}
