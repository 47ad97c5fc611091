// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Files of lightmaps come back, and broken ones are refused.
#include "LightmapScenes.h"

#include "common/Failure.h"

#include <vtkImageData.h>

#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>

#include <unistd.h>

using namespace penumbra_test;

namespace
{
class LightmapFiles : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Folder =
      std::filesystem::temp_directory_path() / ("penumbra_lightmap_" + std::to_string(getpid()));
    std::filesystem::create_directories(this->Folder);
    Scene scene;
    scene.AddBox();
    const Surfaces surfaces = GatherSurfaces(scene.Renderer);
    const std::vector<Chart> charts = MakeCharts(surfaces);
    const Atlas atlas = PackAll(charts, 0.1);
    const std::vector<Texel> texels = PlaceTexels(surfaces, charts, atlas);
    std::vector<unsigned char> known;
    this->Map.Baked = Fill(atlas, texels, known);
    this->Map.First = this->Map.Baked;
    AddSurfaces(this->Map, surfaces, charts, atlas);
    this->Map.Patches = { { { 1, 2 }, { 3, 4 }, 0x123456789abcdef0u } };
    this->Map.Scene = "a scene\nof two lines\n";
    this->Map.Made = "made in a test";
    this->Map.Settings = "settings";
    this->Path = (this->Folder / "map.exr").string();
    WriteLightmap(this->Path, this->Map);
  }
  void TearDown() override { std::filesystem::remove_all(this->Folder); }

  // Why it is refused; else it must hold what was written.
  std::string Refusal(const std::string& path)
  {
    try
    {
      ExpectSame(ReadLightmap(path), ReadLightmap(this->Path));
    }
    catch (const penumbra::tool::Failure& failure)
    {
      return failure.what();
    }
    return "";
  }

  static void ExpectSame(const Lightmap& read, const Lightmap& written)
  {
    EXPECT_EQ(read.Scene, written.Scene);
    EXPECT_EQ(read.Made, written.Made);
    EXPECT_EQ(read.Settings, written.Settings);
    EXPECT_EQ(read.Origin, written.Origin);
    EXPECT_EQ(read.Points, written.Points);
    EXPECT_EQ(read.Normals, written.Normals);
    EXPECT_EQ(read.Places, written.Places);
    EXPECT_EQ(read.Triangles, written.Triangles);
    ASSERT_EQ(read.Patches.size(), written.Patches.size());
    for (std::size_t i = 0; i < read.Patches.size(); ++i)
    {
      EXPECT_EQ(read.Patches[i].At, written.Patches[i].At);
      EXPECT_EQ(read.Patches[i].Texels, written.Patches[i].Texels);
      EXPECT_EQ(read.Patches[i].Key, written.Patches[i].Key);
    }
    EXPECT_EQ(read.Baked.Values, written.Baked.Values);
    EXPECT_EQ(read.Lamps.Values, written.Lamps.Values);
    EXPECT_EQ(read.First.Values, written.First.Values);
  }

  std::filesystem::path Folder;
  std::string Path;
  Lightmap Map;
};
}

TEST_F(LightmapFiles, ComeBack)
{
  EXPECT_TRUE(IsLightmap(this->Path));
  const Lightmap read = ReadLightmap(this->Path);
  for (Light* light : { &this->Map.Baked, &this->Map.First })
  {
    for (float& value : light->Values)
    {
      value = glm::unpackHalf2x16(glm::packHalf2x16({ value, 0.0f })).x; // as files have it
    }
  }
  ExpectSame(read, this->Map);
  EXPECT_EQ(read.Lamps.Channels, 0);
}

// Every kind of light that a file may hold, each with its own values.
TEST_F(LightmapFiles, KindsOfLightComeBack)
{
  const Light plain = this->Map.Baked;
  for (const int each : { 3, 12 })
  {
    for (const int lamps : { 0, each })
    {
      this->Map.Baked = Light(plain.Width, plain.Height, each);
      this->Map.Lamps = Light(plain.Width, plain.Height, lamps);
      float value = 0.0f;
      for (Light* light : { &this->Map.Baked, &this->Map.Lamps })
      {
        for (float& to : light->Values)
        {
          value = value < 2000.0f ? value + 1.0f : 0.0f; // half floats hold these as they are
          to = value;
        }
      }
      WriteLightmap(this->Path, this->Map);
      const Lightmap read = ReadLightmap(this->Path);
      EXPECT_EQ(read.Baked.Values, this->Map.Baked.Values);
      EXPECT_EQ(read.Lamps.Values, this->Map.Lamps.Values);
      EXPECT_EQ(read.First.Values.size(), plain.Values.size());
      const auto image = MakeImage(read);
      ASSERT_EQ(image->GetNumberOfScalarComponents(), each + lamps);
      const int last = each + lamps - 1;
      const Light& of = lamps > 0 ? read.Lamps : read.Baked;
      EXPECT_EQ(image->GetScalarComponentAsDouble(3, 2, 0, last),
        of.At(2 * std::size_t(plain.Width) + 3)[(lamps > 0 ? lamps : each) - 1]);
      EXPECT_EQ(image->GetScalarComponentAsDouble(3, 2, 0, 1),
        read.Baked.At(2 * std::size_t(plain.Width) + 3)[1]);
    }
  }
}

TEST_F(LightmapFiles, BrokenOnesAreRefused)
{
  std::ifstream file(this->Path, std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(file)), {});
  const std::string broken = (this->Folder / "broken.exr").string();
  int accepted = 0;
  constexpr int changed = 200;
  std::mt19937 random(11);
  for (int i = 0; i < 20 + changed; ++i)
  {
    std::string bytes = whole;
    if (i < 20)
    {
      bytes.resize(whole.size() * i / 20);
    }
    else
    {
      bytes[random() % bytes.size()] ^= static_cast<char>(1 + random() % 255);
    }
    std::ofstream(broken, std::ios::binary) << bytes;
    const std::string said = this->Refusal(broken);
    // Bytes that nothing depends on may change, such as a picture's size on the screen.
    accepted += said.empty() ? 1 : 0;
    EXPECT_TRUE(said.empty() || said.find("broken.exr") != std::string::npos) << said;
    EXPECT_TRUE(i >= 20 || !said.empty()) << "cut off at " << bytes.size();
  }
  std::printf("%d of %d files with a byte changed were accepted\n", accepted, changed);
  EXPECT_LT(accepted, changed / 8);
  EXPECT_NE(
    this->Refusal((this->Folder / "none.exr").string()).find("does not exist"), std::string::npos);
}
