// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Errors give one clear message, and there is still a picture.
#include "Scenes.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <limits>
#include <unistd.h>

namespace penumbra_test
{
namespace
{
// Expect exactly one message, which contains a text.
void ExpectOneMessage(const std::string& text)
{
  const auto messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u) << testing::PrintToString(messages);
  EXPECT_NE(messages[0].find(text), std::string::npos) << messages[0];
}

class OverrideFolder
{
public:
  OverrideFolder()
    : Path(
        std::filesystem::temp_directory_path() / ("penumbra_shaders_" + std::to_string(getpid())))
  {
    std::filesystem::create_directories(this->Path / "direct_light");
    std::filesystem::create_directories(this->Path / "capture");
  }
  ~OverrideFolder() { std::filesystem::remove_all(this->Path); }
  void Write(const char* name, const std::string& text) const
  {
    std::ofstream(this->Path / name) << text;
  }
  const std::filesystem::path Path;
};

TEST(Errors, CorruptShadersAreReportedOnce)
{
  Scene plain;
  const Picture stock = Shoot(plain.Window);
  OverrideFolder folder;
  Scene scene;
  vtkGIPass* pass = scene.SetPass();
  for (const char* text :
    { "#version 430 core\nthis is no shader\n", "", "#include \"no/such/file.glsl\"\n" })
  {
    folder.Write("direct_light/resolve.frag", text);
    pass->SetShaderPath("");
    ExpectSame(stock, Shoot(scene.Window));
    EXPECT_STREQ(pass->GetLastError(), "");

    pass->SetShaderPath(folder.Path.c_str());
    const Picture fallback = Shoot(scene.Window);
    EXPECT_EQ(Compare(stock, fallback, 1).Within, 1.0) << "VTK's picture is drawn instead";
    EXPECT_NE(std::string(pass->GetLastError()), "");
    ExpectOneMessage(*text == '#' && text[1] == 'i' ? "no/such/file.glsl" : "resolve.frag");
    // Reported once, not in every frame.
    scene.Window->Render();
    EXPECT_EQ(TakeMessages(), std::vector<std::string>());
    EXPECT_GT(pass->GetNumberOfRenderedProps(), 0);
  }
  pass->SetShaderPath("");
  ExpectSame(stock, Shoot(scene.Window));
  EXPECT_STREQ(pass->GetLastError(), "");
}

// VTK itself compiles the capture snippets, and crashes if it cannot build the program.
TEST(Errors, CorruptCaptureSnippetsAreReported)
{
  Scene plain;
  const Picture stock = Shoot(plain.Window);
  OverrideFolder folder;
  folder.Write("capture/phong.glsl", "  gl_FragData[0] = nonsense;\n");
  Scene scene;
  vtkGIPass* pass = scene.SetPass();
  pass->SetShaderPath(folder.Path.c_str());
  EXPECT_EQ(Compare(stock, Shoot(scene.Window), 1).Within, 1.0) << "VTK's picture is drawn instead";
  ExpectOneMessage("capture/phong.glsl");
  pass->SetShaderPath("");
  ExpectSame(stock, Shoot(scene.Window));
  EXPECT_STREQ(pass->GetLastError(), "");
}

TEST(Errors, ValidShaderOverridesTakeEffect)
{
  OverrideFolder folder;
  folder.Write("direct_light/resolve.frag",
    "#version 430 core\nlayout(location = 0) out vec4 color;\n"
    "void main() { color = vec4(1.0, 0.0, 1.0, 1.0); }\n");
  Scene scene(false);
  scene.SetPass()->SetShaderPath(folder.Path.c_str());
  const Picture picture = Shoot(scene.Window);
  EXPECT_EQ(picture.At(130, 110)[1], 0);
  EXPECT_EQ(picture.At(130, 110)[0], 255);
}

TEST(Errors, UnknownNamesAreReported)
{
  vtkNew<vtkGIPass> pass;
  EXPECT_TRUE(pass->SetPreset("fast"));
  EXPECT_FALSE(pass->SetPreset("fastest"));
  ExpectOneMessage("fastest");
  EXPECT_STREQ(pass->GetPreset(), "fast");
  EXPECT_FALSE(pass->SetPreset(nullptr));
  ExpectOneMessage("preset");
  EXPECT_EQ(pass->GetTechnique("shadows"), nullptr);
  EXPECT_EQ(pass->GetTechnique(static_cast<const char*>(nullptr)), nullptr);
  EXPECT_EQ(pass->GetTechnique(-1), nullptr);
  EXPECT_EQ(pass->GetTechnique(pass->GetNumberOfTechniques()), nullptr);

  vtkGITechnique* shadows = pass->GetTechnique("shadow-maps");
  EXPECT_FALSE(shadows->SetParameter("radius", 1.0));
  EXPECT_NE(std::string(shadows->GetLastError()).find("slope-bias"), std::string::npos)
    << "the message lists the valid names";
  ExpectOneMessage("radius");
  EXPECT_FALSE(shadows->SetParameterFromText(nullptr, "1"));
  EXPECT_EQ(TakeMessages().size(), 1u);
  EXPECT_FALSE(shadows->ApplyPreset("fastest"));
}

TEST(Errors, ParametersOutOfRangeAreRefused)
{
  vtkNew<vtkGIPass> pass;
  vtkGITechnique* shadows = pass->GetTechnique("shadow-maps");
  const double before = shadows->GetParameter("resolution");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double value : { 0.0, -5.0, 1e9, 100.5, nan, infinity })
  {
    EXPECT_FALSE(shadows->SetParameter("resolution", value)) << value;
    ExpectOneMessage("shadow-maps.resolution");
  }
  for (const char* text : { "", "many", "12x", "-1", "nan", "1e30" })
  {
    EXPECT_FALSE(shadows->SetParameterFromText("resolution", text)) << text;
    ExpectOneMessage("resolution");
  }
  EXPECT_EQ(shadows->GetParameter("resolution"), before);
  EXPECT_TRUE(shadows->SetParameterFromText("resolution", "512"));
  EXPECT_EQ(shadows->GetParameter("resolution"), 512.0);
}

