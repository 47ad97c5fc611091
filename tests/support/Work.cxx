// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Work.h"

#include "gpu/GL.h"

#include <nlohmann/json.hpp>

namespace penumbra_test
{
namespace
{
constexpr int KeepsUnused = 40; // frames, and more
}

FrameWork WorkOfFrame(Stage& stage, vtkGIPass* pass)
{
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  const auto next = [&] {
    camera->Azimuth(1e-3); // nothing is averaged
    stage.Window->Render();
  };
  for (int i = 0; i < KeepsUnused; ++i)
  {
    next();
  }
  FrameWork work;
  stage.Window->MakeCurrent();
  GLuint query = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  next();
  glEndQuery(GL_SAMPLES_PASSED);
  GLuint samples = 0;
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
  glDeleteQueries(1, &query);
  work.Samples = samples;
  const auto statistics = nlohmann::json::parse(pass->GetStatistics());
  for (const auto& row : statistics.at("passes"))
  {
    work.Passes.insert(row.at("name").get<std::string>());
  }
  work.Bytes = statistics.at("bytes").get<long>();
  return work;
}
}
