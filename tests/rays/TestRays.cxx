// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays traced by the shaders against Embree. PENUMBRA_NIGHTLY=1 asks for the full counts: 10 million random rays, 100
// million at edges.
#include "Nightly.h"
#include "RayCompare.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>

using namespace penumbra;
using namespace penumbra_test;

namespace
{
class RayTest : public testing::Test
{
protected:
  void SetUp() override
  {
    if (!this->Stage.IsReady())
    {
      GTEST_SKIP() << "no OpenGL context here";
    }
  }
  RayStage Stage;
};
}

TEST_F(RayTest, AgreesWithEmbree)
{
  const std::size_t count = IsNightly() ? 1700000 : 50000;
  for (const RayWorld& world : AllWorlds())
  {
    this->Stage.Show(world);
    const Rays rays = RandomRays(world, count, 11);
    Answers expected;
    EmbreeWorld(world).Trace(rays, expected);
    const Comparison result = Compare(world, rays, expected, this->Stage.Closest(rays));
    std::cout << result.Line(world.Name) << std::endl;
    EXPECT_EQ(result.Unexplained, 0u) << world.Name << ": " << result.First;
    EXPECT_GT(result.Hits, count / 4) << world.Name << ": too few rays hit anything";
    // Slivers narrower than floats resolve are hit or missed by chance, and either of two duplicates may be hit. Other
    // scenes have few such triangles.
    const bool hard = world.Name == "thin slivers" || world.Name == "degenerate input";
    EXPECT_GT(result.Same, count / 100 * (hard ? 90 : 99)) << world.Name;
    EXPECT_EQ(this->Stage.IsShallow(), world.Name != "deep trees") << world.Name;
  }
}

TEST_F(RayTest, AnyHitAgreesWithClosestHit)
{
  for (const RayWorld& world : AllWorlds())
  {
    this->Stage.Show(world);
    Rays rays = RandomRays(world, IsNightly() ? 1000000 : 20000, 12);
    const Answers closest = this->Stage.Closest(rays);
    // A third of the rays end just before the hit, a third just after it.
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      if (closest[i].Hit.x >= 0 && i % 3 > 0)
      {
        rays[i].Direction.w = closest[i].Distance * (i % 3 == 1 ? 0.9999f : 1.0001f);
      }
    }
    const Answers any = this->Stage.Any(rays);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      const bool expected = closest[i].Hit.x >= 0 && closest[i].Distance < rays[i].Direction.w;
      // A limit within the rounding error of a needle's distance decides nothing.
      const bool differs = expected != (any[i].Hit.x >= 0);
      wrong += differs && !IsDistanceUncertain(world, rays[i], closest[i], 1e-4) ? 1 : 0;
    }
    EXPECT_EQ(wrong, 0u) << world.Name;
  }
}

// Number of rays from inside a closed mesh toward its edges and vertices that find no surface.
std::size_t LeaksOf(RayStage& stage, std::size_t total)
{
  const RayWorld world = Single("closed sphere", ClosedSphere(40));
  stage.Show(world);
  const RayGeometry& mesh = world.Meshes[0];
  std::mt19937 random(6);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  const std::size_t part = std::min<std::size_t>(total, 1000000);
  std::size_t leaks = 0;
  for (std::size_t done = 0; done < total; done += part)
  {
    Rays rays(part);
    for (shared::RayQuery& ray : rays)
    {
      // From inside toward edges and vertices; some from the centre.
      const glm::uvec3 corners = mesh.Triangles[random() % mesh.Triangles.size()];
      const unsigned int first = random() % 3;
      const glm::vec3 a = mesh.Points[corners[first]];
      const glm::vec3 b = mesh.Points[corners[(first + 1) % 3]];
      const float along = random() % 4 == 0 ? 0.0f : unit(random);
      glm::vec3 origin = 0.5f * glm::vec3(unit(random), unit(random), unit(random)) - 0.25f;
      if (random() % 4 == 0)
      {
        origin = glm::vec3(0.0f);
      }
      ray = { glm::vec4(origin, 0.0f), glm::vec4(glm::mix(a, b, along) - origin, 1e30f) };
    }
    for (const shared::RayAnswer& answer : stage.Closest(rays))
    {
      leaks += answer.Hit.x < 0 ? 1 : 0;
    }
  }
  std::cout << total << " rays at edges and vertices: " << leaks << " leaks" << std::endl;
  return leaks;
}

TEST_F(RayTest, LeaksNothingThroughAClosedMesh)
{
  EXPECT_EQ(LeaksOf(this->Stage, IsNightly() ? 100000000 : 1000000), 0u);
}

