// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// In a multisampled window the pass smooths edges its own way: after a few still frames the picture
// is VTK's again, but for the tones along edges.
#include "Cases.h"
#include "Messages.h"
#include "Picture.h"

#include <cstdio>

namespace penumbra_test
{
namespace
{
const std::vector<std::string> Chosen = { "specular", "lines wide", "texture", "physically based",
  "glyphs", "clipping plane", "viewports with gaps", "layer above", "text" };

ParityCases ChosenCases()
{
  ParityCases cases;
  for (const auto& row : AllCases())
  {
    if (std::find(Chosen.begin(), Chosen.end(), row.Name) != Chosen.end())
    {
      cases.push_back(row);
    }
  }
  return cases;
}

class Multisampled : public testing::TestWithParam<ParityCase>
{
};

TEST_P(Multisampled, ComesCloseToStock)
{
  const ParityCase& row = GetParam();
  Stage plain;
  plain.Window->SetMultiSamples(8);
  row.Build(plain);
  const Picture stock = Shoot(plain.Window);
  Stage stage;
  stage.Window->SetMultiSamples(8);
  row.Build(stage);
  const auto passes = stage.SetPasses();
  const Difference first = Compare(stock, Shoot(stage.Window), 8);
  for (int frame = 0; frame < 8; ++frame)
  {
    stage.Window->Render();
  }
  const Difference still = Compare(stock, Shoot(stage.Window), 8);
  std::printf("%-24s within 8: first frame %.4f, still %.4f; mean %.3f, %.3f\n", row.Name,
    first.Within, still.Within, first.Mean, still.Mean);
  EXPECT_GT(first.Within, 0.9);
  // What is left: eight samples know nine tones of an edge.
  EXPECT_GT(still.Within, 0.95);
  EXPECT_LT(still.Mean, 1.0);
  for (const auto& pass : passes)
  {
    EXPECT_STREQ("", pass->GetLastError());
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, Multisampled, testing::ValuesIn(ChosenCases()),
  [](const auto& info) { return info.param.Id(); });
}
}
