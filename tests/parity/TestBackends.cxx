// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// EGL and OSMesa draw the same picture where both use the same software driver.
#include "Cases.h"
#include "Picture.h"

#include <cstdio>
#include <cstring>
#include <set>

namespace penumbra_test
{
namespace
{
// One case of each kind.
const std::set<std::string> ComparedCases = { "specular", "edges as tubes", "points as spheres",
  "scalars per cell", "opacity masked", "texture, specular and ambient",
  "physically based, textures, environment", "glyphs coloured", "composite, block colours",
  "sphere impostors", "clipping planes, backface property", "lights of every type",
  "viewports with gaps", "odd window", "side-by-side stereo", "translucent, depth peeling",
  "volume with a surface", "every annotation" };

Picture ShootWith(int backend, const ParityCase& row, const char* preset)
{
  Stage stage(backend);
  row.Build(stage);
  for (const auto& pass : stage.SetPasses())
  {
    pass->SetPreset(preset);
  }
  return Shoot(stage.Window);
}

TEST(Backends, EglAndOSMesaAgree)
{
  if (!HasBackend(vtkHeadlessRenderWindow::EGL) || !HasBackend(vtkHeadlessRenderWindow::OSMESA))
  {
    GTEST_SKIP() << "needs both backends";
  }
  vtkNew<vtkHeadlessRenderWindow> window;
  window->SetBackendToEGL();
  if (!std::strstr(window->GetDescription(), "llvmpipe"))
  {
    GTEST_SKIP() << "EGL uses a GPU here";
  }
  std::size_t compared = 0;
  for (const auto& row : AllCases())
  {
    if (ComparedCases.count(row.Name) == 0)
    {
      continue;
    }
    for (const char* preset : { "off", "balanced" })
    {
      const Picture egl = ShootWith(vtkHeadlessRenderWindow::EGL, row, preset);
      const Picture osmesa = ShootWith(vtkHeadlessRenderWindow::OSMESA, row, preset);
      const Difference found = Compare(egl, osmesa, 1);
      std::printf("%-44s %-9s largest difference %d\n", row.Name, preset, found.Max);
      EXPECT_LE(found.Max, 1) << row.Name << " " << preset;
      EXPECT_GT(Busyness(egl), 0.005) << row.Name;
    }
    ++compared;
  }
  EXPECT_EQ(compared, ComparedCases.size()) << "a compared case does not exist";
}
}
}
