// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Files of lightmaps come back, and broken ones are refused.
#include "LightmapScenes.h"

#include "common/Failure.h"

#include <OpenImageIO/imageio.h>
#include <vtkFieldData.h>
#include <vtkGIBakeFile.h>
#include <vtkGIPass.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkXMLImageDataReader.h>

#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
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
    this->Map.Scene = "penumbra scene 1\n";
    this->Map.Made = "made in a test";
    this->Map.Settings = "settings";
    this->Path = (this->Folder / "map.vti").string();
    WriteLightmap(this->Path, this->Map);
  }
  void TearDown() override { std::filesystem::remove_all(this->Folder); }

  // Why it is refused; else it must hold what was written.
  std::string Refusal(const std::string& path)
  {
    vtkNew<vtkGIBakeFile> file;
    vtkNew<vtkGIPass> pass;
    vtkNew<vtkImageData> read;
    if (!file->Load(path.c_str(), pass))
    {
      return file->GetLastError();
    }
    EXPECT_TRUE(file->Read(path.c_str(), read));
    ExpectSame(read, MakeImage(this->Map));
    return "";
  }

  // Every array that there was, bit for bit.
  static void ExpectSame(vtkImageData* read, vtkImageData* written)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(read->GetDimensions()[axis], written->GetDimensions()[axis]);
    }
    vtkFieldData* pairs[][2] = { { read->GetPointData(), written->GetPointData() },
      { read->GetFieldData(), written->GetFieldData() } };
    for (auto& [ours, theirs] : pairs)
    {
      for (int i = 0; i < theirs->GetNumberOfArrays(); ++i)
      {
        vtkAbstractArray* wanted = theirs->GetAbstractArray(i);
        vtkAbstractArray* array = ours->GetAbstractArray(wanted->GetName());
        ASSERT_TRUE(array) << wanted->GetName();
        ASSERT_EQ(array->GetDataType(), wanted->GetDataType()) << wanted->GetName();
        ASSERT_EQ(array->GetNumberOfComponents(), wanted->GetNumberOfComponents());
        ASSERT_EQ(array->GetNumberOfValues(), wanted->GetNumberOfValues()) << wanted->GetName();
        if (auto* text = vtkStringArray::SafeDownCast(array))
        {
          EXPECT_EQ(text->GetValue(0), vtkStringArray::SafeDownCast(wanted)->GetValue(0));
          continue;
        }
        EXPECT_EQ(
          std::memcmp(array->GetVoidPointer(0), wanted->GetVoidPointer(0),
            static_cast<std::size_t>(array->GetNumberOfValues()) * array->GetDataTypeSize()),
          0)
          << wanted->GetName();
      }
    }
  }

  std::filesystem::path Folder;
  std::string Path;
  Lightmap Map;
};

float AsHalf(float value)
{
  return glm::unpackHalf1x16(glm::packHalf1x16(value));
}
}

TEST_F(LightmapFiles, ComeBack)
{
  vtkNew<vtkXMLImageDataReader> reader; // as anyone reads it
  reader->SetFileName(this->Path.c_str());
  reader->Update();
  ExpectSame(reader->GetOutput(), MakeImage(this->Map));
  EXPECT_STREQ(reader->GetOutput()->GetPointData()->GetScalars()->GetName(), "light");
  const Lightmap read = ReadLightmap(this->Path);
  for (Light* light : { &this->Map.Baked, &this->Map.First })
  {
    std::transform(light->Values.begin(), light->Values.end(), light->Values.begin(), AsHalf);
  }
  EXPECT_EQ(read.Baked.Values, this->Map.Baked.Values);
  EXPECT_EQ(read.First.Values, this->Map.First.Values);
  EXPECT_EQ(read.Scene, this->Map.Scene);
  EXPECT_EQ(read.Made, this->Map.Made);
  EXPECT_EQ(read.Settings, this->Map.Settings);
  ASSERT_EQ(read.Patches.size(), 1u);
  EXPECT_EQ(read.Patches[0].At, this->Map.Patches[0].At);
  EXPECT_EQ(read.Patches[0].Texels, this->Map.Patches[0].Texels);
  EXPECT_EQ(read.Patches[0].Key, this->Map.Patches[0].Key);
}

