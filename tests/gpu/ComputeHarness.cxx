// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ComputeHarness.h"

#include "gpu/GLObjects.h"

namespace penumbra_test
{
using namespace penumbra;

void ComputeHarness::TearDown()
{
  if (this->Window)
  {
    this->Window->MakeCurrent();
    this->Library.Release();
  }
}

std::vector<glm::vec4> ComputeHarness::Run(const std::vector<std::string>& includes,
  const std::string& body, int stride, const std::vector<glm::vec4>& inputs, const Defines& defines)
{
  const auto count = static_cast<GLuint>(inputs.size() / stride);
  std::string text = "#version 430 core\nlayout(local_size_x = 64) in;\n";
  for (const auto& define : defines)
  {
    text += "#define " + define.first + " " + define.second + "\n";
  }
  for (const auto& include : includes)
  {
    text += this->Library.Source(include);
  }
  text += "layout(std430, binding = 6) readonly buffer Inputs { vec4 inputs[]; };\n"
          "layout(std430, binding = 7) writeonly buffer Results { vec4 results[]; };\n"
          "uniform int count;\n"
          "#define IN(k) inputs[gl_GlobalInvocationID.x * " +
    std::to_string(stride) +
    "u + uint(k)]\n"
    "#define RESULT results[gl_GlobalInvocationID.x]\n"
    "void main()\n{\n  if (gl_GlobalInvocationID.x >= uint(count)) { return; }\n" +
    body + "\n}\n";

  const char* source = text.c_str();
  const Program program(glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &source));
  GLint linked = GL_FALSE;
  glGetProgramiv(program.Get(), GL_LINK_STATUS, &linked);
  char log[2048] = "";
  glGetProgramInfoLog(program.Get(), sizeof(log), nullptr, log);
  EXPECT_TRUE(linked) << log << "\n" << text;
  if (!linked)
  {
    return std::vector<glm::vec4>(count);
  }

  Buffer input;
  Buffer output;
  std::vector<glm::vec4> results(count, glm::vec4(-1e30f));
  input.Upload(GL_SHADER_STORAGE_BUFFER, inputs.data(), inputs.size() * sizeof(inputs[0]));
  output.Upload(GL_SHADER_STORAGE_BUFFER, results.data(), results.size() * sizeof(results[0]));
  input.BindBase(GL_SHADER_STORAGE_BUFFER, 6);
  output.BindBase(GL_SHADER_STORAGE_BUFFER, 7);
  glUseProgram(program.Get());
  program.SetValues(Arguments().Set("count", static_cast<int>(count)));
  glDispatchCompute((count + 63) / 64, 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  GLint name = 0;
  glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, 7, &name);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(name));
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0,
    static_cast<GLsizeiptr>(results.size() * sizeof(results[0])), results.data());
  glUseProgram(0);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  return results;
}

std::vector<glm::dvec3> UnitVectors(int count)
{
  std::vector<glm::dvec3> vectors;
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 v(0.0);
    v[axis] = 1.0;
    vectors.push_back(v);
    vectors.push_back(-v);
  }
  // A spiral from pole to pole: Saff and Kuijlaars 1997, Distributing Many Points on a Sphere.
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double r = std::sqrt(1.0 - z * z);
    const double angle = 2.39996323 * i;
    vectors.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  return vectors;
}
}
