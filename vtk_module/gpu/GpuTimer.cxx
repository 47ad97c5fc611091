// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gpu/GpuTimer.h"

namespace penumbra
{
// Mesa's software renderers run compute shaders at once but rasterize later, so a query does not enclose a dispatch.
GpuTimer::GpuTimer()
  : UsesClock(IsSoftwareContext())
{
}

void GpuTimer::Begin(const std::string& name)
{
  if (this->UsesClock)
  {
    glFinish();
    this->Measured.push_back({ name, 0.0 });
    this->Start = std::chrono::steady_clock::now();
    return;
  }
  GLuint query = 0;
  glGenQueries(1, &query);
  this->Names.push_back(name);
  this->Queries.emplace_back(query);
  glBeginQuery(GL_TIME_ELAPSED, query);
}

void GpuTimer::End()
{
  if (this->UsesClock)
  {
    glFinish();
    const std::chrono::duration<double, std::milli> elapsed =
      std::chrono::steady_clock::now() - this->Start;
    this->Measured.back().Milliseconds = elapsed.count();
    return;
  }
  glEndQuery(GL_TIME_ELAPSED);
}

std::vector<GpuTimer::Span> GpuTimer::Collect()
{
  std::vector<Span> spans = std::move(this->Measured);
  for (std::size_t i = 0; i < this->Queries.size(); ++i)
  {
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(this->Queries[i].Get(), GL_QUERY_RESULT, &nanoseconds);
    spans.push_back({ this->Names[i], static_cast<double>(nanoseconds) * 1e-6 });
  }
  this->Names.clear();
  this->Queries.clear();
  return spans;
}
}
