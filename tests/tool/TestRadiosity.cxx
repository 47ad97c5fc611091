// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Radiosity where it is known: closed boxes, lights, meshes that stay whole.
#include "RadiosityScenes.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <map>

using namespace penumbra::radiosity;
using namespace penumbra_test;

namespace
{
constexpr double Pi = glm::pi<double>();

/// A closed room, coloured, with a block and a lamp that shines in a corner of the ceiling.
PatchMesh Room()
{
  PatchMesh mesh;
  AddBox(mesh, Point(-1.0), Point(1.0), AddMatte(mesh, { 0.8, 0.6, 0.3 }), true);
  AddBox(mesh, { -0.5, -0.6, -1.0 }, { 0.3, 0.2, 0.2 }, AddMatte(mesh, { 0.2, 0.5, 0.7 }), false);
  AddQuad(mesh,
    { { { 0.3, 0.3, 0.99 }, { 0.3, 0.8, 0.99 }, { 0.8, 0.8, 0.99 }, { 0.8, 0.3, 0.99 } } },
    AddMatte(mesh, Color(0.0), Color(5.0)));
  return mesh;
}

Settings Quick()
{
  Settings settings;
  settings.PatchSize = 0.4;
  settings.Refinements = 0;
  settings.Tolerance = 1e-6;
  return settings;
}

std::string Refusal(const PatchMesh& mesh, const Settings& settings)
{
  try
  {
    Solve(mesh, {}, settings);
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return "";
}
}

TEST(Radiosity, ClosedBoxGivesEmissionOverAbsorption)
{
  for (const double reflectance : { 0.2, 0.5, 0.8 })
  {
    PatchMesh mesh;
    AddBox(mesh, Point(-1.0), Point(1.0), AddMatte(mesh, Color(reflectance), Color(0.25)), true);
    AddBox(mesh, { -0.5, -0.6, -0.9 }, { 0.3, 0.2, 0.4 },
      AddMatte(mesh, Color(reflectance), Color(0.25)), false);
    const Solution solution = Solve(mesh, {}, Quick());
    const double expected = 0.25 * Pi / (1.0 - reflectance);
    double worst = 0.0;
    for (std::size_t i = 0; i < solution.Elements.size(); ++i)
    {
      const bool room = solution.Elements[i].Area > 0.0 && solution.Escaped[i] < 0.5f;
      worst = room ? std::max(worst, std::abs(solution.Radiosity[i].x / expected - 1.0)) : worst;
    }
    std::printf(
      "closed box, reflectance %.1f: E / (1 - rho) within %.3f %%\n", reflectance, 100.0 * worst);
    EXPECT_LT(worst, 1.5e-5);
  }
}

TEST(Radiosity, AimedLightFillsAClosedBox)
{
  PatchMesh mesh;
  AddBox(mesh, Point(-1.0), Point(1.0), AddMatte(mesh, Color(0.5), Color(1.0)), true);
  AddBox(
    mesh, { -0.5, -0.6, -0.9 }, { 0.3, 0.2, 0.4 }, AddMatte(mesh, Color(0.5), Color(1.0)), false);
  Cut(mesh, 0.5);
  const std::vector<Element> elements = MakeElements(mesh);
  const PatchRays rays(elements);
  const auto light = DirectIrradiance(elements, rays, { {}, MakeEmitters(mesh) }, 256);
  double square = 0.0;
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    if (light[i] != Color(0.0)) // not the outside
    {
      square += std::pow(light[i].x / Pi - 1.0, 2) * elements[i].Area;
      sum += light[i].x / Pi * elements[i].Area;
      area += elements[i].Area;
    }
  }
  std::printf(
    "aimed at every wall: irradiance pi L within %.3f %% (standard deviation), %+.4f %% in the "
    "mean\n",
    100.0 * std::sqrt(square / area), 100.0 * (sum / area - 1.0));
  EXPECT_LT(std::sqrt(square / area), 0.01);
  EXPECT_NEAR(sum / area, 1.0, 0.001);
}

TEST(Radiosity, SolversAgree)
{
  Settings settings = Quick();
  settings.Both = true;
  const Solution solution = Solve(Room(), {}, settings);
  const double apart = SolverDifference(solution);
  std::printf("solvers: %zu sweeps, residual %.1e; shooting of %.2f matrices' work, residual %.1e; "
              "apart by %.4f %% of the mean at most\n",
    solution.Gathered.History.size(), solution.Gathered.History.back().Residual,
    solution.Shot.History.back().Work, solution.Shot.History.back().Residual, 100.0 * apart);
  EXPECT_TRUE(solution.Gathered.Converged && solution.Shot.Converged);
  EXPECT_GT(apart, 0.0) << "they cannot agree to the last digit";
  EXPECT_LT(apart, 2.5e-6);
  for (const Reflected* solved : { &solution.Gathered, &solution.Shot })
  {
    for (std::size_t i = 1; i < solved->History.size(); ++i)
    {
      EXPECT_LT(solved->History[i].Residual, solved->History[i - 1].Residual);
    }
  }
}

