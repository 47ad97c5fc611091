// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// In a multisampled window the pass anti-aliases edges itself. After a few frames at rest the picture equals stock
// VTK's, except for the tones along edges.
#include "Cases.h"
#include "Messages.h"
#include "Picture.h"

#include <cstdio>

namespace penumbra_test
{
namespace
{
const std::vector<std::string> ComparedNames = { "specular", "lines wide", "texture",
  "physically based", "glyphs", "clipping plane", "viewports with gaps", "layer above", "text" };

ParityCases ComparedCases()
{
  ParityCases cases;
  for (const auto& row : AllCases())
  {
    if (std::find(ComparedNames.begin(), ComparedNames.end(), row.Name) != ComparedNames.end())
    {
      cases.push_back(row);
    }
  }
  return cases;
}

class Multisampled : public testing::TestWithParam<ParityCase>
{
};

TEST_P(Multisampled, ConvergesToStock)
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
  // The rest is along edges, where eight samples give only nine tones.
  EXPECT_GT(still.Within, 0.95);
  EXPECT_LT(still.Mean, 1.0);
  for (const auto& pass : passes)
  {
    EXPECT_STREQ("", pass->GetLastError());
  }
}

TEST(MultisampledCases, Exist)
{
  EXPECT_EQ(ComparedCases().size(), ComparedNames.size()) << "a compared case does not exist";
}

INSTANTIATE_TEST_SUITE_P(Cases, Multisampled, testing::ValuesIn(ComparedCases()),
  [](const auto& info) { return info.param.Id(); });
}
}
