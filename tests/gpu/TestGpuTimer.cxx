// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Times of a frame's parts: by timestamps and by the clock.
#include "WindowTest.h"

#include "gpu/GpuTimer.h"

using namespace penumbra;
using namespace penumbra_test;

namespace
{
class GpuTimerTest
  : public WindowTest
  , public testing::WithParamInterface<GpuTimer::Method>
{
protected:
  static void TimeFrame(GpuTimer& timer, long long number)
  {
    timer.BeginFrame(number);
    for (const char* name : { "first", "second" })
    {
      glClear(GL_COLOR_BUFFER_BIT);
      timer.Mark(name, std::string("technique of ") + name);
    }
    timer.EndFrame();
  }
};
}

TEST_P(GpuTimerTest, TellsEachPartOfAFrame)
{
  GpuTimer timer(GetParam());
  TimeFrame(timer, 7);
  const auto frames = timer.Wait();
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].Number, 7);
  ASSERT_EQ(frames[0].Spans.size(), 2u);
  EXPECT_EQ(frames[0].Spans[0].Name, "first");
  EXPECT_EQ(frames[0].Spans[1].Technique, "technique of second");
  double sum = 0.0;
  for (const TimedSpan& span : frames[0].Spans)
  {
    EXPECT_GE(span.Milliseconds, 0.0);
    sum += span.Milliseconds;
  }
  EXPECT_LE(sum, frames[0].Milliseconds * (1.0 + 1e-9));
  EXPECT_GT(frames[0].Milliseconds, 0.0);
  EXPECT_TRUE(timer.Wait().empty()) << "a frame is told once";
}

TEST_P(GpuTimerTest, KeepsFourFramesThatNobodyHasRead)
{
  GpuTimer timer(GetParam());
  for (int number = 0; number < 6; ++number)
  {
    TimeFrame(timer, number);
  }
  const auto frames = timer.Wait();
  ASSERT_EQ(frames.size(), 4u);
  EXPECT_EQ(frames.front().Number, 0);
  EXPECT_EQ(frames.back().Number, 3);
  TimeFrame(timer, 6);
  ASSERT_EQ(timer.Wait().size(), 1u);
}

TEST_P(GpuTimerTest, ForgetsAFrameThatDidNotEnd)
{
  GpuTimer timer(GetParam());
  timer.BeginFrame(0);
  timer.Mark("first");
  TimeFrame(timer, 1);
  const auto frames = timer.Wait();
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].Number, 1);
  EXPECT_EQ(frames[0].Spans.size(), 2u);
}

INSTANTIATE_TEST_SUITE_P(Methods, GpuTimerTest,
  testing::Values(GpuTimer::Method::Timestamps, GpuTimer::Method::Clock), [](const auto& instance) {
    return instance.param == GpuTimer::Method::Clock ? "clock" : "timestamps";
  });