TEST(Radiosity, EnergyIsKept)
{
  // What is emitted is absorbed: nothing leaves a closed room.
  const Solution solution = Solve(Room(), {}, Quick());
  double emitted = 0.0;
  double absorbed = 0.0;
  for (std::size_t i = 0; i < solution.Elements.size(); ++i)
  {
    const Element& element = solution.Elements[i];
    emitted += element.Area * element.Emission.x * (solution.Escaped[i] < 0.5f ? 1.0 : 0.0);
    absorbed += element.Area * (1.0 - element.Reflectance.x) * solution.Irradiance[i].x;
  }
  std::printf("closed room: %.4f emitted, %.4f absorbed (%+.2f %%)\n", emitted, absorbed,
    100.0 * (absorbed / emitted - 1.0));
  EXPECT_NEAR(absorbed / emitted, 1.0, 0.0021);
}

TEST(Radiosity, StatedErrorIsWhatChanceMakes)
{
  Settings settings = Quick();
  settings.Reciprocal = false;
  settings.Rays = 4096;
  const Solution fine = Solve(Room(), {}, settings);
  settings.Rays = 64;
  const Solution coarse = Solve(Room(), {}, settings);
  double off = 0.0;
  double stated = 0.0;
  for (std::size_t i = 0; i < fine.Elements.size(); ++i)
  {
    const Color apart = coarse.Irradiance[i] - fine.Irradiance[i];
    off += glm::dot(apart, apart) * fine.Elements[i].Area;
    stated += glm::dot(coarse.Error[i], coarse.Error[i]) * fine.Elements[i].Area;
  }
  std::printf("64 rays: off by %.3f of the stated error\n", std::sqrt(off / stated));
  EXPECT_LT(off, stated) << "strata make it smaller";
  EXPECT_GT(off, 0.1 * stated);
}

TEST(Radiosity, LightsAreAsInVtk)
{
  PatchMesh mesh;
  AddQuad(
    mesh, { { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } } }, AddMatte(mesh, Color(0.5)));
  Illumination light;
  light.Lights.resize(1);
  Light& sun = light.Lights[0];
  sun.Color = Color(1.0);
  sun.WorldDirection = glm::normalize(Point(1.0, 0.0, -1.0));
  Settings settings = Quick();
  const Solution slanted = Solve(mesh, light, settings);
  EXPECT_NEAR(slanted.Irradiance[0].x, Pi * std::sqrt(0.5), 1e-9);
  EXPECT_EQ(slanted.Irradiance[1].x, 0.0) << "the back";
  // A disc's worth of light: an emitter seen from a point on its axis.
  PatchMesh under;
  AddQuad(under,
    { { { -0.01, -0.01, 0 }, { 0.01, -0.01, 0 }, { 0.01, 0.01, 0 }, { -0.01, 0.01, 0 } } },
    AddMatte(under, Color(0.5)));
  AddDisc(under, 0.5, 1.0, false, AddMatte(under, Color(0.0), Color(2.0)));
  const Solution disc = Solve(under, {}, settings);
  const double expected = Pi * 2.0 * 0.25 / 1.25;
  std::printf("disc on its axis: E = %.6f of %.6f\n", disc.Irradiance[0].x, expected);
  EXPECT_NEAR(disc.Irradiance[0].x / expected, 1.0, 0.001);
}

TEST(Radiosity, CornersOfCurvedSurfacesDoNotShadowThemselves)
{
  // A flat roof: the mean of what is around its ridge lies below it.
  PatchMesh mesh;
  const std::uint32_t matte = AddMatte(mesh, Color(0.5));
  AddQuad(mesh, { { { -1, -1, 0 }, { 0, -1, 0.2 }, { 0, 1, 0.2 }, { -1, 1, 0 } } }, matte);
  AddQuad(mesh, { { { 0, -1, 0.2 }, { 1, -1, 0 }, { 1, 1, 0 }, { 0, 1, 0.2 } } }, matte);
  Illumination light;
  light.Lights.resize(1);
  light.Lights[0].Color = Color(1.0 / Pi);
  light.Lights[0].WorldDirection = Point(0.0, 0.0, -1.0);
  const Solution solution = Solve(mesh, light, Quick());
  const double expected = 1.0 / std::sqrt(1.0 + 0.2 * 0.2);
  int ridge = 0;
  for (std::size_t i = 0; i < solution.Elements.size(); i += 2)
  {
    for (int k = 0; k < 3; ++k)
    {
      ridge += solution.Elements[i].Corners[k].x == 0.0 ? 1 : 0;
      EXPECT_NEAR(solution.Points.Irradiance[solution.Points.OfElement[i][k]].x, expected, 1e-9);
    }
  }
  EXPECT_GT(ridge, 8);
}

