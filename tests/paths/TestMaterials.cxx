// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays see materials as VTK draws them: the parity cases that a headlight lights, whose surfaces
// nothing shadows, through the centres of pixels.
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
// Where rays mean to draw something else than the raster path does, or leave it to chance.
const std::map<std::string, const char*> Others = {
  { "ambient", "what emits lights its neighbours" },
  { "texture, specular and ambient", "what emits lights its neighbours" },
  { "physically based, every texture", "what emits lights its neighbours" },
  { "physically based, two lights", "the lamps cast shadows" },
  { "physically based, environment", "the surroundings are traced, not filtered beforehand" },
  { "physically based, irradiance texture", "as above" },
  { "physically based, textures, environment", "as above" },
  { "physically based, environment, no light", "as above" },
  { "texture with alpha", "rays pass what is translucent by chance" },
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
      [](const ParityCase& row) { return Others.count(row.Name) == 0; });
  }
  return comparable;
}

class Materials : public testing::TestWithParam<ParityCase>
{
};
}

TEST_P(Materials, AsDrawn)
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
  // All but those that an edge runs through, and highlights of metal, for which the raster path
  // keeps eight bits of roughness.
  EXPECT_GE(found.Within, 0.992);
  if (testing::Test::HasFailure())
  {
    Save(raster, GetParam().Id() + "-raster");
    Save(rays, GetParam().Id() + "-rays");
    Save(Amplified(raster, rays), GetParam().Id() + "-difference");
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, Materials, testing::ValuesIn(Comparable()),
  [](const auto& info) { return info.param.Id(); });
