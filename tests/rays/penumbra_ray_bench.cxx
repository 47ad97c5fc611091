// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Rates of the ray core and of Embree on the same cores, scenes and rays, in one run: medians of alternating
// repetitions. Does not measure uploads of rays, downloads of hits, or shading.
//
// usage: penumbra_ray_bench [--repetitions N] [--rays N] [--scene NAME-PART] [--json FILE]
#include "Cost.h"
#include "RayStage.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <thread>

using namespace penumbra;
using namespace penumbra_test;

namespace
{
/// Repeated timings.
struct Series
{
  std::vector<double> Wall, Cpu;
  void Add(const Seconds& seconds)
  {
    this->Wall.push_back(seconds.Wall);
    this->Cpu.push_back(seconds.Cpu);
  }
};

struct Options
{
  int Repetitions = 5;
  int Rays = 1 << 18;
  std::string Scene;
  std::string Json;
};

Options Parse(int argc, char** argv)
{
  Options options;
  for (int i = 1; i + 1 < argc; i += 2)
  {
    const std::string name = argv[i];
    if (name == "--repetitions")
    {
      options.Repetitions = std::max(1, std::atoi(argv[i + 1]));
    }
    else if (name == "--rays")
    {
      options.Rays = std::max(64, std::atoi(argv[i + 1]));
    }
    else if (name == "--scene")
    {
      options.Scene = argv[i + 1];
    }
    else if (name == "--json")
    {
      options.Json = argv[i + 1];
    }
  }
  return options;
}

nlohmann::json TraceRates(RayStage& stage, const RayWorld& world, const Options& options)
{
  stage.Show(world);
  const EmbreeWorld embree(world);
  int side = 8;
  while (side * side * 2 < options.Rays)
  {
    side *= 2;
  }
  struct Kind
  {
    const char* Name;
    penumbra_test::Rays Rays;
    EmbreeWorld::Mode Mode;
    bool Any;
  };
  const Rays camera = CameraRays(world, 2 * side, side);
  const Rays scattered = IncoherentRays(world, options.Rays, 21);
  const std::vector<Kind> kinds = { { "incoherent, intersect1", scattered, EmbreeWorld::Single,
                                      false },
    { "coherent, intersect1", camera, EmbreeWorld::Single, false },
    { "coherent, packets of 8", camera, EmbreeWorld::Packets, false },
    { "incoherent any, occluded1", scattered, EmbreeWorld::Occluded, true } };
  nlohmann::json rows = nlohmann::json::array();
  const double cores = std::max(1u, std::thread::hardware_concurrency());
  for (const Kind& kind : kinds)
  {
    Series ours, theirs;
    Answers answers;
    for (int i = 0; i < options.Repetitions; ++i)
    {
      theirs.Add(embree.Trace(kind.Rays, answers, kind.Mode));
      ours.Add(stage.Time(kind.Rays, kind.Any));
    }
    const double count = 1e-6 * static_cast<double>(kind.Rays.size());
    const double cpu[2] = { count * cores / MedianOf(ours.Cpu),
      count * cores / MedianOf(theirs.Cpu) };
    const double wall[2] = { count / MedianOf(ours.Wall), count / MedianOf(theirs.Wall) };
    std::printf("%-24s %-26s %8.2f %8.2f %7.2f %10.2f %8.2f %7.2f\n", world.Name.c_str(), kind.Name,
      cpu[0], cpu[1], cpu[0] / cpu[1], wall[0], wall[1], wall[0] / wall[1]);
    std::fflush(stdout);
    rows.push_back({ { "scene", world.Name }, { "rays", kind.Name }, { "mrays", cpu[0] },
      { "embree", cpu[1] }, { "ratio", cpu[0] / cpu[1] }, { "wall_mrays", wall[0] },
      { "wall_embree", wall[1] }, { "wall_ratio", wall[0] / wall[1] } });
  }
  return rows;
}

nlohmann::json BuildRate(int spheres, int rings)
{
  const RayGeometry geometry = SphereField(spheres, rings);
  Series series, refits;
  for (int i = 0; i < 3; ++i)
  {
    Seconds begin = Seconds::Now();
    RayMesh mesh(geometry);
    series.Add(begin.Since());
    begin = Seconds::Now();
    mesh.Refit(geometry);
    refits.Add(begin.Since());
  }
  const double cores = std::max(1u, std::thread::hardware_concurrency());
  const double count = 1e-6 * static_cast<double>(geometry.Triangles.size());
  std::printf(
    "build %.2f M triangles: %.2f M/s by CPU time, %.2f M/s by the clock; refit %.2f, %.2f\n",
    count, count * cores / MedianOf(series.Cpu), count / MedianOf(series.Wall),
    count * cores / MedianOf(refits.Cpu), count / MedianOf(refits.Wall));
  std::fflush(stdout);
  return { { "mtriangles", count }, { "per_second", count * cores / MedianOf(series.Cpu) },
    { "wall_per_second", count / MedianOf(series.Wall) },
    { "refit_wall_per_second", count / MedianOf(refits.Wall) } };
}

nlohmann::json MoveTime(RayStage& stage, int instances)
{
  const RayWorld world = Glyphs(instances);
  stage.Show(world);
  Series series;
  for (int i = 0; i < 51; ++i)
  {
    const std::size_t moved = static_cast<std::size_t>(i) * 7 % world.Instances.size();
    glm::dmat4 matrix = world.Instances[moved].MeshToWorld;
    matrix[3].x += 0.1 * i;
    const Seconds begin = Seconds::Now();
    stage.Scene.SetInstance(moved, world.Instances[moved].Mesh, matrix);
    stage.Scene.Update();
    series.Add(begin.Since());
  }
  std::printf("moving one of %d instances: %.2f ms by CPU time, %.2f ms by the clock\n", instances,
    1e3 * MedianOf(series.Cpu), 1e3 * MedianOf(series.Wall));
  std::fflush(stdout);
  return { { "instances", instances }, { "cpu_ms", 1e3 * MedianOf(series.Cpu) },
    { "wall_ms", 1e3 * MedianOf(series.Wall) } };
}
}

int main(int argc, char** argv)
{
  const Options options = Parse(argc, argv);
  RayStage stage;
  if (!stage.IsReady())
  {
    std::cerr << "penumbra_ray_bench: no OpenGL context can be made here.\n";
    return 1;
  }
  std::printf("%s, %u cores\n", stage.Description(), std::thread::hardware_concurrency());
  nlohmann::json report = { { "device", stage.Description() } };
  report["build"] = { BuildRate(160, 18), BuildRate(160, 60) };
  report["move"] = { MoveTime(stage, 1000), MoveTime(stage, 10000) };
  std::printf(
    "%-24s %-26s %s\n", "Mray/s", "", "   by CPU time: ours, Embree, ratio; by the clock");
  report["trace"] = nlohmann::json::array();
  for (const RayWorld& world : AllWorlds())
  {
    if (world.Name.find(options.Scene) != std::string::npos)
    {
      for (const auto& row : TraceRates(stage, world, options))
      {
        report["trace"].push_back(row);
      }
    }
  }
  if (!options.Json.empty())
  {
    std::ofstream(options.Json) << report.dump(2) << "\n";
  }
  return 0;
}
