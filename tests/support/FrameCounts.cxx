// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameCounts.h"

#include "gpu/GL.h"

#include <nlohmann/json.hpp>

namespace penumbra_test
{
namespace
{
constexpr int WarmUpFrames = 40; // more than ResourcePool's IdleLimit
}

FrameCounts CountFrame(Stage& stage, vtkGIPass* pass)
{
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  const auto drawFrame = [&] {
    camera->Azimuth(1e-3); // so that no frame is an average
    stage.Window->Render();
  };
  for (int i = 0; i < WarmUpFrames; ++i)
  {
    drawFrame();
  }
  FrameCounts counts;
  stage.Window->MakeCurrent();
  GLuint query = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  drawFrame();
  glEndQuery(GL_SAMPLES_PASSED);
  GLuint samples = 0;
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
  glDeleteQueries(1, &query);
  counts.Samples = samples;
  const auto statistics = nlohmann::json::parse(pass->GetStatistics());
  for (const auto& row : statistics.at("passes"))
  {
    counts.Passes.insert(row.at("name").get<std::string>());
  }
  counts.Bytes = statistics.at("bytes").get<long>();
  return counts;
}
}
