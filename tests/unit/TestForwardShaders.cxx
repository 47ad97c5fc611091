// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Code that is inserted into the shaders of props that VTK draws itself.
#include "TestData.h"

#include "light/ForwardShaders.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <unistd.h>

namespace
{
using namespace penumbra;
using namespace penumbra_test;
namespace fs = std::filesystem;

ForwardPart Part(const char* source)
{
  ForwardPart part;
  part.Source = source;
  return part;
}

ForwardLight Light(bool shadows, const std::vector<const char*>& indirect)
{
  ForwardLight light;
  light.Visibility = Part(shadows ? "shadow_maps/forward.glsl" : "");
  for (const char* source : indirect)
  {
    light.Indirect.push_back(Part(source));
  }
  if (indirect.size() > 1) // the last of several parts has several grids
  {
    light.Indirect.back().OnSurfaces["GI_FIELD_NESTED"] = "1";
    light.Indirect.back().InVolumes = light.Indirect.back().OnSurfaces;
  }
  return light;
}

const char* const DDGI = "ddgi/forward.glsl";
const char* const Baked = "sh_probes/forward.glsl";

std::string LitVolume(const ForwardLight& light, std::string text)
{
  ShaderLibrary library;
  ForwardShaders::MarkVolume(text);
  ForwardShaders(library, light).LightVolume(text);
  return text;
}

bool Has(const std::string& text, const char* what)
{
  return text.find(what) != std::string::npos;
}

std::string Replaced(std::string text, const char* name, const char* with)
{
  return std::regex_replace(text, std::regex(name), with);
}

// VTK's lighting function of volumes, with the names that a version uses.
std::string VolumeText(const char* signature, const char* gradient, const char* component)
{
  std::string text = TestText("unit/shaders/volume.glsl");
  text = Replaced(text, "SIGNATURE", signature);
  text = Replaced(text, "GRADIENT", gradient);
  return Replaced(text, "COMPONENT", component);
}
}

TEST(ForwardShaders, ReferenceCompilerAcceptsEveryCombination)
{
  if (std::system("glslangValidator --version > /dev/null 2>&1") != 0)
  {
    GTEST_SKIP() << "glslangValidator is not installed (package glslang-tools)";
  }
  const fs::path folder =
    fs::temp_directory_path() / ("penumbra_forward_" + std::to_string(getpid()));
  fs::create_directories(folder);
  ShaderLibrary library;
  int count = 0;
  for (const bool shadows : { false, true })
  {
    for (const auto& indirect : std::vector<std::vector<const char*>>{
           {}, { DDGI }, { Baked }, { DDGI, Baked }, { Baked, DDGI } })
    {
      for (const char* variant : { "", "GI_SOFT", "GI_CUBE", "GI_CASCADES" })
      {
        ForwardLight light = Light(shadows, indirect);
        if (*variant)
        {
          light.Visibility.OnSurfaces[variant] = "1";
          light.Visibility.InVolumes = light.Visibility.OnSurfaces;
        }
        if (light.IsEmpty() || (*variant && !shadows))
        {
          continue;
        }
        for (const auto& example : ForwardShaders(library, light).Examples())
        {
          EXPECT_TRUE(Has(example.second, "#version")) << example.first << " was not changed";
          std::ofstream(folder / (std::to_string(count++) + ".frag")) << example.second;
        }
      }
    }
  }
  EXPECT_EQ(count, 3 * (4 + 5 * 4));
  const std::string log = (folder / "log.txt").string();
  const int status = std::system(
    ("cd '" + folder.string() + "' && ls | grep frag | xargs glslangValidator > '" + log + "' 2>&1")
      .c_str());
  std::ifstream file(log);
  std::string errors((std::istreambuf_iterator<char>(file)), {});
  EXPECT_EQ(status, 0) << errors;
  fs::remove_all(folder);
}

