// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gpu/GpuTimer.h"

#include <algorithm>

namespace penumbra
{
namespace
{
// Mesa's software renderers run compute shaders at once but rasterize later, so their timestamps tell nothing.
bool HasTimestamps()
{
  GLint bits = 0;
  glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
  return bits > 0 && !IsSoftwareContext();
}

double MillisecondsBetween(
  std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to)
{
  return std::chrono::duration<double, std::milli>(to - from).count();
}
}

GpuTimer::GpuTimer(Method method)
  : UsesClock(method == Method::Clock || (method == Method::Automatic && !HasTimestamps()))
{
}

void GpuTimer::BeginFrame(long long number)
{
  Slot& slot = this->Ring[this->Next];
  this->Current = slot.Waiting ? nullptr : &slot;
  this->Stamps = 0;
  this->Beginning = Clock::now();
  this->LastMark = this->Beginning;
  if (this->Current)
  {
    slot.Frame = TimedFrame();
    slot.Frame.Number = number;
    this->Stamp();
  }
}

void GpuTimer::Stamp()
{
  if (this->UsesClock)
  {
    return;
  }
  std::vector<QueryHandle>& queries = this->Current->Queries;
  if (this->Stamps == queries.size())
  {
    GLuint query = 0;
    glGenQueries(1, &query);
    queries.emplace_back(query);
  }
  glQueryCounter(queries[this->Stamps++].Get(), GL_TIMESTAMP);
}

void GpuTimer::Mark(const std::string& name, const std::string& technique)
{
  if (!this->Current)
  {
    return;
  }
  double milliseconds = 0.0;
  if (this->UsesClock)
  {
    glFinish();
    const Clock::time_point now = Clock::now();
    milliseconds = MillisecondsBetween(this->LastMark, now);
    this->LastMark = now;
  }
  this->Stamp();
  this->Current->Frame.Spans.push_back({ name, technique, milliseconds });
}

void GpuTimer::EndFrame()
{
  if (this->Current)
  {
    this->Current->Processor = MillisecondsBetween(this->Beginning, Clock::now());
    this->Current->Waiting = true;
    this->Current = nullptr;
    this->Next = (this->Next + 1) % this->Ring.size();
  }
}

bool GpuTimer::ReadSlot(Slot& slot, bool wait) const
{
  TimedFrame& frame = slot.Frame;
  frame.Milliseconds = slot.Processor;
  if (this->UsesClock || frame.Spans.empty())
  {
    return true;
  }
  if (!wait)
  {
    // The GPU writes them in order.
    GLuint ready = 0;
    glGetQueryObjectuiv(slot.Queries[frame.Spans.size()].Get(), GL_QUERY_RESULT_AVAILABLE, &ready);
    if (!ready)
    {
      return false;
    }
  }
  GLuint64 first = 0;
  glGetQueryObjectui64v(slot.Queries[0].Get(), GL_QUERY_RESULT, &first);
  GLuint64 last = first;
  for (std::size_t i = 0; i < frame.Spans.size(); ++i)
  {
    GLuint64 end = 0;
    glGetQueryObjectui64v(slot.Queries[i + 1].Get(), GL_QUERY_RESULT, &end);
    frame.Spans[i].Milliseconds = 1e-6 * static_cast<double>(end > last ? end - last : 0);
    last = std::max(last, end);
  }
  frame.Milliseconds = std::max(slot.Processor, 1e-6 * static_cast<double>(last - first));
  return true;
}

std::vector<TimedFrame> GpuTimer::Read(bool wait)
{
  std::vector<TimedFrame> frames;
  for (std::size_t i = 0; i < this->Ring.size(); ++i)
  {
    Slot& slot = this->Ring[(this->Next + i) % this->Ring.size()];
    if (!slot.Waiting)
    {
      continue;
    }
    if (!this->ReadSlot(slot, wait))
    {
      break;
    }
    slot.Waiting = false;
    frames.push_back(std::move(slot.Frame));
  }
  return frames;
}
}
