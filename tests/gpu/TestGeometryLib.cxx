// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Functions of glsl/lib for normals, positions and noise.
#include "ComputeHarness.h"

#include "gpu/GLObjects.h"

#include "view.h"

#include <glm/gtc/matrix_transform.hpp>

namespace penumbra_test
{
namespace
{
using GeometryLib = ComputeHarness;

std::vector<glm::vec4> Pack(const std::vector<glm::dvec3>& vectors)
{
  std::vector<glm::vec4> packed;
  for (const auto& v : vectors)
  {
    packed.emplace_back(glm::vec3(v), 0.0f);
  }
  return packed;
}

TEST_F(GeometryLib, OctahedralRoundTrip)
{
  const auto vectors = UnitVectors(20000);
  const auto results = this->Run({ "lib/octahedral.glsl" },
    "vec2 e = giEncodeOctahedral(IN(0).xyz);\n"
    "RESULT = vec4(giDecodeOctahedral(e), float(all(greaterThanEqual(e, vec2(0.0))) && "
    "all(lessThanEqual(e, vec2(1.0)))));",
    1, Pack(vectors));
  for (std::size_t i = 0; i < vectors.size(); ++i)
  {
    EXPECT_LT(glm::length(glm::dvec3(results[i]) - vectors[i]), 1e-6);
    EXPECT_EQ(results[i].w, 1.0f) << "outside the range of unsigned normalized texels";
  }
}

// The G-buffer stores each component in 16 bits.
TEST_F(GeometryLib, OctahedralIn16Bits)
{
  const auto vectors = UnitVectors(20000);
  const auto results = this->Run({ "lib/octahedral.glsl" },
    "vec2 e = floor(giEncodeOctahedral(IN(0).xyz) * 65535.0 + 0.5) / 65535.0;\n"
    "RESULT = vec4(giDecodeOctahedral(e), 0.0);",
    1, Pack(vectors));
  double worst = 0.0;
  for (std::size_t i = 0; i < vectors.size(); ++i)
  {
    worst = std::max(worst, glm::length(glm::dvec3(results[i]) - vectors[i]));
  }
  RecordProperty("WorstAngle", std::to_string(worst));
  EXPECT_LT(worst, 1e-4);
}

class Reconstruct : public ComputeHarness
{
protected:
  // Bind a view block, and keep it until the end of the test.
  void BindView(const glm::dmat4& toClip, bool parallel)
  {
    penumbra::shared::ViewData view{};
    view.ViewToClip = glm::mat4(toClip);
    view.ClipToView = glm::mat4(glm::inverse(toClip));
    view.Viewport = glm::vec4(40.0f, 20.0f, 320.0f, 200.0f);
    view.Scene = glm::vec4(1.0f, parallel ? 1.0f : 0.0f, 0.0f, 0.0f);
    this->Block.Upload(GL_UNIFORM_BUFFER, &view, sizeof(view));
    this->Block.BindBase(GL_UNIFORM_BUFFER, 0);
  }
  void TearDown() override
  {
    this->Block = penumbra::Buffer();
    ComputeHarness::TearDown();
  }
  penumbra::Buffer Block;
};

// Window coordinates and depth of a view position, as the rasterizer computes them.
glm::dvec3 ToWindow(const glm::dmat4& toClip, const glm::dvec3& p)
{
  const glm::dvec4 clip = toClip * glm::dvec4(p, 1.0);
  const glm::dvec3 unit = glm::dvec3(clip) / clip.w * 0.5 + 0.5;
  return { 40.0 + 320.0 * unit.x, 20.0 + 200.0 * unit.y, unit.z };
}

TEST_F(Reconstruct, ViewPosition)
{
  for (const bool parallel : { false, true })
  {
    const glm::dmat4 toClip = parallel ? glm::ortho(-2.0, 2.0, -1.25, 1.25, 1.0, 9.0)
                                       : glm::perspective(0.6, 1.6, 1.0, 9.0);
    this->BindView(toClip, parallel);
    std::vector<glm::vec4> inputs;
    std::vector<glm::dvec3> expected;
    for (const auto& v : UnitVectors(500))
    {
      expected.push_back(v + glm::dvec3(0.0, 0.0, -5.0));
      inputs.emplace_back(glm::vec3(ToWindow(toClip, expected.back())), 0.0f);
    }
    const auto positions = this->Run({ "shared/view.h", "lib/reconstruct.glsl" },
      "RESULT = vec4(giViewPosition(IN(0).xy, IN(0).z), 1.0);", 1, inputs);
    const auto eyes = this->Run({ "shared/view.h", "lib/reconstruct.glsl" },
      "RESULT = vec4(giToEye(giViewPosition(IN(0).xy, IN(0).z)), 1.0);", 1, inputs);
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      EXPECT_LT(glm::length(glm::dvec3(positions[i]) - expected[i]), 2e-5);
      const glm::dvec3 eye = parallel ? glm::dvec3(0.0, 0.0, 1.0) : glm::normalize(-expected[i]);
      EXPECT_LT(glm::length(glm::dvec3(eyes[i]) - eye), 1e-5);
    }
  }
}

TEST_F(GeometryLib, NoiseIsUniform)
{
  std::vector<glm::vec4> inputs;
  for (int i = 0; i < 64 * 64; ++i)
  {
    inputs.emplace_back(i % 64, i / 64, i % 7, 0.0f);
  }
  const auto results = this->Run(
    { "lib/noise.glsl" }, "RESULT = vec4(giInterleavedNoise(IN(0).xy, int(IN(0).z)));", 1, inputs);
  std::array<int, 8> histogram{};
  for (const auto& r : results)
  {
    ASSERT_TRUE(r.x >= 0.0f && r.x < 1.0f);
    ++histogram[static_cast<std::size_t>(r.x * 8.0f)];
  }
  for (const int count : histogram)
  {
    EXPECT_NEAR(count, 512, 60);
  }
}

TEST_F(GeometryLib, VogelDiscIsUniform)
{
  constexpr int count = 256;
  std::vector<glm::vec4> inputs;
  for (int i = 0; i < count; ++i)
  {
    inputs.emplace_back(i, count, 0.7f, 0.0f);
  }
  const auto results = this->Run({ "lib/noise.glsl" },
    "RESULT = vec4(giVogelDisc(int(IN(0).x), int(IN(0).y), IN(0).z), 0.0, 0.0);", 1, inputs);
  glm::dvec2 mean(0.0);
  double square = 0.0;
  for (const auto& r : results)
  {
    const glm::dvec2 p(r.x, r.y);
    EXPECT_LE(glm::length(p), 1.0);
    mean += p / static_cast<double>(count);
    square += glm::dot(p, p) / count;
  }
  EXPECT_LT(glm::length(mean), 0.01);
  EXPECT_NEAR(square, 0.5, 0.001);
}
}
}
