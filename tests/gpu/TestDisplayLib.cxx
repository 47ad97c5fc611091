// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Functions of glsl/lib for tone curves and for the energy of highlights.
#include "ComputeHarness.h"
#include "ToneCurves.h"

#include <glm/gtc/constants.hpp>

#include <cmath>
#include <cstdio>

namespace penumbra_test
{
namespace
{
class DisplayLib : public ComputeHarness
{
};

TEST_F(DisplayLib, CurvesFollowThePublishedFormulas)
{
  std::vector<glm::vec4> inputs;
  for (int i = 0; i < 400; ++i)
  {
    const double level = std::pow(2.0, -6.0 + 0.03 * i);
    inputs.emplace_back(level * (0.2 + 0.8 * (i % 3 == 0)), level * (0.1 + 0.9 * (i % 2)),
      level * (i % 5) / 4.0, 0.0);
  }
  const auto coated =
    this->Run({ "lib/tone.glsl" }, "RESULT = vec4(giTone(1, IN(0).rgb, true), 1.0);", 1, inputs);
  const auto plain =
    this->Run({ "lib/tone.glsl" }, "RESULT = vec4(giTone(1, IN(0).rgb, false), 1.0);", 1, inputs);
  const auto filmic =
    this->Run({ "lib/tone.glsl" }, "RESULT = vec4(giTone(2, IN(0).rgb, false), 1.0);", 1, inputs);
  int kept = 0;
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    const glm::dvec3 x(inputs[i]);
    const bool below = std::max(x.r, std::max(x.g, x.b)) <= 0.8;
    kept += below;
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(coated[i][c], Neutral(x, 0.04)[c], 1e-5);
      EXPECT_NEAR(plain[i][c], Neutral(x, 0.0)[c], 1e-5);
      EXPECT_NEAR(filmic[i][c], Filmic(x[c]), 1e-5);
      EXPECT_TRUE(!below || plain[i][c] == inputs[i][c]) << "colours up to 0.8 stay as they are";
    }
  }
  EXPECT_GT(kept, 100);
}

TEST_F(DisplayLib, CurvesTakeAnyNumber)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  for (const char* curve : { "0", "1", "2" })
  {
    const auto results = this->Run({ "lib/tone.glsl" },
      std::string("RESULT = vec4(giTone(") + curve + ", IN(0).rgb, IN(0).a > 0.0), 1.0);", 1,
      { { nan, 0.5f, nan, 0.0f }, { infinite, infinite, infinite, 1.0f },
        { -infinite, -1.0f, 0.0f, 1.0f } });
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_GE(results[0][c], 0.0f) << curve;
      EXPECT_LT(results[0][c], 0.7f) << curve;
      EXPECT_NEAR(results[1][c], 1.0f, 1e-3) << curve;
      EXPECT_EQ(results[2][c], 0.0f) << curve;
    }
  }
}

// Light from all around: white metal reflects all of it with compensation, and much less without.
TEST_F(DisplayLib, CompensatedHighlightsKeepAllLight)
{
  const auto directions = UnitVectors(40000);
  std::vector<glm::vec4> inputs;
  for (const auto& L : directions)
  {
    inputs.emplace_back(glm::vec3(L), 0.0f);
  }
  for (const double roughness : { 0.4, 0.6, 0.8, 1.0 })
  {
    for (const double cosine : { 0.2, 0.5, 0.8, 1.0 })
    {
      char body[900];
      std::snprintf(body, sizeof(body),
        "float NdV = %.6f;\n"
        "vec3 L = IN(0).xyz;\n"
        "vec3 V = vec3(sqrt(1.0 - NdV * NdV), 0.0, NdV);\n"
        "vec3 boost = giCompensation(vec3(1.0), giHighlightShare(NdV, %.6f));\n"
        "RESULT = L.z <= 0.0 ? vec4(0.0) : vec4(\n"
        "  giReflectPBR(vec3(0.0, 0.0, 1.0), V, L, vec3(1.0), 1.0, %.6f, vec3(1.0), vec3(1.0), boost, 1.0),\n"
        "  giReflectPBR(vec3(0.0, 0.0, 1.0), V, L, vec3(1.0), 1.0, %.6f, vec3(1.0), vec3(1.0)).r);",
        cosine, roughness, roughness, roughness);
      double with = 0.0;
      double without = 0.0;
      for (const glm::vec4& result :
        this->Run({ "lib/pbr.glsl", "lib/compensation.glsl" }, body, 1, inputs))
      {
        with += result.x;
        without += result.w;
      }
      const double each = 4.0 * glm::pi<double>() / static_cast<double>(directions.size());
      std::printf("roughness %.2f, cosine %.1f: reflects %.4f, without compensation %.4f\n",
        roughness, cosine, with * each, without * each);
      EXPECT_NEAR(with * each, 1.0, 0.01);
      EXPECT_LT(without * each, 0.96);
    }
  }
}
}
}
