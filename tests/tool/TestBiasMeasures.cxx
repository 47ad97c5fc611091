// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Masks made by hand, whose acne and gaps can be counted on a floor seen from straight above.
#include "lab/BiasMeasures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace penumbra::tool;

namespace
{
constexpr int Width = 80;
constexpr int Height = 40;
constexpr double Pixel = 0.25; // world units
constexpr double Texels = 0.5; // a pixel's width
constexpr int Wall = 20;       // the column of what stands on the floor and is turned away
constexpr int ShadowEnd = 50;  // the first lit column behind it

std::size_t At(int x, int y)
{
  return std::size_t(y) * Width + x;
}

/// Lit, then a wall of one column, then its shadow, then lit again.
LitView Floor()
{
  LitView view;
  view.Width = Width;
  view.Height = Height;
  view.Surface.assign(view.PixelCount(), 1);
  view.Receiver.assign(view.PixelCount(), 1);
  view.Light.assign(view.PixelCount(), 1);
  view.Truth.assign(view.PixelCount(), 1);
  view.Place.resize(view.PixelCount());
  view.Across.resize(view.PixelCount());
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const std::size_t i = At(x, y);
      view.Place[i] = { x * Pixel, y * Pixel, 0 };
      view.Across[i] = { x * Texels, y * Texels, 0 };
      view.Receiver[i] = x != Wall;
      view.Truth[i] = x >= Wall && x < ShadowEnd ? 0.0f : 1.0f;
    }
  }
  return view;
}

void Fill(std::vector<float>& mask, int left, int right, float value)
{
  for (int y = 0; y < Height; ++y)
  {
    std::fill(mask.begin() + At(left, y), mask.begin() + At(right, y), value);
  }
}

BiasJudge JudgeOf(const LitView& view, double band = 1.5)
{
  return BiasJudge(view, view.Truth, band);
}
}

TEST(BiasMeasures, TruthHasNoError)
{
  const LitView view = Floor();
  const BiasJudge judge = JudgeOf(view);
  const BiasErrors errors = judge.Measure(view.Truth);
  EXPECT_EQ(errors.Acne, 0);
  EXPECT_EQ(errors.Leak, 0);
  EXPECT_EQ(errors.Gap(), 0);
  EXPECT_EQ(judge.ContactPoints(), std::size_t(Height));
  EXPECT_EQ(judge.OutlinePoints(), std::size_t(Height));
  EXPECT_EQ(judge.Lost(), 0);
}

TEST(BiasMeasures, AcneIsTheShareOfTheLight)
{
  const LitView view = Floor();
  std::vector<float> mask = view.Truth;
  // A quarter of the light, from every second of the lit pixels.
  for (int y = 0; y < Height; ++y)
  {
    for (int x = y % 2; x < Width; x += 2)
    {
      mask[At(x, y)] *= 0.75f;
    }
  }
  EXPECT_NEAR(JudgeOf(view).Measure(mask).Acne, 0.125, 1e-9);
  EXPECT_EQ(JudgeOf(view).Measure(mask).Leak, 0);
}

TEST(BiasMeasures, WhereItIsDimmerErrorsWeighLess)
{
  LitView view = Floor();
  for (int y = 0; y < Height; ++y)
  {
    std::fill(view.Light.begin() + At(0, y), view.Light.begin() + At(Wall, y), 0.25f);
  }
  std::vector<float> mask = view.Truth;
  Fill(mask, 0, Wall, 0);
  // The columns in front of the wall but the last three, and those behind the shadow but the first four.
  const double before = 0.25 * (Wall - 3), behind = Width - ShadowEnd - 4;
  EXPECT_NEAR(JudgeOf(view).Measure(mask).Acne, before / (before + behind), 1e-9);
  // Contact leaks at one of ten points, which are as good as dark: less than a twentieth of the light.
  mask = view.Truth;
  for (int y = 0; y < Height; ++y)
  {
    view.Light[At(Wall + 1, y)] = y % 10 == 0 ? 0.1f : 1.0f;
    mask[At(Wall + 1, y)] = y % 10 == 0 ? 1.0f : 0.0f;
  }
  EXPECT_EQ(JudgeOf(view).Measure(mask).Contact.World, 0);
  std::fill(view.Light.begin(), view.Light.end(), 1.0f);
  // A pixel by itself is dark on both sides: nearest begins the shadow there.
  EXPECT_NEAR(JudgeOf(view).Measure(mask).Contact.World, std::hypot(0.5, 0.5) * Pixel, 1e-9);
}

