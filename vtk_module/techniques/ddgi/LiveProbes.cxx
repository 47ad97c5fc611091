// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/ddgi/LiveProbes.h"

#include "rays/RayProps.h"
#include "technique/FrameBuilder.h"

#include <glm/gtc/constants.hpp>

#include <limits>

namespace penumbra
{
namespace
{
// As in glsl/ddgi/field.glsl.
constexpr int LightTexels = 8;
constexpr int DistanceTexels = 16;

constexpr int Group = 64; // of invocations, as in the shaders

GLuint Groups(int invocations)
{
  return (invocations + Group - 1) / Group;
}

// Along a spiral, neighbours in the table being neighbours on the sphere (Bauer 2000, Distribution of Points on
// a Sphere with Application to Star Catalogs).
std::vector<glm::vec4> EvenDirections(int count)
{
  std::vector<glm::vec4> directions;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double turn = std::sqrt(glm::pi<double>() * count) * std::acos(z);
    const double radius = std::sqrt(1.0 - z * z);
    directions.emplace_back(radius * std::cos(turn), radius * std::sin(turn), z, 0.0);
  }
  return directions;
}

void Fill(const Texture& texture, const std::vector<glm::vec4>& texels)
{
  glBindTexture(GL_TEXTURE_2D, texture.Get());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, texture.Desc().Width, texture.Desc().Height, GL_RGBA,
    GL_FLOAT, texels.data());
  glBindTexture(GL_TEXTURE_2D, 0);
}

void FillAll(const Texture& texture, const glm::vec4& value)
{
  const std::size_t count = static_cast<std::size_t>(texture.Desc().Width) * texture.Desc().Height;
  Fill(texture, std::vector<glm::vec4>(count, value));
}
}

LiveProbeMaps LiveProbeMaps::Of(FrameContext& context, int probes, int rays, bool& fresh)
{
  const int columns = ProbeUniforms::Columns(probes);
  const int rows = ProbeUniforms::Rows(probes, columns);
  bool made = false;
  fresh = false;
  const auto get = [&](const char* name, GLenum format, int side, int rows) {
    const TextureDesc desc = { format, columns * side, rows * side, 0 };
    Texture& texture = context.History(name, desc, made);
    fresh |= made;
    return &texture;
  };
  LiveProbeMaps maps;
  maps.Found = &context.History("ddgi.rays", { GL_RGBA32F, rays, probes, 0 }, made);
  maps.Directions = &context.History("ddgi.directions", { GL_RGBA32F, rays, 1, 0 }, made);
  if (made)
  {
    Fill(*maps.Directions, EvenDirections(rays));
  }
  maps.Light = get("ddgi.light", GL_RGBA32F, LightTexels + 2, rows);
  // And of places that probes left.
  maps.Distance =
    get("ddgi.distance", GL_RG32F, DistanceTexels + 2, ProbeUniforms::Rows(2 * probes, columns));
  maps.Probes = get("ddgi.probes", GL_RGBA32F, 1, rows);
  maps.Places = get("ddgi.places", GL_RGBA32F, 1, rows);
  maps.States = get("ddgi.states", GL_RGBA32F, 1, rows);
  return maps;
}

