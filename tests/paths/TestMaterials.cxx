// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays through the centres of pixels see materials as VTK draws them. The scenes are the parity cases with a headlight,
// where no visible surface is in shadow.
#include "../parity/Cases.h"
#include "Agreement.h"

#include "vtkGITechnique.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <ostream>
#include <string>

using namespace penumbra_test;

namespace
{
// Cases in which rays draw something else than the rasterizer on purpose, or by chance, with the reason.
const std::map<std::string, const char*> Excluded = {
  { "ambient", "emitters light their neighbours" },
  { "texture, specular and ambient", "emitters light their neighbours" },
  { "physically based, every texture", "emitters light their neighbours" },
  { "physically based, two lights", "the lamps cast shadows" },
  { "physically based, environment", "the environment is traced, not filtered" },
  { "physically based, irradiance texture", "as above" },
  { "physically based, textures, environment", "as above" },
  { "physically based, environment, no light", "as above" },
  { "texture with alpha", "rays pass translucent surfaces by chance" },
  { "texture with alpha, masked", "as above" },
  { "camera rolled, user transform", "VTK lights a sheared scene; rays see it as it is" },
  { "edges as tubes", "edges are lines to rays" },
};

ParityCases Comparable()
{
  ParityCases comparable;
  for (const ParityCases& group : { SurfaceCases(), MaterialCases(), MapperCases(), ViewCases() })
  {
    std::copy_if(group.begin(), group.end(), std::back_inserter(comparable),
      [](const ParityCase& row) { return Excluded.count(row.Name) == 0; });
  }
  return comparable;
}

class Materials : public testing::TestWithParam<ParityCase>
{
};
}

TEST_P(Materials, EqualTheRasterizers)
{
  Stage stage;
  GetParam().Build(stage);
  auto pass = stage.SetPasses().front();
  vtkGITechnique* paths = pass->GetTechnique("path-tracing");
  paths->EnabledOn();
  paths->SetParameter("bounces", 0);
  paths->SetParameter("samples", 1);
  const Picture rays = Shoot(stage.Window);
  const std::string notes = pass->GetNotes();
  paths->EnabledOff();
  const Picture raster = Shoot(stage.Window);
  const Difference found = Compare(rays, raster, 3);
  std::printf("%-50s %.4f %s\n", GetParam().Name, found.Within, notes.c_str());
  // The rest are pixels on edges, and highlights of metal, because the G-buffer keeps eight bits of roughness. Drivers
  // disagree about a pixel or two on edges, which is more than that share of a tiny picture.
  const double pixels = static_cast<double>(raster.Width) * raster.Height;
  EXPECT_LE((1.0 - found.Within) * pixels, std::max(0.008 * pixels, 2.5));
  if (testing::Test::HasFailure())
  {
    Save(raster, GetParam().Id() + "-raster");
    Save(rays, GetParam().Id() + "-rays");
    Save(Amplified(raster, rays), GetParam().Id() + "-difference");
  }
}

TEST(ExcludedMaterials, Exist)
{
  const ParityCases all = AllCases();
  EXPECT_EQ(std::count_if(all.begin(), all.end(),
              [](const ParityCase& row) { return Excluded.count(row.Name) != 0; }),
    static_cast<std::ptrdiff_t>(Excluded.size()))
    << "an excluded case does not exist";
}

INSTANTIATE_TEST_SUITE_P(Cases, Materials, testing::ValuesIn(Comparable()),
  [](const auto& info) { return info.param.Id(); });