TEST(ForwardShaders, VolumesOfEveryVersionAreLit)
{
  const ForwardLight light = Light(false, { DDGI });
  struct Version
  {
    const char* Signature;
    const char* Gradient;
    const char* Component;
    const char* Expected;
  };
  for (const Version& version :
    { // 9.1; from 9.2 on; from 9.6 on; several volumes at once
      Version{ "vec4 color, int component, float label", "gradient", "component",
        "in_diffuse[component] * color.rgb * giScattered(in_modelViewMatrix * (in_volumeMatrix[0] "
        "* "
        "(in_textureDatasetMatrix[0] * vec4(g_dataPos, 1.0))), gradient, in_textureToEye[0], "
        "in_cellSpacing[0])" },
      Version{ "vec4 color, int component, float label", "shading_gradient", "component",
        ", shading_gradient, in_textureToEye[0], in_cellSpacing[0])" },
      Version{ "vec4 color, int component, float label", "shading_gradient", "lightingComponent",
        "in_diffuse[lightingComponent] * color.rgb * giScattered(" },
      Version{ "vec3 texPos, vec4 color, const int volIdx, int component", "shading_gradient",
        "component", ", shading_gradient, in_textureToEye[volIdx + 1], in_cellSpacing[volIdx])" } })
  {
    const std::string text =
      LitVolume(light, VolumeText(version.Signature, version.Gradient, version.Component));
    EXPECT_TRUE(Has(text, version.Expected)) << version.Expected << "\n" << text;
    const auto added = text.find("finalColor.xyz += ");
    EXPECT_LT(added, text.find("finalColor.a = color.a;"));
    EXPECT_GT(added, text.find("finalColor.xyz = in_ambient["));
  }
}

TEST(ForwardShaders, UnshadedVolumesAreNotChanged)
{
  const std::string plain = TestText("unit/shaders/unshaded_volume.glsl");
  std::string marked = plain;
  ForwardShaders::MarkVolume(marked);
  EXPECT_EQ(LitVolume(Light(true, { DDGI }), plain), marked);
}

TEST(ForwardShaders, UnlitSurfacesAreNotChanged)
{
  const std::string plain = TestText("unit/shaders/unlit_surface.frag");
  std::string marked = plain;
  ForwardShaders::MarkSurface(marked);
  std::string lit = marked;
  ShaderLibrary library;
  const ForwardLight light = Light(true, { DDGI });
  std::string vertex;
  std::string geometry;
  ForwardShaders(library, light).LightSurface({ vertex, geometry, lit });
  EXPECT_EQ(lit, marked);
}

// Statements of a mapper's shaders tell whether pixels lie on flat facets; comments of the template do not count.
TEST(ForwardShaders, FlatAndSmoothMappersAreDistinguished)
{
  // 1 or 0 for flat facets, then 1 or 0 for round ones; without a name there is no such shader.
  const auto shape = [](const char* vertex, const char* geometry, const char* fragment) {
    const auto read = [](const char* name) {
      return *name ? TestText(std::string("unit/shaders/") + name) : std::string();
    };
    std::string texts[] = { read(vertex), read(geometry), read(fragment) };
    ShaderLibrary library;
    const Defines variant = PassShape({ texts[0], texts[1], texts[2] }, library);
    EXPECT_EQ(Has(texts[0], "out vec4 giRoundVSOutput;"), variant.count("GI_ROUND") > 0);
    EXPECT_EQ(Has(texts[2], "in vec4 giRoundVSOutput;"), variant.count("GI_ROUND") > 0);
    return std::to_string(variant.count("GI_FLAT")) + std::to_string(variant.count("GI_ROUND"));
  };
  EXPECT_EQ(shape("smooth.vert", "", "surface.frag"), "11");
  EXPECT_EQ(shape("smooth.vert", "", "offset_surface.frag"), "11");
  EXPECT_EQ(shape("smooth.vert", "empty.geom", "surface.frag"), "10")
    << "the geometry shader does not pass the normal on";
  EXPECT_EQ(shape("smooth.vert", "normals.geom", "surface.frag"), "11");
  EXPECT_EQ(shape("empty.vert", "", "surface.frag"), "10") << "no point normals";
  EXPECT_EQ(shape("smooth.vert", "", "impostor.frag"), "00") << "an impostor";
}

// Names of a part are made unique, other names are not changed.
TEST(ForwardShaders, PartsDoNotShareNames)
{
  const std::string text = LitVolume(Light(false, { DDGI, Baked }),
    VolumeText("vec4 color, int component", "gradient", "component"));
  for (const char* name :
    { "giField0Distance;", "giField1Distance;", "giField0IndirectCube(", "giField1IndirectCube(" })
  {
    EXPECT_TRUE(Has(text, name)) << name;
  }
  const std::string code = std::regex_replace(text, std::regex("//[^\n]*"), "");
  EXPECT_FALSE(std::regex_search(code, std::regex("\\bfield[A-Z]")));
  EXPECT_EQ(text.find("vec2 giEncodeOctahedral"), text.rfind("vec2 giEncodeOctahedral"));
}