// Every kind of light that a file may hold, each with its own values.
TEST_F(LightmapFiles, KindsOfLightComeBack)
{
  const Light plain = this->Map.Baked;
  for (const int each : { 3, 12 })
  {
    for (const int direct : { 0, each })
    {
      this->Map.Baked = Light(plain.Width, plain.Height, each);
      this->Map.Direct = Light(plain.Width, plain.Height, direct);
      float value = 0.0f;
      for (Light* light : { &this->Map.Baked, &this->Map.Direct })
      {
        for (float& to : light->Values)
        {
          value = value < 2000.0f ? value + 1.0f : 0.0f; // half floats hold these as they are
          to = value;
        }
      }
      WriteLightmap(this->Path, this->Map);
      EXPECT_EQ(this->Refusal(this->Path), "");
      EXPECT_EQ(ReadLightmap(this->Path).Baked.Values, this->Map.Baked.Values);
      const auto image = MakeImage(this->Map);
      const std::size_t texel = 2 * std::size_t(plain.Width) + 3;
      const auto expect = [&](const char* name, const Light& light, int first) {
        vtkDataArray* array = image->GetPointData()->GetArray(name);
        ASSERT_EQ(array != nullptr, light.Channels > first) << name;
        for (int c = 0; array && c < array->GetNumberOfComponents(); ++c)
        {
          EXPECT_EQ(
            array->GetComponent(static_cast<vtkIdType>(texel), c), light.Pixel(texel)[first + c]);
        }
      };
      expect("light", this->Map.Baked, 0);
      expect("moments", this->Map.Baked, 3);
      expect("lamps", this->Map.Direct, 0);
      expect("lamp moments", this->Map.Direct, 3);
    }
  }
}

// Files that the former version wrote: what OpenImageIO finds in them.
TEST_F(LightmapFiles, OldOnesAreRead)
{
  for (const std::string name : { "old_lightmap.exr", "old_lightmap_plain.exr" })
  {
    const std::string path = PENUMBRA_OLD_LIGHTMAPS + name;
    ASSERT_TRUE(IsOpenExr(path));
    const Lightmap map = ReadOldLightmap(path);
    auto input = OIIO::ImageInput::open(path);
    const OIIO::ImageSpec spec = input->spec();
    std::vector<float> pixels(spec.image_pixels() * spec.nchannels);
    ASSERT_TRUE(input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data()));
    const auto image = MakeImage(map);
    ASSERT_EQ(image->GetNumberOfPoints(), static_cast<vtkIdType>(spec.image_pixels()));
    const std::map<std::string, std::pair<std::string, int>> places = { { "R", { "light", 0 } },
      { "B", { "light", 2 } }, { "moment-y.G", { "moments", 4 } }, { "lamps.G", { "lamps", 1 } },
      { "lamps-moment-z.B", { "lamp moments", 8 } }, { "first.R", { "first", 0 } } };
    std::size_t found = 0;
    for (const auto& [channel, place] : places)
    {
      const int at = spec.channelindex(channel);
      vtkDataArray* array = image->GetPointData()->GetArray(place.first.c_str());
      ASSERT_EQ(array != nullptr, at >= 0) << channel;
      for (std::size_t i = 0; array && i < spec.image_pixels(); ++i)
      {
        ASSERT_EQ(array->GetComponent(static_cast<vtkIdType>(i), place.second),
          pixels[i * spec.nchannels + at]);
      }
      found += array ? 1 : 0;
    }
    EXPECT_EQ(found, name == "old_lightmap.exr" ? places.size() : 3u);
    EXPECT_EQ(map.Triangles.size(), 6u);
    EXPECT_EQ(map.Points.size(), 12u);
    EXPECT_EQ(map.Patches.size(), 3u);
    WriteLightmap(this->Path, map);
    this->Map = map;
    EXPECT_EQ(this->Refusal(this->Path), "");
  }
}

TEST_F(LightmapFiles, BrokenOnesAreRefused)
{
  std::ifstream file(this->Path, std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(file)), {});
  const std::string broken = (this->Folder / "broken.vti").string();
  int accepted = 0;
  constexpr int changed = 400;
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
    EXPECT_TRUE(said.empty() || said.find("broken.vti") != std::string::npos) << said;
    EXPECT_TRUE(i >= 20 || !said.empty()) << "cut off at " << bytes.size();
  }
  std::printf("%d of %d files with a byte changed were accepted\n", accepted, changed);
  EXPECT_LT(accepted, changed / 8);
  EXPECT_NE(
    this->Refusal((this->Folder / "none.vti").string()).find("does not exist"), std::string::npos);
}