TEST(BiasMeasures, EdgesAreNoAcne)
{
  const LitView view = Floor();
  std::vector<float> mask = view.Truth;
  // Three pixels are one texel and a half: within the band.
  Fill(mask, ShadowEnd, ShadowEnd + 3, 0);
  EXPECT_EQ(JudgeOf(view).Measure(mask).Acne, 0);
  Fill(mask, ShadowEnd, ShadowEnd + 6, 0);
  EXPECT_GT(JudgeOf(view).Measure(mask).Acne, 0);
  EXPECT_EQ(JudgeOf(view, 3.5).Measure(mask).Acne, 0);
}

TEST(BiasMeasures, GapAtContact)
{
  const LitView view = Floor();
  for (const int pixels : { 1, 4, 9 })
  {
    std::vector<float> mask = view.Truth;
    Fill(mask, Wall + 1, Wall + 1 + pixels, 1);
    const BiasErrors errors = JudgeOf(view).Measure(mask);
    EXPECT_NEAR(errors.Contact.World, pixels * Pixel, 1e-9);
    EXPECT_NEAR(errors.Contact.Texels, pixels * Texels, 1e-9);
    EXPECT_EQ(errors.Outline.World, 0);
    EXPECT_EQ(errors.Acne, 0);
  }
}

TEST(BiasMeasures, GapAtTheOutline)
{
  const LitView view = Floor();
  std::vector<float> mask = view.Truth;
  Fill(mask, ShadowEnd - 6, ShadowEnd, 1);
  const BiasErrors errors = JudgeOf(view).Measure(mask);
  EXPECT_EQ(errors.Contact.World, 0);
  EXPECT_NEAR(errors.Outline.World, 6 * Pixel, 1e-9);
  EXPECT_NEAR(errors.Gap(), 6 * Texels, 1e-9);
  EXPECT_GT(errors.Leak, 0);
}

TEST(BiasMeasures, StrayPixelsAreNoGap)
{
  const LitView view = Floor();
  std::vector<float> mask = view.Truth;
  mask[At(Wall + 1, 7)] = 1; // one of forty points of contact
  EXPECT_EQ(JudgeOf(view).Measure(mask).Contact.World, 0);
}

TEST(BiasMeasures, AShadowThatIsGoneIsAsWideAsItWas)
{
  const LitView view = Floor();
  const BiasErrors errors = JudgeOf(view).Measure(std::vector<float>(view.PixelCount(), 1.0f));
  // No dark pixel is left to measure to: the patch's diagonal, from pixel centre to pixel centre.
  EXPECT_NEAR(errors.Contact.World, std::hypot(ShadowEnd - Wall - 2, Height - 1) * Pixel, 1e-9);
  EXPECT_EQ(errors.Leak, 1);
}

TEST(BiasMeasures, WhatTheMapCannotShowCountsForNothing)
{
  LitView view = Floor();
  std::vector<float> unbiased = view.Truth;
  for (int y = 10; y < 12; ++y)
  {
    view.Truth[At(70, y)] = 0; // a speck that the map misses at any bias
  }
  const BiasJudge judge(view, unbiased, 1.5);
  EXPECT_EQ(judge.OutlinePoints(), std::size_t(Height));
  const double dark = (ShadowEnd - Wall - 1) * Height + 2;
  EXPECT_NEAR(judge.Lost(), 2 / dark, 1e-9);
  const BiasErrors errors = judge.Measure(unbiased);
  EXPECT_EQ(errors.Gap(), 0);
  EXPECT_EQ(errors.Leak, 0);
}

TEST(BiasMeasures, WhatHangsInTheAirTouchesNothing)
{
  LitView view = Floor();
  for (int y = 0; y < Height; ++y)
  {
    view.Place[At(Wall, y)][2] = 5; // seen before the floor, high above it
  }
  const BiasJudge judge = JudgeOf(view);
  EXPECT_EQ(judge.ContactPoints(), 0u);
  EXPECT_EQ(judge.OutlinePoints(), std::size_t(Height));
}

TEST(BiasMeasures, WithoutAnyShadow)
{
  LitView view = Floor();
  std::fill(view.Truth.begin(), view.Truth.end(), 1.0f);
  const BiasJudge judge = JudgeOf(view);
  EXPECT_EQ(judge.ContactPoints() + judge.OutlinePoints(), 0u);
  EXPECT_EQ(judge.LitPixels(), std::size_t((Width - 1) * Height));
  EXPECT_EQ(judge.DarkPixels(), 0u);
  std::vector<float> mask(view.PixelCount(), 0.0f);
  EXPECT_EQ(judge.Measure(mask).Acne, 1);
  EXPECT_EQ(judge.Measure(mask).Gap(), 0);
}

TEST(BiasMeasures, PixelWidth)
{
  EXPECT_NEAR(MedianPixelWidth(Floor()), Texels, 1e-12);
  LitView nothing = Floor();
  std::fill(nothing.Receiver.begin(), nothing.Receiver.end(), 0);
  EXPECT_EQ(MedianPixelWidth(nothing), 0);
}