// A compiler may fuse one product of a difference, as NVIDIA's does and Mesa's llvmpipe does not. These shaders imitate it.
TEST_F(RayTest, FusedProductsNeitherLeakNorHitTrianglesWithoutArea)
{
  const std::string plain = "first.x * last.y - first.y * last.x";
  std::string text = EmbeddedShaders().at("rays/primitives.glsl");
  const auto at = text.find(plain);
  ASSERT_NE(at, std::string::npos);
  text.replace(
    at, plain.size(), "float(double(first.x) * double(last.y) - double(first.y * last.x))");
  const auto folder =
    std::filesystem::temp_directory_path() / ("penumbra_fused_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder / "rays");
  std::ofstream(folder / "rays" / "primitives.glsl") << text;
  this->Stage.OverrideShaders(folder.string());

  EXPECT_EQ(LeaksOf(this->Stage, 300000), 0u);
  const RayWorld world = Single("degenerate input", Degenerate(60));
  this->Stage.Show(world);
  const Rays rays = RandomRays(world, 20000, 14);
  Answers expected;
  EmbreeWorld(world).Trace(rays, expected);
  const Comparison result = Compare(world, rays, expected, this->Stage.Closest(rays));
  std::cout << result.Line("degenerate, fused") << std::endl;
  EXPECT_EQ(result.Unexplained, 0u) << result.First;
  std::filesystem::remove_all(folder);
}

TEST_F(RayTest, RefitGivesTheHitsOfARebuild)
{
  // The tree holds slivers in pieces, and moved points change the cuts.
  for (RayWorld world :
    { Single("moving", SphereField(60, 14, 8)), Single("moving slivers", Slivers(3000)) })
  {
    this->Stage.Show(world);
    for (glm::vec3& point : world.Meshes[0].Points)
    {
      point += 0.3f * glm::vec3(std::sin(point.y), std::sin(point.z), std::cos(point.x));
    }
    world.Measure();
    const Rays rays = RandomRays(world, 50000, 13);
    this->Stage.Scene.SetOrigin(world.Center);
    this->Stage.Scene.RefitMesh(0, world.Meshes[0]);
    this->Stage.Scene.Update();
    const Answers refitted = this->Stage.Closest(rays);
    this->Stage.Show(world);
    const Comparison result = Compare(world, rays, this->Stage.Closest(rays), refitted, 1e-6);
    std::cout << result.Line("refit, rebuilt") << std::endl;
    EXPECT_EQ(result.Unexplained + result.Edge + result.Grazing, 0u) << result.First;
  }
}

TEST_F(RayTest, FollowsChangesOfPartsOfTheScene)
{
  RayWorld world = Glyphs(200);
  this->Stage.Show(world);
  const auto check = [&](const char* what) {
    const Rays rays = RandomRays(world, 20000, 14);
    Answers expected;
    EmbreeWorld(world).Trace(rays, expected);
    this->Stage.Scene.SetOrigin(world.Center);
    this->Stage.Scene.Update();
    const Comparison result = Compare(world, rays, expected, this->Stage.Closest(rays));
    EXPECT_EQ(result.Unexplained, 0u) << what << ": " << result.First;
  };
  check("as given");
  world.Instances[3].MeshToWorld =
    glm::translate(glm::dmat4(1.0), glm::dvec3(30.0, 0.0, 0.0)) * world.Instances[3].MeshToWorld;
  this->Stage.Scene.SetInstance(3, world.Instances[3].Mesh, world.Instances[3].MeshToWorld);
  world.Measure();
  check("an instance moved");
  world.Meshes[0] = ClosedSphere(30); // larger: it moves in the buffers
  this->Stage.Scene.SetMesh(0, world.Meshes[0]);
  check("a mesh replaced by a larger one");
  world.Meshes[0] = ClosedSphere(5);
  this->Stage.Scene.SetMesh(0, world.Meshes[0]);
  check("a mesh replaced by a smaller one");
  this->Stage.Scene.RemoveInstance(199);
  world.Instances.pop_back();
  check("an instance removed");
  world.Center += glm::dvec3(5.0, -3.0, 2.0);
  check("another origin");
}

TEST_F(RayTest, DropsInvalidPrimitivesAndInstances)
{
  RayWorld world = Single("degenerate", Degenerate(10));
  this->Stage.Show(world);
  EXPECT_GT(this->Stage.Scene.DroppedPrimitives(), 0u);
  RayScene& scene = this->Stage.Scene;
  scene.SetInstance(1, 0, glm::scale(glm::dmat4(1.0), glm::dvec3(0.0)));
  scene.SetInstance(2, 0, glm::dmat4(std::nan("")));
  scene.SetInstance(3, 77, glm::dmat4(1.0)); // no such mesh
  scene.Update();
  EXPECT_EQ(scene.DroppedInstances(), 2u);
  const Rays rays = RandomRays(world, 5000, 15);
  std::size_t hits = 0;
  for (const shared::RayAnswer& answer : this->Stage.Closest(rays))
  {
    hits += answer.Hit.x == 0 ? 1 : 0;
    EXPECT_LE(answer.Hit.x, 0);
  }
  EXPECT_GT(hits, 1000u);
}

TEST_F(RayTest, MissesAnEmptyScene)
{
  this->Stage.Scene.Update();
  const Rays rays(100, { glm::vec4(0.0f), glm::vec4(1.0f, 0.0f, 0.0f, 10.0f) });
  for (const shared::RayAnswer& answer : this->Stage.Closest(rays))
  {
    ASSERT_EQ(answer.Hit.x, -1);
    ASSERT_EQ(answer.Distance, 10.0f);
  }
}

TEST_F(RayTest, FindsSpheresAndCylinders)
{
  RayGeometry shapes;
  shapes.Points = { { -1, -1, -3 }, { 1, -1, -3 }, { 0, 1, -3 } };
  shapes.Triangles = { { 0, 1, 2 } };
  shapes.Spheres = { { glm::vec3(0.0f), 1.0f } };
  shapes.Cylinders = { { glm::vec3(5, 0, -1), glm::vec3(5, 0, 1), 0.5f, true },
    { glm::vec3(10, 0, -1), glm::vec3(10, 0, 1), 0.5f, false } };
  this->Stage.Scene.SetMesh(0, shapes);
  this->Stage.Scene.SetInstance(0, 0, glm::dmat4(1.0), 42);
  this->Stage.Scene.Update();
  struct Case
  {
    glm::vec3 Origin, Direction;
    int Primitive;
    float Distance;
  };
  const float far = 1000.0f;
  const std::vector<Case> cases = {
    { { 0, 0, 5 }, { 0, 0, -1 }, 1, 4.0f },           // a sphere from outside
    { { 0, 0, 0 }, { 0, 0, -2 }, 1, 0.5f },           // from inside, in units of the direction
    { { 0, 0, -2 }, { 0, 0, -1 }, 0, 1.0f },          // the triangle behind
    { { 0, 1.001f, 5 }, { 0, 0, -1 }, -1, 0.0f },     // past the sphere; the triangle ends lower
    { { 5, 0, 5 }, { 0, 0, -1 }, 2, 4.0f },           // a cap, along the axis
    { { 5, 5, 0.3f }, { 0, -1, 0 }, 2, 4.5f },        // a side
    { { 5, 0, 0 }, { 0, 1, 0 }, 2, 0.5f },            // from inside
    { { 5, 0.4f, 0 }, { 0, 0, 1 }, 2, 1.0f },         // a cap from inside
    { { 5, 5, 1.001f }, { 0, -1, 0 }, -1, 0.0f },     // past the end
    { { 10, 0, 5 }, { 0, 0, -1 }, -1, 0.0f },         // through an open cylinder
    { { 10, 0.2f, 4 }, { 0, 0.3f, -3.5f }, 3, 1.0f }, // its inner side
    { { far, 0, 0 }, { -1, 0, 0 }, 3, far - 10.5f },  // from far away
    { { 20, 0, 0.5f }, { -1, 0, 0 }, 3, 9.5f },
  };
  Rays rays;
  for (const Case& c : cases)
  {
    rays.push_back({ glm::vec4(c.Origin, 0.0f), glm::vec4(c.Direction, 1e30f) });
  }
  const Answers answers = this->Stage.Closest(rays);
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    EXPECT_EQ(answers[i].Hit.y, cases[i].Primitive) << "case " << i;
    if (cases[i].Primitive >= 0)
    {
      EXPECT_NEAR(answers[i].Distance, cases[i].Distance, 1e-5 * cases[i].Distance) << "case " << i;
      EXPECT_EQ(answers[i].User, 42);
    }
  }
}

TEST_F(RayTest, HoldsFourMillionTriangles)
{
  if (!IsNightly())
  {
    GTEST_SKIP() << "set PENUMBRA_NIGHTLY=1: takes 2 GiB of memory";
  }
  const RayWorld world = Single("4 M triangles", SphereField(640, 40));
  EXPECT_GE(world.Meshes[0].Triangles.size(), 3900000u);
  this->Stage.Show(world);
  const Rays rays = RandomRays(world, 200000, 16);
  Answers expected;
  EmbreeWorld(world).Trace(rays, expected);
  const Comparison result = Compare(world, rays, expected, this->Stage.Closest(rays));
  std::cout << result.Line(world.Name) << ", " << (this->Stage.Scene.Bytes() >> 20) << " MiB"
            << std::endl;
  EXPECT_EQ(result.Unexplained, 0u) << result.First;
}
