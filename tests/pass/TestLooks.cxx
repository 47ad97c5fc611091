// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Looks: their files are checked, and removing one brings back everything that it changed.
#include "Scenes.h"

#include "vtkGILook.h"
#include "vtkCallbackCommand.h"
#include "vtkImageData.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkTexture.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace penumbra_test
{
namespace
{
/// A folder for looks, which PENUMBRA_LOOK_PATH names.
class LookFolder
{
public:
  LookFolder()
    : Path(std::filesystem::temp_directory_path() / ("penumbra_looks_" + std::to_string(getpid())))
  {
    std::filesystem::create_directories(this->Path);
    setenv("PENUMBRA_LOOK_PATH", this->Path.c_str(), 1);
  }
  ~LookFolder()
  {
    unsetenv("PENUMBRA_LOOK_PATH");
    std::filesystem::remove_all(this->Path);
  }
  std::string Write(const std::string& name, const std::string& text) const
  {
    const auto path = this->Path / (name + ".json");
    std::ofstream(path) << text;
    return path.string();
  }
  const std::filesystem::path Path;
};

/// All that VTK's objects print of themselves, except for what changes without a difference in a picture.
std::string Printed(vtkObject* object)
{
  std::ostringstream all;
  object->Print(all);
  std::istringstream lines(all.str());
  std::string kept;
  for (std::string line; std::getline(lines, line);)
  {
    bool counted = false;
    for (const char* word : { "Modified Time", "Reference Count", "Time Uploaded", "Last Time",
           "TimeFactor", "vtkSimpleTransform at" })
    {
      counted = counted || line.find(word) != std::string::npos;
    }
    kept += counted ? "" : line + "\n";
  }
  return kept;
}

/// The renderer, its lights and textures, the camera, and the techniques with their parameters.
std::string State(vtkRenderer* renderer, vtkGIPass* pass)
{
  std::string state = Printed(renderer) + Printed(renderer->GetActiveCamera());
  vtkCollectionSimpleIterator cookie;
  renderer->GetLights()->InitTraversal(cookie);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(cookie))
  {
    state += Printed(light);
    state += light->GetTransformMatrix() ? Printed(light->GetTransformMatrix()) : "no transform";
  }
  for (vtkTexture* texture :
    { renderer->GetBackgroundTexture(), renderer->GetEnvironmentTexture() })
  {
    state += texture ? Printed(texture) : "no texture";
  }
  for (int i = 0; pass && i < pass->GetNumberOfTechniques(); ++i)
  {
    state += Printed(pass->GetTechnique(i));
  }
  return state;
}

void Apply(const std::string& name, vtkRenderer* renderer, vtkGIPass* pass)
{
  vtkNew<vtkGILook> look;
  ASSERT_TRUE(look->Load(name.c_str())) << look->GetLastError();
  look->ApplyTo(renderer, pass);
  EXPECT_EQ(vtkGILook::GetAppliedName(renderer), name);
}

std::vector<std::string> Names()
{
  std::vector<std::string> names;
  const int count = vtkGILook::GetNumberOfLooks();
  for (int i = 0; i < count; ++i)
  {
    names.emplace_back(vtkGILook::GetLookName(i));
  }
  return names;
}

/// Lights of every type, and every kind of background.
void Furnish(vtkRenderer* renderer, int kind)
{
  const int types[] = { VTK_LIGHT_TYPE_HEADLIGHT, VTK_LIGHT_TYPE_CAMERA_LIGHT,
    VTK_LIGHT_TYPE_SCENE_LIGHT };
  for (int type : types)
  {
    vtkNew<vtkLight> light;
    light->SetLightType(type);
    light->SetPosition(0.3, 0.4, 1.0);
    light->SetIntensity(0.3);
    light->SetSwitch(kind != 1 || type != VTK_LIGHT_TYPE_CAMERA_LIGHT);
    renderer->AddLight(light);
  }
  renderer->SetLightFollowCamera(kind != 2);
  renderer->SetAutomaticLightCreation(kind != 1);
  renderer->SetBackground(0.2, 0.3, 0.1);
  renderer->SetBackground2(0.7, 0.5, 0.6);
  renderer->SetGradientBackground(kind == 1);
  renderer->SetBackgroundAlpha(kind == 2 ? 0.0 : 1.0);
  vtkNew<vtkImageData> pixels;
  pixels->SetDimensions(4, 4, 1);
  pixels->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(
    static_cast<unsigned char*>(pixels->GetScalarPointer()), 48, static_cast<unsigned char>(120));
  vtkNew<vtkTexture> texture;
  texture->SetInputData(pixels);
  if (kind == 3)
  {
    renderer->SetBackgroundTexture(texture);
    renderer->TexturedBackgroundOn();
  }
  if (kind >= 2)
  {
    texture->MipmapOn();
    texture->InterpolateOn();
    renderer->SetEnvironmentTexture(texture, kind == 3);
    renderer->SetUseImageBasedLighting(
      kind == 3); // which is not drawn, as VTK takes seconds to filter the texture
    renderer->SetEnvironmentUp(0.0, 0.0, 1.0);
    renderer->SetEnvironmentRight(0.0, 1.0, 0.0);
  }
}

TEST(Looks, TheNamesBeginWithTheOneThatChangesNothing)
{
  const std::vector<std::string> names = Names();
  ASSERT_GE(names.size(), 2u);
  EXPECT_EQ(names.front(), "as-is");
  for (const std::string& name : names)
  {
    vtkNew<vtkGILook> look;
    EXPECT_TRUE(look->Load(name.c_str())) << look->GetLastError();
    EXPECT_EQ(look->GetName(), name);
    EXPECT_STRNE(look->GetTitle(), "");
    EXPECT_STRNE(look->GetDescription(), "");
  }
}

TEST(Looks, AMistakeInAFileIsOneSentence)
{
  const LookFolder folder;
  const std::pair<const char*, const char*> cases[] = {
    { R"({"lights": [)", "is not valid JSON" },
    { R"([])", "must be an object" },
    { R"({"lihgts": []})", "has no key 'lihgts': its keys are title" },
    { R"({"lights": 3})", "'lights' of the look 'wrong' is 3: it must be an array" },
    { R"({"lights": [{"elevation": 91}]})",
      "'elevation' of light 1 of the look 'wrong' is 91: it must be a number from -90 to 90" },
    { R"({"lights": [{}, {"color": [1, 2, 0]}]})", "'color' of light 2" },
    { R"({"sky": {"kind": "cloudy"}})", "it must be one of uniform, gradient, daylight" },
    { R"({"sky": {"turbidity": 0}})", "'turbidity' of the sky of the look 'wrong' is 0" },
    { R"({"sky": {"boxes": [{"width": 200}]}})", "'width' of box 1 of the sky" },
    { R"({"follows": "me"})", "it must be one of camera, world" },
    { R"({"background": "white"})", "it must be a colour: three numbers from 0 to 1" },
    { R"({"background": {"middle": [1, 1, 1]}})", "has no key 'middle': its keys are bottom, top" },
    { R"({"techniques": {"no-such": {}}})", "no technique 'no-such': there are ambient-occlusion" },
    { R"({"techniques": {"shadow-maps": {"enabled": 1}}})", "it must be true or false" },
    { R"({"techniques": {"shadow-maps": {"sofa": 1}}})",
      "has no key 'sofa': its keys are enabled" },
    { R"({"techniques": {"shadow-maps": {"resolution": 1e9}}})", "a whole number" },
    { R"({"techniques": {"shadow-maps": {"resolution": 3}}})",
      "'resolution' of shadow-maps of the look 'wrong' is 3: it must be a number from 64 to "
      "16384" },
    { R"({"techniques": {"ambient-occlusion": {"method": "guess"}}})",
      "it must be one of horizon, hemisphere" },
  };
  for (const auto& [text, says] : cases)
  {
    folder.Write("wrong", text);
    vtkNew<vtkGILook> look;
    EXPECT_FALSE(look->Load("wrong")) << text;
    const std::string error = look->GetLastError();
    EXPECT_NE(error.find(says), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
}

TEST(Looks, AnUnknownNameListsTheNames)
{
  vtkNew<vtkGILook> look;
  EXPECT_FALSE(look->Load("stduio"));
  EXPECT_NE(std::string(look->GetLastError()).find("there are as-is, "), std::string::npos)
    << look->GetLastError();
  EXPECT_FALSE(look->Load("/nowhere/at/all.json"));
  EXPECT_NE(std::string(look->GetLastError()).find("'/nowhere/at/all.json'"), std::string::npos);
  EXPECT_FALSE(look->Load(nullptr));
}

TEST(Looks, AFolderOfOnesOwnComesFirst)
{
  const LookFolder folder;
  folder.Write("mine", R"({"title": "Mine"})");
  const std::string path = folder.Write("studio", R"({"title": "Another studio"})");
  vtkNew<vtkGILook> look;
  const std::vector<std::string> names = Names();
  EXPECT_EQ(std::count(names.begin(), names.end(), "mine"), 1);
  EXPECT_EQ(std::count(names.begin(), names.end(), "studio"), 1);
  EXPECT_TRUE(look->Load("mine"));
  EXPECT_TRUE(look->Load("studio"));
  EXPECT_STREQ(look->GetTitle(), "Another studio");
  EXPECT_TRUE(look->Load(path.c_str()));
  EXPECT_EQ(look->GetName(), path);
}

TEST(Looks, RemovingALookRestoresEverything)
{
  for (int kind = 0; kind < 4; ++kind)
  {
    Scene scene;
    Furnish(scene.Renderer, kind);
    vtkGIPass* pass = scene.SetPass();
    pass->SetPreset("fast");
    const auto shoot = [&] { return kind > 0 ? Picture() : Shoot(scene.Window); };
    const Picture first = shoot();
    // One observer, as VTK prints an empty list in another way than none.
    vtkNew<vtkCallbackCommand> observer;
    scene.Renderer->AddObserver(vtkCommand::UserEvent, observer);
    const std::string before = State(scene.Renderer, pass);
    for (const std::string& name : Names())
    {
      const vtkMTimeType camera = scene.Renderer->GetActiveCamera()->GetMTime();
      Apply(name, scene.Renderer, pass);
      const Picture lit = shoot();
      EXPECT_EQ(scene.Renderer->GetActiveCamera()->GetMTime(), camera) << name;
      if (name != "as-is")
      {
        EXPECT_NE(State(scene.Renderer, pass), before) << name;
        EXPECT_LE(kind > 0 ? 0.0 : Compare(first, lit, 2).Within, 0.9) << name;
      }
      vtkGILook::RemoveFrom(scene.Renderer);
      EXPECT_EQ(State(scene.Renderer, pass), before) << name << " " << kind;
      EXPECT_STREQ(vtkGILook::GetAppliedName(scene.Renderer), "as-is");
    }
    if (kind == 0)
    {
      pass->Restart();
      ExpectSame(first, shoot(), 1.0);
    }
    EXPECT_STREQ(pass->GetLastError(), "");
  }
}

TEST(Looks, RestoringALookKeepsWhatTheProgramSetSince)
{
  Scene scene;
  vtkGIPass* pass = scene.SetPass();
  vtkRenderer* renderer = scene.Renderer;
  vtkGILook::Restore(renderer); // without a look nothing happens
  Apply("studio", renderer, pass);
  Shoot(scene.Window);
  vtkTexture* sky = renderer->GetEnvironmentTexture();
  double background[3];
  renderer->GetBackground(background);
  vtkNew<vtkTexture> own;
  renderer->SetEnvironmentTexture(own);
  renderer->UseImageBasedLightingOff();
  renderer->SetBackground(0.1, 0.2, 0.3);
  renderer->GradientBackgroundOff();
  vtkGILook::Restore(renderer);
  EXPECT_EQ(renderer->GetEnvironmentTexture(), sky);
  EXPECT_TRUE(renderer->GetUseImageBasedLighting());
  EXPECT_TRUE(renderer->GetGradientBackground());
  EXPECT_TRUE(std::equal(background, background + 3, renderer->GetBackground()));
  vtkGILook::RemoveFrom(renderer);
  EXPECT_EQ(renderer->GetEnvironmentTexture(), own);
  EXPECT_FALSE(renderer->GetUseImageBasedLighting());
  EXPECT_FALSE(renderer->GetGradientBackground());
  EXPECT_EQ(renderer->GetBackground()[2], 0.3);
}

// With an orbit while the look is on, which turns lights that follow the camera.
TEST(Looks, LightsThatStayBehindAreWhereTheyWere)
{
  Scene scene;
  Furnish(scene.Renderer, 2);
  vtkGIPass* pass = scene.SetPass();
  Shoot(scene.Window);
  const std::string before = State(scene.Renderer, pass);
  Apply("studio", scene.Renderer, pass);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  vtkNew<vtkCamera> kept;
  kept->DeepCopy(camera);
  camera->Azimuth(70);
  Shoot(scene.Window);
  camera->DeepCopy(kept);
  vtkGILook::RemoveFrom(scene.Renderer);
  std::string now = State(scene.Renderer, pass);
  EXPECT_EQ(now.substr(now.find("vtkOpenGLLight")), before.substr(before.find("vtkOpenGLLight")));
}

TEST(Looks, AnotherLookReplacesTheFirst)
{
  Scene scene;
  vtkGIPass* pass = scene.SetPass();
  pass->SetPreset("balanced");
  const auto described = [&] {
    std::string state = std::to_string(scene.Renderer->GetLights()->GetNumberOfItems());
    for (int i = 0; i < pass->GetNumberOfTechniques(); ++i)
    {
      state += Printed(pass->GetTechnique(i));
    }
    return state;
  };
  Apply("studio", scene.Renderer, pass);
  const std::string studio = described();
  Apply("soft", scene.Renderer, pass);
  EXPECT_NE(described(), studio);
  Apply("studio", scene.Renderer, pass);
  EXPECT_EQ(described(), studio);
  vtkGILook::RemoveFrom(scene.Renderer);
  vtkGILook::RemoveFrom(scene.Renderer); // once is enough
}

TEST(Looks, TwoRenderersMayShareAPass)
{
  Stage stage;
  vtkNew<vtkGIPass> pass;
  vtkNew<vtkRenderer> other;
  pass->SetPreset("balanced");
  vtkGITechnique* occlusion = pass->GetTechnique("ambient-occlusion");
  const double share = occlusion->GetParameter("ambient-share");
  Apply("studio", stage.Renderer, pass);
  const double changed = occlusion->GetParameter("ambient-share");
  Apply("studio", other, pass);
  EXPECT_NE(changed, share);
  vtkGILook::RemoveFrom(stage.Renderer);
  EXPECT_EQ(occlusion->GetParameter("ambient-share"), changed);
  vtkGILook::RemoveFrom(other);
  EXPECT_EQ(occlusion->GetParameter("ambient-share"), share);
}

TEST(Looks, ARendererThatIsDeletedGivesItsLightsBack)
{
  vtkNew<vtkGIPass> pass;
  vtkNew<vtkLight> light;
  vtkGITechnique* occlusion = pass->GetTechnique("ambient-occlusion");
  const std::string before = Printed(light) + Printed(occlusion);
  {
    vtkNew<vtkRenderer> renderer;
    renderer->AddLight(light);
    Apply("soft", renderer, pass);
    EXPECT_EQ(light->GetSwitch(), 0);
  }
  EXPECT_EQ(Printed(light) + Printed(occlusion), before);
}

// Asking a renderer for its camera makes one that shows the props of that moment, so a look must not ask.
TEST(Looks, ARendererWithoutACameraKeepsNone)
{
  for (const std::string& name : Names())
  {
    vtkNew<vtkRenderer> renderer;
    Apply(name, renderer, nullptr);
    EXPECT_FALSE(renderer->IsActiveCameraCreated()) << name;
    vtkGILook::RemoveFrom(renderer);
    EXPECT_FALSE(renderer->IsActiveCameraCreated()) << name;
  }
}

// Looks that are fixed to the world are placed with the axis that is up in the first frame, and scale with the scene.
TEST(Looks, LightsOfTheWorldFindTheVertical)
{
  const LookFolder folder;
  folder.Write("noon", R"({"follows": "world", "lights": [{"elevation": 60, "azimuth": 90}]})");
  Scene scene;
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  Apply("noon", scene.Renderer, nullptr);
  camera->SetPosition(1, -6, 2);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0.1, 0.2, 0.9);
  Shoot(scene.Window);
  auto* sun = static_cast<vtkLight*>(scene.Renderer->GetLights()->GetItemAsObject(1));
  double direction[3];
  vtkMath::Subtract(sun->GetPosition(), sun->GetFocalPoint(), direction);
  EXPECT_GT(vtkMath::Normalize(direction), 1.0);
  EXPECT_NEAR(direction[0], 0.5, 1e-6);
  EXPECT_NEAR(direction[1], 0.0, 1e-6);
  EXPECT_NEAR(direction[2], std::sqrt(0.75), 1e-6);
  camera->Roll(90);
  const double height = sun->GetPosition()[2];
  Shoot(scene.Window);
  EXPECT_EQ(sun->GetPosition()[2], height) << "it stays when the camera turns";
}
}
}
