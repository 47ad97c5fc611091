// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RayStage.h"

#include "gpu/Commands.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <ctime>

using namespace penumbra;

namespace penumbra_test
{
Seconds Seconds::Now()
{
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now().time_since_epoch();
  return { wall.count(), static_cast<double>(std::clock()) / CLOCKS_PER_SEC };
}

Seconds Seconds::Since() const
{
  const Seconds current = Now();
  return { current.Wall - this->Wall, current.Cpu - this->Cpu };
}

RayStage::RayStage()
  : Window(vtkSmartPointer<vtkHeadlessRenderWindow>::New())
{
  this->Window->SetSize(8, 8);
  this->Window->Initialize();
  this->Ready = this->Window->GetBackendName()[0] != '\0';
  if (this->Ready)
  {
    this->Window->MakeCurrent();
  }
  const char* folder = std::getenv("PENUMBRA_SHADER_PATH");
  this->OverrideShaders(folder ? folder : "");
}

RayStage::~RayStage()
{
  if (this->Ready)
  {
    this->Window->MakeCurrent();
    this->Scene.ReleaseGraphicsResources();
    this->Library.Release();
    this->Queries = Buffer();
    this->Results = Buffer();
  }
}

const char* RayStage::Description() const
{
  return this->Window->GetDescription();
}

bool RayStage::IsShallow() const
{
  return this->Scene.ShaderDefines().count("GI_RAY_SHALLOW") != 0;
}

void RayStage::Show(const RayWorld& world)
{
  this->Scene.Clear();
  for (std::size_t i = 0; i < world.Meshes.size(); ++i)
  {
    this->Scene.SetMesh(i, world.Meshes[i]);
  }
  for (std::size_t i = 0; i < world.Instances.size(); ++i)
  {
    const RayWorld::Placement& placement = world.Instances[i];
    this->Scene.SetInstance(i, placement.Mesh, placement.MeshToWorld, static_cast<int>(i) + 7);
  }
  this->Scene.SetOrigin(world.Center);
  this->Scene.Update();
}

void RayStage::Prepare(const Rays& rays, bool any)
{
  Defines defines = this->Scene.ShaderDefines();
  if (any)
  {
    defines["GI_RAY_ANY"] = "1";
  }
  this->Current = &this->Library.Compute("rays/query.comp", defines);
  this->Queries.Upload(GL_SHADER_STORAGE_BUFFER, rays.data(), rays.size() * sizeof(rays[0]));
  const Answers blank(rays.size());
  this->Results.Upload(GL_SHADER_STORAGE_BUFFER, blank.data(), blank.size() * sizeof(blank[0]));
}

void RayStage::Dispatch(std::size_t count)
{
  Commands commands(this->Library);
  commands.SetWindow(this->Window);
  commands.Dispatch(*this->Current,
    Arguments()
      .Block("RayQueryBlock", this->Queries)
      .Block("RayAnswerBlock", this->Results, ShaderAccess::Write)
      .Set("rayCount", static_cast<int>(count)),
    Work::GroupsInRows((count + GI_RAY_QUERY_GROUP - 1) / GI_RAY_QUERY_GROUP),
    this->Scene.ShaderArguments());
  commands.Finish();
  glFinish();
}

Answers RayStage::Trace(const Rays& rays, bool any)
{
  // Parts fit the smallest storage blocks of software OpenGL 4.3.
  constexpr std::size_t part = 2000000;
  Answers answers(rays.size());
  for (std::size_t begin = 0; begin < rays.size(); begin += part)
  {
    const std::size_t count = std::min(part, rays.size() - begin);
    this->Prepare(Rays(rays.begin() + begin, rays.begin() + begin + count), any);
    this->Dispatch(count);
    GLint name = 0;
    glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, GI_RAY_ANSWER_BINDING, &name);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, name);
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0,
      static_cast<GLsizeiptr>(count * sizeof(answers[0])), answers.data() + begin);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  }
  if (!any)
  {
    for (shared::RayAnswer& answer : answers)
    {
      answer.Hit.x = answer.Hit.x < 0 ? -1 : static_cast<int>(this->Scene.InstanceAt(answer.Hit.x));
    }
  }
  return answers;
}

