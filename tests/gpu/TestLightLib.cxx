// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Functions of glsl/lib for light that reaches a point, and for its reflection.
#include "ComputeHarness.h"

#include "gpu/GLObjects.h"
#include "techniques/sh_probes/Harmonics.h"

#include "light.h"

#include <glm/gtc/constants.hpp>

namespace penumbra_test
{
namespace
{
class LightLib : public ComputeHarness
{
protected:
  void TearDown() override
  {
    this->Lights = penumbra::Buffer();
    ComputeHarness::TearDown();
  }
  penumbra::Buffer Lights;
};

TEST_F(LightLib, PhongSpecular)
{
  const auto normals = UnitVectors(300);
  std::vector<glm::vec4> inputs;
  std::vector<double> expected;
  const glm::dvec3 eye = glm::normalize(glm::dvec3(0.2, 0.3, 1.0));
  const glm::dvec3 travel = glm::normalize(glm::dvec3(0.5, -1.0, -2.0));
  for (const auto& n : normals)
  {
    const double power = 1.0 + 10.0 * std::abs(n.x);
    inputs.emplace_back(glm::vec3(n), power);
    const glm::dvec3 mirrored = travel - 2.0 * glm::dot(travel, n) * n;
    expected.push_back(std::pow(std::max(0.0, glm::dot(mirrored, eye)), power));
  }
  const auto results = this->Run({ "lib/phong.glsl" },
    "RESULT = vec4(giPhongSpecular(IN(0).xyz, normalize(vec3(0.5, -1.0, -2.0)),\n"
    "  normalize(vec3(0.2, 0.3, 1.0)), IN(0).w));",
    1, inputs);
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    EXPECT_NEAR(results[i].x, expected[i], 2e-5);
  }
}

// The projected areas of the microfacets over the hemisphere sum to one.
TEST_F(LightLib, DistributionIsNormalized)
{
  for (const double roughness : { 0.2, 0.5, 1.0 })
  {
    constexpr int steps = 20000;
    std::vector<glm::vec4> inputs;
    for (int i = 0; i < steps; ++i)
    {
      inputs.emplace_back((i + 0.5) / steps, roughness, 0.0f, 0.0f);
    }
    const auto results = this->Run(
      { "lib/pbr.glsl" }, "RESULT = vec4(giDistributionGGX(IN(0).x, IN(0).y));", 1, inputs);
    double sum = 0.0;
    for (int i = 0; i < steps; ++i)
    {
      const double cosine = (i + 0.5) / steps;
      sum += results[i].x * cosine * 2.0 * glm::pi<double>() / steps;
    }
    EXPECT_NEAR(sum, 1.0, 0.01) << "roughness " << roughness;
  }
}

TEST_F(LightLib, FresnelFromFacingToGrazing)
{
  const auto results = this->Run({ "lib/pbr.glsl" },
    "RESULT = vec4(giFresnelSchlick(vec3(0.04, 0.5, 0.9), vec3(1.0), IN(0).x), 1.0);", 1,
    { glm::vec4(1.0f), glm::vec4(0.0f), glm::vec4(0.5f) });
  EXPECT_NEAR(results[0].x, 0.04, 1e-6);
  EXPECT_NEAR(results[0].y, 0.5, 1e-6);
  EXPECT_NEAR(results[1].x, 1.0, 1e-6);
  EXPECT_NEAR(results[2].x, 0.04 + 0.96 / 32.0, 1e-6);
}

// The whole model, implemented again from VTK's shader.
double ReflectPBR(const glm::dvec3& N, const glm::dvec3& V, const glm::dvec3& L, double albedo,
  double metallic, double roughness, double f0, double f90)
{
  const auto cosine = [](const glm::dvec3& a, const glm::dvec3& b) {
    return glm::clamp(glm::dot(a, b), 1e-5, 1.0);
  };
  const glm::dvec3 H = glm::normalize(V + L);
  const double NdV = cosine(N, V);
  const double NdL = cosine(N, L);
  const double NdH = cosine(N, H);
  const double F = f0 + (f90 - f0) * std::pow(1.0 - cosine(H, L), 5.0);
  const double a2 = std::pow(roughness, 4.0);
  const double D = a2 / (glm::pi<double>() * std::pow(NdH * NdH * (a2 - 1.0) + 1.0, 2.0));
  const double r2 = roughness * roughness;
  const double visibility = 0.5 /
    (NdL * std::sqrt(NdV * NdV * (1.0 - r2) + r2) + NdV * std::sqrt(NdL * NdL * (1.0 - r2) + r2));
  const double diffuse = (1.0 - metallic) * (1.0 - F) * albedo / glm::pi<double>();
  return (diffuse + D * visibility * F) * NdL;
}

TEST_F(LightLib, PhysicallyBasedReflection)
{
  const auto directions = UnitVectors(400);
  const glm::dvec3 N(0.0, 0.0, 1.0);
  const glm::dvec3 V = glm::normalize(glm::dvec3(0.3, -0.2, 0.8));
  std::vector<glm::vec4> inputs;
  std::vector<double> expected;
  for (const auto& L : directions)
  {
    if (glm::length(L + V) < 0.1)
    {
      continue;
    }
    const double roughness = 0.2 + 0.8 * std::abs(L.x);
    const double metallic = std::abs(L.y);
    inputs.emplace_back(glm::vec3(L), roughness);
    inputs.emplace_back(metallic, 0.0f, 0.0f, 0.0f);
    expected.push_back(ReflectPBR(N, V, L, 0.7, metallic, roughness, 0.3, 0.95));
  }
  const auto results = this->Run({ "lib/pbr.glsl" },
    "RESULT = vec4(giReflectPBR(vec3(0.0, 0.0, 1.0), normalize(vec3(0.3, -0.2, 0.8)),\n"
    "  IN(0).xyz, vec3(0.7), IN(1).x, IN(0).w, vec3(0.3), vec3(0.95)), 1.0);",
    2, inputs);
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(results[i].x, expected[i], 1e-4 + 1e-3 * expected[i]);
  }
}

