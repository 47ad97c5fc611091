// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// The lighting of a frame does not depend on the order of the techniques.
#include "Scenes.h"

#include "pass/PassInternals.h"

#include "vtkLight.h"

#include <random>

class vtkGIPassOrder
{
public:
  static void Shuffle(vtkGIPass* pass, unsigned int seed)
  {
    auto& techniques = pass->Impl->Techniques;
    std::shuffle(techniques.begin(), techniques.end(), std::mt19937(seed));
  }
};

namespace penumbra_test
{
namespace
{
// Number of random orders.
constexpr int Orders = 50;

TEST(Plan, OrderOfTechniquesDoesNotMatter)
{
  Scene scene;
  scene.Window->SetSize(96, 72);
  vtkGIPass* pass = scene.SetPass();
  pass->SetPreset("high");
  for (const char* name :
    { "ray-traced-shadows", "screen-space-reflections", "temporal-accumulation", "anti-aliasing" })
  {
    pass->GetTechnique(name)->EnabledOn();
  }
  pass->GetTechnique("anti-aliasing")->SetParameterFromText("mode", "accumulate");
  pass->GetTechnique("ddgi")->SetParameter("probes", 64);
  pass->GetTechnique("ddgi")->SetParameter("rays", 16);
  const auto draw = [&scene, pass] {
    pass->Restart();
    return Shoot(scene.Window);
  };
  const Picture first = draw();
  EXPECT_GT(Busyness(first), 0.01);
  EXPECT_EQ(Compare(first, draw(), 0).Within, 1.0) << "the same order";
  for (int seed = 1; seed <= Orders; ++seed)
  {
    vtkGIPassOrder::Shuffle(pass, static_cast<unsigned int>(seed));
    EXPECT_EQ(Compare(first, draw(), 0).Within, 1.0) << "order " << seed;
    EXPECT_STREQ(pass->GetLastError(), "");
  }
}

TEST(Plan, OnlyOneOfTwoShadowTechniquesTakesPart)
{
  Scene scene;
  vtkNew<vtkLight> lamp; // from the side: a headlight's shadows are hidden
  lamp->SetPosition(4.0, 2.0, 1.0);
  scene.Renderer->AddLight(lamp);
  vtkGIPass* pass = scene.SetPass();
  vtkGITechnique* traced = pass->GetTechnique("ray-traced-shadows");
  vtkGITechnique* mapped = pass->GetTechnique("shadow-maps");
  mapped->EnabledOn();
  mapped->SetParameter("resolution", 256); // coarse, to tell its shadows from the others
  const Picture byMaps = Shoot(scene.Window);
  mapped->EnabledOff();
  traced->EnabledOn();
  pass->Restart(); // the same noise as below
  const Picture byRays = Shoot(scene.Window);
  EXPECT_STREQ(pass->GetNotes(), "");
  EXPECT_LT(Compare(byMaps, byRays, 2).Within, 0.999) << "the two cannot be told apart here";
  mapped->EnabledOn();
  for (unsigned int seed = 1; seed <= 4; ++seed)
  {
    vtkGIPassOrder::Shuffle(pass, seed);
    pass->Restart();
    EXPECT_EQ(Compare(byRays, Shoot(scene.Window), 0).Within, 1.0);
    EXPECT_STREQ(pass->GetLastError(), "");
    EXPECT_STREQ(pass->GetNotes(),
      "shadow-maps is not used, because ray-traced-shadows, which is on too, takes its place");
    EXPECT_TRUE(traced->GetTookPart());
    EXPECT_FALSE(mapped->GetTookPart());
  }
}
}
}