void LiveProbeMaps::Clear() const
{
  for (Texture* texture : { this->Light, this->Distance })
  {
    texture->SetParameter(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    texture->SetParameter(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    FillAll(*texture, glm::vec4(0.0f));
  }
  FillAll(*this->Probes, glm::vec4(0.0f));
  FillAll(*this->Places, glm::vec4(0.0f));
  FillAll(*this->States, glm::vec4(0.0f, 0.0f, 1.0f, 0.0f));
}

void LiveProbeMaps::BindStates() const
{
  glBindImageTexture(2, this->States->Get(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
}

void LiveProbeUpdate::Scroll(
  FrameContext& context, const LiveProbeMaps& maps, int number, const glm::ivec3& moved) const
{
  const Program& program = context.Shaders().Compute("ddgi/scroll.comp", this->Uniforms.Variant());
  context.Use(program, {});
  this->Uniforms.Set(program);
  glBindImageTexture(0, maps.Probes->Get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  glBindImageTexture(3, maps.Distance->Get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG32F);
  glBindImageTexture(4, maps.Places->Get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  maps.BindStates();
  glUniform1i(program.Location("number"), number);
  glUniform3iv(program.Location("moved"), 1, &moved[0]);
  glDispatchCompute(
    Groups(this->Uniforms.Grids.Begin(number + 1) - this->Uniforms.Grids.Begin(number)), 1, 1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void LiveProbeUpdate::Trace(FrameContext& context, const LiveProbeMaps& maps) const
{
  Defines variant = this->Rays->ShaderDefines();
  variant.merge(this->Uniforms.Variant());
  const Program& program = context.Shaders().Compute("ddgi/trace.comp", variant);
  context.Use(program,
    { nullptr, nullptr, nullptr, maps.Directions, maps.Light, maps.Distance, maps.Probes });
  this->Rays->Bind(program);
  this->Rays->BindSkyCells(this->RayCount);
  this->Lights->BindWorld(0, this->Rays->Origin());
  this->Uniforms.Set(program);
  glBindImageTexture(0, maps.Found->Get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  maps.BindStates();
  const glm::vec3 eye(glm::dvec3(context.GetView().ViewToWorld[3]) - this->Rays->Origin());
  glUniform3fv(program.Location("eye"), 1, &eye[0]);
  glUniform1i(program.Location("rays"), this->RayCount);
  glUniform1i(program.Location("update"), this->Number);
  glUniform1i(program.Location("firstProbe"), this->First);
  glUniform1i(program.Location("lastProbe"), this->Last);
  glUniform1i(program.Location("lightCount"), static_cast<GLint>(this->Lights->Lights().size()));
  glUniform1i(program.Location("lit"), this->Number > 0);
  glDispatchCompute(Groups(this->RayCount * (this->Last - this->First)), 1, 1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void LiveProbeUpdate::Relocate(
  FrameContext& context, const LiveProbeMaps& maps, bool geometryMoves) const
{
  const Program& program =
    context.Shaders().Compute("ddgi/relocate.comp", this->Rays->ShaderDefines());
  context.Use(program,
    { maps.Found, nullptr, nullptr, maps.Directions, maps.Light, maps.Distance, maps.Probes });
  this->Rays->Bind(program);
  this->Uniforms.Set(program);
  glBindImageTexture(0, maps.Places->Get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  maps.BindStates();
  glUniform1i(program.Location("probeCount"), this->Uniforms.Grids.Size());
  glUniform1i(program.Location("rays"), this->RayCount);
  glUniform1i(program.Location("update"), this->Number - 1);
  glUniform1i(program.Location("geometryMoves"), geometryMoves);
  glDispatchCompute(Groups(this->Uniforms.Grids.Size()), 1, 1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  this->TakeOver(context, maps);
}

void LiveProbeUpdate::TakeOver(FrameContext& context, const LiveProbeMaps& maps) const
{
  const Program& program = context.Shaders().Compute("ddgi/take_over.comp");
  context.Use(program, { nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, maps.Probes });
  this->Uniforms.Set(program);
  glBindImageTexture(0, maps.Places->Get(), 0, GL_FALSE, 0, GL_READ_ONLY, GL_RGBA32F);
  glBindImageTexture(3, maps.Distance->Get(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RG32F);
  glBindImageTexture(1, maps.Light->Get(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  maps.BindStates();
  glUniform1i(program.Location("probeCount"), this->Uniforms.Grids.Size());
  glDispatchCompute(Groups(this->Uniforms.Grids.Size()), 1, 1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void LiveProbeUpdate::Connect(
  FrameContext& context, const LiveProbeMaps& maps, int first, int last) const
{
  const Program& program =
    context.Shaders().Compute("ddgi/connect.comp", this->Rays->ShaderDefines());
  context.Use(program, { nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, maps.Places });
  this->Rays->Bind(program);
  this->Uniforms.Set(program);
  glBindImageTexture(0, maps.Probes->Get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  glUniform1i(program.Location("firstProbe"), first);
  glUniform1i(program.Location("lastProbe"), last);
  glDispatchCompute(Groups(last - first), 1, 1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void LiveProbeUpdate::BlendLight(
  FrameContext& context, const LiveProbeMaps& maps, double least) const
{
  this->Blend(context, maps, false, least, std::numeric_limits<int>::max(), 0);
}

void LiveProbeUpdate::BlendDistances(
  FrameContext& context, const LiveProbeMaps& maps, int most, int stride) const
{
  this->Blend(context, maps, true, 0.0, most, stride);
}

void LiveProbeUpdate::Blend(FrameContext& context, const LiveProbeMaps& maps, bool distances,
  double least, int most, int stride) const
{
  Defines defines;
  if (distances)
  {
    defines["GI_BLEND_DISTANCE"] = "1";
  }
  const Program& program = context.Shaders().Compute("ddgi/blend.comp", defines);
  context.Use(program, { maps.Found, nullptr, nullptr, maps.Directions });
  this->Uniforms.Set(program);
  const Texture* map = distances ? maps.Distance : maps.Light;
  glBindImageTexture(1, map->Get(), 0, GL_FALSE, 0, GL_READ_WRITE, map->Desc().Format);
  glUniform1i(program.Location("rays"), this->RayCount);
  glUniform1i(program.Location("update"), this->Number);
  maps.BindStates();
  glUniform1f(program.Location("least"), static_cast<GLfloat>(least));
  glUniform1f(program.Location("most"), static_cast<GLfloat>(most));
  glUniform1i(program.Location("firstProbe"), this->First);
  glUniform1i(program.Location("stride"), stride);
  glDispatchCompute(this->Last - this->First, 1, 1);
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}
}