// Helmholtz reciprocity: the lobe is the same with light and eye exchanged.
TEST_F(LightLib, ReflectionIsReciprocal)
{
  const auto directions = UnitVectors(200);
  std::vector<glm::vec4> inputs;
  for (std::size_t i = 0; i + 1 < directions.size(); ++i)
  {
    if (directions[i].z > 0.1 && directions[i + 1].z > 0.1)
    {
      inputs.emplace_back(glm::vec3(directions[i]), 0.0f);
      inputs.emplace_back(glm::vec3(directions[i + 1]), 0.0f);
    }
  }
  ASSERT_GT(inputs.size(), 50u);
  const auto results = this->Run({ "lib/pbr.glsl" },
    "vec3 a = normalize(IN(0).xyz), b = normalize(IN(1).xyz), n = vec3(0.0, 0.0, 1.0);\n"
    "vec3 f = vec3(0.04), g = vec3(1.0), c = vec3(0.5);\n"
    "RESULT = vec4(giReflectPBR(n, a, b, c, 0.2, 0.4, f, g).x / b.z,\n"
    "  giReflectPBR(n, b, a, c, 0.2, 0.4, f, g).x / a.z, 0.0, 0.0);",
    2, inputs);
  for (const auto& r : results)
  {
    EXPECT_NEAR(r.x, r.y, 1e-5 + 1e-4 * r.x);
  }
}

TEST_F(LightLib, HarmonicsEqualThoseOfTheCPU)
{
  const auto directions = UnitVectors(200);
  std::vector<glm::vec4> inputs;
  for (const auto& d : directions)
  {
    inputs.emplace_back(glm::vec3(d), 0.0f);
  }
  for (int k = 0; k < 9; ++k)
  {
    const auto results = this->Run({ "lib/spherical_harmonics.glsl" },
      "float y[GI_HARMONICS];\ngiHarmonics(IN(0).xyz, y);\nRESULT = vec4(y[" + std::to_string(k) +
        "]);",
      1, inputs);
    for (std::size_t i = 0; i < directions.size(); ++i)
    {
      EXPECT_NEAR(results[i].x, penumbra::HarmonicsOf(directions[i])[k], 1e-5) << k;
    }
  }
}

