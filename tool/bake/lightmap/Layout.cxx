// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/lightmap/Layout.h"

#include "bake/lightmap/GatherLight.h"

#include "common/Failure.h"

#include <OpenImageIO/hash.h>

#include <algorithm>
#include <cstring>

namespace penumbra::lightmap
{
namespace
{
using Sides = std::vector<std::array<bool, 2>>;

/// Sides of charts that any light reaches. None reaches the inside of solids and the outside of rooms.
Sides FindLitSides(const Layout& layout, double texel, GatherLight& gather, tool::Step& step)
{
  constexpr int least = 8, most = 64, paths = 16;
  std::vector<Vec3> points, normals;
  std::vector<std::pair<std::size_t, int>> sides;
  for (std::size_t c = 0; c < layout.Charts.size(); ++c)
  {
    const Chart& chart = layout.Charts[c];
    const double texels = chart.Size.x * chart.Size.y / (texel * texel);
    const int count = std::clamp(static_cast<int>(std::min(texels, 1e6) / 4), least, most);
    for (int back = 0; back < 2; ++back)
    {
      if (layout.Scene.Triangles[chart.Triangles.front()].Visible[back])
      {
        ScatterPoints(layout.Scene, chart, back != 0, count, points, normals);
        sides.resize(points.size(), { c, back });
      }
    }
  }
  gather(points, normals, 0, paths, step.GetProgress());
  Sides lit(layout.Charts.size(), { { false, false } });
  const auto channels = static_cast<std::size_t>(gather.Channels());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const float* light = &gather.Light[i * channels];
    bool& side = lit[sides[i].first][static_cast<std::size_t>(sides[i].second)];
    side = side || light[0] > 0.0f || light[1] > 0.0f || light[2] > 0.0f;
  }
  return lit;
}

std::vector<Patch> MakePatches(const Layout& layout)
{
  Vec3 center;
  layout.Scene.Bounds().GetCenter(&center[0]);
  std::vector<OIIO::SHA1> keys(layout.Packing.Tiles.size());
  for (const Texel& texel : layout.Texels)
  {
    // Relative to the centre of the surfaces, as in ray tracing, with the same rounding.
    const glm::vec3 at(texel.At - center);
    const glm::vec3 normal(texel.Normal);
    keys[texel.Tile].append(&at, sizeof(at));
    keys[texel.Tile].append(&normal, sizeof(normal));
  }
  std::vector<Patch> patches;
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    const Tile& tile = layout.Packing.Tiles[i];
    std::uint64_t key = 0;
    std::memcpy(&key, keys[i].digest().data(), sizeof(key));
    patches.push_back({ tile.At, tile.Texels, key });
  }
  return patches;
}
}

Layout MakeLayout(vtkRenderer* renderer, const BakeSettings& settings, GatherLight& gather,
  tool::Reporter& reporter)
{
  tool::Step step(reporter, "unwrapping surfaces");
  Layout layout;
  layout.Scene = GatherSurfaces(renderer, reporter);
  if (layout.Scene.Triangles.empty())
  {
    tool::Fail("the scene has no opaque surface that is lit, as a lightmap needs");
  }
  layout.Charts = MakeCharts(layout.Scene);
  constexpr double fine = 128.0;
  const double texel = settings.TexelSize > 0.0 ? settings.TexelSize
                                                : layout.Scene.Bounds().GetDiagonalLength() / fine;
  const Sides wanted = FindLitSides(layout, texel, gather, step);
  if (const int lights = gather.CameraLights())
  {
    reporter.Note(fmt::format(
      "{} lights follow the camera and are left out: their light cannot be baked", lights));
  }
  for (const auto& side : wanted)
  {
    layout.DarkSides += (side[0] ? 0 : 1) + (side[1] ? 0 : 1);
  }
  if (layout.DarkSides == 2 * wanted.size())
  {
    tool::Fail("no {} reaches any surface: give the scene lights, an environment or emissive "
               "surfaces",
      settings.Direct ? "light" : "indirect light");
  }
  layout.Packing = PackAtlas(layout.Charts, wanted, texel, settings.LargestSide);
  if (settings.TexelSize > 0.0 && layout.Packing.TexelSize > texel)
  {
    reporter.Note(
      fmt::format("texels are {:.3g} wide, because of --max-size", layout.Packing.TexelSize));
  }
  layout.Texels = PlaceTexels(layout.Scene, layout.Charts, layout.Packing);
  layout.Patches = MakePatches(layout);
  return layout;
}
}
