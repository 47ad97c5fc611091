// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pass/FrameStatistics.h"

#include "vtkGITechnique.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace penumbra
{
using nlohmann::ordered_json;

namespace
{
constexpr std::size_t HistoryFrames = 120; // two seconds of smooth motion

const char* ApproachOf(const TimedSpan& span, const FrameStatistics::Techniques& techniques)
{
  const auto owner = std::find_if(techniques.begin(), techniques.end(),
    [&span](vtkGITechnique* technique) { return span.Technique == technique->GetName(); });
  return owner == techniques.end() ? "none" : (*owner)->GetApproach();
}
}

void FrameStatistics::Add(TimedFrame frame, const Techniques& techniques)
{
  Sums sums = { { "frame", frame.Milliseconds } };
  for (const TimedSpan& span : frame.Spans)
  {
    const std::string approach = ApproachOf(span, techniques);
    sums[approach == "none" ? "rest" : approach] += span.Milliseconds;
  }
  this->History.push_back(std::move(sums));
  while (this->History.size() > HistoryFrames)
  {
    this->History.pop_front();
  }
  this->Last = std::move(frame);
}

std::string FrameStatistics::ToText(const Techniques& techniques, ordered_json budget) const
{
  ordered_json passes = ordered_json::array();
  double total = 0.0;
  for (const TimedSpan& span : this->Last.Spans)
  {
    passes.push_back({ { "name", span.Name }, { "milliseconds", span.Milliseconds },
      { "technique", span.Technique }, { "approach", ApproachOf(span, techniques) } });
    total += span.Milliseconds;
  }
  ordered_json all = { { "passes", passes }, { "milliseconds", total },
    { "textures", this->Textures }, { "bytes", this->Bytes }, { "lights", this->Lights },
    { "frames", this->Frames } };
  if (!budget.is_null())
  {
    budget["frame"] = this->Last.Milliseconds;
    budget["history"] = this->History;
    all["budget"] = std::move(budget);
  }
  return all.dump();
}
}