Seconds RayStage::Time(const Rays& rays, bool any)
{
  this->Prepare(rays, any);
  this->Dispatch(std::min<std::size_t>(rays.size(), 64)); // compile
  const Seconds begin = Seconds::Now();
  this->Dispatch(rays.size());
  return begin.Since();
}

namespace
{
class Random
{
public:
  explicit Random(unsigned int seed)
    : Engine(seed)
  {
  }
  double Unit() { return this->Uniform(this->Engine); }
  glm::dvec3 Direction()
  {
    const double z = 2.0 * this->Unit() - 1.0;
    const double phi = 6.283185307179586 * this->Unit();
    const double s = std::sqrt(std::max(0.0, 1.0 - z * z));
    return glm::dvec3(s * std::cos(phi), s * std::sin(phi), z);
  }
  glm::dvec3 InBall() { return std::cbrt(this->Unit()) * this->Direction(); }
  std::size_t Index(std::size_t count)
  {
    return std::min(count - 1, static_cast<std::size_t>(this->Unit() * static_cast<double>(count)));
  }

private:
  std::mt19937_64 Engine;
  std::uniform_real_distribution<double> Uniform{ 0.0, 1.0 };
};

shared::RayQuery MakeRay(const glm::dvec3& origin, const glm::dvec3& direction)
{
  return { glm::vec4(origin, 0.0), glm::vec4(direction, 1e30) };
}
}

Rays RandomRays(const RayWorld& world, std::size_t count, unsigned int seed)
{
  Random random(seed);
  Rays rays;
  rays.reserve(count);
  while (rays.size() < count)
  {
    const glm::dvec3 origin = world.Radius * random.InBall();
    if (rays.size() % 2 == 0)
    {
      rays.push_back(MakeRay(origin, random.Direction()));
      continue;
    }
    const RayWorld::Placement& placement = world.Instances[random.Index(world.Instances.size())];
    const RayGeometry& mesh = world.Meshes[placement.Mesh];
    const glm::uvec3 corners = mesh.Triangles[random.Index(mesh.Triangles.size())];
    glm::dvec3 at(0.0);
    double rest = 1.0;
    for (int i = 0; i < 3; ++i)
    {
      const double weight = i == 2 ? rest : rest * random.Unit();
      rest -= weight;
      at +=
        weight * glm::dvec3(mesh.Points[std::min<std::size_t>(corners[i], mesh.Points.size() - 1)]);
    }
    at = glm::dvec3(placement.MeshToWorld * glm::dvec4(mesh.Origin + at, 1.0)) - world.Center;
    const glm::dvec3 from = 2.0 * world.Radius * random.Direction();
    if (std::isfinite(at.x + at.y + at.z))
    {
      rays.push_back(MakeRay(from, glm::normalize(at - from)));
    }
  }
  return rays;
}

Rays IncoherentRays(const RayWorld& world, std::size_t count, unsigned int seed)
{
  Random random(seed);
  Rays rays(count);
  for (shared::RayQuery& ray : rays)
  {
    const glm::dvec3 origin = 0.6 * world.Radius * random.InBall();
    ray = MakeRay(origin, random.Direction());
  }
  return rays;
}

Rays CameraRays(const RayWorld& world, int width, int height)
{
  Rays rays;
  const glm::dvec3 eye(0.0, 0.0, 1.6 * world.Radius);
  for (int tileY = 0; tileY < height; tileY += 8)
  {
    for (int tileX = 0; tileX < width; tileX += 8)
    {
      for (int i = 0; i < 64; ++i)
      {
        const int x = tileX + (i & 1) + ((i >> 1) & 2) + ((i >> 2) & 4);
        const int y = tileY + ((i >> 1) & 1) + ((i >> 2) & 2) + ((i >> 3) & 4);
        const glm::dvec3 to((x + 0.5) / width - 0.5, (y + 0.5) / height - 0.5, -0.9);
        rays.push_back(MakeRay(eye, glm::normalize(to)));
      }
    }
  }
  return rays;
}
}