TEST(Statistics, AreJson)
{
  Scene scene;
  vtkGIPass* pass = scene.SetPass();
  pass->CollectStatisticsOn();
  pass->SetPreset("balanced");
  scene.Window->Render();
  const auto statistics = nlohmann::json::parse(pass->GetStatistics());
  ASSERT_TRUE(statistics.contains("passes"));
  std::vector<std::string> names;
  for (const auto& row : statistics["passes"])
  {
    names.push_back(row["name"]);
    EXPECT_GE(row["milliseconds"].get<double>(), 0.0);
  }
  EXPECT_NE(std::find(names.begin(), names.end(), "capture"), names.end());
  EXPECT_NE(std::find(names.begin(), names.end(), "direct-light"), names.end());
  EXPECT_EQ(statistics["lights"], 1);
  EXPECT_GT(statistics["bytes"].get<double>(), 0.0);
}

TEST(Errors, EmptyScenesRaiseNone)
{
  Stage stage;
  auto passes = stage.SetPasses();
  passes[0]->SetPreset("balanced");
  stage.Window->Render();
  EXPECT_STREQ(passes[0]->GetLastError(), "");
  vtkNew<vtkPolyData> empty;
  stage.Add(empty);
  stage.Window->Render();
  vtkNew<vtkImageData> radiance;
  EXPECT_FALSE(passes[0]->GetRadiance(stage.Renderer, radiance));
  passes[0]->KeepRadianceOn();
  stage.Window->Render();
  EXPECT_TRUE(passes[0]->GetRadiance(stage.Renderer, radiance));
  EXPECT_FALSE(passes[0]->GetRadiance(nullptr, radiance));
  EXPECT_FALSE(passes[0]->GetRadiance(stage.Renderer, nullptr));
  EXPECT_STREQ(passes[0]->GetLastError(), "");
}

// Points that are NaN do not spread into the picture.
TEST(Errors, NaNPointsGiveFiniteRadiance)
{
  Stage stage;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  sphere->Update();
  vtkPolyData* data = sphere->GetOutput();
  vtkActor* actor = stage.Add(data);
  Stage::LookAround(stage.Renderer);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  data->GetPoints()->SetPoint(100, nan, nan, nan);
  data->GetPoints()->Modified();
  actor->GetProperty()->SetSpecular(0.5);
  auto passes = stage.SetPasses();
  passes[0]->SetPreset("balanced");
  passes[0]->KeepRadianceOn();
  stage.Window->Render();
  vtkNew<vtkImageData> radiance;
  ASSERT_TRUE(passes[0]->GetRadiance(stage.Renderer, radiance));
  const auto* values = static_cast<float*>(radiance->GetScalarPointer());
  for (vtkIdType i = 0; i < 4 * radiance->GetNumberOfPoints(); ++i)
  {
    ASSERT_TRUE(std::isfinite(values[i])) << "at value " << i;
  }
}
}
}