TEST(Radiosity, ShadowsAreCut)
{
  PatchMesh mesh;
  AddQuad(mesh, { { { -2, -2, 0 }, { 2, -2, 0 }, { 2, 2, 0 }, { -2, 2, 0 } } },
    AddMatte(mesh, Color(0.5)));
  AddQuad(mesh, { { { -0.5, -0.5, 1 }, { 0.5, -0.5, 1 }, { 0.5, 0.5, 1 }, { -0.5, 0.5, 1 } } },
    AddMatte(mesh, Color(0.5)));
  Illumination light;
  light.Lights.resize(1);
  light.Lights[0].Color = Color(1.0 / Pi);
  light.Lights[0].WorldDirection = Point(0.0, 0.0, -1.0);
  Settings settings = Quick();
  const std::size_t before = Solve(mesh, light, settings).Elements.size();
  settings.Refinements = 2;
  const Solution fine = Solve(mesh, light, settings);
  double smallestAtEdge = 1.0;
  double smallestFarOff = 1.0;
  for (const Element& element : fine.Elements)
  {
    const Point middle = (element.Corners[0] + element.Corners[1] + element.Corners[2]) / 3.0;
    const double edge = std::abs(std::max(std::abs(middle.x), std::abs(middle.y)) - 0.5);
    double& smallest = edge < 0.1 ? smallestAtEdge : smallestFarOff;
    smallest = edge < 0.1 || edge > 1.0 ? std::min(smallest, element.Area) : smallest;
  }
  std::printf("%zu elements, then %zu; area at the shadow's edge %.2g, far off %.2g\n", before,
    fine.Elements.size(), smallestAtEdge, smallestFarOff);
  EXPECT_LE(smallestAtEdge, 0.25 * smallestFarOff);
}

TEST(Radiosity, BadInputIsOneSentence)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  PatchMesh nothing;
  const std::uint32_t matte = AddMatte(nothing, Color(0.5));
  Vertex a, b, c;
  b.At = Point(1.0, 0.0, 0.0);
  c.At = Point(2.0, 0.0, 0.0);
  EXPECT_FALSE(nothing.Add({ a, b, c }, matte, Color(1.0))) << "no area";
  c.At.y = nan;
  EXPECT_FALSE(nothing.Add({ a, b, c }, matte, Color(1.0))) << "not finite";
  EXPECT_NE(Refusal(nothing, Quick()).find("no surface"), std::string::npos);
  PatchMesh dark;
  AddBox(dark, Point(-1.0), Point(1.0), AddMatte(dark, Color(0.5)), true);
  EXPECT_NE(Refusal(dark, Quick()).find("has no light"), std::string::npos);
  PatchMesh mirror;
  AddBox(mirror, Point(-1.0), Point(1.0), AddMatte(mirror, Color(1.0), Color(1.0)), true);
  EXPECT_NE(Refusal(mirror, Quick()).find("reflects all light"), std::string::npos);
  Settings few = Quick();
  few.MaximumPatches = 20;
  EXPECT_NE(Refusal(Room(), few).find("--max-patches"), std::string::npos);
}

TEST(PatchMesh, CutPiecesFitTogether)
{
  PatchMesh mesh = Room();
  const double area = mesh.TotalArea();
  Cut(mesh, 0.13);
  mesh.Limit(17, 0.03);
  ASSERT_TRUE(mesh.Refine(1000000));
  EXPECT_NEAR(mesh.TotalArea() / area, 1.0, 1e-12);
  // An edge of a closed box has a face on either side.
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  double thinnest = 1.0;
  for (const Face& face : mesh.Faces())
  {
    thinnest = std::min(thinnest, mesh.Area(face) / std::pow(mesh.LongestEdge(face), 2));
    for (int i = 0; i < 3 && face.Surface < 2; ++i)
    {
      const auto ends = std::minmax(face.Corners[i], face.Corners[(i + 1) % 3]);
      ++edges[{ ends.first, ends.second }];
    }
  }
  for (const auto& edge : edges)
  {
    ASSERT_EQ(edge.second, 2);
  }
  std::printf("%zu faces; the thinnest has %.3f of its longest edge squared as area\n",
    mesh.Faces().size(), thinnest);
  EXPECT_GT(thinnest, 0.1);
}
