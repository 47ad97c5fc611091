// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lab/BiasReport.h"
#include "lab/BiasStudy.h"
#include "lab/BiasSweep.h"

#include <gtest/gtest.h>
#include <vtkGIPass.h>
#include <vtkGITechnique.h>
#include <vtkNew.h>

#include <algorithm>

using namespace penumbra::tool;

namespace
{
BiasSweep SweepOf(const std::vector<std::array<double, 2>>& acneAndGap)
{
  BiasSweep sweep{ "constant", "constant-bias", {} };
  for (const auto& [acne, gap] : acneAndGap)
  {
    BiasSample sample;
    sample.Bias = 0.5 * sweep.Samples.size();
    sample.Errors.Acne = acne;
    sample.Errors.Contact.Texels = gap;
    sweep.Samples.push_back(sample);
  }
  return sweep;
}
}

TEST(BiasSweep, WindowLiesBetweenAcneAndGap)
{
  const auto window =
    SweepOf({ { 0.4, 0 }, { 0.0009, 0.2 }, { 0.0002, 0.5 }, { 0, 0.8 }, { 0, 1.1 } }).Window({});
  ASSERT_TRUE(window);
  EXPECT_EQ(window->Low, 0.5);
  EXPECT_EQ(window->High, 1.5);
  EXPECT_EQ(window->Choice, 1.0);
  EXPECT_FALSE(window->ReachesEnd);
}

TEST(BiasSweep, TheChoiceIsAsFarFromAcneAsFromGaps)
{
  // The best sample, the first, is next to acne.
  const BiasSweep sweep = SweepOf({ { 0.4, 0 }, { 0, 0.1 }, { 0, 0.4 }, { 0, 0.7 }, { 0, 1.2 } });
  EXPECT_EQ(sweep.Window({})->Choice, 1.0);
  EXPECT_EQ(sweep.Best({}).Bias, 1.0);
  // Without acne at the smallest bias there is nothing to keep away from.
  EXPECT_EQ(SweepOf({ { 0, 0 }, { 0, 0.4 }, { 0, 0.7 }, { 0, 1.2 } }).Window({})->Choice, 0);
}

TEST(BiasSweep, TheLimitsAreWithin)
{
  const auto window = SweepOf({ { 0.001, 1 }, { 0.0011, 1 }, { 0.001, 1.01 } }).Window({});
  ASSERT_TRUE(window);
  EXPECT_EQ(window->Low, 0);
  EXPECT_EQ(window->High, 0);
}

TEST(BiasSweep, TheWidestOfTwoWindows)
{
  const auto window =
    SweepOf({ { 0, 0.3 }, { 0, 2 }, { 0, 0.5 }, { 0, 0.4 }, { 0, 0.9 } }).Window({});
  ASSERT_TRUE(window);
  EXPECT_EQ(window->Low, 1);
  EXPECT_EQ(window->High, 2);
  EXPECT_EQ(window->Choice, 1.5);
  EXPECT_TRUE(window->ReachesEnd);
}

TEST(BiasSweep, NoWindowStillHasANearest)
{
  const BiasSweep sweep = SweepOf({ { 0.5, 0 }, { 0.003, 1.5 }, { 0.0015, 6 } });
  EXPECT_FALSE(sweep.Window({}));
  EXPECT_EQ(sweep.Best({}).Bias, 0.5);
}

TEST(BiasSweep, OutlinesAreGapsToo)
{
  BiasErrors errors;
  errors.Outline.Texels = 1.5;
  EXPECT_EQ(ShareOfLimits(errors, {}), 1.5);
  errors.Acne = 0.002;
  EXPECT_EQ(ShareOfLimits(errors, {}), 2);
}

TEST(BiasSweep, EvenSteps)
{
  EXPECT_EQ(EvenSteps(0, 1, 5), (std::vector<double>{ 0, 0.25, 0.5, 0.75, 1 }));
  EXPECT_EQ(EvenSteps(0.1, 0.3, 2), (std::vector<double>{ 0.1, 0.3 }));
}

TEST(BiasSweep, KindsComeFromTheDeclaredParameters)
{
  vtkNew<vtkGIPass> pass;
  vtkGITechnique* maps = pass->GetTechnique("shadow-maps");
  const std::vector<std::string> kinds = BiasKinds(maps);
  for (const char* kind : { "constant", "slope" })
  {
    EXPECT_EQ(std::count(kinds.begin(), kinds.end(), kind), 1) << kind;
  }
  for (const std::string& kind : kinds)
  {
    EXPECT_TRUE(maps->SetParameter((kind + "-bias").c_str(), 1)) << kind;
  }
  EXPECT_TRUE(BiasKinds(pass->GetTechnique("anti-aliasing")).empty());
}

TEST(BiasStudy, ResolutionWhoseTexelsAreSeen)
{
  EXPECT_EQ(ChooseResolution(0.5, 2048), 2048); // a texel is two pixels already
  EXPECT_EQ(ChooseResolution(0.51, 2048), 1024);
  EXPECT_EQ(ChooseResolution(4, 2048), 256);
  EXPECT_EQ(ChooseResolution(1e9, 2048), 64);
}

TEST(BiasReport, WindowsInWords)
{
  const auto words = [](const std::vector<std::array<double, 2>>& acneAndGap) {
    return SummarizeWindow(SweepOf(acneAndGap), {});
  };
  EXPECT_EQ(words({ { 1, 0 }, { 0, 0.2 }, { 0, 0.5 }, { 0, 0.8 }, { 0, 2 } }),
    "safe from 0.5 to 1.5 texels; take 1");
  EXPECT_EQ(
    words({ { 1, 0 }, { 0, 0.2 }, { 0, 0.5 } }), "safe from 0.5 to 1 texels at least; take 0.5");
  EXPECT_EQ(words({ { 1, 0 }, { 0, 0.2 }, { 0, 2 } }), "safe at 0.5 texels only; take that");
  EXPECT_EQ(words({ { 1, 0 }, { 0, 0.2 } }), "safe from 0.5 to 0.5 texels at least; take 0.5");
  EXPECT_EQ(words({ { 1, 0 }, { 0.01, 2 } }), "none safe from 0 to 0.5 texels; nearest 0.5");
}

TEST(BiasReport, Percentages)
{
  EXPECT_EQ(FormatPercent(0), "0 %");
  EXPECT_EQ(FormatPercent(1e-7), "under 0.001 %");
  EXPECT_EQ(FormatPercent(0.00123), "0.12 %");
  EXPECT_EQ(FormatPercent(0.1234), "12 %");
  EXPECT_EQ(FormatPercent(1), "100 %");
}