// Share of a highlight that the fitted lobe puts elsewhere, 0 to 1. fit: x, y, z, w of the matrix to the cosine's
// directions, see highlight_table.comp.
double MisplacedShare(double cosine, double roughness, const glm::dvec4& fit)
{
  const glm::dvec3 V(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
  const double determinant = std::abs(fit.y * (fit.w - fit.x * fit.z));
  constexpr int steps = 300;
  std::vector<double> lobe, fitted;
  double sum = 0.0;
  for (int i = 0; i < steps * steps; ++i)
  {
    const double z = (i % steps + 0.5) / steps;
    const double angle = 2.0 * glm::pi<double>() * (i / steps + 0.5) / steps;
    const double side = std::sqrt(1.0 - z * z);
    const glm::dvec3 L(side * std::cos(angle), side * std::sin(angle), z);
    lobe.push_back(ReflectPBR({ 0.0, 0.0, 1.0 }, V, L, 0.0, 1.0, roughness, 1.0, 1.0));
    sum += lobe.back();
    const glm::dvec3 c(L.x + fit.x * L.z, fit.y * L.y, fit.z * L.x + fit.w * L.z);
    fitted.push_back(
      determinant * std::max(c.z, 0.0) / std::pow(glm::dot(c, c), 2.0) * 2.0 / (steps * steps));
  }
  double share = 0.0;
  for (std::size_t i = 0; i < lobe.size(); ++i)
  {
    share += 0.5 * std::abs(lobe[i] / sum - fitted[i]);
  }
  return share;
}

TEST_F(LightLib, HighlightsAreFitted)
{
  std::vector<glm::vec4> inputs; // the table's, except grazing and sharp ones
  for (int i = 3; i <= 15; ++i)
  {
    for (int k = 2; k <= 15; ++k)
    {
      inputs.emplace_back(k / 15.0f, i / 15.0f, 0.0f, 0.0f);
    }
  }
  const auto fits =
    this->Run({ "lib/pbr.glsl", "lib/sampling.glsl", "direct_light/highlight_fit.glsl" },
      "RESULT = fitHighlight(IN(0).xy)[0];", 1, inputs);
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    const double share = MisplacedShare(inputs[i].x, inputs[i].y, fits[i]);
    EXPECT_LT(share, 0.05 + 0.25 * (1.0 - inputs[i].x))
      << "cosine " << inputs[i].x << ", roughness " << inputs[i].y << ": " << fits[i].x << " "
      << fits[i].y << " " << fits[i].z << " " << fits[i].w;
  }
}

TEST_F(LightLib, IncidentLight)
{
  using penumbra::shared::LightData;
  std::vector<LightData> lights(3);
  const glm::dvec3 down(0.0, 0.0, -1.0);
  const double edge = std::cos(glm::radians(25.0));
  for (auto& light : lights)
  {
    light.Color = glm::vec4(1.0f, 1.0f, 1.0f, -2.0f);
    light.Direction = glm::vec4(glm::vec3(down), 2.5f);
    light.Position = glm::vec4(0.5f, -0.25f, 2.0f, 0.0f);
    light.Attenuation = glm::vec4(0.5f, 0.2f, 0.1f, 0.0f);
    light.Kind = glm::ivec4(GI_LIGHT_POSITIONAL, -1, 0, 0);
  }
  lights[0].Kind.x = GI_LIGHT_DIRECTIONAL;
  lights[2].Color.w = static_cast<float>(edge);
  this->Lights.Upload(GL_SHADER_STORAGE_BUFFER, lights.data(), lights.size() * sizeof(lights[0]));
  this->Lights.BindBase(GL_SHADER_STORAGE_BUFFER, 0);
  std::vector<glm::vec4> inputs;
  for (std::size_t light = 0; light < lights.size(); ++light)
  {
    for (const auto& p : UnitVectors(200))
    {
      inputs.emplace_back(glm::vec3(p), light);
    }
  }
  const auto results = this->Run({ "shared/light.h", "lib/lights.glsl" },
    "GiIncident i = giIncident(lights[int(IN(0).w)], IN(0).xyz);\n"
    "RESULT = vec4(i.Travel, i.Attenuation);",
    1, inputs, { { "GI_POSITIONAL", "1" } });
  int outside = 0;
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    const int light = static_cast<int>(inputs[i].w);
    const glm::dvec3 path = glm::dvec3(inputs[i]) - glm::dvec3(0.5, -0.25, 2.0);
    const double d = glm::length(path);
    const double falloff = 1.0 / (0.5 + 0.2 * d + 0.1 * d * d);
    const double cosine = glm::dot(path / d, down);
    outside += light == 2 && cosine < edge;
    const double expected = light == 0 ? 1.0
      : light == 1                     ? falloff
      : cosine < edge                  ? 0.0
                                       : falloff * std::pow(cosine, 2.5);
    EXPECT_NEAR(results[i].w, expected, 1e-5);
    const glm::dvec3 travel = light == 0 ? down : path / d;
    EXPECT_LT(glm::length(glm::dvec3(results[i]) - travel), 1e-6);
  }
  EXPECT_GT(outside, 20);
}
}
}
